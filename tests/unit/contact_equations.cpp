// The equations as a system of first order: the load on the contact, the accelerations while it sticks and slides.
#include "denhartog/paper_algorithm/contact_equations.hpp"

#include <cmath>

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

struct Sample {
    std::vector<double> y;
    Eigen::VectorXd x, v;
};

Sample sample_of(std::size_t N, std::size_t j) {
    Sample s{std::vector<double>(2 * N), Eigen::VectorXd(static_cast<Eigen::Index>(N)),
             Eigen::VectorXd(static_cast<Eigen::Index>(N))};
    for (std::size_t n = 0; n < N; ++n) {
        s.y[n] = std::sin(3.0 * static_cast<double>(n) + 1);
        s.y[N + n] = n == j ? 0 : std::cos(2.0 * static_cast<double>(n) + 0.5);
        s.x(static_cast<Eigen::Index>(n)) = s.y[n];
        s.v(static_cast<Eigen::Index>(n)) = s.y[N + n];
    }
    return s;
}

} // namespace

TEST_CASE("on a diagonal mass matrix the load on the contact is the sum that the paper prints", "[eq:75][paper-algorithm]") {
    for (const std::size_t l : {1u, 2u}) {
        Scene<double> scene = three_masses();
        scene.system.load = Mass{l - 1};
        scene.beta = 0.25;
        const ContactProblem p = contact_problem(scene);
        const ContactEquations equations(p);
        const Sample s = sample_of(3, 1);
        const double tau = 0.75;
        const double printed = p.matrices.C.row(1).dot(s.v) + p.matrices.K.row(1).dot(s.x) - (l == 2 ? std::cos(tau) : 0);
        CHECK(std::abs(equations.load_on_contact(s.y, tau) + printed) <= 1e-15);
    }
}

TEST_CASE("the load is what friction has to balance to hold the contact, inertia of the others included",
          "[eq:75][eq:6][paper-algorithm]") {
    int coupled = 0;
    double worst = 0;
    std::string where;
    for (const RandomScene<double>& random : random_scenes<double>(11)) {
        Scene<double> scene = random.scene;
        scene.beta = 0.5;
        const ContactProblem p = contact_problem(scene);
        ContactEquations equations(p);
        const Eigen::Index N = p.matrices.M.rows(), j = static_cast<Eigen::Index>(p.contact.index);
        const Sample s = sample_of(equations.N, equations.contact.a);
        const double tau = 2.25;
        coupled += !p.matrices.M.isDiagonal(0);
        // Unknown: accelerations of the others and the friction at the contact, whose acceleration is zero.
        Eigen::MatrixXd A = p.matrices.M;
        A.col(j) = -Eigen::VectorXd::Unit(N, j);
        const Eigen::VectorXd force = std::cos(tau) * Eigen::VectorXd::Unit(N, static_cast<Eigen::Index>(p.load.index)) -
                                      p.matrices.K * s.x - p.matrices.C * s.v;
        const Eigen::VectorXd unknown = A.partialPivLu().solve(force);
        std::vector<double> y_prime(s.y.size());
        equations.set(0);
        equations(s.y, y_prime, tau);
        double error = std::abs(equations.load_on_contact(s.y, tau) + unknown(j)) / (1 + std::abs(unknown(j)));
        for (Eigen::Index k = 0; k < N; ++k) {
            const double a = y_prime[static_cast<std::size_t>(N + k)];
            if (k == j)
                CHECK(a == 0);
            else
                error = std::max(error, std::abs(a - unknown(k)) / (1 + unknown.cwiseAbs().maxCoeff()));
        }
        // Sliding, the contact is moved by the load less friction.
        for (const int direction : {1, -1}) {
            equations.set(direction);
            equations(s.y, y_prime, tau);
            const double a = (equations.load_on_contact(s.y, tau) - direction * 0.5) * equations.compliance;
            error = std::max(error, std::abs(y_prime[equations.N + equations.contact.a] - a) / (1 + std::abs(a)));
        }
        if (error > worst) {
            worst = error;
            where = random.name;
        }
    }
    INFO("worst at " << where << ": " << hexadecimal(worst));
    CHECK(coupled >= 20);
    CHECK(worst <= 1e-12);
}

TEST_CASE("the equations of a contact name the quantity, the rule and the value of bad input", "[bad-input][paper-algorithm]") {
    const Matrix<double> one = Matrix<double>::Identity(2, 2);
    using Equations = ContactEquations;
    CHECK_NOTHROW(Equations({{one, one, one}, {0}, {1}, 1, 0.5}));
    CHECK_THROWS_WITH(Equations({{one, Matrix<double>::Identity(3, 3), one}, {0}, {1}, 1, 0.5}),
                      Catch::Contains("C must be 2 x 2, but is 3 x 3"));
    CHECK_THROWS_WITH(Equations({{-one, one, one}, {0}, {1}, 1, 0.5}), Catch::Contains("M must be positive definite"));
    CHECK_THROWS_WITH(Equations({{one, one, one}, {2}, {1}, 1, 0.5}), Catch::Contains("contact must be from 1 to 2, but is 3"));
    CHECK_THROWS_WITH(Equations({{one, one, one}, {0}, {1}, 0.5, 0.5}), Catch::Contains("mu must be finite and at least 1"));
    CHECK_THROWS_WITH(Equations({{one, one, one}, {0}, {1}, 1, std::nan("")}), Catch::Contains("beta must be finite"));
    CHECK_THROWS_AS(Equations({{one, one, one * std::nan("")}, {0}, {1}, 1, 0.5}), InputError);
    Scene<double> scene = three_masses();
    CHECK_THROWS_WITH(contact_problem(scene), Catch::Contains("beta must be given"));
}
