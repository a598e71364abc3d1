#include <algorithm>
#include <cmath>

#include "conformance/diagnosis/explanations.hpp"
#include "conformance/grade.hpp"
#include "conformance/mistakes/mistake_definition.hpp"
#include "conformance/plain/closed_form.hpp"
#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

constexpr int most_periods = 200;
constexpr std::size_t most_probed = 9, first_probed = 3;

// Distance of a wrong answer from the motion from rest, for each of its periods; infinite for an answer that is not of a period.
std::vector<double> distances(const Judged& one) {
    const Quantity& asked = quantity(one.vector->question.quantity);
    const double from_truth = difference(asked, one.given.numbers, one.vector->nearest).size;
    std::vector<double> all;
    for (const std::optional<Value>& shown : answers_of_transient(one.vector->question, 1, most_periods)) {
        const double apart = shown ? difference(asked, one.given.numbers, shown->numbers).size : INFINITY;
        const bool agrees =
            shown && apart <= of_steps_in_time * size_of(shown->numbers) && apart <= nearer_than_truth * from_truth;
        all.push_back(agrees ? apart / size_of(shown->numbers) : INFINITY);
    }
    return all;
}

std::vector<const Judged*> probes(std::span<const Judged> judged) {
    std::vector<const Judged*> all;
    for (const Judged& one : judged) {
        const Vector& v = *one.vector;
        if (is_wrong_value(one.verdict) && asks_for(v.question, {"amplitude", "motion_under_force"}) &&
            one.given.numbers.size() == v.nearest.size() && is_of_the_paper(v.question))
            all.push_back(&one);
    }
    return spread(all, most_probed);
}

struct Shown {
    int period = 0;
    std::size_t agreeing = 0;
    double distance = 0; // the sum of the digits that are missing, negative
};

// The period that most answers show; of two the one to which they are nearer.
Shown shown_by(const std::vector<std::vector<double>>& all) {
    Shown best;
    for (int n = 1; n <= most_periods; ++n) {
        Shown of_n{n, 0, 0};
        for (const std::vector<double>& of_one : all) {
            const double apart = of_one[static_cast<std::size_t>(n - 1)];
            if (!std::isfinite(apart)) continue;
            ++of_n.agreeing;
            of_n.distance += elementary::log10(std::max(apart, 1e-16));
        }
        if (of_n.agreeing > best.agreeing || (of_n.agreeing == best.agreeing && of_n.distance < best.distance)) best = of_n;
    }
    return best;
}

} // namespace

std::optional<Fitted> fitted_transient(std::span<const Judged> judged) {
    const std::vector<const Judged*> some = probes(judged);
    if (some.size() < least_agreeing) return std::nullopt;
    std::vector<std::vector<double>> all;
    for (const Judged* one : some) {
        if (all.size() == first_probed && shown_by(all).agreeing == 0) return std::nullopt;
        try {
            all.push_back(distances(*one));
        } catch (const NoPlainAnswer&) { // a motion that is none shows nothing
        }
    }
    const Shown shown = shown_by(all);
    if (shown.agreeing < least_agreeing || 2 * shown.agreeing < all.size()) return std::nullopt; // of 200 some agree by chance
    return Fitted{"transient", "read off in period " + std::to_string(shown.period) + " from rest",
                  [period = shown.period](const ProtocolQuestion& q) {
                      if (!asks_for(q, {"amplitude", "phase", "motion_under_force"})) return std::optional<Value>();
                      return answers_of_transient(q, period, period).front();
                  }};
}

} // namespace denhartog::conformance
