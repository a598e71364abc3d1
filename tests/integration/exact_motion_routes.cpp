// The exact solver by second routes: its phases against the matrix exponential, its Jacobian against differences.
#include <Eigen/LU>
#include <cmath>

#include "denhartog/stick_slip/exact_motion.hpp"
#include "tests/integration/orbit_scenes.hpp"
#include "tests/support/half_period.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

/// A system as it is given, without modes.
template <class T>
struct Given {
    Matrix<T> M, C, K; // non-dimensional at r = 1: units m_1, sqrt(k_1 m_1), k_1
    Mass contact, load;
};

template <class T>
tests::Prepared<T> prepared(const Given<T>& g, const T& r, const T& beta, const T& mu) {
    System<T> s;
    s.mass_matrix = g.M;
    s.damping_matrix = g.C;
    s.stiffness_matrix = g.K;
    s.contact = g.contact;
    s.load = g.load;
    return {"", contact_system(s), {r, beta, mu}};
}

template <class T>
Matrix<T> without(const Matrix<T>& A, Eigen::Index j) {
    std::vector<Eigen::Index> kept;
    for (Eigen::Index k = 0; k < A.rows(); ++k)
        if (k != j) kept.push_back(k);
    return A(kept, kept);
}

/// The state after a time by the exponential of z' = A z, z = (x, x', cos, sin, 1): sliding in a direction, or stuck for 0.
template <class T>
State<T> by_exponential(const Given<T>& g, const Excitation<T>& e, int direction, const State<T>& start, const T& tau_0,
                        const T& t) {
    const Eigen::Index N = g.M.rows(), j = static_cast<Eigen::Index>(g.contact.index);
    // Friction on the half-period of `augmented_system` is + beta: that of a motion downwards.
    HalfPeriodProblem<T> p{g.M * T(e.r * e.r), g.C * e.r, g.K, g.contact, g.load, T(-direction * e.beta)};
    Matrix<T> A = augmented_system(p);
    if (direction == 0) { // a contact held: its row gives way to x_j'' = 0, and the others' mass matrix is theirs alone
        Matrix<T> forces = Matrix<T>::Zero(N, 2 * N + 3);
        forces.leftCols(N) = -p.K;
        forces.middleCols(N, N) = -p.C;
        forces(static_cast<Eigen::Index>(g.load.index), 2 * N) += T(1);
        Matrix<T> M = p.M;
        M.row(j).setZero();
        M.col(j).setZero();
        M(j, j) = T(1);
        forces.row(j).setZero();
        A.middleRows(N, N) = Eigen::FullPivLU<Matrix<T>>(M).solve(forces);
    }
    Vector<T> z(2 * N + 3);
    for (Eigen::Index k = 0; k < N; ++k) {
        z(k) = start.x[static_cast<std::size_t>(k)];
        z(N + k) = start.x_prime[static_cast<std::size_t>(k)];
    }
    z.tail(3) << cos(tau_0), sin(tau_0), T(1);
    z = matrix_exponential(Matrix<T>(A * t)) * z;
    State<T> end = at_rest<T>(static_cast<std::size_t>(N));
    for (Eigen::Index k = 0; k < N; ++k) {
        end.x[static_cast<std::size_t>(k)] = z(k);
        end.x_prime[static_cast<std::size_t>(k)] = z(N + k);
    }
    return end;
}

template <class T>
double largest_difference(const State<T>& a, const State<T>& b) {
    using std::abs;
    T largest(0);
    for (std::size_t k = 0; k < a.x.size(); ++k) {
        largest = std::max(largest, T(abs(a.x[k] - b.x[k])));
        largest = std::max(largest, T(abs(a.x_prime[k] - b.x_prime[k])));
    }
    return static_cast<double>(largest);
}

/// One sliding and one sticking phase of a system against the exponential in the same number type.
template <class T>
void check_phases(const Given<T>& g, const T& r, double tolerance) {
    const std::size_t N = static_cast<std::size_t>(g.M.rows()), j = g.contact.index;
    State<T> start = at_rest<T>(N);
    for (std::size_t k = 0; k < N; ++k) {
        start.x[k] = T(static_cast<int>(k) - 1) / 4;
        start.x_prime[k] = T(2 - static_cast<int>(k)) / 8;
    }
    for (const int direction : {1, -1}) {
        start.x_prime[j] = T(8 * direction); // fast enough not to turn round
        const tests::Prepared<T> p = prepared(g, r, T(T(1) / 4), T(1));
        ExactSolver<T> solver(p.system, p.excitation);
        const T tau_0 = T(3) / 8, t = std::min(T(1), r) * 3 / 8;
        const ExactMotion<T>& motion = solver.run(start, tau_0, T(tau_0 + t));
        REQUIRE(motion.phases.size() == 1);
        CHECK(motion.phases[0].direction == direction);
        CHECK(largest_difference(motion.end, by_exponential(g, p.excitation, direction, start, tau_0, t)) < tolerance);
    }
    start.x_prime[j] = T(0);
    const tests::Prepared<T> p = prepared(g, r, T(1000), T(1)); // held
    ExactSolver<T> solver(p.system, p.excitation);
    const T tau_0 = T(3) / 8, t = T(11) / 2;
    const ExactMotion<T>& motion = solver.run(start, tau_0, T(tau_0 + t));
    REQUIRE(motion.phases.size() == 1);
    CHECK(motion.phases[0].direction == 0);
    CHECK(largest_difference(motion.end, by_exponential(g, p.excitation, 0, start, tau_0, t)) < tolerance);
}

template <class T>
Given<T> one_mass(const T& zeta) {
    return {Matrix<T>::Constant(1, 1, T(1)), Matrix<T>::Constant(1, 1, T(2 * zeta)), Matrix<T>::Constant(1, 1, T(1)), Mass{0},
            Mass{0}};
}

/// A chain of unequal masses and springs with C = a M + b K.
template <class T>
Given<T> chain_of(std::size_t N, std::size_t j, std::size_t l, const T& a, const T& b) {
    const auto n = static_cast<Eigen::Index>(N);
    Given<T> g{Matrix<T>::Zero(n, n), {}, Matrix<T>::Zero(n, n), Mass{j}, Mass{l}};
    for (Eigen::Index i = 0; i < n; ++i) {
        const int number = static_cast<int>(i);
        g.M(i, i) = i == 0 ? T(1) : T(2 + number) / 2;
        const T k = i == 0 ? T(1) : T(5 - number) / 4;
        g.K(i, i) += k;
        if (i == 0) continue;
        g.K(i - 1, i - 1) += k;
        g.K(i, i - 1) -= k;
        g.K(i - 1, i) -= k;
    }
    g.C = a * g.M + b * g.K;
    return g;
}

/// The Jacobian of a stretch from the largest to the smallest entry against central differences, in 50 digits.
void check_jacobian(const tests::Prepared<Real50>& p, const State<Real50>& start, int directions_seen) {
    ExactSolver<Real50> solver(p.system, p.excitation);
    const std::size_t N = start.x.size();
    const Real50 tau_0 = Real50(1) / 16, tau_1 = 6, h("1e-18");
    const ExactMotion<Real50>& motion = solver.run(start, tau_0, tau_1, true);
    REQUIRE(motion.status == MotionStatus::complete);
    int seen = 0;
    for (const Phase<Real50>& phase : motion.phases) seen |= phase.direction == 0 ? 1 : phase.direction == 1 ? 2 : 4;
    CHECK(seen == directions_seen);
    const Matrix<Real50> jacobian = motion.jacobian;
    double largest = 0, worst = 0;
    for (std::size_t c = 0; c < 2 * N; ++c) {
        State<Real50> ends[2];
        for (const int side : {0, 1}) {
            State<Real50> z = start;
            (c < N ? z.x[c] : z.x_prime[c - N]) += side == 0 ? Real50(-h) : h;
            ends[side] = solver.run(z, tau_0, tau_1).end;
        }
        for (std::size_t k = 0; k < 2 * N; ++k) {
            const Real50 difference =
                k < N ? Real50(ends[1].x[k] - ends[0].x[k]) : Real50(ends[1].x_prime[k - N] - ends[0].x_prime[k - N]);
            const Real50 slope = difference / (2 * h);
            largest = std::max(largest, std::abs(static_cast<double>(slope)));
            worst = std::max(worst, std::abs(static_cast<double>(Real50(slope - jacobian(k, c)))));
        }
    }
    INFO(worst << " of " << largest);
    CHECK(worst < 1e-28 * (1 + largest));
}

/// A state out of any order, the contact in motion.
State<Real50> some_state(std::size_t N, std::size_t j) {
    State<Real50> z = at_rest<Real50>(N);
    for (std::size_t k = 0; k < N; ++k) {
        z.x[k] = Real50(static_cast<int>(k) + 1) / 8;
        z.x_prime[k] = Real50(3 - 2 * static_cast<int>(k)) / 16;
    }
    z.x_prime[j] = Real50(5) / 16;
    return z;
}

} // namespace

TEST_CASE("a phase is the exponential of its system: near and at resonance, underdamped, coupled, overdamped while stuck",
          "[eq:6][eq:12][exact-solver]") {
    for (const double zeta : {0.0, 1e-9, 0.01, 0.9375})
        for (const double r : {1.0, 1 + 1e-9, 1 + 1e-6, 0.9990234375, 1.0625, 0.125, 3.0}) {
            INFO("zeta " << hexadecimal(zeta) << " r " << hexadecimal(r));
            check_phases(one_mass(zeta), r, 4e-14);
            check_phases(one_mass(Real50(zeta)), Real50(r), 1e-46);
        }
    for (const double r : {0.25, 0.7071067811865476, 1.0, 2.5}) {
        INFO("r " << hexadecimal(r));
        check_phases(chain_of<double>(4, 1, 0, 0.0625, 0.03125), r, 4e-13);
        check_phases(chain_of<double>(4, 3, 3, 0, 0), r, 4e-13);
        check_phases(chain_of<double>(3, 1, 2, 0.5, 0.25), r, 4e-13);
        check_phases(chain_of<Real50>(4, 1, 0, Real50(1) / 16, Real50(1) / 32), Real50(r), 1e-44);
        check_phases(chain_of<Real50>(3, 1, 2, Real50(1) / 2, Real50(1) / 4), Real50(r), 1e-44);
    }
}

TEST_CASE("stuck modes that damping couples or that are overdamped move as the exponential says",
          "[eq:19][eq:88][exact-solver]") {
    // Modal damping ratios that differ: C is full, and the stuck block of it is not diagonalised by the stuck modes.
    const auto check_modal = [](auto number, const std::vector<double>& zeta, double r, double tolerance) {
        using T = decltype(number);
        System<T> s;
        s.mass_ratios = {T(1), T(2), T(1)};
        s.stiffness_ratios = {T(1), T(1) / 4, T(3) / 4};
        s.damping_ratios.assign(zeta.begin(), zeta.end());
        s.contact = Mass{1};
        const NonDimensionalMatrices<T> m = non_dimensional_matrices(s, modal_basis(s), T(1));
        const ContactSystem<T> system = contact_system(s);
        CHECK_FALSE(system.stuck.modes_diagonalise_damping);
        const Given<T> g{m.M, m.C, m.K, s.contact, s.load};
        State<T> start = at_rest<T>(3);
        start.x = {T(1) / 2, T(-1) / 4, T(1)};
        start.x_prime = {T(-3) / 4, T(0), T(1) / 8};
        ExactSolver<T> solver(system, {T(r), T(1000), T(1)});
        const T tau_0 = T(5) / 8, t = T(6);
        const ExactMotion<T>& motion = solver.run(start, tau_0, T(tau_0 + t));
        REQUIRE(motion.phases.size() == 1);
        const Excitation<T> e{T(r), T(1000), T(1)};
        CHECK(largest_difference(motion.end, by_exponential(g, e, 0, start, tau_0, t)) < tolerance);
        const T inside = T(2);
        CHECK(largest_difference(solver.state_at(0, T(tau_0 + inside)), by_exponential(g, e, 0, start, tau_0, inside)) <
              tolerance);
    };
    for (const double r : {0.125, 0.875, 2.0}) {
        INFO("r " << hexadecimal(r));
        for (const std::vector<double>& zeta :
             {std::vector<double>{0.03125, 0.0625, 0.25}, {0.9375, 0.03125, 0.96875}, {0.0, 0.5, 0.0}}) {
            check_modal(0.0, zeta, r, 1e-12);
            check_modal(Real50(0), zeta, r, 1e-43);
        }
    }
}

TEST_CASE("the Jacobian over phases and their ends is that of differences", "[eq:2][eq:3][eq:74][exact-solver][shooting]") {
    const int all = 7;
    for (const double mu : {1.0, 1.5}) {
        INFO("mu " << mu);
        check_jacobian(prepared_oscillator<Real50>(0.03125, 0.125, 0.1875, mu), some_state(1, 0), all);
        check_jacobian(prepared_oscillator<Real50>(0, 0.3125, 0.25, mu), some_state(1, 0), all);
        check_jacobian(prepared_oscillator<Real50>(0.0625, 1.25, 0.0625, mu), some_state(1, 0), 6);
        check_jacobian(prepared_chain<Real50>({1, 2}, {1, 0.5}, {0.03125, 0.0625}, 1, 2, 0.25, 0.25, mu), some_state(2, 0), all);
        check_jacobian(prepared_three_masses<Real50>(0.375, 0.25, mu), some_state(3, 1), all);
        check_jacobian(prepared_three_masses<Real50>(0.6875, 0.25, mu), some_state(3, 1), all);
        const Given<Real50> given = chain_of<Real50>(4, 1, 3, Real50(1) / 16, Real50(1) / 32);
        check_jacobian(prepared(given, Real50(Real50(3) / 8), Real50(Real50(3) / 16), Real50(mu)), some_state(4, 1), all);
        Given<Real50> coupled = chain_of<Real50>(3, 1, 0, Real50(1) / 32, Real50(1) / 64); // inertia across the contact
        coupled.M(0, 1) = coupled.M(1, 0) = Real50(1) / 4;
        coupled.M(1, 2) = coupled.M(2, 1) = Real50(-1) / 8;
        coupled.C = coupled.M * Real50(Real50(1) / 32) + coupled.K * Real50(Real50(1) / 64);
        check_phases(coupled, Real50(Real50(3) / 8), 1e-44);
        check_jacobian(prepared(coupled, Real50(Real50(3) / 8), Real50(Real50(3) / 16), Real50(mu)), some_state(3, 1), all);
    }
}
