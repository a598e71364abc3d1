#include "derivation/observations/sliding_scenes.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/modal_coordinate.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog::derivation {

namespace {

/// Adds the scene at a friction ratio, or at a fraction of the boundary; passes over what does not slide.
void add(std::vector<SlidingScene>& list, const std::string& name, bool of_the_paper, const Scene<double>& scene,
         double fraction) {
    try {
        ModalBasis<double> basis = modal_basis(scene.system);
        ModeSums<double> sums = mode_sums(basis, scene.system.contact, scene.system.load, *scene.r);
        Boundary<double> limit = boundary(sums, scene.mu);
        const double beta = scene.beta ? *scene.beta : friction_ratio_at(fraction, limit.exact);
        if (!(beta > 0 && beta < limit.exact)) return;
        SteadyState<double> state = steady_state(sums, limit, beta);
        list.push_back(
            {name, of_the_paper, scene.mu, scene.system, std::move(basis), std::move(sums), std::move(limit), std::move(state)});
    } catch (const DomainError&) { // a pole of (23), (28) or (29) without damping
    }
}

} // namespace

const std::vector<SlidingScene>& sliding_scenes() {
    static const std::vector<SlidingScene> scenes = [] {
        std::vector<SlidingScene> list;
        for (const NamedScene<double>& named : paper_scenes<double>()) add(list, named.name, true, named.scene, 0);
        for (const RandomScene<double>& random : random_scenes<double>(seed_of_scenes))
            add(list, random.name, false, random.scene, random.fraction_of_limit);
        return list;
    }();
    return scenes;
}

ModeInScene<double> mode_of(const SlidingScene& scene, std::size_t i) {
    const ModeSums<double>& s = scene.sums;
    return {s.R[i], s.zeta[i], mode_shapes_at(s, s.contact)[i], mode_shapes_at(s, s.load)[i]};
}

InitialValues<double> start_of_mode(const SlidingScene& scene, std::size_t i) {
    const ModeInScene<double> m = mode_of(scene, i);
    const double beta = scene.state.beta;
    return {
        m.psi_li * m.R * m.R * times_cosine(scene.sums.v[i], scene.state.phi_j) - m.psi_ji * m.R * m.R * scene.sums.g[i] * beta,
        -m.psi_li * m.R * m.R * times_sine(scene.sums.v[i], scene.state.phi_j) - m.psi_ji * m.R * m.R * scene.sums.u[i] * beta};
}

double limit_with_sum(const SlidingScene& scene, double S) {
    const ModeSums<double>& m = scene.sums;
    const std::size_t j = m.contact.index;
    return paper::friction_ratio_limit(m.V[j], m.U[j],
                                       std::max(S, paper::static_friction_demand(m.H_j, scene.mu, m.sum_of_squares)));
}

bool every_mode_meets_63(const SlidingScene& scene, double beta) {
    SlidingScene at = scene;
    const ModeSums<double>& m = scene.sums;
    const std::size_t j = m.contact.index;
    at.state.beta = beta;
    at.state.phi_j = paper::phase_of_contact(m.V[j], m.U[j], beta);
    for (std::size_t i = 0; i < m.R.size(); ++i) {
        const ModeInScene<double> mode = mode_of(at, i);
        const double load = paper::modal_contact_load_by_functions(mode, start_of_mode(at, i).eta_0, m.u[i], m.g[i], beta);
        if (std::abs(load) <= std::abs(mode.psi_ji) * scene.mu * beta) return false;
    }
    return true;
}

double printed_sum_of_maxima(const SlidingScene& scene) {
    const ModeSums<double>& m = scene.sums;
    double sum = 0;
    for (std::size_t i = 0; i < m.R.size(); ++i) {
        const auto of_57 = [&](double tau) { return as_printed::s_d_integrand(tau, m.R[i], m.zeta[i], m.u[i], m.g[i]); };
        const double at_end = 1e-9;
        double largest = -INFINITY;
        for (const double tau : {at_end, pi<double>() - at_end})
            if (of_57(tau) * std::sin(tau) > 1e-6) return INFINITY;
        for (int n = 1; n < 1000; ++n) largest = std::max(largest, of_57(pi<double>() * n / 1000));
        sum += std::pow(mode_of(scene, i).psi_ji, 2) * largest;
    }
    return sum;
}

} // namespace denhartog::derivation
