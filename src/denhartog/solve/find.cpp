#include "denhartog/solve/find.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/solve/amplitude_search.hpp"
#include "denhartog/solve/condition.hpp"

namespace denhartog {
namespace {

using Json = nlohmann::json;

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
        const std::shared_ptr<const ContactSystem> system = moving_in_double(source, modes_in_double(source));
        for (const auto* frequencies : {&system->basis.r_n, &system->stuck.r_n})
            for (const double r_n : *frequencies) // where nothing is damped there is no answer at them, but beside them
                for (const double beside : {-0x1p-20, 0.0, 0x1p-20})
                    if (const double x = r_n * unit * (1 + beside); x > varied.from && x < varied.to) at.push_back(x);
    }
    std::ranges::sort(at);
    at.erase(std::unique(at.begin(), at.end()), at.end());
    return at;
}

// A scene that lacks the frequency that varies gets one, which each question replaces.
void complete(Json& scene, const VariedNumber& varied) {
    const bool is_frequency = varied.key == "r" || varied.key == "frequency" || varied.key == "frequency_hz";
    if (is_frequency && std::isfinite(varied.to) && scene.is_object() && !scene.contains(varied.key))
        scene[varied.key] = varied.to;
}

SeenAmplitude amplitude_of(const Json& scene, Mass mass, double damping_tolerance, Effort* effort) {
    const AmplitudesOfScene found = amplitudes_of(scene, mass, damping_tolerance, effort);
    if (found.amplitudes.empty()) return {std::nullopt, found.refused};
    return {found.amplitudes.front(), {}};
}

constexpr const char* rule = "must read `amplitude of mass K = VALUE`, `amplitude of mass K is largest` or `is least`, with "
                             "`largest` or `least` in front and `over KEY A:B` behind mass K if a second number varies";

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : std::string(text) + " ") {
        if (c != ' ' && c != '=') {
            word += c;
            continue;
        }
        if (!word.empty()) words.push_back(std::move(word));
        word.clear();
        if (c == '=') words.emplace_back("=");
    }
    return words;
}

std::optional<AmplitudeIs> extreme_named(const std::string& word) {
    if (word == "largest") return AmplitudeIs::largest;
    if (word == "least") return AmplitudeIs::least;
    return std::nullopt;
}

} // namespace

std::optional<VariedNumber> interval_from(std::string_view key, std::string_view ends) {
    VariedNumber varied{std::string(key)};
    const std::size_t colon = ends.find(':');
    const auto reads = [](std::string_view part, double& x) {
        return number_from_text(std::string(part), x) == NumberFault::none;
    };
    if (colon == std::string_view::npos || !reads(ends.substr(0, colon), varied.from) ||
        !reads(ends.substr(colon + 1), varied.to))
        return std::nullopt;
    return varied;
}

Wanted wanted_from(std::string_view text) {
    const std::vector<std::string> words = words_of(text);
    const InputError fault("so-that", rule, std::string(text));
    std::size_t n = 0;
    const auto next = [&] { return n < words.size() ? words[n] : std::string(); };
    const auto take = [&](std::string_view word) {
        if (next() != word) throw fault;
        ++n;
    };
    const auto number = [&](double& x) {
        if (number_from_text(next(), x) != NumberFault::none) throw fault;
        ++n;
    };
    Wanted wanted;
    const std::optional<AmplitudeIs> first = extreme_named(next());
    if (first) ++n;
    for (const char* word : {"amplitude", "of", "mass"}) take(word);
    double mass = 0;
    number(mass);
    if (!(mass >= 1 && mass <= 1e6) || mass != static_cast<double>(static_cast<std::size_t>(mass)))
        throw InputError("so-that", "must count masses from 1", std::string(text));
    wanted.mass.index = static_cast<std::size_t>(mass) - 1;
    if (next() == "over") {
        if (!first || n + 2 >= words.size()) throw fault;
        wanted.of = *first;
        wanted.over = interval_from(words[n + 1], words[n + 2]);
        if (!wanted.over) throw fault;
        n += 3;
    } else if (first) {
        throw fault;
    }
    if (next() == "=") {
        ++n;
        number(wanted.value);
        if (!(wanted.value >= 0)) throw InputError("so-that", "must not ask for a negative amplitude", std::string(text));
    } else {
        take("is");
        const std::optional<AmplitudeIs> is = extreme_named(next());
        if (!is) throw fault;
        wanted.is = *is;
        ++n;
    }
    if (n != words.size()) throw fault;
    return wanted;
}

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
                        double damping_tolerance, Effort* effort) {
    Json given = read_json(scene);
    complete(given, varied);
    if (wanted.over) complete(given, *wanted.over);
    const std::size_t N = number_of_masses(scene_source(SceneText{given.dump()})->in_double().system);
    if (wanted.mass.index >= N)
        throw InputError("so-that", "must name a mass from 1 to " + std::to_string(N), std::to_string(wanted.mass.index + 1));
    if (samples < 2 || samples > most_samples_to_find)
        throw InputError("samples", "must be from 2 to " + std::to_string(most_samples_to_find), std::to_string(samples));
    check_interval("between", varied);
    const Json::json_pointer place = place_of(varied.key, given);
    long questions = 0;
    std::optional<InputError> inadmissible; // a value in an interval that a scene cannot have
    const auto admitted = [&](const auto& ask) -> SeenAmplitude {
        try {
            return ask();
        } catch (const InputError& e) {
            if (!inadmissible) inadmissible = e;
            return {std::nullopt, std::string(e.what())};
        }
    };
    const auto amplitude_with = [&](const Json::json_pointer& at, double x) {
        given[at] = x;
        ++questions;
        return admitted([&] { return amplitude_of(given, wanted.mass, damping_tolerance, effort); });
    };
    AmplitudeAt amplitude = [&](double x) { return amplitude_with(place, x); };
    if (wanted.over) {
        check_interval("over", *wanted.over);
        const Json::json_pointer second = place_of(wanted.over->key, given);
        if (second == place) throw InputError("over", "must be another number than the one that varies", wanted.over->key);
        amplitude = [&, second, own = given.at(second)](double x) {
            given[place] = x;
            given[second] = own;
            return admitted([&] {
                AmplitudeSearch search(first_places(*wanted.over, given, samples),
                                       [&](double y) { return amplitude_with(second, y); });
                return search.amplitude_of_extreme(wanted.of == AmplitudeIs::largest);
            });
        };
    }
    AmplitudeSearch search(first_places(varied, given, samples), amplitude);
    FoundPlaces found =
        wanted.is == AmplitudeIs::value ? search.value(wanted.value) : search.extreme(wanted.is == AmplitudeIs::largest);
    if (found.places.empty() && inadmissible && found.unanswered.size() >= static_cast<std::size_t>(samples))
        throw InputError(*inadmissible); // all are
    found.questions = questions;
    if (found.places.empty() && !found.unanswered.empty())
        throw PrecisionError("no place was found, and the amplitude is not known at " + std::to_string(found.unanswered.size()) +
                             (found.unanswered.size() == 1 ? " sample: " : " samples: ") + found.why);
    return found;
}

} // namespace denhartog
