// The rules of a scene under the names that its author used.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

// The rule of mu, with what is meant by a number below 1.
inline constexpr const char* rule_of_mu =
    "must be at least 1, static over kinetic friction (a coefficient of friction is friction_coefficient, with normal_force)";

// Largest modal damping ratio: beyond, rates and their products leave the range of a double.
inline constexpr double largest_damping_ratio = 1e300;

// Largest tolerance of a damping matrix: no distance is as large, so that it always takes the nearest classical damping.
inline constexpr double largest_damping_tolerance = 2;

// The rule of the largest number of masses, of `values` or `rows`.
[[nodiscard]] inline std::string most_masses_rule(const std::string& of) {
    return "must have at most " + std::to_string(most_masses) + " " + of + ", one a mass";
}

// Whether a scene is in physical units. Throws InputError where it is no object, has a key that is none (the nearest one and all
// are named), or has keys of both ratios and physical units.
bool check_keys(const nlohmann::json& object);

// Names that the author of a scene gives its quantities, and whether messages point into a JSON text.
struct SceneNames {
    bool dimensional = false; // `masses` in place of `mass_ratios`, and so on
    bool one_zeta = false;    // one damping ratio was given for all modes
    bool places = false;      // errors carry the JSON pointer

    // The name of a quantity that is called so in ratios.
    [[nodiscard]] std::string_view operator()(std::string_view in_ratios) const;
};

// Checks every rule of a scene. Throws InputError naming quantity, rule, value and, if asked for, place of the first rule that is
// broken.
template <class T>
void check_under_names(const Scene<T>& scene, const SceneNames& names);

} // namespace denhartog
