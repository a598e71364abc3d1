// Amplitudes as functions of a number of the scene. `amplitudes_of` solves a scene with one number changed; `find_places` seeks
// where an amplitude is as wanted, and `conditions_of` takes differences.
#include "denhartog/solve/find.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "denhartog/answer/models_in_double.hpp"
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/solve/detail/amplitude_search.hpp"
#include "denhartog/solve/solve.hpp"

namespace denhartog {
namespace {

using Json = nlohmann::json;

constexpr auto varied_keys = std::to_array<const char*>(
    {"mass_ratios", "stiffness_ratios", "damping_ratios", "r", "beta", "masses", "stiffnesses", "force", "friction",
     "normal_force", "friction_coefficient", "frequency", "frequency_hz", "unbalance", "base_displacement", "base_acceleration"});

// The place of a number of a scene; of a list the key has it, counted from 1, behind a slash.
Json::json_pointer place_of(const std::string& key, const Json& scene) {
    const std::size_t slash = key.find('/');
    const std::string name = key.substr(0, slash);
    const auto refuse = [&](const std::string& rule) { throw InputError("vary", rule, key); };
    const std::string has_number = "must be a key of the scene that has a number";
    if (!scene.contains(name))
        refuse(has_number + (name == "mu" || std::ranges::count(varied_keys, name) > 0
                                 ? " (give the scene " + name + ", with any number it may have)"
                                 : ""));
    std::string path = pointer_step(name);
    const Json& value = scene.at(name);
    if (value.is_array() && !value.empty() && value.front().is_array())
        refuse("must not name an entry of a matrix, because one changes with its mirror image");
    if (slash != std::string::npos) {
        double place = 0;
        const bool is_number = number_from_text(key.substr(slash + 1), place) == NumberFault::none;
        if (!value.is_array() || !is_number || !(place >= 1 && place <= static_cast<double>(value.size())) ||
            place != std::floor(place))
            refuse("must name a list of the scene and a place in it, counted from 1" +
                   (number_in(value)
                        ? " (" + name + " is one number: leave out the place, or write a list if the key may have one)"
                        : std::string()));
        path += "/" + std::to_string(static_cast<long>(place) - 1);
    } else if (value.is_array()) {
        refuse("must name the place in the list too, counted from 1, such as " + name + "/1");
    }
    const Json::json_pointer pointer(path);
    if (!number_in(scene.at(pointer))) refuse(has_number);
    return pointer;
}

// The amplitudes at the point of a scene, of the mass or of all, in its unit of length, else of P / k_1.
Tried<std::vector<Certified>> amplitudes_of(const Json& scene, std::optional<Mass> mass, double damping_tolerance,
                                            Effort* effort) {
    const std::string text = scene.dump();
    SceneSource source = scene_source(SceneText{text});
    if (damping_tolerance > 0) source = with_damping_tolerance(source, damping_tolerance);
    const Scene<double>& s = source->in_double();
    Question question{Asked::amplitude, std::nullopt};
    question.mass = mass;
    const SolvePoint at{frequency_ratio_of(s), friction_ratio_of(s), &source, effort};
    const Tried<Solution> answer = decide(prepare(source, question), at, question);
    if (!answer.is_answered()) return Refusal(answer);
    double unit = 1;
    if (s.units)
        if (const std::optional<double> P = s.units->force_at(angular_frequency(*s.units, at.r)))
            unit = displacement_unit(*s.units, *P);
    std::vector<Certified> found;
    const double rounding = 4 * std::numeric_limits<double>::epsilon();
    for (const SolvedMass& m : answer.value->masses) {
        const Certified& a = m.amplitude;
        found.push_back({a.value * unit, (a.error + rounding * a.value) * unit, {}, a.proved});
    }
    return found;
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

Tried<Certified> amplitude_of(const Json& scene, Mass mass, double damping_tolerance, Effort* effort) {
    Tried<std::vector<Certified>> found = amplitudes_of(scene, mass, damping_tolerance, effort);
    if (!found.is_answered()) return Refusal(std::move(found));
    if (found.value->empty()) return {Outcome::digits_missing, {}};
    return found.value->front();
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

constexpr double first_step = 0x1p-15, last_step = 0x1p-44; // relative; they become shorter by a factor of 8
constexpr double agreement = 0.01;                          // of two steps

std::vector<std::string> numbers_of(const Json& scene) {
    std::vector<std::string> numbers;
    for (const char* key : varied_keys) {
        if (!scene.contains(key)) continue;
        const Json& value = scene.at(key);
        const bool is_matrix = value.is_array() && !value.empty() && value.front().is_array();
        if (value.is_array() && !is_matrix)
            for (std::size_t n = 1; n <= value.size(); ++n) numbers.push_back(std::string(key) + "/" + std::to_string(n));
        else if (!is_matrix)
            numbers.emplace_back(key);
    }
    // The first of both ratios is 1 by its definition: it cannot vary by itself.
    std::erase_if(numbers, [](const std::string& number) {
        return number == "mass_ratios" || number == "mass_ratios/1" || number == "stiffness_ratios" ||
               number == "stiffness_ratios/1";
    });
    return numbers;
}

// Conditions by one step on both sides; none where there is no answer.
std::vector<std::optional<double>> by_step(Json& scene, const Json::json_pointer& place, double p, double step, std::size_t N,
                                           double damping_tolerance, Effort* effort) {
    std::vector<std::optional<double>> found(N);
    scene[place] = p * (1 + step);
    const Tried<std::vector<Certified>> more = amplitudes_of(scene, std::nullopt, damping_tolerance, effort);
    scene[place] = p * (1 - step);
    const Tried<std::vector<Certified>> less = amplitudes_of(scene, std::nullopt, damping_tolerance, effort);
    scene[place] = p;
    if (!more.value || !less.value || more.value->size() != N || less.value->size() != N) return found;
    for (std::size_t k = 0; k < N; ++k) {
        const Certified &a = (*more.value)[k], &b = (*less.value)[k];
        const double size = (a.value + b.value) / 2, change = a.value - b.value, unsure = a.error + b.error;
        if (size > 0 && (unsure <= agreement / 4 * std::abs(change) || unsure <= 1e-6 * step * size))
            found[k] = change / (2 * step * size);
    }
    return found;
}

// A mode so near to its resonance, and with so little damping, that amplitudes hang on the last digits of the scene.
struct SensitiveMode {
    std::size_t mode; // counted from 0
    double R;         // its frequency ratio, (22)
    double change;    // by what part its amplitude changes if R changes by a unit in the last place
};

// |v_d| of (23) changes by (1 - R) / ((1 - R)^2 + zeta^2) of itself, for a relative change of R. A damping matrix has none unless
// it is zero. With `at_node` it is one that does not move the contact.
std::optional<SensitiveMode> sensitive_mode(const SceneSource& source, bool at_node) {
    constexpr double noticeable = 1e-3, unit = std::numeric_limits<double>::epsilon();
    const System<double>& s = source->in_double().system;
    const bool damped = std::ranges::all_of(s.damping_ratios, [](double zeta) { return zeta > unit / noticeable; });
    if (s.damping_matrix.size() > 0 ? !s.damping_matrix.isZero(0) : damped) return std::nullopt;
    const ModesInDouble found = modes_in_double(source);
    const ModalBasis<Bounded<double>>& modes = *found.basis;
    for (std::size_t i = 0; i < modes.r_n.size(); ++i) {
        const double R = frequency_ratio_of(source->in_double()) / modes.r_n[i].x, zeta = modes.zeta[i].x;
        const double apart = std::abs(R - 1) + unit, change = unit * apart / (apart * apart + zeta * zeta);
        const auto row = static_cast<Eigen::Index>(contact_row(s).index);
        const Bounded<double>& at_contact = modes.phi(row, static_cast<Eigen::Index>(i));
        if (at_node && std::abs(at_contact.x) > at_contact.e) continue;
        if (change > noticeable && is_excited(modes, s, i)) return SensitiveMode{i, R, change};
    }
    return std::nullopt;
}

bool agree(const std::optional<double>& x, const std::optional<double>& y) {
    return x && y && std::abs(*x - *y) <= agreement * std::max({std::abs(*x), std::abs(*y), 1e-3});
}

} // namespace

VariedNumber interval_from(const std::string& key, const std::string& ends, const std::string& quantity) {
    const std::size_t colon = ends.find(':');
    if (colon == ends.npos || colon == 0 || colon + 1 == ends.size())
        throw InputError(quantity, "must be A:B, two numbers", ends);
    const auto number = [&](const std::string& part) {
        double x = 0;
        if (const NumberFault fault = number_from_text(part, x); fault != NumberFault::none)
            throw InputError(quantity, number_rule(fault), part);
        return x;
    };
    return {key, number(ends.substr(0, colon)), number(ends.substr(colon + 1))};
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
        wanted.over = interval_from(words[n + 1], words[n + 2], "over");
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
                        double damping_tolerance, Effort* effort, std::size_t line) {
    Json given = read_json(scene, line);
    complete(given, varied);
    if (wanted.over) complete(given, *wanted.over);
    const std::size_t N = number_of_masses(scene_source(SceneText{given.dump()})->in_double().system);
    if (wanted.mass.index >= N)
        throw InputError("so-that", "must name a mass from 1 to " + std::to_string(N), std::to_string(wanted.mass.index + 1));
    if (samples < 2 || samples > most_samples_to_find)
        throw InputError("samples", "must be from 2 to " + std::to_string(most_samples_to_find), std::to_string(samples));
    check_interval("between", varied);
    const Json::json_pointer place = place_of(varied.key, given);
    long questions = 0, left_out = 0;
    Reasons left_out_why;
    std::optional<InputError> inadmissible; // a value in an interval that a scene cannot have
    const auto admitted = [&](const auto& ask) -> Tried<Certified> {
        try {
            return ask();
        } catch (const InputError& e) {
            if (!inadmissible) inadmissible = e;
            return {Outcome::at_a_pole, std::string(e.what())}; // outside what amplitudes are defined for
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
                AmplitudeSearch search(first_places(*wanted.over, given, samples), [&](double y) {
                    Tried<Certified> seen = amplitude_with(second, y);
                    if (!seen.is_answered() && left_out++ == 0) left_out_why = seen.why;
                    return seen;
                });
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
    found.left_out = left_out;
    found.left_out_why = left_out_why;
    if (found.places.empty() && !found.unanswered.empty())
        throw PrecisionError("no place was found, and the amplitude is not known at " + std::to_string(found.unanswered.size()) +
                                 (found.unanswered.size() == 1 ? " sample: " : " samples: ") + found.why,
                             found.outcome);
    return found;
}

std::vector<ConditionOfAmplitudes> conditions_of(std::string_view text, double damping_tolerance, Effort* effort) {
    Json scene = read_json(text);
    const std::size_t N = number_of_masses(scene_source(SceneText{text})->in_double().system);
    std::vector<ConditionOfAmplitudes> all;
    for (const std::string& number : numbers_of(scene)) {
        const Json::json_pointer place = place_of(number, scene);
        const Json as_written = scene.at(place);
        const double p = *number_in(as_written);
        if (p == 0) continue;
        std::vector<std::optional<double>> settled(N), before(N);
        for (double step = first_step; step >= last_step; step /= 8) {
            const std::vector<std::optional<double>> now = by_step(scene, place, p, step, N, damping_tolerance, effort);
            for (std::size_t k = 0; k < N; ++k)
                if (!settled[k] && agree(now[k], before[k])) settled[k] = now[k];
            if (std::ranges::all_of(settled, [](const auto& each) { return each.has_value(); })) break;
            before = now;
        }
        scene[place] = as_written;
        all.push_back({number, settled});
    }
    return all;
}

std::string warning_of(const SceneSource& source, const Solution& solution) {
    const std::optional<SensitiveMode> mode = sensitive_mode(source, solution.regime.regime != Regime::continuous);
    if (!mode) return {};
    return "a unit in the last place of the frequency, of a mass or of a stiffness changes amplitudes by some " +
           number_in_digits(mode->change, 2) + " of themselves: mode " + std::to_string(mode->mode + 1) +
           " has next to no damping, and R = " + number_to_text(mode->R);
}

} // namespace denhartog
