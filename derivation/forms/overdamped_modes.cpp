// Modes with zeta >= 1, which the paper leaves out: the forms of `evaluation/overdamped.hpp`.
//
// The paper's formulas hold with the cosine and the sine over w as entire functions of w^2: below zeta = 1 these forms are the
// printed ones. Above, and at zeta = 1, the equation of motion (20) is solved again, in real exponentials and with a double
// root, and the conditions (A.3), (A.4) are put to that solution. Nothing of the derivation for zeta < 1 is used there.
#include "denhartog/evaluation/demand.hpp"

#include "derivation/algebra/symbols.hpp"
#include "derivation/forms/overdamped_motion.hpp"
#include "derivation/paper/derived.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

/// The residual of (20) for any combination of the two motions, with friction and load.
Values residual(const FreeMotions& f) {
    const Symbols& s = symbols();
    const Complex<Symbolic> v = paper::complex_response(Symbolic(s.R), Symbolic(f.zeta));
    const ex angle = s.tau + s.phi_j;
    const ex eta = s.A * f.first + s.B * f.second + s.psi_ji * s.R * s.R * s.beta +
                   s.psi_li * s.R * s.R * (v.re.expression() * GiNaC::cos(angle) - v.im.expression() * GiNaC::sin(angle));
    const ModeInScene<Symbolic> m{Symbolic(s.R), Symbolic(f.zeta), Symbolic(s.psi_ji), Symbolic(s.psi_li)};
    return {paper::modal_equation_residual(Symbolic(eta), Symbolic(rate(eta)), Symbolic(rate(rate(eta))), Symbolic(s.tau), m,
                                           Symbolic(s.beta), Symbolic(s.phi_j))};
}

Values values(const evaluation::DampingFunctions<Symbolic>& f) { return {f.u, f.g}; }
Values values(const evaluation::FreeMotion<Symbolic>& f) { return {f.d, f.q, f.d_prime, f.q_prime, f.q_double_prime}; }
Values values(const Complex<Symbolic>& v) { return {v.re, v.im}; }

Values braces(const evaluation::FreeMotion<Symbolic>& free, const Symbolic& one_minus_d) {
    const Symbols& s = symbols();
    const evaluation::FrictionMotion<Symbolic> f =
        evaluation::friction_motion_of(free, one_minus_d, Symbolic(s.R), Symbolic(s.u), Symbolic(s.g));
    return {f.value, f.prime, f.double_prime};
}

/// The paper's C and S at the end of the half-period, below zeta = 1.
evaluation::HalfPeriodDecay<Symbolic> oscillating_half_period(const Symbolic& R, const Symbolic& zeta) {
    const Symbolic root = exp(-(pi<Symbolic>() * zeta / R / 2)), E = root * root, w(symbols().w);
    const Symbolic theta = pi<Symbolic>() * w / R;
    return {root, sin(theta) / w, 1 + 2 * E * cos(theta) + E * E};
}

/// Steps of the derivation for a claim on u and g.
std::vector<Step> steps_of_damping_functions(const std::string& motions, const FreeMotions& f) {
    return {{"Without its right side (20) has the solutions " + motions, ""},
            step("The first", "\\eta_i", f.first),
            step("The second", "\\eta_i", f.second),
            {"With them (A.3) gives the constants and (A.4), at tau = pi, v cos(phi_j) and v sin(phi_j)", ""}};
}

const Register claims_of_overdamped_modes([] {
    const Symbols& s = symbols();
    const std::vector<std::string> below{"R_i > 0", "0 <= zeta_i < 1"}, above{"R_i > 0", "zeta_i > 1"},
        at{"R_i > 0", "zeta_i = 1"};
    const Symbolic R(s.R), zeta(s.zeta), more(heavy()), one(1), x(s.tau / s.R);
    const auto damping_above = [] { return derived_damping_functions(derived_two_rates()); };
    const auto damping_at = [] { return derived_damping_functions(derived_double_rate()); };
    const auto response = [] {
        const auto [re, im] = derived_complex_response();
        return std::vector<ex>{re.subs(symbols().zeta == heavy()), im.subs(symbols().zeta == heavy())};
    };
    const auto phase = [](const Symbolic& ratio, const evaluation::HalfPeriodDecay<Symbolic>& h) {
        const Symbols& n = symbols();
        const ModeInScene<Symbolic> m{Symbolic(n.R), ratio, Symbolic(n.psi_ji), Symbolic(n.psi_li)};
        const auto f = evaluation::damping_functions_of_free_motion(Symbolic(n.R), ratio, h);
        return Values{paper::v_cosine(m, symbolic_start(), f.g, Symbolic(n.beta)),
                      paper::v_sine(m, symbolic_start(), f.u, Symbolic(n.beta))};
    };
    const auto phase_of = [](const FreeMotions& f) {
        const auto [v_cos, v_sin] = derived_phase(f);
        return std::vector<ex>{v_cos, v_sin};
    };
    const auto braces_of_two_rates = [=] {
        const evaluation::FreeMotion<Symbolic> free =
            evaluation::with_rates_in_tau(evaluation::free_motion_of_two_rates(x, more), R);
        return braces(free, evaluation::overdamped_one_minus_d_of_slow_rate(x, more, free.q));
    };
    const Symbolic rate_of_braces = braces_of_two_rates()[1];
    const auto both_one_minus_d = [=](const Symbolic& ratio, const FreeMotions& f) {
        const Symbolic q(derived_free_motions(f)[1]);
        return Values{evaluation::overdamped_one_minus_d_of_slow_rate(x, ratio, q),
                      evaluation::overdamped_one_minus_d_of_positive_terms(x, ratio)};
    };
    const auto derived_one_minus_d = [](const FreeMotions& f) {
        const ex difference = 1 - derived_free_motions(f)[0];
        return std::vector<ex>{difference, difference};
    };
    const auto derived_demand = [&s](const FreeMotions& f) {
        return s.R * s.R * rate(derived_braces(f) + s.u * GiNaC::sin(s.tau)) / GiNaC::sin(s.tau);
    };
    const std::vector<Step> steps_above = steps_of_damping_functions("of two decaying exponentials", derived_two_rates());
    const std::vector<Step> steps_at = steps_of_damping_functions("of a double rate", derived_double_rate());
    const auto claim = [](std::string id, std::vector<std::string> equations, std::string title,
                          std::vector<std::string> assumptions, std::function<Values()> kernel,
                          std::function<std::vector<ex>()> derived, std::vector<Step> steps = {}) {
        return Claim{.id = "overdamped/" + id,
                     .equations = std::move(equations),
                     .role = Role::shipped,
                     .title = std::move(title),
                     .assumptions = std::move(assumptions),
                     .kernel = std::move(kernel),
                     .derived = std::move(derived),
                     .steps = std::move(steps)};
    };
    std::vector<Claim> list{
        claim(
            "printed-damping-functions", {"28", "29"},
            "Below zeta = 1 the formulas in entire functions of w^2 are the printed ones", below,
            [=] { return values(evaluation::damping_functions_of_free_motion(R, zeta, oscillating_half_period(R, zeta))); },
            [=] {
                return std::vector<ex>{paper::first_damping_function(R, zeta).expression(),
                                       paper::second_damping_function(R, zeta).expression()};
            }),
        claim(
            "rates", {"21"}, "The square of w_1, and the slow rate without cancellation", {"zeta_i > 1"},
            [=] {
                return Values{square(evaluation::overdamped_w<Symbolic>(more)), evaluation::slow_rate<Symbolic>(more)};
            },
            [] {
                return std::vector<ex>{heavy() * heavy() - 1, heavy() - GiNaC::sqrt(heavy() * heavy() - 1)};
            }),
        claim(
            "response-above-resonance", {"23"}, "The response function in 1 / R, divided by its real part", above,
            [=] { return values(evaluation::complex_response_above_resonance(R, more)); }, response),
        claim(
            "response-of-heavy-damping", {"23"}, "The response function in 1 / R, divided by its imaginary part", above,
            [=] { return values(evaluation::complex_response_of_heavy_damping(R, more)); }, response),
        claim(
            "solves", {"20", "21"}, "Two decaying exponentials with friction and load satisfy the equation of motion", above,
            [] { return residual(derived_two_rates()); }, [] { return std::vector<ex>{0}; }),
        claim(
            "near-critical", {"28", "29"}, "Damping functions in C and S from the conditions at tau = pi", above,
            [=] {
                return values(
                    evaluation::damping_functions_of_free_motion(R, more, evaluation::half_period_near_critical(R, more)));
            },
            damping_above, steps_above),
        claim(
            "two-rates", {"28", "29"}, "Damping functions from two decaying exponentials", above,
            [=] {
                return values(
                    evaluation::damping_functions_of_free_motion(R, more, evaluation::half_period_of_two_rates(R, more)));
            },
            damping_above, steps_above),
        claim(
            "small-argument", {"28", "29"}, "Damping functions with the difference in (29) as one function", above,
            [=] {
                return values(
                    evaluation::overdamped_functions_small_argument(R, more, evaluation::half_period_of_two_rates(R, more)));
            },
            damping_above, steps_above),
        claim(
            "slow-rate", {"28", "29"}, "Damping functions with hyperbolic tangents of the two rates", above,
            [=] {
                return values(evaluation::overdamped_functions_slow_rate(R, more, evaluation::half_period_of_two_rates(R, more)));
            },
            damping_above, steps_above),
        claim(
            "phase", {"26", "27", "A.13", "A.14"}, "The initial values of an overdamped mode drop out as those of the paper's do",
            {"R_i > 0", "zeta_i > 1", "psi_li not zero"},
            [=] { return phase(more, evaluation::half_period_near_critical(R, more)); },
            [=] { return phase_of(derived_two_rates()); }, steps_above),
        claim(
            "free-motions-near-critical", {"A.8", "A.9"}, "Free motions from C and S", above,
            [=] { return values(evaluation::with_rates_in_tau(evaluation::free_motion_near_critical(x, more), R)); },
            [] { return derived_free_motions(derived_two_rates()); }),
        claim(
            "free-motions-of-two-rates", {"A.8", "A.9"}, "Free motions from two decaying exponentials", above,
            [=] { return values(evaluation::with_rates_in_tau(evaluation::free_motion_of_two_rates(x, more), R)); },
            [] { return derived_free_motions(derived_two_rates()); }),
        claim(
            "one-minus-d", {"A.8"}, "1 - d from the slow rate, and as a sum of positive terms", above,
            [=] { return both_one_minus_d(more, derived_two_rates()); },
            [=] { return derived_one_minus_d(derived_two_rates()); }),
        claim("braces", {"40", "A.15"}, "The braces of (40) with two derivatives", above, braces_of_two_rates,
              [] { return with_two_rates(derived_braces(derived_two_rates())); }),
        claim(
            "s-d-integrand", {"57"}, "The expression under the maximum in (57) from the rate of the braces", above,
            [=, &s] { return Values{evaluation::s_d_integrand_from_rate(Symbolic(s.tau), R, Symbolic(s.u), rate_of_braces)}; },
            [=] { return std::vector<ex>{derived_demand(derived_two_rates())}; }),
        claim(
            "s-d-integrand-from-start", {"57"}, "The expression in (57) in terms that vanish at the start one by one", above,
            [=, &s] {
                return Values{
                    evaluation::overdamped_s_d_integrand_from_start(Symbolic(s.tau), R, more, Symbolic(s.u), Symbolic(s.g))};
            },
            [=] { return std::vector<ex>{derived_demand(derived_two_rates())}; }),
        claim(
            "critical-solves", {"20", "21"}, "At zeta = 1 the motion with the factor tau satisfies the equation of motion", at,
            [] { return residual(derived_double_rate()); }, [] { return std::vector<ex>{0}; }),
        claim(
            "critical-damping-functions", {"28", "29"}, "Damping functions at zeta = 1 from the conditions at tau = pi", at,
            [=] {
                return values(
                    evaluation::damping_functions_of_free_motion(R, one, evaluation::half_period_near_critical(R, one)));
            },
            damping_at, steps_at),
        claim(
            "critical-phase", {"26", "27", "A.13", "A.14"}, "The initial values of a mode with zeta = 1 drop out too",
            {"R_i > 0", "zeta_i = 1", "psi_li not zero"},
            [=] { return phase(one, evaluation::half_period_near_critical(R, one)); },
            [=] { return phase_of(derived_double_rate()); }, steps_at),
        claim(
            "critical-free-motions", {"A.8", "A.9"}, "Free motions at zeta = 1", at,
            [=] { return values(evaluation::with_rates_in_tau(evaluation::free_motion_near_critical(x, one), R)); },
            [] { return derived_free_motions(derived_double_rate()); }),
        claim(
            "critical-one-minus-d", {"A.8"}, "1 - d at zeta = 1 in both forms", at,
            [=] { return both_one_minus_d(one, derived_double_rate()); },
            [=] { return derived_one_minus_d(derived_double_rate()); }),
        claim(
            "critical-braces", {"40", "A.15"}, "The braces of (40) with two derivatives at zeta = 1", at,
            [=] {
                return braces(evaluation::with_rates_in_tau(evaluation::free_motion_near_critical(x, one), R),
                              evaluation::overdamped_one_minus_d_of_positive_terms(x, one));
            },
            [] { return with_two_rates(derived_braces(derived_double_rate())); }),
        claim(
            "critical-s-d-integrand-from-start", {"57"}, "The expression in (57) at zeta = 1 in terms that vanish at the start",
            at,
            [=, &s] {
                return Values{
                    evaluation::overdamped_s_d_integrand_from_start(Symbolic(s.tau), R, one, Symbolic(s.u), Symbolic(s.g))};
            },
            [=] { return std::vector<ex>{derived_demand(derived_double_rate())}; }),
    };
    for (Claim& c : list) c.special_case = c.id.find("/critical-") != std::string::npos;
    return list;
});

} // namespace
} // namespace denhartog::derivation
