/// @file
/// @brief The multiprecision number types the library is built for, with what Eigen has to know of them.
#pragma once

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "denhartog/number/number.hpp"
#include "denhartog/number/wider.hpp"

namespace denhartog {

/// @brief A binary floating-point number with at least 50 decimal digits, expression templates off.
using Real50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
/// @brief A binary floating-point number with at least 100 decimal digits, expression templates off.
using Real100 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// @brief Ten digits more than `Real50`.
using Real60 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

/// @brief Of `long double`.
template <>
struct WiderOf<long double> {
    using type = Real50; ///< the wider type
};
/// @brief Of 50 digits.
template <>
struct WiderOf<Real50> {
    using type = Real60; ///< the wider type
};
/// @brief Of 50 digits.
template <>
struct GuardedOf<Real50> {
    using type = Real60; ///< the type to evaluate in
};

/// @brief pi for the multiprecision types. @tparam B the back end
template <class B>
struct PiOf<boost::multiprecision::number<B, boost::multiprecision::et_off>> {
    /// @return pi, correctly rounded
    static boost::multiprecision::number<B, boost::multiprecision::et_off> value() {
        return boost::math::constants::pi<boost::multiprecision::number<B, boost::multiprecision::et_off>>();
    }
};

} // namespace denhartog

namespace Eigen {

/// @brief What Eigen asks of a multiprecision number; Boost 1.74's own header does not serve Eigen 3.4's eigensolvers.
template <class B>
struct NumTraits<boost::multiprecision::number<B, boost::multiprecision::et_off>>
    : GenericNumTraits<boost::multiprecision::number<B, boost::multiprecision::et_off>> {
    using Number = boost::multiprecision::number<B, boost::multiprecision::et_off>; ///< the number type
    using Real = Number;                                                            ///< its real type
    using NonInteger = Number;                                                      ///< the type of quotients
    using Literal = double;                                                         ///< the type of literals in Eigen's code
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 8, AddCost = 20, MulCost = 60 };
    /// @return the unit in the last place of 1
    static Real epsilon() { return std::numeric_limits<Number>::epsilon(); }
    /// @return the tolerance of Eigen's fuzzy comparisons
    static Real dummy_precision() { return 1000 * epsilon(); }
    /// @return the largest finite number
    static Real highest() { return (std::numeric_limits<Number>::max)(); }
    /// @return the most negative finite number
    static Real lowest() { return (std::numeric_limits<Number>::lowest)(); }
    /// @return the decimal digits that a double conversion keeps
    static int digits10() { return std::numeric_limits<Number>::digits10; }
};

} // namespace Eigen
