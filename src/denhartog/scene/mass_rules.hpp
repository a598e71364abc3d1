/// @file
/// @brief The rule that a mass obeys: users count the masses from 1 to N.
#pragma once

#include <concepts>
#include <string>
#include <utility>

#include "denhartog/number/errors.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief The rule in words.
[[nodiscard]] inline std::string mass_rule(std::size_t N) { return "must be a mass from 1 to " + std::to_string(N); }

/// @brief The mass, counted from 0, that a user means by a number, which counts from 1; InputError under the name if there is
/// none.
template <std::integral I>
[[nodiscard]] Mass mass_from(I number, std::size_t N, const char* name) {
    if (std::cmp_less(number, 1) || std::cmp_greater(number, N)) throw InputError(name, mass_rule(N), std::to_string(number));
    return Mass{static_cast<std::size_t>(number) - 1};
}

/// @brief Checks that a mass is one of the system, else InputError under the name.
inline void check_mass(Mass mass, std::size_t N, const char* name) { (void)mass_from(mass.index + 1, N, name); }

} // namespace denhartog
