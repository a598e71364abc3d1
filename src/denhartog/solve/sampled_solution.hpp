/// @file
/// @brief The motion that an answer describes, sampled over its period.
#pragma once

#include "denhartog/answer/solution.hpp"

namespace denhartog {

/// @brief A motion at equally spaced instants.
struct SampledSolution {
    std::vector<double> tau;           ///< instants, from 0 at the maximum of the force to below the period of the motion
    std::vector<State<double>> states; ///< displacements and velocities of all masses at these instants
};

/// @brief Samples the motion of an answer over its period, in double.
/// @param scene     the scene that was solved
/// @param solution  its answer to `Asked::motion`
/// @param samples   number of instants in a period of the motion, at least 1
/// @return          the samples; a contact that never moves is taken to rest at zero
/// @throws          PrecisionError if the closed form does not give ten digits of a mass, or the phase of the contact is not
/// known
[[nodiscard]] SampledSolution sampled_solution(const Scene<double>& scene, const Solution& solution, std::size_t samples);

} // namespace denhartog
