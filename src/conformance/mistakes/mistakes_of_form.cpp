#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/number.hpp"

namespace denhartog::conformance {
namespace {

MistakeDefinition own(std::string name, std::string equation, std::string told, std::string look_at,
                      std::vector<std::string_view> touched, std::function<void(Choices&)> choose) {
    return by_formulas({std::move(name), std::move(equation), false, std::move(told), std::move(look_at)}, std::move(touched),
                       std::move(choose));
}

std::vector<MistakeDefinition> of_boundaries() {
    return {
        own("88-without-damping-forces", "88",
            "The damping forces of the moving masses on the held contact are left out of (88).",
            "(88): row j of the damping matrix is not zero off its diagonal", {"beta_lim_sticking", "regime"},
            [](Choices& c) { c.sticking = StickingForm::without_damping_load; }),
        own("approximate-limit", "67", "(67) is taken for the boundary (69): (72) stands in place of the maximum over tau.",
            "whether the maximum over tau of the sum over modes is sought at all",
            {"S_j", "beta_lim_exact", "beta_lim_paper", "regime"}, [](Choices& c) { c.demand_at_start = true; }),
        own("load-condition-left-out", "67",
            "The boundary (69) is taken from the maximum over tau alone; the load condition (67) may end the sliding before.",
            "whether the larger of S_j and H_j + mu / (gamma_j r^2) stands in (69)",
            {"beta_lim_exact", "beta_lim_paper", "regime"}, [](Choices& c) { c.without_load_condition = true; }),
        // The number of instants is found from the answers by `fitted_instants`.
        own("coarse-grid-of-tau", "57",
            "The maximum over tau is that of a few instants, 14 for example; the true one lies between two of them.",
            "how the maximum over tau is found: refine it around the largest sample",
            {"S_j", "beta_lim_exact", "beta_lim_paper", "regime"},
            [](Choices& c) {
                c.instants = Instants{pi<double>() / 15, pi<double>() / 15, 14};
            }),
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
        own("hysteretic-damping", "23", "Damping is hysteretic: (23) has 2 zeta_i in place of 2 zeta_i R_i.",
            "the imaginary part of (23): a viscous force grows with the frequency", {}, [](Choices& c) { c.hysteretic = true; }),
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

std::vector<MistakeDefinition> mistakes_of_form() {
    std::vector<MistakeDefinition> all = of_modes();
    for (const MistakeDefinition& each : of_boundaries()) all.push_back(each);
    return all;
}

} // namespace denhartog::conformance
