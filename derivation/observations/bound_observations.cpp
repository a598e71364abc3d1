// Section 2.6 and 2.5: bounds, "only if"s and observations of the text. Proved where possible; else searched by a fixed seed, with the
// counterexample or the number of cases tried.
#include <cmath>

#include "claim.hpp"
#include "denhartog/evaluation/mode.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "limits.hpp"
#include "sliding_scenes.hpp"
#include "symbols.hpp"
#include "witness.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

Witness place(const SlidingScene& s) {
    return {{"scene", s.name},
            {"N", std::to_string(s.sums.R.size())},
            {"r", text(s.sums.r)},
            {"beta", text(s.state.beta)},
            {"mu", text(s.mu)}};
}

/// Looks for the scene with the largest excess; refuted with that scene where the excess is above the threshold.
Outcome refute_by_largest(const std::function<double(const SlidingScene&)>& excess, double threshold,
                          const std::function<Witness(const SlidingScene&)>& witness, const std::string& what) {
    const SlidingScene* worst = nullptr;
    double largest = threshold;
    long tried = 0, above = 0;
    for (const SlidingScene& s : sliding_scenes()) {
        const double e = excess(s);
        if (std::isnan(e)) continue;
        ++tried;
        above += e > threshold;
        if (e > largest) {
            largest = e;
            worst = &s;
        }
    }
    Outcome outcome;
    outcome.steps.push_back({what + ": " + std::to_string(above) + " of " + std::to_string(tried) +
                                 " scenes (the paper's and seed " + std::to_string(seed_of_scenes) +
                                 ") are counterexamples, by more than " + text(threshold),
                             ""});
    if (worst != nullptr) {
        outcome.verdict = Verdict::refuted;
        outcome.witness = with(witness(*worst), {{"excess", text(largest)}});
    }
    outcome.witness.emplace_back("cases tried", std::to_string(tried));
    return outcome;
}

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

/// One mode: value of (57)'s expression at tau -> 0 against its largest value over a fine grid of instants.
struct PeakOfMode {
    double R, zeta, at_zero, largest, instant;
};

PeakOfMode peak_of_mode(double R, double zeta) {
    const evaluation::ModeFunctions<double> f = evaluation::mode_functions(R, zeta);
    PeakOfMode peak{R, zeta, paper::s_d_at_zero(R, zeta, f.u, f.g), 0, 0};
    peak.largest = peak.at_zero;
    for (int n = 1; n < 1024; ++n) {
        const double tau = pi<double>() * n / 1024;
        const double s = paper::s_d_integrand(tau, R, zeta, f.u, f.g);
        if (s > peak.largest) {
            peak.largest = s;
            peak.instant = tau;
        }
    }
    return peak;
}

Outcome maximum_at_zero() {
    long tried = 0, elsewhere = 0;
    PeakOfMode highest{0, -1, 0, 0, 0};
    for (int n = 1; n <= 120; ++n)
        for (int z = 1; z <= 48; ++z) {
            const PeakOfMode peak = peak_of_mode(n / 40.0, z / 64.0);
            ++tried;
            if (peak.largest <= peak.at_zero * (1 + 1e-9)) continue;
            ++elsewhere;
            if (peak.zeta > highest.zeta) highest = peak;
        }
    Outcome outcome;
    outcome.steps.push_back(
        {"R_i = 1/40 to 3 in steps of 1/40, zeta_i = 1/64 to 3/4 in steps of 1/64: the maximum is not at tau = 0 for " +
             std::to_string(elsewhere) + " of " + std::to_string(tried) + " pairs, none of them with zeta_i near zero",
         ""});
    outcome.witness = {{"pairs tried", std::to_string(tried)}, {"maximum elsewhere", std::to_string(elsewhere)}};
    if (elsewhere > 0) {
        outcome.verdict = Verdict::refuted;
        outcome.witness = with(outcome.witness, {{"R_i", text(highest.R)},
                                                 {"largest zeta_i", text(highest.zeta)},
                                                 {"value at tau = 0", text(highest.at_zero)},
                                                 {"larger value", text(highest.largest)},
                                                 {"tau", text(highest.instant)}});
    }
    return outcome;
}

/// g and g + 2 zeta R u are not negative, hence H_j >= 0: the two identities are proved, the two inequalities are elementary.
Outcome not_negative() {
    const Symbols& s = symbols();
    const Symbolic R(s.R), zeta(s.zeta);
    const ex u = paper::first_damping_function(R, zeta).expression(), g = paper::second_damping_function(R, zeta).expression();
    const ex theta = GiNaC::Pi * s.w / s.R, delta = GiNaC::Pi * s.zeta / s.R;
    const ex denominator = GiNaC::cosh(delta) + GiNaC::cos(theta), part = s.zeta / s.w * GiNaC::sin(theta);
    const std::vector<std::pair<ex, ex>> identities{{g * denominator, GiNaC::sinh(delta) - part},
                                                    {(g + 2 * s.zeta * s.R * u) * denominator, GiNaC::sinh(delta) + part},
                                                    {s.zeta / s.w * theta, delta}};
    Outcome outcome;
    outcome.verdict = Verdict::proved;
    for (const auto& [left, right] : identities) {
        const Decision decision = decide_equal(left, right, domain_of({left, right}));
        outcome.steps.push_back({"Identity, " + to_string(decision.verdict), latex(left) + " = " + latex(right)});
        if (decision.verdict != Verdict::proved) outcome.verdict = decision.verdict;
        if (differs_at_samples(left, right + 1, domain_of({left, right}))) ++altered_statements_refuted();
    }
    outcome.steps.push_back(
        {"|sin theta| <= theta gives |(zeta/w) sin theta| <= delta <= sinh delta, and cosh delta + cos theta > 0, so that g "
         "and g + 2 zeta R u are not negative; H_j sums the latter with squares",
         "\\left|\\frac{\\zeta_i}{w}\\sin\\theta\\right| \\le \\delta \\le \\sinh\\delta"});
    return outcome;
}

/// Largest relative error of the monoharmonic amplitude of a mass not in contact; NaN where there is none or nothing slides.
double monoharmonic_error(const ModeSums<double>& sums, double mu, double beta) {
    const Boundary<double> limit = boundary(sums, mu);
    if (!(beta < limit.exact)) return std::nan("");
    const SteadyState<double> state = steady_state(sums, limit, beta);
    double worst = std::nan("");
    for (std::size_t k = 0; k < state.masses.size(); ++k)
        if (k != sums.contact.index)
            worst = std::fmax(worst, std::abs(state.masses[k].amplitude_monoharmonic / state.masses[k].amplitude - 1));
    return worst;
}

/// The same scene with every damping ratio halved.
double error_with_half_the_damping(const SlidingScene& s) {
    ModalBasis<double> basis = s.basis;
    for (double& zeta : basis.zeta) {
        if (zeta == 0) return std::nan("");
        zeta /= 2;
    }
    return monoharmonic_error(mode_sums(basis, s.sums.contact, s.sums.load, s.sums.r), s.mu, s.state.beta);
}

/// A claim that follows from others by an argument; proved if they are.
Outcome follows_from(const std::vector<std::string>& ids, const std::string& argument, const std::string& formula) {
    Outcome outcome;
    outcome.verdict = Verdict::proved;
    for (const std::string& id : ids) {
        bool found = false;
        for (const Claim& claim : claims())
            if (claim.id == id) {
                found = true;
                const Verdict verdict = decide(claim).verdict;
                outcome.steps.push_back({"Rests on " + id + ", " + to_string(verdict), ""});
                if (verdict != Verdict::proved) outcome.verdict = verdict;
            }
        if (!found) throw std::logic_error("no claim named " + id);
    }
    outcome.steps.push_back({argument, formula});
    outcome.argued = true;
    outcome.why_no_twin = "an argument from claims that have twins";
    return outcome;
}

/// (54)b by the sum over the modes, and by each mode on its own as (59) and (63) have it.
Outcome modes_against_sum() {
    return refute_by_largest(
        [](const SlidingScene& s) {
            const auto [by_sum, by_modes] = holds_by_sum_and_by_modes(s);
            return by_sum != by_modes ? 1.0 : 0.0;
        },
        0, place, "(54)b, the sum, is met and a mode's inequality is not");
}

const Register claims_of_bound_observations([] {
    const std::vector<std::string> sliding{"sliding regime"};
    return std::vector<Claim>{
        {.id = "64/not-negative",
         .equations = {"64"},
         .role = Role::step,
         .title = "H_j is never negative",
         .assumptions = {"R_i > 0", "0 <= zeta_i < 1"},
         .check = not_negative},
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
                         return with(place(s), {{"sum of maxima", text(s.boundary.S_paper)},
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
                         return with(place(s), {{"beta_lim with (56)", text(s.boundary.paper)},
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
                         return with(place(s), {{"right side of (68)", text(b.limit)},
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
                         return with(place(s), {{"right side of (58)",
                                                 text(paper::friction_ratio_limit(s.sums.V[j], s.sums.U[j], s.boundary.S_exact))},
                                                {"right side of (68)", text(beyond_68(s).limit)}});
                     },
                     "A friction ratio between the right sides of (68) and (58) meets both as printed");
             }},
        {.id = "68/never-with-58",
         .equations = {"68", "58"},
         .role = Role::step,
         .title = "With H_j > mu / (gamma_j r^2), as (68) needs, (58) and (68) never hold at once",
         .assumptions = {"H_j > mu sum psi_ji^2"},
         .check =
             [] {
                 return follows_from(
                     {"71/limit", "72/one-more-mode", "64/not-negative"},
                     "The supremum S_dj is at least the limit for tau -> 0, H_j + sum psi_ji^2, which exceeds H_j - mu "
                     "sum psi_ji^2 > 0; the right side of (58) is then below that of (68)",
                     "S_{dj} \\ge H_j + \\sum_i\\psi_{ji}^2 > H_j - \\mu\\sum_i\\psi_{ji}^2 > 0");
             }},
        {.id = "38/sign-of-root",
         .equations = {"38", "58"},
         .role = Role::step,
         .title = "S_dj is positive, so that (54)a decides the sign of the root in (38), and (58) may be squared",
         .assumptions = sliding,
         .check =
             [] {
                 return follows_from(
                     {"71/limit", "72/one-more-mode", "64/not-negative", "54/one-more-mode"},
                     "S_dj is at least H_j + sum psi_ji^2, which is positive as H_j is not negative; X_j + beta G_j > beta "
                     "S_dj > 0 leaves the positive root",
                     "S_{dj} \\ge H_j + \\sum_i\\psi_{ji}^2 > 0");
             }},
        {.id = "57/maximum-at-zero/text",
         .equations = {"57", "71"},
         .role = Role::observation,
         .title = "Observation in the text: the maximum of (57) lies at tau = 0, but for zeta_i nearly zero",
         .assumptions = {"zeta_i >= 1/64"},
         .check = maximum_at_zero},
        {.id = "72/larger/text",
         .equations = {"72"},
         .role = Role::observation,
         .title = "Observation in the text: for mu > 1 the demand of (67) is larger than S_dj, by (72)",
         .assumptions = {"mu > 1"},
         .check =
             [] {
                 const ex H = new_symbol("H_j", "H_j", 0, 2),
                          squares = new_symbol("sum_psi_2", "\\sum_i\\psi_{ji}^2", numeric(1, 10), 2),
                          above = new_symbol("mu_less_1", "(\\mu-1)", numeric(1, 10), 2);
                 const auto demand = [&](const ex& mu) {
                     return paper::static_friction_demand(Symbolic(H), Symbolic(mu), Symbolic(squares)).expression();
                 };
                 const ex left = demand(1 + above) - demand(1), right = above * squares;
                 Outcome outcome;
                 add_statement(outcome, decide_equal(left, right, domain_of({left, right})).verdict,
                               "With S_dj by (72) the two differ by (mu - 1) sum psi_ji^2, which is positive",
                               "(\\mu-1)\\sum_i\\psi_{ji}^2>0");
                 return outcome;
             }},
        {.id = "72/larger",
         .equations = {"72"},
         .role = Role::observation,
         .title = "For mu > 1 the demand of (67) is larger than the exact S_dj",
         .assumptions = {"mu > 1"},
         .check =
             [] {
                 return refute_by_largest(
                     [](const SlidingScene& s) {
                         const double demand = paper::static_friction_demand(s.sums.H_j, s.mu, s.sums.sum_of_squares);
                         return s.mu > 1 ? s.boundary.S_exact / demand - 1 : std::nan("");
                     },
                     1e-6,
                     [](const SlidingScene& s) {
                         return with(place(s), {{"S_dj, exact", text(s.boundary.S_exact)},
                                                {"H_j + mu / (gamma_j r^2)",
                                                 text(paper::static_friction_demand(s.sums.H_j, s.mu, s.sums.sum_of_squares))}});
                     },
                     "(71) is a lower bound of s_di, so that S_dj can exceed the demand of static friction");
             }},
        {.id = "67/approximation/text",
         .equations = {"67"},
         .role = Role::observation,
         .title =
             "Observation in the text: (67) departs from (69) at low r only where the damping ratios are nearly zero; here: by "
             "less than 1 percent where every zeta_i is at least 0.02",
         .assumptions = sliding,
         .check =
             [] {
                 return refute_by_largest(
                     [](const SlidingScene& s) {
                         for (const double zeta : s.sums.zeta)
                             if (zeta < 0.02) return std::nan("");
                         return s.boundary.approximate / s.boundary.exact - 1;
                     },
                     0.01,
                     [](const SlidingScene& s) {
                         return with(place(s),
                                     {{"smallest zeta_i", text(*std::min_element(s.sums.zeta.begin(), s.sums.zeta.end()))},
                                      {"beta_lim by (67)", text(s.boundary.approximate)},
                                      {"beta_lim exact", text(s.boundary.exact)}});
                     },
                     "(67) over-estimates the boundary");
             }},
        {.id = "48/very-good/text",
         .equations = {"48", "52"},
         .role = Role::observation,
         .title =
             "Observation in the text: (48) is very good for the masses not in contact; here: within 1 percent of the amplitude",
         .assumptions = sliding,
         .check =
             [] {
                 return refute_by_largest(
                     [](const SlidingScene& s) { return monoharmonic_error(s.sums, s.mu, s.state.beta); }, 0.01, place,
                     "The monoharmonic amplitude of a mass not in contact departs from the largest displacement");
             }},
        {.id = "48/damping/text",
         .equations = {"48"},
         .role = Role::observation,
         .title = "Observation in the text: modal damping further reduces what (48) leaves out; here: twice the damping ratios, "
                  "same beta, "
                  "no larger relative error",
         .assumptions = {"sliding with both"},
         .check =
             [] {
                 return refute_by_largest(
                     [](const SlidingScene& s) {
                         return monoharmonic_error(s.sums, s.mu, s.state.beta) - error_with_half_the_damping(s);
                     },
                     1e-3,
                     [](const SlidingScene& s) {
                         return with(place(s), {{"error with half the damping ratios", text(error_with_half_the_damping(s))},
                                                {"error", text(monoharmonic_error(s.sums, s.mu, s.state.beta))}});
                     },
                     "The monoharmonic error grows with damping");
             }},
    };
});

} // namespace
} // namespace denhartog::derivation
