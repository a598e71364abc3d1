/// @file
/// @brief What friction demands of a motion at every instant, and where the masses are farthest out.
///
/// The equations of a periodic motion say nothing of what happens between its events. A phase is cut into stretches so short that
/// the power series of the motion converge fast; on each of them interval arithmetic with the series decides the signs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "denhartog/reference/orbit_newton.hpp"

namespace denhartog::reference {

/// @brief One number over a stretch, theta from 0 to 1.
struct CurveInBalls {
    std::vector<Ball> powers{}; ///< of theta; the last one holds the rest of the series
    NumberInTime in_time{};     ///< the number by free motions instead, where the stretch is a whole phase of fast ones
    Ball length{};              ///< length of that phase
};

/// @brief A derivative of a curve. @param c the curve @param order 0 to 2 @param theta where, an interval
/// @return  a ball that holds it
[[nodiscard]] Ball derivative(const CurveInBalls& c, int order, const Ball& theta);

/// @brief How a curve vanishes at the ends of a stretch.
struct EndsOfCurve {
    int order = 0;         ///< to which order it is known to vanish at 0: 0 is not at all
    bool vanishes = false; ///< whether it is known to vanish at 1
};

/// @brief Requires that a curve is positive between the ends of a stretch, and at an end where it does not vanish.
/// @param c     the curve
/// @param ends  how it is known to vanish at the ends
/// @param what  the message where it is not, or may not be
/// @throws      Disproved where it is certainly negative somewhere, Unproved where that cannot be told
void require_positive(const CurveInBalls& c, const EndsOfCurve& ends, const char* what);

/// @brief A phase in stretches of one length.
class PhaseInStretches {
public:
    /// @param orbit  the motion
    /// @param i      which phase, 1 to m
    /// @param few    bits of the curves; states have those of the moment
    PhaseInStretches(const ProvedOrbit& orbit, slong i, slong few);

    /// @brief Number of stretches. @return it
    [[nodiscard]] slong count() const { return count_; }
    /// @brief One number over a stretch. @param stretch from 0 to count - 1 @param row which number, a row over Z
    /// @return its curve
    [[nodiscard]] CurveInBalls curve(slong stretch, const BallMatrix& row) const;
    /// @brief The same in all bits of the states.
    /// @param stretch  from 0 to count - 1
    /// @param row      which number, a row over Z
    /// @param theta    where, from 0 to 1
    /// @return         the number
    [[nodiscard]] Ball number(slong stretch, const BallMatrix& row, const Ball& theta) const;
    /// @brief The state within the phase. @param part from 0 to 1, of its length @return Z
    [[nodiscard]] BallMatrix state(const Ball& part) const;

private:
    std::vector<ExponentialSeries> leaps_{}; // in all bits
    slong each_ = 1;                         // stretches a leap
    slong count_ = 1;
    std::vector<ExponentialSeries> stretches_{}; // in few bits
    std::shared_ptr<FastPhases> fast_{};         // instead of both, where the phase takes too many
    BallMatrix Z_{};
    Ball length_{};
};

/// @brief A motion in stretches; states in the bits of the moment.
/// @param orbit  the motion
/// @param few    bits of the curves
/// @return       phases 1 to m, at [0 .. m-1]
/// @throws       Disproved, Unproved where a phase has no length
[[nodiscard]] std::vector<PhaseInStretches> in_stretches(const ProvedOrbit& orbit, slong few);

/// @brief Requires that the motion is what its phases say, (2), (3), (74), (75): the contact slides in a phase of sliding, is
/// held in a phase of sticking, and is not held where it turns.
/// @param orbit   the motion
/// @param phases  the same in stretches
/// @throws        Disproved, Unproved
void require_friction(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases);

/// @brief Where a displacement is largest in size.
struct PeakInBalls {
    Ball size{};                 ///< the largest size
    std::optional<Ball> phase{}; ///< lag behind the force in (-pi, pi], as in `MassMotion`; empty where it never moves
};

/// @brief Where the displacement of the contact is largest: where it comes to rest or turns. @param orbit the motion
/// @return  the peak
[[nodiscard]] PeakInBalls peak_of_contact(const ProvedOrbit& orbit);

/// @brief Where the displacement of a mass is largest.
/// @param orbit   the motion
/// @param phases  the same in stretches
/// @param k       the mass
/// @return        the peak
[[nodiscard]] PeakInBalls peak_of_mass(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, slong k);

} // namespace denhartog::reference
