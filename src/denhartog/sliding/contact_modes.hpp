/// @file
/// @brief The mass in contact alone, in the sliding regime: (33)-(39) with error bounds at the cost of the modes.
///
/// Amplitude and phase of the contact need two rows of the mode shapes and three sums. The contact certainly slides below the
/// boundary (69) if an upper bound of (57) for each mode takes the place of the maximum. The bound is the value at the start if
/// that is certainly the largest, else \f$ \frac{\pi}{2}\left(|c_i| + R_i^2|u_i|\right) \f$ with \f$ |c_i| \f$ the size of the
/// mode's free motion in (40). If the bounds do not decide, the largest demand is searched for.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "denhartog/evaluation/batch_forms.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/bounded.hpp"

namespace denhartog {

/// @brief A mode as the contact has it, the same at every r.
struct ContactMode {
    Bounded<double> r_n;                                 ///< natural frequency ratio
    Bounded<double> zeta;                                ///< damping ratio
    evaluation::ArrayWeights<Bounded<double>> weights{}; ///< in the sums
};

/// @brief The modes of a system as the contact has them.
struct ContactModes {
    std::shared_ptr<const ModalBasis<Bounded<double>>> basis; ///< frequencies, damping ratios, and a row of shapes a mass kept
    Mass contact;                                             ///< the row of the mass in contact
    Mass load;                                                ///< the row of the loaded mass
    std::vector<ContactMode> modes;                           ///< N
};

/// @brief Prepares the modes for many frequency ratios; contact and load are rows of the shapes that the basis has.
[[nodiscard]] ContactModes contact_modes(std::shared_ptr<const ModalBasis<Bounded<double>>> basis, Mass contact, Mass load);

/// @brief Motion of the contact in the sliding regime.
struct ContactSolution {
    Bounded<double> amplitude;    ///< X_j, Eq. (38), units of P / k_1
    Bounded<double> phase;        ///< phi_j, Eq. (39), radians in (-pi, pi]
    Bounded<double> slides_below; ///< the boundary (69) is not below it
};

/// @brief Amplitude and phase of the contact in the sliding regime, mu = 1; none if sliding is not certain.
/// @eq{33,34,35,38,39,57,69}
[[nodiscard]] std::optional<ContactSolution> contact_solution(const ContactModes& modes, const Bounded<double>& r,
                                                              const Bounded<double>& beta);

} // namespace denhartog
