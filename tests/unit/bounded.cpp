#include <cmath>
#include <random>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/models_in_double.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "tests/catch.hpp"
#include "tests/support/closed_form.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog::tests;
using namespace denhartog;

namespace {

// A number within its error, and the true one somewhere in there.
struct Pair {
    Bounded<double> bounded;
    Real50 exact;
};

class Source {
public:
    double uniform(double from, double to) { return from + (to - from) * static_cast<double>(generator() >> 11) * 0x1p-53; }
    Pair number(double from, double to) {
        const double x = uniform(from, to), e = std::abs(x) * std::ldexp(uniform(0, 1), -20 - static_cast<int>(generator() % 30));
        return {{x, e}, Real50(x) + Real50(e) * Real50(uniform(-1, 1))};
    }

private:
    std::mt19937_64 generator{5};
};

bool holds(const Bounded<double>& a, const Real50& exact) { return abs(Real50(Real50(a.x) - exact)) <= Real50(a.e); }

} // namespace

TEST_CASE("the error bound of every operation holds and is not idle", "[accuracy]") {
    Source source;
    double least_used = 1; // how much of the bound was needed at the most, over the operations
    for (int n = 0; n < 2000; ++n) {
        const Pair a = source.number(-4, 4), b = source.number(0.5, 4), c = source.number(0.01, 2);
        const std::vector<std::pair<Bounded<double>, Real50>> results{{a.bounded + b.bounded, a.exact + b.exact},
                                                                      {a.bounded - b.bounded, a.exact - b.exact},
                                                                      {a.bounded * b.bounded, a.exact * b.exact},
                                                                      {a.bounded / b.bounded, a.exact / b.exact},
                                                                      {sqrt(c.bounded), sqrt(c.exact)},
                                                                      {exp(a.bounded), exp(a.exact)},
                                                                      {sin(a.bounded), sin(a.exact)},
                                                                      {cos(a.bounded), cos(a.exact)},
                                                                      {sinh(a.bounded), sinh(a.exact)},
                                                                      {cosh(a.bounded), cosh(a.exact)},
                                                                      {atan2(a.bounded, b.bounded), atan2(a.exact, b.exact)},
                                                                      {sin_pi(c.bounded), sin(Real50(pi<Real50>() * c.exact))},
                                                                      {cos_pi(c.bounded), cos(Real50(pi<Real50>() * c.exact))},
                                                                      {exp_minus_one(c.bounded), Real50(exp(c.exact) - 1)}};
        double used = 0;
        for (std::size_t i = 0; i < results.size(); ++i) {
            INFO("operation " << i << ", run " << n);
            REQUIRE(holds(results[i].first, results[i].second));
            used = std::max(used, static_cast<double>(Real50(abs(Real50(Real50(results[i].first.x) - results[i].second)) /
                                                             Real50(results[i].first.e))));
        }
        least_used = std::min(least_used, used);
    }
    CHECK(least_used > 0.01);
}

TEST_CASE("sine and cosine together are what they are apart, in 50 digits and with bounds too", "[accuracy]") {
    Source draw;
    for (int n = 0; n < 500; ++n) {
        const Pair angle = draw.number(-30, 30);
        const SineCosine<Real50> together = sine_cosine(angle.exact);
        CHECK((together.s == sin(angle.exact) && together.c == cos(angle.exact)));
        const SineCosine<Bounded<double>> bounded = sine_cosine(angle.bounded);
        CHECK((bounded.s.x == elementary::sin(angle.bounded.x) && bounded.c.x == elementary::cos(angle.bounded.x)));
        CHECK(abs(together.s - bounded.s.x) <= bounded.s.e);
        CHECK(abs(together.c - bounded.c.x) <= bounded.c.e);
        const double change = angle.bounded.e / 2; // a bound below it would be none
        CHECK(bounded.s.e >= change * std::abs(bounded.c.x));
        CHECK(bounded.c.e >= change * std::abs(bounded.s.x));
    }
}

TEST_CASE("a quotient by what may be zero and an angle of what may be the origin have no useful bound", "[accuracy]") {
    CHECK_FALSE((Bounded<double>(1) / Bounded<double>(0.5, 0.5)).e < 1e300);
    CHECK(atan2(Bounded<double>(0.1, 0.2), Bounded<double>(0.1)).e > 6);
    CHECK(sqrt(Bounded<double>(0.0, 1e-8)).e >= 1e-4);
}

TEST_CASE("where nothing bounds an error the bound is infinite, never not a number", "[accuracy]") {
    const double infinite = std::numeric_limits<double>::infinity();
    const Bounded<double> open = Bounded<double>(1) / Bounded<double>(0.0, 1.0), wide(1.0, infinite);
    for (const Bounded<double>& b :
         {Bounded<double>(Bounded<double>(0) * wide), Bounded<double>(wide - wide), Bounded<double>(wide * Bounded<double>(0)),
          Bounded<double>(wide / wide), Bounded<double>(open * Bounded<double>(0)), sqrt(Bounded<double>(-1.0)),
          exp(Bounded<double>(-1e4, infinite)), Bounded<double>(Bounded<double>(0) / 0)})
        CHECK(b.e == infinite);
    CHECK(sqrt(Bounded<double>(-1e-20, 1e-16)).e > 0.99e-8); // negative by its error
    CHECK(sqrt(Bounded<double>(-1e-20, 1e-16)).x == 0);
}

TEST_CASE("the functions of a mode on bounded numbers hold their bounds", "[eq:23][eq:28][eq:29][accuracy]") {
    Source source;
    for (int n = 0; n < 300; ++n) {
        const Pair R = source.number(0.05, 6), zeta = source.number(0.001, 0.9);
        const evaluation::ModeFunctions<Bounded<double>> f = evaluation::mode_functions(R.bounded, zeta.bounded);
        const evaluation::ModeFunctions<Real50> exact = evaluation::mode_functions(R.exact, zeta.exact);
        INFO("R = " << R.bounded.x << ", zeta = " << zeta.bounded.x);
        REQUIRE(holds(f.v.re, exact.v.re));
        REQUIRE(holds(f.v.im, exact.v.im));
        REQUIRE(holds(f.u, exact.u));
        REQUIRE(holds(f.g, exact.g));
    }
}

// Bounds of the modes and of their functions against 50 and 100 digits, light and heavy masses among them.

namespace {

/// The largest error over its bound.
struct Used {
    double most = 0;

    void note(const Bounded<double>& a, const Real100& truth) {
        const double error = std::abs(static_cast<double>(Real100(truth - Real100(a.x))));
        if (error > 0) most = std::max(most, error / a.e);
    }
};

double power_of_ten(std::mt19937_64& random, double least, double most) {
    return std::pow(10.0, std::uniform_real_distribution<double>(least, most)(random));
}

/// A random symmetric matrix with positive eigenvalues, its condition number at most ten to the decades.
Matrix<double> random_definite(std::mt19937_64& random, Eigen::Index N, double decades) {
    std::normal_distribution<double> normal;
    Matrix<double> a(N, N);
    for (Eigen::Index i = 0; i < N; ++i)
        for (Eigen::Index k = 0; k < N; ++k) a(i, k) = normal(random) * (i == 0 ? std::pow(10.0, -decades / 2) : 1);
    const Matrix<double> square = a * a.transpose(), unit = Matrix<double>::Identity(N, N);
    return square / square(N - 1, N - 1) + unit * std::pow(10.0, -decades);
}

Matrix<double> symmetric(const Matrix<double>& a) { return (a + a.transpose()) / 2; }

/// A system of N masses: a chain, one with a full stiffness matrix, one with a full mass matrix too.
Scene<double> random_scene(std::mt19937_64& random, int kind, std::size_t N) {
    Scene<double> scene;
    System<double>& s = scene.system;
    const auto n = static_cast<Eigen::Index>(N);
    for (std::size_t i = 0; i < N; ++i) {
        if (kind < 2) s.mass_ratios.push_back(i == 0 ? 1 : power_of_ten(random, -12, 3));
        if (kind == 0) s.stiffness_ratios.push_back(i == 0 ? 1 : power_of_ten(random, -3, 3));
        s.damping_ratios.push_back(power_of_ten(random, -3, -1));
    }
    if (kind > 0) s.stiffness_matrix = symmetric(random_definite(random, n, 2));
    if (kind > 1) s.mass_matrix = symmetric(random_definite(random, n, 6));
    return scene;
}

/// The largest part of the bounds that errors of a basis use.
double used_by_basis(const Scene<double>& scene) {
    const ModalBasis<Bounded<double>> basis = with_errors(scene.system, modal_basis(scene.system));
    const ModalBasis<Real100> truth = modal_basis(converted<Real100>(scene).system);
    Used used;
    for (Eigen::Index i = 0; i < basis.phi.cols(); ++i) {
        used.note(basis.r_n[static_cast<std::size_t>(i)], truth.r_n[static_cast<std::size_t>(i)]);
        Eigen::Index largest = 0;
        truth.phi.col(i).cwiseAbs().maxCoeff(&largest);
        const bool opposite = (truth.phi(largest, i) > 0) != (basis.phi(largest, i).x > 0);
        for (Eigen::Index k = 0; k < basis.phi.rows(); ++k)
            used.note(basis.phi(k, i), opposite ? Real100(-truth.phi(k, i)) : truth.phi(k, i));
    }
    return used.most;
}

} // namespace

TEST_CASE("bounds of natural frequencies and mode shapes hold, with light masses and full matrices too",
          "[eq:14][eq:15][error_bound]") {
    std::mt19937_64 random(7);
    double most = 0;
    for (const int kind : {0, 1, 2})
        for (int n = 0; n < 60; ++n) {
            const double used = used_by_basis(random_scene(random, kind, 2 + static_cast<std::size_t>(n) % 4));
            INFO("kind " << kind << ", system " << n);
            CHECK(used <= 1);
            most = std::max(most, used);
        }
    CHECK(most > 1e-3); // a thousandth of the bounds is refuted
}

TEST_CASE("bounds of the functions of a mode hold for all numbers within those of R and zeta",
          "[eq:23][eq:28][eq:29][error_bound]") {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> part(-1, 1);
    Used used;
    for (int n = 0; n < 4000; ++n) {
        const double R =
            n % 2 == 0 ? power_of_ten(random, -2, 2) : (1 + part(random) * power_of_ten(random, -12, -1)) / (1 + n % 7);
        const double zeta = power_of_ten(random, -12, 0.3), off = power_of_ten(random, -16, -5);
        const Bounded<double> R_i{R, R * off}, zeta_i{zeta, zeta * off};
        const evaluation::ModeFunctions<Bounded<double>> f = bounded_mode_functions(R_i, zeta_i);
        for (const double side : {-1.0, 0.0, part(random), 1.0}) {
            const Real100 r = Real100(R) + Real100(R_i.e) * side, z = Real100(zeta) + Real100(zeta_i.e) * part(random);
            const evaluation::ModeFunctions<Real100> truth = evaluation::mode_functions(r, z);
            Used here;
            here.note(f.v.re, truth.v.re);
            here.note(f.v.im, truth.v.im);
            here.note(f.u, truth.u);
            here.note(f.g, truth.g);
            INFO("R = " << R << ", zeta = " << zeta << ", off by " << off);
            CHECK(here.most <= 1);
            used.most = std::max(used.most, here.most);
        }
    }
    CHECK(used.most > 0.1); // a tenth of the bounds is refuted
}

TEST_CASE("permanent sticking by (88) has the digits asked for", "[program][eq:88]") {
    for (const int digits : {6, 12, 14, 15}) {
        const nlohmann::json all = answer_of("solve --ask regime --json --digits " + std::to_string(digits), "three");
        INFO(digits << " digits");
        CHECK(all["beta_lim_error_bounds"]["sticking_by_88"].get<double>() <=
              std::pow(10, -digits) * all["beta_lim"]["sticking_by_88"].get<double>());
    }
}
