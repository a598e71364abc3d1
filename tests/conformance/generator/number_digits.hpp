/// @file
/// @brief Numbers of vectors as text, and on how many digits two of them agree. Header only.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/multiprecision.hpp"

namespace denhartog::conformance::generator {

/// @brief A number rounded to some significant digits, zeros at their end left out.
template <class T>
[[nodiscard]] std::string text_of_digits(const T& x, int digits) {
    if (x == 0) return "0";
    const std::string text = x.str(digits - 1, std::ios_base::scientific); // so many after the point
    const std::size_t e = text.find('e');
    std::string mantissa = text.substr(0, e);
    while (mantissa.back() == '0') mantissa.pop_back();
    if (mantissa.back() == '.') mantissa.pop_back();
    const int exponent = std::atoi(text.c_str() + e + 1);
    return exponent == 0 ? mantissa : mantissa + "e" + std::to_string(exponent);
}

/// @brief A number rounded to 2 significant digits. @param x the number @return the double nearest to them
[[nodiscard]] inline double two_digits(const Real50& x) {
    return std::strtod(x.str(1, std::ios_base::scientific).c_str(), nullptr);
}

/// @brief Largest size of a list's numbers. @param x the numbers @return the size; 1 where all are zero
template <class T>
[[nodiscard]] T scale_of(const std::vector<T>& x) {
    using std::abs;
    T largest(0);
    for (const T& each : x) largest = std::max(largest, T(abs(each)));
    return largest == T(0) ? T(1) : largest;
}

/// @brief Digits on which two lists of numbers agree: of every number its own, of what counts as zero those of the largest.
/// Angles are compared round the circle, absolutely. None where the lists differ in length or hold what is no number.
template <class T>
[[nodiscard]] std::optional<int> agreement(const std::vector<T>& a, const std::vector<T>& b, bool angle) {
    using std::abs;
    if (a.empty() || a.size() != b.size()) return std::nullopt;
    const T largest = angle ? T(1) : scale_of(a), zero = 1024 * 1024 * largest * std::numeric_limits<T>::epsilon();
    T worst(0);
    for (std::size_t n = 0; n < a.size(); ++n) {
        T difference = a[n] - b[n];
        if (!(difference - difference == T(0))) return std::nullopt;
        if (angle) difference = atan2(T(sin(difference)), T(cos(difference)));
        const bool own = !angle && abs(a[n]) > zero;
        worst = std::max(worst, T(abs(difference) / (own ? T(abs(a[n])) : largest)));
    }
    if (worst == T(0)) return std::numeric_limits<T>::digits10;
    return std::clamp(static_cast<int>(floor(-log10(worst))), 0, std::numeric_limits<T>::digits10);
}

} // namespace denhartog::conformance::generator
