/// @file
/// @brief Requirements of the formulas on a number type.
///
/// A formula of the paper is one function template on its number type `T`. It asks of `T`
///  - construction from `int`,
///  - the four operations and unary minus,
///  - `sqrt`, `exp`, `sin`, `cos`, `sinh`, `cosh`, `atan2`, found by argument-dependent lookup,
///  - `pi<T>()`.
///
/// It asks for no comparison and no conversion from a floating-point literal, so that the derivation can instantiate the same
/// source with a symbolic scalar. `double` is served by `elementary.hpp`, with the same digits on every machine; `float` and
/// `long double`, which only the formulas know, by the system;
/// the symbolic scalar is served in `derivation/algebra/symbolic.hpp`.
#pragma once

#include <cmath>
#include <concepts>
#include <numbers>

#include "elementary/elementary.hpp"

namespace denhartog {

/// @brief The circle constant of a number type; specialise `value()` for a type of your own.
template <class T>
struct PiOf {
    static_assert(std::floating_point<T>, "no pi for this number type: include the header that defines the type");
    /// @brief pi, correctly rounded.
    static T value() { return std::numbers::pi_v<T>; }
};

/// @brief pi in the number type `T`.
template <class T>
[[nodiscard]] T pi() {
    return PiOf<T>::value();
}

using std::sqrt;

/// @brief A number that the processor computes with.
template <class T>
concept MachineNumber = std::floating_point<T>;

// Templates, so that whoever calls `exp` of a double beside `using namespace denhartog` gets the system's, and no ambiguity.
/// @{
/// @brief Elementary functions, of a double with the same digits on every machine.
template <MachineNumber T>
[[nodiscard]] T exp(T x) {
    if constexpr (std::same_as<T, double>)
        return elementary::exp(x);
    else
        return std::exp(x);
}
template <MachineNumber T>
[[nodiscard]] T expm1(T x) {
    if constexpr (std::same_as<T, double>)
        return elementary::expm1(x);
    else
        return std::expm1(x);
}
template <MachineNumber T>
[[nodiscard]] T sinh(T x) {
    if constexpr (std::same_as<T, double>)
        return elementary::sinh(x);
    else
        return std::sinh(x);
}
template <MachineNumber T>
[[nodiscard]] T cosh(T x) {
    if constexpr (std::same_as<T, double>)
        return elementary::cosh(x);
    else
        return std::cosh(x);
}
template <MachineNumber T>
[[nodiscard]] T sin(T x) {
    if constexpr (std::same_as<T, double>)
        return elementary::sin(x);
    else
        return std::sin(x);
}
template <MachineNumber T>
[[nodiscard]] T cos(T x) {
    if constexpr (std::same_as<T, double>)
        return elementary::cos(x);
    else
        return std::cos(x);
}
/// @brief Whether sine and cosine of one angle cost less together; true of the types that `sine_cosine` has a body for.
template <class T>
inline constexpr bool shares_sine_and_cosine = std::same_as<T, double>;
/// @brief Sine and cosine, as `sin` and `cos` give them.
template <class T>
[[nodiscard]] SineCosine<T> sine_cosine(const T& x) {
    if constexpr (std::same_as<T, double>)
        return elementary::sine_cosine(x);
    else
        return {sin(x), cos(x)};
}
template <MachineNumber T>
[[nodiscard]] T atan(T x) {
    if constexpr (std::same_as<T, double>)
        return elementary::atan(x);
    else
        return std::atan(x);
}
template <MachineNumber T>
[[nodiscard]] T atan2(T y, T x) {
    if constexpr (std::same_as<T, double>)
        return elementary::atan2(y, x);
    else
        return std::atan2(y, x);
}
/// @}

} // namespace denhartog
