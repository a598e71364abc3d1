/// @file
/// @brief The symbolic scalar: a GiNaC expression that refuses to be compared or rounded.
///
/// The formula templates of `src/denhartog` are instantiated with it. A kernel that branches on a value or holds a
/// floating-point literal does not compile for this type, so that what is proved here is the whole of what runs there.
///
/// The operators count themselves. With a `Mutation` in force the k-th operation is replaced by a wrong one; that is how the
/// derivation makes a mutated twin of a formula without a second copy of it.
///
/// The scalar has a namespace of its own, in which argument-dependent lookup finds its elementary functions and the stand-ins of
/// `stand_ins.hpp`, nothing else: a function of that name elsewhere in the derivation never takes the place of a shipped body.
#pragma once

#include <concepts>
#include <ginac/ginac.h>
#include <string>

#include "denhartog/number/number.hpp"

namespace denhartog::derivation::scalar {

class Symbolic;

/// @brief Replaces one operation while it lives: the `position`-th that the symbolic scalar carries out, counted from 0.
///
/// Sum and difference are exchanged or lose their second term; product and quotient are exchanged, sine and cosine, hyperbolic
/// sine and cosine, the arguments of atan2; an exponential gets the opposite sign, a root and a unary minus are left out, an
/// integer grows by one, pi is 3.
class Mutation {
public:
    /// @param position  which operation to replace; negative: none, count only
    explicit Mutation(long position);
    ~Mutation();
    Mutation(const Mutation&) = delete;
    Mutation& operator=(const Mutation&) = delete;
    /// @return the operations counted since construction
    [[nodiscard]] long operations() const;
    /// @return what was replaced, e.g. `+ -> -`; empty where the position was not reached
    [[nodiscard]] const std::string& replaced() const;
    /// @brief Counts an operation. @param what description of the replacement @return whether to replace this one
    static bool here(const char* what);

private:
    long position_;
    long count_ = 0;
    std::string replaced_;
};

/// @brief A symbolic number: built from integers and GiNaC expressions, without comparison, without rounding.
class Symbolic {
public:
    /// @brief Zero.
    Symbolic() = default;
    /// @brief An integer. @param n the integer
    Symbolic(int n);
    /// @brief An expression. @param e the expression
    explicit Symbolic(const GiNaC::ex& e) : value_(e) {}
    /// @brief No floating-point number enters a proof.
    template <std::floating_point F>
    Symbolic(F) = delete;
    /// @brief No truth value is a number.
    Symbolic(bool) = delete;

    /// @return the GiNaC expression
    [[nodiscard]] const GiNaC::ex& expression() const { return value_; }

    /// @brief Sum, an operation that a twin may exchange. @param a an expression @param b an expression @return a + b
    friend Symbolic operator+(const Symbolic& a, const Symbolic& b);
    /// @brief Difference, an operation that a twin may exchange. @param a an expression @param b an expression @return a - b
    friend Symbolic operator-(const Symbolic& a, const Symbolic& b);
    /// @brief Product, an operation that a twin may exchange. @param a an expression @param b an expression @return a * b
    friend Symbolic operator*(const Symbolic& a, const Symbolic& b);
    /// @brief Quotient, an operation that a twin may exchange. @param a an expression @param b an expression @return a / b
    friend Symbolic operator/(const Symbolic& a, const Symbolic& b);
    /// @brief Opposite. @param a an expression @return -a
    friend Symbolic operator-(const Symbolic& a);
    friend bool operator==(const Symbolic&, const Symbolic&) = delete;
    friend bool operator!=(const Symbolic&, const Symbolic&) = delete;
    friend bool operator<(const Symbolic&, const Symbolic&) = delete;
    friend bool operator>(const Symbolic&, const Symbolic&) = delete;
    friend bool operator<=(const Symbolic&, const Symbolic&) = delete;
    friend bool operator>=(const Symbolic&, const Symbolic&) = delete;

private:
    GiNaC::ex value_ = 0;
};

/// @name Elementary functions of the symbolic scalar, found by argument-dependent lookup
/// @{

/// @brief Square root.
/// @param x  an expression
/// @return the expression
Symbolic sqrt(const Symbolic& x);
/// @brief Exponential.
/// @param x  an expression
/// @return the expression
Symbolic exp(const Symbolic& x);
/// @brief Sine.
/// @param x  an expression
/// @return the expression
Symbolic sin(const Symbolic& x);
/// @brief Cosine.
/// @param x  an expression
/// @return the expression
Symbolic cos(const Symbolic& x);
/// @brief Hyperbolic sine.
/// @param x  an expression
/// @return the expression
Symbolic sinh(const Symbolic& x);
/// @brief Hyperbolic cosine.
/// @param x  an expression
/// @return the expression
Symbolic cosh(const Symbolic& x);
/// @brief Angle of the point (x, y).
/// @param y  an expression
/// @param x  an expression
/// @return the expression
Symbolic atan2(const Symbolic& y, const Symbolic& x);
/// @brief exp(x) - 1.
/// @param x  an expression
/// @return the expression
Symbolic expm1(const Symbolic& x);
/// @brief x y + z; what a type that rounds does in one rounding.
/// @param x  an expression
/// @param y  an expression
/// @param z  an expression
/// @return the expression
Symbolic fma(const Symbolic& x, const Symbolic& y, const Symbolic& z);

/// @}

} // namespace denhartog::derivation::scalar

namespace denhartog::derivation {

using scalar::Mutation;
using scalar::Symbolic;

/// @brief Square of what a kernel returns, where a claim is on the square; no operation of the kernel, so that no twin alters it.
/// @param x a symbolic number @return its square
[[nodiscard]] inline Symbolic square(const Symbolic& x) { return Symbolic(x.expression() * x.expression()); }

} // namespace denhartog::derivation

namespace denhartog {

/// @brief pi as a symbol.
template <>
struct PiOf<derivation::Symbolic> {
    /// @return GiNaC's Pi; 3 in a twin
    static derivation::Symbolic value() {
        return derivation::Symbolic(derivation::Mutation::here("pi -> 3") ? GiNaC::ex(3) : GiNaC::ex(GiNaC::Pi));
    }
};

} // namespace denhartog
