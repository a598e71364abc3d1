/// @file
/// @brief Proof of a motion with stops: the law of friction holds at every instant; largest displacements; Floquet multipliers.
///
/// The equations of a periodic motion say nothing of what happens between its events. A phase is cut into stretches so short that
/// the power series of the motion converge fast; on each of them interval arithmetic with the series decides the signs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "denhartog/reference/orbit_equations.hpp"

namespace denhartog::reference {

/// @brief One number over a stretch, theta from 0 to 1.
struct CurveInBalls {
    std::vector<Ball> powers{}; ///< of theta; the last one holds the rest of the series
    NumberInTime in_time{};     ///< the number by free motions instead, if the stretch is a whole phase of fast ones
    Ball length{};              ///< length of that phase
};

/// @brief A derivative of a curve, of order 0 to 2, over an interval of theta.
[[nodiscard]] Ball derivative(const CurveInBalls& c, int order, const Ball& theta);

/// @brief The curve from a to b, by Taylor's formula about the middle: where a curve only just stays positive it is
/// flat.
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
    std::vector<ExponentialSeries> stretches_{}; // in few bits
    std::shared_ptr<FastPhases> fast_{};         // instead of both, if the phase takes too many
    BallMatrix Z_{};
    Ball length_{};
};

/// @brief Phases 1 to m of a motion, at [0 .. m-1].
/// @throws Disproved, Unproved if a phase has no length
[[nodiscard]] std::vector<PhaseInStretches> in_stretches(const ProvedOrbit& orbit, slong few);

/// @brief Requires that the motion is what its phases say, (2), (3), (74), (75): the contact slides in a phase of sliding, is
/// held in a phase of sticking, and is not held where it turns.
/// @throws Disproved, Unproved
void require_friction(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases);

/// @brief A displacement that is largest in size, and its instant.
struct PeakInBalls {
    Ball size{};                 ///< the largest size
    std::optional<Ball> phase{}; ///< lag behind the force in (-pi, pi], as in `MassMotion`; empty if it never moves
};

/// @brief The largest displacement of the contact: at a place where it comes to rest or turns.
[[nodiscard]] PeakInBalls peak_of_contact(const ProvedOrbit& orbit);

/// @brief The largest displacement of a mass, as seen from the ground if the frame moves by `frame` cos tau.
[[nodiscard]] PeakInBalls peak_of_mass(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, slong k,
                                       const Ball& frame = Ball(0));

/// @brief The largest size of a number, a row over Z, whose rate may jump at events. @param orbit,phases the motion @param row the
/// row @return the size
[[nodiscard]] Ball largest_of_row(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, const BallMatrix& row);

/// @brief Deviations at the end of a stretch, as a linear function of those at its start.
///
/// A deviation at one instant is carried by exp(A h) over a phase. At an event that comes later by dt the two phases differ in
/// their rates, so that it jumps by \f$ (\mathbf A_{before} - \mathbf A_{after})\mathbf Z\,dt \f$, with dt such that what
/// ends the phase still vanishes. The product over a stretch is the map whose eigenvalues are the multipliers over the stretch.
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
///
/// Arb encloses the eigenvalues, from approximate ones: by the method of van der Hoeven and Mourrain if they are simple, else by
/// those of Miyajima and Rump. The approximate ones come from double, or, if that leaves the balls wide, from Arb. If both fail,
/// norms of powers of the matrix bound them.
[[nodiscard]] std::vector<Ball> multipliers_over_period(const MapOfDeviations& map, bool mirrored, Effort* effort = nullptr);

} // namespace denhartog::reference
