// The verdicts and what is counted of them: the scores of each group, with the median and worst number of right digits, the worst
// answers first, and whether an implementation conforms, `conforms`.
#include "conformance/verdict.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include "conformance/mistakes/mistake.hpp"
#include "conformance/plain/closed_form.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

// An answer that is so near the closed form beyond its boundary, relative to that, and nearer to it than to the truth, is it.
constexpr double agreement = 1e-6;

std::string numbers_in_words(std::size_t count) { return count == 1 ? "1 number" : std::to_string(count) + " numbers"; }

// Angles of the protocol's interval differ round the circle, those outside it (degrees, [0, 2 pi)) as they stand.
bool round_the_circle(const Quantity& asked, double given) {
    constexpr double rounding = 1e-9;
    return asked.angle && std::abs(given) <= std::numbers::pi + rounding;
}

Difference worst_of(std::size_t count, const auto& size_of_one) {
    Difference worst;
    for (std::size_t n = 0; n < count; ++n)
        if (const double size = size_of_one(n); size > worst.size) worst = {size, n};
    return worst;
}

// Error against the 40 digits of the vector: the rounding of the nearest double does not count as the answer's.
Difference error_of(const Vector& v, const Quantity& asked, const std::vector<double>& given) {
    if (asked.shape == Shape::samples) return difference(asked, given, v.nearest);
    using Digits = boost::multiprecision::cpp_bin_float_50;
    const Digits turn = 2 * boost::math::constants::pi<Digits>();
    return worst_of(given.size(), [&](std::size_t n) {
        Digits error = given[n] - Digits(v.value[n]);
        if (round_the_circle(asked, given[n])) error -= turn * round(error / turn);
        return std::abs(static_cast<double>(error));
    });
}

Verdict verdict_of(double error, const Tolerance& allowed) {
    if (error <= allowed.pass) return Verdict::pass;
    if (error <= allowed.loose) return Verdict::pass_loose;
    if (error <= allowed.inaccurate) return Verdict::inaccurate;
    return Verdict::wrong;
}

// Sign that a wrong answer is the one of another regime, in words: no stop, or the closed form beyond the boundary, as a program
// gives it that does not ask for the regime. Empty if there is none.
std::string other_regime(const Vector& v, const Value& given) {
    if (v.regime != "stick_slip" && v.regime != "permanent_sticking") return "";
    const Quantity& asked = quantity(v.question.quantity);
    const bool no_stop =
        asked.shape == Shape::durations ? given.numbers.empty() : asked.name == "stops_per_period" && size_of(given.numbers) == 0;
    if (no_stop) return "no stop, but the regime is " + v.regime;
    if (!asks_for(v.question, {"amplitude", "phase", "amplitude_monoharmonic", "phase_monoharmonic", "initial_displacement",
                               "initial_velocity", "displacement", "motion_under_force"}))
        return "";
    const std::optional<Value> beyond = plain_answer(v.question, Choices{.beyond_the_boundary = true});
    if (!beyond || !agrees(v, given, *beyond, agreement)) return "";
    return "the closed form of continuous sliding, but the regime is " + v.regime;
}

// The verdict on an answer to a question that keeps all rules, with the reason.
void judge_value(Judged& judged, const Vector& v) {
    const Quantity& asked = quantity(v.question.quantity);
    const auto& [numbers, word] = judged.given;
    judged.verdict = Verdict::wrong;
    if (!v.word.empty()) {
        judged.verdict = word == v.word ? Verdict::pass : word.empty() ? Verdict::wrong : Verdict::wrong_regime;
        if (word != v.word)
            judged.reason =
                word.empty() ? numbers_in_words(numbers.size()) + " in place of a regime" : word + " in place of " + v.word;
        return;
    }
    if (!word.empty()) {
        judged.reason = "a regime in place of numbers";
        return;
    }
    if (numbers.size() != v.value.size()) {
        judged.reason = numbers_in_words(numbers.size()) + " in place of " + std::to_string(v.value.size());
    } else {
        const Difference error = error_of(v, asked, numbers);
        judged.error = error.size / v.scale;
        judged.worst = error.worst;
        judged.verdict = verdict_of(*judged.error, v.tolerance);
    }
    const std::string regime = judged.verdict == Verdict::wrong ? other_regime(v, judged.given) : "";
    if (regime.empty()) return;
    judged.verdict = Verdict::wrong_regime;
    judged.reason = regime;
}

constexpr double share_of_an_event = 0.25;

// Distance of a value to the piecewise linear curve over half a step to either side of a sample.
double distance_in_tube(double value, double before, double at, double after) {
    const double to_the_left = (before + at) / 2, to_the_right = (at + after) / 2;
    const double lowest = std::min({to_the_left, at, to_the_right}), highest = std::max({to_the_left, at, to_the_right});
    return std::max({0.0, lowest - value, value - highest});
}

// Errors of the solvers of each method at everyday settings: half of their answers are within the first number, 99 of 100 within
// the second; ten times as much is the third. `./verify chart` measures that anew and compares (docs/solvers.md).
constexpr Tolerance errors(double of_half, double of_most) { return {of_half, of_most, 10 * of_most}; }

constexpr SolverMethod all_methods[] = {
    {"closed-form", "the closed form in double: the vectors' own tolerances", {}, {}, {}},
    {"event-driven", "integration with events, at tolerances of 1e-6", errors(1e-6, 1e-3), errors(2e-6, 2e-4), errors(2e-6, 5e-5),
     2e-4, true},
    {"time-stepping", "equal steps without events, 1024 a period", errors(5e-6, 1e-3), errors(5e-5, 5e-3), errors(3e-4, 5e-3),
     2e-2, true},
    {"harmonic-balance", "harmonics of friction up to the 51st", errors(2e-4, 5e-3), errors(2e-3, 1e-2), {}, 0, false, false},
};

Tolerance of_kind(const SolverMethod& method, const std::string& kind) {
    if (kind == "displacement") return method.displacement;
    return kind == "phase" ? method.phase : kind == "duration" ? method.duration : Tolerance{};
}

// Name and rank of each verdict, in the order of the enumeration.
constexpr std::array<std::string_view, number_of_verdicts> names{"pass",    "pass-loose",   "inaccurate", "as-printed",
                                                                 "wrong",   "wrong-regime", "rejected",   "not-rejected",
                                                                 "skipped", "crash",        "timeout",    "stall"};
constexpr std::array<int, number_of_verdicts> ranks{0, 1, 2, 4, 4, 4, 0, 4, 3, 5, 5, 5};

int rank_of_tier(const std::string& tier) { return tier == "must" ? 0 : tier == "should" ? 1 : 2; }

} // namespace

Difference curve_deviation(const std::vector<double>& given, const std::vector<double>& reference) {
    const std::size_t n = reference.size();
    const auto x = [&](std::size_t i) { return reference[i % n]; };
    std::vector<double> second(n);
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        second[i] = x(i + 1) - 2 * x(i) + x(i + n - 1);
        largest = std::max(largest, std::abs(second[i]));
    }
    const auto jumps = [&](std::size_t i) { return std::abs(second[(i + 1) % n] - second[i % n]) > share_of_an_event * largest; };
    return worst_of(n, [&](std::size_t i) {
        const bool event = jumps(i) || jumps(i + n - 1);
        return event ? distance_in_tube(given[i], x(i + n - 1), x(i), x(i + 1)) : std::abs(given[i] - reference[i]);
    });
}

double size_of(const std::vector<double>& numbers) {
    double size = 0;
    for (const double x : numbers) size = std::max(size, std::abs(x));
    return size;
}

Difference difference(const Quantity& asked, const std::vector<double>& given, const std::vector<double>& reference) {
    if (asked.shape == Shape::samples) return curve_deviation(given, reference);
    return worst_of(given.size(), [&](std::size_t n) {
        const double apart = given[n] - reference[n];
        return std::abs(round_the_circle(asked, given[n]) ? std::remainder(apart, 2 * std::numbers::pi) : apart);
    });
}

bool agrees(const Vector& v, const Value& given, const Value& other, double near) {
    if (!given.word.empty() || !other.word.empty()) return given.word == other.word;
    if (given.numbers.size() != other.numbers.size()) return false;
    const Quantity& asked = quantity(v.question.quantity);
    const double apart = difference(asked, given.numbers, other.numbers).size;
    const double size = asked.angle ? 1 : size_of(other.numbers);
    if (!(apart <= near * (size > 0 ? size : v.scale))) return false;
    if (given.numbers.size() != v.nearest.size()) return true;
    return apart <= nearer_than_truth * difference(asked, given.numbers, v.nearest).size;
}

Judged grade(const Vector& v, const Answer& answer) {
    Judged judged;
    judged.vector = &v;
    const bool to_be_rejected = !v.reject.empty();
    const auto with = [&](Verdict verdict, const std::string& reason) {
        judged.verdict = verdict;
        judged.reason = reason;
        return judged;
    };
    if (const auto* skipped = std::get_if<Skipped>(&answer)) return with(Verdict::skipped, legible(skipped->reason));
    if (const auto* rejected = std::get_if<Rejected>(&answer))
        return to_be_rejected ? with(Verdict::rejected, legible(rejected->reason))
                              : with(Verdict::wrong, "it was rejected, but keeps all rules: " + legible(rejected->reason));
    if (const auto* unusable = std::get_if<Unusable>(&answer))
        return with(to_be_rejected ? Verdict::not_rejected : Verdict::wrong, legible(unusable->reason));
    judged.given = std::get<Value>(answer);
    judged.answered = true;
    if (to_be_rejected) return with(Verdict::not_rejected, "it was answered, but breaks a rule: " + v.reject);
    judge_value(judged, v);
    return judged;
}

std::span<const SolverMethod> methods() { return all_methods; }

const SolverMethod& method_named(std::string_view name) {
    const auto* const found = std::ranges::find(all_methods, name, &SolverMethod::name);
    if (found != std::end(all_methods)) return *found;
    std::vector<std::string> names;
    for (const SolverMethod& each : all_methods) names.emplace_back(each.name);
    throw InputError("method", "must be one of " + joined(names, ", "), std::string(name));
}

std::string kind_of(const ProtocolQuestion& q) {
    if (q.quantity == "stop_durations") return "duration";
    if (asks_for(q, {"phase", "phase_monoharmonic", "absolute_phase"})) return "phase";
    const bool moves = asks_for(q, {"amplitude", "amplitude_monoharmonic", "motion_under_force", "displacement",
                                    "initial_displacement", "initial_velocity", "absolute_amplitude", "transmissibility"});
    return moves ? "displacement" : "";
}

double condition_of(const Vector& v) {
    double largest = 1;
    for (const auto& [input, number] : v.condition) largest = std::max(largest, number);
    return largest;
}

std::string excuse_for(const Vector& v, const SolverMethod& method) {
    if (kind_of(v.question).empty() && !asks_for(v.question, {"regime", "stops_per_period"})) return "";
    const std::vector<double>& zeta = v.question.damping_ratios;
    if (method.settles && std::find(zeta.begin(), zeta.end(), 0.0) != zeta.end())
        return "without damping the transient never ends";
    if (v.margin && *v.margin < method.margin)
        return "beta is nearer than " + number_in_digits(method.margin, 2) + " to a boundary of regimes";
    if (!method.rests && v.regime == "stick_slip" && asks_for(v.question, {"phase"}))
        return "the phase may be that of the start of a rest";
    return "";
}

void widen(Vector& v, const SolverMethod& method) {
    constexpr double largest = 0.1; // beyond, nothing is right
    const Tolerance least = of_kind(method, kind_of(v.question));
    const double condition = condition_of(v);
    const auto wider = [&](double own, double of_method) { return std::max(own, std::min(largest, of_method * condition)); };
    v.tolerance = {wider(v.tolerance.pass, least.pass), wider(v.tolerance.loose, least.loose),
                   wider(v.tolerance.inaccurate, least.inaccurate)};
}

void excuse(Judged& judged, const SolverMethod& method) {
    if (!is_wrong_value(judged.verdict)) return;
    const std::string reason = excuse_for(*judged.vector, method);
    if (reason.empty()) return;
    judged.verdict = Verdict::skipped;
    judged.reason = "not judged by the method " + std::string(method.name) + ": " + reason;
}

std::string_view name(Verdict verdict) { return names.at(static_cast<std::size_t>(verdict)); }

std::optional<Verdict> verdict_named(std::string_view name) {
    const auto* const found = std::ranges::find(names, name);
    return found != names.end() ? std::optional(static_cast<Verdict>(found - names.begin())) : std::nullopt;
}

int badness(Verdict verdict) { return ranks.at(static_cast<std::size_t>(verdict)); }

bool is_wrong_value(Verdict verdict) {
    return badness(verdict) == 2 || (badness(verdict) == 4 && verdict != Verdict::not_rejected);
}

double digits(double error) {
    constexpr double most = 17;
    if (!(error > 0)) return most;
    return error < 1 ? std::min(-elementary::log10(error), most) : 0;
}

Counts counts_of(std::span<const Judged> judged) {
    Counts counts{};
    for (const Judged& one : judged) ++counts[static_cast<std::size_t>(one.verdict)];
    return counts;
}

std::vector<Score> scores(std::span<const Judged> judged) {
    std::map<std::pair<int, std::string>, std::vector<Judged>> parts;
    for (const Judged& one : judged) parts[{rank_of_tier(one.vector->tier), one.vector->group}].push_back(one);
    std::vector<Score> all;
    for (const auto& [key, part] : parts) {
        Score score{part.front().vector->tier, key.second, part.size(), counts_of(part), std::nullopt, std::nullopt};
        std::vector<double> of_answers;
        for (const Judged& one : part)
            if (one.error) of_answers.push_back(digits(*one.error));
        if (!of_answers.empty()) {
            score.median_digits = boost::math::statistics::median(of_answers);
            score.worst_digits = std::ranges::min(of_answers);
        }
        all.push_back(std::move(score));
    }
    return all;
}

std::optional<double> error_over_tolerance(const Judged& judged) {
    if (!judged.error) return std::nullopt;
    if (judged.vector->tolerance.pass > 0) return *judged.error / judged.vector->tolerance.pass;
    return *judged.error > 0 ? std::numeric_limits<double>::infinity() : 0;
}

std::vector<const Judged*> worst_first(std::span<const Judged> judged) {
    std::vector<const Judged*> worst;
    for (const Judged& one : judged)
        if (!is_right(one.verdict) && one.verdict != Verdict::skipped) worst.push_back(&one);
    const auto order = [](const Judged* one) {
        const double size = error_over_tolerance(*one).value_or(std::numeric_limits<double>::infinity());
        return std::tuple(!is_broken(one->verdict), !one->vector->word.empty(), place_in_chain(one->vector->question),
                          -badness(one->verdict), -size);
    };
    std::ranges::stable_sort(worst, {}, order);
    return worst;
}

bool conforms(std::span<const Judged> judged, const std::set<std::string>& needed) {
    bool anything = false;
    for (const Judged& one : judged) {
        const bool skipped = one.verdict == Verdict::skipped;
        anything = anything || !skipped;
        if (one.vector->tier == "must" && !skipped && !is_right(one.verdict)) return false;
        if (skipped && !one.answered && needed.contains(one.vector->question.quantity)) return false;
    }
    return anything;
}

} // namespace denhartog::conformance
