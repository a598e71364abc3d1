// The rules of a question: its masses, and the numbers that make its point: r, beta and mu. And r in the units of the scene.
#pragma once

#include <boost/math/special_functions/fpclassify.hpp>
#include <cmath>
#include <concepts>
#include <string>
#include <utility>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

// The rule that a mass obeys: users count the masses from 1 to N.
[[nodiscard]] inline std::string mass_rule(std::size_t N) { return "must be a mass from 1 to " + std::to_string(N); }

// The mass that a user means by a number, which counts from 1. Throws InputError if there is no such mass.
template <std::integral I>
[[nodiscard]] Mass mass_from(I number, std::size_t N, const char* name) {
    if (std::cmp_less(number, 1) || std::cmp_greater(number, N)) throw InputError(name, mass_rule(N), std::to_string(number));
    return Mass{static_cast<std::size_t>(number) - 1};
}

// Checks that a mass is one of the system, counted from 0.
inline void check_mass(Mass mass, std::size_t N, const char* name) { (void)mass_from(mass.index + 1, N, name); }

// The rules of r, Eq. (10), beta, Eq. (11), and mu, Eq. (3).
template <class T>
void check_frequency_ratio(const T& r) {
    if (!(r > 0) || !boost::math::isfinite(r)) throw InputError("r", "must be positive and finite", number_to_text(r));
}

template <class T>
void check_friction_ratio(const T& beta) {
    if (!(beta >= 0) || !boost::math::isfinite(beta))
        throw InputError("beta", "must be zero or positive, and finite", number_to_text(beta));
}

template <class T>
void check_static_friction(const T& mu) {
    if (!(mu >= 1) || !boost::math::isfinite(mu)) throw InputError("mu", "must be at least 1, and finite", number_to_text(mu));
}

// The frequency ratio and the friction ratio of a scene. InputError where they are missing.
template <class T>
[[nodiscard]] const T& frequency_ratio_of(const Scene<T>& scene) {
    if (scene.r) return *scene.r;
    if (scene.units) throw InputError("frequency", "must be given (or frequency_hz in its place)", "");
    throw InputError("r", "must be given", "");
}

template <class T>
[[nodiscard]] const T& friction_ratio_of(const Scene<T>& scene) {
    if (scene.beta) return *scene.beta;
    if (scene.units && (scene.units->force || scene.units->force_changes())) throw InputError("friction", "must be given", "");
    if (scene.units) throw InputError("force", "must be given, and friction with it", "");
    throw InputError("beta", "must be given", "");
}

// Angular frequency omega = r sqrt(k_1 / m_1), Eq. (10) solved for it.
[[nodiscard]] inline double angular_frequency(const Units& units, double r) {
    return r * std::sqrt(units.stiffness / units.mass);
}

// The unit of displacements, P / k_1.
[[nodiscard]] inline double displacement_unit(const Units& units, double P) { return P / units.stiffness; }

} // namespace denhartog
