/// @file
/// @brief What a number type must offer to the formulas.
///
/// A formula of the paper is one function template on its number type `T`. It asks of `T`
///  - construction from `int`,
///  - the four operations and unary minus,
///  - `sqrt`, `exp`, `sin`, `cos`, `sinh`, `cosh`, `atan2`, found by argument-dependent lookup,
///  - `pi<T>()`.
///
/// It asks for no comparison and no conversion from a floating-point literal, so that the derivation can instantiate the same
/// source with a symbolic scalar. `double` is served here, and so are `float` and `long double`, which only the formulas know;
/// the multiprecision types are served in `multiprecision.hpp`, the symbolic scalar in `derivation/symbolic.hpp`.
#pragma once

#include <cmath>
#include <concepts>
#include <numbers>

namespace denhartog {

/// @brief The circle constant of a number type; specialise `value()` for a type of your own.
/// @tparam T  the number type
template <class T>
struct PiOf {
    static_assert(std::floating_point<T>, "no pi for this number type: include the header that defines the type");
    /// @return pi, correctly rounded
    static T value() { return std::numbers::pi_v<T>; }
};

/// @brief pi in the number type `T`.
/// @return pi; dimensionless
template <class T>
[[nodiscard]] T pi() {
    return PiOf<T>::value();
}

using std::atan2;
using std::cos;
using std::cosh;
using std::exp;
using std::sin;
using std::sinh;
using std::sqrt;

} // namespace denhartog
