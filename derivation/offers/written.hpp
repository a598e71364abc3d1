/// @file
/// @brief A number type that writes down what is computed with it.
///
/// A formula template that is instantiated with `Written` gives the expression that the library computes, in the order in which
/// the source has it. What a reader copies from a page is in this way the formula that runs.
#pragma once

#include <concepts>
#include <string>

#include "denhartog/number/number.hpp"

namespace denhartog::offers {

/// @brief A number that knows how it is computed. It cannot be compared.
class Written {
public:
    /// @brief Zero.
    Written() : Written(0) {}
    /// @brief An integer. @param n the integer
    Written(int n) : text_(n < 0 ? "(-" + std::to_string(-n) + ")" : std::to_string(n)) {}
    /// @brief No floating-point number stands in a formula.
    template <std::floating_point F>
    Written(F) = delete;
    /// @brief No truth value is a number.
    Written(bool) = delete;
    /// @brief A symbol, or an expression. @param text its name, or what it is made of, in brackets @return the number
    [[nodiscard]] static Written of(const std::string& text) {
        Written made;
        made.text_ = text;
        return made;
    }
    /// @return the expression, with brackets around each operation
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// @name Operations and functions, found by argument-dependent lookup
/// @{

/// @brief Sum. @param a a number @param b a number @return a + b
[[nodiscard]] inline Written operator+(const Written& a, const Written& b) {
    if (a.text() == "0") return b;
    return b.text() == "0" ? a : Written::of("(" + a.text() + "+" + b.text() + ")");
}
/// @brief Difference. @param a a number @param b a number @return a - b
[[nodiscard]] inline Written operator-(const Written& a, const Written& b) {
    return Written::of("(" + a.text() + "-" + b.text() + ")");
}
/// @brief Product. @param a a number @param b a number @return a b
[[nodiscard]] inline Written operator*(const Written& a, const Written& b) {
    return Written::of("(" + a.text() + "*" + b.text() + ")");
}
/// @brief Quotient. @param a a number @param b a number @return a / b
[[nodiscard]] inline Written operator/(const Written& a, const Written& b) {
    return Written::of("(" + a.text() + "/" + b.text() + ")");
}
/// @brief Opposite. @param a a number @return -a
[[nodiscard]] inline Written operator-(const Written& a) { return Written::of("(-" + a.text() + ")"); }
/// @brief Square root. @param x a number @return its root
[[nodiscard]] inline Written sqrt(const Written& x) { return Written::of("sqrt(" + x.text() + ")"); }
/// @brief Exponential. @param x a number @return its exponential
[[nodiscard]] inline Written exp(const Written& x) { return Written::of("exp(" + x.text() + ")"); }
/// @brief Sine. @param x a number @return its sine
[[nodiscard]] inline Written sin(const Written& x) { return Written::of("sin(" + x.text() + ")"); }
/// @brief Cosine. @param x a number @return its cosine
[[nodiscard]] inline Written cos(const Written& x) { return Written::of("cos(" + x.text() + ")"); }
/// @brief Hyperbolic sine. @param x a number @return its hyperbolic sine
[[nodiscard]] inline Written sinh(const Written& x) { return Written::of("sinh(" + x.text() + ")"); }
/// @brief Hyperbolic cosine. @param x a number @return its hyperbolic cosine
[[nodiscard]] inline Written cosh(const Written& x) { return Written::of("cosh(" + x.text() + ")"); }
/// @brief Angle of a point. @param y its second coordinate @param x its first one @return the angle
[[nodiscard]] inline Written atan2(const Written& y, const Written& x) {
    return Written::of("atan2(" + y.text() + "," + x.text() + ")");
}
/// @brief The sum over the modes. @param term one mode's, in symbols that have a value a mode @return the sum
[[nodiscard]] inline Written over_modes(const Written& term) { return Written::of("sum(" + term.text() + ")"); }

/// @}

} // namespace denhartog::offers

namespace denhartog {

/// @brief pi, by its name.
template <>
struct PiOf<offers::Written> {
    /// @return the symbol
    static offers::Written value() { return offers::Written::of("pi"); }
};

} // namespace denhartog
