/// @file
/// @brief What the two time-domain solvers share: states, phases of sliding and sticking, stops.
#pragma once

#include <cstddef>
#include <vector>

namespace denhartog {

/// @brief Displacements and velocities of all masses at an instant.
template <class T>
struct State {
    std::vector<T> x;       ///< displacements in units of P / k_1, N values
    std::vector<T> x_prime; ///< velocities with respect to tau, N values
};

/// @brief All masses at rest at zero.
/// @param N  number of masses
/// @return   the state
template <class T>
[[nodiscard]] State<T> at_rest(std::size_t N) {
    return {std::vector<T>(N, T(0)), std::vector<T>(N, T(0))};
}

/// @brief A time of sliding in one direction or of sticking.
template <class T>
struct Phase {
    int direction; ///< sign of the contact's velocity: 1 or -1 while it slides, 0 while it sticks
    T start;       ///< tau at its start
    T end;         ///< tau at its end
};

/// @brief A stop of the contact: a sticking phase of positive length.
template <class T>
struct Stop {
    T start; ///< tau where the contact comes to rest; from the maximum of the force
    T end;   ///< tau where it breaks away
    T x;     ///< where it rests
};

/// @brief The displacement of a mass where it is largest in size.
template <class T>
struct Extremum {
    T x;             ///< the displacement, with its sign
    T instant;       ///< tau there; where the mass rests, the start of the rest
    T unsure = T(0); ///< how much larger a displacement may be, where the effort did not suffice to exclude it; else 0
    T spread = T(0); ///< how far the phase of another instant is, where the displacement may be the largest as well; else 0
};

/// @brief What a mass does over the steady motion.
template <class T>
struct MassMotion {
    T amplitude; ///< largest |x_k| over the motion
    /// tau of the extremum as a lag behind the force, half a period later where x_k is negative there; in (-pi, pi]
    T phase;
    T spread = T(0); ///< how far the phase of another instant is, where |x_k| may be the largest as well; else 0
};

} // namespace denhartog
