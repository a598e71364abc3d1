/// @file
/// @brief The stand-ins: shipped functions that the proofs take by what they compute, not by their text.
///
/// These compare numbers, run a series to its last digit or reduce an argument, so that their bodies cannot be instantiated with
/// the symbolic scalar. Each stands for a theorem, which is what its overload here returns: what the body computes, without
/// rounding. This is the whole list. A shipped function that compares and is not on it does not compile for the proofs, and an
/// overload anywhere else is not found. That the bodies compute what the theorems say is measured in
/// `tests/derivation/stand_ins.cpp` and, to the last places, by the tests of accuracy.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/number/reduced_angle.hpp"
#include "derivation/algebra/symbolic.hpp"

namespace denhartog::derivation::scalar {

/// @brief \f$ \sin(\pi x) \f$. @param x an expression @return the theorem's right side
Symbolic sin_pi(const Symbolic& x);
/// @brief \f$ \cos(\pi x) \f$. @param x an expression @return the theorem's right side
Symbolic cos_pi(const Symbolic& x);
/// @brief Sine and cosine of \f$ \pi[1/(2R)-y] \f$. @param R an expression @param y an expression @return both
SineCosine<Symbolic> sine_cosine_of_half_period(const Symbolic& R, const Symbolic& y);
/// @brief \f$ \sin(x)/x \f$, 1 at 0. @param x an expression @return the theorem's right side
Symbolic sinc(const Symbolic& x);
/// @brief \f$ \sinh(x)/x-1 \f$, 0 at 0. @param x an expression @return the theorem's right side
Symbolic sinhc_minus_one(const Symbolic& x);
/// @brief \f$ (1-e^{-x})/x \f$, 1 at 0. @param x an expression @return the theorem's right side
Symbolic one_minus_exp_over(const Symbolic& x);
/// @brief \f$ (e^z-1)/z \f$ of a complex number. @param z a pair of expressions @return the theorem's right side
Complex<Symbolic> exp_minus_one_over(const Complex<Symbolic>& z);
/// @brief \f$ \sum_{k\ge1}s^k/(2k+1)! = \sinh(\sqrt s)/\sqrt s-1 \f$, 0 at 0. @param s an expression @return the right side
Symbolic odd_series_without_leading_term(const Symbolic& s);
/// @brief \f$ [\sinh(q\zeta)/(q\zeta)-\sin(qw)/(qw)]/q^2 \f$. @param q an expression @param zeta an expression
/// @return the theorem's right side
Symbolic sinhc_less_sinc_over_square(const Symbolic& q, const Symbolic& zeta);
/// @brief \f$ [\sinh(q\zeta)/(q\zeta)-\sinh(qw_1)/(qw_1)]/q^2 \f$. @param q an expression @param zeta an expression
/// @return the theorem's right side
Symbolic sinhc_less_sinhc_over_square(const Symbolic& q, const Symbolic& zeta);
/// @brief \f$ pK/R \f$ in any order. @param p an expression @param K an expression @param R an expression
/// @return the theorem's right side
Symbolic product_over(const Symbolic& p, const Symbolic& K, const Symbolic& R);
/// @brief \f$ x+y-\mathrm{sum} \f$. The body is proved too, by itself: some of its operations matter to roundings alone.
/// @param x an expression @param y an expression @param sum an expression @return the theorem's right side
Symbolic sum_error(const Symbolic& x, const Symbolic& y, const Symbolic& sum);

} // namespace denhartog::derivation::scalar

namespace denhartog::derivation {

/// @brief A stand-in as the report shows it.
struct StandIn {
    std::string name;    ///< name of the shipped function
    std::string header;  ///< where its body is
    std::string theorem; ///< LaTeX: what it is called with, and what the overload above makes of that
};

/// @brief All stand-ins, each theorem made by the overload itself. @return the list
[[nodiscard]] std::vector<StandIn> stand_ins();

} // namespace denhartog::derivation
