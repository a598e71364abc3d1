/// @file
/// @brief A periodic motion with stops as a system of equations, and their derivatives.
///
/// The state \f$ \mathbf Z = (\bar{\mathbf x}, \bar{\mathbf x}'/\sigma, \cos\tau, \sin\tau, 1) \f$ obeys
/// \f$ \mathbf Z' = \mathbf A\mathbf Z \f$ in every phase: one matrix for sliding forward, one for sliding back and one for
/// sticking are all there is of the mechanics. The power of two \f$ \sigma \f$ brings the entries of \f$ \mathbf A \f$ to one
/// size. The unknowns are the state at event 0 and the instants of events 0 to m - 1. The equations say that the state comes back
/// after the stretch, mirrored or not, and that the quantity that ends a phase is zero at the event at its end.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "denhartog/reference/fast_phase.hpp"
#include "denhartog/reference/orbit_guess_data.hpp"
#include "denhartog/reference/scene_in_balls.hpp"

namespace denhartog::reference {

/// @brief The mechanics of a scene with one contact, phase by phase.
/// @eq{6}
struct ContactMechanics {
    /// @param scene  the scene, with C and beta
    explicit ContactMechanics(const SceneInBalls& scene);

    slong N;                ///< number of masses
    Ball sigma{};           ///< unit of the velocities in Z, a power of two
    BallMatrix w;           ///< w^T x is the displacement of the contact, N x 1
    BallMatrix free;        ///< A without friction, n x n
    BallMatrix load;        ///< minus the sum in (75): all forces on a contact at rest but friction, as a row over Z
    BallMatrix stuck;       ///< A while the contact sticks
    BallMatrix push;        ///< what a unit force on the contact adds to x'' / sigma, N x 1
    Ball beta{};            ///< friction while the contact slides
    Ball holds{};           ///< friction up to which it sticks, mu beta
    bool equal;             ///< mu = 1
    bool on_a_wall;         ///< whether w is a unit vector: the contact is of one mass, on a wall
    slong lead;             ///< the mass on which w is largest
    slong bits = ball_bits; ///< bits of the scene
    mutable std::optional<std::shared_ptr<FastPhases>> fast[3] = {}; ///< phases by their free motions, sought when first needed

    /// @brief Length of a state. @return 2 N + 3
    [[nodiscard]] slong n() const { return 2 * N + 3; }
    /// @brief The matrix of a phase.
    /// @param direction  1 or -1 while the contact slides: friction is a constant force against it; 0 while it sticks
    /// @return           A
    [[nodiscard]] BallMatrix phase(int direction) const;
    /// @brief A phase by its free motions. @param direction as in `phase`
    /// @return  all phases of the kind; null where the free motions are not told apart, or the force may excite one without damping
    [[nodiscard]] const std::shared_ptr<FastPhases>& by_free_motions(int direction) const;
    /// @brief The velocity of the contact, \f$ \mathbf w^T\bar{\mathbf x}'/\sigma \f$. @return it as a row over Z
    [[nodiscard]] BallMatrix speed() const;
    /// @brief What is zero where a phase ends: the velocity of a contact that slides, or the load on a contact that sticks less
    /// static friction, (74).
    /// @param before  direction in the phase that ends
    /// @param after   direction in the one that begins
    /// @return        it as a row over Z
    [[nodiscard]] BallMatrix ending(int before, int after) const;
};

/// @brief A matrix in the bits of the moment. @param A a matrix @return it, rounded
[[nodiscard]] BallMatrix rounded(const BallMatrix& A);

/// @brief A matrix made uncertain. @param E the matrix @param part by which part of the largest entry of a column each of its
/// entries may be off
/// @return  the matrix
[[nodiscard]] BallMatrix with_width(BallMatrix E, double part);

/// @brief Where the unknowns are, and the order of the phases.
struct OrbitUnknowns {
    std::vector<int> directions{}; ///< as in `OrbitGuess`
    bool mirrored = false;         ///< as in `OrbitGuess`
    int periods = 1;               ///< as in `OrbitGuess`
    BallMatrix u{};                ///< x, x'/sigma at event 0, then the instants of events 0 to m - 1

    /// @brief Number of phases in the stretch. @return m
    [[nodiscard]] slong m() const { return static_cast<slong>(directions.size()) - 1; }
    /// @brief Number of displacements and velocities. @return 2 N
    [[nodiscard]] slong states() const { return u.rows() - m(); }
    /// @brief What the stretch does to a state. @return -1 where it mirrors it, else 1
    [[nodiscard]] int sign() const { return mirrored ? -1 : 1; }
    /// @brief Direction in a phase. @param i 0 before event 0, i before event i, m + 1 after event m
    /// @return 1, -1 or 0
    [[nodiscard]] int direction(slong i) const;
    /// @brief Length of the stretch. @return T
    [[nodiscard]] Ball T() const;
    /// @brief Instant of an event. @param i 0 to m @return tau
    [[nodiscard]] Ball instant(slong i) const;
    /// @brief Length of a phase. @param i 1 to m @return what passes from event i - 1 to event i
    [[nodiscard]] Ball length(slong i) const { return instant(i) - instant(i - 1); }
    /// @brief The state at event 0. @return Z
    [[nodiscard]] BallMatrix start() const;
};

/// @brief The unknowns where a guess puts them.
/// @param s      the mechanics
/// @param guess  the guess
/// @return       the unknowns, exact
/// @throws       Disproved where no contact has such an order of phases
[[nodiscard]] OrbitUnknowns unknowns_of(const ContactMechanics& s, const OrbitGuess& guess);

/// @brief Terms of \f$ \mathrm e^{\mathbf B\theta}\mathbf y = \sum_k \mathbf y_k\theta^k \f$, from
/// \f$ \mathbf y_k = \mathbf B\mathbf y_{k-1}/k \f$, for theta in [0, 1].
class ExponentialSeries {
public:
    /// @param B  a square matrix; its zeros cost nothing
    /// @param y  a column
    ExponentialSeries(const BallMatrix& B, const BallMatrix& y);

    /// @brief The terms. @return y_k in column k. The last one has a ball that holds the rest of the series, and whose
    /// derivatives by theta, up to the second, hold those of the rest
    [[nodiscard]] const BallMatrix& terms() const { return terms_; }
    /// @brief The sum. @param theta from 0 to 1 @return exp(B theta) y
    [[nodiscard]] BallMatrix at(const Ball& theta) const;
    /// @brief One number of the sum. @param row which, a row @param theta from 0 to 1 @return it times exp(B theta) y
    [[nodiscard]] Ball at(const BallMatrix& row, const Ball& theta) const;
    /// @brief Makes every sum uncertain. @param radius by how much
    void widen(const Ball& radius);

private:
    BallMatrix terms_{};
};

/// @brief The norm of A times a length up to which a series is summed at one go: it may widen a ball by the exponential of it.
inline constexpr double longest_leap = 18;

/// @brief Leaps of all phases beyond which these are not followed by series, but by their free motions, if these are known.
inline constexpr slong many_leaps = 24;
/// @brief Leaps of all phases beyond which series are too many.
inline constexpr slong most_leaps = 4096;

/// @brief Number of leaps in which a phase is followed.
/// @param norm  that of A times the length of the phase
/// @return      the number
[[nodiscard]] slong leaps_for(double norm);

/// @brief What the phases make of deviations, over all unknowns of a box.
struct Linearised {
    std::vector<Ball> lengths{};    ///< lengths of phases 1 to m in the middle of the box, at [0 .. m-1]
    std::vector<BallMatrix> E{};    ///< exp(A length) of these lengths
    std::vector<BallMatrix> leap{}; ///< exp(A length / leaps) over the box
    std::vector<slong> leaps{};     ///< leaps in which each is followed
    bool fast = false;              ///< whether they are followed by their free motions instead
    std::vector<BallMatrix> D{};    ///< dZ/du at events 0 to m
    BallMatrix J{};                 ///< dF/du
};

/// @brief Linearises along all motions of a box, in the bits of the moment.
/// @param s    the mechanics
/// @param box  the unknowns, as balls
/// @return     balls that hold the derivatives at every point of the box
[[nodiscard]] Linearised linearised(const ContactMechanics& s, const OrbitUnknowns& box);

/// @brief A phase followed from its start.
///
/// The series carries the midpoint of a state. The matrix carries what the state is uncertain by, and widens it the least.
/// @param A       matrix of the phase
/// @param Z       state at its start
/// @param length  its length
/// @param leaps   in how many leaps
/// @param leap    encloses exp(A length / leaps)
/// @param series  gets the motion over each leap; null where it is not wanted
/// @return        the state at the end
[[nodiscard]] BallMatrix followed(const BallMatrix& A, const BallMatrix& Z, const Ball& length, slong leaps,
                                  const BallMatrix& leap, std::vector<ExponentialSeries>* series = nullptr);

/// @brief The binary logarithm. @param x positive @return it, to a few units in its last place
[[nodiscard]] double binary_logarithm(double x);

/// @brief What products of balls cost, in the bits of the moment.
/// @param products  how many
/// @return          operations, as `Effort` counts them
[[nodiscard]] long cost_of_ball_products(double products);

} // namespace denhartog::reference
