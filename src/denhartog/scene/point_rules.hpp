/// @file
/// @brief The rules of the numbers that make a point: r, beta and mu; and of a mass, which users count from 1 to N.
#pragma once

#include <boost/math/special_functions/fpclassify.hpp>
#include <concepts>
#include <string>
#include <utility>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
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

/// @brief Checks that a frequency ratio, Eq. (10), is positive and finite, else InputError.
template <class T>
void check_frequency_ratio(const T& r) {
    if (!(r > 0) || !boost::math::isfinite(r)) throw InputError("r", "must be positive and finite", number_to_text(r));
}

/// @brief Checks that a friction ratio, Eq. (11), is zero or positive, and finite, else InputError.
template <class T>
void check_friction_ratio(const T& beta) {
    if (!(beta >= 0) || !boost::math::isfinite(beta))
        throw InputError("beta", "must be zero or positive, and finite", number_to_text(beta));
}

/// @brief Checks that static over kinetic friction, Eq. (3), is at least 1, and finite, else InputError.
template <class T>
void check_static_friction(const T& mu) {
    if (!(mu >= 1) || !boost::math::isfinite(mu)) throw InputError("mu", "must be at least 1, and finite", number_to_text(mu));
}

/// @brief The frequency ratio of a scene; InputError where it is missing.
template <class T>
[[nodiscard]] const T& frequency_ratio_of(const Scene<T>& scene) {
    if (!scene.r) throw InputError(scene.units ? "frequency" : "r", "must be given", "nothing");
    return *scene.r;
}

/// @brief The friction ratio of a scene; InputError where it is missing.
template <class T>
[[nodiscard]] const T& friction_ratio_of(const Scene<T>& scene) {
    if (scene.beta) return *scene.beta;
    if (scene.units && (scene.units->force || scene.units->base)) throw InputError("friction", "must be given", "nothing");
    if (scene.units) throw InputError("force", "must be given, and friction with it", "nothing");
    throw InputError("beta", "must be given", "nothing");
}

} // namespace denhartog
