/// @file
/// @brief The steady motions without stops, proved: that of the sliding regime, (38), (39), (41), (44) to (53), its boundary, (54) to
/// (58), (67), (69), and the motion with the contact held, (88).
#pragma once

#include <optional>
#include <vector>

#include "denhartog/reference/friction.hpp"
#include "denhartog/sliding/steady_state.hpp"

namespace denhartog::reference {
/// @brief The contact, below the boundary of beta, without the masses. @eq{38,39}
[[nodiscard]] SteadyState<Ball> contact_in_balls(const ResponsesInBalls& r, const Ball& beta);

/// @brief A mass at tau = 0, where the displacement of the contact is largest: `x0` and `v0`, and nothing else. Row N is the
/// contact; a mass may move as the contact does.
/// @eq{44,45}
[[nodiscard]] MassResponse<Ball> start_of_mass_in_balls(const ResponsesInBalls& r, const SteadyState<Ball>& contact,
                                                        std::size_t row, bool is_contact);

/// @brief The displacement of a mass and its derivatives at an instant in [0, pi], or over a stretch. @eq{41}
[[nodiscard]] Series displacement_in_balls(const ResponsesInBalls& r, const MassResponse<Ball>& m, const Ball& beta,
                                           std::size_t row, const Ball& tau);

/// @brief One mass, with the largest displacement proved.
/// @eq{41,44,45,46,47,50,51,52,53}
/// @throws Unproved if a maximum is not settled
[[nodiscard]] MassResponse<Ball> mass_in_balls(const ResponsesInBalls& r, const SteadyState<Ball>& contact, std::size_t row,
                                               bool is_contact);

/// @brief A harmonic motion, \f$ \mathrm{Re}(X_k\mathrm e^{\mathrm i\tau}) \f$: N displacements, then N velocities, 2 N x 1. tau counts
/// from a maximum of the force.
[[nodiscard]] BallMatrix harmonic_in_balls(const std::vector<Complex<Ball>>& X, slong N, const Ball& tau);

/// @brief The sliding motion: the contact, and `x0` and `v0` of the N masses, nothing else of them. @eq{38,39,44,45}
[[nodiscard]] SteadyState<Ball> sliding_motion_in_balls(const ResponsesInBalls& r, const Ball& beta);

/// @brief The state of the masses in that motion at any instant, as `harmonic_in_balls` has it. @eq{25,41}
[[nodiscard]] BallMatrix state_in_balls(const ResponsesInBalls& r, const SteadyState<Ball>& motion, const Ball& tau);

/// @brief The boundary from the response functions, without `sticking` and `instants`. Where damping couples the modes, (56) has
/// no modes to sum over, and `paper` is `exact`.
/// @eq{54,56,57,58,67,69}
/// @throws Unproved if a maximum is not settled
[[nodiscard]] Boundary<Ball> boundary_in_balls(const SceneInBalls& s, const ResponsesInBalls& r);

/// @brief The motion with the contact held.
struct StuckInBalls {
    std::vector<Complex<Ball>> X{}; ///< complex amplitudes of the masses: x_k = Re(X_k e^{i tau})
    Complex<Ball> load{};           ///< complex amplitude of the force that holds the contact
    Ball compliance{};              ///< static displacement of the contact by a unit force on it
};

/// @brief The response if a force holds the contact, \f$ \mathbf w^T\mathbf X = 0 \f$; none if the system may resonate. @eq{88}
[[nodiscard]] std::optional<StuckInBalls> stuck_in_balls(const SceneInBalls& s);

/// @brief The friction ratio from which the contact can rest for ever: 1 / mu if the load acts on the contact alone. @eq{88}
[[nodiscard]] Ball sticking_limit_in_balls(const SceneInBalls& s, const StuckInBalls& stuck);

/// @brief (88) as printed, for a chain with one loaded mass and a contact on the wall. @eq{88}
/// @throws Unproved as `modes_in_balls`
[[nodiscard]] Ball sticking_limit_by_88(const SceneInBalls& s, std::size_t load);

} // namespace denhartog::reference
