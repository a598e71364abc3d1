// Section 2.6: the bounds (56), (59), (63), (68), (69) as printed, against those that hold, by a search over scenes.
#include <cmath>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "derivation/observations/scene_search.hpp"

namespace denhartog::derivation {

namespace {

/// Whether the load condition (54)b holds by the sum (66), and by every mode on its own as (59) and (63) have it.
std::pair<bool, bool> holds_by_sum_and_by_modes(const SlidingScene& s) {
    const ModeSums<double>& m = s.sums;
    const std::size_t j = m.contact.index;
    const double beta = s.state.beta;
    const bool by_sum = std::abs(paper::contact_load_at_start(s.state.X_j, m.G[j], m.H_j, beta)) > s.mu * beta * m.sum_of_squares;
    bool by_modes = true;
    for (std::size_t i = 0; i < m.R.size(); ++i) {
        const ModeInScene<double> mode = mode_of(s, i);
        const double load = paper::modal_contact_load_by_functions(mode, start_of_mode(s, i).eta_0, m.u[i], m.g[i], beta);
        by_modes = by_modes && std::abs(load) > mode.psi_ji * s.mu * beta;
    }
    return {by_sum, by_modes};
}

/// (68) as printed: beta beyond which the load condition is said to hold; and whether it does hold, just beyond.
struct BeyondTheOtherLimit {
    double limit, beta, load, needed;
};

BeyondTheOtherLimit beyond_68(const SlidingScene& s) {
    const ModeSums<double>& m = s.sums;
    const std::size_t j = m.contact.index;
    const double limit = paper::friction_ratio_limit(m.V[j], m.U[j], m.H_j - s.mu * m.sum_of_squares);
    const double largest = m.U[j] == 0 ? 2 * limit : modulus(m.V[j]) / std::abs(m.U[j]); // beyond it (38) has no root
    const double beta = limit + (largest - limit) / 64;
    const double X = paper::displacement_transmissibility_of_contact(m.V[j], m.U[j], m.G[j], beta);
    return {limit, beta, std::abs(paper::contact_load_at_start(X, m.G[j], m.H_j, beta)), s.mu * beta * m.sum_of_squares};
}

/// (54)b by the sum over the modes, and by each mode on its own as (59) and (63) have it.
Outcome modes_against_sum() {
    return refute_by_largest(
        [](const SlidingScene& s) {
            const auto [by_sum, by_modes] = holds_by_sum_and_by_modes(s);
            return by_sum != by_modes ? 1.0 : 0.0;
        },
        0, place_of, "(54)b, the sum, is met and a mode's inequality is not");
}

const Register claims_of_printed_bounds([] {
    const std::vector<std::string> sliding{"sliding regime"};
    return std::vector<Claim>{
        {.id = "56/printed",
         .equations = {"56"},
         .role = Role::printed,
         .title = "S_dj, the sum of the modes' maxima, is what X_j + beta G_j has to exceed: no more than (54)a demands",
         .assumptions = sliding,
         .check =
             [] {
                 return refute_by_largest(
                     [](const SlidingScene& s) { return s.boundary.S_paper / s.boundary.S_exact - 1; }, 1e-6,
                     [](const SlidingScene& s) {
                         return with(place_of(s), {{"sum of maxima", text(s.boundary.S_paper)},
                                                   {"maximum of the sum", text(s.boundary.S_exact)}});
                     },
                     "The modes' maxima lie at different instants, their sum is larger than the maximum of the sum");
             },
         .departure = Departure::substance,
         .correction = "S_{dj} = \\sup_{0<\\tau<\\pi}\\sum_{i=1}^N\\psi_{ji}^2\\,s_i(\\tau) \\;\\le\\; "
                       "\\sum_{i=1}^N\\psi_{ji}^2\\sup_{0<\\tau<\\pi}s_i(\\tau)"},
        {.id = "69/printed",
         .equations = {"69"},
         .role = Role::printed,
         .title = "With S_dj from (56) the right side is the boundary of the sliding regime",
         .assumptions = sliding,
         .check =
             [] {
                 return refute_by_largest(
                     [](const SlidingScene& s) { return 1 - s.boundary.paper / s.boundary.exact; }, 1e-6,
                     [](const SlidingScene& s) {
                         return with(place_of(s), {{"beta_lim with (56)", text(s.boundary.paper)},
                                                   {"beta_lim with the maximum of the sum", text(s.boundary.exact)}});
                     },
                     "Motions between the two values slide throughout: (69) with (56) is sufficient, not necessary");
             },
         .departure = Departure::substance,
         .correction =
             "\\beta < \\sqrt{\\frac{|V_{dj}|^2}{U_{dj}^2+\\left[\\max\\left(\\sup_\\tau\\sum_i\\psi_{ji}^2s_i(\\tau),\\; "
             "H_j+\\frac{\\mu}{\\gamma_jr^2}\\right)\\right]^2}}"},
        {.id = "59/printed",
         .equations = {"59"},
         .role = Role::printed,
         .title = "The load condition (54)b holds exactly where every mode meets it on its own",
         .assumptions = sliding,
         .check = modes_against_sum,
         .departure = Departure::substance,
         .correction =
             "\\left|\\sum_{i=1}^N\\psi_{ji}\\left(2\\zeta_i\\Omega_i\\eta_{i0}'+\\Omega_i^2\\eta_{i0}-\\psi_{li}\\cos\\phi_j"
             "\\right)\\right| > \\mu\\beta\\sum_{i=1}^N\\psi_{ji}^2"},
        {.id = "63/printed",
         .equations = {"63"},
         .role = Role::printed,
         .title = "The load condition (54)b, with (62) in it, holds exactly where every mode meets it on its own",
         .assumptions = sliding,
         .check = modes_against_sum,
         .departure = Departure::substance,
         .correction =
             "\\left|\\sum_{i=1}^N\\psi_{ji}\\left(\\eta_{i0}-\\beta\\psi_{ji}[(1-R_i^2)g_i+2\\zeta_iR_iu_{di}]\\right)\\right| "
             "> \\mu\\beta\\sum_{i=1}^N\\psi_{ji}^2"},
        {.id = "68/printed",
         .equations = {"68"},
         .role = Role::printed,
         .title = "Beyond (68) the load condition (66) holds",
         .assumptions = {"beta |U_dj| <= |V_dj|"},
         .check =
             [] {
                 return refute_by_largest(
                     [](const SlidingScene& s) {
                         const BeyondTheOtherLimit b = beyond_68(s);
                         return 1 - b.load / b.needed;
                     },
                     1e-6,
                     [](const SlidingScene& s) {
                         const BeyondTheOtherLimit b = beyond_68(s);
                         return with(place_of(s), {{"right side of (68)", text(b.limit)},
                                                   {"beta beyond it", text(b.beta)},
                                                   {"|X_j + beta G_j - beta H_j|", text(b.load)},
                                                   {"mu beta / (gamma_j r^2)", text(b.needed)},
                                                   {"H_j", text(s.sums.H_j)},
                                                   {"mu / (gamma_j r^2)", text(s.mu * s.sums.sum_of_squares)}});
                     },
                     "Squaring lost a sign: where H_j is below mu / (gamma_j r^2) no beta meets the second branch of (66)");
             },
         .departure = Departure::substance,
         .correction = "\\beta > \\sqrt{\\frac{|V_{dj}|^2}{U_{dj}^2+\\left(H_j-\\frac{\\mu}{\\gamma_jr^2}\\right)^2}} "
                       "\\quad\\text{and}\\quad "
                       "H_j > \\frac{\\mu}{\\gamma_jr^2}"},
        {.id = "68/never-with-58/text",
         .equations = {"68", "58"},
         .role = Role::observation,
         .title = "Observation in the text: (58) and (68) never hold at once",
         .assumptions = {"(58) and (68) as printed, S_dj exact"},
         .check =
             [] {
                 return refute_by_largest(
                     [](const SlidingScene& s) {
                         const std::size_t j = s.sums.contact.index;
                         const double upper = paper::friction_ratio_limit(s.sums.V[j], s.sums.U[j], s.boundary.S_exact);
                         return upper / beyond_68(s).limit - 1;
                     },
                     1e-6,
                     [](const SlidingScene& s) {
                         const std::size_t j = s.sums.contact.index;
                         return with(place_of(s),
                                     {{"right side of (58)",
                                       text(paper::friction_ratio_limit(s.sums.V[j], s.sums.U[j], s.boundary.S_exact))},
                                      {"right side of (68)", text(beyond_68(s).limit)}});
                     },
                     "A friction ratio between the right sides of (68) and (58) meets both as printed");
             }},
    };
});

} // namespace
} // namespace denhartog::derivation
