// Energy that a motion dissipates and forces that it hands over: the balance of the reference against quadratures of the power
// along motions that other routes have.
#include <cmath>

#include "denhartog/solve/solve.hpp"
#include "tests/properties/against_witness.hpp"
#include "tests/support/kinds_of_scenes.hpp"
#include "tests/support/named_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

constexpr std::uint64_t seed_of_energies = 20266;

// Work and forces of a motion at evenly spaced instants, from what each does at every instant.
struct Quadrature {
    double contact = 0, dampers = 0, load = 0, on_base = 0, work_of_base = 0;
};

// Motion of the base or wall in the frame of the displacements.
double motion_of_base(const Scene<double>& scene) {
    const BaseMotion base = scene.system.base_motion;
    return base == BaseMotion::alone ? 1 : base == BaseMotion::wall ? -1 : 0;
}

// Sums over instants tau of a whole period of the force, or of several; `p` has M, C and K of (12), r included.
Quadrature quadrature(const HalfPeriodProblem<Real50>& p, const Scene<double>& scene, const SampledSolution& motion) {
    const std::size_t count = motion.tau.size();
    const double d = motion_of_base(scene), h = 2 * pi<double>() / static_cast<double>(count);
    const auto N = static_cast<Eigen::Index>(number_of_masses(scene.system));
    const Vector<double> w = contact_vector(p).cast<double>(), one = Vector<double>::Ones(N);
    const Vector<double> load = load_vector(p).cast<double>(), ahead = leading_load(p).cast<double>();
    const Matrix<double> C = p.C.cast<double>(), K = p.K.cast<double>();
    Quadrature q;
    for (std::size_t n = 0; n < count; ++n) {
        const double c = std::cos(motion.tau[n]), s = std::sin(motion.tau[n]);
        const State state = motion.at(n);
        const Vector<double> x = Eigen::Map<const Vector<double>>(state.x.data(), N),
                             v = Eigen::Map<const Vector<double>>(state.x_prime.data(), N);
        const Vector<double> strain = x - d * c * one, rate = v + d * s * one;
        q.contact += h * *scene.beta * std::abs(w.dot(v));
        q.dampers += h * rate.dot(C * rate);
        q.load += h * v.dot(load * c - ahead * s);
        const double force = one.dot(K * strain + C * rate);
        q.on_base = std::max(q.on_base, std::abs(force));
        q.work_of_base += h * force * d * s; // - force times the velocity -d sin of the base
    }
    return q;
}

// Compares with a quadrature, whose error is a part of the largest energy and force.
void check_energies(const Energies& e, const Quadrature& q, double error) {
    const double size = std::abs(q.contact) + std::abs(q.dampers);
    CHECK(std::abs(e.contact.value - q.contact) <= error * size + e.contact.error);
    CHECK(std::abs(e.dampers.value - q.dampers) <= error * size + e.dampers.error);
    CHECK(e.on_base.value >= q.on_base * (1 - error));
    CHECK(e.on_base.value <= q.on_base * (1 + 20 * error) + 20 * error);
}

// Energies of scenes at their fraction of the boundary of sliding and at multiples of it, by samples of the motion. How many motions
// of each regime were compared.
std::array<int, 3> compare_energies(const std::vector<RandomScene<double>>& scenes, std::size_t every) {
    constexpr std::size_t samples = 20000;
    std::array<int, 3> compared{};
    for (std::size_t n = 0; n < scenes.size(); n += every)
        for (const double times : {1.0, 3.0, 60.0}) {
            Scene<double> scene = scenes[n].scene;
            if (number_of_masses(scene.system) > 5) continue;
            INFO(scenes[n].name << " times " << times);
            try {
                scene.beta = friction_ratio_at(scenes[n].fraction_of_limit, boundary(scene, 6).exact.value) * times;
                const Solution s = solve(scene);
                const Energies e = energies(scene);
                const std::size_t periods = static_cast<std::size_t>(s.periods);
                Quadrature q = quadrature(half_period_problem(scene), scene, motion(scene, samples * periods));
                CHECK(e.contact.proved);
                CHECK(e.contact.value >= 0);
                check_energies(e, q, 1e-5);
                // The energy that goes in comes out again.
                const double in = (motion_of_base(scene) == 0 ? q.load : 0);
                if (motion_of_base(scene) == 0) CHECK(e.contact.value + e.dampers.value == Approx(in).epsilon(1e-5).margin(1e-7));
                if (motion_of_base(scene) == 1)
                    CHECK(e.contact.value + e.dampers.value == Approx(q.work_of_base).epsilon(1e-4).margin(1e-6));
                ++compared[static_cast<std::size_t>(s.regime.regime)];
            } catch (const PrecisionError&) {
                continue;
            } catch (const DomainError&) {
                continue;
            }
        }
    return compared;
}

} // namespace

TEST_CASE("energies and forces are those of quadratures along the motion, in every regime", "[energy]") {
    const std::array<int, 3> compared = compare_energies(random_phased_scenes(seed_of_energies), 101);
    CHECK(compared[0] >= 1);
    CHECK(compared[1] + compared[2] >= 2);
}

TEST_CASE("on moving bases and walls dampers are strained by the motion of the base as well", "[energy][base]") {
    const std::array<int, 3> compared = compare_energies(random_base_scenes(seed_of_energies), 101);
    CHECK(compared[0] >= 1);
    CHECK(compared[1] + compared[2] >= 2);
}

TEST_CASE("energies of many random scenes are those of quadratures", "[.][sweep][energy]") {
    for (const auto& scenes : {random_phased_scenes(seed_of_energies + 1), random_base_scenes(seed_of_energies + 1)}) {
        const std::array<int, 3> compared = compare_energies(scenes, 3);
        CHECK(compared[0] > 30);
        CHECK(compared[1] > 5);
        CHECK(compared[2] > 10);
    }
}

TEST_CASE("the dampers' energy of the half-period problem is that of the balance to 12 digits", "[energy][witness]") {
    int compared = 0;
    for (const RandomScene<double>& each : random_scenes<double>(seed_of_energies)) {
        if (++compared % 60 != 0) continue;
        Scene<double> scene = each.scene;
        INFO(each.name);
        scene.beta = friction_ratio_at(each.fraction_of_limit, boundary(scene, 6).exact.value);
        const HalfPeriodProblem<Real50> problem = half_period_problem(scene);
        constexpr int steps = 512; // of Boole's rule
        const HalfPeriodMotion<Real50> w = half_period_motion(problem, steps);
        Real50 dampers(0);
        for (int n = 0; n <= steps; ++n) {
            const Vector<Real50> v = w.x_prime.col(n);
            const int weight = n == 0 || n == steps ? 7 : n % 2 == 1 ? 32 : n % 4 == 2 ? 12 : 14;
            dampers += weight * v.dot(problem.C * v);
        }
        dampers *= 2 * Real50(4) / 90 * pi<Real50>() / steps;
        const Energies e = energies(scene, 13);
        CHECK(std::abs(e.dampers.value - static_cast<double>(dampers)) <=
              1e-12 * (e.contact.value + e.dampers.value) + 1e-9 * e.dampers.value);
        CHECK(e.contact.value ==
              Approx(4 * *scene.beta * static_cast<double>(w.amplitude(static_cast<Eigen::Index>(scene.system.contact.index))))
                  .epsilon(1e-12));
    }
}

TEST_CASE("one mass without damping: 4 F X, and the textbooks' amplitude", "[energy]") {
    const double r = 1.75, beta = 0.25;
    Scene<double> at = named_scene(R"(undamped {"r": 1.75, "beta": 0.25})");
    const double X = solve(at, {Asked::motion, 14}).masses.front().amplitude.value;
    const Energies e = energies(at, 14);
    CHECK(e.contact.value == Approx(4 * beta * X).epsilon(1e-13));
    CHECK(std::abs(e.dampers.value) <= e.dampers.error);
    CHECK(e.on_base.value == Approx(X).epsilon(1e-13)); // the spring's force is largest where the mass is
    CHECK(e.friction.value == beta);
    const EquivalentDamping& c = e.equivalent.value();
    CHECK(c.coefficient.value == Approx(4 * beta / (pi<double>() * r * X)).epsilon(1e-13));
    CHECK(c.ratio.value == Approx(c.coefficient.value / 2).epsilon(1e-13));
    // Rao, Mechanical Vibrations: X = P / k sqrt(1 - (4 F / (pi P))^2) / |1 - r^2|.
    const double b = 4 * beta / pi<double>(), textbook = std::sqrt(1 - b * b) / std::abs(1 - r * r);
    CHECK(c.textbook_amplitude.value().value == Approx(textbook).epsilon(1e-13));
    CHECK(c.textbook_amplitude_error.value().value == Approx(textbook / X - 1).epsilon(1e-11));
    at.beta = 0.8; // beyond pi / 4 the formula has no amplitude
    CHECK_FALSE(energies(at).equivalent.value().textbook_amplitude);
}

TEST_CASE("a contact that rests dissipates nothing, and takes up the force that holds it", "[energy]") {
    const Scene<double> at = named_scene(R"(loaded beyond {"r": 0.5, "beta": 9, "mu": 1})");
    const Energies e = energies(at);
    CHECK(e.contact.value == 0);
    CHECK_FALSE(e.equivalent);
    CHECK(e.dampers.value > 0);
    CHECK(e.friction.value == Approx(boundary(at).sticking.value().value).epsilon(1e-6)); // at mu = 1
}

TEST_CASE("energies grow to any number of digits, and those of fewer lie within their bounds", "[energy]") {
    const Scene<double> at = named_scene("loaded beyond");
    const Energies few = energies(at), many = energies(at, 40);
    CHECK(many.contact.decimal.size() >= 40);
    for (const auto& [a, b] : {std::pair{few.contact, many.contact}, {few.dampers, many.dampers}, {few.on_base, many.on_base}})
        CHECK(std::abs(a.value - b.value) <= a.error + b.error + 1e-15 * std::abs(a.value));
}

TEST_CASE("energies of an answer that is no whole motion are refused", "[energy][bad-input]") {
    const SceneSource source = scene_source(named_scene(R"(loaded beyond {"r": 0.5, "beta": 0.1, "mu": 1})"));
    Question of_one;
    of_one.mass = Mass{1};
    for (const Question& question : {Question{Asked::amplitude, {}}, Question{Asked::regime, {}}, of_one})
        CHECK_THROWS_AS(energies(source, solve(source, question)), InputError);
}

TEST_CASE("energies are not those of another motion than that of the answer", "[energy][twin]") {
    const SceneSource sticks = scene_source(named_scene("loaded beyond"));
    const Solution right = solve(sticks, {});
    REQUIRE(right.regime.regime == Regime::stick_slip);
    CHECK(energies(sticks, right).contact.proved);
    Solution wrong = right;
    wrong.masses.front().amplitude.value *= 1.001;
    CHECK_THROWS_AS(energies(sticks, wrong), PrecisionError);
    wrong = right;
    wrong.stops.pop_back();
    CHECK_THROWS_AS(energies(sticks, wrong), PrecisionError);
    wrong = right;
    wrong.start.reset(); // as if it slid throughout
    CHECK_THROWS_AS(energies(sticks, wrong), PrecisionError);
}
