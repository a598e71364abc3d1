// Printed forms that the derivation refutes, refuted here by numbers, each beside the form that holds.
#include "denhartog/formulas/as_printed.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/support/second_witness.hpp"

using namespace denhartog;

namespace {

struct Solved {
    Scene<double> scene;
    ModeSums<double> sums;
    Boundary<double> limit;
    SteadyState<double> state;
};

/// The paper's chain of five, contact on the third mass, load on the first: r = 0.9, beta = 0.2, zeta = 0.1 (Fig. 5b).
const Solved& five_masses() {
    static const Solved solved = [] {
        for (const NamedScene<double>& named : paper_scenes<double>())
            if (number_of_masses(named.scene.system) == 5 && named.scene.system.contact != named.scene.system.load &&
                named.scene.system.damping_ratios.front() > 0.05) {
                const Scene<double>& scene = named.scene;
                ModeSums<double> sums = mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, *scene.r);
                Boundary<double> limit = boundary(sums, scene.mu);
                SteadyState<double> state = steady_state(sums, limit, *scene.beta);
                return Solved{scene, std::move(sums), std::move(limit), std::move(state)};
            }
        throw std::logic_error("the paper's scene is missing");
    }();
    return solved;
}

/// A mass that neither touches the wall nor carries the load.
constexpr std::size_t k = 1;

std::size_t j() { return five_masses().sums.contact.index; }

} // namespace

TEST_CASE("the friction force opposes the velocity, not the displacement", "[eq:2][erratum]") {
    const double F = 2, x = 1, x_dot = -1; // displaced to the right, moving to the left: friction pushes to the right
    CHECK(paper::friction_force(F, std::copysign(1.0, x_dot)) == F);
    CHECK(as_printed::friction_force(F, std::copysign(1.0, x)) == -F);
}

TEST_CASE("a modal displacement starts from its initial value, but not with the bracket as printed",
          "[eq:40][eq:A.15][erratum]") {
    const ModeInScene<double> m{0.875, 0.125, 0.75, -0.5};
    const InitialValues<double> start{0.25, -0.375};
    const double u = paper::first_damping_function(m.R, m.zeta), g = paper::second_damping_function(m.R, m.zeta);
    CHECK(paper::modal_displacement(0.0, m, start, u, g, 0.5) == Approx(start.eta_0).epsilon(1e-14));
    CHECK(std::abs(as_printed::modal_displacement(0.0, m, start, u, g, 0.5) - start.eta_0) > 0.1);
}

TEST_CASE("the displacement of a mass over the half-period agrees with the second witness, but not with the bracket as printed",
          "[eq:41][eq:46][erratum]") {
    const Solved& s = five_masses();
    const HalfPeriodMotion<Real50> witness = half_period_motion(half_period_problem(s.scene), 16);
    double worst = 0, worst_printed = 0;
    for (int n = 0; n <= 16; ++n) {
        const double tau = pi<double>() * n / 16, truth = static_cast<double>(witness.x(k, n));
        const auto psi_k = mode_shapes_at(s.sums, Mass{k}), psi_j = mode_shapes_at(s.sums, s.sums.contact);
        const auto value = [&](double F_k) {
            return paper::steady_displacement(tau, s.sums.V[k], s.sums.V[j()], s.sums.U[j()], s.state.beta, F_k);
        };
        const double shipped =
            value(paper::friction_motion_of_mass<double>(tau, psi_k, psi_j, s.sums.R, s.sums.zeta, s.sums.u, s.sums.g));
        const double printed =
            value(as_printed::friction_motion_of_mass<double>(tau, psi_k, psi_j, s.sums.R, s.sums.zeta, s.sums.u, s.sums.g));
        worst = std::max(worst, std::abs(shipped - truth));
        worst_printed = std::max(worst_printed, std::abs(printed - truth));
    }
    CHECK(worst < 1e-13);
    CHECK(worst_printed > 0.05);
}

TEST_CASE(
    "displacement and velocity at the maximum of the contact agree with the second witness, but not the real parts as printed",
    "[eq:44][eq:45][erratum]") {
    const Solved& s = five_masses();
    const HalfPeriodMotion<Real50> witness = half_period_motion(half_period_problem(s.scene), 4);
    const double x_0 = static_cast<double>(witness.x_0(k)), v_0 = static_cast<double>(witness.x_prime_0(k));
    const double beta = s.state.beta;
    CHECK(paper::initial_displacement(s.sums.V[k], s.sums.V[j()], s.sums.U[j()], s.sums.G[k], beta) ==
          Approx(x_0).epsilon(1e-12));
    CHECK(paper::initial_velocity(s.sums.V[k], s.sums.V[j()], s.sums.U[j()], s.sums.U[k], beta) == Approx(v_0).epsilon(1e-12));
    CHECK(std::abs(as_printed::initial_displacement(s.sums.V[k], s.sums.V[j()], s.sums.U[j()], s.sums.G[k], beta) - x_0) > 0.01);
    CHECK(std::abs(as_printed::initial_velocity(s.sums.V[k], s.sums.V[j()], s.sums.U[j()], s.sums.U[k], beta) - v_0) > 0.01);
}

TEST_CASE("the monoharmonic amplitude is that of the initial values, but not as printed", "[eq:50][eq:51][eq:52][erratum]") {
    const Solved& s = five_masses();
    const double beta = s.state.beta, x_0 = s.state.masses[k].x0, v_0 = s.state.masses[k].v0;
    const Complex<double>&V_k = s.sums.V[k], &V_j = s.sums.V[j()];
    const double U_j = s.sums.U[j()], U_k = s.sums.U[k], G_k = s.sums.G[k];
    CHECK(paper::monoharmonic_cosine(V_k, V_j, U_j, G_k, beta) == Approx(x_0).epsilon(1e-12));
    CHECK(paper::monoharmonic_sine(V_k, V_j, U_j, U_k, beta) == Approx(v_0).epsilon(1e-12));
    CHECK(paper::displacement_transmissibility(V_k, V_j, U_j, U_k, G_k, beta) == Approx(std::hypot(x_0, v_0)).epsilon(1e-12));
    CHECK(std::abs(as_printed::monoharmonic_cosine(V_k, V_j, U_j, G_k, beta) - x_0) > 1e-3);
    CHECK(std::abs(as_printed::displacement_transmissibility(V_k, V_j, U_j, U_k, G_k, beta) - std::hypot(x_0, v_0)) > 1e-3);
}

TEST_CASE("the expression of (57) is bounded near tau = 0, but not as printed", "[eq:57][erratum]") {
    const double R = 0.875, zeta = 0.125;
    const double u = paper::first_damping_function(R, zeta), g = paper::second_damping_function(R, zeta);
    CHECK(paper::s_d_integrand(1e-6, R, zeta, u, g) ==
          Approx(paper::s_d_at_zero(R, zeta, u, g)).epsilon(1e-5)); // the limit is approached in proportion to tau
    CHECK(std::abs(as_printed::s_d_integrand(1e-6, R, zeta, u, g)) > 1e3);
}

TEST_CASE("the expansion (70) has the limit (71), but not with the sign as printed", "[eq:70][eq:71][erratum]") {
    const double R = 0.875, zeta = 0.125;
    const double u = paper::first_damping_function(R, zeta), g = paper::second_damping_function(R, zeta);
    const double limit = paper::s_d_at_zero(R, zeta, u, g);
    CHECK(paper::s_d_expansion(1e-7, R, zeta, u, g) == Approx(limit).epsilon(1e-6));
    CHECK(as_printed::s_d_expansion(1e-7, R, zeta, u, g) == Approx(limit - 4 * zeta * R * u).epsilon(1e-6));
    CHECK(std::abs(4 * zeta * R * u) > 0.01);
}

TEST_CASE("the modal velocity is the rate of the displacement, but not with the sign as printed", "[eq:A.7][erratum]") {
    const ModeInScene<double> m{0.875, 0.125, 0.75, -0.5};
    const InitialValues<double> start{0.25, -0.375};
    const double tau = 1, h = 1e-5, beta = 0.5, phi_j = 0.75;
    const double rate = (paper::modal_displacement_from_start(tau + h, m, start, beta, phi_j) -
                         paper::modal_displacement_from_start(tau - h, m, start, beta, phi_j)) /
                        (2 * h);
    CHECK(paper::modal_velocity_from_start(tau, m, start, beta, phi_j) == Approx(rate).epsilon(1e-8));
    CHECK(std::abs(as_printed::modal_velocity_from_start(tau, m, start, beta, phi_j) - rate) > 0.1);
}

TEST_CASE("the contact still slides beyond the boundary that (56) gives", "[eq:56][eq:69][erratum]") {
    int found = 0;
    for (const RandomScene<double>& random : random_scenes<double>(2022)) {
        const System<double>& system = random.scene.system;
        if (number_of_masses(system) < 2 || number_of_masses(system) > 4) continue;
        Scene<double> scene = random.scene;
        const ModeSums<double> sums = mode_sums(modal_basis(system), system.contact, system.load, *scene.r);
        const Boundary<double> limit = boundary(sums, scene.mu);
        if (!(limit.paper < 0.99 * limit.exact)) continue;
        ++found;
        scene.beta = friction_ratio_at(0.5, limit.paper + limit.exact); // half-way between the two
        INFO(random.name);
        CHECK(slides(half_period_motion(half_period_problem(scene), 256), Real50(scene.mu), Real50(*scene.beta)));
        if (found == 5) break;
    }
    CHECK(found == 5);
}

TEST_CASE("beyond (68) static friction holds the contact all the same where H is below mu / (gamma r^2)", "[eq:68][erratum]") {
    const double R = 0.5, zeta = 0.0625, r = 0.5, mu = 1.5, sum_of_squares = paper::sum_of_squares_at_contact(1.0, r);
    const double u = paper::first_damping_function(R, zeta), g = paper::second_damping_function(R, zeta);
    const double psi_R_2 = sum_of_squares * R * R; // one mass: psi^2 = 1 / r^2
    const Complex<double> v = paper::complex_response(R, zeta), V{psi_R_2 * v.re, psi_R_2 * v.im};
    const double U = psi_R_2 * u, G = psi_R_2 * g, H = sum_of_squares * (g + 2 * zeta * R * u);
    REQUIRE(H < mu * sum_of_squares);
    const double limit = paper::friction_ratio_limit(V, U, H - mu * sum_of_squares);
    for (int n = 1; n < 16; ++n) {
        const double beta = limit + (modulus(V) / std::abs(U) - limit) * n / 16;
        const double X = paper::displacement_transmissibility_of_contact(V, U, G, beta);
        CHECK(std::abs(paper::contact_load_at_start(X, G, H, beta)) < mu * beta * sum_of_squares);
    }
}
