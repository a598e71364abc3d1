// The response from rest next to resonance in double against 50 digits, and the harmonic motion far from it.
#include "denhartog/evaluation/driven_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

template <class T>
InitialValues<T> from_rest(const T& t, const T& R, const T& zeta, const T& tau_0) {
    const T w = sqrt(T((1 - zeta) * (1 + zeta)));
    const T gap = (R - 1) * (R + 1) / (R * R);
    const evaluation::FreeMotion<T> free = evaluation::free_motion(t, R, zeta, evaluation::w_if_oscillating(zeta));
    return evaluation::response_from_rest(t, T(zeta / R), T(w / R), evaluation::detuning(R, zeta, gap),
                                          Complex<T>{free.d - zeta * free.q, w * free.q}, T(cos(tau_0)), T(sin(tau_0)));
}

} // namespace

TEST_CASE("the response from rest keeps its digits next to resonance, down to the resonance itself", "[eq:A.6][eq:A.7]") {
    double worst = 0;
    for (const double apart : {0.0, 1e-300, 1e-15, 1e-12, -1e-9, 1e-6, -1e-3, 0.03})
        for (const double zeta : {0.0, 1e-300, 1e-15, 1e-9, 1e-4, 0.05})
            for (const double t : {1e-12, 1e-3, 0.5, 3.0, 6.25, 31.25}) {
                const double R = 1 + apart, tau_0 = 0.625;
                const InitialValues<double> h = from_rest(t, R, zeta, tau_0);
                const InitialValues<Real50> exact = from_rest(Real50(t), Real50(R), Real50(zeta), Real50(tau_0));
                const double unit = std::numeric_limits<double>::epsilon() * (1 + t); // the response grows to t / 2
                const double error = std::max(std::abs(static_cast<double>(Real50(h.eta_0 - exact.eta_0))),
                                              std::abs(static_cast<double>(Real50(h.eta_prime_0 - exact.eta_prime_0)))) /
                                     unit;
                INFO("R - 1 = " << apart << ", zeta = " << zeta << ", t = " << t << ": " << error << " units");
                CHECK(error <= 8);
                worst = std::max(worst, error);
            }
    std::printf("response from rest: worst error %.2f units in the last place of 1 + t\n", worst);
}

TEST_CASE("the response from rest is the harmonic and the free motion where these do not cancel", "[eq:A.6][eq:A.7]") {
    for (const double R : {0.25, 0.8, 1.25, 4.0})
        for (const double zeta : {0.0, 0.03125, 0.5}) {
            const Real50 t(2), r(R), z(zeta), tau_0(0.625);
            const Real50 gap = (r - 1) * (r + 1) / (r * r);
            const Complex<Real50> X = evaluation::response_by_R_squared(gap, Real50(z / r));
            const InitialValues<Real50> start = evaluation::free_start(InitialValues<Real50>{Real50(0), Real50(0)}, Real50(0), X,
                                                                       Real50(cos(tau_0)), Real50(sin(tau_0)));
            const InitialValues<Real50> sum =
                evaluation::driven_motion(evaluation::free_motion(t, r, z, evaluation::w_if_oscillating(z)), r, start, Real50(0),
                                          X, Real50(cos(Real50(tau_0 + t))), Real50(sin(Real50(tau_0 + t))));
            const InitialValues<Real50> h = from_rest(t, r, z, tau_0);
            CHECK(abs(Real50(h.eta_0 - sum.eta_0)) < Real50("1e-46"));
            CHECK(abs(Real50(h.eta_prime_0 - sum.eta_prime_0)) < Real50("1e-46"));
        }
}
