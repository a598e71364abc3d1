/// @file
/// @brief What is asked of the search for an orbit, how long it follows a motion, and what it says of one that leads to none.
#pragma once

#include <string>

#include "denhartog/orbit/periodic_orbit.hpp"

namespace denhartog {

/// @brief What was seen of a motion that leads to no orbit. Lengths count half-periods.
struct SearchWithoutOrbit {
    int periods = 0;               ///< of the force, for which it was followed
    std::string ended{};           ///< why it was followed no further; empty where that is long enough
    bool chattering = false;       ///< phases of no length followed each other
    bool restless = false;         ///< rounding keeps it from settling
    double grows_to = 0;           ///< its size, where it still grows; else 0
    int repeats_after = 0;         ///< the length after which it repeats itself best; 0 where that is not known
    double repeats_to = 0;         ///< how well, over its size
    int orbit = 0;                 ///< length of a periodic motion that is there; 0 where none was found
    bool orbit_is_stable = false;  ///< whether that attracts its neighbours
    double largest_multiplier = 0; ///< of it
    double away = 0;               ///< how far the motion is from it, over its size
};

/// @brief The same in words. @param seen what was seen @return sentences, the first without a capital, the last without its stop
[[nodiscard]] std::string in_words(const SearchWithoutOrbit& seen);

/// @brief What a half-period changes of a motion, where no two motions move apart: less than the one before, but for rounding.
struct Settling {
    double change = -1; ///< of the last half-period, as `OrbitMap` measures it; negative before the first
    int rises = 0;      ///< half-periods that changed more than the one before

    /// @brief Takes the change of one more half-period. @param next the change
    void take(double next) {
        rises += change >= 0 && next > change * 1.001;
        change = next;
    }
    /// @brief Whether rounding keeps the motion from settling: Newton's method would have to end at it too. @return whether
    [[nodiscard]] bool is_restless() const { return rises >= 16; }
};

/// @brief Checks what is asked of the search. Throws InputError.
/// @param search  what is asked
/// @param start   state at tau = 0
/// @param N       masses
void check_search(const OrbitSearch& search, const State& start, std::size_t N);

/// @brief Periods after which a motion from a start is no transient any more, where it has not become periodic.
/// @param solver  system, frequency and friction
/// @param most    no more than these @return 500 and thirty times a mode's slowest decay time; `most` if damping couples modes
[[nodiscard]] int periods_to_follow(const ExactSolver& solver, int most);

} // namespace denhartog
