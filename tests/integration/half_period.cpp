// The second witness by itself: its exponential, its boundary-value problem, its judgement of the regime.
#include "tests/support/half_period.hpp"

#include <Eigen/LU>
#include <cmath>

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

template <class T>
T largest_difference(const Matrix<T>& A, const Matrix<T>& B) {
    return (A - B).cwiseAbs().maxCoeff();
}

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

HalfPeriodProblem<Real50> in_50_digits(const HalfPeriodProblem<double>& p) {
    return {p.M.cast<Real50>(), p.C.cast<Real50>(), p.K.cast<Real50>(), p.contact, p.load, Real50(p.beta)};
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

TEST_CASE("the exponential of a nilpotent matrix ends after its last power", "[witness]") {
    Matrix<double> A = Matrix<double>::Zero(3, 3);
    A(0, 1) = 2;
    A(1, 2) = 3;
    Matrix<double> expected = Matrix<double>::Identity(3, 3) + A;
    expected(0, 2) = 3;
    CHECK(largest_difference(matrix_exponential(A), expected) == 0);
}

TEST_CASE("the exponential of a damped oscillator is its free motion, to all the digits of 50 and of 100", "[witness]") {
    const auto error = [](auto zero) {
        using T = decltype(zero);
        const T zeta = T(3) / 16, Omega = T(37) / 4, tau = T(5) / 2, w = sqrt(T(1 - zeta * zeta));
        Matrix<T> A(2, 2);
        A << T(0), T(1), T(-Omega * Omega), T(-2 * zeta * Omega);
        const T e = exp(T(-zeta * Omega * tau)), c = cos(T(w * Omega * tau)), s = sin(T(w * Omega * tau));
        Matrix<T> expected(2, 2);
        expected << T(e * (c + zeta / w * s)), T(e * s / (w * Omega)), T(-e * Omega / w * s), T(e * (c - zeta / w * s));
        return static_cast<double>(largest_difference(matrix_exponential(Matrix<T>(A * tau)), expected));
    };
    CHECK(error(double()) < 1e-12);
    CHECK(error(Real50()) < 1e-46);
    CHECK(error(Real100()) < 1e-96);
}

TEST_CASE("the exponential has the semigroup property", "[witness]") {
    const Matrix<Real50> A = augmented_system(in_50_digits(three_masses(0.125)));
    const Matrix<Real50> whole = matrix_exponential(A);
    const Matrix<Real50> parts =
        matrix_exponential(Matrix<Real50>(A * (Real50(3) / 8))) * matrix_exponential(Matrix<Real50>(A * (Real50(5) / 8)));
    CHECK(static_cast<double>(largest_difference(whole, parts)) < 1e-47);
    CHECK(static_cast<double>(largest_difference(Matrix<Real50>(whole * matrix_exponential(Matrix<Real50>(-A))),
                                                 Matrix<Real50>(Matrix<Real50>::Identity(9, 9)))) < 1e-46);
}

TEST_CASE("an exponential that overflows or is asked of a matrix that is not finite is an error", "[witness]") {
    CHECK_THROWS_AS(matrix_exponential(Matrix<double>(Matrix<double>::Constant(1, 1, 1000))), DomainError);
    CHECK_THROWS_AS(matrix_exponential(Matrix<double>(Matrix<double>::Constant(1, 1, std::nan("")))), DomainError);
}

TEST_CASE("the boundary-value problem meets its conditions", "[eq:12][eq:25][eq:30][witness]") {
    const HalfPeriodProblem<double> p = three_masses(0.0625);
    const HalfPeriodMotion<double> m = half_period_motion(p, 64);
    CHECK((m.x.col(64) + m.x_0).cwiseAbs().maxCoeff() < 1e-13);
    CHECK((m.x_prime.col(64) + m.x_prime_0).cwiseAbs().maxCoeff() < 1e-13);
    CHECK(m.mirror_defect < 1e-13);
    CHECK(m.x_prime_0(1) == 0);
    CHECK(m.x_0(1) > 0);
    CHECK(m.x.col(0) == m.x_0);
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

TEST_CASE("without friction one mass responds as the linear oscillator does", "[eq:23][witness][limit]") {
    const double r = 0.75, zeta = 0.125;
    const HalfPeriodMotion<double> m = half_period_motion(one_mass(r, zeta, 0.0), 16);
    const double modulus = 1 / std::hypot(1 - r * r, 2 * zeta * r);
    CHECK(m.amplitude(0) == Approx(modulus).epsilon(1e-13));
    CHECK(m.phi_j == Approx(std::atan2(2 * zeta * r, 1 - r * r)).epsilon(1e-13));
    CHECK(m.phase(0) == Approx(m.phi_j).epsilon(1e-13));
}

TEST_CASE("amplitudes do not depend on the sample, and no sample exceeds them", "[witness]") {
    const HalfPeriodProblem<Real50> p = in_50_digits(three_masses(0.0625));
    const HalfPeriodMotion<Real50> coarse = half_period_motion(p, 24), fine = half_period_motion(p, 512);
    for (Eigen::Index k = 0; k < 3; ++k) {
        INFO("mass " << k + 1 << ": " << coarse.amplitude(k) << " and " << fine.amplitude(k));
        CHECK(static_cast<double>(abs(Real50(coarse.amplitude(k) / fine.amplitude(k) - 1))) < 1e-45);
        CHECK(static_cast<double>(abs(Real50(coarse.phase(k) - fine.phase(k)))) < 1e-45);
        const Real50 largest_sample = fine.x.row(k).cwiseAbs().maxCoeff();
        CHECK(largest_sample <= fine.amplitude(k) * (1 + Real50("1e-45")));
        CHECK(largest_sample >= fine.amplitude(k) * (1 - Real50("1e-4")));
    }
}

TEST_CASE("of the two phases that bring the contact to rest the one with the larger displacement is taken", "[witness]") {
    const HalfPeriodProblem<double> p = one_mass(0.5, 0.0625, 0.125);
    const HalfPeriodMotion<double> m = half_period_motion(p, 64);
    CHECK(m.x_0(0) > 0);
    CHECK(slides(m, 1.0, p.beta));
    CHECK(m.x(0, 1) < m.x_0(0));
}

TEST_CASE("a contact that friction holds or that turns back does not slide", "[eq:54][witness]") {
    const HalfPeriodProblem<double> held = one_mass(0.5, 0.0625, 0.125);
    const HalfPeriodMotion<double> m = half_period_motion(held, 64);
    CHECK(slides(m, 1.0, held.beta));
    CHECK_FALSE(slides(m, 1.001 * m.contact_load / held.beta, held.beta));

    const HalfPeriodProblem<double> turning = one_mass(0.125, 0.0009765625, 0.0625);
    const HalfPeriodMotion<double> back = half_period_motion(turning, 256);
    CHECK(back.largest_contact_velocity > 0);
    CHECK_FALSE(slides(back, 1.0, turning.beta));
}

TEST_CASE("friction that no phase can overcome is outside the domain", "[eq:38][witness]") {
    CHECK_THROWS_AS(half_period_motion(one_mass(0.75, 0.0625, 16.0), 16), DomainError);
}

TEST_CASE("an undamped mode that fits the half-period an odd number of times has no unique motion", "[witness]") {
    CHECK_THROWS_AS(half_period_motion(one_mass<double>(1.0, 0.0, 0.125), 16), DomainError);
    CHECK_THROWS_AS(half_period_motion(one_mass<double>(1.0 / 3, 0.0, 0.125), 16), DomainError);
    CHECK_THROWS_AS(half_period_motion(one_mass<Real50>(Real50(1) / 3, Real50(0), Real50(1) / 8), 16), DomainError);
}

TEST_CASE("the load on the contact counts what coupled masses hand on", "[eq:54][witness]") {
    HalfPeriodProblem<double> p = three_masses(0.0625);
    p.M(0, 1) = p.M(1, 0) = 0.25;
    p.M(1, 2) = p.M(2, 1) = 0.125;
    const HalfPeriodMotion<double> m = half_period_motion(p, 16);
    Vector<double> force = -p.K * m.x_0 - p.C * m.x_prime_0;
    force(0) += std::cos(m.phi_j);
    Vector<double> held = force;
    held(1) += m.contact_load;
    const Vector<double> acceleration = p.M.inverse() * held;
    CHECK(std::abs(acceleration(1)) < 1e-14);
    CHECK(std::abs((p.M.inverse() * force)(1)) > 1e-3);
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
