// Section 3.1, (74), (75): when the contact sticks. (73) is in section_2_1_formulation.cpp.
#include "denhartog/formulas/stuck.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/paper/system_matrices.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::matrix;

namespace {

/// Displacements, velocities and accelerations of N masses as symbols; the contact is the first mass, and is not accelerated.
struct HeldMotion {
    matrix x, x_prime, x_double_prime;
};

HeldMotion held_motion(int N) {
    const SymbolicModes m = symbolic_modes(N);
    HeldMotion motion{matrix(N, 1), matrix(N, 1), matrix(N, 1)};
    for (int k = 0; k < N; ++k) {
        motion.x(k, 0) = m.u[k].expression();
        motion.x_prime(k, 0) = m.g[k].expression();
        motion.x_double_prime(k, 0) = k == 0 ? ex(0) : m.v[k].re.expression();
    }
    return motion;
}

/// The rest of (6), which is beta times the member of (3)'s set: row 1 of the load less inertia, damping and stiffness forces.
ex friction_needed(int N, const ex& direct) {
    const SymbolicSystem& s = symbolic_system(N);
    const HeldMotion motion = held_motion(N);
    matrix load(N, 1);
    load(0, 0) = direct * GiNaC::cos(symbols().tau);
    const matrix springs = s.K.mul(motion.x).mul_scalar(from_premise());
    return load.sub(s.M.mul(motion.x_double_prime)).sub(s.C.mul(motion.x_prime)).sub(springs)(0, 0);
}

Symbolic shipped_load(int N, const ex& direct) {
    const SymbolicSystem& s = symbolic_system(N);
    const HeldMotion motion = held_motion(N);
    std::vector<Symbolic> C_j, K_j, x, x_prime;
    for (int k = 0; k < N; ++k) {
        C_j.emplace_back(s.C(0, k));
        K_j.emplace_back(s.K(0, k));
        x.emplace_back(motion.x(k, 0));
        x_prime.emplace_back(motion.x_prime(k, 0));
    }
    return paper::dynamic_load_on_contact<Symbolic>(C_j, K_j, x, x_prime, Symbolic(direct), Symbolic(symbols().tau));
}

const Register claims_of_section_3_1_numerical([] {
    const Symbols& s = symbols();
    std::vector<Claim> list{
        {.id = "74/margin",
         .equations = {"74"},
         .title = "The margin is beta times what the friction needed to balance the load leaves of the set [-mu, mu] of (3)",
         .assumptions = {"x_j' = 0", "beta > 0"},
         .kernel =
             [&s] { return Values{paper::sticking_margin(Symbolic(GiNaC::sqrt(s.x * s.x)), Symbolic(s.mu), Symbolic(s.beta))}; },
         .derived =
             [&s] {
                 const ex needed = -s.x / s.beta; // (6) with the load x on a contact that is not accelerated
                 return std::vector<ex>{s.beta * (s.mu - GiNaC::sqrt(needed * needed))};
             },
         .steps = {{"A contact at rest stays at rest where (6) holds without acceleration with a member of (3)'s set",
                    "\\beta\\,\\mathrm{sgn} = -\\left(\\textstyle\\sum_k\\overline{C}_{jk}\\bar{x}_k' + "
                    "\\sum_k\\overline{K}_{jk}\\bar{x}_k - "
                    "\\delta_{lj}\\cos\\tau\\right),\\qquad |\\mathrm{sgn}|\\le\\mu"}}},
    };
    struct Case {
        int N;
        std::string load; // the loaded mass
        ex direct;        // part of the load on mass 1, in contact
    };
    for (const auto& [N, load, direct] : std::vector<Case>{{1, "l=1", 1},
                                                           {2, "l=1", 1},
                                                           {2, "l=2", 0},
                                                           {3, "l=1", 1},
                                                           {3, "l=3", 0},
                                                           {2, "several", s.p_j},
                                                           {3, "several", s.p_j}})
        list.push_back({.id = "75/load/N=" + std::to_string(N) + "/" + load,
                        .equations = {"75"},
                        .title = "The load on a contact that is not accelerated is what friction has to balance in (6), with the "
                                 "opposite sign",
                        .assumptions = {"M diagonal", "x_j'' = 0", "j = 1", "N = " + std::to_string(N)},
                        .kernel = [N = N, direct = direct] { return Values{shipped_load(N, direct)}; },
                        .derived = [N = N, direct = direct] { return std::vector<ex>{-friction_needed(N, direct)}; },
                        .special_case = !direct.is_equal(1)});
    return list;
});

} // namespace
} // namespace denhartog::derivation
