#include "conformance/grade.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>

#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/legible.hpp"

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

// Value of the closed form beyond the boundary, as it is computed by whoever forgets it; none where the quantity is not of the
// steady motion.
std::optional<Value> closed_form_beyond_boundary(const ProtocolQuestion& q) {
    if (!asks_for(q, {"amplitude", "phase", "amplitude_monoharmonic", "phase_monoharmonic", "initial_displacement",
                      "initial_velocity", "displacement", "motion_under_force"}))
        return std::nullopt;
    Choices c;
    c.beyond_the_boundary = true;
    return plain_answer(q, c);
}

// Whether a wrong answer is the one of another regime, and how that shows.
std::string other_regime(const Vector& v, const Value& given) {
    if (v.regime != "stick_slip" && v.regime != "permanent_sticking") return "";
    const Quantity& asked = quantity(v.question.quantity);
    const bool no_stop =
        asked.shape == Shape::durations ? given.numbers.empty() : asked.name == "stops_per_period" && size_of(given.numbers) == 0;
    if (no_stop) return "no stop, but the regime is " + v.regime;
    const std::optional<Value> beyond = closed_form_beyond_boundary(v.question);
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
    const std::string regime = other_regime(v, judged.given);
    if (!regime.empty()) {
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
    if (const auto* skipped = std::get_if<Skipped>(&answer)) {
        judged.verdict = Verdict::skipped;
        judged.reason = legible(skipped->reason);
        return judged;
    }
    if (const auto* rejected = std::get_if<Rejected>(&answer)) {
        judged.verdict = to_be_rejected ? Verdict::rejected : Verdict::wrong;
        judged.reason = (to_be_rejected ? "" : "it was rejected, but keeps all rules: ") + legible(rejected->reason);
        return judged;
    }
    if (const auto* unusable = std::get_if<Unusable>(&answer)) {
        judged.verdict = to_be_rejected ? Verdict::not_rejected : Verdict::wrong;
        judged.reason = legible(unusable->reason);
        return judged;
    }
    judged.given = std::get<Value>(answer);
    judged.answered = true;
    if (to_be_rejected) {
        judged.verdict = Verdict::not_rejected;
        judged.reason = "it was answered, but breaks a rule: " + v.reject;
        return judged;
    }
    return v.word.empty() ? graded_numbers(std::move(judged), v) : graded_word(std::move(judged), v);
}

} // namespace denhartog::conformance
