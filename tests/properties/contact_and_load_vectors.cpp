// Contacts between two masses and loads on several, against routes that know no coordinates of their own.
#include <cmath>
#include <cstdio>

#include "denhartog/denhartog.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "tests/catch.hpp"
#include "tests/support/second_witness.hpp"
#include "tests/support/vector_scenes.hpp"

using namespace denhartog;

namespace {

constexpr std::uint64_t seed_of_vectors = 20261;

struct Found {
    int compared = 0;
    int refused = 0;  // the digits asked for are not there
    double worst = 0; // difference over the amplitude
};

template <class W>
W number_of(const Certified& x) {
    W value(x.value);
    if (!x.decimal.empty()) REQUIRE(number_from_text(x.decimal, value) == NumberFault::none);
    return value;
}

// Amplitudes and phases of all masses, and of the contact, against the half-period in coordinates of the masses.
template <class T>
void compare_with_witness(const RandomScene<double>& random, int digits, Found& found) {
    using W = WitnessOf<T>;
    INFO(random.name);
    Scene<double> scene = random.scene;
    Solution s;
    try {
        scene.beta = friction_ratio_at(random.fraction_of_limit, boundary(scene, 6).exact.value);
        s = solve(scene, {Asked::motion, digits});
    } catch (const PrecisionError&) {
        CHECK(scene.mu > 1);
        ++found.refused;
        return;
    }
    if (s.regime.regime != Regime::continuous) return; // at mu > 1 the motion from rest may be another
    const HalfPeriodProblem<W> problem = half_period_problem(converted<T>(scene));
    const HalfPeriodMotion<W> witness = half_period_motion(problem, 64);
    const auto check = [&](const Certified& x, const W& expected, const W& scale) {
        const W difference = abs(W(number_of<W>(x) - expected)), rounding = scale * W(std::pow(10.0, -digits));
        CHECK(difference <= W(x.error) + rounding);
        found.worst = std::max(found.worst, static_cast<double>(W(difference / scale)));
    };
    for (std::size_t k = 0; k < s.masses.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        INFO("mass " << k + 1);
        check(s.masses[k].amplitude, witness.amplitude(row), witness.amplitude(row));
        const W turn = number_of<W>(s.masses[k].phase.value()) - witness.phase(row);
        CHECK(abs(W(sin(turn))) + (cos(turn) < 0 ? W(1) : W(0)) <= W(s.masses[k].phase->error) + W(std::pow(10.0, -digits)));
    }
    const W of_contact = contact_vector(problem).dot(witness.x_0);
    check(scene.system.contact_with ? s.between.value().amplitude : s.amplitude(scene.system.contact), of_contact, of_contact);
    ++found.compared;
}

} // namespace

TEST_CASE("the closed form with contact and load as vectors agrees with the second witness to 12 digits",
          "[eq:33][eq:34][eq:35][eq:38][eq:46][eq:65][vectors][witness]") {
    Found found;
    const std::vector<RandomScene<double>> scenes = random_vector_scenes(seed_of_vectors);
    for (std::size_t n = 0; n < scenes.size(); n += 6) compare_with_witness<double>(scenes[n], 12, found);
    CHECK(found.compared >= 70);
    CHECK(found.worst < 1e-12);
}

TEST_CASE("the closed form with contact and load as vectors agrees with the second witness to 45 digits",
          "[eq:33][eq:38][vectors][witness]") {
    Found found;
    const std::vector<RandomScene<double>> scenes = random_vector_scenes(seed_of_vectors + 1);
    for (std::size_t n = 0; n < 120; n += 20) compare_with_witness<Real50>(scenes[n], 45, found);
    CHECK(found.compared >= 5);
    CHECK(found.worst < 5e-45); // they are rounded to 45 digits
}

TEST_CASE("every scene with contact and load as vectors agrees with the second witness", "[.][sweep][vectors][witness]") {
    Found found, in_50_digits;
    for (const std::uint64_t seed : {seed_of_vectors, seed_of_vectors + 1})
        for (const RandomScene<double>& each : random_vector_scenes(seed)) compare_with_witness<double>(each, 12, found);
    for (const RandomScene<double>& each : random_vector_scenes(seed_of_vectors))
        if (number_of_masses(each.scene.system) <= 4) compare_with_witness<Real50>(each, 45, in_50_digits);
    std::printf(
        "to 12 digits: %d scenes, %d refused, worst %.2g of the amplitude; to 45 digits: %d scenes, %d refused, worst %.2g\n",
        found.compared, found.refused, found.worst, in_50_digits.compared, in_50_digits.refused, in_50_digits.worst);
    CHECK(found.worst < 1e-12);
    CHECK(in_50_digits.worst < 5e-45);
}

TEST_CASE("stick-slip with contact and load as vectors is the paper's algorithm's", "[eq:74][eq:75][vectors]") {
    int compared = 0;
    const std::vector<RandomScene<double>> scenes = random_vector_scenes(seed_of_vectors + 2);
    for (std::size_t n = 0; n < scenes.size() && compared < 60; n += 3) {
        Scene<double> scene = scenes[n].scene;
        INFO(scenes[n].name);
        Solution s;
        try {
            const Limits limits = boundary(scene);
            if (!limits.sticking || limits.sticking->value < 1.05 * limits.exact.value) continue;
            scene.beta = limits.exact.value + scenes[n].fraction_of_limit * (limits.sticking->value - limits.exact.value);
            s = solve(scene);
        } catch (const PrecisionError&) {
            continue;
        }
        if (s.regime.regime != Regime::stick_slip || !s.start) continue;
        PaperSettings settings;
        settings.cycles = s.periods;
        settings.absolute_tolerance = 1e-10;
        settings.relative_tolerance = 1e-10;
        settings.start.emplace();
        for (const Certified& x : s.start->x) settings.start->x.push_back(x.value);
        for (const Certified& v : s.start->x_prime) settings.start->x_prime.push_back(v.value);
        const PaperMotion paper = paper_algorithm(scene, settings);
        REQUIRE(paper.status == IntegrationStatus::complete);
        if (s.periods > 1) continue; // its last period alone has not all extrema
        for (std::size_t k = 0; k < s.masses.size(); ++k) {
            INFO("mass " << k + 1);
            CHECK(std::abs(paper.masses[k].amplitude - s.masses[k].amplitude.value) <
                  1e-6 * s.masses[k].amplitude.value + s.masses[k].amplitude.error + 1e-8);
        }
        if (s.between)
            CHECK(std::abs(paper.between.value().amplitude - s.between->amplitude.value) <
                  1e-6 * (1 + s.between->amplitude.value));
        CHECK(paper.stops.size() == s.stops.size());
        ++compared;
    }
    CHECK(compared == 60);
}

TEST_CASE("two masses that rub against each other may be named in either order", "[vectors]") {
    const std::string chain =
        R"({"mass_ratios": [1, 2, 1.5], "stiffness_ratios": [1, 0.75, 1.25], "damping_ratios": [0.05, 0.04, 0.06],
            "load": [0.25, 1, 0.5], "r": 0.75, "contact": )";
    for (const std::string beta : {"0.0625", "0.25"}) {
        const Solution a = solve(scene(chain + R"([1, 3], "beta": )" + beta + "}"));
        const Solution b = solve(scene(chain + R"([3, 1], "beta": )" + beta + "}"));
        INFO("beta = " << beta);
        CHECK(b.between.value().amplitude.value == Approx(a.between.value().amplitude.value).epsilon(1e-9));
        CHECK(std::abs(std::cos(b.between->phase.value().value - a.between->phase.value().value) + 1) < 1e-9);
        for (std::size_t k = 0; k < 3; ++k) CHECK(b.amplitude(Mass{k}).value == Approx(a.amplitude(Mass{k}).value).epsilon(1e-9));
    }
}

TEST_CASE("a mass that cannot move is a wall", "[vectors]") {
    // The last mass of three is heavy: rubbing against it is rubbing against a wall, as a chain of two does.
    const std::string heavy =
        R"({"mass_ratios": [1, 2, 1e6], "stiffness_matrix": [[1.75, -0.75, 0], [-0.75, 0.75, 0], [0, 0, 1]],
        "damping_matrix": [[0.1, 0, 0], [0, 0.2, 0], [0, 0, 1e5]], "contact": [2, 3], "load": 1, "r": 0.875, "beta": )";
    const std::string wall = R"({"mass_ratios": [1, 2], "stiffness_matrix": [[1.75, -0.75], [-0.75, 0.75]],
        "damping_matrix": [[0.1, 0], [0, 0.2]], "contact": 2, "load": 1, "r": 0.875, "beta": )";
    for (const char* beta : {"0.125", "0.5", "2"}) {
        const Solution a = solve(scene(heavy + beta + "}")), b = solve(scene(wall + beta + "}"));
        INFO("beta = " << beta);
        CHECK(a.regime.regime == b.regime.regime);
        CHECK(a.stops.size() == b.stops.size());
        for (std::size_t k = 0; k < 2; ++k)
            CHECK(a.masses[k].amplitude.value == Approx(b.masses[k].amplitude.value).margin(1e-4)); // it moves by a millionth
    }
}

TEST_CASE("map and motion of a contact between two masses are those of solve", "[vectors]") {
    const Scene<double> at = scene(
        R"({"mass_ratios": [1, 2, 1.5], "stiffness_ratios": [1, 0.75, 1.25], "damping_ratios": [0.05, 0.04, 0.06],
            "contact": [1, 2], "load": [0.25, 1, 0.5], "r": 0.75, "beta": 0.0625})");
    const std::vector<double> r{0.5, 0.75, 1.5}, beta{0.0625, 0.5, 4};
    const RegimeMap all = map(at, r, beta);
    Scene<double> point = at;
    for (std::size_t m = 0; m < r.size(); ++m)
        for (std::size_t n = 0; n < beta.size(); ++n) {
            point.r = r[m];
            point.beta = beta[n];
            const Solution s = solve(point);
            const std::size_t place = m * beta.size() + n;
            CHECK(all.points[place].regime == s.regime.regime);
            const SampledSolution sampled = motion(point, 512);
            for (std::size_t k = 0; k < 3; ++k) {
                CHECK(all.amplitudes[place * 3 + k] == Approx(s.masses[k].amplitude.value).epsilon(1e-6));
                double largest = 0;
                for (const State<double>& state : sampled.states) largest = std::max(largest, std::abs(state.x[k]));
                CHECK(largest == Approx(s.masses[k].amplitude.value).epsilon(1e-4));
            }
        }
}
