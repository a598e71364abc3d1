// Forces out of phase, against routes that have a complex load of their own.
#include <Eigen/LU>
#include <cmath>

#include "denhartog/answer/reference.hpp"
#include "tests/properties/against_witness.hpp"
#include "tests/support/event_integrator.hpp"
#include "tests/support/kinds_of_scenes.hpp"
#include "tests/support/named_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

constexpr std::uint64_t seed_of_phases = 20264;

double as_double(const Real50& x) { return static_cast<double>(x); }

// A motion with stops, which the answer has the start of, followed over its period.
int compare_with_events(const std::vector<RandomScene<double>>& scenes, std::size_t every, int most) {
    constexpr int steps = 96;
    int compared = 0;
    for (std::size_t n = 0; n < scenes.size() && compared < most; n += every) {
        Scene<double> scene = scenes[n].scene;
        const std::size_t N = number_of_masses(scene.system);
        INFO(scenes[n].name);
        Solution s;
        try {
            const Limits limits = boundary(scene);
            if (N > 4 || !limits.sticking || limits.sticking->value < 1.05 * limits.exact.value) continue;
            scene.beta = friction_ratio_at(1, limits.exact.value +
                                                  scenes[n].fraction_of_limit * (limits.sticking->value - limits.exact.value));
            s = solve(scene, {Asked::motion, 12});
        } catch (const PrecisionError&) {
            continue;
        }
        if (s.regime.regime != Regime::stick_slip || !s.start || s.stops.empty()) continue;
        EventIntegrator<Real50> integrator(half_period_problem(scene), Real50(scene.mu) * Real50(*scene.beta), steps);
        Vector<Real50> x(static_cast<Eigen::Index>(N)), v(static_cast<Eigen::Index>(N));
        double size = 0;
        for (std::size_t k = 0; k < N; ++k) {
            x(static_cast<Eigen::Index>(k)) = number_of<Real50>(s.start->x[k]);
            v(static_cast<Eigen::Index>(k)) = number_of<Real50>(s.start->x_prime[k]);
            size = std::max(size, s.masses[k].amplitude.value);
        }
        const FollowedMotion<Real50> followed = integrator.follow(x, v, steps * s.periods);
        for (Eigen::Index k = 0; k < x.size(); ++k) {
            INFO("mass " << k + 1);
            CHECK(std::abs(as_double(followed.x(k) - x(k))) < 1e-10 * size);
            CHECK(std::abs(as_double(followed.amplitude(k)) - s.masses[static_cast<std::size_t>(k)].amplitude.value) <
                  1e-10 * size);
        }
        int within = 0; // a rest that goes on where the period ends is none that ends within it
        for (const auto& stop : s.stops) within += stop.end.value < 2 * pi<double>() * s.periods;
        CHECK(std::abs(static_cast<int>(followed.stops.size()) - within) <= 1);
        ++compared;
    }
    return compared;
}

// The response with the contact held from the matrices of (6): a dense linear system.
int compare_stuck(const std::vector<RandomScene<double>>& scenes, std::size_t every) {
    int compared = 0;
    for (std::size_t n = 0; n < scenes.size(); n += every) {
        Scene<double> scene = scenes[n].scene;
        INFO(scenes[n].name);
        const Limits limits = boundary(scene);
        if (!limits.sticking) continue;
        scene.beta = std::max(1.25 * limits.sticking->value, 1.25 * limits.exact.value);
        Solution s;
        try {
            s = solve(scene, {Asked::motion, 12});
        } catch (const PrecisionError&) {
            CHECK(scene.mu > 1); // the motion from rest may take long
            continue;
        }
        if (s.regime.regime != Regime::permanent_sticking) continue;
        const HalfPeriodProblem<Real50> p = half_period_problem(scene);
        const Eigen::Index N = p.M.rows(), m = N + 1;
        Matrix<Real50> A = Matrix<Real50>::Zero(2 * m, 2 * m);
        Vector<Real50> b = Vector<Real50>::Zero(2 * m);
        const Vector<Real50> w = contact_vector(p);
        for (const Eigen::Index at : {Eigen::Index(0), m}) {
            A.block(at, at, N, N) = p.K - p.M;
            A.block(at, at + N, N, 1) = w;
            A.block(at + N, at, 1, N) = w.transpose();
        }
        A.block(m, 0, N, N) = p.C;
        A.block(0, m, N, N) = -p.C;
        b.head(N) = load_vector(p);
        b.segment(m, N) = leading_load(p);
        const Vector<Real50> X = Eigen::FullPivLU<Matrix<Real50>>(A).solve(b);
        double size = 0;
        for (const SolvedMass& mass : s.masses) size = std::max(size, mass.amplitude.value);
        for (Eigen::Index k = 0; k < N; ++k) {
            INFO("mass " << k + 1);
            const SolvedMass& mass = s.masses[static_cast<std::size_t>(k)];
            const Real50 expected = sqrt(Real50(X(k) * X(k) + X(m + k) * X(m + k)));
            CHECK(std::abs(mass.amplitude.value - as_double(expected)) <= 1e-12 * size + mass.amplitude.error + 1e-30);
            if (mass.phase && as_double(expected) > 1e-6 * size)
                CHECK(std::abs(std::remainder(mass.phase->value + std::atan2(as_double(X(m + k)), as_double(X(k))),
                                              2 * pi<double>())) < 1e-9);
        }
        const Real50 load = sqrt(Real50(X(N) * X(N) + X(m + N) * X(m + N)));
        CHECK(limits.sticking->value == Approx(as_double(load) / scene.mu).epsilon(1e-11));
        ++compared;
    }
    return compared;
}

// Storeys under forces with or without phases, at a friction ratio.
Scene<double> phased(const std::string& damping, const std::string& phases, const std::string& beta) {
    return named_scene(R"(storeys {"load": [1, 0.5, 0.25], "damping_ratios": )" + damping + R"(, "load_phases": )" + phases +
                       R"(, "beta": )" + beta + "}");
}

} // namespace

TEST_CASE("every stop and every rest under forces out of phase is found by other routes", "[.][sweep][phases][witness]") {
    CHECK(compare_with_events(random_phased_scenes(seed_of_phases + 2), 1, 200) >= 100);
    // The other scenes have no such limit, or the motion from rest does not come to rest there.
    CHECK(compare_stuck(random_phased_scenes(seed_of_phases + 3), 1) >= 370);
}

TEST_CASE("stick-slip under forces out of phase is what an event-driven integration gives", "[eq:74][eq:75][phases][witness]") {
    CHECK(compare_with_events(random_phased_scenes(seed_of_phases + 2), 3, 20) == 20);
}

TEST_CASE("the stuck response to forces out of phase solves (6) with the contact held", "[eq:88][phases][witness]") {
    CHECK(compare_stuck(random_phased_scenes(seed_of_phases + 3), 9) >= 40);
}

TEST_CASE("forces that all lead by one angle are forces in phase, that much earlier", "[phases]") {
    for (const char* damping : {"[0.05, 0.04, 0.06]", "[0, 0, 0]"})
        for (const char* beta : {"0.0625", "0.25", "4"}) {
            INFO(damping << " " << beta);
            const Solution a = solve(phased(damping, "null", beta)), b = solve(phased(damping, "[0.75, 0.75, 0.75]", beta));
            CHECK(a.regime.regime == b.regime.regime);
            CHECK(a.stops.size() == b.stops.size());
            for (std::size_t k = 0; k < 3; ++k) {
                CHECK(b.masses[k].amplitude.value == Approx(a.masses[k].amplitude.value).epsilon(1e-9));
                if (a.masses[k].phase)
                    CHECK(std::abs(std::remainder(a.masses[k].phase->value - 0.75 - b.masses[k].phase.value().value,
                                                  2 * pi<double>())) < 1e-8);
            }
        }
}

TEST_CASE("a force on one mass that leads by an angle is that force, that much earlier", "[phases][eq:69]") {
    const auto answer = [](const std::string& load) { return solve(named_scene("two {" + load + "}")); };
    for (const bool first : {true, false})
        for (const std::string beta : {"0.0625", "0.5"}) {
            const std::string load = (first ? R"("load": [1, 0], "beta": )" : R"("load": [0, 1], "beta": )") + beta;
            INFO(load);
            const Solution a = answer(load),
                           b = answer(load + (first ? R"(, "load_phases": [0.75, 0])" : R"(, "load_phases": [0, 0.75])"));
            CHECK(b.regime.regime == a.regime.regime);
            CHECK(b.limits.value().exact.value == Approx(a.limits.value().exact.value).epsilon(1e-12));
            for (std::size_t k = 0; k < 2; ++k) {
                CHECK(b.masses[k].amplitude.value == Approx(a.masses[k].amplitude.value).epsilon(1e-9));
                CHECK(std::abs(std::remainder(a.masses[k].phase.value().value - 0.75 - b.masses[k].phase.value().value,
                                              2 * pi<double>())) < 1e-8);
            }
        }
}

TEST_CASE("invariant points, (86) and (88) as printed are refused or left out where forces are out of phase", "[eq:87][phases]") {
    const Scene<double> at = phased("[0, 0, 0]", "[0, 1.25, -2]", "4");
    CHECK_THROWS_WITH(invariant_points(scene_source(at), {"0.25", "2"}, std::nullopt),
                      Catch::Matchers::Contains("load_phases must not be given for invariant points"));
    CHECK(!solve(at).sticking_by_88);
}
