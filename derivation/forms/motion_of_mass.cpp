// The answer to callers for (46): a harmonic part and the braces of the modes, with the derivatives that searches follow.
#include "denhartog/evaluation/mass.hpp"
#include "denhartog/formulas/mode.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/paper/modal_sums.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

const GiNaC::symbol& time_symbol() {
    static const GiNaC::symbol tau = GiNaC::ex_to<GiNaC::symbol>(symbols().tau);
    return tau;
}

/// The harmonic part in the symbols of (46).
evaluation::HarmonicPart<Symbolic> shipped_harmonic_part() {
    const Symbols& s = symbols();
    return evaluation::harmonic_part(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.beta));
}

/// The motion by the template that callers get, the braces of (40) of each mode with their rates.
Values shipped_motion(int N) {
    const Symbols& s = symbols();
    const SymbolicModes m = symbolic_modes(N);
    std::vector<Symbolic> weights;
    std::vector<evaluation::FrictionMotion<Symbolic>> y;
    for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) {
        weights.push_back(m.psi_k[i] * m.psi_j[i] * m.R[i] * m.R[i]);
        const ex braces = paper::friction_motion(Symbolic(s.tau), m.R[i], m.zeta[i], m.u[i], m.g[i]).expression();
        y.push_back({Symbolic(braces), Symbolic(braces.diff(time_symbol())), Symbolic(braces.diff(time_symbol(), 2))});
    }
    const evaluation::MotionOfMass<Symbolic> motion = evaluation::motion_of_mass<Symbolic>(
        cos(Symbolic(s.tau)), sin(Symbolic(s.tau)), shipped_harmonic_part(), Symbolic(s.beta), weights, y);
    return {motion.x, motion.x_prime, motion.x_double_prime};
}

/// The displacement and its derivatives from (44), (45) and the sum of the modes.
std::vector<ex> derived_motion(int N) {
    const Symbols& s = symbols();
    const SymbolicModes m = symbolic_modes(N);
    const auto [c, sine] = derived_steady_phase(s.V_jr, s.V_ji, s.U_j);
    std::vector<std::pair<ex, ex>> friction_alone;
    for (const ModalStart& start : derived_starts(N, c, sine))
        friction_alone.emplace_back(start.eta_0 - start.harmonic_cosine, start.eta_prime_0 - start.harmonic_sine);
    const ex x = (s.V_kr * c - s.V_ki * sine) * GiNaC::cos(s.tau) - (s.V_kr * sine + s.V_ki * c) * GiNaC::sin(s.tau) +
                 derived_displacement_of_mass(N, Row::mass, friction_alone);
    return {x, x.diff(time_symbol()), x.diff(time_symbol(), 2)};
}

const Register claims_of_motion_of_mass([] {
    const Symbols& s = symbols();
    const std::vector<std::string> sliding{"sliding regime, beta |U_dj| <= |V_dj|", "V_dj not zero"};
    std::vector<Claim> list;
    list.push_back({.id = "46/harmonic-part",
                    .equations = {"42", "43", "46"},
                    .role = Role::shipped,
                    .title = "The harmonic part of the motion of a mass without angles",
                    .assumptions = sliding,
                    .kernel =
                        [] {
                            const evaluation::HarmonicPart<Symbolic> h = shipped_harmonic_part();
                            return Values{h.A, h.B};
                        },
                    .derived =
                        [&s] {
                            const auto [x_k0, x_prime_k0] = derived_initial_state();
                            return std::vector<ex>{x_k0 + s.beta * s.G_k, x_prime_k0 + s.beta * s.U_k};
                        }});
    for (int N = 1; N <= 2; ++N) {
        std::vector<std::string> modes = sliding;
        modes.insert(modes.end(), {"0 <= tau <= pi", "N = " + std::to_string(N) + " modes"});
        list.push_back({.id = "46/motion-of-mass/N=" + std::to_string(N),
                        .equations = {"46"},
                        .role = Role::shipped,
                        .title = "Displacement, velocity and acceleration of a mass as callers get them",
                        .assumptions = modes,
                        .kernel = [N] { return shipped_motion(N); },
                        .derived = [N] { return derived_motion(N); }});
    }
    return list;
});

} // namespace

} // namespace denhartog::derivation
