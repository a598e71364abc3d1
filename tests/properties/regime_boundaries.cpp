// Properties of the boundary over seeded random systems.
#include <cmath>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

constexpr std::uint64_t seed_of_boundaries = 20220614;

const std::vector<RandomScene<double>>& scenes() {
    static const std::vector<RandomScene<double>> all = random_scenes<double>(seed_of_boundaries);
    return all;
}

/// Velocity of the contact over -sin(tau) at a friction ratio, whether or not it slides there.
double margin(const ModeSums<double>& s, double beta, double tau) {
    const std::size_t j = s.contact.index;
    const double X_j = paper::displacement_transmissibility_of_contact(s.V[j], s.U[j], s.G[j], beta);
    return paper::sliding_margin(X_j, s.G[j], sliding_demand(s, tau), beta);
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
