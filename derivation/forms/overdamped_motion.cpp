#include "derivation/forms/overdamped_motion.hpp"

#include <map>
#include <stdexcept>

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/provenance.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

namespace {

/// Sum and product of the rates sigma for which exp(sigma tau) solves (20) without its right side, both times their power of R.
std::pair<ex, ex> derived_sum_and_product(const ex& zeta) {
    const Symbols& s = symbols();
    const GiNaC::symbol sigma("sigma");
    const ex eta = GiNaC::exp(sigma * s.tau);
    const ex left = rate(rate(eta)) + 2 * zeta / s.R * rate(eta) + from_premise() * eta / (s.R * s.R); // (20)
    const ex polynomial = (left / eta).expand();
    return {(-polynomial.coeff(sigma, 1) * s.R).normal(), (polynomial.coeff(sigma, 0) * s.R * s.R).normal()};
}

} // namespace

ex rate(const ex& e) { return e.diff(GiNaC::ex_to<GiNaC::symbol>(symbols().tau)); }

/// A damping ratio above 1.
const ex& heavy() {
    static const ex zeta = new_symbol("zeta_h", "\\zeta_i", GiNaC::numeric(101, 100), 5, {GiNaC::numeric(1), {}});
    return zeta;
}

/// Two different real rates: half the sum, more or less the root of its square less the product.
FreeMotions derived_two_rates() {
    const Symbols& s = symbols();
    const auto [sum, product] = derived_sum_and_product(heavy());
    const ex root = GiNaC::sqrt((sum * sum / 4 - product).expand());
    return {heavy(), GiNaC::exp((sum / 2 + root) * s.tau / s.R), GiNaC::exp((sum / 2 - root) * s.tau / s.R)};
}

/// A double rate at zeta = 1: the second motion has the factor tau.
FreeMotions derived_double_rate() {
    const Symbols& s = symbols();
    const auto [sum, product] = derived_sum_and_product(1);
    if (!(sum * sum / 4 - product).is_zero()) throw std::logic_error("the rates differ at zeta = 1");
    const ex decay = GiNaC::exp(sum / 2 * s.tau / s.R);
    return {1, decay, s.tau * decay};
}

/// The combination of the two motions with a displacement and a velocity at tau = 0.
ex derived_start(const FreeMotions& f, const ex& displacement, const ex& velocity) {
    const Symbols& s = symbols();
    const ex motion = s.A * f.first + s.B * f.second;
    const ex constants =
        GiNaC::lsolve(lst{motion.subs(s.tau == 0) == displacement, rate(motion).subs(s.tau == 0) == velocity}, lst{s.A, s.B});
    return motion.subs(constants);
}

/// v cos(phi_j) and v sin(phi_j) from the initial values and (A.4).
std::pair<ex, ex> derived_phase(const FreeMotions& f) {
    const Symbols& s = symbols();
    const ex forced =
        s.psi_ji * s.R * s.R * s.beta + s.psi_li * s.R * s.R * (s.v_cos * GiNaC::cos(s.tau) - s.v_sin * GiNaC::sin(s.tau));
    const ex eta = forced + derived_start(f, s.eta_0 - forced.subs(s.tau == 0), s.eta_prime_0 - rate(forced).subs(s.tau == 0));
    const ex by_25 = from_premise();
    const ex displacement = (eta.subs(s.tau == GiNaC::Pi) + by_25 * s.eta_0).expand();
    const ex velocity = (rate(eta).subs(s.tau == GiNaC::Pi) + by_25 * s.eta_prime_0).expand();
    const ex solution = GiNaC::lsolve(lst{displacement == 0, velocity == 0}, lst{s.v_cos, s.v_sin});
    return {s.v_cos.subs(solution), s.v_sin.subs(solution)};
}

/// u and g: what friction alone adds to -v sin(phi_j) and v cos(phi_j), over psi_ji beta / psi_li.
std::vector<ex> derived_damping_functions(const FreeMotions& f) {
    static std::map<ex, std::vector<ex>, GiNaC::ex_is_less> known; // a selection asks at each of its points
    std::vector<ex>& functions = known[lst{f.zeta, f.first, f.second}];
    if (functions.empty()) {
        const Symbols& s = symbols();
        const auto [v_cos, v_sin] = derived_phase(f);
        const ex unit = s.psi_li / (s.psi_ji * s.beta);
        const lst at_rest{s.eta_0 == 0, s.eta_prime_0 == 0};
        functions = {-v_sin.subs(at_rest) * unit, v_cos.subs(at_rest) * unit};
    }
    return functions;
}

/// The braces of (40): what is left of the motion over beta psi_ji R^2 once its harmonic part is taken off.
ex derived_braces(const FreeMotions& f) { return 1 + derived_start(f, -(1 + symbols().g), -symbols().u); }

std::vector<ex> with_two_rates(const ex& e) { return {e, rate(e), rate(rate(e))}; }

std::vector<ex> derived_free_motions(const FreeMotions& f) {
    const Symbols& s = symbols();
    const ex d = derived_start(f, 1, 0), q = derived_start(f, 0, 1) / s.R;
    return {d, q, rate(d), rate(q), rate(rate(q))};
}

} // namespace denhartog::derivation
