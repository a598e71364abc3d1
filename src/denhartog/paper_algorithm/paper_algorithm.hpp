/// @file
/// @brief The paper's numerical approach, Section 3.1 and Fig. 3: Runge-Kutta with events, from phase to phase.
///
/// A sliding phase integrates (6) with friction of one sign until \f$ \bar{x}_j' = 0 \f$; (74) with \f$ \Sigma_j \f$ of (75) then
/// decides whether the contact sticks, else it goes where the load on it pushes. A sticking phase integrates all N equations
/// with \f$ \bar{x}_j \f$ held, until \f$ \Sigma_j > \mu\beta \f$. The method is that of Dormand and Prince, fifth order with an
/// error estimate of fourth; each event is the first one of the dense output of its step, to rounding, and none is missed there.
///
/// A phase is not ended by the event that starts it. Its event function is zero then (twice so where a stop with mu = 1 ends:
/// velocity and acceleration), and the sign of what is left without these zeros tells where it goes. A load that equals static
/// friction to rounding lets go of the contact only where it grows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "denhartog/paper_algorithm/contact_equations.hpp"
#include "denhartog/sliding/regime_at_point.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief Settings of the paper's algorithm, its own as defaults.
struct PaperSettings {
    int cycles = 200;                 ///< N_cyc, periods of the force; at least 1
    double absolute_tolerance = 1e-6; ///< of every displacement and velocity; positive
    std::optional<double>
        relative_tolerance;              ///< zero or positive. Not in the paper; none is the absolute one. Matlab's own: 1e-3
    std::optional<State> start;          ///< initial state; none is rest at zero
    double tau_0 = 0;                    ///< instant of the start; the force is cos tau
    int samples = 0;                     ///< instants of the last period at which the state is wanted, equally spaced
    bool history = false;                ///< whether amplitude and stops of the contact are wanted for every period
    long most_steps = 10'000'000;        ///< steps after which the integration gives up
    long most_phases_per_cycle = 10'000; ///< phases in a period after which the contact is said to chatter
};

/// @brief End of an integration.
enum class IntegrationStatus : std::uint8_t {
    complete,   ///< the final time was reached
    chattering, ///< more phases in a period than allowed, or phases of no length without end
    step_limit, ///< more steps than allowed, or steps too small to advance the time
    overflow    ///< a displacement is no longer a finite number
};

/// @brief Motion of a mass over the last period.
struct PaperMassMotion {
    double amplitude = 0;        ///< largest |x_k|, in units of P / k_1
    std::optional<double> phase; ///< instant of the largest x_k as a lag in (-pi, pi]; none where the contact stops, or x_k rests
};

/// @brief Motion of the contact over one period.
struct ContactPeriod {
    double amplitude = 0; ///< largest |x_j|
    int stops = 0;        ///< stops that end within it
};

/// @brief The outcome of the paper's algorithm; without numbers where it is not complete.
struct PaperMotion {
    IntegrationStatus status = IntegrationStatus::complete; ///< whether the final time was reached
    std::string reason;                                     ///< why not
    std::vector<PaperMassMotion> masses;                    ///< over the last period, N
    std::optional<PaperMassMotion> between; ///< of two masses that rub against each other, the one relative to the other
    /// Stops that end within the last period. Times from its start, a maximum of the force where tau_0 is one; a stop that began
    /// before it is given one period later, so that starts are not negative where a stop is shorter than a period.
    std::vector<Stop> stops;
    bool rests = false;                 ///< the contact rests all through the last period; `stops` then has that rest alone
    bool slides = false;                ///< it rests at no time of the last period, nor in a stop that has not ended by its end
    State end;                          ///< the state at the final time
    std::vector<ContactPeriod> history; ///< of every period, where asked for
    std::vector<double> sample_times;   ///< instants asked for, from the start of the last period
    std::vector<State> samples;         ///< states at these
    long steps = 0;                     ///< steps taken
    long rejected_steps = 0;            ///< steps tried and not taken
    long right_hand_sides = 0;          ///< evaluations of (6)
    long phases = 0;                    ///< phases of sliding and sticking
};

/// @brief The regime of the last period. A stop that has not ended by then counts, though it is not yet among the stops.
/// @param motion  a complete motion
/// @return        the regime; of the steady motion only where that has been reached
[[nodiscard]] inline Regime regime_seen(const PaperMotion& motion) {
    if (motion.rests) return Regime::permanent_sticking;
    return motion.slides ? Regime::continuous : Regime::stick_slip;
}

/// @brief Checks settings. @param settings the settings @param N number of masses @throws InputError for the first rule broken
void check(const PaperSettings& settings, std::size_t N);

/// @brief Integrates (6) from a start over a number of periods as the paper does.
///
/// A step is at most pi / 4 long: while the contact of a single mass sticks no error bounds it, and over such a step the dense
/// output with the force added is a polynomial to rounding. The error of a step is weighed against the absolute tolerance plus
/// the relative one times the size of each component.
/// @eq{6,74,75}
/// @param problem   the equations, friction, contact and load
/// @param settings  tolerances, number of periods, start
/// @return          the motion, or a status with its reason
/// @throws          InputError where problem or settings break a rule
[[nodiscard]] PaperMotion paper_algorithm(const ContactProblem& problem, const PaperSettings& settings = {});

/// @brief Integration at the point of a scene.
/// @eq{6,74,75}
/// @param scene     the scene, with r and beta
/// @param settings  tolerances, number of periods, start
/// @return          the motion, or a status with its reason
/// @throws          InputError where scene or settings break a rule
[[nodiscard]] PaperMotion paper_algorithm(const Scene<double>& scene, const PaperSettings& settings = {});

} // namespace denhartog
