/// @file
/// @brief The motion that an answer describes, sampled over its period.
#pragma once

#include <memory>

#include "denhartog/answer/solution.hpp"

namespace denhartog {

struct SceneReader;

/// @brief The error of a sample, of the amplitude of its mass, beside the error of that amplitude.
constexpr double error_of_samples = 1e-6;

/// @brief A motion at equally spaced instants.
struct SampledSolution {
    std::vector<double> tau;     ///< instants, from 0 at the maximum of the force to below the period of the motion
    std::vector<double> x;       ///< displacements of all masses at the first instant, then at the next, in units of P / k_1
    std::vector<double> x_prime; ///< velocities with respect to tau, in the same order

    /// @brief No motion.
    SampledSolution() = default;
    /// @brief Masses at rest. @param samples number of instants @param periods of the force @param N number of masses
    SampledSolution(std::size_t samples, int periods, std::size_t N);
    /// @brief States at instants. @param instants the instants @param states the state at each
    SampledSolution(std::vector<double> instants, const std::vector<State>& states);
    /// @brief The state at an instant. @param n its place in `tau` @return displacements and velocities of all masses
    [[nodiscard]] State at(std::size_t n) const;
    /// @brief The states at all instants. @return one for each
    [[nodiscard]] std::vector<State> states() const;
};

/// @brief Samples the motion of an answer over its period.
///
/// A displacement is good to `error_of_samples`. If the answer is proved, so is that: the reference then gives the samples, as it
/// does where double fails. A motion with stops is followed in double from its start, and has to come back to it with the stops of
/// the answer.
/// @param source    the scene that was solved, a `SceneSource`
/// @param solution  its answer to `Asked::motion`
/// @param samples   number of instants in a period of the motion, at least 1
/// @return          the samples; a contact that never moves is taken to rest at zero
/// @throws          PrecisionError if the samples do not have these digits
[[nodiscard]] SampledSolution sampled_solution(const std::shared_ptr<const SceneReader>& source, const Solution& solution,
                                               std::size_t samples);

/// @brief The energies that the motion of an answer dissipates, and the forces that it hands to wall and base; the reference
/// proves them in every regime.
/// @param source    the scene that was solved
/// @param solution  its answer to `Asked::motion` of all masses
/// @param digits    significant digits; by default 6
/// @return          energies and forces
/// @throws          PrecisionError if they cannot be proved, or the library was built without the reference; InputError if the
///                  answer is to another question
[[nodiscard]] Energies energies(const std::shared_ptr<const SceneReader>& source, const Solution& solution,
                                std::optional<int> digits = std::nullopt);

} // namespace denhartog
