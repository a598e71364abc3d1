/// @file
/// @brief Sine and cosine of half the angle of (28) and (29), reduced exactly before it is multiplied by pi.
#pragma once

#include "denhartog/number/number.hpp"

namespace denhartog {

/// @brief Remainder of 1 after division by m, of the least size: exact, whatever the quotient.
/// @param m  a positive number
/// @return   1 - n m for the whole n nearest to 1 / m; at most m / 2 in size
template <class T>
[[nodiscard]] T remainder_of_one(const T& m) {
    using std::remainder;
    return remainder(T(1), m);
}

/// @brief Sine and cosine of one angle.
template <class T>
struct SineCosine {
    T s; ///< sine
    T c; ///< cosine
};

/// @brief Sine and cosine of \f$ \pi\,[1/(2R) - y] \f$, reduced exactly: both keep their digits however small they or R are.
///
/// With \f$ \rho \f$ the remainder of 1 after division by 4R the first part is \f$ \rho/(2R) \f$ but for whole turns. What is
/// left to the next multiple of a quarter turn, \f$ 2R-|\rho| \f$ or \f$ R-|\rho| \f$, is a difference without rounding; y is
/// added to it.
/// @param R  a positive number
/// @param y  a number, in half turns
/// @return   sine and cosine
template <class T>
[[nodiscard]] SineCosine<T> sine_cosine_of_half_period(const T& R, const T& y) {
    const T rest = remainder_of_one(T(4 * R));
    const T size = rest < 0 ? T(-rest) : rest;
    const bool second_quarter = size > R;
    const T t = second_quarter ? T(2 * R - size) : size;
    const bool beyond_eighth = 2 * t > R;
    const bool mirrored = (rest < 0) != second_quarter;
    const T y_there = mirrored ? T(-y) : y;
    const T angle = pi<T>() * (beyond_eighth ? T((R - t) / (2 * R) + y_there) : T(t / (2 * R) - y_there));
    const T sine = beyond_eighth ? T(cos(angle)) : T(sin(angle));
    const T cosine = beyond_eighth ? T(sin(angle)) : T(cos(angle));
    return {rest < 0 ? T(-sine) : sine, second_quarter ? T(-cosine) : cosine};
}

} // namespace denhartog
