/// @file
/// @brief A number that has a place and an expression: comparisons look at the place, operations make the expression.
///
/// With it a selection runs as it is shipped, takes the form that it takes at that place, and leaves the form as an expression
/// that can be proved, with the comparisons that led there.
#pragma once

#include <limits>

#include "denhartog/evaluation/demand.hpp"
#include "denhartog/evaluation/driven_motion.hpp"
#include "derivation/selections/stand_ins.hpp"

namespace denhartog::derivation::scalar {

/// @brief A value at a place, with the expression that it is the value of.
class Placed {
public:
    /// @brief Zero.
    Placed() = default;
    /// @brief An integer. @param n the integer
    Placed(int n) : symbolic_(n), value_(n) {}
    /// @brief An expression and its value. @param e the expression @param value its value at the place
    Placed(const Symbolic& e, double value) : symbolic_(e), value_(value) {}
    /// @return the expression
    [[nodiscard]] const Symbolic& symbolic() const { return symbolic_; }
    /// @return the value
    [[nodiscard]] double value() const { return value_; }

private:
    Symbolic symbolic_;
    double value_ = 0;
};

/// @brief A comparison that a selection has made: the difference of its sides, and the outcome.
struct Comparison {
    GiNaC::ex difference; ///< left side less right side
    bool equality;        ///< whether it asked for equality
    bool outcome;         ///< what it found
};

/// @brief The comparisons since the list was last cleared, in their order. @return the list
std::vector<Comparison>& comparisons();

/// @brief Keeps a comparison. @param a a side @param b the other @param equality whether it asks for equality @param outcome what
/// it finds @return the outcome
bool noted(const Placed& a, const Placed& b, bool equality, bool outcome);

/// @name What the formulas and the selections ask of a number
/// @{

/// @brief Sum. @param a a number @param b a number @return a + b
inline Placed operator+(const Placed& a, const Placed& b) { return {a.symbolic() + b.symbolic(), a.value() + b.value()}; }
/// @brief Difference. @param a a number @param b a number @return a - b
inline Placed operator-(const Placed& a, const Placed& b) { return {a.symbolic() - b.symbolic(), a.value() - b.value()}; }
/// @brief Product. @param a a number @param b a number @return a * b
inline Placed operator*(const Placed& a, const Placed& b) { return {a.symbolic() * b.symbolic(), a.value() * b.value()}; }
/// @brief Quotient. @param a a number @param b a number @return a / b
inline Placed operator/(const Placed& a, const Placed& b) { return {a.symbolic() / b.symbolic(), a.value() / b.value()}; }
/// @brief Opposite. @param a a number @return -a
inline Placed operator-(const Placed& a) { return {-a.symbolic(), -a.value()}; }
/// @brief Whether one place is less than another; the comparison is kept. @param a a number @param b a number @return the outcome
inline bool operator<(const Placed& a, const Placed& b) { return noted(a, b, false, a.value() < b.value()); }
/// @brief Whether one place is greater than another; the comparison is kept. @param a one @param b the other @return the outcome
inline bool operator>(const Placed& a, const Placed& b) { return noted(a, b, false, a.value() > b.value()); }
/// @brief Whether one place is not above another; the comparison is kept. @param a one @param b the other @return the outcome
inline bool operator<=(const Placed& a, const Placed& b) { return noted(a, b, false, a.value() <= b.value()); }
/// @brief Whether one place is not below another; the comparison is kept. @param a one @param b the other @return the outcome
inline bool operator>=(const Placed& a, const Placed& b) { return noted(a, b, false, a.value() >= b.value()); }
/// @brief Whether one place is equal to another; the comparison is kept. @param a a number @param b a number @return the outcome
inline bool operator==(const Placed& a, const Placed& b) { return noted(a, b, true, a.value() == b.value()); }

/// @brief Square root. @param x a number @return its root
inline Placed sqrt(const Placed& x) { return {sqrt(x.symbolic()), std::sqrt(x.value())}; }
/// @brief Exponential. @param x a number @return exp(x)
inline Placed exp(const Placed& x) { return {exp(x.symbolic()), std::exp(x.value())}; }
/// @brief Sine. @param x a number @return sin(x)
inline Placed sin(const Placed& x) { return {sin(x.symbolic()), std::sin(x.value())}; }
/// @brief Cosine. @param x a number @return cos(x)
inline Placed cos(const Placed& x) { return {cos(x.symbolic()), std::cos(x.value())}; }
/// @brief Hyperbolic sine. @param x a number @return sinh(x)
inline Placed sinh(const Placed& x) { return {sinh(x.symbolic()), std::sinh(x.value())}; }
/// @brief Hyperbolic cosine. @param x a number @return cosh(x)
inline Placed cosh(const Placed& x) { return {cosh(x.symbolic()), std::cosh(x.value())}; }
/// @brief exp(x) - 1. @param x a number @return the difference
inline Placed expm1(const Placed& x) { return {expm1(x.symbolic()), std::expm1(x.value())}; }

/// @}
/// @name The stand-ins that the selections meet: the theorem for the expression, the shipped body for the value
/// @{

/// @brief sin(pi x). @param x a number @return the value
inline Placed sin_pi(const Placed& x) { return {sin_pi(x.symbolic()), evaluation::sin_pi(x.value())}; }
/// @brief cos(pi x). @param x a number @return the value
inline Placed cos_pi(const Placed& x) { return {cos_pi(x.symbolic()), evaluation::cos_pi(x.value())}; }
/// @brief Sine and cosine of pi [1 / (2 R) - y]. @param R a number @param y a number @return both
SineCosine<Placed> sine_cosine_of_half_period(const Placed& R, const Placed& y);
/// @brief sin(x) / x. @param x a number @return the value
inline Placed sinc(const Placed& x) { return {sinc(x.symbolic()), evaluation::sinc(x.value())}; }
/// @brief (1 - exp(-x)) / x. @param x a number @return the value
inline Placed one_minus_exp_over(const Placed& x) {
    return {one_minus_exp_over(x.symbolic()), evaluation::one_minus_exp_over(x.value())};
}
/// @brief (exp(z) - 1) / z of a complex number. @param z a pair of numbers @return the value
inline Complex<Placed> exp_minus_one_over(const Complex<Placed>& z) {
    const Complex<Symbolic> e = exp_minus_one_over(Complex<Symbolic>{z.re.symbolic(), z.im.symbolic()});
    const Complex<double> v = evaluation::exp_minus_one_over(Complex<double>{z.re.value(), z.im.value()});
    return {{e.re, v.re}, {e.im, v.im}};
}
/// @brief The series of `special.hpp`. @param s a number @return the value
inline Placed odd_series_without_leading_term(const Placed& s) {
    return {odd_series_without_leading_term(s.symbolic()), evaluation::sinhc_minus_one(std::sqrt(s.value()))};
}
/// @brief The series of `special.hpp`. @param q a number @param zeta a number @return the value
inline Placed sinhc_less_sinc_over_square(const Placed& q, const Placed& zeta) {
    return {sinhc_less_sinc_over_square(q.symbolic(), zeta.symbolic()),
            evaluation::sinhc_less_sinc_over_square(q.value(), zeta.value())};
}
/// @brief The series of `entire_functions.hpp`. @param q a number @param zeta a number @return the value
inline Placed sinhc_less_sinhc_over_square(const Placed& q, const Placed& zeta) {
    return {sinhc_less_sinhc_over_square(q.symbolic(), zeta.symbolic()),
            evaluation::sinhc_less_sinhc_over_square(q.value(), zeta.value())};
}
/// @brief p K / R. @param p a number @param K a number @param R a number @return the value
inline Placed product_over(const Placed& p, const Placed& K, const Placed& R) {
    return {product_over(p.symbolic(), K.symbolic(), R.symbolic()), p.value() * K.value() / R.value()};
}

/// @}

} // namespace denhartog::derivation::scalar

namespace denhartog {

/// @brief pi with its value.
template <>
struct PiOf<derivation::scalar::Placed> {
    /// @return pi
    static derivation::scalar::Placed value() { return {pi<derivation::Symbolic>(), pi<double>()}; }
};

} // namespace denhartog

namespace std {

/// @brief The limits of double, which the selections ask for.
template <>
class numeric_limits<denhartog::derivation::scalar::Placed> {
public:
    static constexpr bool is_specialized = true; ///< there are limits
    /// @brief The distance of 1 and the next number. @return 2^-52
    static denhartog::derivation::scalar::Placed epsilon();
    /// @brief The least normal number. @return 2^-1022
    static denhartog::derivation::scalar::Placed(min)();
};

} // namespace std
