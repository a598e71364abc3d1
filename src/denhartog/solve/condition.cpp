#include "denhartog/solve/condition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/solve/decision.hpp"

namespace denhartog {
namespace {

using Json = nlohmann::json;

constexpr auto varied_keys = std::to_array<const char*>(
    {"mass_ratios", "stiffness_ratios", "damping_ratios", "r", "beta", "masses", "stiffnesses", "force", "friction",
     "normal_force", "friction_coefficient", "frequency", "frequency_hz", "unbalance", "base_displacement", "base_acceleration"});
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
    const AmplitudesOfScene more = amplitudes_of(scene, std::nullopt, damping_tolerance, effort);
    scene[place] = p * (1 - step);
    const AmplitudesOfScene less = amplitudes_of(scene, std::nullopt, damping_tolerance, effort);
    scene[place] = p;
    if (more.amplitudes.size() != N || less.amplitudes.size() != N) return found;
    for (std::size_t k = 0; k < N; ++k) {
        const Certified &a = more.amplitudes[k], &b = less.amplitudes[k];
        const double size = (a.value + b.value) / 2, change = a.value - b.value, unsure = a.error + b.error;
        if (size > 0 && (unsure <= agreement / 4 * std::abs(change) || unsure <= 1e-6 * step * size))
            found[k] = change / (2 * step * size);
    }
    return found;
}

bool agree(const std::optional<double>& x, const std::optional<double>& y) {
    return x && y && std::abs(*x - *y) <= agreement * std::max({std::abs(*x), std::abs(*y), 1e-3});
}

} // namespace

nlohmann::json::json_pointer place_of(const std::string& key, const nlohmann::json& scene) {
    const std::size_t slash = key.find('/');
    const std::string name = key.substr(0, slash);
    const auto refuse = [&](const std::string& rule) { throw InputError("vary", rule, key); };
    if (!scene.contains(name)) refuse("must be a key of the scene that has a number");
    std::string path = pointer_step(name);
    const Json& value = scene.at(name);
    if (value.is_array() && !value.empty() && value.front().is_array())
        refuse("must not name an entry of a matrix, because one changes with its mirror image");
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
    if (!number_in(scene.at(pointer))) refuse("must be a key of the scene that has a number");
    return pointer;
}

AmplitudesOfScene amplitudes_of(const Json& scene, std::optional<Mass> mass, double damping_tolerance, Effort* effort) {
    const std::string text = scene.dump();
    SceneSource source = scene_source(SceneText{text});
    if (damping_tolerance > 0) source = with_damping_tolerance(source, damping_tolerance);
    const Scene<double>& s = source->in_double();
    Question question{Asked::amplitude, std::nullopt};
    question.mass = mass;
    const SolvePoint at{frequency_ratio_of(s), friction_ratio_of(s), &source, effort};
    const AnswerOrNone answer = decide(prepare(source, question), at, question);
    if (!answer.is_answered()) return {{}, answer.refused};
    double unit = 1;
    if (s.units)
        if (const std::optional<double> P = s.units->force_at(angular_frequency(*s.units, at.r)))
            unit = displacement_unit(*s.units, *P);
    AmplitudesOfScene found;
    const double rounding = 4 * std::numeric_limits<double>::epsilon();
    for (const SolvedMass& m : answer.solution.masses) {
        const Certified& a = m.amplitude;
        found.amplitudes.push_back({a.value * unit, (a.error + rounding * a.value) * unit, {}, a.proved});
    }
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

std::optional<SensitiveMode> sensitive_mode(const SceneSource& source) {
    constexpr double noticeable = 1e-3, unit = std::numeric_limits<double>::epsilon();
    const System<double>& s = source->in_double().system;
    const bool damped = std::ranges::all_of(s.damping_ratios, [](double zeta) { return zeta > unit / noticeable; });
    if (s.damping_matrix.size() > 0 ? !s.damping_matrix.isZero(0) : damped) return std::nullopt;
    const ModesInDouble found = modes_in_double(source);
    const ModalBasis<Bounded<double>>& modes = *found.basis;
    const LoadRows load = load_rows(s);
    for (std::size_t i = 0; i < modes.r_n.size(); ++i) {
        const auto excites = [&](Mass row) {
            const Bounded<double>& p = modes.phi(static_cast<Eigen::Index>(row.index), static_cast<Eigen::Index>(i));
            return std::abs(p.x) > p.e;
        };
        const double R = frequency_ratio_of(source->in_double()) / modes.r_n[i].x, zeta = modes.zeta[i].x;
        const double apart = std::abs(R - 1) + unit, change = unit * apart / (apart * apart + zeta * zeta);
        if (change > noticeable && (excites(load.re) || (load.im && excites(*load.im)))) return SensitiveMode{i, R, change};
    }
    return std::nullopt;
}

std::string warning_of(const SceneSource& source, const Solution& solution) {
    if (solution.regime.regime == Regime::permanent_sticking) return {};
    const std::optional<SensitiveMode> mode = sensitive_mode(source);
    if (!mode) return {};
    return "a unit in the last place of the frequency, of a mass or of a stiffness changes amplitudes by some " +
           number_in_digits(mode->change, 2) + " of themselves: mode " + std::to_string(mode->mode + 1) +
           " has next to no damping, and R = " + number_to_text(mode->R);
}

} // namespace denhartog
