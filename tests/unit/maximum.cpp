#include "denhartog/sliding/maximum.hpp"

#include <cmath>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"
#include "tests/catch.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

/// f with w = f', z = f'' and a bound of |f'''|.
template <class T>
Curve<T> smooth(std::function<T(const T&)> f, std::function<T(const T&)> w, std::function<T(const T&)> z, T rate) {
    return {[=](const T& tau) {
                return Sample<T>{f(tau), w(tau), z(tau)};
            },
            [=](const T&, const T&) { return rate; },
            [](const T& a, const T& b, const T& z_bound) { return T(z_bound * (b - a) * (b - a) / 8); }};
}

} // namespace

TEMPLATE_TEST_CASE("the maximum of a cosine lies where it is known to, to all digits", "[maximum]", double, long double, Real50,
                   Real100) {
    using T = TestType;
    const T shift = T(5) / 7;
    const Curve<T> curve =
        smooth<T>([=](const T& t) { return T(cos(T(t - shift))); }, [=](const T& t) { return T(-sin(T(t - shift))); },
                  [=](const T& t) { return T(-cos(T(t - shift))); }, T(1));
    const Maximum<T> best = global_maximum(curve, T(0), pi<T>());
    const T eps = std::numeric_limits<T>::epsilon();
    CHECK(abs(T(best.value - 1)) <= 2 * eps);
    CHECK(abs(T(best.instant - shift)) <= 4 * eps);
}

TEST_CASE("a maximum at an end of the interval is found", "[maximum]") {
    const Curve<double> rising = smooth<double>([](double t) { return std::exp(t); }, [](double t) { return std::exp(t); },
                                                [](double t) { return std::exp(t); }, std::exp(2.0));
    CHECK(global_maximum(rising, 0.0, 2.0).instant == 2.0);
    CHECK(global_maximum(rising, 0.0, 2.0).value == std::exp(2.0));
    const Curve<double> falling = smooth<double>([](double t) { return std::exp(-t); }, [](double t) { return -std::exp(-t); },
                                                 [](double t) { return std::exp(-t); }, 1.0);
    CHECK(global_maximum(falling, 0.0, 2.0).instant == 0.0);
}

TEST_CASE("a peak that is narrow between samples does not hide", "[maximum]") {
    // cos t + a exp(-((t - c) / b)^2) with c off every dyadic grid; the peak is 1/4000 of the interval wide.
    const double a = 0.5, b = 1e-3, c = 2.0 / 3;
    const auto bump = [=](double t) { return a * std::exp(-(t - c) / b * ((t - c) / b)); };
    const auto x = [=](double t) { return (t - c) / b; };
    const Curve<double> curve = smooth<double>(
        [=](double t) { return std::cos(t) + bump(t); }, [=](double t) { return -std::sin(t) - 2 * x(t) / b * bump(t); },
        [=](double t) { return -std::cos(t) + (4 * x(t) * x(t) - 2) / (b * b) * bump(t); }, 1 + 4 * a / (b * b * b));
    double sampled = 0, instant = 0;
    for (int n = -20000; n <= 20000; ++n) {
        const double t = c + n * 1e-7;
        if (std::cos(t) + bump(t) > sampled) sampled = std::cos(t) + bump(t), instant = t;
    }
    const Maximum<double> best = global_maximum(curve, 0.0, 3.0);
    INFO("value " << hexadecimal(best.value) << " at " << hexadecimal(best.instant));
    CHECK(best.value >= sampled);
    CHECK(best.value - sampled < 1e-8);
    CHECK(std::abs(best.instant - instant) < 1e-7);
}

TEST_CASE("among many equal-looking peaks the highest is taken", "[maximum]") {
    // Peaks of cos(200 t) under a parabola that is highest at 1.1.
    const auto top = [](double t) { return 1 - 1e-5 * (t - 1.1) * (t - 1.1); };
    const Curve<double> curve = smooth<double>([=](double t) { return top(t) + std::cos(200 * t); },
                                               [](double t) { return -2e-5 * (t - 1.1) - 200 * std::sin(200 * t); },
                                               [](double t) { return -2e-5 - 40000 * std::cos(200 * t); }, 8e6);
    const Maximum<double> best = global_maximum(curve, 0.0, 3.0);
    const double peak = 35 * 2 * pi<double>() / 200; // the peak nearest to 1.1
    CHECK(std::abs(best.instant - peak) < 1e-6);
    CHECK(std::abs(best.value - (top(peak) + 1)) < 1e-14);
}

TEST_CASE("a search that does not settle ends in an error, not in an answer", "[maximum]") {
    const Curve<double> flat =
        smooth<double>([](double) { return 1.0; }, [](double) { return 0.0; }, [](double) { return 0.0; }, 1e30);
    CHECK_THROWS_AS(global_maximum(flat, 0.0, 1.0), PrecisionError);
}

TEMPLATE_TEST_CASE("a bracketed root has all digits", "[maximum]", double, long double, Real50, Real100) {
    using T = TestType;
    const std::function<T(const T&)> f = [](const T& x) { return T(x * x - 2); };
    const T root = bracketed_root<T>(f, T(1), T(2), f(T(1)), f(T(2)));
    CHECK(abs(T(root - sqrt(T(2)))) <= 4 * std::numeric_limits<T>::epsilon());
}
