// One modal coordinate over the half-period, against a Runge-Kutta integration of (20) that knows none of the formulas.
#include "denhartog/formulas/modal_coordinate.hpp"

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <vector>

#include "denhartog/formulas/boundary.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

namespace {

using State = std::array<double, 2>;

/// Displacement and velocity at tau from the initial values, by integration of (20).
State integrated(const ModeInScene<double>& m, const InitialValues<double>& start, double beta, double phi_j, double tau) {
    State state{start.eta_0, start.eta_prime_0};
    if (tau == 0) return state;
    const auto rate = [&](const State& s, State& ds, double t) {
        ds[0] = s[1];
        ds[1] = -2 * m.zeta / m.R * s[1] - s[0] / (m.R * m.R) + m.psi_ji * beta + m.psi_li * std::cos(t + phi_j);
    };
    namespace odeint = boost::numeric::odeint;
    const int steps = 8000;
    odeint::integrate_n_steps(odeint::runge_kutta4<State>(), rate, state, 0.0, tau / steps, steps);
    return state;
}

struct Case {
    ModeInScene<double> m;
    InitialValues<double> start;
    double beta, phi_j;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> list{{{0.875, 0.03125, 0.75, -0.5}, {0.25, -0.375}, 0.3125, 0.625},
                                        {{2.5, 0.25, -1.25, 0.875}, {-0.5, 0.125}, 0.75, -1.5},
                                        {{0.3125, 0.5, 0.5, 1.5}, {0.0625, 1.25}, 0.1875, 2.75},
                                        {{1.125, 0.8125, 1.0, 1.0}, {1.0, 0.0}, 1.5, 0.25}};
    return list;
}

const std::vector<double> instants{0.0, 0.375, 1.0, 1.625, 2.5, 3.0};

constexpr double tolerance = 2e-11; // of the integration, absolute: steps of at most 4e-4 with an error of fourth order

} // namespace

TEST_CASE("the general solution with the constants (A.5) is the integrated motion",
          "[eq:20][eq:21][eq:A.1][eq:A.2][eq:A.3][eq:A.5]") {
    for (const Case& c : cases()) {
        const IntegrationConstants<double> constants = paper::integration_constants(c.m, c.start, c.beta, c.phi_j);
        for (const double tau : instants)
            CHECK(paper::general_solution(tau, c.m, constants, c.beta, c.phi_j) ==
                  Approx(integrated(c.m, c.start, c.beta, c.phi_j, tau)[0]).margin(tolerance));
    }
}

TEST_CASE("the modal displacement from the initial values is the integrated motion", "[eq:A.6]") {
    for (const Case& c : cases())
        for (const double tau : instants)
            CHECK(paper::modal_displacement_from_start(tau, c.m, c.start, c.beta, c.phi_j) ==
                  Approx(integrated(c.m, c.start, c.beta, c.phi_j, tau)[0]).margin(tolerance));
}

TEST_CASE("the modal velocity as corrected is the integrated velocity", "[eq:A.7]") {
    for (const Case& c : cases())
        for (const double tau : instants)
            CHECK(paper::modal_velocity_from_start(tau, c.m, c.start, c.beta, c.phi_j) ==
                  Approx(integrated(c.m, c.start, c.beta, c.phi_j, tau)[1]).margin(tolerance));
}

TEST_CASE("d and R q are the free motions from unit displacement and unit velocity", "[eq:A.8][eq:A.9]") {
    for (Case c : cases()) {
        c.m.psi_li = 0;
        for (const double tau : instants) {
            const State from_displacement = integrated(c.m, {1, 0}, 0, 0, tau),
                        from_velocity = integrated(c.m, {0, 1}, 0, 0, tau);
            CHECK(paper::d(tau, c.m.R, c.m.zeta) == Approx(from_displacement[0]).margin(tolerance));
            CHECK(paper::d_prime(tau, c.m.R, c.m.zeta) == Approx(from_displacement[1]).margin(tolerance));
            CHECK(c.m.R * paper::q(tau, c.m.R, c.m.zeta) == Approx(from_velocity[0]).margin(tolerance));
            CHECK(c.m.R * paper::q_prime(tau, c.m.R, c.m.zeta) == Approx(from_velocity[1]).margin(tolerance));
        }
    }
}

TEST_CASE("the conditions (A.10) measure how far the integrated motion is from its mirror image at pi",
          "[eq:25][eq:A.4][eq:A.10][eq:A.11]") {
    for (const Case& c : cases()) {
        const Complex<double> v = paper::complex_response(c.m.R, c.m.zeta);
        const double v_cos = times_cosine(v, c.phi_j), v_sin = times_sine(v, c.phi_j);
        const PhaseSystem<double> p = paper::phase_system(c.m, c.start, c.beta);
        const State end = integrated(c.m, c.start, c.beta, c.phi_j, pi<double>());
        CHECK(paper::final_displacement_residual(p, v_cos, v_sin) == Approx(end[0] + c.start.eta_0).margin(tolerance));
        CHECK(paper::final_velocity_residual(p, v_cos, v_sin) == Approx(end[1] + c.start.eta_prime_0).margin(tolerance));
    }
}

TEST_CASE("started by (26) and (27), a mode ends the half-period in its mirror image",
          "[eq:26][eq:27][eq:28][eq:29][eq:40][eq:60][eq:62][eq:A.4][eq:A.12][eq:A.13][eq:A.14][eq:A.15]") {
    for (const Case& c : cases()) {
        const auto& [R, zeta, psi_ji, psi_li] = c.m;
        const Complex<double> v = paper::complex_response(R, zeta);
        const double u = paper::first_damping_function(R, zeta), g = paper::second_damping_function(R, zeta);
        const InitialValues<double> start{psi_li * R * R * times_cosine(v, c.phi_j) - psi_ji * R * R * g * c.beta,
                                          -psi_li * R * R * times_sine(v, c.phi_j) - psi_ji * R * R * u * c.beta};
        const State end = integrated(c.m, start, c.beta, c.phi_j, pi<double>());
        CHECK(end[0] == Approx(-start.eta_0).margin(tolerance));
        CHECK(end[1] == Approx(-start.eta_prime_0).margin(tolerance));

        const PhaseSystem<double> p = paper::phase_system(c.m, start, c.beta);
        CHECK(paper::v_cosine_from_system(p) == Approx(times_cosine(v, c.phi_j)).margin(tolerance));
        CHECK(paper::v_sine_from_system(p) == Approx(times_sine(v, c.phi_j)).margin(tolerance));
        CHECK(paper::v_cosine(c.m, start, g, c.beta) / modulus(v) == Approx(std::cos(c.phi_j + argument(v))).margin(tolerance));
        CHECK(paper::v_sine(c.m, start, u, c.beta) / modulus(v) == Approx(std::sin(c.phi_j + argument(v))).margin(tolerance));
        CHECK(paper::cosine_of_phase(c.m, start, u, g, c.beta) == Approx(std::cos(c.phi_j)).margin(tolerance));
        for (const double tau : instants)
            CHECK(paper::modal_displacement(tau, c.m, start, u, g, c.beta) ==
                  Approx(integrated(c.m, start, c.beta, c.phi_j, tau)[0]).margin(tolerance));
    }
}

TEST_CASE("the argument of v has the cosine and the sine of (61)", "[eq:23][eq:61]") {
    for (const Case& c : cases()) {
        const Complex<double> v = paper::complex_response(c.m.R, c.m.zeta);
        CHECK(paper::cosine_of_response_argument(v, c.m.R) == Approx(std::cos(argument(v))).margin(1e-14));
        CHECK(paper::sine_of_response_argument(v, c.m.R, c.m.zeta) == Approx(std::sin(argument(v))).margin(1e-14));
    }
}

TEST_CASE("the load of a mode on the contact is its inertia and friction, taken from the integrated motion", "[eq:59][eq:63]") {
    for (const Case& c : cases()) {
        const double h = 1e-4;
        const State before = integrated(c.m, c.start, c.beta, c.phi_j, h),
                    after = integrated(c.m, c.start, c.beta, c.phi_j, 2 * h);
        const double acceleration = (-3 * c.start.eta_prime_0 + 4 * before[1] - after[1]) / (2 * h); // one-sided, O(h^2)
        CHECK(paper::modal_contact_load(c.m, c.start, std::cos(c.phi_j)) ==
              Approx(c.m.psi_ji * c.beta - acceleration).epsilon(1e-5).margin(1e-5)); // the difference formula's own error
    }
}

TEST_CASE("the expansion (70) tends to the expression of (57) with an error of first order", "[eq:57][eq:70][eq:71]") {
    for (const Case& c : cases()) {
        const double u = paper::first_damping_function(c.m.R, c.m.zeta), g = paper::second_damping_function(c.m.R, c.m.zeta);
        const auto error = [&](double tau) {
            return paper::s_d_expansion(tau, c.m.R, c.m.zeta, u, g) - paper::s_d_integrand(tau, c.m.R, c.m.zeta, u, g);
        };
        CHECK(error(1.0 / 16384) / error(1.0 / 32768) == Approx(2).epsilon(0.01)); // halving tau halves the error
        CHECK(paper::s_d_expansion(1e-9, c.m.R, c.m.zeta, u, g) ==
              Approx(paper::s_d_at_zero(c.m.R, c.m.zeta, u, g)).margin(1e-6)); // the numerator cancels to 1e-16 / 1e-9
    }
}
