// The keys of a scene, in ratios and in physical units, and the message for a key that is none: it names the key that was
// probably meant. Read `check_keys`.
#include "denhartog/scene/scene_json.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/scene_rules.hpp"

namespace denhartog {
namespace {

using nlohmann::json;

constexpr auto keys = std::to_array<std::string_view>({"mass_ratios",
                                                       "stiffness_ratios",
                                                       "damping_ratios",
                                                       "contact",
                                                       "load",
                                                       "load_phases",
                                                       "mu",
                                                       "r",
                                                       "beta",
                                                       "mass_matrix",
                                                       "stiffness_matrix",
                                                       "damping_matrix",
                                                       "masses",
                                                       "stiffnesses",
                                                       "force",
                                                       "unbalance",
                                                       "friction",
                                                       "normal_force",
                                                       "friction_coefficient",
                                                       "static_friction_coefficient",
                                                       "frequency",
                                                       "frequency_hz",
                                                       "static_load",
                                                       "base_motion",
                                                       "base_displacement",
                                                       "base_acceleration",
                                                       "damping_tolerance",
                                                       "comment"});
constexpr auto dimensional_keys = std::to_array<const char*>(
    {"masses", "stiffnesses", "force", "unbalance", "friction", "normal_force", "friction_coefficient",
     "static_friction_coefficient", "frequency", "frequency_hz", "base_displacement", "base_acceleration"});
// Words for what a scene has under other names, and these.
constexpr auto other_words = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"mass", "masses, or mass_ratios"},
     {"m", "masses, or mass_ratios"},
     {"stiffness", "stiffnesses, or stiffness_ratios"},
     {"k", "stiffnesses, or stiffness_ratios"},
     {"damping", "damping_ratios, or damping_matrix"},
     {"zeta", "damping_ratios"},
     {"c", "damping_matrix"},
     {"dampings", "damping_matrix"},
     {"omega", "frequency, or r"},
     {"w", "frequency, or r"},
     {"f", "frequency_hz"},
     {"F", "friction"},
     {"P", "force"},
     {"N", "normal_force"},
     {"amplitude", "force, or base_displacement"},
     {"me", "unbalance, mass times eccentricity"},
     {"phases", "load_phases"},
     {"phase", "load_phases"},
     {"acceleration", "base_acceleration"},
     {"direction", "contact, as {\"direction\": [..]}"},
     {"mu_k", "friction_coefficient, with normal_force"},
     {"mu_s", "static_friction_coefficient, with friction_coefficient and normal_force"},
     {"coefficient_of_friction", "friction_coefficient, with normal_force"},
     {"preload", "static_load"},
     {"weight", "static_load"},
     {"static_friction", "static_friction_coefficient, or mu"},
     {"mu_static", "static_friction_coefficient, with friction_coefficient and normal_force"}});
// Keys of a scene in ratios, each with its name in a dimensional scene.
constexpr auto ratio_keys = std::to_array<std::pair<const char*, const char*>>({{"mass_ratios", "masses"},
                                                                                {"stiffness_ratios", "stiffnesses"},
                                                                                {"mass_matrix", "masses"},
                                                                                {"stiffness_matrix", "stiffnesses"},
                                                                                {"r", "frequency"},
                                                                                {"beta", "friction"}});

/// Number of letters to be added, left out or changed to make one word of another.
std::size_t letters_apart(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t before = row[0];
        row[0] = i;
        for (std::size_t k = 1; k <= b.size(); ++k) {
            const std::size_t changed = before + (a[i - 1] == b[k - 1] ? 0 : 1);
            before = row[k];
            row[k] = std::min({changed, row[k] + 1, row[k - 1] + 1});
        }
    }
    return row.back();
}

// The nearest key to a word that is none, as the end of a sentence; empty if none is near.
std::string did_you_mean(std::string_view unknown) {
    constexpr std::size_t longest = 64; // of a word that may be a key misspelt
    if (unknown.size() > longest) return {};
    const auto word = std::ranges::find(other_words, unknown, [](const auto& each) { return each.first; });
    if (word != other_words.end()) return "; did you mean " + std::string(word->second) + "?";
    const auto apart = [unknown](std::string_view key) { return letters_apart(unknown, key); };
    const std::string_view nearest = *std::ranges::min_element(keys, {}, apart);
    return apart(nearest) <= nearest.size() / 2 ? "; did you mean " + std::string(nearest) + "?" : "";
}

// The rule that an unknown key breaks, with the key that was meant, if there is one like it, and all keys.
std::string rule_of_keys(std::string_view unknown) {
    const std::string guess = did_you_mean(unknown);
    std::string rule = "is no key of a scene" + (guess.empty() ? "." : guess) + " The keys are";
    for (const std::string_view key : keys) rule.append(key == keys.front() ? " " : ", ").append(key);
    return rule;
}

} // namespace

std::span<const std::string_view> scene_keys() { return keys; }

bool check_keys(const json& object) {
    if (!object.is_object())
        throw InputError("scene", "must be a JSON object",
                         legible(object.dump(-1, ' ', true, json::error_handler_t::replace), most_of_a_value));
    for (const auto& entry : object.items())
        if (std::ranges::find(keys, entry.key()) == keys.end())
            throw InputError(
                entry.key(),
                rule_of_keys(entry.key()) +
                    ". A scene has one contact with Coulomb friction and one harmonic load: for several contacts, "
                    "several harmonics or another law of friction take an integrator over time, e.g. SUNDIALS or Siconos",
                "", pointer_step(entry.key()));
    const auto dimensional = std::ranges::find_if(dimensional_keys, [&](const char* key) { return object.contains(key); });
    if (dimensional == dimensional_keys.end()) return false;
    for (const auto& [key, dimensional_key] : ratio_keys)
        if (object.contains(key))
            throw InputError(key,
                             std::string("must not be given together with ") + *dimensional +
                                 ": a scene is dimensional or it is not; a dimensional one has " + dimensional_key +
                                 (key == std::string_view("r") ? " or frequency_hz" : "") + " instead",
                             "", pointer_step(key));
    return true;
}

std::string_view SceneNames::operator()(std::string_view in_ratios) const {
    const auto names = std::ranges::find(ratio_keys, in_ratios, [](const auto& each) { return std::string_view(each.first); });
    return dimensional ? names->second : in_ratios;
}

} // namespace denhartog
