// Bases and walls that move, together or alone, against routes that know the equations of motion alone.
#include <cmath>
#include <tuple>

#include "denhartog/answer/reference.hpp"
#include "tests/properties/against_witness.hpp"
#include "tests/support/kinds_of_scenes.hpp"
#include "tests/support/named_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

constexpr std::uint64_t seed_of_bases = 20265;

// The largest of |x_k + b cos(tau + phi_j)| over the half-period of the witness, by Hermite's cubic between fine samples.
struct Absolute {
    double amplitude, phase;
};

Absolute absolute_of(const HalfPeriodMotion<Real50>& w, Eigen::Index k, double b) {
    const Eigen::Index steps = w.x.cols() - 1;
    const double h = pi<double>() / static_cast<double>(steps), phi = static_cast<double>(w.phi_j);
    const auto at = [&](Eigen::Index n) {
        const double tau = h * static_cast<double>(n) + phi;
        return std::pair{static_cast<double>(w.x(k, n)) + b * std::cos(tau),
                         static_cast<double>(w.x_prime(k, n)) - b * std::sin(tau)};
    };
    Absolute largest{0, 0};
    const auto take = [&](double x, double tau) {
        if (std::abs(x) > largest.amplitude) largest = {std::abs(x), tau + phi + (x < 0 ? pi<double>() : 0)};
    };
    for (Eigen::Index n = 0; n < steps; ++n) {
        double x0 = 0, v0 = 0, x1 = 0, v1 = 0; // Clang 14 takes no structured binding into a lambda
        std::tie(x0, v0) = at(n);
        std::tie(x1, v1) = at(n + 1);
        take(x0, h * static_cast<double>(n));
        if (v0 * v1 > 0) continue;
        double low = 0, high = 1;
        const auto cubic = [&](double s) {
            const double a = 2 * (x0 - x1) + h * (v0 + v1), c = 3 * (x1 - x0) - h * (2 * v0 + v1);
            return std::pair{x0 + s * (h * v0 + s * (c + s * a)), h * v0 + s * (2 * c + 3 * s * a)};
        };
        for (int m = 0; m < 60; ++m) {
            const double s = (low + high) / 2;
            (cubic(s).second * v0 > 0 ? low : high) = s;
        }
        take(cubic(low).first, h * (static_cast<double>(n) + low));
    }
    return largest;
}

// Absolute amplitudes and phases of sliding motions. How many were compared.
int compare_from_ground(const std::vector<RandomScene<double>>& scenes, std::size_t every, int steps) {
    int compared = 0;
    for (std::size_t n = 0; n < scenes.size(); n += every) {
        Scene<double> scene = scenes[n].scene;
        INFO(scenes[n].name);
        Solution s;
        try {
            scene.beta = friction_ratio_at(scenes[n].fraction_of_limit, boundary(scene, 6).exact.value);
            s = solve(scene, {Asked::motion, 12});
        } catch (const PrecisionError&) {
            continue;
        }
        if (s.regime.regime != Regime::continuous || s.from_ground.empty()) continue;
        const double r = *scene.r, base = scene.system.base_motion == BaseMotion::with_wall ? 1 / (r * r) : 1;
        const double b = scene.system.base_motion == BaseMotion::alone ? 0 : base;
        CHECK(s.base_amplitude.value().value == Approx(base).epsilon(1e-14));
        const HalfPeriodMotion<Real50> witness = half_period_motion(half_period_problem(scene), steps);
        for (std::size_t k = 0; k < s.from_ground.size(); ++k) {
            INFO("mass " << k + 1);
            const Absolute expected = absolute_of(witness, static_cast<Eigen::Index>(k), b);
            const MassFromGround& seen = s.from_ground[k];
            CHECK(std::abs(seen.amplitude.value - expected.amplitude) <=
                  1e-7 * (expected.amplitude + b) + seen.amplitude.error); // of the cubic
            CHECK(seen.transmissibility.value == Approx(seen.amplitude.value / base).epsilon(1e-12));
            if (seen.phase && expected.amplitude > 1e-3 * b)
                CHECK(std::abs(std::remainder(seen.phase->value - expected.phase, 2 * pi<double>())) < 1e-4 + seen.phase->error);
        }
        ++compared;
    }
    return compared;
}

// A motion of two masses in absolute displacements by Runge and Kutta's method: springs and dampers to a base at x_0, friction with
// a wall at x_w, both of which move. The largest displacements over the last period.
std::array<double, 2> integrated(const std::array<double, 2>& m, const std::array<double, 2>& k, const std::array<double, 2>& c,
                                 double omega, double X_base, double X_wall, double friction, std::size_t contact) {
    using Vector4 = std::array<double, 4>;
    const auto rate = [&](const Vector4& z, double t) {
        const double base = X_base * std::cos(omega * t), v_base = -omega * X_base * std::sin(omega * t),
                     v_wall = -omega * X_wall * std::sin(omega * t);
        const double first = k[0] * (base - z[0]) + c[0] * (v_base - z[2]), second = k[1] * (z[0] - z[1]) + c[1] * (z[2] - z[3]);
        std::array<double, 2> force{first - second, second};
        force[contact] -= friction * std::tanh((z[2 + contact] - v_wall) * 1e5);
        return Vector4{z[2], z[3], force[0] / m[0], force[1] / m[1]};
    };
    constexpr int periods = 60, steps = 20000;
    const double h = 2 * pi<double>() / omega / steps;
    Vector4 z{};
    std::array<double, 2> largest{};
    const auto moved = [](const Vector4& a, double t, const Vector4& b) {
        return Vector4{a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2], a[3] + t * b[3]};
    };
    for (int n = 0; n < periods * steps; ++n) {
        const double t = h * n;
        const Vector4 a = rate(z, t), b = rate(moved(z, h / 2, a), t + h / 2), d = rate(moved(z, h / 2, b), t + h / 2),
                      e = rate(moved(z, h, d), t + h);
        for (std::size_t i = 0; i < 4; ++i) z[i] += h / 6 * (a[i] + 2 * b[i] + 2 * d[i] + e[i]);
        for (std::size_t i = 0; i < 2 && n >= (periods - 1) * steps; ++i) largest[i] = std::max(largest[i], std::abs(z[i]));
    }
    return largest;
}

} // namespace

TEST_CASE("absolute displacements of every second scene agree with the second witness", "[.][sweep][base][witness]") {
    CHECK(compare_from_ground(random_base_scenes(seed_of_bases + 2), 2, 1024) > 150);
}

TEST_CASE("absolute displacements, transmissibilities and phases agree with the second witness", "[base][witness]") {
    CHECK(compare_from_ground(random_base_scenes(seed_of_bases + 2), 17, 1024) >= 20);
}

TEST_CASE("a base, a wall and both that move are what an integration in absolute displacements gives", "[base]") {
    const std::array<double, 2> m{2, 3}, k{800, 500}, c{6, 9};
    constexpr double omega = 17, X = 0.01;
    for (const auto& [name, base, wall] : {std::tuple{"with_wall", X, X}, {"alone", X, 0.0}, {"wall", 0.0, X}})
        for (const double friction : {0.4, 1.5}) {
            INFO(name << " friction " << friction);
            const Scene<double> at = named_scene(R"(shaken dashpots {"base_motion": ")" + std::string(name) +
                                                 R"(", "friction": )" + std::to_string(friction) + "}");
            const Solution s = solve(at);
            REQUIRE(s.from_ground.size() == 2);
            const double length = at.units.value().force.value() / 800;
            const std::array<double, 2> expected = integrated(m, k, c, omega, base, wall, friction, 1);
            for (std::size_t i = 0; i < 2; ++i) {
                CHECK(length * s.from_ground[i].amplitude.value == Approx(expected[i]).epsilon(2e-3).margin(2e-6));
                CHECK(X * s.from_ground[i].transmissibility.value == Approx(expected[i]).epsilon(2e-3).margin(2e-6));
            }
        }
}

TEST_CASE("absolute displacements in double lie within their bounds of those that are proved", "[base]") {
    for (const char* base : {"with_wall", "alone", "wall"})
        for (const char* beta : {"0.05", "0.5", "6"}) {
            INFO(base << " " << beta);
            const Scene<double> at =
                named_scene(R"(storeys {"load": null, "base_motion": ")" + std::string(base) + R"(", "beta": )" + beta + "}");
            const Solution fast = solve(at), proved = solve(at, {Asked::motion, 17});
            CHECK(fast.regime.regime == proved.regime.regime);
            REQUIRE(fast.from_ground.size() == 3);
            REQUIRE(proved.from_ground.size() == 3);
            for (std::size_t k = 0; k < 3; ++k) {
                const MassFromGround &a = fast.from_ground[k], &b = proved.from_ground[k];
                CHECK(std::abs(a.amplitude.value - b.amplitude.value) <= a.amplitude.error + b.amplitude.error);
                CHECK(std::abs(a.transmissibility.value - b.transmissibility.value) <=
                      a.transmissibility.error + b.transmissibility.error);
                if (a.phase && b.phase)
                    CHECK(std::abs(std::remainder(a.phase->value - b.phase->value, 2 * pi<double>())) <=
                          a.phase->error + b.phase->error);
            }
        }
}

TEST_CASE("a map of absolute amplitudes has those of solve", "[base]") {
    Scene<double> at =
        named_scene(R"(pair on a base {"damping_ratios": [0.05, 0.04], "r": 0.75, "beta": 0.1, "base_motion": "wall"})");
    MapRequest request{{0.5, 1.5}, {0.05, 0.4, 8}, {Mass{1}, Mass{0}}, MapStart::rest, 1};
    request.from_ground = true;
    const std::atomic<bool> stop{false};
    const RegimeMap all = regime_map(at, request, stop);
    REQUIRE(all.complete);
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t n = 0; n < 3; ++n) {
            at.r = request.r[m];
            at.beta = request.beta[n];
            const Solution s = solve(at);
            CHECK(all.points[m * 3 + n].regime == s.regime.regime);
            for (std::size_t k = 0; k < 2; ++k)
                CHECK(all.amplitudes[(m * 3 + n) * 2 + k] == s.from_ground[request.masses[k].index].amplitude.value);
        }
    at.system.base_motion = BaseMotion::none;
    CHECK_THROWS_WITH(regime_map(at, request, stop),
                      Catch::Matchers::Contains("base_motion must be given for absolute amplitudes"));
}

TEST_CASE("a wall that nothing rubs against, and one that loads nothing, are refused", "[base][bad-input]") {
    CHECK_THROWS_WITH(
        named_scene(R"(pair on a base {"contact": [1, 2], "r": 0.5, "beta": 0.1, "base_motion": "wall"})"),
        Catch::Matchers::Contains("base_motion must be \"with_wall\" or \"alone\" where the contact is between two masses"));
    CHECK_THROWS_WITH(solve(named_scene(R"(undamped {"load": null, "r": 1, "beta": 0.1, "base_motion": "wall"})")),
                      Catch::Matchers::Contains("loads no mass"));
}

TEST_CASE("invariant points of a base alone are those of its springs, damped or not, and a wall alone is refused by name",
          "[base][eq:87]") {
    const auto points = [](const std::string& load, const std::string& zeta) {
        const SceneSource source =
            named_source(R"(storeys {"load": null, "r": null, "damping_ratios": )" + zeta + ", " + load + "}");
        return invariant_points(source, {"0.2", "2"}, std::nullopt);
    };
    const auto of_load = points(R"("load": 1)", "0"); // the base holds mass 1 alone, by the spring k_1
    std::size_t count = 0;
    for (const char* zeta : {"0", "0.05"}) {
        const auto of_base = points(R"("base_motion": "alone")", zeta);
        REQUIRE(of_base.size() == of_load.size());
        for (std::size_t k = 0; k < of_load.size(); ++k) {
            REQUIRE(of_base[k].points.size() == of_load[k].points.size());
            for (std::size_t n = 0; n < of_load[k].points.size(); ++n, ++count)
                CHECK(of_base[k].points[n].r.value == of_load[k].points[n].r.value);
        }
    }
    CHECK(count > 4);
    REQUIRE_THROWS_WITH(points(R"("base_motion": "wall")", "0.05"), Catch::Matchers::Contains("in the frame of the wall"));
}
