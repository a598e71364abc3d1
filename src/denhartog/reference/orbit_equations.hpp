/// @file
/// @brief A periodic motion with stops as a system of equations, and their derivatives.
///
/// The state \f$ \mathbf Z = (\bar{\mathbf x}, \bar{\mathbf x}'/\sigma, \cos\tau, \sin\tau, 1) \f$ obeys
/// \f$ \mathbf Z' = \mathbf A\mathbf Z \f$ in every phase: one matrix for sliding forward, one for sliding back and one for
/// sticking are all there is of the mechanics. The unit \f$ \sigma \f$ brings the entries of \f$ \mathbf A \f$ to one size.
/// The unknowns are the state at event 0 and the instants of events 0 to m - 1. The equations say that the state comes back after
/// the stretch, mirrored or not, and that the quantity that ends a phase is zero at the event at its end.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "denhartog/reference/fast_phase.hpp"
#include "denhartog/reference/orbit_guess_data.hpp"
#include "denhartog/reference/scene_in_balls.hpp"
#include "denhartog/reference/sliding_phase.hpp"

namespace denhartog::reference {

/// @brief The mechanics of a scene with one contact, phase by phase.
/// @eq{6}
struct ContactMechanics {
    /// @brief Of a scene.
    explicit ContactMechanics(const SceneInBalls& scene);

    slong N;          ///< number of masses
    Ball sigma{};     ///< unit of the velocities in Z
    BallMatrix w;     ///< w^T x is the displacement of the contact, N x 1
    BallMatrix free;  ///< A without friction, n x n
    BallMatrix load;  ///< minus the sum in (75): all forces on a contact at rest but friction, as a row over Z
    BallMatrix stuck; ///< A while the contact sticks
    BallMatrix push;  ///< what a unit force on the contact adds to x'' / sigma, N x 1
    Ball beta{};      ///< friction while the contact slides
    Ball holds{};     ///< friction up to which it sticks, mu beta
    bool equal;       ///< mu = 1
    bool on_a_wall;   ///< whether the contact is of one mass, on a wall: its row vanishes while it sticks, to the last bit
    slong lead;       ///< the mass on which w is largest
    std::optional<SlidingPhases> sliding{}; ///< phases of sliding by modes, where these move by themselves
    Effort* effort;                         ///< that of the scene
    slong bits = ball_bits;                 ///< bits of the scene
    mutable std::optional<std::shared_ptr<FastPhases>> fast[3] = {}; ///< phases by their free motions, sought when first needed

    /// @brief The length of a state, 2 N + 3.
    [[nodiscard]] slong n() const { return 2 * N + 3; }
    /// @brief The matrix A of a phase: direction 1 or -1 while the contact slides, against a constant friction, 0 while it sticks.
    [[nodiscard]] BallMatrix phase(int direction) const;
    /// @brief The matrix that takes any state through a part of a phase, \f$ \mathrm e^{\mathbf A h} \f$.
    [[nodiscard]] BallMatrix propagator(int direction, const Ball& h) const;
    /// @brief Phases of a kind by their free motions; null if these are not proved distinct, or the force may excite one without
    /// damping.
    [[nodiscard]] const std::shared_ptr<FastPhases>& by_free_motions(int direction) const;
    /// @brief The displacement of the contact, \f$ \mathbf w^T\bar{\mathbf x} \f$, as a row over Z.
    [[nodiscard]] BallMatrix place() const;
    /// @brief The velocity of the contact, \f$ \mathbf w^T\bar{\mathbf x}'/\sigma \f$, as a row over Z.
    [[nodiscard]] BallMatrix speed() const;
    /// @brief The zero at the end of a phase: the velocity of a contact that slides, or the load on a contact that sticks less
    /// static friction, (74); as a row over Z. The directions are those of the phases before and after.
    [[nodiscard]] BallMatrix ending(int before, int after) const;
};

/// @brief A matrix whose entries are off by no more than a part of the largest of their column.
[[nodiscard]] BallMatrix with_width(BallMatrix E, double part);

/// @brief Places of the unknowns, and the order of the phases.
struct OrbitUnknowns {
    std::vector<int> directions{}; ///< as in `OrbitGuess`
    bool mirrored = false;         ///< as in `OrbitGuess`
    int periods = 1;               ///< as in `OrbitGuess`
    BallMatrix u{};                ///< x, x'/sigma at event 0, then the instants of events 0 to m - 1

    /// @brief Number of phases in the stretch.
    [[nodiscard]] slong m() const { return static_cast<slong>(directions.size()) - 1; }
    /// @brief Number of displacements and velocities.
    [[nodiscard]] slong states() const { return u.rows() - m(); }
    /// @brief Sign that the stretch gives to a state: -1 if it mirrors it.
    [[nodiscard]] int sign() const { return mirrored ? -1 : 1; }
    /// @brief Direction in the phase before event i; that of m + 1 is after event m.
    [[nodiscard]] int direction(slong i) const;
    /// @brief The length of the stretch after which all repeats, mirrored or not.
    [[nodiscard]] Ball T() const;
    /// @brief Instant of event i, 0 to m.
    [[nodiscard]] Ball instant(slong i) const;
    /// @brief Length of phase i, 1 to m: from event i - 1 to event i.
    [[nodiscard]] Ball length(slong i) const { return instant(i) - instant(i - 1); }
    /// @brief The state at event 0.
    [[nodiscard]] BallMatrix start() const;
};

/// @brief The unknowns where a guess puts them, exact.
/// @throws Disproved if no contact has such an order of phases
[[nodiscard]] OrbitUnknowns unknowns_of(const ContactMechanics& s, const OrbitGuess& guess);

/// @brief Terms of \f$ \mathrm e^{\mathbf B\theta}\mathbf y = \sum_k \mathbf y_k\theta^k/k! \f$, from
/// \f$ \mathbf y_k = \mathbf B\mathbf y_{k-1} \f$, for theta in [0, 1].
class ExponentialSeries {
public:
    /// @brief Zeros of the matrix cost nothing. The terms are paid from `effort`.
    ExponentialSeries(const BallMatrix& B, const BallMatrix& y, Effort* effort = nullptr);

    /// @brief Factors of the powers of theta in one number of the sum, given as a row. The last one has a ball that holds the rest
    /// of the series, and whose derivatives by theta, up to the second, hold those of the rest
    [[nodiscard]] std::vector<Ball> powers(const BallMatrix& row) const;
    /// @brief The sum, exp(B theta) y.
    [[nodiscard]] BallMatrix at(const Ball& theta) const;
    /// @brief One number of the sum, given as a row.
    [[nodiscard]] Ball at(const BallMatrix& row, const Ball& theta) const;
    /// @brief Makes every sum uncertain.
    void widen(const Ball& radius);

private:
    [[nodiscard]] BallMatrix powers_of(const Ball& theta) const; // 1, theta, theta^2 / 2 and so on, as a row

    BallMatrix terms_{};           // y_k in column k
    BallMatrix over_factorials_{}; // 1 / k! in column k
};

/// @brief The norm of A times a length up to which a series is summed at one go: it may widen a ball by the exponential of it.
inline constexpr double longest_leap = 16;

/// @brief Leaps of all phases beyond which these are not followed by series, but by their free motions, if these are known.
inline constexpr slong many_leaps = 24;
/// @brief Leaps of all phases beyond which series are too many.
inline constexpr slong most_leaps = 4096;

/// @brief The phases linearised over all unknowns of a box.
struct Linearised {
    std::vector<Ball> lengths{};    ///< lengths of phases 1 to m in the middle of the box, at [0 .. m-1]
    std::vector<BallMatrix> E{};    ///< exp(A length) of these lengths
    std::vector<BallMatrix> leap{}; ///< exp(A length / leaps) over the box
    std::vector<slong> leaps{};     ///< leaps in which each is followed
    bool fast = false;              ///< whether they are followed by their free motions instead
    std::vector<BallMatrix> D{};    ///< dZ/du at events 0 to m
    BallMatrix J{};                 ///< dF/du
};

/// @brief Linearises along all motions of a box, in the current bits: balls that hold the derivatives at every point of it.
[[nodiscard]] Linearised linearised(const ContactMechanics& s, const OrbitUnknowns& box);

/// @brief The state at the end of a phase. `leap` encloses exp(A length / leaps); `series`, if wanted, gets the motion over each.
///
/// The series carries the midpoint of a state. The matrix carries what the state is uncertain by, and widens it the least.
[[nodiscard]] BallMatrix followed(const BallMatrix& A, const BallMatrix& Z, const Ball& length, slong leaps,
                                  const BallMatrix& leap, Effort* effort, std::vector<ExponentialSeries>* series = nullptr);

/// @brief The binary logarithm of a positive number, to a few units in its last place.
[[nodiscard]] double binary_logarithm(double x);

/// @brief Cost of products of balls in the current bits, as `Effort` counts.
[[nodiscard]] long cost_of_ball_products(double products);

/// @brief A motion that is proved to obey the equations; whether it obeys the inequalities of friction is another matter.
struct ProvedOrbit {
    ContactMechanics s;          ///< the mechanics
    OrbitUnknowns at;            ///< the unknowns: the box holds one solution
    std::vector<BallMatrix> Z{}; ///< states at events 0 to m
    Linearised along{};          ///< what the phases make of deviations, in few bits, over a larger box
};

/// @brief A box around u, from u, with the only solution of F = 0 next to it; none if that is not proved.
///
/// With an approximate inverse \f$ \mathbf Y \f$ of the derivative J, Krawczyk's operator of a box U about u,
/// \f[ \mathbf u - \mathbf Y\mathbf F(\mathbf u) + (\mathbf 1 - \mathbf Y\mathbf J(U))(U - \mathbf u) \f]
/// holds every solution in U; if it is inside of U there is exactly one. `step` is Y F(u), `open` is 1 - Y J over `box`.
[[nodiscard]] std::optional<BallMatrix> solution_from(const BallMatrix& u, const BallMatrix& step, const BallMatrix& open,
                                                      const BallMatrix& box);

/// @brief Proves that the equations have one solution near a guess.
///
/// Newton's method brings u near, with steps made shorter until they bring it nearer; `solution_from` is the proof.
/// A product over many phases widens balls, so that J takes as many bits as it needs. Fewer bits are certain than it computes
/// with, as a leap may widen a ball by exp(longest_leap).
/// @throws Disproved, Unproved
[[nodiscard]] ProvedOrbit proved_near(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits);

} // namespace denhartog::reference
