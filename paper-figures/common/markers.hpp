/// @file
/// @brief The paper's numerical markers: its algorithm over a grid of frequency and friction ratios, on all cores.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "figure.hpp"

namespace denhartog::figures {

/// @brief What the paper's algorithm finds at a point.
struct Marker {
    double r;           ///< frequency ratio
    double beta;        ///< friction ratio
    PaperMotion motion; ///< its last period
};

/// @brief Runs the paper's algorithm, by default as the paper does: 200 periods from rest, absolute tolerance 1e-6.
/// @param figure    is told how far the work is
/// @param system    the system
/// @param mu        static over kinetic friction
/// @param points    pairs of frequency ratio and friction ratio
/// @param settings  cycles, tolerances, start
/// @return          a marker for every point, in their order
/// @throws          std::runtime_error where an integration does not come to its end
[[nodiscard]] std::vector<Marker> markers(const Figure& figure, const System<double>& system, double mu,
                                          const std::vector<std::pair<double, double>>& points,
                                          const PaperSettings& settings = {});

/// @brief Threads to use: as many as there are cores. @return at least 1
[[nodiscard]] unsigned threads();

} // namespace denhartog::figures
