/// @file
/// @brief The mass in contact alone, in the sliding regime: (33)-(39) in double with error bounds at the cost of the modes.
///
/// Amplitude and phase of the contact need two rows of the mode shapes and three sums. `Bounded` numbers would follow every
/// operation; here the functions of a mode are evaluated in double and what the errors of \f$ R_i \f$ and \f$ \zeta_i \f$ make of
/// them is bounded at once. With \f$ z = \theta + \mathrm{i}\delta = \pi(w + \mathrm{i}\zeta)/R \f$, of size \f$ \pi/R \f$,
/// \f[ R\,w\,u_d = \mathrm{Re}\tan\frac{z}{2}, \qquad g + \zeta R\,u_d = \mathrm{Im}\tan\frac{z}{2}, \qquad
///     \left|\frac{d}{dz}\tan\frac{z}{2}\right| \le \frac{1}{2}\left(1+\left|\tan\frac{z}{2}\right|^2\right), \f]
/// from (28), (29), and from (23) \f$ |R\,v_d'| \le 2R(R+\zeta)\,|v_d|^2 \f$, \f$ |dv_d/d\zeta| = 2R|v_d|^2 \f$. Where the change
/// is not small there is no answer this way.
///
/// That the contact slides is certain below the boundary (69) with an upper bound of the demand (57) of every mode: its value at
/// the start where that is certain to be the largest, else that of `few_modes.hpp`.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/sliding/bounded_modes.hpp"

namespace denhartog {

/// @brief A mode as the contact has it, the same at every r.
struct ContactMode {
    Bounded r_n;     ///< natural frequency ratio
    Bounded zeta;    ///< damping ratio, below 1
    double w;        ///< root of 1 - zeta^2
    Bounded load;    ///< weight of v in V_dj, Eq. (33): psi_ji psi_li R_i^2
    Bounded contact; ///< weight of u and g in U_dj, G_j, Eqs. (34), (35): psi_ji^2 R_i^2
    Bounded square;  ///< weight in the demand (56), times r^2: phi_ji^2
};

/// @brief The modes of a system as the contact has them.
struct ContactModes {
    ModalBasis<Bounded> basis;      ///< shapes at the contact and, below, at the loaded mass where that is another
    Mass load;                      ///< the row of the loaded mass
    std::vector<ContactMode> modes; ///< N; empty where a mode is not underdamped
};

/// @brief Prepares the modes for many frequency ratios.
/// @param basis  shapes at the contact and, where that is another mass, at the loaded mass
/// @return       the modes
[[nodiscard]] ContactModes contact_modes(ModalBasis<Bounded> basis);

/// @brief What the contact does in the sliding regime.
struct ContactSolution {
    Bounded amplitude;   ///< X_j, Eq. (38), units of P / k_1
    Bounded phase;       ///< phi_j, Eq. (39), radians in (-pi, pi]
    double slides_below; ///< the boundary (69) is not below it
};

/// @brief Amplitude and phase of the contact in the sliding regime, mu = 1. @eq{33,34,35,38,39,69}
/// @param modes  the modes
/// @param r      frequency ratio with its error
/// @param beta   friction ratio with its error
/// @return       the solution; none where sliding is not certain
[[nodiscard]] std::optional<ContactSolution> contact_solution(const ContactModes& modes, const Bounded& r, const Bounded& beta);

} // namespace denhartog
