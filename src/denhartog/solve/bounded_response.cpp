#include "denhartog/solve/bounded_response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/sliding/chain_sums.hpp"

namespace denhartog {
namespace {

// A comparison with what is no number is false, and the larger of two would drop it: such an error is unbounded.
double at_worst(double error) { return error >= 0 ? error : std::numeric_limits<double>::infinity(); }

// Twice what separates a number from the bounded one and that one from the truth: the instants of maxima are not followed.
double error_of(double x, const Bounded& bounded) { return at_worst(2 * (std::abs(x - bounded.x) + bounded.e)); }

double error_of_phase(double phase, const Bounded& bounded) {
    return at_worst(2 * (std::abs(wrapped(phase - bounded.x)) + bounded.e));
}

double relative(double error, double size) { return error == 0 ? 0 : size > 0 ? at_worst(error / size) : 1; }

void take_values(Boundary<double>& b, const Boundary<Bounded>& bounded) {
    b.exact = bounded.exact.x;
    b.paper = bounded.paper.x;
    b.approximate = bounded.approximate.x;
    if (b.sticking && bounded.sticking) b.sticking = bounded.sticking->x;
}

void bound_boundary(BoundedResponse& all, const Boundary<Bounded>& bounded, BoundaryError<double>& error) {
    const Boundary<double>& b = all.response.boundary;
    error = {error_of(b.exact, bounded.exact), 0};
    all.relative = std::max({relative(error.exact, b.exact), relative(error_of(b.paper, bounded.paper), b.paper),
                             relative(error_of(b.approximate, bounded.approximate), b.approximate)});
    if (b.sticking.has_value() != bounded.sticking.has_value()) all.relative = 1;
    if (!b.sticking || !bounded.sticking) return;
    error.sticking = error_of(*b.sticking, *bounded.sticking);
    all.relative = std::max(all.relative, relative(error.sticking, *b.sticking));
}

void bound_masses(BoundedResponse& all, const SteadyState<Bounded>& bounded, std::optional<Mass> only) {
    std::vector<MassResponse<double>>& masses = all.response.steady_state->masses;
    double largest = 0;
    for (const MassResponse<double>& m : masses) largest = std::max(largest, m.amplitude);
    for (std::size_t k = 0; k < masses.size(); ++k) {
        MassResponse<double>& m = masses[k];
        const MassResponse<Bounded>& b = bounded.masses[k];
        m.error_bound = std::max({error_of(m.x0, b.x0), error_of(m.v0, b.v0), error_of(m.amplitude, b.amplitude),
                                  error_of(m.amplitude_monoharmonic, b.amplitude_monoharmonic)});
        all.phase_error.push_back(
            std::max(error_of_phase(m.phase, b.phase), error_of_phase(m.phase_monoharmonic, b.phase_monoharmonic)));
        if (only && k != only->index) continue;
        if (!only && m.amplitude <= m.error_bound && m.error_bound <= largest * std::numeric_limits<double>::epsilon() * 1024)
            continue; // a mass that does not move
        all.relative = std::max({all.relative, relative(m.error_bound, m.amplitude), all.phase_error.back()});
    }
}

} // namespace

BoundedResponse bounded_response(const Scene<double>& scene, BoundedModes& modes, bool with_motion, std::optional<Mass> only) {
    const Mass contact = scene.system.contact;
    const Bounded beta = as_input(*scene.beta), mu = as_input(scene.mu);
    const ModeSums<Bounded> bounded = bounded_sums(scene.system, modes, Inputs::rounded);
    const ModeSums<double> sums = values_of(bounded);
    BoundedResponse all{{*scene.r, scene.mu, scene.beta, contact, boundary(sums, scene.mu), std::nullopt, std::nullopt}, 0, {}};
    Response<double>& response = all.response;
    std::vector<Bounded> instants(response.boundary.instants.begin(), response.boundary.instants.end());
    BoundaryError<double> error{};
    const Boundary<Bounded> limits = boundary_at(bounded, mu, Bounded(response.boundary.instant), instants);
    take_values(response.boundary, limits); // the search above may take V_dj for zero by the size of its terms
    bound_boundary(all, limits, error);
    response.regime = regime_at(response.boundary, *scene.beta, error);
    if (response.regime->regime != Regime::continuous || !with_motion) return all;
    response.steady_state = steady_state(sums, response.boundary, *scene.beta, only);
    instants.clear();
    for (const MassResponse<double>& m : response.steady_state->masses) instants.emplace_back(m.instant);
    bound_masses(all, steady_state_at(bounded, beta, instants, only), only);
    return all;
}

} // namespace denhartog
