/// @file
/// @brief The number types in which callers' forms are evaluated where the roundings of their own type would add up.
#pragma once

#include "denhartog/number/double_double.hpp"

namespace denhartog {

/// @brief The next wider number type, for a difference whose terms may not be rounded first; the type itself where none is wider.
template <class T>
struct WiderOf {
    using type = T; ///< the wider type
};
/// @brief Of `float`.
template <>
struct WiderOf<float> {
    using type = double; ///< the wider type
};
/// @brief Of `double`.
template <>
struct WiderOf<double> {
    using type = DoubleDouble; ///< the wider type
};
template <>
struct WiderOf<long double>; // who uses it defines it

} // namespace denhartog
