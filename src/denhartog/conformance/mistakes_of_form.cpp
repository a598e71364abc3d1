#include "denhartog/conformance/mistake_definition.hpp"

namespace denhartog::conformance {
namespace {

using Names = std::vector<std::string_view>;
using Choose = void (*)(Choices&);

std::function<std::vector<Value>(const Question&)> by_formulas(Names touched, std::vector<Choose> choices) {
    return [touched = std::move(touched), choices = std::move(choices)](const Question& q) {
        std::vector<Value> all;
        if (!touched.empty() && std::find(touched.begin(), touched.end(), q.quantity) == touched.end()) return all;
        for (const Choose choose : choices) {
            Choices c;
            choose(c);
            if (const std::optional<Value> value = plain_answer(q, c)) all.push_back(*value);
        }
        return all;
    };
}

MistakeDefinition printed(std::string equation, std::string told, std::string look_at, Names touched,
                          std::vector<Choose> choices) {
    return {{equation + "-as-printed", equation, true, std::move(told), std::move(look_at)},
            by_formulas(std::move(touched), std::move(choices))};
}

MistakeDefinition own(std::string name, std::string equation, std::string told, std::string look_at, Names touched,
                      Choose choose) {
    return {{std::move(name), std::move(equation), false, std::move(told), std::move(look_at)},
            by_formulas(std::move(touched), {choose})};
}

std::vector<MistakeDefinition> of_printed_motion() {
    return {
        printed("46",
                "Sine and cosine stand exchanged in the bracket of (46), as printed there and in (40), (41) and (A.15); it is d "
                "of (A.8).",
                "the bracket that multiplies (1 + g_i): cos + zeta / sqrt(1 - zeta^2) sin, which is 1 at tau = 0",
                {"displacement", "amplitude", "phase", "motion_under_force"}, {[](Choices& c) { c.motion_as_printed = true; }}),
        printed("44", "(44) as printed: the real part lacks beta U_dj sin(Delta).",
                "x_k0: the phase phi_j is not zero in V_dk cos(phi_j), read as Re{V_dk exp(i phi_j)}",
                {"initial_displacement", "displacement", "amplitude", "phase", "motion_under_force"},
                {[](Choices& c) { c.initial_displacement_as_printed = true; },
                 [](Choices& c) { c.initial_displacement_as_printed = c.motion_from_start = true; }}),
        printed("45", "(45) as printed: the real part lacks the root times sin(Delta).",
                "x'_k0: V_dk sin(phi_j) is read as Im{V_dk exp(i phi_j)}, whose real part alone is not enough",
                {"initial_velocity", "displacement", "amplitude", "phase", "motion_under_force"},
                {[](Choices& c) { c.initial_velocity_as_printed = true; },
                 [](Choices& c) { c.initial_velocity_as_printed = c.motion_from_start = true; }}),
        printed("50", "(50) as printed: the ratio of the moduli multiplies its first term only.",
                "X_kC: |V_dk| / |V_dj| multiplies the root and beta U_dj sin(Delta)",
                {"phase_monoharmonic", "amplitude_monoharmonic"},
                {[](Choices& c) { c.cosine_as_printed = true; },
                 [](Choices& c) { c.cosine_as_printed = c.amplitude_from_parts = true; }}),
        printed("52", "(52) as printed: U_dk sin(Delta) has the other sign.",
                "the first bracket of (52): G_k cos(Delta) - U_dk sin(Delta)", {"amplitude_monoharmonic"},
                {[](Choices& c) { c.monoharmonic_as_printed = true; }}),
    };
}

std::vector<MistakeDefinition> of_printed_boundaries() {
    return {
        printed("56", "The sum of the maxima of the modes, (56), is taken for the maximum of their sum.",
                "where the maximum over tau is taken: after the sum over the modes", {"S_j", "beta_lim_exact", "regime"},
                {[](Choices& c) { c.maximum_of_each_mode = true; }}),
        printed("57", "(57) as printed: another bracket multiplies u_di, and cos(tau) is missing, so that it has no maximum.",
                "the expression of (57): (1 + g_i) R_i q_i - u_di R_i^2 (R_i q_i' - cos(tau)) over sin(tau) stays finite at both "
                "ends",
                {"S_j", "beta_lim_paper", "beta_lim_exact"},
                {[](Choices& c) { c.printed_demand = 999; }, [](Choices& c) { c.printed_demand = 1000; },
                 [](Choices& c) { c.printed_demand = 1001; }, [](Choices& c) { c.printed_demand = 998; },
                 [](Choices& c) { c.printed_demand = 99; }, [](Choices& c) { c.printed_demand = 100; },
                 [](Choices& c) { c.printed_demand = 199; }, [](Choices& c) { c.printed_demand = 200; },
                 [](Choices& c) { c.printed_demand = 499; }, [](Choices& c) { c.printed_demand = 500; },
                 [](Choices& c) { c.printed_demand = 1999; }, [](Choices& c) { c.printed_demand = 2000; },
                 [](Choices& c) { c.printed_demand = 4999; }, [](Choices& c) { c.printed_demand = 9999; }}),
        printed("63", "The load condition is asked of every mode on its own, as (59) and (63) print it; it holds for the sum.",
                "(59) and (63): sum over the modes with psi_ji before comparing with mu beta", {"beta_lim_approximate"},
                {[](Choices& c) { c.load_of_each_mode = true; }}),
        printed("68", "The contact is said to slide beyond (68) as printed, which also needs H_j > mu / (gamma_j r^2).",
                "the condition (68): drop it, since (58) and (68) never hold at once", {"beta_lim_exact", "regime"},
                {[](Choices& c) { c.sliding_beyond_68 = true; }}),
        printed("86", "(86) as printed has mu in place of its square.", "the root of (86): 4 mu^2 + pi^2",
                {"beta_lim_high_frequency"}, {[](Choices& c) { c.mu_at_high_frequency = true; }}),
        printed("88", "(88) as printed: the spring next to the contact alone holds it, and the modes are taken as uncoupled.",
                "(88): all forces on the held contact count, the damping forces of the moving masses among them",
                {"beta_lim_sticking", "regime"}, {[](Choices& c) { c.sticking = StickingForm::as_printed; }}),
        own("88-without-damping-forces", "88",
            "The damping forces of the moving masses on the held contact are left out of (88).",
            "(88): row j of the damping matrix is not zero off its diagonal", {"beta_lim_sticking", "regime"},
            [](Choices& c) { c.sticking = StickingForm::without_damping_load; }),
        own("approximate-limit", "67", "(67) is taken for the boundary (69): (72) stands in place of the maximum over tau.",
            "whether the maximum over tau of the sum over modes is sought at all",
            {"S_j", "beta_lim_exact", "beta_lim_paper", "regime"}, [](Choices& c) { c.demand_at_start = true; }),
        own("sign-of-mu-in-67", "67", "mu / (gamma_j r^2) has the other sign in (67) and (69), which is (68).",
            "H_j + mu / (gamma_j r^2) in (67)", {"beta_lim_approximate", "beta_lim_exact", "beta_lim_paper", "regime"},
            [](Choices& c) { c.sign_of_mu = -1; }),
        own("r-not-squared-in-65", "65", "The sum of squares in (65) is taken as 1 / (gamma_j r); it is 1 / (gamma_j r^2).",
            "mu / (gamma_j r^2) in (67)", {"beta_lim_approximate", "beta_lim_exact", "beta_lim_paper", "regime"},
            [](Choices& c) { c.power_of_r_in_65 = 1; }),
    };
}

std::vector<MistakeDefinition> of_modes() {
    return {
        own("psi-not-scaled-with-r", "17", "Mode shapes are normalised with diag(m_i / m_1); (17) has r^2 diag(m_i / m_1).",
            "the normalisation of the mode shapes: they go as 1 / r", {},
            [](Choices& c) { c.normalisation = Normalisation::without_r; }),
        own("psi-largest-entry-1", "17", "Mode shapes are normalised to a largest entry of 1; (17) uses the mass matrix.",
            "the normalisation of the mode shapes: psi^T M psi = 1 with M of (8)", {},
            [](Choices& c) { c.normalisation = Normalisation::largest_entry; }),
        own("psi-of-unit-length", "17",
            "Mode shapes have unit length, as eigenvalue routines return them; (17) uses the mass matrix.",
            "the normalisation of the mode shapes: psi^T M psi = 1 with M of (8)", {},
            [](Choices& c) { c.normalisation = Normalisation::unit_length; }),
        own("modes-descending", "15", "Modes are listed by descending natural frequency; answers list them ascending.",
            "the order in which the eigenvalue routine returns the modes",
            {"natural_frequency_ratios", "modal_frequency_ratios", "mode_shape_products"},
            [](Choices& c) { c.descending = true; }),
        own("no-2-in-23", "23", "The 2 of 2 zeta_i R_i is missing in (23).", "the imaginary part of (23)", {},
            [](Choices& c) { c.factor_in_23 = 1; }),
        own("argument-by-arctangent", "39",
            "The argument of V_dj is taken as the arcus tangent of a quotient, which loses the half-plane.",
            "the argument of V_dj in (39): atan2 of imaginary and real part",
            {"phase", "phase_monoharmonic", "motion_under_force"}, [](Choices& c) { c.argument_in_half_plane = true; }),
        own("minimum-taken-for-maximum", "47",
            "The phase of a mass is that of its minimum where this is what the half-period holds: (47) lacks half a period.",
            "(47): add pi where the displacement of largest size is negative", {"phase"},
            [](Choices& c) { c.no_half_period_for_minima = true; }),
    };
}

} // namespace

std::vector<MistakeDefinition> mistakes_of_print() {
    std::vector<MistakeDefinition> all = of_printed_motion();
    for (const MistakeDefinition& each : of_printed_boundaries()) all.push_back(each);
    return all;
}

std::vector<MistakeDefinition> mistakes_of_form() { return of_modes(); }

} // namespace denhartog::conformance
