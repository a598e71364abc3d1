// Known mistakes in formulas: each equation as the paper prints it, if the derivation refutes that, such as (40), (46) and (57),
// and other formulas in the place of the right ones. The core of a mistake is the set of quantities that show it at once.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "conformance/mistakes/mistake_definition.hpp"
#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

using std::numbers::pi;

// Cores of mistakes.
const std::vector<std::string> of_67{"beta_lim_approximate"},
    of_limits{"beta_lim_approximate", "beta_lim_exact", "beta_lim_paper"}, of_maxima{"S_j", "beta_lim_exact", "beta_lim_paper"},
    of_sticking{"beta_lim_sticking"};

// Every mode shape times a factor of its own.
Answering scaled_shapes(double (*factor)(const PlainModes& m, std::size_t i)) {
    return by_formulas({}, [=](Choices& c) {
        c.change_modes = [=](PlainModes& m) {
            for (std::size_t i = 0; i < m.R.size(); ++i) {
                const double by = factor(m, i);
                for (auto& row : m.psi) row[i] *= by;
            }
        };
    });
}

// Another response of every mode in place of (23).
Answering other_responses(Phasor (*response)(double R, double zeta)) {
    return by_formulas({}, [=](Choices& c) {
        c.change_modes = [=](PlainModes& m) {
            for (std::size_t i = 0; i < m.R.size(); ++i) m.v[i] = response(m.R[i], m.zeta[i]);
        };
    });
}

// The paper prints nothing for a mode that does not vibrate. The core: what the equation is printed for.
Mistake printed(const std::string& equation, std::string told, std::string look_at, Answering answer,
                std::vector<std::string> core = {}) {
    Mistake mistake{equation + "-as-printed", equation, std::move(told), std::move(look_at),
                    where_modes_vibrate(std::move(answer))};
    mistake.core = std::move(core);
    mistake.as_printed = true;
    return mistake;
}

} // namespace

std::vector<Mistake> mistakes_of_formulas() {
    return {
        printed("46",
                "Sine and cosine stand exchanged in the bracket of (46), as printed there and in (40), (41) and (A.15); it is d "
                "of (A.8).",
                "the bracket that multiplies (1 + g_i): cos + zeta / sqrt(1 - zeta^2) sin, which is 1 at tau = 0",
                by_formulas({"displacement", "amplitude", "phase", "motion_under_force"}, &Choices::motion_as_printed),
                {"displacement"}),
        printed("44", "(44) as printed: the real part lacks beta U_dj sin(Delta).",
                "x_k0: the phase phi_j is not zero in V_dk cos(phi_j), read as Re{V_dk exp(i phi_j)}",
                by_formulas({"initial_displacement", "displacement", "amplitude", "phase", "motion_under_force",
                             "amplitude_monoharmonic", "phase_monoharmonic"},
                            [](Choices& c) { c.initial_displacement_as_printed = c.motion_from_start = true; }),
                {"initial_displacement"}),
        printed("45", "(45) as printed: the real part lacks the root times sin(Delta).",
                "x'_k0: V_dk sin(phi_j) is read as Im{V_dk exp(i phi_j)}, whose real part alone is not enough",
                by_formulas({"initial_velocity", "displacement", "amplitude", "phase", "motion_under_force",
                             "amplitude_monoharmonic", "phase_monoharmonic"},
                            [](Choices& c) { c.initial_velocity_as_printed = c.motion_from_start = true; }),
                {"initial_velocity"}),
        printed("50", "(50) as printed: the ratio of the moduli multiplies its first term only.",
                "X_kC: |V_dk| / |V_dj| multiplies the root and beta U_dj sin(Delta)",
                by_formulas({"phase_monoharmonic", "amplitude_monoharmonic"}, &Choices::cosine_as_printed),
                {"phase_monoharmonic"}),
        printed("52", "(52) as printed: U_dk sin(Delta) has the other sign.",
                "the first bracket of (52): G_k cos(Delta) - U_dk sin(Delta)",
                by_formulas({"amplitude_monoharmonic"}, &Choices::monoharmonic_as_printed), {"amplitude_monoharmonic"}),
        printed("56", "The sum of the maxima of the modes, (56), is taken for the maximum of their sum.",
                "where the maximum over tau is taken: after the sum over the modes",
                by_formulas({"S_j", "beta_lim_exact", "regime"}, &Choices::maximum_of_each_mode), {"S_j"}),
        printed("63", "The load condition is asked of every mode on its own, as (59) and (63) print it; it holds for the sum.",
                "(59) and (63): sum over the modes with psi_ji before comparing with mu beta",
                by_formulas(of_load, &Choices::load_of_each_mode), {"beta_lim_approximate"}),
        printed("68", "The contact is said to slide beyond (68) as printed, which also needs H_j > mu / (gamma_j r^2).",
                "the condition (68): drop it, since (58) and (68) never hold at once",
                by_formulas(of_boundary, &Choices::sliding_beyond_68), {"beta_lim_exact"}),
        printed("86", "(86) as printed has mu in place of its square.", "the root of (86): 4 mu^2 + pi^2",
                changed({"beta_lim_high_frequency"},
                        [](Value& value, const ProtocolQuestion& q) {
                            value.numbers = {2 / elementary::hypot(2 * std::sqrt(q.mu), pi)};
                        })),
        printed("88", "(88) as printed: the spring next to the contact alone holds it, and the modes are taken as uncoupled.",
                "(88): all forces on the held contact count, the damping forces of the moving masses among them",
                by_formulas({"beta_lim_sticking", "regime"}, [](Choices& c) { c.sticking = plain_sticking_limit_by_88; }),
                {"beta_lim_sticking"}),
        // It has no maximum: what is answered depends on the instants tried, which `fitted_to` finds from the answers.
        printed("57",
                "(57) as printed: another bracket multiplies u_di, and cos(tau) is missing, so that it has no maximum; its "
                "value at one of the instants tried is taken for it, in the sum over the modes or, by (56), mode by mode.",
                "the expression of (57): (1 + g_i) R_i q_i - u_di R_i^2 (R_i q_i' - cos(tau)) over sin(tau) stays finite at "
                "both ends",
                by_formulas(of_maximum,
                            [](Choices& c) {
                                c.demand_as_printed = true;
                                c.instants = Instants{pi / 1000, pi / 1000, 999};
                            }),
                {"S_j", "beta_lim_exact", "beta_lim_paper"}),
        // Mistakes that the paper does not print.
        {"88-without-damping-forces", "88", "The damping forces of the moving masses on the held contact are left out of (88).",
         "(88): row j of the damping matrix is not zero off its diagonal",
         by_formulas({"beta_lim_sticking", "regime"}, [](Choices& c) { c.sticking = plain_sticking_limit_without_damping; }),
         1e-6, of_sticking},
        {"88-by-sub-matrices", "88",
         "(88) from the first or last rows and columns of M, C and K, as its text has it: of the forces on the held contact only "
         "that of one spring counts.",
         "(88): all forces on the held contact count, the damping forces of all moving masses among them",
         by_formulas({"beta_lim_sticking", "regime"}, [](Choices& c) { c.sticking = plain_sticking_limit_by_sub_matrices; }),
         1e-6, of_sticking},
        {"approximate-limit", "67", "(67) is taken for the boundary (69): (72) stands in place of the maximum over tau.",
         "whether the maximum over tau of the sum over modes is sought at all",
         by_formulas(of_maximum, &Choices::demand_at_start), 1e-6, of_maxima},
        {"load-condition-left-out", "67",
         "The boundary (69) is taken from the maximum over tau alone; the load condition (67) may end the sliding before.",
         "whether the larger of S_j and H_j + mu / (gamma_j r^2) stands in (69)",
         by_formulas(of_boundary, &Choices::without_load_condition), 1e-6, of_limits},
        {"mu-missing-in-67", "67", "mu is left out of (67): the load is compared with kinetic friction.",
         "mu in H_j + mu / (gamma_j r^2), and in the load condition of (69)",
         by_formulas(of_load, [](Choices& c) { c.change_sums = [](PlainModes& m) { m.sum_of_squares /= m.mu; }; }), 1e-6, of_67},
        // The number of instants is found from the answers by `fitted_to`.
        {"coarse-grid-of-tau", "57",
         "The maximum over tau is that of a few instants, 14 for example; the true one lies between two of them.",
         "how the maximum over tau is found: refine it around the largest sample",
         by_formulas(of_maximum,
                     [](Choices& c) {
                         c.instants = Instants{pi / 15, pi / 15, 14};
                     }),
         1e-6, of_maxima},
        {"sign-of-mu-in-67", "67", "mu / (gamma_j r^2) has the other sign in (67) and (69), which is (68).",
         "H_j + mu / (gamma_j r^2) in (67)",
         by_formulas(of_load, [](Choices& c) { c.change_sums = [](PlainModes& m) { m.sum_of_squares = -m.sum_of_squares; }; }),
         1e-6, of_67},
        {"r-not-squared-in-65", "65", "The sum of squares in (65) is taken as 1 / (gamma_j r); it is 1 / (gamma_j r^2).",
         "mu / (gamma_j r^2) in (67)",
         by_formulas(of_load, [](Choices& c) { c.change_sums = [](PlainModes& m) { m.sum_of_squares *= m.r; }; }), 1e-6, of_67},
        {"psi-not-scaled-with-r", "17", "Mode shapes are normalised with diag(m_i / m_1); (17) has r^2 diag(m_i / m_1).",
         "the normalisation of the mode shapes: they go as 1 / r",
         scaled_shapes([](const PlainModes& m, std::size_t) { return m.r; })},
        {"psi-largest-entry-1", "17", "Mode shapes are normalised to a largest entry of 1; (17) uses the mass matrix.",
         "the normalisation of the mode shapes: psi^T M psi = 1 with M of (8)",
         scaled_shapes([](const PlainModes& m, std::size_t i) {
             double largest = 0;
             for (const auto& row : m.psi) largest = std::max(largest, std::abs(row[i]));
             return 1 / largest;
         })},
        {"psi-of-unit-length", "17",
         "Mode shapes have unit length, as eigenvalue routines return them; (17) uses the mass matrix.",
         "the normalisation of the mode shapes: psi^T M psi = 1 with M of (8)",
         scaled_shapes([](const PlainModes& m, std::size_t i) {
             double squares = 0;
             for (const auto& row : m.psi) squares += row[i] * row[i];
             return 1 / std::sqrt(squares);
         })},
        {"modes-descending", "15", "Modes are listed by descending natural frequency; answers list them ascending.",
         "the order in which the eigenvalue routine returns the modes",
         changed({"natural_frequency_ratios", "modal_frequency_ratios", "mode_shape_products"},
                 [](Value& value, const ProtocolQuestion&) { std::ranges::reverse(value.numbers); })},
        {"no-2-in-23", "23", "The 2 of 2 zeta_i R_i is missing in (23).", "the imaginary part of (23)",
         other_responses([](double R, double zeta) { return response_of_mode(R, zeta / 2); })},
        {"hysteretic-damping", "23", "Damping is hysteretic: (23) has 2 zeta_i in place of 2 zeta_i R_i.",
         "the imaginary part of (23): a viscous force grows with the frequency", other_responses([](double R, double zeta) {
             const double stiffness = (1 - R) * (1 + R), damping = 2 * zeta;
             const double square = stiffness * stiffness + damping * damping;
             return Phasor{stiffness / square, -damping / square};
         })},
        {"argument-by-arctangent", "39",
         "The argument of V_dj is taken as the arcus tangent of a quotient, which loses the half-plane.",
         "the argument of V_dj in (39): atan2 of imaginary and real part",
         by_formulas({"phase", "phase_monoharmonic", "motion_under_force"}, &Choices::argument_in_half_plane)},
        {"minimum-taken-for-maximum", "47",
         "The phase of a mass is that of its minimum where this is what the half-period holds: (47) lacks half a period.",
         "(47): add pi where the displacement of largest size is negative",
         by_formulas({"phase"}, &Choices::no_half_period_for_minima)}};
}

} // namespace denhartog::conformance
