/// @file
/// @brief Motions with stops in double: their numbers lie within their bounds of the proved ones, and the bounds are of use.
#include <cmath>
#include <limits>

#include "orbit_cases.hpp"
#include "tests/integration/orbit_scenes.hpp"

namespace denhartog::tests {
namespace {

using reference::OrbitInBalls;

constexpr slong bits = 256;

// The motion near one in double, proved.
OrbitInBalls proved(const PreparedMotion& p, const PeriodicOrbit& orbit, bool with_multipliers = false) {
    ExactSolver solver(p.system, p.excitation);
    return reference::proved_orbit(in_bits(p.scene), guess_of(solver, orbit), bits, {}, with_multipliers);
}

double apart(const Ball& truth, double x) { return std::abs(static_cast<double>(truth - Ball(x))); }

// Eigenvalues of the proved map over the period, of which balls give the sizes alone.
std::vector<std::complex<double>> proved_eigenvalues(const PreparedMotion& p, const PeriodicOrbit& orbit) {
    ExactSolver solver(p.system, p.excitation);
    const reference::ProvedOrbit motion = reference::proved_near(in_bits(p.scene), guess_of(solver, orbit), bits);
    const Bits enough(bits);
    const reference::MapOfDeviations map = reference::map_of_deviations(motion, reference::linearised(motion.s, motion.at));
    Matrix<double> A(map.A.rows(), map.A.rows());
    for (slong i = 0; i < map.A.rows(); ++i)
        for (slong k = 0; k < map.A.rows(); ++k) {
            A(i, k) = static_cast<double>(map.A(i, k));
            CHECK(map.A(i, k).radius() < 1e-12);
        }
    if (motion.at.mirrored) A = Matrix<double>(A * A);
    std::vector<std::complex<double>> all;
    for (const Multiplier& each : multipliers_of(A, 0, std::numeric_limits<double>::infinity())) all.push_back(each.value);
    if (map.from_a_stop) all.emplace_back(0);
    return all;
}

} // namespace

TEST_CASE("in stick-slip double agrees with the proved motion, within the bound it gives, and the bound is no excuse",
          "[eq:2][eq:3][eq:74][exact-solver][shooting]") {
    int compared = 0;
    double worst = 0, tightest = 0, product = 0;
    std::string where, tightest_where;
    for (const double mu : {1.0, 0.0}) {
        for (const PreparedMotion& p : between_the_boundaries(mu == 1 ? 7 : 8, 3, mu)) {
            OrbitSearch search;
            search.most_periods = 100;
            const PeriodicOrbit orbit = orbit_of(p, search);
            if (orbit.status != OrbitStatus::periodic || orbit.periods > 1 || !orbit.symmetric) continue;
            INFO(p.name);
            const OrbitInBalls exact = proved(p, orbit);
            REQUIRE(exact.stops.size() == orbit.stops.size());
            ++compared;
            double error = 0, largest = 0;
            for (std::size_t k = 0; k < orbit.masses.size(); ++k) {
                CHECK(exact.masses[k].size.radius() < 1e-42);
                largest = std::max(largest, orbit.masses[k].amplitude);
                error = std::max(
                    {error, apart(exact.masses[k].size, orbit.masses[k].amplitude), apart(exact.x[k], orbit.start.x[k])});
            }
            for (std::size_t n = 0; n < orbit.stops.size(); ++n) {
                CHECK(apart(exact.stops[n].start, orbit.stops[n].start) < 1e-11);
                CHECK(apart(exact.stops[n].end, orbit.stops[n].end) < 1e-11);
                error = std::max(error, apart(exact.stops[n].x, orbit.stops[n].x));
            }
            CHECK(error < 1e-13 * (1 + largest));
            const double size = std::max(largest, 1e-3);
            if (error / size > worst) {
                worst = error / size;
                where = p.name;
            }
            if (error / orbit.error_bound > tightest) {
                tightest = error / orbit.error_bound;
                tightest_where = p.name;
            }
            CHECK(orbit.error_bound < 1e-8 * size);
            product += std::log10(std::max(error, 1e-17) / orbit.error_bound);
        }
    }
    INFO(where << " " << hexadecimal(worst) << "; " << tightest_where << " " << hexadecimal(tightest));
    CHECK(compared > 100);
    CHECK(worst < 1e-12);
    CHECK(tightest <= 1);
    CHECK(product / compared > -4);
}

TEST_CASE("the phase of a contact that stops is where it comes to rest, proved as in double", "[eq:39][exact-solver][shooting]") {
    const PreparedMotion p = prepared_chain({1, 3.125}, {1, 2}, {0.09375, 0.203125}, 1, 2, 0.8125, 3.984375);
    const PeriodicOrbit orbit = orbit_of(p);
    REQUIRE(orbit.status == OrbitStatus::periodic);
    const OrbitInBalls exact = proved(p, orbit);
    REQUIRE(exact.stops.size() == 2);
    const StopOf<Ball>& out = exact.stops[exact.stops[0].x > Ball(0) ? 0 : 1];
    const Ball phase = exact.masses.back().phase.value(), period = 2 * pi<Ball>();
    const Ball turned = phase - out.start, rest = turned - Ball(std::round(static_cast<double>(turned / period))) * period;
    CHECK(abs(rest).low() <= 0);
    CHECK(rest.radius() < 1e-44);
    CHECK(apart(phase, orbit.contact.phase) < 1e-11);
}

TEST_CASE("Floquet multipliers are the eigenvalues of the proved map of deviations", "[exact-solver][shooting]") {
    for (const PreparedMotion& p : {prepared_oscillator(0.01, 0.125, 0.1875), prepared_oscillator(0.03125, 0.5, 0.1875, 2),
                                    prepared_three_masses(1.125, 0.0625), prepared_three_masses(0.6875, 0.25),
                                    prepared_three_masses(0.6875, 0.1875, 1.25)}) {
        const PeriodicOrbit orbit = orbit_of(p);
        REQUIRE(orbit.status == OrbitStatus::periodic);
        REQUIRE(orbit.periods == 1);
        const std::vector<std::complex<double>> expected = proved_eigenvalues(p, orbit);
        REQUIRE(expected.size() == orbit.multipliers.size());
        for (std::size_t n = 0; n < expected.size(); ++n) {
            const std::complex<double> value = orbit.multipliers[n].value, other = expected[n];
            INFO(n << " " << other << " " << value);
            // Zeros are of higher multiplicity where the contact sticks: their rounding is a root of that of the rest.
            const double tolerance = std::abs(other) > 1e-3 ? 1e-10 : 1e-5;
            CHECK(std::abs(other - value) < tolerance);
        }
        CHECK(orbit.stable);
    }
}

TEST_CASE("the sizes of Floquet multipliers are within their bounds of the proved ones", "[exact-solver][shooting]") {
    std::size_t compared = 0, close = 0, closer = 0;
    for (const double mu : {1.0, 1.25})
        for (const PreparedMotion& p : between_the_boundaries(mu == 1 ? 31 : 32, 3, mu)) {
            OrbitSearch any;
            any.follow_start = false;
            const PeriodicOrbit orbit = orbit_of(p, any);
            if (orbit.status != OrbitStatus::periodic) continue;
            INFO(p.name << " mu = " << mu);
            OrbitInBalls exact;
            try {
                exact = proved(p, orbit, true);
            } catch (const reference::Unproved&) {
                continue;
            }
            REQUIRE(exact.multipliers.size() == orbit.multipliers.size());
            for (std::size_t n = 0; n < orbit.multipliers.size(); ++n) {
                const Multiplier& in_double = orbit.multipliers[n];
                INFO(n << " " << size_of(in_double.value) << " " << static_cast<double>(exact.multipliers[n]));
                CHECK(abs(exact.multipliers[n] - Ball(size_of(in_double.value))).low() <= in_double.error);
                ++compared;
                close += in_double.error < 1e-6;
                closer += exact.multipliers[n].radius() < 1e-9;
            }
        }
    CAPTURE(compared, close, closer);
    CHECK(compared > 300);
    CHECK(10 * close > 9 * compared);
    CHECK(10 * closer > 9 * compared);
}

} // namespace denhartog::tests
