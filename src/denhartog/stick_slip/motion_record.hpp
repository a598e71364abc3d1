/// @file
/// @brief States, phases of sliding and sticking, and stops of a motion, which the library's solvers share; how a motion comes to
/// rest; and what a proof starts from.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace denhartog {

/// @brief Displacements and velocities of all masses at an instant.
struct State {
    std::vector<double> x;       ///< displacements in units of P / k_1, N values
    std::vector<double> x_prime; ///< velocities with respect to tau, N values
};

/// @brief The state of N masses at rest at zero. @param N their number @return the state
[[nodiscard]] inline State at_rest(std::size_t N) { return {std::vector<double>(N), std::vector<double>(N)}; }

/// @brief An interval of time in which the contact slides in one direction, or sticks.
struct Phase {
    int direction; ///< sign of the contact's velocity: 1 or -1 while it slides, 0 while it sticks
    double start;  ///< tau at its start
    double end;    ///< tau at its end
};

/// @brief A stop of the contact: a sticking phase of positive length. Its numbers are doubles, certified numbers or balls.
template <class Number>
struct StopOf {
    Number start; ///< tau where the contact comes to rest, measured from the maximum of the force
    Number end;   ///< tau where it breaks away again
    Number x;     ///< the displacement at which it rests, in units of P / k_1
};

/// @brief A stop as double has it, without a bound.
using Stop = StopOf<double>;

/// @brief Where the velocity of the contact is zero at the end of a half-cycle of a motion without a load.
template <class Number>
struct TurnOf {
    Number tau; ///< the instant, counted from the start; radians
    Number x;   ///< displacement of the contact, in units of P / k_1
};

/// @brief The way of a motion without a load to rest. Every number is proved.
template <class Number>
struct FreeDecayOf {
    bool at_rest = false;              ///< whether the contact rests for good; if not, `rest_from` to `on_limit` say nothing
    std::vector<TurnOf<Number>> turns; ///< ends of the half-cycles, in order; at the last one the contact rests for good
    std::vector<StopOf<Number>> stops; ///< stops before that, in order; tau counts from the start
    Number rest_from;                  ///< tau from which the contact rests for good
    Number rest_at;                    ///< displacement of the contact at rest, in units of P / k_1
    std::vector<Number> masses;        ///< places of rest of all masses with the contact there, in units of P / k_1
    /// True where the other masses come to rest at these places, since every free motion of theirs is damped; false where nothing
    /// damps them, and they move about the places for ever; empty where neither is proved, or there are no other masses.
    std::optional<bool> others_come_to_rest;
    /// True where the springs pull on the resting contact with static friction, to some hundred digits. If the two are equal, (74)
    /// lets it stick, as this says.
    bool on_limit = false;
};

/// @brief The displacement of a mass at the instant at which |x_k| is largest.
struct Extremum {
    double x;          ///< the displacement, with its sign
    double instant;    ///< tau there; if the mass rests, the start of the rest
    double unsure = 0; ///< how much larger a displacement may be, if the effort did not suffice to exclude it; otherwise 0
    double spread = 0; ///< distance in phase to another instant at which |x_k| may be as large; 0 if there is none
};

/// @brief Amplitude and phase of a mass in the steady motion.
struct MassMotion {
    double amplitude; ///< largest |x_k| over the motion, in units of P / k_1
    /// tau of the extremum as a lag behind the force in (-pi, pi]; if x_k is negative there, half a period is added
    double phase;
    double spread = 0; ///< distance in phase to another instant at which |x_k| may be as large; 0 if there is none
};

/// @brief A periodic motion with stops as double precision sees it. Nothing in it is certain; a proof needs it to be near.
///
/// It covers one stretch: the period of the motion, or half of it if the other half is its mirror image, Eq. (25). Event 0 is
/// the first of the stretch; event m, a stretch later, is event 0 again.
struct OrbitGuess {
    /// m + 1 values: direction of the contact in the phase before event 0, then in the phases that end at events 1 to m. It is
    /// 1 or -1 while the contact slides, 0 while it sticks.
    std::vector<int> directions{};
    bool mirrored = false;         ///< whether the stretch is half of the period, and the other half its mirror image
    int periods = 1;               ///< period of the motion, in periods of the force
    std::vector<double> x{};       ///< displacements of the masses at event 0, units of P / k_1
    std::vector<double> x_prime{}; ///< their velocities there, with respect to tau
    std::vector<double> events{};  ///< tau of events 0 to m - 1, from a maximum of the force, ascending
    /// Instants at which the contact slides so slowly that it may in truth come to rest there, without turning; ascending
    std::vector<double> slow{};
};

} // namespace denhartog
