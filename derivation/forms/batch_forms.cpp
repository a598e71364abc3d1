// The forms that arrays are computed by, each equal to the paper's formula as a function of its symbols. The exponential, the
// products of the half angle and the series stand for themselves here; what they are in double is tested against long double.
#include "denhartog/evaluation/batch_forms.hpp"
#include "denhartog/evaluation/friction_motion.hpp"

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

using evaluation::ArrayMode;
using evaluation::ArrayWeights;

evaluation::Exponential<Symbolic> exponential_of(const Symbolic& x, const ArrayMode<Symbolic>& m) {
    const Symbolic delta = m.two_pi_zeta * x, half = exp(-delta / 2);
    return {half, half, evaluation::exp_minus_one(Symbolic(-delta))};
}

// Products of sine and cosine of pi w / (2 R), the angle as a difference.
evaluation::HalfAngleProducts<Symbolic> products_of_difference(const Symbolic& x, const Symbolic& zeta) {
    const Symbolic angle = pi<Symbolic>() * ((1 - evaluation::one_minus_w(zeta)) * x);
    const Symbolic s = sin(angle), c = cos(angle);
    return {s * c, c * c};
}

// The products of the half angle, of the angle as a product.
evaluation::HalfAngleProducts<Symbolic> products_of_product(const Symbolic& x, const Symbolic& zeta) {
    const Symbolic angle = pi<Symbolic>() * (sqrt(Symbolic((1 - zeta) * (1 + zeta))) * x);
    const Symbolic s = sin(angle), c = cos(angle);
    return {s * c, c * c};
}

// (23), (28) and (29), the last in the form for small or for large R.
Values mode_functions(const Symbolic& R, const Symbolic& zeta, const evaluation::HalfAngleProducts<Symbolic>& h, bool large) {
    const Symbolic x = 1 / (2 * R);
    const ArrayMode<Symbolic> m = evaluation::array_mode(zeta);
    const auto e = exponential_of(x, m);
    const Complex<Symbolic> v = evaluation::array_response(R, m);
    const Symbolic inverse = evaluation::inverse_denominator(e, h);
    const Symbolic u = evaluation::array_first_damping_function(x, m, e, h, inverse);
    if (!large) return {v.re, v.im, u, evaluation::array_second_damping_function(m, e, h, inverse)};
    const Symbolic q = 2 * pi<Symbolic>() * x;
    return {v.re, v.im, u,
            evaluation::array_second_damping_function_of_large_ratio(m.two_pi_zeta * x, q * q,
                                                                     sinhc_less_sinc_over_square(q, zeta), e, inverse)};
}

const Register claims_of_batch_forms([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1"};
    const Symbolic R(s.R), zeta(s.zeta);
    const auto functions = [&s] {
        const Complex<Symbolic> v = paper::complex_response(Symbolic(s.R), Symbolic(s.zeta));
        return std::vector<ex>{v.re.expression(), v.im.expression(),
                               paper::first_damping_function(Symbolic(s.R), Symbolic(s.zeta)).expression(),
                               paper::second_damping_function(Symbolic(s.R), Symbolic(s.zeta)).expression()};
    };
    const auto braces = [&s](int order) {
        const ex value =
            paper::friction_motion(Symbolic(s.tau), Symbolic(s.R), Symbolic(s.zeta), Symbolic(s.u), Symbolic(s.g)).expression();
        return value.diff(GiNaC::ex_to<GiNaC::symbol>(s.tau), static_cast<unsigned>(order));
    };
    return std::vector<Claim>{
        {.id = "batch/mode-functions",
         .equations = {"23", "28", "29"},
         .role = Role::shipped,
         .title = "The functions of a mode over arrays, the half angle as a difference",
         .assumptions = domain,
         .kernel = [=] { return mode_functions(R, zeta, products_of_difference(Symbolic(1 / (2 * R)), zeta), false); },
         .derived = functions},
        {.id = "batch/mode-functions-of-heavy-damping",
         .equations = {"23", "28", "29"},
         .role = Role::shipped,
         .title = "The functions of a mode over arrays, the half angle as a product",
         .assumptions = domain,
         .kernel = [=] { return mode_functions(R, zeta, products_of_product(Symbolic(1 / (2 * R)), zeta), false); },
         .derived = functions},
        {.id = "batch/mode-functions-of-large-ratio",
         .equations = {"23", "28", "29"},
         .role = Role::shipped,
         .title = "The functions of a mode over arrays, the difference in (29) as one series",
         .assumptions = {"R_i > 0", "0 < zeta_i < 1"},
         .kernel = [=] { return mode_functions(R, zeta, products_of_difference(Symbolic(1 / (2 * R)), zeta), true); },
         .derived = functions},
        {.id = "batch/weights",
         .equations = {"33", "34", "35", "64", "65"},
         .role = Role::shipped,
         .title = "A mode's terms in the sums at the mass in contact with weights that do not depend on r",
         .assumptions = {"psi = phi / r", "R_i = r / r_n,i"},
         .kernel =
             [&s] {
                 const ArrayWeights<Symbolic> m = evaluation::array_weights(Symbolic(s.psi_ji * s.r), Symbolic(s.psi_li * s.r),
                                                                            Symbolic(s.r / s.R), Symbolic(s.zeta));
                 const Symbolic r_square(s.r * s.r);
                 return Values{m.load * Symbolic(s.V_kr), m.contact * Symbolic(s.u),
                               evaluation::term_of_H(m, Symbolic(s.R), Symbolic(s.u), Symbolic(s.g)) / r_square,
                               m.square / r_square};
             },
         .derived =
             [&s] {
                 const std::vector<Symbolic> psi_j{Symbolic(s.psi_ji)}, psi_l{Symbolic(s.psi_li)}, R_i{Symbolic(s.R)},
                     zeta_i{Symbolic(s.zeta)}, u{Symbolic(s.u)}, g{Symbolic(s.g)}, one{Symbolic(1)};
                 const std::vector<Complex<Symbolic>> v{{Symbolic(s.V_kr), Symbolic(s.V_ki)}};
                 const auto span = [](const auto& x) { return std::span(x.data(), x.size()); };
                 return std::vector<ex>{
                     paper::complex_response_of_mass(span(psi_j), span(psi_l), span(R_i), span(v)).re.expression(),
                     paper::damping_function_of_mass(span(psi_j), span(psi_j), span(R_i), span(u)).expression(),
                     paper::H(span(psi_j), span(R_i), span(zeta_i), span(u), span(g)).expression(),
                     paper::sum_over_contact(span(psi_j), span(one)).expression()};
             }},
        {.id = "batch/demand-equation",
         .equations = {"57"},
         .role = Role::step,
         .title = "The velocity N in (57) obeys N'' + N = Z, in which the cosine has dropped out; and the braces in it",
         .assumptions = domain,
         .kernel =
             [=, &s] {
                 const Symbolic w = evaluation::oscillating_w(zeta);
                 const evaluation::FreeMotion<Symbolic> free = evaluation::oscillating_free_motion(Symbolic(s.tau), R, zeta, w);
                 const evaluation::FrictionMotion<Symbolic> y = evaluation::friction_motion_of(
                     free, evaluation::one_minus_d_half_angle(Symbolic(s.tau / s.R), zeta, w, free.q), R, Symbolic(s.u),
                     Symbolic(s.g));
                 return Values{-(2 * zeta * R * y.double_prime + (1 - R) * (1 + R) * y.prime), y.value};
             },
         .derived =
             [=, &s] {
                 const GiNaC::symbol& tau = GiNaC::ex_to<GiNaC::symbol>(s.tau);
                 const ex N = s.R * s.R * (braces(1) + s.u * GiNaC::cos(s.tau));
                 return std::vector<ex>{N.diff(tau, 2) + N, braces(0)};
             }},
        {.id = "batch/demand-at-the-ends",
         .equations = {"57", "71"},
         .role = Role::step,
         .title = "R Z at the end of the half-period; at its beginning the opposite less 4 zeta",
         .assumptions = domain,
         .kernel =
             [=] {
                 const Symbolic u(paper::first_damping_function(R, zeta).expression()),
                     g(paper::second_damping_function(R, zeta).expression());
                 const Symbolic excess = evaluation::excess_at_the_end(Symbolic(2 * zeta), R, u, g);
                 return Values{excess, -(excess + 4 * zeta)};
             },
         .derived =
             [=, &s] {
                 const ex Z = -(2 * s.zeta * s.R * braces(2) + (1 - s.R * s.R) * braces(1));
                 const ex of_mode = Z.subs(GiNaC::lst{s.u == paper::first_damping_function(R, zeta).expression(),
                                                      s.g == paper::second_damping_function(R, zeta).expression()});
                 return std::vector<ex>{s.R * of_mode.subs(s.tau == GiNaC::Pi), s.R * of_mode.subs(s.tau == 0)};
             }},
    };
});

} // namespace
} // namespace denhartog::derivation
