#include "tests/conformance/generator/scene_routes.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/number/errors.hpp"

namespace denhartog::conformance::generator {
namespace {

constexpr double relative_step = 0x1p-36;

} // namespace

std::optional<Regimes> regimes_of(const Question& scene) {
    Question q = scene;
    q.beta = 0;
    try {
        const auto route = closed_form<Real50>(q, Regime::continuous);
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
    static const char* const names[] = {
        "amplitude",    "phase",  "amplitude_monoharmonic", "phase_monoharmonic", "initial_displacement", "initial_velocity",
        "displacement", "regime", "stops_per_period",       "stop_durations",     "rest_interval",        "motion_under_force"};
    return std::find(std::begin(names), std::end(names), quantity) != std::end(names);
}

std::vector<Neighbour> neighbours_of(const Question& scene) {
    std::vector<Neighbour> all;
    const auto add = [&](const char* input, auto&& entry) {
        Question q = scene;
        double& x = entry(q);
        const double before = x;
        if (before == 0) return;
        x = before * (1 + relative_step);
        all.push_back({input, (x - before) / before, q});
    };
    add("r", [](Question& q) -> double& { return q.r; });
    add("beta", [](Question& q) -> double& { return q.beta; });
    add("mu", [](Question& q) -> double& { return q.mu; });
    const std::size_t N = scene.mass_ratios.size();
    for (std::size_t i = 1; i < N; ++i) add("mass_ratios", [i](Question& q) -> double& { return q.mass_ratios[i]; });
    for (std::size_t i = 1; i < N; ++i) add("stiffness_ratios", [i](Question& q) -> double& { return q.stiffness_ratios[i]; });
    for (std::size_t i = 0; i < N; ++i) add("damping_ratios", [i](Question& q) -> double& { return q.damping_ratios[i]; });
    return all;
}

SceneRoutes::SceneRoutes(const Question& scene, Regime regime)
    : scene_(scene), regime_(regime), neighbours_(neighbours_of(scene)), near_(neighbours_.size()),
      near_orbits_(neighbours_.size()) {}

bool SceneRoutes::is_orbit(const Question& q) const {
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
std::vector<T> SceneRoutes::first(const Question& q) {
    Pair<T>& p = pair<T>();
    if (is_orbit(q)) {
        if (!p.orbit) p.orbit = exact_orbit<T>(scene_, seen());
        return p.orbit->numbers(q);
    }
    if (!p.first) p.first = closed_form<T>(scene_, regime_);
    return p.first->numbers(q);
}

template <class T>
std::vector<T> SceneRoutes::second(const Question& q) {
    Pair<T>& p = pair<T>();
    if (is_orbit(q)) {
        if (!p.phases) p.phases = phase_problem<T>(scene_, seen());
        return p.phases->numbers(q);
    }
    if (!p.second) p.second = physical<T>(scene_, regime_);
    return p.second->numbers(q);
}

std::array<std::string, 2> SceneRoutes::names(const Question& q) const {
    const std::string& name = q.quantity;
    if (is_orbit(q)) return {"Newton on the exact solver", "phases as a boundary-value problem"};
    if (name == "natural_frequency_ratios" || name == "modal_frequency_ratios" || name == "mode_shape_products")
        return {"singular values of the chain", "characteristic polynomial and residues"};
    if (name == "beta_lim_high_frequency") return {"closed form", "half-periods at high frequency extrapolated"};
    if (name == "beta_lim_sticking") return {"closed form", "dense system with the contact held"};
    if (name == "regime") return {"closed form of both boundaries", "half-period and dense system with the contact held"};
    if (regime_ == Regime::permanent_sticking && depends_on_friction(name))
        return {"modes of the stuck system", "dense system with the contact held"};
    return {"closed form", "half-period boundary-value problem"};
}

std::vector<Real50> SceneRoutes::at_neighbour(std::size_t n, const Question& q) {
    if (is_orbit(q)) {
        if (!near_orbits_[n]) near_orbits_[n] = phase_problem<Real50>(neighbours_[n].scene, seen());
        return near_orbits_[n]->numbers(q);
    }
    if (!near_[n]) near_[n] = closed_form<Real50>(neighbours_[n].scene, regime_, in_50_.first.get());
    return near_[n]->numbers(q);
}

std::vector<std::pair<std::string, Real50>> SceneRoutes::condition(const Question& q, const std::vector<Real50>& values,
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
        Question later = q;
        later.tau = q.tau * (1 + relative_step);
        note("tau", first<Real50>(later), (later.tau - q.tau) / q.tau);
    }
    return all;
}

template std::vector<Real50> SceneRoutes::first(const Question&);
template std::vector<Real100> SceneRoutes::first(const Question&);
template std::vector<Real50> SceneRoutes::second(const Question&);
template std::vector<Real100> SceneRoutes::second(const Question&);

} // namespace denhartog::conformance::generator
