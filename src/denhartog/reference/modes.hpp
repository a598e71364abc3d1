/// @file
/// @brief The equations of motion (6) with every number a ball, and their natural modes, proved: (13) to (17), (22).
///
/// In the paper's case the contact is one mass on a wall and the load acts on one mass: \f$ \mathbf{w} \f$ and
/// \f$ \mathbf{p} \f$ are unit vectors. A contact between two masses has \f$ \mathbf{w} = \mathbf{e}_j - \mathbf{e}_k \f$, another
/// one any \f$ \mathbf{w} \f$, and a load may act on several masses; the equations are the same:
/// \f[ \overline{\mathbf M}\bar{\mathbf x}'' + \overline{\mathbf C}\bar{\mathbf x}' + \overline{\mathbf K}\bar{\mathbf x} =
/// \mathbf{p}\cos\tau - \mathbf{p}_{\mathrm i}\sin\tau - \beta\,\mathbf{w}\,\mathrm{sgn}(\mathbf{w}^T\bar{\mathbf x}') \f]
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/number/ball_matrix.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog::reference {
/// @brief Product of complex numbers.
[[nodiscard]] inline Complex<Ball> operator*(const Complex<Ball>& a, const Complex<Ball>& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/// @brief Something that could not be proved with the bits at hand; more bits may help.
struct Unproved : PrecisionError {
    /// @param why_  what is not proved @param outcome_  whether more bits may help
    explicit Unproved(Reasons why_, Outcome outcome_ = Outcome::unproved) : PrecisionError(std::move(why_), outcome_) {}
};
/// @brief A statement that is certainly not so: no number of bits will prove it.
struct Disproved : Unproved {
    /// @param why_  what is not so
    explicit Disproved(Reasons why_) : Unproved(std::move(why_), Outcome::disproved) {}
};
/// @brief The value of a computation; none where more bits may prove it and it is not a `must`. What is disproved is thrown.
template <class Compute>
[[nodiscard]] auto if_proved(const Compute& compute, bool must = false) -> std::optional<decltype(compute())> {
    try {
        return compute();
    } catch (const Unproved& e) {
        if (must || e.outcome == Outcome::disproved) throw;
        return std::nullopt;
    }
}

/// @brief The solution of \f$ Ax=b \f$; Unproved, for the reason that is told, where A may be singular.
[[nodiscard]] BallMatrix solution_of(const BallMatrix& A, const BallMatrix& b, const char* otherwise);
inline constexpr const char* mass_is_open = "the mass matrix is not proved regular";           ///< a reason of these
inline constexpr const char* stiffness_is_open = "the stiffness matrix is not proved regular"; ///< another

/// @brief The size of a complex number that may be zero.
[[nodiscard]] inline Ball size_in_balls(const Complex<Ball>& x) { return root_of_positive(squared_modulus(x)); }

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
    [[nodiscard]] const std::vector<Ball>& at_contact() const { return psi[N]; }
    /// @brief Row of the load, p^T psi_i.
    [[nodiscard]] const std::vector<Ball>& at_load() const { return psi[static_cast<std::size_t>(N) + 1]; }
    /// @brief Row of its imaginary part; null if forces are in phase.
    [[nodiscard]] const std::vector<Ball>* at_load_i() const {
        return psi.size() > static_cast<std::size_t>(N) + 2 ? &psi.back() : nullptr;
    }

    /// @brief Error of the sum of psi_ki psi_ni f_i over the modes if all modes of a cluster share one ball f: with f_i = f + e_i it is
    /// at most the largest |e_i| times the lengths of both rows in the cluster (Cauchy and Schwarz), whichever basis the shapes are.
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

/// @brief The natural modes of one system found so far, in each precision. All questions about it share them, from any thread.
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

/// @brief The modes of a scene; without damping ratios `zeta` is empty.
///
/// With a Cholesky factor L of M, (15) is the eigenvalue problem of the symmetric matrix
/// \f$ \mathbf{A} = \mathbf{L}^{-1}\mathbf{K}\mathbf{L}^{-T} \f$. Approximate eigenvectors of A, made orthonormal by a second
/// Cholesky factor, take A to \f$ \boldsymbol\Lambda + \mathbf{E} \f$, which has the same eigenvalues. With
/// \f$ \varepsilon = \|\mathbf{E}\|_F \f$ and a gap \f$ \delta \f$ about an eigenvalue, Weyl's theorem puts it within
/// \f$ \varepsilon \f$ of its entry, that of Kato and Temple within \f$ \varepsilon^2/\delta \f$, and that of Davis and Kahan its
/// vector within \f$ \sqrt2\varepsilon/\delta \f$.
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
