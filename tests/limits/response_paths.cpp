// Limits of the response: what (38) tends to, and the digits that plain sums over modes, the library's sums and `answer` keep on
// the way; the ways are those of the chart.
#include <array>
#include <utility>

#include "paper-figures/common/response_paths.hpp"
#include "tests/catch.hpp"

using namespace denhartog;
using namespace denhartog::figures;

namespace {

double relative(const Real100& a, const Real100& b) { return std::abs(static_cast<double>(Real100(a / b - 1))); }

/// Digits of the sums at one point of a path.
struct Sums {
    double printed, shipped, library;
};

// The sums over modes are built for double and, for the tests, for 50 and 100 digits. The forms of a mode work in long double
// too.
template <class T>
Sums digits_in(const Scene<double>& scene, const ModesAtContact<Real100>& modes, const Real100& X) {
    const ModesAtContact<T> m = rounded<T>(modes);
    const double shipped = digits_kept(amplitude_of_contact(m, Forms::shipped), X);
    double library = shipped;
    if constexpr (!std::same_as<T, long double>) library = digits_kept(amplitude_by_library(converted<T>(scene)), X);
    return {digits_kept(amplitude_of_contact(m, Forms::printed), X), shipped, library};
}

/// A point of a path: its scene, its modes, its amplitude, and the digits of the sums in the number types of the chart.
struct Point {
    Scene<double> scene;
    ModesAtContact<Real100> modes;
    Real100 X;
    Sums in_double, in_long_double, in_50;
    Point(const ResponsePath& path, int k)
        : scene(path.scene(k)), modes(path.modes(scene)), X(amplitude_of_contact(modes, Forms::printed)),
          in_double(digits_in<double>(scene, modes, X)), in_long_double(digits_in<long double>(scene, modes, X)),
          in_50(digits_in<Real50>(scene, modes, X)) {
        CHECK(digits_kept(answered_amplitude(scene), X) > 12);
    }
    /// The digits in each type, with the most that it has.
    [[nodiscard]] std::array<std::pair<Sums, double>, 3> in_types() const {
        return {{{in_double, 16.0}, {in_long_double, 19.3}, {in_50, 50.6}}};
    }
};

/// Digits that a part of k binary places takes.
double lost_of(double places) { return places * std::log10(2.0); }

} // namespace

TEST_CASE("on its way to each limit of two masses (38) tends to it, and to no other", "[eq:33][eq:38][limit]") {
    std::vector<ResponsePath> paths = paths_of_two_masses();
    paths.push_back(path_to_resonance_at_boundary());
    for (const ResponsePath& path : paths)
        for (const int k : {17, 23, 29}) {
            const Scene<double> scene = path.scene(k);
            const Real100 X = amplitude_of_contact(path.modes(scene), Forms::printed), limit = path.limit(scene);
            INFO(path.words << ", x = 2^-" << k);
            CHECK(relative(X, limit) < std::ldexp(10, -k));
            CHECK(relative(X, Real100(limit * Real100(1.001))) > 5e-4); // another limit is refuted
        }
}

TEST_CASE("modes of two masses by the quadratic equation and of chains in closed form are those of the library",
          "[eq:15][limit]") {
    for (const ResponsePath& path : paths_of_two_masses())
        for (const int k : {2, 10, 26, 58}) {
            const Scene<double> scene = path.scene(k);
            const Real100 X = amplitude_of_contact(path.modes(scene), Forms::shipped);
            INFO(path.words << ", x = 2^-" << k);
            CHECK(relative(amplitude_by_library(converted<Real100>(scene)), X) < 1e-85);
        }
    for (const int N : {1, 2, 7})
        for (const std::size_t j : {0, 1}) {
            const Scene<double> scene = chain_of(N, j, 0.75, 0);
            const Real100 X = amplitude_of_contact(response_paths::modes_of_chain(scene), Forms::shipped);
            INFO("N = " << N);
            CHECK(relative(amplitude_by_library(converted<Real100>(scene)), X) < 1e-90);
        }
}

TEST_CASE(
    "where two natural frequencies merge plain sums lose half the digits of the mass ratio in every type, printed or shipped",
    "[eq:33][eq:38][limit][form]") {
    const ResponsePath path = paths_of_two_masses()[0];
    for (const int k : {30, 51, 72, 100}) {
        const Point d(path, k);
        const double lost = lost_of(k / 2.0);
        INFO("x = 2^-" << k << ", " << lost << " digits are to be lost");
        for (const auto& [digits, most] : d.in_types())
            for (const double each : {digits.printed, digits.shipped, digits.library}) {
                CHECK(each < std::max(0.5, most - lost + 3));
                CHECK(each > most - lost - 3);
            }
    }
}

TEST_CASE("a heavy mass costs plain sums no digits", "[eq:33][eq:38][limit][form]") {
    const ResponsePath path = paths_of_two_masses()[1];
    for (const int k : {2, 26, 27, 51, 100}) { // 2^26 and 2^27 are next to 1e8
        const Point d(path, k);
        INFO("gamma_2 = 2^" << k);
        for (const auto& [digits, most] : d.in_types())
            for (const double each : {digits.printed, digits.shipped, digits.library}) CHECK(each > most - 1.6);
    }
}

TEST_CASE("a light mass makes the printed forms overflow, and the eigen-solve lose up to half the digits of the mass ratio",
          "[eq:28][eq:29][eq:38][limit][form]") {
    const ResponsePath path = paths_of_two_masses()[2];
    for (const int k : {10, 26, 27, 38, 58}) {
        const Point d(path, k);
        const double lost = lost_of(k / 2.0);
        INFO("gamma_2 = 2^-" << k);
        CHECK((d.in_double.printed == 0) == (k >= 26)); // cosh(pi zeta / R) beyond 1e308
        CHECK((d.in_long_double.printed == 0) == (k >= 34));
        CHECK(d.in_50.printed > 49);
        CHECK((digits_kept(amplitude_of_contact(rounded<float>(d.modes), Forms::printed), d.X) == 0) == (k >= 20));
        CHECK(digits_kept(amplitude_of_contact(rounded<float>(d.modes), Forms::shipped), d.X) > 6);
        for (const auto& [digits, most] : d.in_types()) {
            CHECK(digits.shipped > most - 1.6); // with modes without error
            CHECK(digits.library > most - lost - 2);
        }
    }
}

TEST_CASE(
    "at resonance next to the boundary the printed forms lose three times the digits of the damping ratio, the shipped ones once",
    "[eq:28][eq:29][eq:38][limit][form]") {
    const ResponsePath path = path_to_resonance_at_boundary();
    for (const int k : {8, 17, 26}) {
        const Point d(path, k);
        const double lost = lost_of(k);
        INFO("zeta = 2^-" << k);
        for (const auto& [digits, most] : d.in_types()) {
            CHECK(digits.printed < std::max(0.5, most - 3 * lost + 3));
            CHECK(digits.printed > most - 3 * lost - 3);
            CHECK(digits.shipped > most - lost - 2);
            CHECK(digits.library > most - lost - 2);
        }
    }
}

TEST_CASE("the amplitude has one limit and one slope on both sides of the boundary", "[eq:38][eq:67][eq:69][limit]") {
    const AtBoundary b = boundary_of_single_mass();
    CHECK(relative(b.beta_lim, b.exact) < 1e-95);
    for (const int e : {-4, -9, -14, -19})
        for (const int side : {-1, 1}) {
            const Real100 x = pow(Real100(10), e);
            const SolvedAmplitude s = solved_next_to(b, x, side, std::min(40, 8 - 2 * e));
            const Real100 rise = -side * (s.X - b.X) / x;
            INFO((side < 0 ? "below" : "above") << " by 1e" << e);
            CHECK(s.regime == (side < 0 ? Regime::continuous : Regime::stick_slip));
            CHECK(relative(rise, b.slope) < 10 * static_cast<double>(x));
            CHECK(relative(rise, Real100(b.slope * Real100(1.01))) > 5e-3); // another slope is refuted
        }
}

TEST_CASE("plain sums of 200 masses lose digits with the load at the other end above all natural frequencies, not with it on the "
          "contact",
          "[eq:33][limit][form]") {
    const Scene<double> far = chain_of(200, 0, 3, 0), near = chain_of(200, 1, 0.75, 0.125);
    const ModesAtContact<Real100> far_modes = response_paths::modes_of_chain(far),
                                  near_modes = response_paths::modes_of_chain(near);
    const Real100 far_X = amplitude_of_contact(far_modes, Forms::printed),
                  near_X = amplitude_of_contact(near_modes, Forms::printed);
    const Sums far_digits = digits_in<double>(far, far_modes, far_X), near_digits = digits_in<double>(near, near_modes, near_X);
    for (const double each : {far_digits.printed, far_digits.shipped, far_digits.library}) {
        CHECK(each > 8);
        CHECK(each < 12);
    }
    for (const double each : {near_digits.printed, near_digits.shipped, near_digits.library}) CHECK(each > 14);
    const Scene<double> half = chain_of(100, 0, 3, 0);
    const Real100 half_X = amplitude_of_contact(response_paths::modes_of_chain(half), Forms::printed);
    CHECK(static_cast<double>(log2(Real100(half_X / far_X))) == Approx(3).epsilon(0.01)); // falls like N^-3
}
