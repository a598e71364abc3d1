#include <cmath>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog::tests;
using namespace denhartog;

// Changes of a scene that leave its response as it is, over seeded random systems.

namespace {

constexpr std::uint64_t seed_of_invariances = 117085;

/// Random scenes without equal or nearly equal natural frequencies, by their matrices, with beta inside the boundary.
std::vector<RandomScene<double>> scenes_by_matrices() {
    std::vector<RandomScene<double>> all;
    int n = 0;
    for (RandomScene<double> random : random_scenes<double>(seed_of_invariances)) {
        if (++n % 4 != 0) continue;
        System<double>& s = random.scene.system;
        const Eigen::Index N = static_cast<Eigen::Index>(number_of_masses(s));
        const NonDimensionalMatrices m = matrices_of(random.scene);
        if (s.mass_matrix.size() == 0) s.mass_matrix = Eigen::Map<Eigen::VectorXd>(s.mass_ratios.data(), N).asDiagonal();
        s.mass_ratios.clear();
        s.stiffness_ratios.clear();
        s.stiffness_matrix = m.K;
        random.scene.beta = friction_ratio_at(random.fraction_of_limit, boundary(sums_of(random.scene), random.scene.mu).exact);
        all.push_back(random);
    }
    return all;
}

void check_same(const Response<double>& a, const Response<double>& b, const std::vector<std::size_t>& place, double scale,
                const std::string& name) {
    INFO(name);
    CHECK(a.boundary.exact == Approx(b.boundary.exact).epsilon(1e-8));
    CHECK(a.boundary.paper == Approx(b.boundary.paper).epsilon(1e-8));
    REQUIRE((a.steady_state && b.steady_state));
    for (std::size_t k = 0; k < place.size(); ++k) {
        const MassResponse<double>&p = a.steady_state->masses[k], q = b.steady_state->masses[place[k]];
        INFO("mass " << k + 1 << ": " << hexadecimal(p.amplitude) << " and " << hexadecimal(q.amplitude));
        CHECK(p.amplitude == Approx(scale * q.amplitude).epsilon(1e-8));
        CHECK(std::abs(p.x0 - scale * q.x0) < 1e-8 * p.amplitude);
        CHECK(std::abs(std::remainder(p.phase_monoharmonic - q.phase_monoharmonic, 2 * pi<double>())) < 1e-6);
    }
}

std::vector<std::size_t> in_order(std::size_t N) {
    std::vector<std::size_t> place(N);
    for (std::size_t k = 0; k < N; ++k) place[k] = k;
    return place;
}

} // namespace

TEST_CASE("masses can be numbered in any order", "[eq:1][eq:6]") {
    for (const RandomScene<double>& random : scenes_by_matrices()) {
        const std::size_t N = number_of_masses(random.scene.system);
        std::vector<std::size_t> place; // in reverse order
        for (std::size_t k = 0; k < N; ++k) place.push_back(N - 1 - k);
        Scene<double> other = random.scene;
        System<double>& s = other.system;
        s.mass_matrix = random.scene.system.mass_matrix.reverse().eval();
        s.stiffness_matrix = random.scene.system.stiffness_matrix.reverse().eval();
        if (s.damping_matrix.size() > 0) s.damping_matrix = random.scene.system.damping_matrix.reverse().eval();
        s.contact = Mass{place[s.contact.index]};
        s.load = Mass{place[s.load.index]};
        check_same(response(random.scene), response(other), place, 1, random.name);
    }
}

TEST_CASE("masses four times heavier at half the frequency move the same", "[eq:7][eq:10]") {
    for (const RandomScene<double>& random : scenes_by_matrices()) {
        Scene<double> other = random.scene;
        other.system.mass_matrix *= 4;
        if (other.system.damping_matrix.size() > 0) other.system.damping_matrix *= 2;
        *other.r /= 2;
        check_same(response(random.scene), response(other), in_order(number_of_masses(other.system)), 1, random.name);
    }
}

TEST_CASE("springs four times stiffer at twice the frequency move a quarter", "[eq:5][eq:7]") {
    for (const RandomScene<double>& random : scenes_by_matrices()) {
        Scene<double> other = random.scene;
        other.system.stiffness_matrix *= 4;
        if (other.system.damping_matrix.size() > 0) other.system.damping_matrix *= 2;
        *other.r *= 2;
        check_same(response(random.scene), response(other), in_order(number_of_masses(other.system)), 4, random.name);
    }
}

TEST_CASE("a mass that hangs on the ground alone changes nothing", "[eq:33][eq:34][eq:35]") {
    for (const RandomScene<double>& random : scenes_by_matrices()) {
        if (random.scene.system.damping_matrix.size() > 0) continue;
        const Eigen::Index N = static_cast<Eigen::Index>(number_of_masses(random.scene.system));
        const ModalBasis<double> basis = modal_basis(random.scene.system);
        Scene<double> other = random.scene;
        System<double>& s = other.system;
        s.mass_matrix.conservativeResizeLike(Eigen::MatrixXd::Zero(N + 1, N + 1));
        s.stiffness_matrix.conservativeResizeLike(Eigen::MatrixXd::Zero(N + 1, N + 1));
        s.mass_matrix(N, N) = 1;
        s.stiffness_matrix(N, N) = 4 * basis.r_n.back() * basis.r_n.back(); // its mode comes last
        s.damping_ratios.push_back(0.125);
        const Response<double> with = response(other);
        check_same(response(random.scene), with, in_order(static_cast<std::size_t>(N)), 1, random.name);
        CHECK(with.steady_state->masses.back().amplitude < 1e-12);
    }
}

TEST_CASE("what the load puts in is what friction and damping take out", "[eq:3][eq:6][energy]") {
    for (RandomScene<double> random : random_scenes<double>(seed_of_invariances)) {
        if (number_of_masses(random.scene.system) > 6) break;
        const ModeSums<double> s = sums_of(random.scene);
        const Boundary<double> b = boundary(s, random.scene.mu);
        random.scene.beta = friction_ratio_at(random.fraction_of_limit, b.exact);
        const SteadyState<double> state = steady_state(s, b, *random.scene.beta);
        const Eigen::MatrixXd C = matrices_of(random.scene).C;
        // Gauss's rule with 3 points in each of many equal steps of the half-period.
        const int steps = 400;
        double input = 0, viscous = 0;
        for (int n = 0; n < steps; ++n)
            for (int p = -1; p <= 1; ++p) {
                const double h = pi<double>() / steps;
                const double tau = h * (n + 0.5 + p * 0.5 * std::sqrt(0.6));
                const double weight = h * (p == 0 ? 8 : 5) / 18;
                const Motion<double> now = motion(s, state, tau);
                const Eigen::Map<const Eigen::VectorXd> v(now.x_prime.data(), C.rows());
                input += weight * std::cos(tau + state.phi_j) * now.x_prime[s.load.index];
                viscous += weight * v.dot(C * v);
            }
        const double friction = 2 * *random.scene.beta * state.X_j;
        INFO(random.name << ": " << hexadecimal(input) << " and " << hexadecimal(viscous) << " + " << hexadecimal(friction));
        CHECK(std::abs(input - viscous - friction) < 1e-8 * (std::abs(input) + viscous + friction));
    }
}

// Amplitudes against dense samples, over seeded random systems.

TEST_CASE("no sample of the motion exceeds an amplitude, and samples come up to it", "[eq:46][eq:47][maximum]") {
    constexpr std::uint64_t seed = 535;
    int n = 0;
    for (RandomScene<double> random : random_scenes<double>(seed)) {
        if (++n % 3 != 0) continue;
        const ModeSums<double> s = sums_of(random.scene);
        const Boundary<double> b = boundary(s, random.scene.mu);
        random.scene.beta = friction_ratio_at(random.fraction_of_limit, b.exact);
        const SteadyState<double> state = steady_state(s, b, *random.scene.beta);
        constexpr int samples = 1000;
        std::vector<double> largest(state.masses.size());
        for (int i = 0; i <= samples; ++i) {
            const Motion<double> now = motion(s, state, std::min(pi<double>(), pi<double>() * i / samples));
            for (std::size_t k = 0; k < largest.size(); ++k) largest[k] = std::max(largest[k], std::abs(now.x[k]));
        }
        for (std::size_t k = 0; k < largest.size(); ++k) {
            const double amplitude = state.masses[k].amplitude;
            INFO(random.name << ", mass " << k + 1 << ": " << hexadecimal(amplitude) << " and " << hexadecimal(largest[k]));
            CHECK(largest[k] <= amplitude * (1 + 1e-11));
            CHECK(largest[k] >= amplitude * (1 - 1e-3));
        }
    }
}

TEST_CASE("many oscillations in a half-period do not hide the largest", "[eq:57][eq:47][maximum]") {
    for (const double r : {0.02, 0.0201, 0.0303})
        for (const double zeta : {0.0, 0.0009765625}) {
            Scene<double> scene = chain({1, 2.5, 0.75}, {1, 0.625, 1.875}, {zeta, zeta, zeta}, 2, 1, 1, r);
            const ModeSums<double> s = sums_of(scene);
            const Boundary<double> b = boundary(s, scene.mu);
            double demand = 0;
            for (int n = 1; n < 100000; ++n) demand = std::max(demand, sliding_demand(s, pi<double>() * n / 100000));
            INFO("r = " << hexadecimal(r) << ", zeta = " << hexadecimal(zeta));
            CHECK(demand <= b.S_exact * (1 + 1e-10));
            CHECK(demand >= b.S_exact * (1 - 1e-2));
            const SteadyState<double> state = steady_state(s, b, 0.5 * b.exact);
            for (std::size_t k = 0; k < 3; ++k) {
                const double sampled = largest_sample(s, state, k, 20000);
                CHECK(sampled <= state.masses[k].amplitude * (1 + 1e-12));
                CHECK(sampled >= state.masses[k].amplitude * (1 - 1e-4));
            }
        }
}

// Properties of the boundary over seeded random systems.

namespace {

constexpr std::uint64_t seed_of_boundaries = 20220614;

const std::vector<RandomScene<double>>& scenes() {
    static const std::vector<RandomScene<double>> all = random_scenes<double>(seed_of_boundaries);
    return all;
}

} // namespace

TEST_CASE("the paper's boundary is never above the exact one, the approximation never below", "[eq:56][eq:67][eq:69]") {
    int strictly_below = 0;
    for (const RandomScene<double>& random : scenes()) {
        const ModeSums<double> s = sums_of(random.scene);
        const Boundary<double> b = boundary(s, random.scene.mu), with_one = boundary(s, 1.0);
        INFO(random.name << ": " << hexadecimal(b.paper) << " " << hexadecimal(b.exact) << " " << hexadecimal(b.approximate));
        CHECK(b.paper <= b.exact * (1 + 1e-13));
        CHECK(b.exact <= b.approximate);
        CHECK(b.S_exact <= b.S_paper * (1 + 1e-13));
        CHECK(with_one.approximate >= b.exact);
        CHECK(with_one.S_exact == b.S_exact);
        if (with_one.paper < with_one.exact * (1 - 1e-9)) ++strictly_below;
    }
    CHECK(strictly_below > 0); // (56) as an equality would pass every check above
}

TEST_CASE("(58) and (68) are never met together", "[eq:58][eq:68]") {
    int excluding = 0;
    for (const RandomScene<double>& random : scenes()) {
        const ModeSums<double> s = sums_of(random.scene);
        const std::size_t j = s.contact.index;
        const double demand = s.H_j - random.scene.mu * s.sum_of_squares;
        if (demand <= 0) continue;
        ++excluding;
        const Boundary<double> b = boundary(s, random.scene.mu);
        INFO(random.name);
        CHECK(paper::friction_ratio_limit(s.V[j], s.U[j], demand) > paper::friction_ratio_limit(s.V[j], s.U[j], b.S_exact));
    }
    CHECK(excluding > 0);
}

TEST_CASE("the contact moves down throughout just inside the boundary", "[eq:54][eq:55][eq:58]") {
    for (const RandomScene<double>& random : scenes()) {
        const ModeSums<double> s = sums_of(random.scene);
        const Boundary<double> b = boundary(s, random.scene.mu);
        const double beta = b.exact * (1 - 1e-6);
        for (int n = 1; n < 200; ++n) {
            const double tau = pi<double>() * n / 200;
            if (margin(s, beta, tau) > 0) continue;
            FAIL(random.name << " at tau = " << hexadecimal(tau) << ", beta = " << hexadecimal(beta));
        }
        const double beyond = paper::friction_ratio_limit(s.V[s.contact.index], s.U[s.contact.index], b.S_exact) * (1 + 1e-5);
        INFO(random.name);
        CHECK(margin(s, beyond, b.instant > 0 ? b.instant : 1e-9 * s.R.front()) < 0);
    }
}

TEST_CASE("with load and contact on one mass permanent sticking starts at 1 / mu", "[sticking]") {
    int tried = 0;
    for (const RandomScene<double>& random : scenes()) {
        if (!(random.scene.system.contact == random.scene.system.load)) continue;
        ++tried;
        const Boundary<double> b = boundary(sums_of(random.scene), random.scene.mu);
        INFO(random.name);
        CHECK((b.sticking && *b.sticking == 1 / random.scene.mu));
    }
    CHECK(tried > 50);
}

TEST_CASE("permanent sticking starts where a dense solve with the contact held has static friction", "[sticking]") {
    for (const RandomScene<double>& random : scenes()) {
        const NonDimensionalMatrices m = matrices_of(random.scene);
        const Eigen::Index N = m.M.rows(), j = static_cast<Eigen::Index>(random.scene.system.contact.index);
        Eigen::MatrixXd A(2 * N, 2 * N);
        A << m.K - m.M, m.C, -m.C, m.K - m.M;
        for (const Eigen::Index column : {j, N + j}) A.col(column) = -Eigen::VectorXd::Unit(2 * N, column);
        const Eigen::FullPivLU<Eigen::MatrixXd> solver(A);
        const Eigen::VectorXd x =
            solver.solve(Eigen::VectorXd::Unit(2 * N, static_cast<Eigen::Index>(random.scene.system.load.index)));
        const Boundary<double> b = boundary(sums_of(random.scene), random.scene.mu);
        INFO(random.name << ", reciprocal condition " << solver.rcond());
        REQUIRE(b.sticking);
        CHECK(std::abs(*b.sticking * random.scene.mu - std::hypot(x(j), x(N + j))) < 1e-14 / solver.rcond() * x.norm());
    }
}
