/// @file
/// @brief The largest systems and the longest answers that the library computes. It refuses larger ones with an error that names
/// the limit, before memory runs out.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "denhartog/number/errors.hpp"

namespace denhartog {

/// @brief The largest number of masses of a system.
///
/// The eigenproblem is dense: its time grows as N^3, its memory as N^2. A motion with stops takes far longer than a boundary.
inline constexpr std::size_t most_masses = 1000;

/// @brief The largest number of instants at which a motion is given.
inline constexpr std::size_t most_samples = 10'000'000;

/// @brief The largest number of displacements in one answer, instants times masses. With velocities and text these take some
/// gigabytes.
inline constexpr std::size_t most_displacements = 100'000'000;

/// @brief The largest number of instants for a system of N masses. @param N number of masses, at least 1 @return the number
[[nodiscard]] constexpr std::size_t most_samples_of(std::size_t N) { return std::min(most_samples, most_displacements / N); }

/// @brief Checks a number of instants.
/// @param quantity  the caller's name for it, which the error uses
/// @param samples   the number of instants
/// @param N         number of masses
/// @throws          InputError if it is not from 1 to `most_samples_of(N)`
inline void check_samples(const std::string& quantity, std::size_t samples, std::size_t N) {
    if (samples < 1 || samples > most_samples_of(N))
        throw InputError(quantity,
                         "must be from 1 to " + std::to_string(most_samples_of(N)) + " for " + std::to_string(N) +
                             (N == 1 ? " mass" : " masses"),
                         std::to_string(samples));
}

} // namespace denhartog
