/// @file
/// @brief The equations of motion (6) with every number a ball, and the refusal of what is not proved.
///
/// In the paper's case the contact is one mass on a wall and the load acts on one mass: \f$ \mathbf{w} \f$ and
/// \f$ \mathbf{p} \f$ are unit vectors. A contact between two masses has \f$ \mathbf{w} = \mathbf{e}_j - \mathbf{e}_k \f$, another
/// one any \f$ \mathbf{w} \f$, and a load may act on several masses; the equations are the same:
/// \f[ \overline{\mathbf M}\bar{\mathbf x}'' + \overline{\mathbf C}\bar{\mathbf x}' + \overline{\mathbf K}\bar{\mathbf x} =
/// \mathbf{p}\cos\tau - \mathbf{p}_{\mathrm i}\sin\tau - \beta\,\mathbf{w}\,\mathrm{sgn}(\mathbf{w}^T\bar{\mathbf x}') \f]
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "denhartog/number/ball_matrix.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog::reference {

/// @brief Something that could not be proved with the bits at hand; more bits may help.
struct Unproved : PrecisionError {
    using PrecisionError::PrecisionError;
};

/// @brief A statement that is certainly not so: no number of bits will prove it.
struct Disproved : Unproved {
    using Unproved::Unproved;
};

class KeptModes;

/// @brief A scene, every number a ball.
/// @eq{6}
struct SceneInBalls {
    BallMatrix M{}; ///< masses in units of m_1, N x N; the bar of (7) is a factor r^2
    BallMatrix K{}; ///< stiffnesses in units of k_1, N x N
    BallMatrix C{}; ///< damping in units of sqrt(k_1 m_1), N x N; the bar of (7) is a factor r. Empty until (19) if zeta is given
    std::vector<Ball> zeta{}; ///< damping ratios by ascending natural frequency, Eq. (18); empty if C is given
    BallMatrix w{};           ///< w^T x is the displacement of the contact, N x 1
    BallMatrix p{};           ///< force on each mass in units of P, N x 1; its real part if forces are out of phase
    BallMatrix p_i{};         ///< its imaginary part; empty if forces are in phase
    BaseMotion base_motion = BaseMotion::none; ///< of whose motion the load is made
    Ball r{};                                  ///< frequency ratio, Eq. (10)
    Ball mu{};                                 ///< static over kinetic friction, Eq. (3)
    std::optional<Ball> beta{};                ///< friction ratio, Eq. (11)
    std::size_t contact = 0;                   ///< the mass in contact, j
    std::shared_ptr<KeptModes> kept{};         ///< natural modes found so far, shared by scenes of one system; null: not kept
    Effort* effort = nullptr;                  ///< the work that may be spent on the scene; null: as much as it takes

    /// @brief The number of masses.
    [[nodiscard]] slong N() const { return M.rows(); }
    /// @brief Whether the contact moves as mass k does, and with no other.
    [[nodiscard]] bool is_the_contact(slong k) const;
};

/// @brief \f$ \mathbf K - r^2\mathbf M + \mathrm ir\mathbf C \f$ as a real matrix of real and imaginary parts, n rows of each.
[[nodiscard]] BallMatrix dynamic_stiffness(const SceneInBalls& scene, slong n);

/// @brief The matrices of a scene with r as its author wrote it.
/// @eq{6,7,8,73}
[[nodiscard]] SceneInBalls in_matrices(const Scene<Ball>& scene);

} // namespace denhartog::reference
