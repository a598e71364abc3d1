/// @file
/// @brief The symbolic scalar: a GiNaC expression that refuses to be compared or rounded.
///
/// The formula templates of `src/denhartog` are instantiated with it. A kernel that branches on a value or holds a
/// floating-point literal does not compile for this type, so that what is proved here is the whole of what runs there.
///
/// The operators count themselves. With a `Mutation` in force the k-th operation is replaced by a wrong one; that is how the
/// derivation makes a mutated twin of a formula without a second copy of it.
#pragma once

#include <concepts>
#include <ginac/ginac.h>
#include <string>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/number/reduced_angle.hpp"

namespace denhartog::derivation {

class Symbolic;

/// @brief Replaces one operation while it lives: the `position`-th that the symbolic scalar carries out, counted from 0.
///
/// Sum and difference are exchanged, product and quotient, sine and cosine, hyperbolic sine and cosine, the arguments of atan2;
/// an exponential gets the opposite sign, a root and a unary minus are left out, an integer grows by one.
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
/// @brief sin(pi x).
/// @param x  an expression
/// @return the expression
Symbolic sin_pi(const Symbolic& x);
/// @brief cos(pi x).
/// @param x  an expression
/// @return the expression
Symbolic cos_pi(const Symbolic& x);
/// @brief exp(x) - 1.
/// @param x  an expression
/// @return the expression
Symbolic exp_minus_one(const Symbolic& x);
/// @brief 1 - sqrt(1 - zeta^2).
/// @param zeta  an expression
/// @return the expression
Symbolic one_minus_w(const Symbolic& zeta);
/// @brief sinh(x) / x - 1.
/// @param x  an expression
/// @return the expression
Symbolic sinhc_minus_one(const Symbolic& x);
/// @brief (1 - exp(-x)) / x.
/// @param x  an expression
/// @return the expression
Symbolic one_minus_exp_over(const Symbolic& x);
/// @brief (exp(z) - 1) / z of a complex number.
/// @param z  a pair of expressions
/// @return the pair
Complex<Symbolic> exp_minus_one_over(const Complex<Symbolic>& z);
/// @brief sin(x) / x.
/// @param x  an expression
/// @return the expression
Symbolic sinc(const Symbolic& x);
/// @brief [sinh(q zeta) / (q zeta) - sin(q w) / (q w)] / q^2.
/// @param q  an expression
/// @param zeta  an expression
/// @return the expression
Symbolic sinhc_less_sinc_over_square(const Symbolic& q, const Symbolic& zeta);
/// @brief What `product_error` of the evaluation forms stands for.
/// @param x  an expression
/// @param y  an expression
/// @param xy  an expression
/// @return the expression
Symbolic product_error(const Symbolic& x, const Symbolic& y, const Symbolic& xy);
/// @brief What `sum_error` of the evaluation forms stands for.
/// @param x  an expression
/// @param y  an expression
/// @param sum  an expression
/// @return the expression
Symbolic sum_error(const Symbolic& x, const Symbolic& y, const Symbolic& sum);
/// @brief What `contact_root` of the evaluation forms stands for.
/// @param V_dj  an expression
/// @param U_dj  an expression
/// @param beta  an expression
/// @return the expression
Symbolic contact_root(const Complex<Symbolic>& V_dj, const Symbolic& U_dj, const Symbolic& beta);
/// @brief What `overdamped_w` of the evaluation forms stands for.
/// @param zeta  an expression
/// @return the expression
Symbolic overdamped_w(const Symbolic& zeta);
/// @brief What `slow_rate` of the evaluation forms stands for.
/// @param zeta  an expression
/// @return the expression
Symbolic slow_rate(const Symbolic& zeta);
/// @brief What `overdamped_sinc` of the evaluation forms stands for.
/// @param zeta  an expression
/// @param x  an expression
/// @return the expression
Symbolic overdamped_sinc(const Symbolic& zeta, const Symbolic& x);
/// @brief What `overdamped_cosine` of the evaluation forms stands for.
/// @param zeta  an expression
/// @param x  an expression
/// @return the expression
Symbolic overdamped_cosine(const Symbolic& zeta, const Symbolic& x);
/// @brief What `overdamped_difference` of the evaluation forms stands for.
/// @param zeta  an expression
/// @param x  an expression
/// @return the expression
Symbolic overdamped_difference(const Symbolic& zeta, const Symbolic& x);
/// @brief What `sinhc_less_sinhc_over_square` of the evaluation forms stands for.
/// @param q  an expression
/// @param zeta  an expression
/// @return the expression
Symbolic sinhc_less_sinhc_over_square(const Symbolic& q, const Symbolic& zeta);
/// @brief What `product_over` of the evaluation forms stands for.
/// @param p  an expression
/// @param K  an expression
/// @param R  an expression
/// @return the expression
Symbolic product_over(const Symbolic& p, const Symbolic& K, const Symbolic& R);
/// @brief What `sine_cosine_of_half_period` of the evaluation forms stands for.
/// @param R  an expression
/// @param y  an expression
/// @return the expression
SineCosine<Symbolic> sine_cosine_of_half_period(const Symbolic& R, const Symbolic& y);

/// @}

/// @brief Square of what a kernel returns, where a claim is on the square; no operation of the kernel, so that no twin alters it.
/// @param x a symbolic number @return its square
[[nodiscard]] inline Symbolic square(const Symbolic& x) { return Symbolic(x.expression() * x.expression()); }

} // namespace denhartog::derivation

namespace denhartog {

/// @brief pi as a symbol.
template <>
struct PiOf<derivation::Symbolic> {
    /// @return GiNaC's Pi
    static derivation::Symbolic value() { return derivation::Symbolic(GiNaC::Pi); }
};

} // namespace denhartog
