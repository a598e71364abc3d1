/// @file
/// @brief Natural frequencies and mode shapes, proved, (13) to (17), and the modal frequency ratios (22).
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "denhartog/reference/scene_in_balls.hpp"

namespace denhartog::reference {

/// @brief Modes whose frequencies the bits at hand do not distinguish. They enter every sum as a whole.
struct ModeCluster {
    std::size_t first = 0; ///< its first mode
    std::size_t last = 0;  ///< the mode behind its last
};

/// @brief The modes of a system at a frequency ratio.
///
/// The shapes of a cluster are some orthonormal basis of the space that its mode shapes span. Each R of a cluster holds the
/// modal frequency ratios of all its modes.
struct ModesInBalls {
    std::vector<Ball> R{};                ///< modal frequency ratios (22), by ascending natural frequency
    std::vector<Ball> zeta{};             ///< damping ratios
    std::vector<std::vector<Ball>> psi{}; ///< psi_ki of (17): a row for each mass, then w^T psi, then p^T psi, part by part
    std::vector<ModeCluster> clusters{};  ///< the clusters of more than one mode
    slong N = 0;                          ///< number of masses
    Effort* effort = nullptr;             ///< that of the scene

    /// @brief Row of the contact, w^T psi_i.
    [[nodiscard]] const std::vector<Ball>& at_contact() const { return psi[static_cast<std::size_t>(N)]; }
    /// @brief Row of the load, p^T psi_i.
    [[nodiscard]] const std::vector<Ball>& at_load() const { return psi[static_cast<std::size_t>(N) + 1]; }

    /// @brief Row of the imaginary part of the load; null if forces are in phase.
    [[nodiscard]] const std::vector<Ball>* at_load_i() const {
        return psi.size() > static_cast<std::size_t>(N) + 2 ? &psi.back() : nullptr;
    }

    /// @brief Error of the sum of psi_ki psi_ni f_i over the modes if all modes of a cluster share one ball f.
    ///
    /// With f_i = f + e_i and |e_i| at most e, the sum of psi_ki psi_ni f_i differs from that with f alone by at most e times
    /// the product of the lengths of both rows in the cluster (Cauchy and Schwarz), whichever basis the shapes are.
    [[nodiscard]] Ball left_open(const std::vector<Ball>& k, const std::vector<Ball>& n, const std::vector<Ball>& f) const;
    /// @brief The product of the lengths of two rows in a cluster.
    [[nodiscard]] static Ball lengths_in(const ModeCluster& cluster, const std::vector<Ball>& k, const std::vector<Ball>& n);
};

/// @brief Frequencies and shapes of the modes, which depend neither on the frequency ratio nor on damping and friction.
struct NaturalModesInBalls {
    std::vector<Ball> lambda{};           ///< squares of the natural frequency ratios, ascending
    std::vector<std::vector<Ball>> phi{}; ///< mass-normalised shapes, with the rows of `ModesInBalls::psi`
    std::vector<ModeCluster> clusters{};  ///< the clusters of more than one mode; they have one lambda
    long work = 0;                        ///< what they cost, as `Effort` counts
};

/// @brief The natural modes of one system that were found so far, in each precision. All questions about the system share them,
/// from any thread.
class KeptModes {
public:
    /// @brief The natural modes of a scene in the current bits. A question pays for them as if it had solved for them: what
    /// it may cost does not depend on what was asked before.
    /// @throws as `modes_in_balls`; nothing is kept then
    [[nodiscard]] std::shared_ptr<const NaturalModesInBalls> of(const SceneInBalls& scene);
    /// @brief Eigenproblems (15) solved so far.
    [[nodiscard]] long solved() const { return solved_; }

private:
    struct Kept {
        slong bits;
        BallMatrix M, K, w, p, p_i;
        std::shared_ptr<const NaturalModesInBalls> modes;
    };
    std::mutex one_at_a_time_{};
    std::vector<Kept> kept_{};
    std::atomic<long> solved_ = 0;
};

/// @brief The modes of a scene.
///
/// With a Cholesky factor L of M, (15) is the eigenvalue problem of the symmetric matrix
/// \f$ \mathbf{A} = \mathbf{L}^{-1}\mathbf{K}\mathbf{L}^{-T} \f$. Approximate eigenvectors of A, made orthonormal by a second
/// Cholesky factor, take A to \f$ \boldsymbol\Lambda + \mathbf{E} \f$, which has the same eigenvalues. With
/// \f$ \varepsilon = \|\mathbf{E}\|_F \f$ and a gap \f$ \delta \f$ about an eigenvalue, Weyl's theorem puts it within
/// \f$ \varepsilon \f$ of its entry, that of Kato and Temple within \f$ \varepsilon^2/\delta \f$, and that of Davis and Kahan its
/// vector within \f$ \sqrt2\varepsilon/\delta \f$.
/// Without damping ratios `zeta` is empty.
/// @eq{13,14,15,16,17,22}
/// @throws Unproved if the mass matrix is not proved positive definite, a frequency is not proved positive, or modes of
///               one cluster have different damping ratios
[[nodiscard]] ModesInBalls modes_in_balls(const SceneInBalls& scene);

/// @brief The mode shapes of the masses, Psi of (17), mass by mode.
[[nodiscard]] BallMatrix shapes_of(const ModesInBalls& modes);

/// @brief The damping matrix that gives the modes their damping ratios. @eq{19}
[[nodiscard]] BallMatrix damping_matrix_in_balls(const SceneInBalls& scene, const ModesInBalls& modes);

/// @brief A copy of a scene with the load of its base or wall, if that depends on the frequency: in the frame at rest
/// \f$ (\mathbf K + \mathrm ir\mathbf C)\mathbf 1 \f$ of a base that moves alone; in that of a wall that does
/// \f$ -(\mathbf K + \mathrm ir\mathbf C - r^2\mathbf M)\mathbf 1 \f$.
/// @throws as `modes_in_balls`, if (19) is needed
[[nodiscard]] SceneInBalls with_load_of_base(SceneInBalls scene);

} // namespace denhartog::reference
