// Sines and cosines of angles in half turns, reduced exactly before they are multiplied by pi.
#pragma once

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

#include "denhartog/number/number.hpp"

namespace denhartog {

// An angle in half turns without whole turns, where there are many: Boost counts half turns in an int. NaN if not finite.
template <class T>
[[nodiscard]] T without_many_turns(const T& x) {
    constexpr double many = 1e9;
    using std::fmod;
    return x > -many && x < many ? x : T(fmod(x, T(2)));
}

// sin(pi x); NaN if x is not finite.
template <class T>
[[nodiscard]] T sine_of_half_turns(const T& x) {
    if constexpr (std::same_as<T, double>) {
        return elementary::sine_of_half_turns(x);
    } else {
        const T reduced = without_many_turns(x);
        return reduced == reduced ? T(boost::math::sin_pi(reduced)) : reduced;
    }
}

// cos(pi x); NaN if x is not finite.
template <class T>
[[nodiscard]] T cosine_of_half_turns(const T& x) {
    if constexpr (std::same_as<T, double>) {
        return elementary::cosine_of_half_turns(x);
    } else {
        const T reduced = without_many_turns(x);
        return reduced == reduced ? T(boost::math::cos_pi(reduced)) : reduced;
    }
}

// Sine and cosine of pi [1/(2R) - y], reduced exactly: both keep their digits however small they or R are. With rho the remainder
// of 1 after division by 4R the first part is rho/(2R) but for whole turns. What is left to the next multiple of a quarter turn,
// 2R - |rho| or R - |rho|, is a difference without rounding; y, in half turns, is added to it.
template <class T>
[[nodiscard]] SineCosine<T> sine_cosine_of_half_period(const T& R, const T& y) {
    using std::remainder;
    const T rest = remainder(T(1), T(4 * R));
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
