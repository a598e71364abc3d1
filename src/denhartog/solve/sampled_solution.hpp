/// @file
/// @brief The motion that an answer describes, sampled over its period.
#pragma once

#include "denhartog/answer/solution.hpp"

namespace denhartog {

/// @brief A motion at equally spaced instants.
struct SampledSolution {
    std::vector<double> tau;           ///< instants from the maximum of the force, 0 to below the period
    std::vector<State<double>> states; ///< displacements and velocities there
};

/// @brief Samples the motion of an answer over its period, in double.
/// @param scene     the scene that was solved
/// @param solution  its answer, the motion asked for
/// @param samples   instants in a period, at least 1
/// @return          the samples; a contact that rests is taken to rest at zero
/// @throws          PrecisionError where the closed form has not ten digits of a mass
[[nodiscard]] SampledSolution sampled_solution(const Scene<double>& scene, const Solution& solution, std::size_t samples);

} // namespace denhartog
