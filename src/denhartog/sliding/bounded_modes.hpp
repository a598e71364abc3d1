/// @file
/// @brief The modal basis with bounds of its errors, the functions of its modes with theirs, and the load of a base or a wall that moves
/// alone.
///
/// The bounds of a basis come from what the eigen-solvers are trusted with: an error of each natural frequency of 8 N eps of
/// itself on a chain and, times what the springs multiply, of masses of very different size; else of its square of 8 N eps of the
/// highest square, times what a full mass matrix multiplies when it is scaled to a diagonal of ones; of a mode shape an angle of
/// 8 N eps over the relative distance of its frequency from the next one, which moves a light mass far.
/// They cost no eigen-solve. Every number of a scene is taken to be off by a unit in its last place, as a decimal fraction or a
/// quotient is.
///
/// With the absolute displacements \f$ \mathbf x \f$ of the masses and a base that moves by \f$ X\cos\tau \f$ springs and dampers
/// are strained by \f$ \mathbf x - \mathbf 1X\cos\tau \f$: the base loads the masses by
/// \f$ (\mathbf K + \mathrm ir\mathbf C)\mathbf 1 \f$ in units of \f$ P = k_1X \f$. In the frame of a wall that moves by
/// \f$ X\cos\tau \f$ the contact rubs against a wall at rest, the base moves by \f$ -X\cos\tau \f$, and inertia adds
/// \f$ r^2\mathbf M\mathbf 1 \f$.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/sliding/mode_sums.hpp"

namespace denhartog {

/// @brief A modal basis with bounds of its errors.
[[nodiscard]] ModalBasis<Bounded<double>> with_errors(const System<double>& system, const ModalBasis<double>& basis);

/// @brief The modes of a system with bounds of their errors, as several answers share them; paid from a budget. @eq{14,15}
[[nodiscard]] inline std::shared_ptr<const ModalBasis<Bounded<double>>> modes_with_errors(const System<double>& system,
                                                                                          Effort* effort = nullptr) {
    return std::make_shared<const ModalBasis<Bounded<double>>>(with_errors(system, modal_basis(system, effort)));
}

/// @brief Modes with bounds, their shapes at a few masses alone, a row each, see `modal_basis_at`: one eigen-solve. @eq{14,15}
[[nodiscard]] ModalBasis<Bounded<double>> bounded_basis_at(const System<double>& system, const std::vector<Mass>& masses,
                                                           Effort* effort = nullptr);

/// @brief The system with a force and a phase of each mass, the load that its base or wall makes at a frequency ratio, with bounds
/// for rounding and the errors of the modes; the same system if the load does not depend on the frequency. InputError if `check`
/// throws; DomainError if the load vanishes; PrecisionError as `modal_basis`. @eq{6,7,19}
[[nodiscard]] System<double> with_load_at(const System<double>& system, double r);

/// @brief Modes and sums without their bounds.
[[nodiscard]] ModeSums<double> values_of(const ModeSums<Bounded<double>>& sums);
/// @brief A modal basis without its bounds.
[[nodiscard]] ModalBasis<double> values_of(const ModalBasis<Bounded<double>>& basis);

/// @brief (23), (28), (29) of one mode with bounds of what the errors of \f$ R_i \f$ and \f$ \zeta_i \f$ make of them.
///
/// The functions are evaluated on values alone, and all errors are bounded at once. With
/// \f$ z = \theta + \mathrm{i}\delta = \pi(w + \mathrm{i}\zeta)/R \f$, of size \f$ \pi/R \f$,
/// \f[ R\,w\,u_d = \mathrm{Re}\tan\frac{z}{2}, \qquad g + \zeta R\,u_d = \mathrm{Im}\tan\frac{z}{2}, \qquad
///     \left|\frac{d}{dz}\tan\frac{z}{2}\right| \le \frac{1}{2}\left(1+\left|\tan\frac{z}{2}\right|^2\right), \f]
/// from (28), (29), and from (23) \f$ |R\,v_d'| \le 2R(R+\zeta)\,|v_d|^2 \f$, \f$ |dv_d/d\zeta| = 2R|v_d|^2 \f$. Where the change
/// is not small, and without oscillations, every operation carries its own bound.
/// @eq{23,28,29}
[[nodiscard]] evaluation::ModeFunctions<Bounded<double>> bounded_mode_functions(const Bounded<double>& R,
                                                                                const Bounded<double>& zeta);

/// @brief The larger of two numbers.
template <class T>
[[nodiscard]] T larger(const T& a, const T& b) {
    return a < b ? b : a;
}
/// @brief The larger value, with the larger bound.
[[nodiscard]] inline Bounded<double> larger(const Bounded<double>& a, const Bounded<double>& b) {
    return {std::max(a.x, b.x), std::max(a.e, b.e)};
}

/// @brief A largest value as a search found it.
template <class T>
[[nodiscard]] T found_by_search(const T& value) {
    return value;
}
/// @brief A maximum with a bound. The search compares rounded values: the true maximum exceeds the one found by no more than the
/// error where that lies, which is taken to be at most half again of the error where the search ended, and a unit or two.
[[nodiscard]] inline Bounded<double> found_by_search(const Bounded<double>& value) {
    return Bounded<double>::rounded(value.x, value.e + value.e / 2, 2);
}

/// @brief True if the load leaves the contact unmoved without friction: \f$ |V_{dj}| \f$ is below the rounding of its own terms.
[[nodiscard]] bool contact_is_unmoved(const ModeSums<double>& sums);
/// @brief True if \f$ V_{dj} \f$ is within its bound of zero.
[[nodiscard]] bool contact_is_unmoved(const ModeSums<Bounded<double>>& sums);

/// @brief True if the system resonates without damping while the contact is held: Y_jj is below the rounding of its own terms.
template <class T>
[[nodiscard]] bool stuck_system_resonates(const ModeSums<T>& sums);

/// @brief Zero in place of a number without a digit.
template <class T>
[[nodiscard]] T zero_for(const T&) {
    return T(0);
}
/// @brief Zero with a bound that is the largest size of the number.
[[nodiscard]] inline Bounded<double> zero_for(const Bounded<double>& x) { return {0.0, x.most()}; }

/// @brief An instant that rounding may have put a little outside the half-period, in it.
[[nodiscard]] inline double in_half_period(double tau) { return std::clamp(tau, 0.0, pi<double>()); }
/// @brief An instant in the half-period, with a bound of what moving it there changes.
[[nodiscard]] inline Bounded<double> in_half_period(const Bounded<double>& tau) {
    const double inside = in_half_period(tau.x);
    return {inside, tau.e + std::abs(tau.x - inside)};
}

/// @brief The angle, at most 1, by which errors of two natural frequencies may turn their modes towards each other: that of the
/// squares over their distance. The modes of a chain keep their digits however far they are apart; those of other systems do not.
[[nodiscard]] inline double angle_of_turn(const Bounded<double>& r_i, const Bounded<double>& r_k) {
    const double error_of_squares = std::min(r_k.x * r_i.e + r_i.x * r_k.e, r_i.x * r_i.e + r_k.x * r_k.e); // the first of chains
    return error_of_squares / std::max(error_of_squares, std::abs(r_i.x - r_k.x) * (r_i.x + r_k.x));
}

} // namespace denhartog
