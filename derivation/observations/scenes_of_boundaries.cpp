// Boundaries of the regimes and resonances as printed, on the paper's systems and on chains like them.
#include <algorithm>
#include <cmath>

#include "denhartog/evaluation/resonance.hpp"
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "derivation/observations/refutation_scene.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

namespace {

const std::string slides_up_to = "friction ratio up to which the contact slides throughout";

Compared compared_limits(const SlidingScene& s, double printed) {
    return {slides_up_to, printed, s.boundary.exact, s.boundary.exact};
}

Compared sums_of_maxima(const SlidingScene& s) {
    return {"S_dj, what X_j + beta G_j has to exceed over beta", s.boundary.S_paper, s.boundary.S_exact, s.boundary.S_exact};
}

/// The printed expression grows beyond bounds at an end of the half-period: no friction ratio is below the boundary.
Compared limit_with_57(const SlidingScene& s) {
    Compared c = compared_limits(s, limit_with_sum(s, printed_sum_of_maxima(s)));
    c.quantity += ": none, as the printed expression has no maximum";
    return c;
}

/// The expansion as printed close to tau = 0 in place of (72).
Compared limit_with_70(const SlidingScene& s) {
    const double close_to_zero = 1e-6;
    double S = 0;
    for (std::size_t i = 0; i < s.sums.R.size(); ++i)
        S += std::pow(mode_of(s, i).psi_ji, 2) *
             as_printed::s_d_expansion(close_to_zero, s.sums.R[i], s.sums.zeta[i], s.sums.u[i], s.sums.g[i]);
    return compared_limits(s, paper::friction_ratio_limit(s.sums.V[s.sums.contact.index], s.sums.U[s.sums.contact.index], S));
}

/// The first friction ratio at which a mode fails, in steps of 1/1024 of the boundary.
Compared limit_mode_by_mode(const SlidingScene& s) {
    const int steps = 1024;
    int n = 1;
    while (n < steps && every_mode_meets_63(s, s.boundary.exact * n / steps)) ++n;
    return compared_limits(s, s.boundary.exact * n / steps);
}

/// Beyond (68) as printed the load on the contact is said to exceed static friction.
Compared load_beyond_68(const SlidingScene& s, double beta) {
    const ModeSums<double>& m = s.sums;
    const std::size_t j = m.contact.index;
    if (!(beta > paper::friction_ratio_limit(m.V[j], m.U[j], m.H_j - s.mu * m.sum_of_squares)))
        throw std::logic_error("the scene for (68) does not meet it as printed");
    const double X = paper::displacement_transmissibility_of_contact(m.V[j], m.U[j], m.G[j], beta);
    const double needed = s.mu * beta * m.sum_of_squares;
    return {"load on the contact at tau = 0 over gamma_j r^2: what it exceeds as printed, and what it is", needed,
            std::abs(paper::contact_load_at_start(X, m.G[j], m.H_j, beta)), needed};
}

/// A mass at a resonance: (81) or (82) as printed and as it holds.
struct ResonantMass {
    Complex<double> V;
    double U_k, U_j, G, psi_k, psi_j, beta;
};

ResonantMass resonant_mass(const SlidingScene& s, std::size_t k, std::size_t i) {
    const ModeSums<double>& m = s.sums;
    const double psi_k = mode_shapes_at(m, Mass{k})[i], psi_j = mode_shapes_at(m, m.contact)[i],
                 psi_l = mode_shapes_at(m, m.load)[i];
    return {paper::complex_response_at_resonance(psi_k, psi_l, m.zeta[i]),
            m.U[k],
            m.U[m.contact.index],
            evaluation::second_damping_function_at_resonance(psi_k, psi_j, m.zeta[i]),
            psi_k,
            psi_j,
            s.state.beta};
}

Compared amplitude_by_81(const SlidingScene& s) {
    const ResonantMass a = resonant_mass(s, 0, 0);
    const double V = modulus(a.V);
    const double holds = paper::transmissibility_at_resonance(V, a.U_k, a.U_j, a.G, a.psi_k, a.psi_j, a.beta);
    return {"amplitude of mass 1 at the resonance by (81), in units of P / k_1",
            as_printed::transmissibility_at_resonance(V, a.U_k, a.U_j, a.G, a.beta), holds, holds};
}

Compared amplitude_by_82(const SlidingScene& s) {
    const ResonantMass a = resonant_mass(s, 0, 0);
    const double holds = paper::transmissibility_at_resonance_without_U(modulus(a.V), a.G, a.beta);
    return {"amplitude at the resonance by (82), in units of P / k_1",
            as_printed::transmissibility_at_resonance_without_U(a.V, a.G, a.beta), holds, holds};
}

Compared sticking_by_88(const SlidingScene& s) {
    const StuckConfiguration stuck = stuck_configuration(s.system, s.basis);
    const StuckResponse response = stuck_response(stuck, s.system.load, s.sums.r);
    const StickingBoundary b = sticking_boundary(response, stuck_chain(s.system, stuck), s.mu);
    return {"friction ratio from which the contact never moves", b.paper.value(), b.exact, b.exact};
}

} // namespace

std::vector<RefutationScene> scenes_of_boundaries() {
    const double zeta = 0.1, mu = 2, far_above = 20, between = 0.5;
    const System<double> single = single_mass<double>(zeta);
    const System<double> slightly_damped = denhartog::equal_chain<double>(2, 2, 1, {0.0016, 0.0006}); // Figs. 8 to 10, rounded
    const auto three = [](std::size_t j, double z) { return denhartog::equal_chain<double>(3, j, 1, {z, z, z}); };
    const std::string of_single = "the single mass of Figs. 6 and 7, damping ratio 0.1",
                      of_two = "the two masses of Figs. 8 to 10";
    const std::string on_first = "three equal masses and springs, load and contact on mass 1, damping ratios 0.1";
    const std::string on_second = "three equal masses and springs, load on mass 1, contact on mass 2";
    const auto by_56 = [](const SlidingScene& s) { return compared_limits(s, s.boundary.paper); };
    const auto by_68 = [between](const SlidingScene& s) { return load_beyond_68(s, between); };
    const auto by_86 = [](const SlidingScene& s) {
        return compared_limits(s, as_printed::friction_ratio_limit_at_high_frequency(s.mu));
    };
    return {{"56", of_two, slightly_damped, 1, 0.55, 0.1, true, sums_of_maxima},
            {"69", of_two, slightly_damped, 1, 0.55, 0.1, true, by_56},
            {"57", of_single, single, 1, 0.9, 0.2, true, limit_with_57},
            {"59", on_first, three(1, zeta), 1, 1.3, 0.1, true, limit_mode_by_mode},
            {"63", on_first, three(1, zeta), 1, 1.3, 0.1, true, limit_mode_by_mode},
            {"68", of_single, single, 1, 0.5, between, false, by_68},
            {"70", of_single, single, 1, 0.9, 0.2, true, limit_with_70},
            {"81", on_second + ", damping ratios 0.01, at the first resonance", three(2, 0.01), 1, 0.445042, 0.4, true,
             amplitude_by_81},
            {"82", of_single + ", at its resonance", single, 1, 1, 0.2, true, amplitude_by_82},
            {"86", of_single + ", far above its resonance, with mu = 2", single, mu, far_above, 0.2, true, by_86},
            {"88", on_second + ", damping ratios 0.1", three(2, zeta), 1, 1, 0.1, true, sticking_by_88}};
}

} // namespace denhartog::derivation
