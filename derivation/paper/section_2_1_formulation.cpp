// Section 2.1, (1)-(12): the equation of motion and its non-dimensional form; (16) as printed.
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/system.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/claims/provenance.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

std::vector<Symbolic> symbolic(const std::vector<ex>& values) { return {values.begin(), values.end()}; }

/// Stiffness matrix of the chain as second derivatives of the energy of its springs.
std::vector<ex> hessian_of_chain(const std::vector<ex>& k) {
    std::vector<GiNaC::symbol> x;
    for (std::size_t i = 0; i < k.size(); ++i) x.emplace_back("x" + std::to_string(i + 1));
    ex energy = 0;
    for (std::size_t i = 0; i < k.size(); ++i)
        energy += from_premise() * k[i] * GiNaC::pow(i == 0 ? ex(x[0]) : ex(x[i] - x[i - 1]), 2) / 2;
    std::vector<ex> K;
    for (const GiNaC::symbol& a : x)
        for (const GiNaC::symbol& b : x) K.push_back(energy.diff(a).diff(b));
    return K;
}

/// Terms of the equation of motion of one mass, as they stand in (4) and (6), in the order inertia, damping, stiffness, friction,
/// load; the derivatives in tau are symbols of their own.
struct Motion {
    ex inertia, damping, stiffness, sgn, load;
};

const Motion& motion() {
    static const Motion m{new_symbol("x_double_prime", "\\bar{x}''", -1, 1), new_symbol("x_prime", "\\bar{x}'", -1, 1),
                          new_symbol("x_bar", "\\bar{x}", -1, 1), new_symbol("sgn", "\\mathrm{sgn}", -1, 1),
                          new_symbol("cos_tau", "\\cos\\tau", -1, 1)};
    return m;
}

ex damping_constant() {
    static const ex c = new_symbol("c", "c", GiNaC::numeric(1, 5), 2);
    return c;
}

/// One row of (6) and the non-dimensional time, through the shipped functions.
Values non_dimensional_residual() {
    const Symbols& s = symbols();
    const Motion& m = motion();
    const Symbolic omega(s.omega), k_1(s.k_1);
    const Symbolic displacement = paper::non_dimensional_displacement(Symbolic(s.x), k_1, Symbolic(s.P));
    return {paper::non_dimensional_mass(Symbolic(s.m_i), omega, k_1) * Symbolic(m.inertia) +
                paper::non_dimensional_damping(Symbolic(damping_constant()), omega, k_1) * Symbolic(m.damping) +
                paper::stiffness_ratio(Symbolic(s.k_i), k_1) * displacement +
                paper::friction_ratio(Symbolic(s.F), Symbolic(s.P)) * Symbolic(m.sgn) - Symbolic(m.load),
            paper::non_dimensional_time(omega, Symbolic(s.t))};
}

/// One row of (4), divided by P. d/dt = omega d/dtau; the rates in tau belong to the non-dimensional displacement.
std::vector<ex> residual_of_4_over_P() {
    const Symbols& s = symbols();
    const Motion& m = motion();
    const ex unit = s.P / s.k_1;
    const ex x_double_dot = unit * s.omega * s.omega * m.inertia, x_dot = unit * s.omega * m.damping;
    const ex residual =
        from_premise() * s.m_i * x_double_dot + damping_constant() * x_dot + s.k_i * s.x + s.F * m.sgn - s.P * m.load;
    return {residual / s.P, s.omega * s.t};
}

const Register claims_of_section_2_1_formulation([] {
    const Symbols& s = symbols();
    static const ex sgn_x = new_symbol("sgn_x", "\\mathrm{sgn}\\,x_j", -1, 1);
    std::vector<Claim> list{
        {.id = "1/chain",
         .equations = {"1"},
         .title = "Stiffness matrix of the chain from the energy of its springs",
         .assumptions = {"k_i > 0", "N = 1 to 4"},
         .kernel =
             [] {
                 Values values;
                 for (int N = 1; N <= 4; ++N) {
                     const std::vector<Symbolic> k = symbolic({symbols().k_1, symbols().k_i, symbols().m_1, symbols().m_i});
                     for (const Symbolic& entry : paper::chain_stiffness_matrix<Symbolic>(std::span(k).first(N)))
                         values.push_back(entry);
                 }
                 return values;
             },
         .derived =
             [] {
                 std::vector<ex> values;
                 const std::vector<ex> k{symbols().k_1, symbols().k_i, symbols().m_1, symbols().m_i};
                 for (int N = 1; N <= 4; ++N)
                     for (const ex& entry : hessian_of_chain({k.begin(), k.begin() + N})) values.push_back(entry);
                 return values;
             }},
        {.id = "2/printed",
         .equations = {"2"},
         .role = Role::printed,
         .title = "Friction force with the sign of the displacement",
         .kernel = [&s] { return Values{as_printed::friction_force(Symbolic(s.F), Symbolic(sgn_x))}; },
         .derived = [&s] { return std::vector<ex>{-s.F * motion().sgn}; },
         .departure = Departure::scan,
         .correction = "F_f = -F\\,\\mathrm{sgn}(\\dot{x}_j)"},
        {.id = "2/friction-force",
         .equations = {"2"},
         .role = Role::shipped,
         .title = "Friction force: what (4) has on its left, with the opposite sign",
         .kernel = [&s] { return Values{paper::friction_force(Symbolic(s.F), Symbolic(motion().sgn))}; },
         .derived = [&s] { return std::vector<ex>{-s.F * motion().sgn}; }},
        {.id = "4/printed",
         .equations = {"4"},
         .role = Role::printed,
         .title = "One unit vector for friction and load, looked at on the mass in contact while the load acts on another",
         .assumptions = {"j not l"},
         .kernel =
             [&s] {
                 return Values{as_printed::equation_of_motion_residual(Symbolic(s.x), Symbolic(1), Symbolic(s.F),
                                                                       Symbolic(motion().sgn), Symbolic(s.P * motion().load))};
             },
         .derived = [&s] { return std::vector<ex>{s.x + s.F * motion().sgn}; },
         .departure = Departure::scan,
         .correction = "\\mathbf{M}\\ddot{\\mathbf{x}} + \\mathbf{C}\\dot{\\mathbf{x}} + \\mathbf{K}\\mathbf{x} + "
                       "F\\mathbf{e}_j\\mathrm{sgn}(\\dot{x}_j) = P\\mathbf{e}_l\\cos(\\omega t)"},
        {.id = "5/printed",
         .equations = {"5"},
         .role = Role::printed,
         .title = "Displacement made non-dimensional with the stiffness ratio kappa_1 = 1",
         .kernel = [&s] { return Values{as_printed::non_dimensional_displacement(Symbolic(s.x), Symbolic(1), Symbolic(s.P))}; },
         .derived = [&s] { return std::vector<ex>{s.k_1 * s.x / s.P}; },
         .departure = Departure::scan,
         .correction_left = {"\\tau = \\omega t, \\quad \\bar{x}"}},
        {.id = "6/non-dimensional",
         .equations = {"6", "7", "11"},
         .title = "The non-dimensional equation with the matrices (7) and the friction ratio (11)",
         .assumptions = {"omega, k_1, P > 0"},
         .kernel = non_dimensional_residual,
         .derived = residual_of_4_over_P,
         .steps = {{"(4) is divided by $P$; with $\\tau=\\omega t$ every dot is $\\omega$ times a prime, and "
                    "$\\mathbf{x}=P\\bar{\\mathbf{x}}/k_1$",
                    ""}}},
        {.id = "12/half-period",
         .equations = {"12"},
         .title = "While the contact moves from its maximum to its minimum, sgn is -1 and friction acts with + beta on the right",
         .assumptions = {"x_j' < 0 for 0 < tau < pi"},
         .kernel =
             [&s] {
                 const Symbolic omega(s.omega), k_1(s.k_1);
                 const Symbolic x = paper::non_dimensional_displacement(Symbolic(s.x), k_1, Symbolic(s.P));
                 return Values{paper::non_dimensional_mass(Symbolic(s.m_i), omega, k_1) * Symbolic(motion().inertia) +
                               paper::non_dimensional_damping(Symbolic(damping_constant()), omega, k_1) *
                                   Symbolic(motion().damping) +
                               paper::stiffness_ratio(Symbolic(s.k_i), k_1) * x -
                               paper::friction_ratio(Symbolic(s.F), Symbolic(s.P)) - Symbolic(motion().load)};
             },
         .derived = [] { return std::vector<ex>{residual_of_4_over_P().front().subs(motion().sgn == -1)}; },
         .steps = {{"In (6) the sign of $\\bar{x}_j'$ is $-1$ over the half-period, and friction goes to the right side", ""}}},
        {.id = "8/mass-by-ratios",
         .equations = {"8"},
         .title = "Mass ratio and frequency ratio give the non-dimensional mass",
         .assumptions = {"m_1, k_1 > 0"},
         .kernel =
             [&s] {
                 const Symbolic gamma = paper::mass_ratio(Symbolic(s.m_i), Symbolic(s.m_1));
                 const Symbolic r = paper::frequency_ratio(Symbolic(s.omega), Symbolic(s.m_1), Symbolic(s.k_1));
                 return Values{paper::non_dimensional_mass_by_ratios(gamma, r)};
             },
         .derived =
             [&s] {
                 return std::vector<ex>{
                     paper::non_dimensional_mass(Symbolic(s.m_i), Symbolic(s.omega), Symbolic(s.k_1)).expression()};
             },
         .refines = {"7"},
         .steps = {{"(9) and (10) are put into $\\gamma_ir^2$; this has to be the entry $\\omega^2m_i/k_1$ of (7)", ""}}},
        {.id = "16/printed",
         .equations = {"16"},
         .role = Role::printed,
         .title = "Modal load with one row of the modal matrix for friction and load",
         .assumptions = {"j not l"},
         .kernel = [&s] { return Values{as_printed::modal_load(Symbolic(s.psi_ji), Symbolic(s.beta), Symbolic(motion().load))}; },
         .derived = [&s] { return std::vector<ex>{s.psi_ji * s.beta + s.psi_li * motion().load}; },
         .departure = Departure::scan,
         .correction = "\\hat{\\mathbf{M}}\\boldsymbol\\eta'' + \\hat{\\mathbf{C}}\\boldsymbol\\eta' + "
                       "\\hat{\\mathbf{K}}\\boldsymbol\\eta = \\boldsymbol\\Psi^T\\mathbf{e}_j\\beta + "
                       "\\boldsymbol\\Psi^T\\mathbf{e}_l\\cos(\\tau+\\phi_j)"},
    };
    return list;
});

} // namespace
} // namespace denhartog::derivation
