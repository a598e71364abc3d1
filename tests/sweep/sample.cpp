// Samples by their index, and the distributions that they are drawn from.
#include "denhartog/sweep/sample.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <set>

#include "tests/catch.hpp"

using namespace denhartog::sweep;

namespace {

std::size_t parts_met(const UnitSamples& samples, std::size_t quantity, std::uint64_t first, std::uint64_t count) {
    std::set<std::uint64_t> parts;
    for (std::uint64_t n = first; n < first + count; ++n)
        parts.insert(static_cast<std::uint64_t>(samples.at(n, quantity) * static_cast<double>(count)));
    return parts.size();
}

// The share of samples in [0, a) x [0, b) next to the area.
double discrepancy(const UnitSamples& samples, std::uint64_t count, double a, double b) {
    std::size_t within = 0;
    for (std::uint64_t n = 0; n < count; ++n) within += samples.at(n, 0) < a && samples.at(n, 1) < b;
    return std::abs(static_cast<double>(within) / static_cast<double>(count) - a * b);
}

} // namespace

TEST_CASE("every block of Sobol's samples has one in each part of every quantity, whatever the seed", "[sweep]") {
    for (const std::uint64_t seed : {0, 1, 12345}) {
        const UnitSamples samples(Sampling::sobol, 1 << 12, seed, 25);
        for (std::size_t quantity = 0; quantity < 25; ++quantity) {
            CHECK(parts_met(samples, quantity, 0, 1024) == 1024);
            CHECK(parts_met(samples, quantity, 1536, 256) == 256);
        }
    }
}

TEST_CASE("Sobol's samples fill a square more evenly than chance would", "[sweep]") {
    const UnitSamples samples(Sampling::sobol, 1 << 12, 3, 2);
    for (const double a : {0.21, 0.5, 0.83})
        for (const double b : {0.37, 0.66}) CHECK(discrepancy(samples, 1 << 12, a, b) < 0.002); // chance has 0.008
}

TEST_CASE("a Latin hypercube has one sample in each part of every quantity", "[sweep]") {
    for (const std::uint64_t count : {1, 2, 7, 1000, 4096, 5001}) {
        const UnitSamples samples(Sampling::latin_hypercube, count, 9, 3);
        for (std::size_t quantity = 0; quantity < 3; ++quantity) CHECK(parts_met(samples, quantity, 0, count) == count);
    }
    const UnitSamples samples(Sampling::latin_hypercube, 5000, 9, 2);
    CHECK(discrepancy(samples, 5000, 0.5, 0.5) < 0.02);
}

TEST_CASE("another seed gives other samples, and a sample does not depend on those asked for before", "[sweep]") {
    for (const Sampling sampling : {Sampling::sobol, Sampling::latin_hypercube}) {
        const UnitSamples a(sampling, 100, 1, 2), b(sampling, 100, 2, 2);
        int same = 0;
        for (std::uint64_t n = 0; n < 100; ++n) same += a.at(n, 0) == b.at(n, 0);
        CHECK(same < 5);
        CHECK(a.at(57, 1) == UnitSamples(sampling, 100, 1, 2).at(57, 1));
        CHECK(a.at(57, 1) != a.at(57, 0));
    }
}

TEST_CASE("the normal quantile is the inverse of the distribution, and Boost's to its digits", "[sweep]") {
    const boost::math::normal normal;
    for (const double u : {1e-15, 1e-6, 0.02, 0.3, 0.5, 0.77, 0.999, 1 - 1e-10}) {
        const double x = normal_quantile(u);
        CHECK(x == Approx(boost::math::quantile(normal, u)).epsilon(1e-13).margin(1e-15));
        CHECK(normal_probability(x) == Approx(u).epsilon(1e-14));
    }
    CHECK(normal_quantile(0.25) == -normal_quantile(0.75));
    CHECK(normal_quantile(0.5) == 0);
    CHECK(normal_quantile(0.5 + 0x1p-40) == Approx(0x1p-40 * 2.5066282746310002).epsilon(1e-15)); // sqrt(2 pi)
}

TEST_CASE("samples have the mean and the deviation that their distribution says, and stay within its bounds", "[sweep]") {
    constexpr std::uint64_t count = 1 << 14;
    const UnitSamples samples(Sampling::sobol, count, 4, 1);
    const auto moments = [&](const Marginal& m) {
        double sum = 0, squares = 0, least = 1e300, most = -1e300;
        for (std::uint64_t n = 0; n < count; ++n) {
            const double x = quantile(m, samples.at(n, 0));
            sum += x;
            squares += x * x;
            least = std::min(least, x);
            most = std::max(most, x);
        }
        const double mean = sum / count;
        return std::array{mean, std::sqrt(squares / count - mean * mean), least, most};
    };
    const auto uniform = moments({Distribution::uniform, 2, 5, {}, {}});
    CHECK(uniform[0] == Approx(3.5).epsilon(1e-5));
    CHECK(uniform[1] == Approx(3 / std::sqrt(12.0)).epsilon(1e-3));
    const auto normal = moments({Distribution::normal, -1, 0.5, {}, {}});
    CHECK(normal[0] == Approx(-1).epsilon(1e-4));
    CHECK(normal[1] == Approx(0.5).epsilon(1e-3));
    const auto lognormal = moments(lognormal_of_mean(0.02, 0.008));
    CHECK(lognormal[0] == Approx(0.02).epsilon(1e-3));
    CHECK(lognormal[1] == Approx(0.008).epsilon(1e-2));
    // A half of a normal distribution: mean sqrt(2 / pi).
    const auto half = moments({Distribution::normal, 0, 1, 0.0, {}});
    CHECK(half[0] == Approx(std::sqrt(2 / std::acos(-1.0))).epsilon(1e-3));
    CHECK(half[2] >= 0);
    const auto loguniform = moments({Distribution::loguniform, 0.1, 10, {}, {}});
    CHECK(loguniform[0] == Approx(9.9 / std::log(100.0)).epsilon(1e-3));
    CHECK(loguniform[2] >= 0.1);
    CHECK(loguniform[3] <= 10);
}

TEST_CASE("logarithmic values have one ratio and both ends as given", "[sweep]") {
    const std::vector<double> values = logarithmic_values(0.1, 1000, 9);
    CHECK(values.front() == 0.1);
    CHECK(values.back() == 1000);
    for (std::size_t n = 1; n < 9; ++n) CHECK(values[n] / values[n - 1] == Approx(std::sqrt(10.0)).epsilon(1e-14));
    CHECK(values[2] == 1);
}
