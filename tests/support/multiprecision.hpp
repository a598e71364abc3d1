/// @file
/// @brief Number types of 50 and 100 digits for the tests and figures, with what Eigen has to know of them.
///
/// MPFR rounds every operation and every elementary function correctly, so that the digits are the same on every machine.
/// A number holds its digits in itself: none is allocated.
#pragma once

#include <mpfr.h>

#include <Eigen/Core>
#include <boost/multiprecision/mpfr.hpp>
#include <limits>

#include "denhartog/number/number.hpp"

namespace denhartog {

/// @brief A binary floating-point number with at least so many decimal digits, expression templates off.
template <unsigned digits10>
using Multiprecision =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<digits10, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// @brief At least 50 decimal digits.
using Real50 = Multiprecision<50>;
/// @brief At least 100 decimal digits.
using Real100 = Multiprecision<100>;

/// @brief Frees, at the end of a thread, the constants that MPFR keeps for it.
struct ConstantsOfThread {
    /// @brief Frees them.
    ~ConstantsOfThread() { mpfr_free_cache(); }
};

/// @brief Has the constants that MPFR keeps for this thread freed at its end. An arc tangent leaves some as well.
inline void free_constants_at_end_of_thread() { thread_local const ConstantsOfThread freed_at_its_end; }

/// @brief pi for the multiprecision types. @tparam digits10 the digits
template <unsigned digits10>
struct PiOf<Multiprecision<digits10>> {
    static Multiprecision<digits10> value() {
        free_constants_at_end_of_thread();
        static const Multiprecision<digits10> pi = [] {
            Multiprecision<digits10> x;
            mpfr_const_pi(x.backend().data(), MPFR_RNDN);
            return x;
        }();
        return pi;
    }
};

/// @brief Of multiprecision numbers MPFR has both.
template <unsigned digits10>
inline constexpr bool shares_sine_and_cosine<Multiprecision<digits10>> = true;
/// @brief Sine and cosine. @param x radians @return both, correctly rounded as `sin` and `cos` are
template <unsigned digits10>
[[nodiscard]] SineCosine<Multiprecision<digits10>> sine_cosine(const Multiprecision<digits10>& x) {
    SineCosine<Multiprecision<digits10>> at;
    mpfr_sin_cos(at.s.backend().data(), at.c.backend().data(), x.backend().data(), MPFR_RNDN);
    return at;
}

} // namespace denhartog

namespace boost::multiprecision::backends {

/// @brief A number whose digits are in itself, as Boost's operators see it.
template <unsigned digits10>
using DigitsInside = mpfr_float_backend<digits10, allocate_stack>;

// Boost 1.74 has these for numbers that allocate their digits alone: for others its operators copy a factor first, a tenth of
// the time of sums of products.

/// @brief \f$ a+b \f$, rounded once. @param sum the result @param a a number @param b another
template <unsigned digits10>
void eval_add(DigitsInside<digits10>& sum, const DigitsInside<digits10>& a, const DigitsInside<digits10>& b) {
    mpfr_add(sum.data(), a.data(), b.data(), MPFR_RNDN);
}
/// @brief \f$ a-b \f$, rounded once. @param difference the result @param a a number @param b another
template <unsigned digits10>
void eval_subtract(DigitsInside<digits10>& difference, const DigitsInside<digits10>& a, const DigitsInside<digits10>& b) {
    mpfr_sub(difference.data(), a.data(), b.data(), MPFR_RNDN);
}
/// @brief \f$ ab \f$, rounded once. @param product the result @param a a number @param b another
template <unsigned digits10>
void eval_multiply(DigitsInside<digits10>& product, const DigitsInside<digits10>& a, const DigitsInside<digits10>& b) {
    mpfr_mul(product.data(), a.data(), b.data(), MPFR_RNDN);
}
/// @brief \f$ a/b \f$, rounded once. @param quotient the result @param a a number @param b another
template <unsigned digits10>
void eval_divide(DigitsInside<digits10>& quotient, const DigitsInside<digits10>& a, const DigitsInside<digits10>& b) {
    mpfr_div(quotient.data(), a.data(), b.data(), MPFR_RNDN);
}

} // namespace boost::multiprecision::backends

namespace std {

/// @brief The limits of a multiprecision type. Boost 1.74's own set their values when first asked for, and no lock keeps a second
/// thread from reading them before they are set; these are set under one.
template <unsigned digits10_>
class numeric_limits<denhartog::Multiprecision<digits10_>>
    : public numeric_limits<boost::multiprecision::number<
          boost::multiprecision::mpfr_float_backend<digits10_, boost::multiprecision::allocate_stack>,
          boost::multiprecision::et_on>> {
    using Number = denhartog::Multiprecision<digits10_>;

public:
    static Number epsilon() {
        static const Number value = ldexp(Number(1), 1 - numeric_limits::digits);
        return value;
    }
    static Number min() {
        static const Number value = ldexp(Number(1), numeric_limits::min_exponent - 1);
        return value;
    }
    static Number max() {
        static const Number value = ldexp(Number(1 - epsilon() / 2), numeric_limits::max_exponent);
        return value;
    }
    static Number lowest() { return -max(); }
    static Number infinity() { return Number(std::numeric_limits<double>::infinity()); }
    static Number quiet_NaN() { return Number(std::numeric_limits<double>::quiet_NaN()); }
};

} // namespace std

namespace Eigen {

/// @brief What Eigen asks of a multiprecision number; Boost 1.74's own header does not serve Eigen 3.4's eigensolvers.
template <unsigned digits10_>
struct NumTraits<denhartog::Multiprecision<digits10_>> : GenericNumTraits<denhartog::Multiprecision<digits10_>> {
    using Number = denhartog::Multiprecision<digits10_>; ///< the number type
    using Real = Number;                                 ///< its real type
    using NonInteger = Number;                           ///< the type of quotients
    using Literal = double;                              ///< the type of literals in Eigen's code
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 8, AddCost = 20, MulCost = 60 };
    static Real epsilon() { return std::numeric_limits<Number>::epsilon(); }
    static Real dummy_precision() { return 1000 * epsilon(); }
    static Real highest() { return (std::numeric_limits<Number>::max)(); }
    static Real lowest() { return (std::numeric_limits<Number>::lowest)(); }
    static int digits10() { return std::numeric_limits<Number>::digits10; }
};

} // namespace Eigen
