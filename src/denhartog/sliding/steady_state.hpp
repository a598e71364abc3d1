/// @file
/// @brief The steady state in the sliding regime: motion, initial values, amplitude and phase of every mass, (38)-(53).
#pragma once

#include <span>
#include <vector>

#include "denhartog/sliding/boundary.hpp"

namespace denhartog {

/// @brief Amplitude, phase and initial values of a mass in the steady state.
template <class T>
struct MassResponse {
    T x0;                     ///< displacement at the maximum of x_j, Eq. (44)
    T v0;                     ///< velocity d/dtau there, Eq. (45)
    T amplitude;              ///< largest displacement; of the mass in contact by Eq. (38)
    T instant;                ///< tau in [0, pi] where the displacement is largest in size
    T phase;                  ///< lag behind the force, Eqs. (39), (47); radians in (-pi, pi]
    T amplitude_monoharmonic; ///< Eq. (52)
    T phase_monoharmonic;     ///< phi_j + phi_kj, Eq. (53); radians in (-pi, pi]
};

/// @brief The steady state at one friction ratio.
template <class T>
struct SteadyState {
    T beta;                              ///< friction ratio, Eq. (11)
    T X_j;                               ///< amplitude of the mass in contact, Eq. (38)
    T phi_j;                             ///< phase of the mass in contact, Eq. (39); radians in (-pi, pi]
    std::vector<MassResponse<T>> masses; ///< N entries
};

/// @brief Displacements and velocities of all masses at an instant.
template <class T>
struct Motion {
    std::vector<T> x;       ///< displacements, in units of P / k_1
    std::vector<T> x_prime; ///< velocities with respect to tau
};

/// @brief The steady state in the sliding regime, with the global maximum of every displacement guaranteed by `global_maximum`.
/// `only` is the one mass whose maximum is wanted besides that of the contact, none for all. InputError if beta is negative or
/// not finite; DomainError at and beyond the boundary (69). @eq{38,39,44,45,47,52,53}
[[nodiscard]] SteadyState<double> steady_state(const ModeSums<double>& sums, const RegimeBoundary<double>& boundary, double beta,
                                               std::optional<Mass> only = std::nullopt);

/// @brief The steady state without its searches: amplitude and phase of the mass in contact, initial values of every mass.
/// Instant, amplitude and phase of the masses not in contact are zero. DomainError if the amplitude (38) is not a positive
/// number. @eq{38,39,44,45,52,53}
template <class T>
[[nodiscard]] SteadyState<T> steady_state_without_maxima(const ModeSums<T>& sums, const T& beta);

/// @brief Motion of all masses at instants, of which zero is at a maximum of x_j: (46) over the half-period and antisymmetric
/// beyond. @eq{41,46}
template <class T>
[[nodiscard]] std::vector<Motion<T>> motions(const ModeSums<T>& sums, const SteadyState<T>& state, std::span<const T> tau);

/// @brief Motion of all masses at one instant. @eq{41,46}
[[nodiscard]] inline Motion<double> motion(const ModeSums<double>& sums, const SteadyState<double>& state, double tau) {
    return motions(sums, state, std::span<const double>(&tau, 1)).front();
}

/// @brief An angle in radians wrapped to (-pi, pi].
template <class T>
[[nodiscard]] T wrapped(const T& angle);

} // namespace denhartog
