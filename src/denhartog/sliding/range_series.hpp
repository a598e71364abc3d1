/// @file
/// @brief Ranges of a function and of its Taylor coefficients over an interval, with the size of the terms that were added up.
///
/// Where the terms of a sum cancel, the sum of their ranges is much wider than the range of the sum. The coefficients in the
/// middle of the interval cancel as the sum does, and what is left to the ranges is of the order of a high power of its length.
#pragma once

#include <algorithm>
#include <array>
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

/// @brief A function over an interval: bounds of its values and of its rate, rounding included.
template <class T>
struct RangeWithRate {
    Range<T> value; ///< range of the values
    Range<T> rate;  ///< range of the rate
    T rounding;     ///< part of the range of the values that is rounding
};

/// @brief Ranges of \f$ f^{(n)}/n! \f$ over an interval.
template <class T>
struct RangeSeries {
    static constexpr std::size_t order = 8;           ///< the last n
    std::array<Range<T>, order + 1> coefficient = {}; ///< the ranges
    std::array<T, order + 1> size = {};               ///< sums of the sizes of their terms
};

/// @brief A function from the ranges of its coefficients. @param coefficient gives the range for n @return the series
template <class T, class Coefficient>
[[nodiscard]] RangeSeries<T> range_series(const Coefficient& coefficient) {
    RangeSeries<T> f;
    for (std::size_t n = 0; n <= f.order; ++n) {
        f.coefficient[n] = coefficient(n);
        f.size[n] = size_of(f.coefficient[n]);
    }
    return f;
}

/// @brief A constant. @param c the constant @return the function
template <class T>
[[nodiscard]] RangeSeries<T> constant_series(const T& c) {
    return range_series<T>([&](std::size_t n) { return n == 0 ? Range<T>{c, c} : Range<T>{T(0), T(0)}; });
}

/// @brief A function f with \f$ f' = c(1+f^2) \f$, as the tangent has it, from the range of its values.
/// @param value  range of the values
/// @param c      the factor
/// @return       the function
template <class T>
[[nodiscard]] RangeSeries<T> tangent_series(const Range<T>& value, const T& c) {
    RangeSeries<T> f;
    f.coefficient[0] = value;
    for (std::size_t n = 0; n < f.order; ++n) {
        Range<T> sum = n == 0 ? Range<T>{T(1), T(1)} + square(value) : Range<T>{T(0), T(0)};
        for (std::size_t i = 0; n > 0 && i <= n; ++i) sum = sum + f.coefficient[i] * f.coefficient[n - i];
        const T factor = c / static_cast<int>(n + 1);
        f.coefficient[n + 1] = Range<T>{factor, factor} * sum;
    }
    for (std::size_t n = 0; n <= f.order; ++n) f.size[n] = size_of(f.coefficient[n]);
    return f;
}

/// @brief Sum of functions. @param a a function @param b a function @return a + b
template <class T>
[[nodiscard]] RangeSeries<T> operator+(RangeSeries<T> a, const RangeSeries<T>& b) {
    for (std::size_t n = 0; n <= a.order; ++n) {
        a.coefficient[n] = a.coefficient[n] + b.coefficient[n];
        a.size[n] += b.size[n];
    }
    return a;
}

/// @brief Multiple of a function. @param c the factor @param a a function @return c a
template <class T>
[[nodiscard]] RangeSeries<T> operator*(const T& c, RangeSeries<T> a) {
    for (std::size_t n = 0; n <= a.order; ++n) {
        a.coefficient[n] = Range<T>{c, c} * a.coefficient[n];
        a.size[n] *= c < 0 ? T(-c) : c;
    }
    return a;
}

/// @brief Product of functions. @param a a function @param b a function @return a b
template <class T>
[[nodiscard]] RangeSeries<T> operator*(const RangeSeries<T>& a, const RangeSeries<T>& b) {
    RangeSeries<T> product;
    for (std::size_t n = 0; n <= a.order; ++n)
        for (std::size_t i = 0; i <= n; ++i) {
            product.coefficient[n] = product.coefficient[n] + a.coefficient[i] * b.coefficient[n - i];
            product.size[n] += a.size[i] * b.size[n - i];
        }
    return product;
}

/// @brief What two ranges of the same thing have in common. @param a a range @param b another @return the range
template <class T>
[[nodiscard]] Range<T> in_common(const Range<T>& a, const Range<T>& b) {
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// @brief Values and rate over an interval: by their ranges, and by the Taylor polynomial of its middle.
/// @param middle    the function at the middle
/// @param whole     the function over the interval
/// @param h         half the length of the interval
/// @param rounding  what sums may be off by, as a part of the sizes of their terms
/// @return          the function
template <class T>
[[nodiscard]] RangeWithRate<T> over_interval(const RangeSeries<T>& middle, const RangeSeries<T>& whole, const T& h,
                                             const T& rounding) {
    const auto widened = [](const Range<T>& a, const T& by) { return Range<T>{a.low - by, a.high + by}; };
    Range<T> value = middle.coefficient[0], rate = middle.coefficient[1];
    T value_size = middle.size[0], rate_size = middle.size[1], power = h; // h^n
    for (std::size_t n = 1; n <= whole.order; ++n) {
        const RangeSeries<T>& f = n == whole.order ? whole : middle;
        const T of_rate = n == 1 ? T(0) : T(static_cast<int>(n) * power / h);
        value = value + Range<T>{-power, power} * f.coefficient[n];
        rate = rate + Range<T>{-of_rate, of_rate} * f.coefficient[n];
        value_size += power * f.size[n];
        rate_size += of_rate * f.size[n];
        power *= h;
    }
    return {in_common(widened(whole.coefficient[0], rounding * whole.size[0]), widened(value, rounding * value_size)),
            in_common(widened(whole.coefficient[1], rounding * whole.size[1]), widened(rate, rounding * rate_size)),
            rounding * std::min(whole.size[0], value_size)};
}

/// @brief Sign of all values of a range. @param a a range @param rounding what its ends may be off by
/// @return 1 or -1; 0 where it is not certain
template <class T>
[[nodiscard]] int certain_sign(const Range<T>& a, const T& rounding) {
    return a.low > rounding ? 1 : a.high < -rounding ? -1 : 0;
}

} // namespace denhartog
