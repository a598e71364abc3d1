// Section 2.6: "only if"s and observations of the text on the boundary of the sliding regime. Proved where possible; else
// searched by a fixed seed, with the counterexample or the number of cases tried.
#include <algorithm>
#include <cmath>

#include "denhartog/evaluation/mode.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/observations/scene_search.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

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

constexpr double least_damping = 1.0 / 64; // the damping ratio up to which one is taken to be nearly zero

Outcome maximum_at_zero() {
    long tried = 0, elsewhere = 0;
    PeakOfMode highest{0, -1, 0, 0, 0};
    for (int n = 1; n <= 120; ++n)
        for (int z = 1; z <= 63; ++z) {
            const PeakOfMode peak = peak_of_mode(n / 40.0, z / 64.0);
            ++tried;
            if (peak.largest <= peak.at_zero * (1 + 1e-9)) continue;
            ++elsewhere;
            if (peak.zeta > std::max(highest.zeta, least_damping)) highest = peak;
        }
    Outcome outcome;
    outcome.steps.push_back(
        {"R_i = 1/40 to 3 in steps of 1/40, zeta_i = 1/64 to 63/64 in steps of 1/64: the maximum is not at tau = 0 for " +
             std::to_string(elsewhere) + " of " + std::to_string(tried) + " pairs",
         ""});
    outcome.witness = {{"pairs tried", std::to_string(tried)}, {"maximum elsewhere", std::to_string(elsewhere)}};
    if (elsewhere > 0) {
        refute_above(outcome, highest.zeta,
                     {.what = "zeta_i that is nearly zero, R_i from 1/40 to 3", .taken = least_damping, .empty = 1});
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

double smallest_damping_ratio(const SlidingScene& s) { return *std::ranges::min_element(s.sums.zeta); }

double error_of_67(const SlidingScene& s) { return s.boundary.approximate / s.boundary.exact - 1; }

/// (67) against (69) where no damping ratio is nearly zero.
Outcome approximation_with_damping() {
    const double least = 0.02, error = 0.01;
    const auto excess = [&](const SlidingScene& s) { return smallest_damping_ratio(s) < least ? std::nan("") : error_of_67(s); };
    const auto witness = [](const SlidingScene& s) {
        return with(place_of(s), {{"smallest zeta_i", text(smallest_damping_ratio(s))},
                                  {"beta_lim by (67)", text(s.boundary.approximate)},
                                  {"beta_lim exact", text(s.boundary.exact)}});
    };
    Outcome outcome = refute_by_largest(excess, {.what = "relative error of (67)", .taken = error, .empty = 1}, witness,
                                        "(67) over-estimates the boundary");
    double largest = 0;
    for (const SlidingScene& s : sliding_scenes())
        if (error_of_67(s) > error) largest = std::max(largest, smallest_damping_ratio(s));
    refute_above(outcome, largest,
                 {.what = "zeta_i that is nearly zero, with an error of 1 percent", .taken = least, .empty = 1});
    return outcome;
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
                         return with(place_of(s),
                                     {{"S_dj, exact", text(s.boundary.S_exact)},
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
         .check = approximation_with_damping},
    };
});

} // namespace
} // namespace denhartog::derivation
