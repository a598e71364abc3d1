#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/number.hpp"

namespace denhartog::conformance {
namespace {

// The paper prints nothing for a mode that does not vibrate. The core: what the equation is printed for.
MistakeDefinition printed(std::string equation, std::string told, std::string look_at, std::vector<std::string_view> touched,
                          std::function<void(Choices&)> choose, std::vector<std::string> core = {}) {
    std::string name = equation + "-as-printed";
    MistakeDefinition definition = by_formulas({std::move(name), std::move(equation), true, std::move(told), std::move(look_at)},
                                               std::move(touched), std::move(choose));
    definition.mistake.core = std::move(core);
    definition.answer = [vibrating = std::move(definition.answer)](const ProtocolQuestion& q) {
        return is_overdamped(q) ? std::nullopt : vibrating(q);
    };
    return definition;
}

std::vector<MistakeDefinition> of_printed_motion() {
    return {
        printed("46",
                "Sine and cosine stand exchanged in the bracket of (46), as printed there and in (40), (41) and (A.15); it is d "
                "of (A.8).",
                "the bracket that multiplies (1 + g_i): cos + zeta / sqrt(1 - zeta^2) sin, which is 1 at tau = 0",
                {"displacement", "amplitude", "phase", "motion_under_force"}, [](Choices& c) { c.motion_as_printed = true; }),
        printed("44", "(44) as printed: the real part lacks beta U_dj sin(Delta).",
                "x_k0: the phase phi_j is not zero in V_dk cos(phi_j), read as Re{V_dk exp(i phi_j)}",
                {"initial_displacement", "displacement", "amplitude", "phase", "motion_under_force", "amplitude_monoharmonic",
                 "phase_monoharmonic"},
                [](Choices& c) { c.initial_displacement_as_printed = c.motion_from_start = true; }, {"initial_displacement"}),
        printed("45", "(45) as printed: the real part lacks the root times sin(Delta).",
                "x'_k0: V_dk sin(phi_j) is read as Im{V_dk exp(i phi_j)}, whose real part alone is not enough",
                {"initial_velocity", "displacement", "amplitude", "phase", "motion_under_force", "amplitude_monoharmonic",
                 "phase_monoharmonic"},
                [](Choices& c) { c.initial_velocity_as_printed = c.motion_from_start = true; }, {"initial_velocity"}),
        printed("50", "(50) as printed: the ratio of the moduli multiplies its first term only.",
                "X_kC: |V_dk| / |V_dj| multiplies the root and beta U_dj sin(Delta)",
                {"phase_monoharmonic", "amplitude_monoharmonic"},
                [](Choices& c) { c.cosine_as_printed = c.amplitude_from_parts = true; }, {"phase_monoharmonic"}),
        printed("52", "(52) as printed: U_dk sin(Delta) has the other sign.",
                "the first bracket of (52): G_k cos(Delta) - U_dk sin(Delta)", {"amplitude_monoharmonic"},
                [](Choices& c) { c.monoharmonic_as_printed = true; }),
    };
}

std::vector<MistakeDefinition> of_printed_boundaries() {
    return {
        printed("56", "The sum of the maxima of the modes, (56), is taken for the maximum of their sum.",
                "where the maximum over tau is taken: after the sum over the modes", {"S_j", "beta_lim_exact", "regime"},
                [](Choices& c) { c.maximum_of_each_mode = true; }),
        printed("63", "The load condition is asked of every mode on its own, as (59) and (63) print it; it holds for the sum.",
                "(59) and (63): sum over the modes with psi_ji before comparing with mu beta",
                {"beta_lim_approximate", "beta_lim_exact", "beta_lim_paper", "regime"},
                [](Choices& c) { c.load_of_each_mode = true; }, {"beta_lim_approximate"}),
        printed("68", "The contact is said to slide beyond (68) as printed, which also needs H_j > mu / (gamma_j r^2).",
                "the condition (68): drop it, since (58) and (68) never hold at once",
                {"beta_lim_exact", "beta_lim_paper", "regime"}, [](Choices& c) { c.sliding_beyond_68 = true; }),
        printed("86", "(86) as printed has mu in place of its square.", "the root of (86): 4 mu^2 + pi^2",
                {"beta_lim_high_frequency"}, [](Choices& c) { c.mu_at_high_frequency = true; }),
        printed("88", "(88) as printed: the spring next to the contact alone holds it, and the modes are taken as uncoupled.",
                "(88): all forces on the held contact count, the damping forces of the moving masses among them",
                {"beta_lim_sticking", "regime"}, [](Choices& c) { c.sticking = StickingForm::as_printed; }),
    };
}

// It has no maximum: what is answered depends on the instants tried, which `fitted_instants` finds from the answers.
MistakeDefinition printed_demand() {
    return printed("57",
                   "(57) as printed: another bracket multiplies u_di, and cos(tau) is missing, so that it has no maximum; its "
                   "value at one of the instants tried is taken for it, in the sum over the modes or, by (56), mode by mode.",
                   "the expression of (57): (1 + g_i) R_i q_i - u_di R_i^2 (R_i q_i' - cos(tau)) over sin(tau) stays finite at "
                   "both ends",
                   {"S_j", "beta_lim_paper", "beta_lim_exact", "regime"}, [](Choices& c) {
                       c.demand_as_printed = true;
                       c.instants = Instants{pi<double>() / 1000, pi<double>() / 1000, 999};
                   });
}

} // namespace

std::vector<MistakeDefinition> mistakes_of_print() {
    std::vector<MistakeDefinition> all = of_printed_motion();
    for (const MistakeDefinition& each : of_printed_boundaries()) all.push_back(each);
    all.push_back(printed_demand());
    return all;
}

} // namespace denhartog::conformance
