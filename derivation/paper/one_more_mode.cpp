// The sums over modes for every N, by induction on the loops that run: a sum over no mode is zero, and with an opaque sum so far
// one more mode adds its term. What is said of a sum so far is the statement for the modes before; the statement for all follows.
#include "denhartog/evaluation/mass.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/formulas/system.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/paper/derived.hpp"
#include "derivation/paper/modal_sums.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

namespace {

using Row1 = std::vector<Symbolic>;

ex tau_rate(const ex& e) { return e.diff(GiNaC::ex_to<GiNaC::symbol>(symbols().tau)); }

/// One mode, its symbols those of the first of several.
const SymbolicModes& mode() {
    static const SymbolicModes one = symbolic_modes(1);
    return one;
}

/// The motion of the mode from any initial values, times its shape at the contact.
ex motion_at_contact() {
    const Symbols& s = symbols();
    return derived_displacement_of_mass(1, Row::contact, {{s.eta_0, s.eta_prime_0}});
}

/// The hypothesis on the sums so far: (41) for the modes before.
ex displacement_so_far() {
    const Symbols& s = symbols();
    const PartialSums& p = partial_sums();
    return (p.x + s.beta * p.G) * GiNaC::cos(s.tau) + (p.x_prime + s.beta * p.U) * GiNaC::sin(s.tau) + s.beta * p.F;
}

Symbolic one_more_G(const Row1& psi) {
    return paper::damping_function_of_mass<Symbolic>(psi, mode().psi_j, mode().R, mode().g, Symbolic(partial_sums().G));
}
Symbolic one_more_U(const Row1& psi) {
    return paper::damping_function_of_mass<Symbolic>(psi, mode().psi_j, mode().R, mode().u, Symbolic(partial_sums().U));
}
Symbolic one_more_H() {
    return paper::H<Symbolic>(mode().psi_j, mode().R, mode().zeta, mode().u, mode().g, Symbolic(partial_sums().H));
}
Symbolic one_more_F() {
    const SymbolicModes& m = mode();
    return paper::friction_motion_of_mass<Symbolic>(Symbolic(symbols().tau), m.psi_k, m.psi_j, m.R, m.zeta, m.u, m.g,
                                                    Symbolic(partial_sums().F));
}
Symbolic one_more_S() {
    const SymbolicModes& m = mode();
    const Row1 s_i{paper::s_d_integrand(Symbolic(symbols().tau), m.R[0], m.zeta[0], m.u[0], m.g[0])};
    return paper::sum_over_contact<Symbolic>(m.psi_j, s_i, Symbolic(partial_sums().S));
}

/// Initial values of a mass: those of the modes before, for which (31), (32) or (42), (43) hold, and those of the mode.
std::pair<ex, ex> one_more_start(Row row) {
    const Symbols& s = symbols();
    const PartialSums& p = partial_sums();
    const ex c = GiNaC::cos(s.phi_j), sine = GiNaC::sin(s.phi_j);
    const auto [x, x_prime] = derived_start_of_mass(1, row, c, sine);
    return {p.V_r * c - p.V_i * sine - s.beta * p.G + x, -(p.V_r * sine + p.V_i * c) - s.beta * p.U + x_prime};
}

/// Re and Im of V exp(i phi_j), V the sum so far and the mode's.
std::vector<ex> one_more_response(Row row) {
    const Symbols& s = symbols();
    const PartialSums& p = partial_sums();
    const auto [re, im] = derived_response(1, row);
    const ex c = GiNaC::cos(s.phi_j), sine = GiNaC::sin(s.phi_j);
    return {(p.V_r + re) * c - (p.V_i + im) * sine, (p.V_r + re) * sine + (p.V_i + im) * c};
}

const Register claims_of_one_more_mode([] {
    const Symbols& s = symbols();
    const PartialSums& p = partial_sums();
    const Symbolic tau(s.tau), beta(s.beta);
    const evaluation::HarmonicPart<Symbolic> harmonic{Symbolic(s.A), Symbolic(s.B)};
    const ex harmonic_motion = s.A * GiNaC::cos(s.tau) + s.B * GiNaC::sin(s.tau);
    const auto with_rates = [](const ex& e) { return std::vector<ex>{e, tau_rate(e), tau_rate(tau_rate(e))}; };
    const std::vector<Step> by_induction{
        {"For no mode the sums are zero; if the statement holds for the modes before, it holds with one more, hence for every N",
         ""}};
    const auto claim = [&](std::string id, std::vector<std::string> equations, std::string title, std::function<Values()> kernel,
                           std::function<std::vector<ex>()> derived) {
        return Claim{.id = std::move(id),
                     .equations = std::move(equations),
                     .role = Role::step,
                     .title = std::move(title),
                     .assumptions = {"any number of modes before"},
                     .kernel = std::move(kernel),
                     .derived = std::move(derived),
                     .steps = by_induction};
    };
    Claim without_modes = claim(
        "46/no-mode", {"46"}, "Over no mode the motion that callers get is its harmonic part",
        [=] {
            const auto motion = evaluation::motion_of_mass<Symbolic>(cos(tau), sin(tau), harmonic, beta, {}, {});
            return Values{motion.x, motion.x_prime, motion.x_double_prime};
        },
        [=] { return with_rates(harmonic_motion); });
    without_modes.special_case = true; // what is added there is zero
    return std::vector<Claim>{
        claim(
            "33/no-mode", {"33", "34", "35", "41", "46", "56", "64", "19"}, "The sums over no mode are zero",
            [=] {
                const Row1 none;
                const Complex<Symbolic> V =
                    paper::complex_response_of_mass<Symbolic>(none, none, none, std::span<const Complex<Symbolic>>());
                return Values{V.re,
                              V.im,
                              paper::damping_function_of_mass<Symbolic>(none, none, none, none),
                              paper::sum_over_contact<Symbolic>(none, none),
                              paper::H<Symbolic>(none, none, none, none, none),
                              paper::friction_motion_of_mass<Symbolic>(tau, none, none, none, none, none, none),
                              paper::entry_of_product<Symbolic>(none, none),
                              paper::entry_of_damping<Symbolic>(none, none, none, none)};
            },
            [] { return std::vector<ex>(8, ex(0)); }),
        without_modes,
        claim(
            "33/one-more-mode", {"33"}, "With one more mode V_dk is still the complex amplitude of the harmonic part",
            [=, &s, &p] {
                const SymbolicModes& m = mode();
                const Complex<Symbolic> V =
                    paper::complex_response_of_mass<Symbolic>(m.psi_k, m.psi_l, m.R, m.v, {Symbolic(p.V_r), Symbolic(p.V_i)});
                return Values{times_cosine(V, Symbolic(s.tau + s.phi_j))};
            },
            [&s, &p] {
                const ex angle = s.tau + s.phi_j;
                ex sum = p.V_r * GiNaC::cos(angle) - p.V_i * GiNaC::sin(angle);
                for (const ModalStart& start : derived_starts(1, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j)))
                    sum += start.psi_k * (start.harmonic_cosine * GiNaC::cos(s.tau) + start.harmonic_sine * GiNaC::sin(s.tau));
                return std::vector<ex>{sum};
            }),
        claim(
            "31/one-more-mode", {"30", "31", "32", "34", "35"}, "With one more mode the relations of the mass in contact hold",
            [=] {
                const auto [X, rate] = one_more_start(Row::contact);
                return Values{paper::V_cosine(Symbolic(X), one_more_G(mode().psi_j), beta),
                              Symbolic(paper::V_sine(one_more_U(mode().psi_j), beta).expression() - rate)};
            },
            [] { return one_more_response(Row::contact); }),
        claim(
            "42/one-more-mode", {"42", "43"}, "With one more mode the relations of the mass k hold",
            [=] {
                const auto [x, rate] = one_more_start(Row::mass);
                return Values{paper::V_k_cosine(Symbolic(x), one_more_G(mode().psi_k), beta),
                              paper::V_k_sine(Symbolic(rate), one_more_U(mode().psi_k), beta)};
            },
            [] { return one_more_response(Row::mass); }),
        claim(
            "41/one-more-mode", {"41"}, "With one more mode the displacement from its initial values is the sum of the motions",
            [=, &s, &p] {
                const ex psi = mode().psi_k[0].expression();
                return Values{paper::displacement(tau, Symbolic(p.x + psi * s.eta_0), Symbolic(p.x_prime + psi * s.eta_prime_0),
                                                  one_more_G(mode().psi_k), one_more_U(mode().psi_k), beta, one_more_F())};
            },
            [&s] {
                return std::vector<ex>{displacement_so_far() +
                                       derived_displacement_of_mass(1, Row::mass, {{s.eta_0, s.eta_prime_0}})};
            }),
        claim(
            "46/one-more-mode", {"46"},
            "With one more mode the steady displacement has the braces of that mode more, in both forms",
            [=, &p] {
                const SymbolicModes& m = mode();
                const ex braces = paper::friction_motion(tau, m.R[0], m.zeta[0], m.u[0], m.g[0]).expression();
                const Row1 w{m.psi_k[0] * m.psi_j[0] * m.R[0] * m.R[0]};
                const std::vector<evaluation::FrictionMotion<Symbolic>> y{
                    {Symbolic(braces), Symbolic(tau_rate(braces)), Symbolic(tau_rate(tau_rate(braces)))}};
                const auto motion = evaluation::motion_of_mass<Symbolic>(
                    cos(tau), sin(tau), harmonic, beta, w, y, {Symbolic(p.F), Symbolic(p.F_prime), Symbolic(p.F_second)});
                return Values{one_more_F(), motion.x, motion.x_prime, motion.x_double_prime};
            },
            [=, &s, &p] {
                // friction alone: (40) without the harmonic motion, over beta
                const SymbolicModes& m = mode();
                const ex weight = m.psi_j[0].expression() * GiNaC::pow(m.R[0].expression(), 2) * s.beta;
                const ex alone =
                    derived_displacement_of_mass(1, Row::mass, {{-weight * m.g[0].expression(), -weight * m.u[0].expression()}}) /
                    s.beta;
                std::vector<ex> motion = with_rates(harmonic_motion + s.beta * alone);
                motion[0] += s.beta * p.F;
                motion[1] += s.beta * p.F_prime;
                motion[2] += s.beta * p.F_second;
                motion.insert(motion.begin(), p.F + alone);
                return motion;
            }),
        claim(
            "54/one-more-mode", {"54", "55"},
            "With one more mode -x_j' / sin(tau) is X_j + beta G_j - beta S less x_j'(0) cot(tau), which (30) makes zero for all "
            "modes",
            [=, &s, &p] {
                const ex psi = mode().psi_j[0].expression(), rate = p.x_prime + psi * s.eta_prime_0;
                const Symbolic margin =
                    paper::sliding_margin(Symbolic(p.x + psi * s.eta_0), one_more_G(mode().psi_j), one_more_S(), beta);
                return Values{Symbolic(margin.expression() - rate * GiNaC::cos(s.tau) / GiNaC::sin(s.tau))};
            },
            [&s, &p] {
                const ex before = p.x + s.beta * p.G - s.beta * p.S - p.x_prime * GiNaC::cos(s.tau) / GiNaC::sin(s.tau);
                return std::vector<ex>{before - tau_rate(motion_at_contact()) / GiNaC::sin(s.tau)};
            }),
        claim(
            "66/one-more-mode", {"64", "66"},
            "With one more mode the load on the contact at tau = 0 has the load of that mode more",
            [=, &s, &p] {
                const ex psi = mode().psi_j[0].expression();
                return Values{
                    paper::contact_load_at_start(Symbolic(p.x + psi * s.eta_0), one_more_G(mode().psi_j), one_more_H(), beta)};
            },
            [&s, &p] {
                const ex psi = mode().psi_j[0].expression();
                const ex of_mode = psi * psi * s.beta - tau_rate(tau_rate(motion_at_contact())).subs(s.tau == 0);
                return std::vector<ex>{p.x + s.beta * p.G - s.beta * p.H + of_mode};
            }),
        claim(
            "72/one-more-mode", {"72"},
            "With one more mode H_j plus the sum of squares has psi_ji^2 times (71) of that mode more",
            [=, &p] {
                const Symbolic squares(p.squares + GiNaC::pow(mode().psi_j[0].expression(), 2));
                return Values{paper::static_friction_demand(one_more_H(), Symbolic(ex(1)), squares)};
            },
            [&p] {
                const Symbols& n = symbols();
                const SymbolicModes& m = mode();
                const ex psi = m.psi_j[0].expression();
                const ex alone = derived_modal_displacement().subs(n.eta_prime_0 == 0);
                const ex expression = (n.eta_0 + n.psi_ji * n.R * n.R * n.g * n.beta) * GiNaC::sin(n.tau) + tau_rate(alone);
                const ex at_zero = tau_rate(expression).subs(n.tau == 0) / (n.beta * n.psi_ji);
                return std::vector<ex>{p.H + p.squares +
                                       psi * psi *
                                           at_zero.subs(lst{n.R == m.R[0].expression(), n.zeta == m.zeta[0].expression(),
                                                            n.u == m.u[0].expression(), n.g == m.g[0].expression()})};
            }),
        claim(
            "19/one-more-mode", {"19"},
            "With one more factor pair, and one more mode, an entry of the damping matrix has its term more",
            [=, &p] {
                const SymbolicModes& m = mode();
                const Symbolic so_far(p.entry);
                return Values{paper::entry_of_product<Symbolic>(m.psi_k, m.psi_j, so_far),
                              paper::entry_of_damping<Symbolic>(m.R, m.zeta, m.psi_k, m.psi_j, so_far)};
            },
            [&p] {
                const SymbolicModes& m = mode();
                const ex a = m.psi_k[0].expression(), b = m.psi_j[0].expression();
                const GiNaC::matrix column{{a},
                                           {b}}; // the term of (19) as a matrix, of which this is an entry beside the diagonal
                const ex term = column.mul(column.transpose()).mul_scalar(2 * m.zeta[0].expression() * m.R[0].expression())(0, 1);
                return std::vector<ex>{p.entry + a * b, p.entry + term};
            }),
    };
});

} // namespace

} // namespace denhartog::derivation
