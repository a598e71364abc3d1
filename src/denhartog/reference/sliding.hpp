/// @file
/// @brief The steady state of the sliding regime, proved: (38), (39), (41), (44) to (53).
#pragma once

#include <optional>
#include <vector>

#include "denhartog/reference/friction.hpp"

namespace denhartog::reference {

/// @brief What a mass does in the sliding regime.
struct SlidingMassInBalls {
    Ball amplitude{};              ///< largest |x_k|, Eqs. (46), (47)
    Ball phase{};                  ///< its phase, Eq. (47); radians in (-pi, pi]
    Ball x0{};                     ///< displacement at tau = 0, where that of the contact is largest, Eq. (44)
    Ball v0{};                     ///< velocity there, Eq. (45)
    Ball instant{};                ///< time in [0, pi] of the largest |x_k|, Eq. (47)
    Ball amplitude_monoharmonic{}; ///< Eq. (52)
    Ball phase_monoharmonic{};     ///< phi_j + phi_kj, Eq. (53)
};

/// @brief The contact in the sliding regime.
struct SlidingContactInBalls {
    Ball X_j{};   ///< amplitude of the contact, Eq. (38)
    Ball phi_j{}; ///< its phase, Eq. (39); radians in (-pi, pi]
};

/// @brief The contact. @eq{38,39} @param r response functions @param beta friction ratio below the boundary @return X_j, phi_j
[[nodiscard]] SlidingContactInBalls contact_in_balls(const ResponsesInBalls& r, const Ball& beta);

/// @brief A mass at tau = 0, where the displacement of the contact is largest: `x0` and `v0`, and nothing else.
/// @eq{44,45}
/// @param r        response functions
/// @param contact  the contact
/// @param beta     friction ratio below the boundary
/// @param row      the mass; N for the contact, w^T x
/// @param is_contact  whether its displacement is that of the contact
/// @return         where it starts
[[nodiscard]] SlidingMassInBalls start_of_mass_in_balls(const ResponsesInBalls& r, const SlidingContactInBalls& contact,
                                                        const Ball& beta, std::size_t row, bool is_contact);

/// @brief The displacement of a mass and its derivatives.
/// @eq{41}
/// @param r     response functions
/// @param m     the mass at tau = 0
/// @param beta  friction ratio below the boundary
/// @param row   the mass; N for the contact, w^T x
/// @param tau   an instant in [0, pi], or a stretch
/// @return      its series
[[nodiscard]] Series displacement_in_balls(const ResponsesInBalls& r, const SlidingMassInBalls& m, const Ball& beta,
                                           std::size_t row, const Ball& tau);

/// @brief One mass, with the largest displacement proved.
/// @eq{41,44,45,46,47,50,51,52,53}
/// @param r        response functions
/// @param contact  the contact
/// @param beta     friction ratio below the boundary
/// @param row      the mass; N for the contact, w^T x
/// @param is_contact  whether its displacement is that of the contact
/// @return         what it does
/// @throws         Unproved where a maximum is not settled
[[nodiscard]] SlidingMassInBalls mass_in_balls(const ResponsesInBalls& r, const SlidingContactInBalls& contact, const Ball& beta,
                                               std::size_t row, bool is_contact);

/// @brief A harmonic motion, \f$ \mathrm{Re}(X_k\mathrm e^{\mathrm i\tau}) \f$.
/// @param X    complex amplitudes of the masses; more are not looked at
/// @param N    number of masses
/// @param tau  from a maximum of the force, an instant or a ball that holds it
/// @return     N displacements, then N velocities, 2 N x 1
[[nodiscard]] BallMatrix harmonic_in_balls(const std::vector<Complex<Ball>>& X, slong N, const Ball& tau);

/// @brief The motion of all masses in the sliding regime, at any instant.
/// @eq{25,41,44,45}
class SlidingMotionInBalls {
public:
    /// @param r     response functions
    /// @param beta  friction ratio below the boundary
    SlidingMotionInBalls(ResponsesInBalls r, const Ball& beta);
    /// @brief Displacements and velocities. @param tau from a maximum of the force, an instant or a ball that holds it
    /// @return N displacements, then N velocities, 2 N x 1
    [[nodiscard]] BallMatrix at(const Ball& tau) const;

private:
    ResponsesInBalls r_;
    Ball beta_;
    SlidingContactInBalls contact_;
    std::vector<SlidingMassInBalls> start_{};
};

} // namespace denhartog::reference
