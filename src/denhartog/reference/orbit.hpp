/// @file
/// @brief A steady motion with stops, every number of it proved.
///
/// A guess from double precision says in which order the contact slides and sticks. A periodic motion of that order is a system of
/// equations. Its unknowns are the state at event 0 and the instants of events 0 to m - 1; its equations say that the state comes
/// back after the stretch, mirrored or not, and that the quantity that ends a phase is zero at the event at its end. Newton's
/// method and Krawczyk's operator prove that there is one solution near the guess. What happens between the events is another
/// matter: a phase is cut into stretches so short that the power series of the motion converge fast, and on each of them interval
/// arithmetic decides the signs that (2), (3) and (74) demand. The same series bound the largest displacements.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "denhartog/reference/phases.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog::reference {

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

/// @brief Terms of \f$ \mathrm e^{\mathbf B\theta}\mathbf y = \sum_k \mathbf y_k\theta^k/k! \f$, from
/// \f$ \mathbf y_k = \mathbf B\mathbf y_{k-1} \f$, for theta in [0, 1].
class ExponentialSeries {
public:
    /// @brief Zeros of the matrix cost nothing. The terms are paid from `effort`.
    ExponentialSeries(const BallMatrix& B, const BallMatrix& y, Effort* effort = nullptr);

    /// @brief Factors of the powers of theta in one number of the sum, given as a row. The last one has a ball that holds the rest
    /// of the series, and whose derivatives by theta, up to the second, hold those of the rest.
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

/// @brief The state at the end of a phase. `leap` encloses exp(A length / leaps) and carries what the state is uncertain by;
/// `series`, if wanted, gets the motion over each leap.
[[nodiscard]] BallMatrix followed(const BallMatrix& A, const BallMatrix& Z, const Ball& length, slong leaps,
                                  const BallMatrix& leap, Effort* effort, std::vector<ExponentialSeries>* series = nullptr);

/// @brief A matrix whose entries are off by no more than a part of the largest of their column.
[[nodiscard]] BallMatrix with_width(BallMatrix E, double part);

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

/// @brief Proves that the equations have one solution near a guess. Fewer bits are certain than it computes with, as a leap may
/// widen a ball by exp(longest_leap).
/// @throws Disproved, Unproved
[[nodiscard]] ProvedOrbit proved_near(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits);

/// @brief One number over a stretch, theta from 0 to 1.
struct CurveInBalls {
    std::vector<Ball> powers{}; ///< of theta; the last one holds the rest of the series
    NumberInTime in_time{};     ///< the number by free motions instead, if the stretch is a whole phase of fast ones
    Ball length{};              ///< length of that phase
};

/// @brief A derivative of a curve, of order 0 to 2, over an interval of theta.
[[nodiscard]] Ball derivative(const CurveInBalls& c, int order, const Ball& theta);

/// @brief That derivative from a to b, by Taylor's formula about the middle: where a curve only just stays positive it is flat.
[[nodiscard]] Ball derivative_over(const CurveInBalls& c, int order, double a, double b);

/// @brief Orders to which a curve vanishes at the ends of a stretch.
struct EndsOfCurve {
    int order = 0;         ///< to which order it is known to vanish at 0: 0 is not at all
    bool vanishes = false; ///< whether it is known to vanish at 1
};

/// @brief Requires that a curve is positive between the ends of a stretch, and at an end where it does not vanish.
/// @throws Disproved if it is certainly negative somewhere, Unproved if that is not decided
void require_positive(const CurveInBalls& c, const EndsOfCurve& ends, const char* what);

/// @brief A phase in stretches of one length.
class PhaseInStretches {
public:
    /// @brief Phase i, 1 to m. Its curves have few bits, its states the current number.
    PhaseInStretches(const ProvedOrbit& orbit, slong i, slong few);

    /// @brief Number of stretches.
    [[nodiscard]] slong count() const { return count_; }
    /// @brief A number, a row over Z, over a stretch from 0 to count - 1.
    [[nodiscard]] CurveInBalls curve(slong stretch, const BallMatrix& row) const;
    /// @brief The number at theta, in all bits of the states.
    [[nodiscard]] Ball number(slong stretch, const BallMatrix& row, const Ball& theta) const;
    /// @brief The state Z at a part of the phase, from 0 to 1.
    [[nodiscard]] BallMatrix state(const Ball& part) const;

private:
    std::vector<ExponentialSeries> leaps_{}; // in all bits
    slong each_ = 1;                         // stretches a leap
    slong count_ = 1;
    std::vector<ExponentialSeries> stretches_{};  // in few bits
    std::shared_ptr<PhasesByFreeMotions> fast_{}; // instead of both, if the phase takes too many
    BallMatrix Z_{};
    Ball length_{};
};

/// @brief Phases 1 to m of a motion, at [0 .. m-1].
/// @throws Disproved, Unproved if a phase has no length
[[nodiscard]] std::vector<PhaseInStretches> in_stretches(const ProvedOrbit& orbit, slong few);

/// @brief Requires that the motion is what its phases say: the contact slides in a phase of sliding, is held in a phase of sticking,
/// and is not held where it turns.
/// @eq{2,3,74,75}
/// @throws Disproved, Unproved
void require_friction(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases);

/// @brief A displacement that is largest in size, and its instant.
struct PeakInBalls {
    Ball size{};                 ///< the largest size; units of P / k_1
    std::optional<Ball> phase{}; ///< lag behind the force in (-pi, pi], as in `MassMotion`; empty if no force ever moves it
};

/// @brief The largest displacement of the contact: at a place where it comes to rest or turns.
[[nodiscard]] PeakInBalls peak_of_contact(const ProvedOrbit& orbit);

/// @brief The largest displacement of a mass, as seen from the ground if the frame moves by `frame` cos tau.
[[nodiscard]] PeakInBalls peak_of_mass(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, slong k,
                                       const Ball& frame = Ball(0));

/// @brief The largest size of a number, a row over Z, whose rate may jump at events.
[[nodiscard]] Ball largest_of_row(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, const BallMatrix& row);

/// @brief Deviations at the end of a stretch, as a linear function of those at its start: its eigenvalues are the multipliers over the
/// stretch.
///
/// A deviation at one instant is carried by exp(A h) over a phase. At an event that comes later by dt the two phases differ in
/// their rates, so that it jumps by \f$ (\mathbf A_{before} - \mathbf A_{after})\mathbf Z\,dt \f$, with dt such that what
/// ends the phase still vanishes.
struct MapOfDeviations {
    /// It starts and ends within a stop if there is one: there a deviation does not move the contact and has 2N - 1 numbers
    /// only. Else it has 2N.
    BallMatrix A{};
    bool from_a_stop = false; ///< whether it starts within a stop; a further multiplier is then zero
};

/// @brief The map of deviations of a motion, from what its phases make of them in a box next to it.
/// @throws Unproved if an event may be tangential
[[nodiscard]] MapOfDeviations map_of_deviations(const ProvedOrbit& orbit, const Linearised& along);

/// @brief Whether all deviations certainly die out: a power of the map has a norm below 1.
[[nodiscard]] bool dies_out(const BallMatrix& map, Effort* effort = nullptr);

/// @brief Whether the sizes of multipliers are known so well that more bits need not be tried.
[[nodiscard]] bool are_narrow(const std::vector<Ball>& sizes);

/// @brief Sizes of the 2N multipliers over the whole period, descending; wide if the eigenvectors hardly differ.
[[nodiscard]] std::vector<Ball> multipliers_over_period(const MapOfDeviations& map, bool mirrored, Effort* effort = nullptr);

/// @brief A motion that obeys its equations and all that friction demands.
struct OrbitInPhases {
    ProvedOrbit orbit;                      ///< the motion
    std::vector<PhaseInStretches> phases{}; ///< phases 1 to m, at [0 .. m-1]

    /// @brief The state at an instant, as `harmonic_in_balls` has it. tau counts from a maximum of the force, and may be a ball.
    /// @throws Unproved if the ball is too wide
    [[nodiscard]] BallMatrix at(const Ball& tau) const;
};

/// @brief Proves that there is a periodic motion near a guess, and that friction allows it. Compute with as many bits whatever you
/// derive from it.
/// @throws Disproved, Unproved as `proved_orbit`
[[nodiscard]] OrbitInPhases orbit_in_phases(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits);

/// @brief A periodic motion with stops, or with turns without a stop, proved.
struct OrbitInBalls {
    bool mirrored = false;                  ///< whether it mirrors itself after half its period, Eq. (25)
    int periods = 1;                        ///< its period in periods of the force
    std::vector<PeakInBalls> masses{};      ///< N + 1 values: the masses, then the contact; zero where one was not asked for
    std::vector<PeakInBalls> from_ground{}; ///< N values, of the masses as they are seen from the ground; empty if not asked for
    std::vector<StopOf<Ball>> stops{};      ///< within the period, starts ascending in [0, 2 pi periods)
    std::vector<Ball> x{};                  ///< displacements of the masses at tau = 0, where the force is largest
    std::vector<Ball> x_prime{};            ///< their velocities there
    bool stable = false;                    ///< proved: every deviation from it dies out
    bool unstable = false;                  ///< proved: a multiplier is outside the unit circle
    /// 2N values: sizes of the Floquet multipliers over the period, descending; empty if they were not asked for. A multiplier
    /// that a stop makes zero is exactly zero.
    std::vector<Ball> multipliers{};
};

/// @brief Proves that there is a periodic motion near a guess, and bounds its numbers. No `masses` are all; the contact's amplitude
/// is always given. `frame` is by how much the frame of the displacements moves, if the masses are wanted as they are seen from the
/// ground.
/// @throws Disproved        if the motion near the guess is certainly not what the guess says
/// @throws Unproved         if more bits, or another guess, may help
/// @throws PrecisionError   if the work allowed is spent, see `SceneInBalls::effort`
[[nodiscard]] OrbitInBalls proved_orbit(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits,
                                        const std::vector<std::size_t>& masses = {}, bool with_multipliers = true,
                                        const std::optional<Ball>& frame = std::nullopt);

} // namespace denhartog::reference
