// Section 2.6: at frequency ratios from half the damped natural one on, 2 R_i >= w_i, the expression of (57) is largest for
// tau -> 0. There (71), (72) are exact, and (67) is the boundary (69).
#include "denhartog/evaluation/demand.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

ex rate_in_tau(const ex& e) { return e.diff(GiNaC::ex_to<GiNaC::symbol>(symbols().tau)); }

/// N, the expression of (57) times sin(tau), in the symbols u and g.
ex numerator_of_57() {
    const Symbols& s = symbols();
    return (paper::s_d_integrand(Symbolic(s.tau), Symbolic(s.R), Symbolic(s.zeta), Symbolic(s.u), Symbolic(s.g)).expression() *
            GiNaC::sin(s.tau))
        .normal();
}

/// The damping functions (28), (29) in the place of their symbols.
ex with_28_and_29(const ex& e) {
    const Symbols& s = symbols();
    return e.subs(GiNaC::lst{s.u == first_function(s.R, s.zeta), s.g == second_function(s.R, s.zeta)});
}

/// An identity as a statement of the outcome; an altered one must be refuted.
void add_identity(Outcome& outcome, const ex& left, const ex& right, const std::string& what, const std::string& formula) {
    const std::vector<Range> domain = domain_of({left, right});
    const Verdict verdict = decide_equal(left, right, domain).verdict;
    add_statement(outcome, verdict, what, formula);
    if (verdict == Verdict::proved && differs_at_samples(left, right + 1, domain)) ++altered_statements_refuted();
}

/// R Z(0) with (28), (29) in it, times -(cosh delta + cos theta): four terms, none of them negative where theta <= 2 pi.
void add_sign_at_the_start(Outcome& outcome, const ex& Z) {
    const Symbols& s = symbols();
    const ex w = GiNaC::sqrt(1 - s.zeta * s.zeta), theta = GiNaC::Pi * w / s.R, delta = GiNaC::Pi * s.zeta / s.R;
    const ex denominator = GiNaC::cosh(delta) + GiNaC::cos(theta);
    const ex four_terms = 2 * s.zeta * (GiNaC::exp(delta) - 1 - delta) + 2 * s.zeta * (1 + GiNaC::cos(theta)) +
                          s.zeta * delta * (2 + GiNaC::sin(theta) / theta) - (w * w - s.R * s.R) / w * GiNaC::sin(theta);
    add_identity(outcome, -s.R * with_28_and_29(Z.subs(s.tau == 0)) * denominator, four_terms, "At the start, with (28) and (29)",
                 "-R_iZ(0)\\,(\\cosh\\delta+\\cos\\theta) = 2\\zeta_i(e^\\delta-1-\\delta) + 2\\zeta_i(1+\\cos\\theta) + "
                 "\\zeta_i\\delta\\left(2+\\frac{\\sin\\theta}{\\theta}\\right) - \\frac{w_i^2-R_i^2}{w_i}\\sin\\theta");
    add_argument(outcome,
                 "No term is negative for 0 < theta <= 2 pi: an exponential is not below its tangent, |sin theta| <= theta, and "
                 "sin theta has the sign of R_i - w_i, as theta = pi w_i / R_i. Hence Z(0) <= 0",
                 "e^\\delta\\ge1+\\delta,\\quad |\\sin\\theta|\\le\\theta,\\quad (R_i-w_i)\\sin\\theta\\ge0");
}

Outcome largest_at_the_start() {
    const Symbols& s = symbols();
    const ex N = numerator_of_57(), Z = rate_in_tau(rate_in_tau(N)) + N;
    const ex slope = rate_in_tau(N) * GiNaC::sin(s.tau) - N * GiNaC::cos(s.tau);
    Outcome outcome;
    for (const ex& end : {ex(0), ex(GiNaC::Pi)})
        add_identity(outcome, with_28_and_29(N.subs(s.tau == end)), 0,
                     "The numerator of (57) vanishes at an end of the half-period", end.is_zero() ? "N(0) = 0" : "N(\\pi) = 0");
    add_identity(outcome, rate_in_tau(N / GiNaC::sin(s.tau)) * GiNaC::pow(GiNaC::sin(s.tau), 2), slope,
                 "The rate of (57) has the sign of W",
                 "\\left(\\frac{N}{\\sin\\tau}\\right)'\\sin^2\\tau = W = N'\\sin\\tau-N\\cos\\tau");
    add_identity(outcome, rate_in_tau(slope), Z * GiNaC::sin(s.tau), "The rate of W", "W' = Z\\sin\\tau,\\quad Z = N''+N");
    add_identity(outcome, rate_in_tau(rate_in_tau(Z)) + 2 * s.zeta / s.R * rate_in_tau(Z) + Z / (s.R * s.R), 0,
                 "Z is a damped sine of the frequency w / R", "Z'' + \\frac{2\\zeta_i}{R_i}Z' + \\frac{1}{R_i^2}Z = 0");
    const Symbolic R(s.R), zeta(s.zeta), u(s.u), g(s.g);
    add_identity(outcome, paper::s_d_at_zero(R, zeta, u, g).expression() - evaluation::s_d_at_pi(R, zeta, u, g).expression(), 2,
                 "(57) at the start, (71), exceeds (57) at the end by two", "s_i(0)-s_i(\\pi) = 2");
    add_sign_at_the_start(outcome, Z);
    add_argument(
        outcome,
        "Zeros of Z are pi R_i / w_i >= pi/2 apart, so that no more than two are inside the half-period, and no more than "
        "one if Z(0) = 0: Z is not first positive, then negative, then positive. W is zero at both ends, and Z is not zero "
        "throughout, as (57) is not constant. If Z goes from negative to positive once, W is "
        "nowhere positive and (57) falls throughout. If Z goes back to negative, (57) falls and then rises to its end, "
        "which is below its start. Z cannot go from positive to negative alone, as (57) would rise to an end below its "
        "start",
        "s_i(\\tau) \\le \\lim_{\\tau\\to0}s_i = 1+g_i+2\\zeta_iR_iu_{di}");
    return outcome;
}

Outcome exact_boundary() {
    Outcome outcome;
    add_claim(outcome, "57/largest-at-start", "each mode demands most for tau -> 0");
    add_claim(outcome, "72/one-more-mode", "what the modes demand for tau -> 0 sums to H_j + sum psi_ji^2");
    add_argument(outcome,
                 "The sum over the modes is at most the sum of their largest values, which all lie at tau -> 0, where the sum "
                 "reaches it; the demand of static friction is not less, as mu >= 1",
                 "\\sup_\\tau\\sum_i\\psi_{ji}^2s_i(\\tau) = H_j+\\sum_i\\psi_{ji}^2 \\le H_j+\\mu\\sum_i\\psi_{ji}^2");
    outcome.why_no_twin = "an argument from claims that have twins";
    return outcome;
}

const Register claims_of_section_2_6_largest_at_start([] {
    return std::vector<Claim>{
        {.id = "57/largest-at-start",
         .equations = {"57", "71"},
         .role = Role::step,
         .title = "From half the damped natural frequency on (57) is largest for tau -> 0: (71) is its maximum",
         .assumptions = {"2 R_i >= w_i", "0 <= zeta_i < 1", "zeta_i > 0 or R_i not 1"},
         .check = largest_at_the_start},
        {.id = "67/exact",
         .equations = {"67", "69", "72", "56"},
         .role = Role::step,
         .title = "If 2 R_i >= w_i for every mode, (72) is S_dj, and (67) is the boundary (69), for every mu",
         .assumptions = {"2 R_i >= w_i", "0 <= zeta_i < 1", "mu >= 1"},
         .check = exact_boundary},
    };
});

} // namespace

} // namespace denhartog::derivation
