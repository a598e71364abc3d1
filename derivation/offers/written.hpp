/// @file
/// @brief A number type that writes down what is computed with it: the formulas of the library as code in other languages.
///
/// A formula template that is instantiated with `Written` gives the expression that the library computes, in the order in
/// which the
/// source has it. What a reader copies from a page is in this way the formula that runs.
#pragma once

#include <concepts>
#include <memory>
#include <string>
#include <vector>

#include "denhartog/number/number.hpp"

namespace denhartog::offers {

/// @brief An operation, or what it is applied to.
struct Operation {
    std::string name;                                      ///< `+`, `-`, `*`, `/`, `neg`, `sum`, a function; of a leaf its text
    std::vector<std::shared_ptr<const Operation>> on = {}; ///< its operands; none of a leaf
    std::string key = {};                                  ///< the whole expression: the same for the same computation
};

/// @brief A number that knows how it is computed. It cannot be compared.
class Written {
public:
    /// @brief Zero.
    Written() : Written(0) {}
    /// @brief An integer. @param n the integer
    Written(int n);
    /// @brief No floating-point number stands in a formula.
    template <std::floating_point F>
    Written(F) = delete;
    /// @brief No truth value is a number.
    Written(bool) = delete;
    /// @brief A symbol. @param name its name in code @return the symbol
    [[nodiscard]] static Written symbol(const std::string& name);
    /// @brief The sum over the modes of an expression in symbols that have a value a mode. @param term one mode's @return the sum
    [[nodiscard]] static Written sum_over_modes(const Written& term);
    /// @brief What an operation makes. @param name its name @param on its operands @return the result
    [[nodiscard]] static Written of(const std::string& name, const std::vector<Written>& on);
    /// @return the operation
    [[nodiscard]] const std::shared_ptr<const Operation>& operation() const { return operation_; }

private:
    explicit Written(std::shared_ptr<const Operation> operation) : operation_(std::move(operation)) {}
    std::shared_ptr<const Operation> operation_;
};

/// @name Operations and functions, found by argument-dependent lookup
/// @{

/// @brief Sum. @param a a number @param b a number @return a + b
[[nodiscard]] Written operator+(const Written& a, const Written& b);
/// @brief Difference. @param a a number @param b a number @return a - b
[[nodiscard]] Written operator-(const Written& a, const Written& b);
/// @brief Product. @param a a number @param b a number @return a b
[[nodiscard]] Written operator*(const Written& a, const Written& b);
/// @brief Quotient. @param a a number @param b a number @return a / b
[[nodiscard]] Written operator/(const Written& a, const Written& b);
/// @brief Opposite. @param a a number @return -a
[[nodiscard]] Written operator-(const Written& a);
/// @brief Square root. @param x a number @return its root
[[nodiscard]] Written sqrt(const Written& x);
/// @brief Exponential. @param x a number @return its exponential
[[nodiscard]] Written exp(const Written& x);
/// @brief Sine. @param x a number @return its sine
[[nodiscard]] Written sin(const Written& x);
/// @brief Cosine. @param x a number @return its cosine
[[nodiscard]] Written cos(const Written& x);
/// @brief Hyperbolic sine. @param x a number @return its hyperbolic sine
[[nodiscard]] Written sinh(const Written& x);
/// @brief Hyperbolic cosine. @param x a number @return its hyperbolic cosine
[[nodiscard]] Written cosh(const Written& x);
/// @brief Angle of a point. @param y its second coordinate @param x its first one @return the angle
[[nodiscard]] Written atan2(const Written& y, const Written& x);

/// @}

/// @brief A language in which a formula is written.
enum class Language { cxx, python, matlab, javascript };

/// @brief A formula as a function of its arguments.
struct WrittenFormula {
    std::string name;                   ///< of the function
    std::vector<std::string> arguments; ///< their names, in order
    std::vector<std::string> of_modes;  ///< those of them that have a value a mode
    std::vector<Written> results;       ///< one, or real and imaginary part
};

/// @brief A formula as code: a function with a name for each computation that is needed twice.
/// @param formula   the formula
/// @param language  the language
/// @return          the lines of the function
[[nodiscard]] std::string code_of(const WrittenFormula& formula, Language language);

} // namespace denhartog::offers

namespace denhartog {

/// @brief pi, by its name.
template <>
struct PiOf<offers::Written> {
    /// @return the symbol
    static offers::Written value() { return offers::Written::of("pi", {}); }
};

} // namespace denhartog
