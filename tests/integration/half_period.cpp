// The second witness by itself: that an integration which knows neither exponentials nor matrices lands where it does, and what it
// refuses. That it agrees with the closed form to 45 digits, with which it shares nothing, is for the suites accuracy and properties.
#include "tests/support/half_period.hpp"

#include <cmath>

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

template <class T>
HalfPeriodProblem<T> one_mass(const T& r, const T& zeta, const T& beta) {
    HalfPeriodProblem<T> p;
    p.M = Matrix<T>::Constant(1, 1, r * r);
    p.C = Matrix<T>::Constant(1, 1, 2 * zeta * r);
    p.K = Matrix<T>::Constant(1, 1, T(1));
    p.beta = beta;
    return p;
}

/// Three unequal masses with a damper between the first two: no modal damping, nothing that the closed form could do.
HalfPeriodProblem<double> three_masses(double beta) {
    HalfPeriodProblem<double> p;
    p.M = Matrix<double>::Zero(3, 3);
    p.M.diagonal() << 1.25, 2.5, 0.75;
    p.C = Matrix<double>::Zero(3, 3);
    p.C << 0.375, -0.25, 0, -0.25, 0.25, 0, 0, 0, 0.125;
    p.K = Matrix<double>::Zero(3, 3);
    p.K << 1.625, -0.625, 0, -0.625, 2.5, -1.875, 0, -1.875, 1.875;
    p.contact = Mass{1};
    p.load = Mass{0};
    p.beta = beta;
    return p;
}

/// One classical Runge-Kutta step of (6) with the sign of the velocity fixed to minus one.
Vector<double> runge_kutta_step(const HalfPeriodProblem<double>& p, const Vector<double>& z, double tau, double h, double phi) {
    const auto rate = [&](const Vector<double>& y, double t) {
        const Eigen::Index N = p.M.rows();
        Vector<double> force = -p.K * y.head(N) - p.C * y.tail(N);
        force(static_cast<Eigen::Index>(p.contact.index)) += p.beta;
        force(static_cast<Eigen::Index>(p.load.index)) += std::cos(t + phi);
        Vector<double> result(2 * N);
        result << y.tail(N), force.cwiseQuotient(p.M.diagonal());
        return result;
    };
    const Vector<double> a = rate(z, tau);
    const Vector<double> b = rate(z + h / 2 * a, tau + h / 2);
    const Vector<double> c = rate(z + h / 2 * b, tau + h / 2);
    const Vector<double> d = rate(z + h * c, tau + h);
    return z + h / 6 * (a + 2 * b + 2 * c + d);
}

} // namespace

TEST_CASE("an exponential that overflows or is asked of a matrix that is not finite is an error", "[witness]") {
    CHECK_THROWS_AS(matrix_exponential(Matrix<double>(Matrix<double>::Constant(1, 1, 1000))), DomainError);
    CHECK_THROWS_AS(matrix_exponential(Matrix<double>(Matrix<double>::Constant(1, 1, std::nan("")))), DomainError);
}

TEST_CASE("a Runge-Kutta integration from the witness's start lands on the mirrored state", "[eq:6][eq:12][witness]") {
    const HalfPeriodProblem<double> p = three_masses(0.0625);
    const HalfPeriodMotion<double> m = half_period_motion(p, 8);
    const int steps = 4096;
    const double h = pi<double>() / steps;
    Vector<double> z(6);
    z << m.x_0, m.x_prime_0;
    for (int n = 0; n < steps; ++n) {
        if (n % (steps / 8) == 0) {
            INFO("instant " << n);
            CHECK((z.head(3) - m.x.col(n / (steps / 8))).cwiseAbs().maxCoeff() < 1e-12);
            CHECK((z.tail(3) - m.x_prime.col(n / (steps / 8))).cwiseAbs().maxCoeff() < 1e-12);
        }
        z = runge_kutta_step(p, z, n * h, h, m.phi_j);
    }
    CHECK((z.head(3) + m.x_0).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((z.tail(3) + m.x_prime_0).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("friction that no phase can overcome is outside the domain", "[eq:38][witness]") {
    CHECK_THROWS_AS(half_period_motion(one_mass(0.75, 0.0625, 16.0), 16), DomainError);
}

TEST_CASE("an undamped mode that fits the half-period an odd number of times has no unique motion", "[witness]") {
    CHECK_THROWS_AS(half_period_motion(one_mass<double>(1.0, 0.0, 0.125), 16), DomainError);
    CHECK_THROWS_AS(half_period_motion(one_mass<double>(1.0 / 3, 0.0, 0.125), 16), DomainError);
    CHECK_THROWS_AS(half_period_motion(one_mass<Real50>(Real50(1) / 3, Real50(0), Real50(1) / 8), 16), DomainError);
}

TEST_CASE("a problem that breaks a rule is refused by name", "[witness][input]") {
    const HalfPeriodProblem<double> good = three_masses(0.0625);
    const auto refused = [&](auto change, int steps, const std::string& quantity) {
        HalfPeriodProblem<double> p = good;
        change(p);
        try {
            (void)half_period_motion(p, steps);
        } catch (const InputError& error) {
            return error.quantity == quantity;
        }
        return false;
    };
    CHECK(refused([](auto& p) { p.M.resize(0, 0); }, 16, "M"));
    CHECK(refused([](auto& p) { p.M = Matrix<double>::Zero(3, 3); }, 16, "M"));
    CHECK(refused([](auto& p) { p.C = Matrix<double>::Zero(2, 2); }, 16, "C"));
    CHECK(refused([](auto& p) { p.K(0, 0) = std::nan(""); }, 16, "K"));
    CHECK(refused([](auto& p) { p.contact = Mass{3}; }, 16, "contact"));
    CHECK(refused([](auto& p) { p.load = Mass{3}; }, 16, "load"));
    CHECK(refused([](auto& p) { p.beta = -1; }, 16, "beta"));
    CHECK(refused([](auto&) {}, 1, "steps"));
}
