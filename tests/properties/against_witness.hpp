/// @file
/// @brief Certified answers to random scenes against routes that share nothing with them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "denhartog/denhartog.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog {

/// @brief What a comparison has come to.
struct Found {
    int compared = 0; ///< scenes
    int refused = 0;  ///< the digits asked for are not there
    double worst = 0; ///< largest difference over the amplitude
};

/// @brief A number of an answer with all its digits. @param x the number @return its value
template <class W>
W number_of(const Certified& x) {
    W value(x.value);
    if (!x.decimal.empty()) REQUIRE(number_from_text(x.decimal, value) == NumberFault::none);
    return value;
}

/// @brief Tolerance of differences, over the amplitude. @param digits asked for: answers are rounded to 45 @return the tolerance
inline double tolerance_of_witness(int digits) { return digits < 45 ? std::pow(10.0, -digits) : 5e-45; }

/// @brief Amplitudes and phases of all masses, and of the contact, against the half-period in coordinates of the masses.
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
    check(contact_moves_apart(scene.system) ? s.between.value().amplitude : s.amplitude(scene.system.contact), of_contact,
          of_contact);
    ++found.compared;
}

/// @brief Some of the scenes against the second witness: the differences are below what the digits allow.
template <class T>
void check_by_witness(const std::vector<RandomScene<double>>& scenes, std::size_t every, int digits, int least) {
    Found found;
    for (std::size_t n = 0; n < scenes.size(); n += every) compare_with_witness<T>(scenes[n], digits, found);
    CHECK(found.compared >= least);
    CHECK(found.worst < tolerance_of_witness(digits));
}

/// @brief Every scene against the second witness, with a line of what was found.
template <class T>
int survey_by_witness(const std::vector<RandomScene<double>>& scenes, int digits, std::size_t most) {
    Found found;
    for (const RandomScene<double>& each : scenes)
        if (number_of_masses(each.scene.system) <= most) compare_with_witness<T>(each, digits, found);
    std::printf("to %d digits: %zu scenes, %d compared, %d refused, worst %.2g of the amplitude\n", digits, scenes.size(),
                found.compared, found.refused, found.worst);
    CHECK(found.worst < tolerance_of_witness(digits));
    return found.compared;
}

/// @brief The points of a map, and the motions there, against `solve`.
inline int check_map_by_solve(Scene<double> scene, const std::vector<double>& r, const std::vector<double>& beta) {
    const RegimeMap all = map(scene, r, beta);
    const std::size_t N = number_of_masses(scene.system);
    int stops = 0;
    for (std::size_t m = 0; m < r.size(); ++m)
        for (std::size_t n = 0; n < beta.size(); ++n) {
            scene.r = r[m];
            scene.beta = beta[n];
            INFO("r = " << r[m] << ", beta = " << beta[n]);
            const Solution s = solve(scene);
            const std::size_t place = m * beta.size() + n;
            CHECK(all.points[place].status == PointStatus::answered);
            CHECK(all.points[place].regime == s.regime.regime);
            CHECK(all.points[place].stops == static_cast<int>(s.stops.size()));
            stops += all.points[place].stops;
            const SampledSolution sampled = motion(scene, 512);
            for (std::size_t k = 0; k < N; ++k) {
                CHECK(all.amplitudes[place * N + k] == Approx(s.masses[k].amplitude.value).epsilon(1e-6));
                double largest = 0;
                for (const State& state : sampled.states()) largest = std::max(largest, std::abs(state.x[k]));
                CHECK(largest == Approx(s.masses[k].amplitude.value).epsilon(1e-4));
            }
        }
    return stops;
}

/// @brief Motions of scenes in stick-slip against the paper's Runge-Kutta over their own period, to 1e-6.
inline int compare_stick_slip_with_paper(const std::vector<RandomScene<double>>& scenes, std::size_t every, int most) {
    int compared = 0;
    for (std::size_t n = 0; n < scenes.size() && compared < most; n += every) {
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
    return compared;
}

} // namespace denhartog
