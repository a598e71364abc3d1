/// @file
/// @brief Complex numbers as pairs, and the reading of \f$ v\cos(\tau+\phi) \f$.
///
/// The paper multiplies the complex \f$ v_{di} \f$ by a real cosine, (21), (26), (27), (31), (32), (42)-(45), (A.2)-(A.14), and
/// takes the real part at the end. What that means, made precise: \f$ v\cos a \f$ stands for
/// \f$ \mathrm{Re}\{v\,e^{ia}\} = |v|\cos(a+\angle v) \f$ and \f$ v\sin a \f$ for
/// \f$ \mathrm{Im}\{v\,e^{ia}\} = |v|\sin(a+\angle v) \f$. With this reading (36), (37) and (60) follow.
#pragma once

#include "denhartog/number/number.hpp"

namespace denhartog {

/// @brief A complex number on any number type, symbols included (std::complex serves floating-point types only).
template <class T>
struct Complex {
    T re; ///< real part
    T im; ///< imaginary part
};

/// @brief Sum of two complex numbers. @param a a summand @param b a summand @return a + b
template <class T>
[[nodiscard]] Complex<T> operator+(const Complex<T>& a, const Complex<T>& b) {
    return {a.re + b.re, a.im + b.im};
}

/// @brief Real multiple of a complex number. @param s the factor @param a a complex number @return s a
template <class T>
[[nodiscard]] Complex<T> operator*(const T& s, const Complex<T>& a) {
    return {s * a.re, s * a.im};
}

/// @brief \f$ \mathrm{i}a \f$: what turns a quarter of a period ahead. @param a a complex number @return i a
template <class T>
[[nodiscard]] Complex<T> times_i(const Complex<T>& a) {
    return {-a.im, a.re};
}

/// @brief \f$ |a|^2 \f$. @param a a complex number @return its squared modulus
template <class T>
[[nodiscard]] T squared_modulus(const Complex<T>& a) {
    return a.re * a.re + a.im * a.im;
}

/// @brief \f$ |a| \f$. @param a a complex number @return its modulus
template <class T>
[[nodiscard]] T modulus(const Complex<T>& a) {
    return sqrt(squared_modulus(a));
}

/// @brief \f$ \angle a \f$. @param a a complex number @return its argument in (-pi, pi], radians
template <class T>
[[nodiscard]] T argument(const Complex<T>& a) {
    return atan2(a.im, a.re);
}

/// @brief \f$ v\cos\alpha \f$ as the paper reads it, \f$ \mathrm{Re}\{v\,e^{i\alpha}\} \f$.
/// @param v      a complex amplitude
/// @param alpha  an angle, radians
/// @return       the real part of v exp(i alpha)
template <class T>
[[nodiscard]] T times_cosine(const Complex<T>& v, const T& alpha) {
    return v.re * cos(alpha) - v.im * sin(alpha);
}

/// @brief \f$ v\sin\alpha \f$ as the paper reads it, \f$ \mathrm{Im}\{v\,e^{i\alpha}\} \f$.
/// @param v      a complex amplitude
/// @param alpha  an angle, radians
/// @return       the imaginary part of v exp(i alpha)
template <class T>
[[nodiscard]] T times_sine(const Complex<T>& v, const T& alpha) {
    return v.re * sin(alpha) + v.im * cos(alpha);
}

} // namespace denhartog
