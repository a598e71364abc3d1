/// @file
/// @brief The systems on which statements on permanent sticking are measured: the paper's own and other equal chains.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "denhartog/stick_slip/stuck_response.hpp"
#include "tests/support/sample_scenes.hpp"

namespace denhartog::derivation {

/// @brief A system with its modes, sliding and stuck.
struct StuckSystem {
    std::string name;                ///< its name
    bool of_the_paper;               ///< whether it is one of the paper's own
    System<double> system;           ///< the system
    ModalBasis<double> basis;        ///< modes while the contact slides
    StuckConfiguration stuck;        ///< modes while it sticks
    std::optional<StuckChain> chain; ///< the masses that move by (88)
};

/// @brief The systems, made once.
/// @return  those of the paper, then chains of equal masses and springs with one damping ratio for all modes
[[nodiscard]] const std::vector<StuckSystem>& stuck_systems();

/// @brief A chain of equal masses and springs with one damping ratio for all modes.
/// @param N     number of masses
/// @param j     mass in contact, counted from 1
/// @param l     loaded mass, counted from 1
/// @param zeta  damping ratio
/// @return      the system
[[nodiscard]] StuckSystem equal_chain(std::size_t N, std::size_t j, std::size_t l, double zeta);

/// @brief The boundary of permanent sticking at a frequency ratio, mu = 1.
/// @param s  a system
/// @param r  frequency ratio
/// @return   the boundary; none where an undamped stuck mode resonates
[[nodiscard]] std::optional<StickingBoundary> sticking_at(const StuckSystem& s, double r);

/// @brief Where a relative error of the boundary is largest over a sweep of frequency ratios.
struct WorstOfSweep {
    double error = 0; ///< |wrong / exact - 1|
    double r = 0;     ///< where
    double ratio = 1; ///< wrong / exact there
};

/// @brief The worst of a sweep r = 1/200 to 3 in steps of 1/200, the natural frequency ratios of the stuck configuration besides.
/// @param s      a system
/// @param wrong  the boundary to be judged
/// @return       the largest relative error
[[nodiscard]] WorstOfSweep worst_over_r(const StuckSystem& s, const std::function<double(const StickingBoundary&)>& wrong);

} // namespace denhartog::derivation
