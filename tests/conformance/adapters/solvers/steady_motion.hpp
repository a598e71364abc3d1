/// @file
/// @brief The settled motion that a time integrator comes to, and what is read off its last period.
#pragma once

#include "denhartog/sliding/boundary.hpp"
#include "tests/conformance/adapters/solvers/period.hpp"

namespace denhartog::tests {

/// @brief A settled motion.
struct SteadyMotion {
    std::string why_none;      ///< why there is no motion; empty where there is one
    Stage stage;               ///< the finest setting that settled
    std::vector<double> start; ///< the state at the maximum of the force
    PeriodRecord record;       ///< the period from there, with its nodes
    Regime regime = Regime::continuous;
    std::vector<Stop> stops; ///< of the contact; one over the end of the period is whole, its start within the period
};

/// @brief Integrates period after period until the state repeats itself.
///
/// The start is rest at zero. What a period changes has to be below the tolerance times the part that the slowest sliding mode
/// loses in it, but not less than 1/100; after 200 periods ten times the tolerance will do. Light damping is shortened: from the
/// states of successive periods that to which they tend is extrapolated (reduced rank extrapolation), and the integration goes
/// on from there; what counts as settled stays the same. With mu > 1 a motion from rest is not extrapolated, as that can lead to
/// a motion with stops that is not stable.
///
/// Where the contact rests for ever the answer is for rest at zero, as `solve` has it: all masses are moved by what the contact's
/// displacement makes of them at rest, and the integration goes on. With mu > 1, where several motions may exist, sliding
/// throughout goes before, looked for from the motion without friction, then rest for ever, looked for from rest with the contact
/// held until the other masses have settled. So is rest for ever where the contact hardly moves: it may creep up to the edge of
/// where it can rest and never get there.
[[nodiscard]] SteadyMotion steady_motion(const Scene<double>& scene, const TimeIntegrator& integrator);

/// @brief Largest displacement of a mass. It counts from 0, here and below.
[[nodiscard]] double amplitude(const SteadyMotion& motion, std::size_t k, std::size_t contact);

/// @brief Instant of the largest x_k as a lag behind the force; where the contact rests there, the start of the rest. In (-pi,
/// pi]; none where x_k does not move.
[[nodiscard]] std::optional<double> phase(const SteadyMotion& motion, std::size_t k, std::size_t contact);

/// @brief x_k at equally spaced instants from the maximum of the force.
[[nodiscard]] std::vector<double> samples(const SteadyMotion& motion, std::size_t k, int samples);

} // namespace denhartog::tests
