/// @file
/// @brief What the evaluation forms of one mode return.
#pragma once

#include "denhartog/formulas/complex.hpp"

namespace denhartog::evaluation {

/// @brief What one mode contributes at one frequency ratio: (23), (28), (29).
template <class T>
struct ModeFunctions {
    Complex<T> v; ///< complex response function, Eq. (23)
    T u;          ///< first damping function, Eq. (28)
    T g;          ///< second damping function, Eq. (29)
};

/// @brief Both damping functions of a mode: (28), (29).
template <class T>
struct DampingFunctions {
    T u; ///< first damping function, Eq. (28)
    T g; ///< second damping function, Eq. (29)
};

/// @brief The braces of (40) and their first two derivatives in \f$ \tau \f$.
template <class T>
struct FrictionMotion {
    T value;        ///< 1 - (1 + g) d - u R q
    T prime;        ///< first derivative in tau
    T double_prime; ///< second derivative in tau
};

/// @brief The free motions of a mode and their rates: (A.8), (A.9).
template <class T>
struct FreeMotion {
    T d;              ///< from unit displacement, Eq. (A.8)
    T q;              ///< from unit velocity over R, Eq. (A.8)
    T d_prime;        ///< rate of d, Eq. (A.9)
    T q_prime;        ///< rate of q, Eq. (A.9)
    T q_double_prime; ///< rate of that
};

/// @brief The braces of (40) with their derivatives from the free motions.
/// @eq{40,A.8,A.9}  @derivation{evaluation_forms}  @domain{R > 0, zeta >= 0}
/// @param free  the free motions at the instant
/// @param R     modal frequency ratio, Eq. (22)
/// @param u     first damping function of the mode, Eq. (28)
/// @param g     second damping function of the mode, Eq. (29)
/// @return      value and derivatives in tau; dimensionless
template <class T>
[[nodiscard]] FrictionMotion<T> friction_motion_of(const FreeMotion<T>& free, const T& R, const T& u, const T& g) {
    return {1 - (1 + g) * free.d - u * R * free.q, -((1 + g) * free.d_prime) - u * (R * free.q_prime),
            (1 + g) * (free.q_prime / R) - u * (R * free.q_double_prime)};
}

} // namespace denhartog::evaluation
