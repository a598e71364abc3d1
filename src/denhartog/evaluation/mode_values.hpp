/// @file
/// @brief Values that the forms of one mode return.
#pragma once

#include "denhartog/formulas/complex.hpp"

namespace denhartog::evaluation {

/// @brief The functions of one mode at one frequency ratio: (23), (28), (29).
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

} // namespace denhartog::evaluation
