#include "denhartog/solve/find.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/solve/amplitude_search.hpp"
#include "denhartog/solve/decision.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {
namespace {

using Json = nlohmann::json;

constexpr double eps = std::numeric_limits<double>::epsilon();

// The place of a number in the scene.
Json::json_pointer place_of(const std::string& key, const Json& scene) {
    const std::size_t slash = key.find('/');
    const std::string name = key.substr(0, slash);
    const auto refuse = [&](const std::string& rule) { throw InputError("vary", rule, key); };
    if (!scene.contains(name)) refuse("must be a key of the scene that has a number");
    std::string path = pointer_step(name);
    const Json& value = scene.at(name);
    if (slash != std::string::npos) {
        double place = 0;
        const bool is_number = number_from_text(key.substr(slash + 1), place) == NumberFault::none;
        if (!value.is_array() || !is_number || !(place >= 1 && place <= static_cast<double>(value.size())) ||
            place != std::floor(place))
            refuse("must name a list of the scene and a place in it, counted from 1");
        path += "/" + std::to_string(static_cast<long>(place) - 1);
    } else if (value.is_array()) {
        refuse("must name the place in the list too, counted from 1, such as " + name + "/1");
    }
    const Json::json_pointer pointer(path);
    if (!scene.at(pointer).is_number() && !scene.at(pointer).is_string()) refuse("must be a key of the scene that has a number");
    return pointer;
}

void check_interval(const std::string& name, const VariedNumber& varied) {
    if (!std::isfinite(varied.from) || !std::isfinite(varied.to) || !(varied.from < varied.to))
        throw InputError(name, "must be two finite numbers, the lower one first",
                         number_to_text(varied.from) + ":" + number_to_text(varied.to));
}

// Places where an amplitude is looked at first: evenly spaced, and the natural frequencies if the frequency varies.
std::vector<double> first_places(const VariedNumber& varied, const Json& scene, int samples) {
    std::vector<double> at;
    for (int n = 0; n <= samples; ++n)
        at.push_back(n == samples ? varied.to : varied.from + (varied.to - varied.from) * n / samples);
    double unit = 0;
    const SceneSource source = scene_source(SceneText{scene.dump()});
    const std::optional<Units>& units = source->in_double().units;
    if (varied.key == "r") unit = 1;
    if (varied.key == "frequency" && units) unit = angular_frequency(*units, 1);
    if (varied.key == "frequency_hz" && units) unit = angular_frequency(*units, 1) / (2 * pi<double>());
    if (unit > 0) {
        const ContactSystem system = contact_system(source->in_double().system);
        for (const auto* frequencies : {&system.basis.r_n, &system.stuck.r_n})
            for (const double r_n : *frequencies)
                if (r_n * unit > varied.from && r_n * unit < varied.to) at.push_back(r_n * unit);
    }
    std::ranges::sort(at);
    at.erase(std::ranges::unique(at).begin(), at.end());
    return at;
}

// The amplitude of a mass at the point of a scene, in its unit of length.
SeenAmplitude amplitude_of(const Json& scene, Mass mass, double damping_tolerance) {
    const std::string text = scene.dump();
    SceneSource source = scene_source(SceneText{text});
    if (damping_tolerance > 0) source = with_damping_tolerance(source, damping_tolerance);
    const Scene<double>& s = source->in_double();
    Question question{Asked::amplitude, std::nullopt};
    question.mass = mass;
    const SolvePoint at{frequency_ratio_of(s), friction_ratio_of(s), &source};
    const AnswerOrNone answer = decide(prepare(source, question), at, question);
    if (!answer.is_answered()) return {std::nullopt, answer.refused};
    const Certified& a = answer.solution.amplitude(mass);
    double unit = 1;
    if (s.units)
        if (const std::optional<double> P = s.units->force_at(angular_frequency(*s.units, frequency_ratio_of(s))))
            unit = displacement_unit(*s.units, *P);
    return {Certified{a.value * unit, (a.error + 4 * eps * a.value) * unit, {}, a.proved}, {}};
}

} // namespace

std::string_view name_of(PlaceIs is) {
    switch (is) {
    case PlaceIs::crossing: return "crossing";
    case PlaceIs::jump: return "jump";
    case PlaceIs::undecided: return "undecided";
    case PlaceIs::extreme: return "extreme";
    default: return "end of the interval";
    }
}

FoundPlaces find_places(std::string_view scene, const VariedNumber& varied, const Wanted& wanted, int samples,
                        double damping_tolerance) {
    Json given = read_json(scene);
    const std::size_t N = number_of_masses(scene_source(SceneText{scene})->in_double().system);
    if (wanted.mass.index >= N)
        throw InputError("so-that", "must name a mass from 1 to " + std::to_string(N), std::to_string(wanted.mass.index + 1));
    if (samples < 2 || samples > most_samples_to_find)
        throw InputError("samples", "must be from 2 to " + std::to_string(most_samples_to_find), std::to_string(samples));
    check_interval("between", varied);
    const Json::json_pointer place = place_of(varied.key, given);
    long questions = 0;
    AmplitudeAt amplitude = [&](double x) {
        given[place] = x;
        ++questions;
        return amplitude_of(given, wanted.mass, damping_tolerance);
    };
    if (wanted.over) {
        check_interval("over", *wanted.over);
        const Json::json_pointer second = place_of(wanted.over->key, given);
        if (second == place) throw InputError("over", "must be another number than the one that varies", wanted.over->key);
        amplitude = [&, second](double x) -> SeenAmplitude {
            given[place] = x;
            AmplitudeSearch search(first_places(*wanted.over, given, samples), [&](double y) {
                given[second] = y;
                ++questions;
                return amplitude_of(given, wanted.mass, damping_tolerance);
            });
            const FoundPlaces found = search.extreme(wanted.of == AmplitudeIs::largest);
            if (found.places.empty()) return {std::nullopt, found.why};
            return {found.places.front().amplitude, {}};
        };
    }
    Json at_first = given;
    at_first[place] = varied.from;
    AmplitudeSearch search(first_places(varied, at_first, samples), amplitude);
    FoundPlaces found =
        wanted.is == AmplitudeIs::value ? search.value(wanted.value) : search.extreme(wanted.is == AmplitudeIs::largest);
    found.questions = questions;
    return found;
}

} // namespace denhartog
