#include <cmath>
#include <limits>
#include <random>

#include "denhartog/evaluation/mode_arrays.hpp"
#include "denhartog/paper_algorithm/contact_equations.hpp"
#include "tests/speed_accuracy/table.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog::tests;
using namespace denhartog;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

std::vector<double> frequency_ratios(std::size_t n) {
    std::vector<double> r{1e-3, 0.5, 1, 2, 50};
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    while (r.size() < n) r.push_back(std::exp2(7 * unit(random) - 4));
    return r;
}

std::vector<System<double>> systems() {
    System<double> undamped = three_masses().system;
    undamped.damping_ratios = {0, 0.0625, 0};
    return {oscillator(0, 1).system, oscillator(0.015625, 1).system, oscillator(0.75, 1).system, three_masses().system, undamped};
}

/// The sizes of the terms of the sums at the mass in contact, which rounding errors are relative to, with the terms' own
/// condition: a change of R by eps moves v, u and g by that much.
struct Sizes {
    double V = 0, U = 0, G = 0, H = 0;
};

Sizes sizes_of(const ModalBasis<double>& basis, const System<double>& system, double r) {
    const ModeSums<double> s = mode_sums(basis, system.contact, system.load, r);
    const ModeSums<double> next = mode_sums(basis, system.contact, system.load, r * (1 + 0x1p-26));
    const auto psi_j = mode_shapes_at(s, s.contact), psi_l = mode_shapes_at(s, s.load);
    Sizes sizes;
    for (std::size_t i = 0; i < s.R.size(); ++i) {
        const double square = s.R[i] * s.R[i];
        const auto with_condition = [](double x, double y) { return std::abs(x) + std::abs(y - x) * 0x1p26; };
        const double v = with_condition(s.v[i].re, next.v[i].re) + with_condition(s.v[i].im, next.v[i].im);
        const double u = with_condition(s.u[i], next.u[i]), g = with_condition(s.g[i], next.g[i]);
        sizes.V += std::abs(psi_j[i] * psi_l[i]) * square * v;
        sizes.U += psi_j[i] * psi_j[i] * square * u;
        sizes.G += psi_j[i] * psi_j[i] * square * g;
        sizes.H += psi_j[i] * psi_j[i] * (g + 2 * s.zeta[i] * s.R[i] * u);
    }
    return sizes;
}

double difference(double a, double b, double size) { return a == b ? 0 : std::abs(a - b) / (eps * size); }

ContactSums sums_over(const System<double>& system, const std::vector<double>& r, unsigned threads) {
    ContactSums sums;
    contact_sums(with_errors(system, modal_basis(system)), system.contact, system.load, r, threads, sums);
    return sums;
}

} // namespace

TEST_CASE("sums over arrays of r are those at each r", "[eq:33][eq:34][eq:35][eq:64][eq:65]") {
    for (const System<double>& system : systems()) {
        const ModalBasis<double> basis = modal_basis(system);
        const std::vector<double> r = frequency_ratios(2500);
        const ContactSums sums = sums_over(system, r, 2);
        const std::size_t j = system.contact.index;
        double worst = 0;
        std::string where;
        for (std::size_t n = 0; n < r.size(); ++n) {
            if (sums.without_numbers[n] != 0) {
                CHECK_THROWS_AS(mode_sums(basis, system.contact, system.load, r[n]), DomainError);
                continue;
            }
            const ModeSums<double> one = mode_sums(basis, system.contact, system.load, r[n]);
            const Sizes size = sizes_of(basis, system, r[n]);
            for (const double each : {difference(sums.V_re[n], one.V[j].re, size.V),
                                      difference(sums.V_im[n], one.V[j].im, size.V), difference(sums.U[n], one.U[j], size.U),
                                      difference(sums.G[n], one.G[j], size.G), difference(sums.H[n], one.H_j, size.H),
                                      difference(sums.sum_of_squares[n], one.sum_of_squares, one.sum_of_squares)})
                if (!(each <= worst)) {
                    worst = each;
                    where = hexadecimal(r[n]);
                }
        }
        INFO(basis.r_n.size() << " modes, zeta_1 = " << basis.zeta[0] << ": " << worst << " eps at r = " << where);
        CHECK(worst <= 16);
    }
}

TEST_CASE("over arrays each mode is evaluated once an r", "[counter]") {
    const std::vector<double> r = frequency_ratios(1000);
    const long before = evaluation::array_mode_evaluations(), scalar = mode_evaluations();
    CHECK(sums_over(three_masses().system, r, 2).modes == 3);
    CHECK(evaluation::array_mode_evaluations() - before == 3 * 1000);
    CHECK(mode_evaluations() == scalar);
}

TEST_CASE("the number of threads changes nothing in sums over arrays", "[threads][eq:33][eq:34][eq:64]") {
    const std::vector<double> r = frequency_ratios(3000);
    const ContactSums one = sums_over(three_masses().system, r, 1), three = sums_over(three_masses().system, r, 3);
    CHECK(one.V_re == three.V_re);
    CHECK(one.U == three.U);
    CHECK(one.H == three.H);
}

TEST_CASE("sums that are written over keep nothing of what they were", "[eq:33]") {
    const System<double> system = three_masses().system;
    const ModalBasis<Bounded<double>> basis = with_errors(system, modal_basis(system));
    ContactSums sums;
    contact_sums(basis, system.contact, system.load, std::vector<double>{1e-200, 0.5, 1.5}, 1, sums);
    CHECK(sums.without_numbers == std::vector<std::uint8_t>{1, 0, 0});
    contact_sums(basis, system.contact, system.load, std::vector<double>{0.5, 1.5}, 1, sums);
    CHECK(sums.without_numbers == std::vector<std::uint8_t>{0, 0});
    CHECK(sums.V_re == sums_over(system, {0.5, 1.5}, 1).V_re);
}

TEST_CASE("a sum beyond the range of a double is none", "[domain]") {
    const ContactSums sums = sums_over(three_masses().system, {1, 1e-200}, 1);
    CHECK(sums.without_numbers == std::vector<std::uint8_t>{0, 1});
    CHECK(sums.H[1] == 0);
    CHECK_FALSE(sums.certainty[1] > 0);
}

TEST_CASE("arguments of sums over arrays are checked", "[domain]") {
    const System<double> system = three_masses().system;
    const ModalBasis<Bounded<double>> basis = with_errors(system, modal_basis(system));
    const auto over = [&](Mass contact, const std::vector<double>& r, unsigned threads) {
        ContactSums sums;
        contact_sums(basis, contact, Mass{0}, r, threads, sums);
    };
    CHECK_THROWS_AS(over(Mass{0}, {1, -1}, 1), InputError);
    CHECK_THROWS_WITH(over(Mass{3}, {1}, 1), "contact must be a mass from 1 to 3, but is 4");
    CHECK_THROWS_WITH(over(Mass{0}, {1}, 0), "threads must be at least 1, but is 0");
}

TEST_CASE("over an array X_j has the digits of the form for one friction ratio, and those are right", "[eq:38]") {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    Worst worst;
    long points = 0;
    for (const Scene<double>& scene : {oscillator(0.015625, 1), oscillator(0.75, 1), three_masses()}) {
        const ModalBasis<double> basis = modal_basis(scene.system);
        for (int m = 1; m <= 100; ++m) {
            const double r = m / 33.0;
            const ModeSums<double> sums = mode_sums(basis, scene.system.contact, scene.system.load, r);
            const double limit = boundary(sums, scene.mu).exact;
            const std::size_t j = sums.contact.index;
            std::vector<double> beta{0, std::nextafter(limit, 0)};
            for (int n = 1; n < 30; ++n) beta.push_back(limit * n / 30.0);
            std::vector<double> X(beta.size());
            contact_amplitudes(sums.V[j], sums.U[j], sums.G[j], beta, X);
            const auto of_V = std::hypot(static_cast<long double>(sums.V[j].re), static_cast<long double>(sums.V[j].im));
            for (std::size_t n = 0; n < beta.size(); ++n, ++points) {
                const std::string at = "r = " + hexadecimal(r) + ", beta = " + hexadecimal(beta[n]);
                INFO(at);
                CHECK(X[n] == evaluation::displacement_transmissibility_of_contact(sums.V[j], sums.U[j], sums.G[j], beta[n]));
                const long double lag = static_cast<long double>(beta[n]) * sums.U[j];
                const long double root = std::sqrt((of_V - lag) * (of_V + lag));
                const auto exact = static_cast<double>(root - static_cast<long double>(beta[n]) * sums.G[j]);
                worst.note(std::abs(X[n] - exact) / (eps * (static_cast<double>(root) + beta[n] * std::abs(sums.G[j]))), at);
            }
        }
    }
    INFO(points << " points, worst " << worst.error << " eps at " << worst.where);
    CHECK(worst.error <= 2);
}

// The equations as a system of first order: the load on the contact, the accelerations while it sticks and slides.

namespace {

struct SampledState {
    std::vector<double> y;
    Eigen::VectorXd x, v;
};

SampledState sampled_state(std::size_t N, std::size_t j) {
    SampledState s{std::vector<double>(2 * N), Eigen::VectorXd(static_cast<Eigen::Index>(N)),
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
        const SampledState s = sampled_state(equations.N, equations.contact.a);
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
