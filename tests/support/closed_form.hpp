/// @file
/// @brief The closed form in 50 and 100 digits: the truth that the library's numbers in double are compared with.
///
/// Modes come from Jacobi's rotations in twice the digits, sums and motion from the formulas, largest values from a fine sample
/// and what lies next to it. It shares with the library the formulas and `evaluation/`, in more digits, and the types; not the
/// eigen-solver, the sums or the searches. The functions are named as the library names them in double.
#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <vector>

#include "denhartog/sliding/boundary.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "tests/support/multiprecision.hpp" // NOLINT(misc-include-cleaner): the number types

namespace denhartog {

/// @brief A number type of the truth.
template <class T>
concept ManyDigits = std::same_as<T, Real50> || std::same_as<T, Real100>;

/// @brief The modal basis of a system. Modes that coincide are those that diagonalise the damping matrix, where it has such.
/// InputError where `check` throws. @eq{14,15,18}
template <ManyDigits T>
[[nodiscard]] ModalBasis<T> modal_basis(const System<T>& s);

/// @brief Modes and sums over modes at a frequency ratio. @eq{22,23,28,29,33,34,35,64,65}
template <ManyDigits T>
[[nodiscard]] ModeSums<T> mode_sums(const ModalBasis<T>& basis, Mass contact, const LoadRows& load, const T& r);

/// @brief The expression of (57) summed over the modes, at an instant in [0, pi]. @eq{56,57}
template <ManyDigits T>
[[nodiscard]] T sliding_demand(const ModeSums<T>& s, const T& tau);

/// @brief The instant in [0, pi] at which `sliding_demand` is largest; 0 stands for the limit. @eq{56,57}
template <ManyDigits T>
[[nodiscard]] T instant_of_largest_demand(const ModeSums<T>& s);

/// @brief The boundary with the instants of the largest demands given. @eq{54,56,57,67,69,88}
template <ManyDigits T>
[[nodiscard]] Boundary<T> boundary_at(const ModeSums<T>& s, const T& mu, const T& instant, std::vector<T> instants);

/// @brief The boundary. @eq{54,56,57,67,69,88}
template <ManyDigits T>
[[nodiscard]] Boundary<T> boundary(const ModeSums<T>& s, const T& mu);

/// @brief The steady state but for instants, amplitudes and phases of the masses not in contact, which are zero.
/// @eq{38,39,44,45,52,53}
template <ManyDigits T>
[[nodiscard]] SteadyState<T> steady_state_without_maxima(const ModeSums<T>& s, const T& beta);

/// @brief The steady state; `only` is the one mass whose maximum is wanted besides that of the contact, none for all.
/// @eq{38,39,44,45,46,47,52,53}
template <ManyDigits T>
[[nodiscard]] SteadyState<T> steady_state(const ModeSums<T>& s, const RegimeBoundary<T>& boundary, const T& beta,
                                          std::optional<Mass> only = std::nullopt);

/// @brief Motion of all masses at an instant, of which zero is at a maximum of x_j. @eq{41,46}
template <ManyDigits T>
[[nodiscard]] Motion<T> motion(const ModeSums<T>& s, const SteadyState<T>& state, const T& tau);

/// @brief The same at many instants. @eq{41,46}
template <ManyDigits T>
[[nodiscard]] std::vector<Motion<T>> motions(const ModeSums<T>& s, const SteadyState<T>& state, std::span<const T> tau) {
    std::vector<Motion<T>> all;
    for (const T& each : tau) all.push_back(motion(s, state, each));
    return all;
}

/// @brief An angle in radians wrapped to (-pi, pi].
template <ManyDigits T>
[[nodiscard]] T wrapped(const T& angle) {
    const T turn = 2 * pi<T>();
    const T a = angle - turn * floor(T((angle + pi<T>()) / turn));
    return a > pi<T>() ? T(a - turn) : a <= -pi<T>() ? T(a + turn) : a;
}

} // namespace denhartog
