/// @file
/// @brief The scenes on which observations and losses are measured: the paper's own and seeded asymmetric ones, all sliding.
#pragma once

#include <string>
#include <vector>

#include "denhartog/formulas/modal_coordinate.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "tests/support/sample_scenes.hpp"

namespace denhartog::derivation {

/// @brief A scene in the sliding regime with its steady state.
struct SlidingScene {
    std::string name;          ///< its name
    bool of_the_paper;         ///< whether it is one of the paper's own
    double mu;                 ///< static over kinetic friction
    System<double> system;     ///< the system
    ModalBasis<double> basis;  ///< modal basis of the system
    ModeSums<double> sums;     ///< modes at r
    Boundary<double> boundary; ///< boundary at r
    SteadyState<double> state; ///< steady state at beta
};

/// @brief The seed of the asymmetric scenes.
constexpr std::uint64_t seed_of_scenes = 2022;

/// @brief The scenes, made once.
/// @return  those of the paper's grid that slide, then the random ones at their fraction of the boundary
[[nodiscard]] const std::vector<SlidingScene>& sliding_scenes();

/// @brief The single modes of a scene as the kernels see them. @param scene a scene @param i mode @return the mode
[[nodiscard]] ModeInScene<double> mode_of(const SlidingScene& scene, std::size_t i);

/// @brief Initial values of a mode in the steady state, by (26) and (27). @param scene a scene @param i mode
/// @return  eta_0 and eta'_0
[[nodiscard]] InitialValues<double> start_of_mode(const SlidingScene& scene, std::size_t i);

/// @brief The boundary (69) with a sum S_dj of one's own. @param scene a scene @param S the sum @return the friction ratio
[[nodiscard]] double limit_with_sum(const SlidingScene& scene, double S);

/// @brief Whether every mode on its own meets (63), which is (59) with (62). As printed the sign of psi_ji counts, which is free;
///        it is taken positive here.
/// @param scene a scene @param beta friction ratio @return whether all do
[[nodiscard]] bool every_mode_meets_63(const SlidingScene& scene, double beta);

/// @brief (56) with (57) as printed. @param scene a scene
/// @return  the sum; infinite where (57) grows beyond bounds at an end of the half-period, else from 999 instants
[[nodiscard]] double printed_sum_of_maxima(const SlidingScene& scene);

} // namespace denhartog::derivation
