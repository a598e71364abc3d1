#include "denhartog/evaluation/mode_arrays.hpp"

#include <cstring>
#include <random>

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;
using evaluation::ModeFunctions;
using evaluation::Vectors;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Results of a mode over an array.
struct Functions {
    std::vector<double> v_re, v_im, u, g;
    std::vector<std::uint8_t> at_pole;
    std::size_t scalar;

    Functions(const std::vector<double>& R, double zeta, Vectors vectors)
        : v_re(R.size()), v_im(R.size()), u(R.size()), g(R.size()), at_pole(R.size(), 0),
          scalar(evaluation::mode_functions(R, zeta, {v_re, v_im, u, g, at_pole}, vectors)) {}
};

const std::vector<double>& damping_ratios() {
    static const std::vector<double> all{0,    0x1p-1074, 1e-300, 1e-13, 1e-9,    1e-6,        1e-3,       0.0625,
                                         0.25, 0.5,       0.51,   0.75,  0.96875, 1 - 0x1p-20, 1 - 0x1p-53};
    return all;
}

/// Seeded over 2^-45 to 2^45, most of them near 1, with the edges: poles and their neighbours, R = 2, ends of the vectors' range.
std::vector<double> frequency_ratios(std::size_t n, std::uint64_t seed) {
    std::vector<double> R{1e-300, 1e-20, 0x1p-27, 0x1p-26, 4e-4, 0x1p-10, 0.5, 0.25, 1.25, std::nextafter(1.25, 0),
                          1e5,    1e20,  1e70};
    for (int k = 1; k < 60; k += 2)
        for (const double pole : {1.0 / k, std::nextafter(1.0 / k, 0), std::nextafter(1.0 / k, 2)}) R.push_back(pole);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    while (R.size() < n) R.push_back(std::exp2(R.size() % 4 == 0 ? 90 * unit(random) - 45 : 8 * unit(random) - 5));
    return R;
}

/// Error in units of eps of the value and of what a relative change of R by eps, or of zeta, does to it; where the value is below
/// the normal numbers, in units of their spacing over R, by which (28) magnifies what is left of its exponential.
double error_in_eps(double found, const Real100& exact, const Real100& by_R, const Real100& by_zeta, double R) {
    using boost::multiprecision::abs;
    const Real100 scale = abs(exact) + abs(by_R) + abs(by_zeta) + std::numeric_limits<double>::min() * (1 + 1 / R);
    return static_cast<double>(abs(Real100(found) - exact) / scale) / eps;
}

/// Changes by a relative change of an argument by one, from differences over 1e-30 of it.
ModeFunctions<Real100> rates(const Real100& R, const Real100& zeta, bool of_R) {
    const Real100 h("1e-30");
    const ModeFunctions<Real100> a = evaluation::mode_functions(R, zeta);
    const ModeFunctions<Real100> b =
        of_R ? evaluation::mode_functions(Real100(R * (1 + h)), zeta) : evaluation::mode_functions(R, Real100(zeta * (1 - h)));
    return {{(b.v.re - a.v.re) / h, (b.v.im - a.v.im) / h}, (b.u - a.u) / h, (b.g - a.g) / h};
}

} // namespace

TEST_CASE("over arrays a mode has the digits of the scalar forms, against 100 digits", "[eq:23][eq:28][eq:29][accuracy]") {
    double worst_array = 0, worst_scalar = 0;
    std::string where;
    std::size_t compared = 0;
    for (std::size_t n = 0; n < damping_ratios().size(); ++n) {
        const double zeta = damping_ratios()[n];
        const std::vector<double> R = frequency_ratios(900, 40 + n);
        const Functions f(R, zeta, evaluation::supported_vectors().back());
        for (std::size_t i = 0; i < R.size(); ++i) {
            // Outside the vectors' range the scalar forms answer; at zeta below eps a change of R by eps is as wide as a peak.
            const bool in_range = R[i] >= evaluation::least_vector_ratio() && R[i] <= evaluation::largest_vector_ratio();
            if (f.at_pole[i] != 0 || !in_range || (zeta > 0 && zeta < 1e-14)) continue;
            const ModeFunctions<double> scalar = evaluation::mode_functions(R[i], zeta);
            const ModeFunctions<Real100> exact = evaluation::mode_functions(Real100(R[i]), Real100(zeta));
            const ModeFunctions<Real100> by_R = rates(Real100(R[i]), Real100(zeta), true);
            const ModeFunctions<Real100> by_zeta = rates(Real100(R[i]), Real100(zeta), false);
            const auto compare = [&](double array, double one, const Real100& x, const Real100& d, const Real100& e) {
                const double error = error_in_eps(array, x, d, e, R[i]);
                if (!(error <= worst_array)) {
                    worst_array = error;
                    where = "R = " + tests::hexadecimal(R[i]) + ", zeta = " + tests::hexadecimal(zeta);
                }
                worst_scalar = std::max(worst_scalar, error_in_eps(one, x, d, e, R[i]));
                ++compared;
            };
            compare(f.v_re[i], scalar.v.re, exact.v.re, by_R.v.re, by_zeta.v.re);
            compare(f.v_im[i], scalar.v.im, exact.v.im, by_R.v.im, by_zeta.v.im);
            compare(f.u[i], scalar.u, exact.u, by_R.u, by_zeta.u);
            compare(f.g[i], scalar.g, exact.g, by_R.g, by_zeta.g);
        }
    }
    INFO("worst over arrays " << worst_array << " eps at " << where << "; worst of the scalar forms " << worst_scalar << " eps");
    CHECK(compared > 4 * 10000);
    CHECK(worst_array <= 3);
}

TEST_CASE("vectors of any width give the same digits", "[eq:23][eq:28][eq:29]") {
    const std::vector<double> R = frequency_ratios(1000, 7);
    for (const double zeta : damping_ratios()) {
        const Functions narrow(R, zeta, Vectors::baseline);
        for (const Vectors vectors : evaluation::supported_vectors()) {
            INFO("zeta = " << tests::hexadecimal(zeta) << ", " << evaluation::name(vectors));
            const Functions wide(R, zeta, vectors);
            CHECK(wide.v_re == narrow.v_re);
            CHECK(wide.v_im == narrow.v_im);
            CHECK(wide.u == narrow.u);
            CHECK(wide.g == narrow.g);
            CHECK(wide.at_pole == narrow.at_pole);
        }
    }
}

TEST_CASE("over arrays only poles are marked, and nothing that is no number comes out", "[eq:23][eq:28][domain]") {
    const std::vector<double> R = frequency_ratios(1000, 9);
    for (const double zeta : damping_ratios()) {
        const Functions f(R, zeta, evaluation::supported_vectors().back());
        for (std::size_t i = 0; i < R.size(); ++i) {
            INFO("R = " << tests::hexadecimal(R[i]) << ", zeta = " << tests::hexadecimal(zeta));
            const ModeFunctions<double> one = evaluation::mode_functions(R[i], zeta);
            const bool finite =
                std::isfinite(one.v.re) && std::isfinite(one.v.im) && std::isfinite(one.u) && std::isfinite(one.g);
            CHECK((f.at_pole[i] != 0) <= !finite);
            CHECK(std::isfinite(f.v_re[i] + f.v_im[i] + f.u[i] + f.g[i]));
        }
    }
    const Functions undamped({1, 0.2, 0.5}, 0, evaluation::supported_vectors().back());
    CHECK(undamped.at_pole == std::vector<std::uint8_t>{1, 1, 0});
    CHECK(undamped.u[0] == 0);
}

TEST_CASE("frequency ratios beyond the vectors' range are left to the scalar forms, and counted", "[counter]") {
    const std::vector<double> R{0x1p-27, 0x1p-26, 1, 0x1p200, 0x1p201};
    const long before = evaluation::array_mode_evaluations(), left = evaluation::array_modes_left_to_scalar_forms();
    const Functions f(R, 0.125, evaluation::supported_vectors().back());
    CHECK(f.scalar == 2);
    CHECK(evaluation::array_modes_left_to_scalar_forms() - left == 2);
    CHECK(evaluation::array_mode_evaluations() - before == 5);
    CHECK(Functions(R, 0x1p-501, evaluation::supported_vectors().back()).scalar == 5);
    CHECK(Functions(R, 0x1p-500, evaluation::supported_vectors().back()).scalar == 2);
    CHECK(f.g[4] == evaluation::mode_functions(0x1p201, 0.125).g);
}

TEST_CASE("modes with zeta of 1 and more are left to the scalar forms", "[eq:23][eq:28][eq:29][overdamped]") {
    const std::vector<double> R{0.125, 1, 3};
    for (const double zeta : {1.0, 1.5, 40.0}) {
        const Functions f(R, zeta, evaluation::supported_vectors().back());
        CHECK(f.scalar == 3);
        for (std::size_t i = 0; i < R.size(); ++i) {
            const ModeFunctions<double> one = evaluation::mode_functions(R[i], zeta);
            CHECK(f.v_re[i] == one.v.re);
            CHECK(f.u[i] == one.u);
            CHECK(f.g[i] == one.g);
        }
    }
}

TEST_CASE("arguments of arrays of modes are checked", "[domain]") {
    std::vector<double> a(2);
    std::vector<std::uint8_t> marks(2);
    const auto run = [&](const std::vector<double>& R, double zeta) { evaluation::mode_functions(R, zeta, {a, a, a, a, marks}); };
    CHECK_THROWS_WITH(run({1, 2}, -0.5), "zeta must be finite and at least 0, but is -0.5");
    CHECK_THROWS_WITH(run({1, 2, 3}, 0.5), "an array of results must have the length of R, 3, but is 2");
    for (const double R : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        CHECK_THROWS_AS(run({1, R}, 0.5), InputError);
}
