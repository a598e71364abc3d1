#include "tests/conformance/generator/scene_routes.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/number/errors.hpp"

namespace denhartog::conformance::generator {
namespace {

constexpr double relative_step = 0x1p-36;

} // namespace

std::optional<Regimes> regimes_of(const ProtocolQuestion& scene) {
    ProtocolQuestion q = scene;
    q.beta = 0;
    try {
        const auto route = by_reference<Real50>(q, Regime::continuous);
        Regimes regimes;
        q.quantity = "beta_lim_exact";
        regimes.sliding = route->numbers(q).front();
        q.quantity = "beta_lim_sticking";
        const std::vector<Real50> sticking = route->numbers(q);
        if (!sticking.empty()) regimes.sticking = sticking.front();
        return regimes;
    } catch (const DomainError&) {
        return std::nullopt;
    }
}

bool depends_on_friction(const std::string& quantity) {
    static const char* const names[] = {"amplitude",
                                        "phase",
                                        "amplitude_monoharmonic",
                                        "phase_monoharmonic",
                                        "initial_displacement",
                                        "initial_velocity",
                                        "displacement",
                                        "regime",
                                        "stops_per_period",
                                        "stop_durations",
                                        "rest_interval",
                                        "motion_under_force",
                                        "absolute_amplitude",
                                        "absolute_phase",
                                        "transmissibility"};
    return std::find(std::begin(names), std::end(names), quantity) != std::end(names);
}

std::vector<Neighbour> neighbours_of(const ProtocolQuestion& scene) {
    std::vector<Neighbour> all;
    const auto add = [&](const char* input, auto&& entry) {
        ProtocolQuestion q = scene;
        double& x = entry(q);
        const double before = x;
        if (before == 0) return;
        x = before * (1 + relative_step);
        all.push_back({input, (x - before) / before, q});
    };
    add("r", [](ProtocolQuestion& q) -> double& { return q.r; });
    add("beta", [](ProtocolQuestion& q) -> double& { return q.beta; });
    add("mu", [](ProtocolQuestion& q) -> double& { return q.mu; });
    using List = std::vector<double> ProtocolQuestion::*;
    const auto add_list = [&](const char* input, List list, std::size_t from) {
        for (std::size_t i = from; i < (scene.*list).size(); ++i)
            add(input, [list, i](ProtocolQuestion& q) -> double& { return (q.*list)[i]; });
    };
    add_list("mass_ratios", &ProtocolQuestion::mass_ratios, 1);
    add_list("stiffness_ratios", &ProtocolQuestion::stiffness_ratios, 1);
    add_list("damping_ratios", &ProtocolQuestion::damping_ratios, 0);
    add_list("load", &ProtocolQuestion::loads, 0);
    add_list("load_phases", &ProtocolQuestion::load_phases, 0);
    // Of a matrix both entries of a pair change. Those off the diagonal shrink: a dashpot alone leaves no room for more.
    const auto add_matrix = [&](const char* input, List matrix) {
        const std::size_t N = (scene.*matrix).empty() ? 0 : masses_of(scene);
        for (std::size_t i = 0; i < N; ++i)
            for (std::size_t k = 0; k <= i; ++k) {
                ProtocolQuestion q = scene;
                const double before = (q.*matrix)[i * N + k];
                if (before == 0) continue;
                const double after = before * (k == i ? 1 + relative_step : 1 - relative_step);
                (q.*matrix)[i * N + k] = (q.*matrix)[k * N + i] = after;
                all.push_back({input, (after - before) / before, q});
            }
    };
    add_matrix("mass_matrix", &ProtocolQuestion::mass_matrix);
    add_matrix("stiffness_matrix", &ProtocolQuestion::stiffness_matrix);
    add_matrix("damping_matrix", &ProtocolQuestion::damping_matrix);
    return all;
}

SceneRoutes::SceneRoutes(const ProtocolQuestion& scene, Regime regime)
    : scene_(scene), regime_(regime), neighbours_(neighbours_of(scene)), near_(neighbours_.size()),
      near_orbits_(neighbours_.size()) {}

bool SceneRoutes::is_orbit(const ProtocolQuestion& q) const {
    return regime_ == Regime::stick_slip && depends_on_friction(q.quantity) && q.quantity != "regime";
}

const OrbitSeen& SceneRoutes::seen() {
    if (!seen_) seen_ = orbit_seen(scene_);
    return *seen_;
}

template <>
SceneRoutes::Pair<Real50>& SceneRoutes::pair() {
    return in_50_;
}

template <>
SceneRoutes::Pair<Real100>& SceneRoutes::pair() {
    return in_100_;
}

template <class T>
std::vector<T> SceneRoutes::first(const ProtocolQuestion& q) {
    Pair<T>& p = pair<T>();
    if (is_orbit(q)) {
        if (!p.orbit) p.orbit = by_reference<T>(scene_, regime_, &seen());
        return p.orbit->numbers(q);
    }
    if (!p.first) p.first = by_reference<T>(scene_, regime_);
    return p.first->numbers(q);
}

template <class T>
std::vector<T> SceneRoutes::second(const ProtocolQuestion& q) {
    Pair<T>& p = pair<T>();
    if (is_orbit(q)) {
        if (!p.phases) p.phases = phase_problem<T>(scene_, seen());
        return p.phases->numbers(q);
    }
    if (!p.second) p.second = physical<T>(scene_, regime_);
    return p.second->numbers(q);
}

std::array<std::string, 2> SceneRoutes::names(const ProtocolQuestion& q) const {
    const std::string& name = q.quantity;
    const auto second = [&]() -> std::string {
        if (is_orbit(q)) return "phases as a boundary-value problem";
        if (name == "natural_frequency_ratios" || name == "modal_frequency_ratios" || name == "mode_shape_products")
            return is_of_the_paper(scene_) ? "characteristic polynomial and residues" : "characteristic polynomial";
        if (name == "beta_lim_high_frequency") return "half-periods at high frequency extrapolated";
        if (name == "regime") return "half-period and dense system with the contact held";
        const bool held = regime_ == Regime::permanent_sticking && depends_on_friction(name);
        return held || name == "beta_lim_sticking" ? "dense system with the contact held" : "half-period boundary-value problem";
    };
    return {"reference", second()};
}

std::vector<Real50> SceneRoutes::at_neighbour(std::size_t n, const ProtocolQuestion& q) {
    if (is_orbit(q)) {
        if (!near_orbits_[n]) near_orbits_[n] = phase_problem<Real50>(neighbours_[n].scene, seen());
        return near_orbits_[n]->numbers(q);
    }
    if (!near_[n]) near_[n] = by_reference<Real50>(neighbours_[n].scene, regime_);
    return near_[n]->numbers(q);
}

std::vector<std::pair<std::string, Real50>> SceneRoutes::condition(const ProtocolQuestion& q, const std::vector<Real50>& values,
                                                                   const Real50& scale) {
    using std::abs;
    std::vector<std::pair<std::string, Real50>> all;
    const auto note = [&](const std::string& input, const std::vector<Real50>& changed, double change) {
        Real50 largest(0);
        for (std::size_t i = 0; i < values.size(); ++i) {
            Real50 difference = changed.at(i) - values[i];
            if (quantity(q.quantity).angle) difference = atan2(Real50(sin(difference)), Real50(cos(difference)));
            largest = std::max(largest, Real50(abs(difference)));
        }
        largest /= scale * abs(Real50(change));
        if (largest < Real50("1e-12")) return;
        if (all.empty() || all.back().first != input) all.emplace_back(input, Real50(0));
        all.back().second = std::max(all.back().second, largest);
    };
    for (std::size_t n = 0; n < neighbours_.size(); ++n) {
        const Neighbour& near = neighbours_[n];
        note(near.input, at_neighbour(n, q), near.relative_change);
        if (near.input != "mu" || q.tau == 0) continue; // tau follows mu in the order of the inputs
        ProtocolQuestion later = q;
        later.tau = q.tau * (1 + relative_step);
        note("tau", first<Real50>(later), (later.tau - q.tau) / q.tau);
    }
    return all;
}

template std::vector<Real50> SceneRoutes::first(const ProtocolQuestion&);
template std::vector<Real100> SceneRoutes::first(const ProtocolQuestion&);
template std::vector<Real50> SceneRoutes::second(const ProtocolQuestion&);
template std::vector<Real100> SceneRoutes::second(const ProtocolQuestion&);

} // namespace denhartog::conformance::generator
