// The exact solver by second routes: its phases against the matrix exponential, its Jacobian against differences.
#include <cmath>

#include "tests/integration/orbit_scenes.hpp"
#include "tests/support/contact_phase.hpp"
#include "tests/support/second_witness.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

/// A system as it is given, without modes.
struct Given {
    Matrix<double> M, C, K; // non-dimensional at r = 1: units m_1, sqrt(k_1 m_1), k_1
    Mass contact, load;
};

tests::PreparedMotion prepared(const Given& g, double r, double beta, double mu) {
    System<double> s;
    s.mass_matrix = g.M;
    s.damping_matrix = g.C;
    s.stiffness_matrix = g.K;
    s.contact = g.contact;
    s.load = g.load;
    return {"", contact_system(s), {r, beta, mu}};
}

/// The state after a time by the exponential of z' = A z, z = (x, x', cos, sin, 1), in 50 digits: sliding in a direction, or
/// stuck for 0. M, C and K are those at r = 1.
State by_exponential(const Matrix<Real50>& M, const Matrix<Real50>& C, const Matrix<Real50>& K, Mass contact, Mass load,
                     const Excitation& e, int direction, const State& start, double tau_0, double t) {
    const Eigen::Index N = M.rows();
    const Real50 r = e.r;
    const HalfPeriodProblem<Real50> p{M * Real50(r * r), C * r, K, contact, load, Real50(e.beta)};
    Vector<Real50> z(2 * N + 3);
    for (Eigen::Index k = 0; k < N; ++k) {
        z(k) = start.x[static_cast<std::size_t>(k)];
        z(N + k) = start.x_prime[static_cast<std::size_t>(k)];
    }
    z.tail(3) << cos(Real50(tau_0)), sin(Real50(tau_0)), Real50(1);
    z = matrix_exponential(Matrix<Real50>(system_of_phase(p, direction) * Real50(t))) * z;
    State end = at_rest(static_cast<std::size_t>(N));
    for (Eigen::Index k = 0; k < N; ++k) {
        end.x[static_cast<std::size_t>(k)] = static_cast<double>(z(k));
        end.x_prime[static_cast<std::size_t>(k)] = static_cast<double>(z(N + k));
    }
    return end;
}

State by_exponential(const Given& g, const Excitation& e, int direction, const State& start, double tau_0, double t) {
    return by_exponential(g.M.cast<Real50>(), g.C.cast<Real50>(), g.K.cast<Real50>(), g.contact, g.load, e, direction, start,
                          tau_0, t);
}

/// One sliding and one sticking phase of a system against the exponential.
void check_phases(const Given& g, double r, double tolerance) {
    const std::size_t N = static_cast<std::size_t>(g.M.rows()), j = g.contact.index;
    State start = at_rest(N);
    for (std::size_t k = 0; k < N; ++k) {
        start.x[k] = (static_cast<int>(k) - 1) / 4.0;
        start.x_prime[k] = (2 - static_cast<int>(k)) / 8.0;
    }
    for (const int direction : {1, -1}) {
        start.x_prime[j] = 8 * direction; // fast enough not to turn round
        const tests::PreparedMotion p = prepared(g, r, 0.25, 1);
        ExactSolver solver(p.system, p.excitation);
        const double tau_0 = 0.375, tau_1 = tau_0 + std::min(1.0, r) * 3 / 8;
        const ExactMotion& motion = solver.run(start, tau_0, tau_1);
        REQUIRE(motion.phases.size() == 1);
        CHECK(motion.phases[0].direction == direction);
        CHECK(distance(motion.end, by_exponential(g, p.excitation, direction, start, tau_0, tau_1 - tau_0)) < tolerance);
    }
    start.x_prime[j] = 0;
    const tests::PreparedMotion p = prepared(g, r, 1000, 1); // held
    ExactSolver solver(p.system, p.excitation);
    const double tau_0 = 0.375, t = 5.5;
    const ExactMotion& motion = solver.run(start, tau_0, tau_0 + t);
    REQUIRE(motion.phases.size() == 1);
    CHECK(motion.phases[0].direction == 0);
    CHECK(distance(motion.end, by_exponential(g, p.excitation, 0, start, tau_0, t)) < tolerance);
}

Given one_mass(double zeta) {
    const auto number = [](double x) { return Matrix<double>(Matrix<double>::Constant(1, 1, x)); };
    return {number(1), number(2 * zeta), number(1), Mass{0}, Mass{0}};
}

/// A chain of unequal masses and springs with C = a M + b K.
Given chain_of(std::size_t N, std::size_t j, std::size_t l, double a, double b) {
    std::vector<double> masses{1}, springs{1};
    for (int number = 1; masses.size() < N; ++number) {
        masses.push_back((2 + number) / 2.0);
        springs.push_back((5 - number) / 4.0);
    }
    const System<double> s = denhartog::chain_of(masses, springs);
    Given g{mass_matrix(s), {}, stiffness_matrix(s), Mass{j}, Mass{l}};
    g.C = a * g.M + b * g.K;
    return g;
}

/// The Jacobian of a stretch against central differences of the fourth order.
void check_jacobian(const tests::PreparedMotion& p, const State& start, int directions_seen) {
    ExactSolver solver(p.system, p.excitation);
    const std::size_t N = start.x.size();
    const double tau_0 = 0.0625, tau_1 = 6, h = 0x1p-12;
    const ExactMotion& motion = solver.run(start, tau_0, tau_1, true);
    REQUIRE(motion.status == MotionStatus::complete);
    int seen = 0;
    for (const Phase& phase : motion.phases) seen |= phase.direction == 0 ? 1 : phase.direction == 1 ? 2 : 4;
    CHECK(seen == directions_seen);
    const Matrix<double> jacobian = motion.jacobian;
    double largest = 0, worst = 0;
    for (std::size_t c = 0; c < 2 * N; ++c) {
        const auto end_after = [&](double deviation) {
            State z = start;
            (c < N ? z.x[c] : z.x_prime[c - N]) += deviation;
            return solver.run(z, tau_0, tau_1).end;
        };
        const Column near = difference(end_after(h), end_after(-h)), far = difference(end_after(2 * h), end_after(-2 * h));
        const Column slope = (8 * near - far) / (12 * h);
        largest = std::max(largest, slope.cwiseAbs().maxCoeff());
        worst = std::max(worst, (slope - jacobian.col(static_cast<Eigen::Index>(c))).cwiseAbs().maxCoeff());
    }
    INFO(worst << " of " << largest);
    CHECK(worst < 1e-10 * (1 + largest));
}

/// A state out of any order, the contact in motion.
State some_state(std::size_t N, std::size_t j) {
    State z = at_rest(N);
    for (std::size_t k = 0; k < N; ++k) {
        z.x[k] = (static_cast<int>(k) + 1) / 8.0;
        z.x_prime[k] = (3 - 2 * static_cast<int>(k)) / 16.0;
    }
    z.x_prime[j] = 5 / 16.0;
    return z;
}

} // namespace

TEST_CASE("a phase is the exponential of its system: near and at resonance, underdamped, coupled, overdamped while stuck",
          "[eq:6][eq:12][exact-solver]") {
    for (const double zeta : {0.0, 1e-9, 0.01, 0.9375})
        for (const double r : {1.0, 1 + 1e-9, 1 + 1e-6, 0.9990234375, 1.0625, 0.125, 3.0}) {
            INFO("zeta " << hexadecimal(zeta) << " r " << hexadecimal(r));
            check_phases(one_mass(zeta), r, 4e-14);
        }
    for (const double r : {0.25, 0.7071067811865476, 1.0, 2.5}) {
        INFO("r " << hexadecimal(r));
        check_phases(chain_of(4, 1, 0, 0.0625, 0.03125), r, 4e-13);
        check_phases(chain_of(4, 3, 3, 0, 0), r, 4e-13);
        check_phases(chain_of(3, 1, 2, 0.5, 0.25), r, 4e-13);
    }
}

TEST_CASE("stuck modes that damping couples or that are overdamped move as the exponential says",
          "[eq:19][eq:88][exact-solver]") {
    // Modal damping ratios that differ: C is full, and the stuck block of it is not diagonalised by the stuck modes.
    for (const double r : {0.125, 0.875, 2.0})
        for (const std::vector<double>& zeta :
             {std::vector<double>{0.03125, 0.0625, 0.25}, {0.9375, 0.03125, 0.96875}, {0.0, 0.5, 0.0}}) {
            INFO("r " << hexadecimal(r));
            const tests::PreparedMotion p = prepared_chain({1, 2, 1}, {1, 0.25, 0.75}, zeta, 2, 1, r, 1000);
            Scene<double> at_1 = p.scene;
            at_1.r = 1;
            at_1.beta = 0;
            const HalfPeriodProblem<Real50> m = half_period_problem(at_1);
            CHECK_FALSE(p.system.stuck.modes_diagonalise_damping);
            const State start{{0.5, -0.25, 1}, {-0.75, 0, 0.125}};
            ExactSolver solver(p.system, p.excitation);
            const double tau_0 = 0.625;
            const ExactMotion& motion = solver.run(start, tau_0, tau_0 + 6);
            REQUIRE(motion.phases.size() == 1);
            const auto after = [&](double t) {
                return by_exponential(m.M, m.C, m.K, m.contact, m.load, p.excitation, 0, start, tau_0, t);
            };
            CHECK(distance(motion.end, after(6)) < 1e-12);
            CHECK(distance(solver.state_at(0, tau_0 + 2), after(2)) < 1e-12);
        }
}

TEST_CASE("the Jacobian over phases and their ends is that of differences", "[eq:2][eq:3][eq:74][exact-solver][shooting]") {
    const int all = 7;
    for (const double mu : {1.0, 1.5}) {
        INFO("mu " << mu);
        check_jacobian(prepared_oscillator(0.03125, 0.125, 0.1875, mu), some_state(1, 0), all);
        check_jacobian(prepared_oscillator(0, 0.3125, 0.25, mu), some_state(1, 0), all);
        check_jacobian(prepared_oscillator(0.0625, 1.25, 0.0625, mu), some_state(1, 0), 6);
        check_jacobian(prepared_chain({1, 2}, {1, 0.5}, {0.03125, 0.0625}, 1, 2, 0.25, 0.25, mu), some_state(2, 0), all);
        check_jacobian(prepared_three_masses(0.375, 0.25, mu), some_state(3, 1), all);
        check_jacobian(prepared_three_masses(0.6875, 0.25, mu), some_state(3, 1), all);
        check_jacobian(prepared(chain_of(4, 1, 3, 0.0625, 0.03125), 0.375, 0.1875, mu), some_state(4, 1), all);
        Given coupled = chain_of(3, 1, 0, 0, 0); // inertia across the contact
        coupled.M(0, 1) = coupled.M(1, 0) = 0.25;
        coupled.M(1, 2) = coupled.M(2, 1) = -0.125;
        coupled.C = coupled.M / 32 + coupled.K / 64;
        check_phases(coupled, 0.375, 4e-13);
        check_jacobian(prepared(coupled, 0.375, 0.1875, mu), some_state(3, 1), all);
    }
}
