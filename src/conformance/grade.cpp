// The verdict on one answer: its error against the 40 digits of the vector, compared with its tolerance. Read `grade` first. A
// method that steps in time gets wider tolerances, `widen`, and is not judged if the question is beyond it, `excuse`.
#include "conformance/grade.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>

#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"

namespace denhartog::conformance {
namespace {

// An answer agrees with the closed form beyond its boundary where it is so near, relative to the closed form's size.
constexpr double agreement = 1e-6;

std::string numbers_in_words(std::size_t count) { return count == 1 ? "1 number" : std::to_string(count) + " numbers"; }

// Angles of the protocol's interval differ round the circle, those outside it (degrees, [0, 2 pi)) as they stand.
bool round_the_circle(const Quantity& asked, double given) {
    constexpr double rounding = 1e-9;
    return asked.angle && std::abs(given) <= std::numbers::pi + rounding;
}

// Error against the 40 digits of the vector: the rounding of the nearest double does not count as the answer's.
Difference error_of(const Vector& v, const Quantity& asked, const std::vector<double>& given) {
    if (asked.shape == Shape::samples) return difference(asked, given, v.nearest);
    using Digits = boost::multiprecision::cpp_bin_float_50;
    const Digits turn = 2 * boost::math::constants::pi<Digits>();
    Difference worst;
    for (std::size_t n = 0; n < given.size(); ++n) {
        Digits error = given[n] - Digits(v.value[n]);
        if (round_the_circle(asked, given[n])) error -= turn * round(error / turn);
        const double size = std::abs(static_cast<double>(error));
        if (size > worst.size) worst = {size, n};
    }
    return worst;
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
    if (!beyond || beyond->numbers.size() != given.numbers.size()) return "";
    const double size = asked.angle ? 1 : size_of(beyond->numbers);
    if (!(difference(asked, given.numbers, beyond->numbers).size <= agreement * size)) return "";
    return "the closed form of continuous sliding, but the regime is " + v.regime;
}

Judged graded_numbers(Judged judged, const Vector& v) {
    const Quantity& asked = quantity(v.question.quantity);
    const std::vector<double>& given = judged.given.numbers;
    judged.verdict = Verdict::wrong;
    if (!judged.given.word.empty()) {
        judged.reason = "a regime in place of numbers";
    } else if (given.size() != v.value.size()) {
        judged.reason = numbers_in_words(given.size()) + " in place of " + std::to_string(v.value.size());
    } else {
        const Difference error = error_of(v, asked, given);
        judged.error = error.size / v.scale;
        judged.worst = error.worst;
        judged.verdict = verdict_of(*judged.error, v.tolerance);
    }
    if (judged.verdict != Verdict::wrong || !judged.given.word.empty()) return judged;
    if (const std::string regime = other_regime(v, judged.given); !regime.empty()) {
        judged.verdict = Verdict::wrong_regime;
        judged.reason = regime;
    }
    return judged;
}

Judged graded_word(Judged judged, const Vector& v) {
    if (judged.given.word.empty()) {
        judged.verdict = Verdict::wrong;
        judged.reason = numbers_in_words(judged.given.numbers.size()) + " in place of a regime";
    } else if (judged.given.word == v.word) {
        judged.verdict = Verdict::pass;
    } else {
        judged.verdict = Verdict::wrong_regime;
        judged.reason = judged.given.word + " in place of " + v.word;
    }
    return judged;
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
constexpr SolverMethod all_methods[] = {
    {"closed-form", "the closed form in double: the vectors' own tolerances", {}, {}, {}},
    {"event-driven",
     "integration with events, at tolerances of 1e-6",
     {1e-6, 1e-3, 1e-2},
     {2e-6, 2e-4, 2e-3},
     {2e-6, 5e-5, 5e-4},
     2e-4,
     true},
    {"time-stepping",
     "equal steps without events, 1024 a period",
     {5e-6, 1e-3, 1e-2},
     {5e-5, 5e-3, 5e-2},
     {2e-4, 5e-3, 5e-2},
     2e-2,
     true},
    {"harmonic-balance", "harmonics of friction up to the 51st", {2e-4, 5e-3, 5e-2}, {2e-3, 1e-2, 1e-1}, {}, 0, false, false},
};

Tolerance of_kind(const SolverMethod& method, const std::string& kind) {
    if (kind == "displacement") return method.displacement;
    if (kind == "phase") return method.phase;
    return kind == "duration" ? method.duration : Tolerance{};
}

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
    Difference worst;
    for (std::size_t i = 0; i < n; ++i) {
        const bool event = jumps(i) || jumps(i + n - 1);
        const double deviation =
            event ? distance_in_tube(given[i], x(i + n - 1), x(i), x(i + 1)) : std::abs(given[i] - reference[i]);
        if (deviation > worst.size) worst = {deviation, i};
    }
    return worst;
}

double size_of(const std::vector<double>& numbers) {
    double size = 0;
    for (const double x : numbers) size = std::max(size, std::abs(x));
    return size;
}

Difference difference(const Quantity& asked, const std::vector<double>& given, const std::vector<double>& reference) {
    if (asked.shape == Shape::samples) return curve_deviation(given, reference);
    Difference worst;
    for (std::size_t n = 0; n < given.size(); ++n) {
        const double apart = given[n] - reference[n];
        const double size = std::abs(round_the_circle(asked, given[n]) ? std::remainder(apart, 2 * std::numbers::pi) : apart);
        if (size > worst.size) worst = {size, n};
    }
    return worst;
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
    return v.word.empty() ? graded_numbers(std::move(judged), v) : graded_word(std::move(judged), v);
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

} // namespace denhartog::conformance
