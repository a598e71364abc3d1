// The selections as shipped, each with what its forms stand for.
#include "denhartog/evaluation/demand.hpp"

#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/forms/overdamped_motion.hpp"
#include "derivation/selections/selections.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

std::vector<Placed> parts(const Complex<Placed>& v) { return {v.re, v.im}; }
std::vector<Placed> parts(const evaluation::DampingFunctions<Placed>& f) { return {f.u, f.g}; }
std::vector<Placed> parts(const evaluation::FreeMotion<Placed>& f) { return {f.d, f.q, f.d_prime, f.q_prime, f.q_double_prime}; }

Symbolic number(const ex& e) { return Symbolic(e); }

bool is_paper(const ex& zeta) { return !zeta.is_equal(1) && !zeta.is_equal(heavy()); }
FreeMotions beyond_paper(const ex& zeta) { return zeta.is_equal(1) ? derived_double_rate() : derived_two_rates(); }

std::vector<ex> at_ratio(std::vector<ex> values, const ex& R) {
    for (ex& value : values) value = value.subs(symbols().R == R);
    return values;
}

std::vector<Selection> shipped_selections() {
    const auto response = [](const ex&, const ex& R, const ex& zeta) {
        const Complex<Symbolic> v = paper::complex_response(number(R), number(zeta));
        return std::vector<ex>{v.re.expression(), v.im.expression()};
    };
    const auto damping = [](const ex&, const ex& R, const ex& zeta) {
        if (!is_paper(zeta)) return at_ratio(derived_damping_functions(beyond_paper(zeta)), R);
        return std::vector<ex>{first_function(R, zeta), second_function(R, zeta)};
    };
    const auto free = [](const ex&, const ex& R, const ex& zeta) {
        if (!is_paper(zeta)) return at_ratio(derived_free_motions(beyond_paper(zeta)), R);
        const Symbolic t(symbols().tau), r(R), z(zeta);
        const ex q_prime = paper::q_prime(t, r, z).expression();
        return std::vector<ex>{paper::d(t, r, z).expression(), paper::q(t, r, z).expression(),
                               paper::d_prime(t, r, z).expression(), q_prime,
                               q_prime.diff(GiNaC::ex_to<GiNaC::symbol>(symbols().tau))};
    };
    const auto braces = [](const ex& tau, const ex& R, const ex& zeta) {
        const Symbols& s = symbols();
        if (!is_paper(zeta)) return at_ratio(with_two_rates(derived_braces(beyond_paper(zeta))), R);
        return with_two_rates(
            paper::friction_motion(number(tau), number(R), number(zeta), number(s.u), number(s.g)).expression());
    };
    const auto damping_of = [](const ex& R, const ex& zeta) { // beyond the paper's modes what is said holds of any u and g
        const Symbols& s = symbols();
        return is_paper(zeta) ? std::pair(first_function(R, zeta), second_function(R, zeta)) : std::pair(s.u, s.g);
    };
    const auto demand = [=](const ex& tau, const ex& R, const ex& zeta) {
        const Symbols& s = symbols();
        const auto [u, g] = damping_of(R, zeta);
        if (tau.is_zero()) return std::vector<ex>{1 + g + 2 * zeta * R * u};
        const GiNaC::lst of_mode{s.u == u, s.g == g};
        const std::vector<ex> motion = braces(s.tau, R, zeta);
        const ex rate = motion[1].subs(of_mode), second = motion[2].subs(of_mode);
        if (tau.is_equal(GiNaC::Pi)) return std::vector<ex>{-R * R * second.subs(s.tau == GiNaC::Pi)};
        return std::vector<ex>{R * R * (rate + u * GiNaC::cos(s.tau)) / GiNaC::sin(s.tau)};
    };
    const auto take_braces = [](const Placed& tau, const Placed& R, const Placed& zeta) {
        const auto f = evaluation::friction_motion(tau, R, zeta, evaluation::w_if_oscillating(zeta),
                                                   Placed(number(symbols().u), 0.5), Placed(number(symbols().g), 0.25));
        return std::vector<Placed>{f.value, f.prime, f.double_prime};
    };
    const auto take_demand = [=](const Placed& tau, const Placed& R, const Placed& zeta) {
        const auto [u, g] = damping_of(R.symbolic().expression(), zeta.symbolic().expression());
        return std::vector<Placed>{evaluation::s_d_integrand_of(tau, R, zeta, {Placed(number(u), 0.5), Placed(number(g), 0.25)})};
    };
    using P = const Placed&;
    return {{"complex_response", [](P, P R, P zeta) { return parts(evaluation::complex_response(R, zeta)); }, response},
            {"selected_damping_functions", [](P, P R, P zeta) { return parts(evaluation::selected_damping_functions(R, zeta)); },
             damping},
            {"free_motion",
             [](P tau, P R, P zeta) { return parts(evaluation::free_motion(tau, R, zeta, evaluation::w_if_oscillating(zeta))); },
             free},
            {"friction_motion", take_braces, braces},
            {"s_d_integrand_of", take_demand, demand}};
}

const Register claims_of_selections([] {
    std::vector<Claim> list;
    const std::vector<std::vector<std::string>> equations{
        {"23"}, {"28", "29"}, {"A.8", "A.9"}, {"40", "A.8", "A.9"}, {"57", "71"}};
    const std::vector<Selection> selections = shipped_selections();
    for (std::size_t i = 0; i < selections.size(); ++i)
        list.push_back({.id = "selection/" + selections[i].name,
                        .equations = equations[i],
                        .role = Role::step,
                        .title = "Every form that the selection can take is proved on a domain that contains the place",
                        .assumptions = {"R_i > 0", "zeta_i >= 0"},
                        .check = [selection = selections[i]] { return check_selection(selection); }});
    return list;
});

} // namespace

} // namespace denhartog::derivation
