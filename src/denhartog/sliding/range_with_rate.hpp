/// @file
/// @brief Ranges of a function and of its rate over an interval, with the size of the terms that were added up.
#pragma once

#include <algorithm>
#include <cmath>

namespace denhartog {

/// @brief The least and the largest value that something can have.
template <class T>
struct Range {
    T low;  ///< least value
    T high; ///< largest value
};

/// @brief Sum of ranges. @param a a range @param b a range @return the range of the sum
template <class T>
[[nodiscard]] Range<T> operator+(const Range<T>& a, const Range<T>& b) {
    return {a.low + b.low, a.high + b.high};
}

/// @brief Product of ranges. @param a a range @param b a range @return the range of the product
template <class T>
[[nodiscard]] Range<T> operator*(const Range<T>& a, const Range<T>& b) {
    const T ll = a.low * b.low, lh = a.low * b.high, hl = a.high * b.low, hh = a.high * b.high;
    return {std::min({ll, lh, hl, hh}), std::max({ll, lh, hl, hh})};
}

/// @brief Largest size. @param a a range @return the largest absolute value
template <class T>
[[nodiscard]] T size_of(const Range<T>& a) {
    using std::abs;
    return std::max(T(abs(a.low)), T(abs(a.high)));
}

/// @brief Square of a range. @param a a range @return the range of the square, not below zero
template <class T>
[[nodiscard]] Range<T> square(const Range<T>& a) {
    const T low = a.low * a.low, high = a.high * a.high;
    if (a.low < 0 && a.high > 0) return {T(0), std::max(low, high)};
    return {std::min(low, high), std::max(low, high)};
}

/// @brief A function over an interval: bounds of its values and of its rate. Rounding is kept apart: it is a few units in the
/// last place of the sizes.
template <class T>
struct RangeWithRate {
    Range<T> value; ///< range of the values
    Range<T> rate;  ///< range of the rate
    T value_size;   ///< sum of the sizes of the terms of the value
    T rate_size;    ///< sum of the sizes of the terms of the rate
};

/// @brief A function from its bounds. @param value range of its values @param rate range of its rate @return the function
template <class T>
[[nodiscard]] RangeWithRate<T> range_with_rate(const Range<T>& value, const Range<T>& rate) {
    return {value, rate, size_of(value), size_of(rate)};
}

/// @brief A constant. @param c the constant @return the function
template <class T>
[[nodiscard]] RangeWithRate<T> constant_range(const T& c) {
    return range_with_rate(Range<T>{c, c}, Range<T>{T(0), T(0)});
}

/// @brief Sum of functions. @param a a function @param b a function @return a + b
template <class T>
[[nodiscard]] RangeWithRate<T> operator+(const RangeWithRate<T>& a, const RangeWithRate<T>& b) {
    return {a.value + b.value, a.rate + b.rate, a.value_size + b.value_size, a.rate_size + b.rate_size};
}

/// @brief Product of functions. @param a a function @param b a function @return a b
template <class T>
[[nodiscard]] RangeWithRate<T> operator*(const RangeWithRate<T>& a, const RangeWithRate<T>& b) {
    return {a.value * b.value, a.rate * b.value + a.value * b.rate, a.value_size * b.value_size,
            a.rate_size * b.value_size + a.value_size * b.rate_size};
}

/// @brief Sign of all values of a range. @param a a range @param rounding what its ends may be off by
/// @return 1 or -1; 0 where it is not certain
template <class T>
[[nodiscard]] int certain_sign(const Range<T>& a, const T& rounding) {
    return a.low > rounding ? 1 : a.high < -rounding ? -1 : 0;
}

} // namespace denhartog
