#include "derivation/observations/observation.hpp"

#include <cstdio>
#include <utility>

namespace denhartog::derivation {

Claim observation(std::string id, std::vector<std::string> equations, std::string title, std::vector<std::string> assumptions,
                  std::function<Outcome()> check) {
    return {.id = std::move(id),
            .equations = std::move(equations),
            .role = Role::observation,
            .title = std::move(title),
            .assumptions = std::move(assumptions),
            .check = std::move(check)};
}

void refute_above(Outcome& outcome, double found, Threshold threshold) {
    if (found > threshold.taken) outcome.verdict = Verdict::refuted;
    threshold.turns = found;
    outcome.thresholds.push_back(std::move(threshold));
}

void refute_below(Outcome& outcome, double found, Threshold threshold) {
    if (found < threshold.taken) outcome.verdict = Verdict::refuted;
    threshold.turns = found;
    outcome.thresholds.push_back(std::move(threshold));
}

std::string rounded(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", x);
    return buffer;
}

} // namespace denhartog::derivation
