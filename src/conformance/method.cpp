#include "conformance/method.hpp"

#include <algorithm>
#include <string>

#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"

namespace denhartog::conformance {
namespace {

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

std::span<const SolverMethod> methods() { return all_methods; }

const SolverMethod& method_named(std::string_view name) {
    const auto* const found = std::ranges::find(all_methods, name, &SolverMethod::name);
    if (found != std::end(all_methods)) return *found;
    std::string names;
    for (const SolverMethod& each : all_methods) names += (names.empty() ? "" : ", ") + std::string(each.name);
    throw InputError("method", "must be one of " + names, std::string(name));
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

double least_agreement(const SolverMethod& method) { return method.displacement.loose; }

} // namespace denhartog::conformance
