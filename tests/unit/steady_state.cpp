#include "denhartog/sliding/steady_state.hpp"

#include <cmath>

#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

/// Modes and steady state of a scene at a fraction of the boundary.
struct Case {
    Scene<double> scene;
    ModeSums<double> s;
    SteadyState<double> state;
    Case(const Scene<double>& scene_, double fraction) : scene(scene_), s(sums_of(scene)) {
        const Boundary<double> b = boundary(s, scene.mu);
        scene.beta = fraction * b.exact;
        state = steady_state(s, b, *scene.beta);
    }
};

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const double r : {0.25, 0.4375, 0.875, 1.125, 2.5})
        for (const double fraction : {0.125, 0.5, 0.96875}) {
            all.emplace_back(three_masses(r), fraction);
            Scene<double> other = three_masses(r);
            other.system.contact = Mass{0};
            other.system.load = Mass{2};
            other.system.damping_ratios = {0, 0.0078125, 0};
            all.emplace_back(other, fraction);
        }
    return all;
}

std::string at(const Case& c) { return "r = " + hexadecimal(*c.scene.r) + ", beta = " + hexadecimal(*c.scene.beta); }

} // namespace

TEST_CASE("one mass at r = 2 without damping has the amplitude and phase of Den Hartog's solution", "[eq:38][eq:39]") {
    // V = -1/3 and U = tan(pi/4)/2 = 1/2, so that X = sqrt(1/9 - 1/64) with beta = 1/4.
    const ModeSums<double> s = sums_of(oscillator(0, 2));
    const SteadyState<double> state = steady_state(s, boundary(s, 1.0), 0.25);
    CHECK(state.X_j == Approx(std::sqrt(55.0) / 24).epsilon(1e-15));
    CHECK(state.phi_j == Approx(pi<double>() - std::asin(0.375)).epsilon(1e-15));
}

TEST_CASE("one damped mass has the amplitude of Den Hartog's solution with mixed damping", "[eq:38][eq:39]") {
    // His formula as it stands in his paper's notation: q for the viscous amplification, G and H for the damping functions.
    const double zeta = 0.125, r = 0.75, beta = 0.25, root = std::sqrt(1 - zeta * zeta);
    const double q = std::hypot(1 - r * r, 2 * zeta * r);
    const double denominator = std::cosh(zeta * pi<double>() / r) + std::cos(root * pi<double>() / r);
    const double G = (std::sinh(zeta * pi<double>() / r) - zeta / root * std::sin(root * pi<double>() / r)) / denominator;
    const double H = std::sin(root * pi<double>() / r) / (r * root) / denominator;
    const ModeSums<double> s = sums_of(oscillator(zeta, r));
    const SteadyState<double> state = steady_state(s, boundary(s, 1.0), beta);
    CHECK(state.X_j == Approx(-G * beta + std::sqrt(1 / (q * q) - H * H * beta * beta)).epsilon(1e-14));
}

TEST_CASE("the motion fulfils the equation of motion inside the half-period", "[eq:6][eq:12][eq:40][eq:41]") {
    for (const Case& c : cases()) {
        const NonDimensionalMatrices m = matrices_of(c.scene);
        const double h = 1e-3;
        for (const double tau : {0.25, 1.0, 1.75, 2.875}) {
            // Accelerations by differences of velocities, sixth order.
            Eigen::VectorXd x(3), v(3), a = Eigen::VectorXd::Zero(3);
            const Motion<double> now = motion(c.s, c.state, tau);
            for (Eigen::Index k = 0; k < 3; ++k) x(k) = now.x[k], v(k) = now.x_prime[k];
            for (int n = 1; n <= 3; ++n) {
                const double weight = n == 1 ? 0.75 : n == 2 ? -0.15 : 1.0 / 60;
                const Motion<double> after = motion(c.s, c.state, tau + n * h), before = motion(c.s, c.state, tau - n * h);
                for (Eigen::Index k = 0; k < 3; ++k) a(k) += weight / h * (after.x_prime[k] - before.x_prime[k]);
            }
            Eigen::VectorXd load = Eigen::VectorXd::Zero(3);
            load(c.s.contact.index) += *c.scene.beta;
            load(c.s.load.index) += std::cos(tau + c.state.phi_j);
            INFO(at(c) << ", tau = " << tau);
            CHECK((m.M * a + m.C * v + m.K * x - load).norm() < 1e-8 * (m.K.norm() * x.norm() + 1));
        }
    }
}

TEST_CASE("the motion starts from its initial values and mirrors itself after half a period", "[eq:24][eq:25][eq:30]") {
    for (const Case& c : cases()) {
        const Motion<double> start = motion(c.s, c.state, 0.0);
        const std::size_t j = c.s.contact.index;
        CHECK(std::abs(start.x[j] - c.state.X_j) < 1e-12 * c.state.X_j);
        CHECK(c.state.masses[j].v0 == 0);
        for (std::size_t k = 0; k < 3; ++k) {
            const double size = c.state.masses[k].amplitude;
            INFO(at(c) << ", mass " << k + 1);
            CHECK(std::abs(start.x[k] - c.state.masses[k].x0) < 1e-12 * size);
            CHECK(std::abs(start.x_prime[k] - c.state.masses[k].v0) < 1e-11 * size / *c.scene.r);
            // The end of the half-period, approached from inside by the formula itself.
            const double end = std::nextafter(pi<double>(), 0.0);
            CHECK(std::abs(motion(c.s, c.state, end).x[k] + start.x[k]) < 1e-12 * size);
            CHECK(std::abs(motion(c.s, c.state, end).x_prime[k] + start.x_prime[k]) < 1e-11 * size / *c.scene.r);
            for (const double tau : {0.375, 2.5}) {
                CHECK(motion(c.s, c.state, tau + pi<double>()).x[k] ==
                      Approx(-motion(c.s, c.state, tau).x[k]).margin(1e-13 * size));
                CHECK(motion(c.s, c.state, tau - pi<double>()).x[k] ==
                      Approx(-motion(c.s, c.state, tau).x[k]).margin(1e-13 * size));
            }
        }
    }
}

TEST_CASE("amplitude and phase of the mass in contact fulfil the relations that they come from",
          "[eq:31][eq:32][eq:36][eq:37][eq:38][eq:39]") {
    for (const Case& c : cases()) {
        const std::size_t j = c.s.contact.index;
        const Complex<double>& V = c.s.V[j];
        const double beta = *c.scene.beta, size = modulus(V), sum = c.state.phi_j + argument(V);
        INFO(at(c));
        CHECK(times_cosine(V, c.state.phi_j) == Approx(paper::V_cosine(c.state.X_j, c.s.G[j], beta)).margin(1e-14 * size));
        CHECK(times_sine(V, c.state.phi_j) == Approx(paper::V_sine(c.s.U[j], beta)).margin(1e-14 * size));
        CHECK(std::cos(sum) == Approx(paper::cosine_of_phase_sum(V, c.state.X_j, c.s.G[j], beta)).margin(1e-14));
        CHECK(std::sin(sum) == Approx(paper::sine_of_phase_sum(V, c.s.U[j], beta)).margin(1e-14));
        CHECK(c.state.phi_j > -pi<double>());
        CHECK(c.state.phi_j <= pi<double>());
    }
}

TEST_CASE("initial values of the masses not in contact fulfil the relations that they come from",
          "[eq:42][eq:43][eq:44][eq:45]") {
    for (const Case& c : cases())
        for (std::size_t k = 0; k < 3; ++k) {
            const MassResponse<double>& m = c.state.masses[k];
            const Complex<double>&V = c.s.V[k], V_j = c.s.V[c.s.contact.index];
            const double beta = *c.scene.beta, size = modulus(V) + beta * (std::abs(c.s.G[k]) + std::abs(c.s.U[k]));
            const double U_j = c.s.U[c.s.contact.index];
            INFO(at(c) << ", mass " << k + 1);
            CHECK(std::abs(times_cosine(V, c.state.phi_j) - paper::V_k_cosine(m.x0, c.s.G[k], beta)) < 1e-13 * size);
            CHECK(std::abs(times_sine(V, c.state.phi_j) - paper::V_k_sine(m.v0, c.s.U[k], beta)) < 1e-13 * size);
            CHECK(std::abs(m.x0 - paper::initial_displacement(V, V_j, U_j, c.s.G[k], beta)) < 1e-13 * size);
            CHECK(std::abs(m.v0 - paper::initial_velocity(V, V_j, U_j, c.s.U[k], beta)) < 1e-13 * size);
        }
}

TEST_CASE("the motion from initial values is the motion in closed form", "[eq:46]") {
    for (const Case& c : cases()) {
        const Rows<double> rows(c.s);
        const auto psi_j = mode_shapes_at(c.s, c.s.contact);
        for (std::size_t k = 0; k < 3; ++k)
            for (const double tau : {0.0, 0.625, 1.5, 3.0}) {
                const double F_k =
                    paper::friction_motion_of_mass(tau, mode_shapes_at(c.s, Mass{k}), psi_j, rows.R, rows.zeta, rows.u, rows.g);
                const double x = paper::steady_displacement(tau, c.s.V[k], c.s.V[c.s.contact.index], c.s.U[c.s.contact.index],
                                                            *c.scene.beta, F_k);
                INFO(at(c) << ", mass " << k + 1 << ", tau = " << tau);
                CHECK(std::abs(x - motion(c.s, c.state, tau).x[k]) < 1e-12 * c.state.masses[k].amplitude);
            }
    }
}

TEST_CASE("no sample exceeds the amplitude, and dense samples come up to it", "[eq:46][eq:47][maximum]") {
    const auto check_samples = [](const Case& c, int samples, double above, double below) {
        std::vector<double> largest(c.state.masses.size());
        for (int n = 0; n <= samples; ++n) {
            const Motion<double> now = motion(c.s, c.state, std::min(pi<double>(), pi<double>() * n / samples));
            for (std::size_t k = 0; k < largest.size(); ++k) largest[k] = std::max(largest[k], std::abs(now.x[k]));
        }
        for (std::size_t k = 0; k < largest.size(); ++k) {
            const double amplitude = c.state.masses[k].amplitude;
            INFO(at(c) << ", mass " << k + 1 << ": " << hexadecimal(amplitude) << " and " << hexadecimal(largest[k]));
            CHECK(largest[k] <= amplitude * (1 + above));
            CHECK(largest[k] >= amplitude * (1 - below));
        }
    };
    for (const Case& c : cases()) check_samples(c, 2000, 1e-14, 2e-4);
    const std::vector<RandomScene<double>> seeded = random_scenes<double>(535);
    for (std::size_t n = 2; n < seeded.size(); n += 3)
        check_samples(Case(seeded[n].scene, seeded[n].fraction_of_limit), 1000, 1e-11, 1e-3);
}

TEST_CASE("the phase of a mass is that of its largest displacement", "[eq:47]") {
    for (const Case& c : cases())
        for (std::size_t k = 0; k < 3; ++k) {
            const MassResponse<double>& m = c.state.masses[k];
            const Motion<double> there = motion(c.s, c.state, m.instant);
            INFO(at(c) << ", mass " << k + 1);
            CHECK(std::abs(std::abs(there.x[k]) - m.amplitude) < 1e-13 * m.amplitude);
            CHECK(std::abs(there.x_prime[k]) < 1e-11 * m.amplitude / (*c.scene.r * *c.scene.r));
            // The load is cos(tau + phi_j): the mass has its maximum where that angle is its phase.
            const double from_load = m.instant + c.state.phi_j + (there.x[k] < 0 ? pi<double>() : 0.0);
            CHECK(std::abs(std::remainder(from_load - m.phase, 2 * pi<double>())) < 1e-14);
            CHECK(m.phase > -pi<double>());
            CHECK(m.phase <= pi<double>());
        }
}

TEST_CASE("the monoharmonic amplitude and phase are those of (50) to (53)", "[eq:48][eq:49][eq:50][eq:51][eq:52][eq:53]") {
    for (const Case& c : cases())
        for (std::size_t k = 0; k < 3; ++k) {
            const MassResponse<double>& m = c.state.masses[k];
            const Complex<double>&V = c.s.V[k], V_j = c.s.V[c.s.contact.index];
            const double U_j = c.s.U[c.s.contact.index], beta = *c.scene.beta;
            const double X_kC = paper::monoharmonic_cosine(V, V_j, U_j, c.s.G[k], beta);
            const double X_kS = paper::monoharmonic_sine(V, V_j, U_j, c.s.U[k], beta);
            const double X_k = paper::displacement_transmissibility(V, V_j, U_j, c.s.U[k], c.s.G[k], beta);
            INFO(at(c) << ", mass " << k + 1);
            CHECK(m.amplitude_monoharmonic == Approx(std::hypot(X_kC, X_kS)).epsilon(1e-11));
            CHECK(m.amplitude_monoharmonic == Approx(X_k).epsilon(1e-8));
            const double phi_kj = std::remainder(m.phase_monoharmonic - c.state.phi_j, 2 * pi<double>());
            CHECK(std::cos(phi_kj) == Approx(X_kC / X_k).margin(1e-8));
            CHECK(std::sin(phi_kj) == Approx(X_kS / X_k).margin(1e-8));
            // Exact at both ends; between them the amplitude of the approximation is taken on where it says.
            CHECK(paper::monoharmonic_displacement(0.0, m.x0, m.v0) == m.x0);
            CHECK(std::abs(paper::monoharmonic_displacement(phi_kj, m.x0, m.v0) - m.amplitude_monoharmonic) <
                  1e-11 * m.amplitude_monoharmonic);
        }
}

TEST_CASE("without friction every mass moves harmonically", "[eq:33][eq:46]") {
    Scene<double> scene = three_masses();
    const ModeSums<double> s = sums_of(scene);
    const SteadyState<double> state = steady_state(s, boundary(s, scene.mu), 0.0);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(state.masses[k].amplitude == Approx(modulus(s.V[k])).epsilon(1e-14));
        CHECK(std::abs(std::remainder(state.masses[k].phase + argument(s.V[k]), 2 * pi<double>())) < 1e-7);
    }
}

TEST_CASE("outside the sliding regime there is an error and no number", "[eq:69][domain]") {
    const ModeSums<double> s = sums_of(three_masses());
    const Boundary<double> b = boundary(s, 1.375);
    CHECK_THROWS_AS(steady_state(s, b, b.exact), DomainError);
    CHECK_THROWS_AS(steady_state(s, b, 2 * b.exact), DomainError);
    CHECK_THROWS_AS(steady_state_without_maxima(s, 1000.0), DomainError);
    CHECK_THROWS_AS(steady_state(s, b, -0.125), InputError);
    CHECK_THROWS_AS(steady_state(s, b, std::numeric_limits<double>::quiet_NaN()), InputError);
    CHECK_NOTHROW(steady_state(s, b, std::nextafter(b.exact, 0.0)));
}

TEST_CASE("angles are wrapped to the half-open interval", "[phase]") {
    const double turn = 2 * pi<double>();
    CHECK(wrapped(pi<double>()) == pi<double>());
    CHECK(wrapped(-pi<double>()) == pi<double>());
    CHECK(wrapped(0.0) == 0.0);
    CHECK(wrapped(1.5 + 3 * turn) == Approx(1.5));
    CHECK(wrapped(-1.5 - 3 * turn) == Approx(-1.5));
    CHECK(wrapped(std::nextafter(pi<double>(), 4.0)) > -pi<double>());
    CHECK(wrapped(std::nextafter(pi<double>(), 4.0)) < -3);
}
