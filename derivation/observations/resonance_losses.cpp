#include "derivation/observations/resonance_losses.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "denhartog/evaluation/resonance.hpp"
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"

namespace denhartog::derivation {

namespace {

/// The parts of the amplitude of a mass at a resonance.
struct AtResonance {
    Complex<double> V_k;
    double U_k, U_j, G_k, psi_ki, psi_ji, beta;
};

std::optional<double> error_at_resonances(const SlidingScene& s, const std::function<double(const AtResonance&)>& error) {
    std::optional<double> worst;
    const std::size_t j = s.sums.contact.index;
    const double beta = s.state.beta;
    for (std::size_t i = 0; i < s.basis.r_n.size(); ++i) {
        const double zeta = s.sums.zeta[i];
        if (!(zeta > 0)) continue;
        const ModeSums<double> m = mode_sums(s.basis, s.sums.contact, s.sums.load, s.basis.r_n[i]);
        const double psi_ji = mode_shapes_at(m, m.contact)[i], psi_li = mode_shapes_at(m, m.load)[i];
        if (!(beta < boundary(m, s.mu).exact)) continue;
        if (!(beta < evaluation::friction_ratio_limit_at_resonance(psi_li, psi_ji, zeta))) continue;
        const SteadyState<double> state =
            with_maxima(m, steady_state_without_maxima(m, beta), std::vector<double>(m.V.size(), 0.0));
        double largest = 0, largest_error = 0;
        for (std::size_t k = 0; k < m.V.size(); ++k) {
            const double psi_ki = mode_shapes_at(m, Mass{k})[i];
            const AtResonance at{paper::complex_response_at_resonance(psi_ki, psi_li, zeta),
                                 m.U[k],
                                 m.U[j],
                                 evaluation::second_damping_function_at_resonance(psi_ki, psi_ji, zeta),
                                 psi_ki,
                                 psi_ji,
                                 beta};
            largest = std::max(largest, state.masses[k].amplitude_monoharmonic);
            const double e = error(at);
            if (!std::isnan(e)) largest_error = std::max(largest_error, e);
        }
        worst = std::max(worst.value_or(0), largest_error / largest);
    }
    return worst;
}

} // namespace

std::optional<double> error_with_81(const SlidingScene& scene) {
    return error_at_resonances(scene, [](const AtResonance& a) {
        const double V = modulus(a.V_k);
        return std::abs(as_printed::transmissibility_at_resonance(V, a.U_k, a.U_j, a.G_k, a.beta) -
                        paper::transmissibility_at_resonance(V, a.U_k, a.U_j, a.G_k, a.psi_ki, a.psi_ji, a.beta));
    });
}

std::optional<double> error_with_82(const SlidingScene& scene) {
    return error_at_resonances(scene, [](const AtResonance& a) {
        return std::abs(as_printed::transmissibility_at_resonance_without_U(a.V_k, a.G_k, a.beta) -
                        paper::transmissibility_at_resonance_without_U(modulus(a.V_k), a.G_k, a.beta));
    });
}

std::optional<double> error_with_86(const SlidingScene& scene) {
    if (scene.sums.contact != scene.sums.load) return std::nullopt;
    const double correct = paper::friction_ratio_limit_at_high_frequency(scene.mu);
    return std::abs(as_printed::friction_ratio_limit_at_high_frequency(scene.mu) / correct - 1);
}

} // namespace denhartog::derivation
