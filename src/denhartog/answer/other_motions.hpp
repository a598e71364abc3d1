/// @file
/// @brief Steady motions of one scene from many starts: seeded ones, and orbits met on sweeps in r and beta.
///
/// With mu > 1 the motion depends on the start. What is listed was found; what was not found may still exist. The starts are the
/// same in every run.
#pragma once

#include <memory>

#include "denhartog/answer/solution.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {

/// @brief Distinct steady motions, the one from rest first; none where no start leads to one.
///
/// Starts: rest; the sliding motion of the closed form, and larger and smaller ones; the contact displaced to either side; random
/// states in the size of the motion without friction; the orbits of neighbouring r and beta, from both sides. Unstable orbits are
/// those that Newton's method finds from the same starts. Where the motion is known to be unique the start from rest alone is
/// followed.
[[nodiscard]] std::vector<OtherMotion> other_motions(const Scene<double>& scene, const ContactSystem<double>& system,
                                                     const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis);

} // namespace denhartog
