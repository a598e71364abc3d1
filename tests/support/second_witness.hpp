/// @file
/// @brief The closed form against the second witness, on one scene.
///
/// The witness (`half_period.hpp`) computes in more digits than the closed form is judged to, from matrices that are set up here
/// without `formulas/`, without `modal_basis` and without its eigen-solvers. The closed form is what `response` answers.
#pragma once

#include "tests/support/half_period.hpp"
#include "tests/support/plain_response.hpp"

namespace denhartog {

/// @brief The number type in which the witness of a closed form in T computes: 50 digits against double, else 100. In 100 digits
/// the matrices of a scene are set up, and no motion is compared.
template <class T>
using WitnessOf = std::conditional_t<std::same_as<T, double>, Real50, Real100>;

/// @brief The boundary-value problem of a scene: (6) with its matrices, from the scene's numbers taken as exact.
///
/// The damping matrix of modal damping ratios needs the modes by its definition, Eq. (19); they come from Jacobi rotations
/// in the witness's number type.
/// @eq{6,7,8}  @domain{a scene that `check` lets pass}
/// @throws       InputError where r or beta is missing
template <class T>
[[nodiscard]] HalfPeriodProblem<WitnessOf<T>> half_period_problem(const Scene<T>& scene);

/// @brief The sliding motion as the closed form gives it, at the instants pi n / steps.
template <class T>
struct SampledMotion {
    Vector<T> x_0;       ///< displacements at tau = 0, Eq. (44), N values
    Vector<T> x_prime_0; ///< velocities at tau = 0, Eq. (45), N values
    Vector<T> amplitude; ///< amplitudes, N values
    Vector<T> phase;     ///< phases of the masses, Eqs. (39), (47), radians, N values
    Mass contact;        ///< the mass in contact, j
    Matrix<T> x;         ///< displacements, Eq. (46), mass by instant, N x (steps + 1)
};

/// @brief Samples a steady state of the closed form.
template <class T>
[[nodiscard]] SampledMotion<T> sampled_motion(const ModeSums<T>& sums, const SteadyState<T>& state, int steps);

/// @brief How far a motion is from the witness's: every figure is the largest over the masses.
///
/// Displacements and amplitudes are measured against the amplitude of their own mass, initial velocities against the largest
/// velocity of their own mass in the sample, phases in radians round the circle.
template <class T>
struct Agreement {
    T displacement;  ///< |x_k(tau) - witness|, relative, the largest over the instants too
    T x_0;           ///< |x_k0 - witness|, relative
    T x_prime_0;     ///< |x'_k0 - witness|, relative
    T amplitude;     ///< |X_k - witness|, relative
    T phi_j;         ///< |phi_j - witness|
    T phase;         ///< |phi_k - witness|, over all masses
    Mass worst_mass; ///< the mass with the largest of the first four
};

/// @brief Largest of the first five figures: the error of the motion. @param a an agreement @return its largest relative error
template <class T>
[[nodiscard]] T worst(const Agreement<T>& a);

/// @brief Compares a sampled motion with the witness's.
/// @throws         InputError where the samples differ in size, DomainError where a number is not finite
template <class T>
[[nodiscard]] Agreement<T> compare(const SampledMotion<T>& motion, const HalfPeriodMotion<WitnessOf<T>>& witness);

/// @brief Compares the closed form with the second witness on one scene.
/// @throws       InputError for a bad scene; DomainError where the closed form or the witness finds no sliding motion
template <class T>
[[nodiscard]] Agreement<T> compare_with_second_witness(const Scene<T>& scene, int steps = 64);

} // namespace denhartog
