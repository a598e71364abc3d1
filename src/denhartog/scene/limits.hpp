/// @file
/// @brief The largest systems and the longest answers that are computed: what is beyond is refused by name, not for want of memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "denhartog/number/errors.hpp"

namespace denhartog {

/// @brief Most masses of a system.
///
/// The eigenproblem is dense: time goes with N^3, memory with N^2. At 1000 masses one boundary takes about a second and 60
/// megabytes in double; in 50 digits it takes some minutes and 400 megabytes. A motion with stops takes far longer.
inline constexpr std::size_t most_masses = 1000;

/// @brief Most instants at which a motion is given.
inline constexpr std::size_t most_samples = 10'000'000;

/// @brief Most displacements in one answer, instants times masses: some gigabytes with the velocities and their text.
inline constexpr std::size_t most_displacements = 100'000'000;

/// @brief Most instants at which a motion of many masses is given. @param N number of masses, at least 1 @return the number
[[nodiscard]] constexpr std::size_t most_samples_of(std::size_t N) { return std::min(most_samples, most_displacements / N); }

/// @brief Checks a number of instants.
/// @param quantity  what the caller calls it
/// @param samples   the number
/// @param N         number of masses
/// @throws          InputError where it is 0 or too large
inline void check_samples(const std::string& quantity, std::size_t samples, std::size_t N) {
    if (samples < 1 || samples > most_samples_of(N))
        throw InputError(quantity,
                         "must be from 1 to " + std::to_string(most_samples_of(N)) + " for " + std::to_string(N) +
                             (N == 1 ? " mass" : " masses"),
                         std::to_string(samples));
}

} // namespace denhartog
