#include <cmath>

#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/model/coupled_motion.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "tests/catch.hpp"
#include "tests/support/half_period.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/scene_builder.hpp"

using namespace denhartog;

namespace {

System<double> one_mass(double zeta) { return chain_of({1}, {1}, zeta); }

System<double> three_masses() { return chain_of({1, 2.5, 0.75}, {1, 0.625, 1.875}, {0.03, 0.06, 0.09}, 2, 1); }

} // namespace

TEST_CASE("a mass pulled from rest by more than static friction slides, sticks and slides on", "[unit][exact-solver]") {
    const ContactSystem system = contact_system(one_mass(0.01));
    ExactSolver solver(system, {0.1, 0.2, 1.0});
    const ExactMotion& motion = solver.run(at_rest(1), 0.0, 2 * pi<double>());
    REQUIRE(motion.status == MotionStatus::complete);
    CHECK(motion.phases.front().direction == 1);
    CHECK(motion.phases.front().start == 0);
    CHECK(motion.phases.back().end == 2 * pi<double>());
    int stops = 0;
    for (std::size_t n = 0; n < motion.phases.size(); ++n) {
        CHECK(motion.phases[n].end > motion.phases[n].start);
        if (n > 0) CHECK(motion.phases[n].start == motion.phases[n - 1].end);
        stops += motion.phases[n].direction == 0;
    }
    CHECK(stops >= 4);
}

TEST_CASE("while it sticks the contact carries no more than static friction, and just that when it leaves",
          "[unit][exact-solver][eq:74][eq:75]") {
    const System<double> s = three_masses();
    const ContactSystem system = contact_system(s);
    const double beta = 0.2, mu = 1.25, r = 0.15;
    ExactSolver solver(system, {r, beta, mu});
    const ExactMotion motion = solver.run(at_rest(3), 0.0, 12 * pi<double>());
    const NonDimensionalMatrices m = non_dimensional_matrices(s, system.basis, r);
    int departures = 0;
    for (std::size_t n = 0; n + 1 < motion.phases.size(); ++n) {
        const Phase& p = motion.phases[n];
        if (p.direction != 0) continue;
        const auto load = [&](double tau) {
            const State z = solver.state_at(n, tau);
            double sum = s.load == s.contact ? std::cos(tau) : 0;
            for (Eigen::Index k = 0; k < 3; ++k)
                sum -= m.C(1, k) * z.x_prime[static_cast<std::size_t>(k)] + m.K(1, k) * z.x[static_cast<std::size_t>(k)];
            return sum;
        };
        for (int i = 0; i <= 100; ++i) CHECK(std::abs(load(p.start + (p.end - p.start) * i / 100)) <= mu * beta + 1e-13);
        CHECK(std::abs(std::abs(load(p.end)) - mu * beta) <= 1e-13);
        CHECK(motion.phases[n + 1].direction * load(p.end) > 0);
        ++departures;
    }
    CHECK(departures >= 3);
}

TEST_CASE("the largest displacements are those of a dense sample", "[unit][exact-solver]") {
    const ContactSystem system = contact_system(three_masses());
    ExactSolver solver(system, {0.3, 0.4, 1.25});
    const ExactMotion motion = solver.run(at_rest(3), 0.0, 4 * pi<double>());
    const std::vector<Extremum> largest = solver.largest_displacements();
    std::vector<double> sampled(3, 0);
    for (std::size_t n = 0; n < motion.phases.size(); ++n) {
        const Phase& p = motion.phases[n];
        for (int i = 0; i <= 4000; ++i) {
            const State z = solver.state_at(n, p.start + (p.end - p.start) * i / 4000);
            for (std::size_t k = 0; k < 3; ++k) sampled[k] = std::max(sampled[k], std::abs(z.x[k]));
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(std::abs(largest[k].x) >= sampled[k] * (1 - 1e-14));
        CHECK(std::abs(largest[k].x) <= sampled[k] * (1 + 1e-5));
    }
}

TEST_CASE("the exact solver names the quantity, the rule and the value of bad input", "[unit][exact-solver][bad-input]") {
    const ContactSystem system = contact_system(one_mass(0.01));
    using Solver = ExactSolver;
    CHECK_THROWS_WITH(Solver(system, {0.0, 0.2, 1.0}), Catch::Contains("r must be positive"));
    CHECK_THROWS_WITH(Solver(system, {1.0, -0.2, 1.0}), Catch::Contains("beta must be zero or positive"));
    CHECK_THROWS_WITH(Solver(system, {1.0, 0.2, 0.5}), Catch::Contains("mu must be at least 1"));
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, -0.25}) {
        CHECK_THROWS_AS(Solver(system, {bad, 0.2, 1.0}), InputError);
        CHECK_THROWS_AS(Solver(system, {1.0, bad, 1.0}), InputError);
        CHECK_THROWS_AS(Solver(system, {1.0, 0.2, bad}), InputError);
    }
    Solver solver(system, {1.0, 0.2, 1.0});
    CHECK_THROWS_AS(solver.run(at_rest(2), 0.0, 1.0), InputError);
}

TEST_CASE("coupled coordinates move as the exponential of their matrix, with short steps and with long ones",
          "[model][coupled_damping]") {
    // y'' + 0.5 y' + 16 y = 0 and z'' + 0.5 z' + z / 4 = 0 in the coordinates y + z / 2 and z.
    const Matrix<double> A{{0, 0, 1, 0}, {0, 0, 0, 1}, {-16, 7.875, -0.5, 0}, {0, -0.25, 0, -0.5}};
    const double rate = 4.5;
    const Column start{{0, -2, 0.625, 0.25}};
    for (const auto asked : {CoupledMotion::Asked::instants_of_one_start, CoupledMotion::Asked::many_starts}) {
        CoupledMotion motion(A, rate, asked, nullptr), another = motion;
        motion.start(start);
        another.start(start);
        (void)another.at(0.3);
        another.start(-2 * start); // nothing is left of the start before
        for (const double t : {0.0, 0.001, 0.3, 0.31, 2.5, 0.3, 7.0, 40.0}) {
            INFO("t = " << t << ", many starts: " << (asked == CoupledMotion::Asked::many_starts));
            const Column expected = matrix_exponential(Matrix<Real50>(A.cast<Real50>() * Real50(t))).cast<double>() * start;
            const double allowed = 64 * (1 + t * rate) * 0x1p-53;
            CHECK((motion.at(t) - expected).cwiseAbs().maxCoeff() <= allowed);
            CHECK((motion.carried(t, Matrix<double>(start)).col(0) - expected).cwiseAbs().maxCoeff() <= allowed);
            CHECK(another.at(t) == -2 * motion.at(t));
        }
    }
}

TEST_CASE("over half a period a mirrored system grows as its motion does", "[model][coupled_damping]") {
    // Two oscillators in energy coordinates, their damping coupled; at the last rate half a period holds no whole step.
    Matrix<double> A(4, 4);
    A << 0, 0, 1.3, 0.2, 0, 0, 0.1, 0.7, -1.3, -0.1, -0.3, 0.1, -0.2, -0.7, 0.1, -0.4;
    const double allowed = 4096 * std::numeric_limits<double>::epsilon();
    for (const double rate : {100.0, 4.0, 2.5, 0.25}) {
        INFO("rate " << rate);
        const Matrix<double> slowed = A / std::max(1.0, 1 / rate), unit = Matrix<double>::Identity(4, 4);
        const Matrix<double> truth = matrix_exponential(Matrix<Real50>(slowed.cast<Real50>() * pi<Real50>())).cast<double>();
        CoupledMotion motion(slowed, rate, CoupledMotion::Asked::instants_of_one_start, nullptr);
        CoupledMotion otherwise(slowed, 3 * rate, CoupledMotion::Asked::many_starts, nullptr);
        CHECK((otherwise.carried(pi<double>(), unit) - truth).cwiseAbs().maxCoeff() < allowed);
        CHECK((unit + motion.growth_over_half_period() - truth).cwiseAbs().maxCoeff() < allowed);
        motion.start(unit.col(1));
        CHECK((motion.at(pi<double>()) - truth.col(1)).cwiseAbs().maxCoeff() < allowed);
    }
}

TEST_CASE("the products that coupled motions form are paid for, and end where nothing is left to pay", "[model][effort]") {
    const Matrix<double> unit = Matrix<double>::Identity(40, 40), A = Matrix<double>::Constant(40, 40, 0.1) - 4 * unit;
    Effort allowed{400};
    Effort* const paying = &allowed;
    CoupledMotion motion(A, 8, CoupledMotion::Asked::many_starts, &paying);
    CHECK_THROWS_AS(motion.carried(40, unit), PrecisionError);
    CHECK(allowed.spent > 400);
    CHECK(allowed.spent < 600); // a product more than was allowed, and no further
    const long spent = allowed.spent;
    motion.pay_no_more();
    CHECK_NOTHROW(motion.carried(40, unit));
    CHECK(allowed.spent == spent);
}

// The history of a motion: its last period is that of `exact_cycles`, its stops those of the paper's algorithm, period by period.

namespace {

Scene<double> stopping_scene() { return {chain_of({1, 0.75}, {1, 1.5}, 0.0625, 1, 2), 1.125, 0.4375, 0.375, {}, {}}; }

} // namespace

TEST_CASE("the last periods of a history are the end of the whole one, and the last is that of the exact solver", "[history]") {
    const SceneSource source = scene_source(stopping_scene());
    HistorySettings settings;
    settings.cycles = 9;
    settings.samples = 32;
    settings.start = {{1, -0.5}, {0.25, 0}};
    const MotionHistory all = motion_history(source, settings);
    settings.last = 3;
    const MotionHistory last = motion_history(source, settings);
    REQUIRE(all.states.size() == 9 * 32);
    REQUIRE(last.states.size() == 3 * 32);
    CHECK(all.from == 0);
    CHECK(last.from == Approx(12 * pi<double>()));
    for (std::size_t n = 0; n < last.states.size(); ++n) {
        const std::size_t of_all = n + 6 * 32;
        CHECK(last.times[n] == Approx(all.times[of_all]).epsilon(1e-14));
        for (std::size_t k = 0; k < 2; ++k) CHECK(last.states[n].x[k] == Approx(all.states[of_all].x[k]).margin(1e-11));
        CHECK((last.directions[n] == 0) == (last.states[n].x_prime[0] == 0));
        if (last.directions[n] != 0) CHECK(last.directions[n] * last.states[n].x_prime[0] > -1e-12);
    }
    PaperSettings cycles;
    cycles.cycles = 9;
    cycles.samples = 32;
    cycles.start = settings.start;
    const PaperMotion period = exact_cycles(source, cycles);
    for (std::size_t n = 0; n < 32; ++n)
        for (std::size_t k = 0; k < 2; ++k) CHECK(last.states[n + 64].x[k] == Approx(period.samples[n].x[k]).margin(1e-11));
    // Every stop of the last periods is a stop of all, with its own start.
    REQUIRE(last.stops.size() <= all.stops.size());
    CHECK(last.stops.size() > 3);
    for (std::size_t n = 0; n < last.stops.size(); ++n) {
        const HistoryStop &a = last.stops[last.stops.size() - 1 - n], &b = all.stops[all.stops.size() - 1 - n];
        CHECK(a.start == Approx(b.start).margin(1e-10));
        CHECK(a.end.has_value() == b.end.has_value());
        CHECK(a.x == Approx(b.x).margin(1e-10));
    }
}

TEST_CASE("the stops of a history are as many in each period as the paper's algorithm counts", "[history][paper-algorithm]") {
    HistorySettings settings;
    settings.cycles = 12;
    settings.start = at_rest(2);
    const MotionHistory history = motion_history(scene_source(stopping_scene()), settings);
    PaperSettings paper;
    paper.cycles = 12;
    paper.absolute_tolerance = 1e-10;
    paper.history = true;
    const PaperMotion motion = paper_algorithm(stopping_scene(), paper);
    std::vector<int> ends(12);
    for (const HistoryStop& stop : history.stops)
        if (stop.end) ++ends[static_cast<std::size_t>(*stop.end / (2 * pi<double>()))];
    for (std::size_t n = 0; n < 12; ++n) CHECK(ends[n] == motion.history[n].stops);
}

TEST_CASE("a contact that rests from before the history on has one stop, which began then and does not end", "[history]") {
    Scene<double> scene = stopping_scene();
    scene.beta = 4;
    HistorySettings settings;
    settings.cycles = 20;
    settings.last = 2;
    settings.start = {{6, 0}, {0, 0}};
    const MotionHistory history = motion_history(scene_source(scene), settings);
    REQUIRE(history.stops.size() == 1);
    CHECK(history.stops[0].start < history.from);
    CHECK_FALSE(history.stops[0].end.has_value());
    settings.without_load = true; // then the stop and its place are those of the free motion
    const MotionHistory free = motion_history(scene_source(scene), settings);
    REQUIRE(free.stops.size() == 1);
    CHECK(std::abs(free.stops[0].x) <= 4.5);
}

TEST_CASE("a history of no period, of more than there are, or of a broken start is refused", "[history][bad-input]") {
    const SceneSource source = scene_source(stopping_scene());
    const auto quantity = [&](auto change) {
        HistorySettings settings;
        settings.start = at_rest(2);
        settings.cycles = 5;
        change(settings);
        try {
            (void)motion_history(source, settings);
        } catch (const InputError& e) {
            return e.quantity;
        }
        return std::string("none");
    };
    CHECK(quantity([](HistorySettings&) {}) == "none");
    CHECK(quantity([](HistorySettings& s) { s.last = 0; }) == "history");
    CHECK(quantity([](HistorySettings& s) { s.last = -1; }) == "history");
    CHECK(quantity([](HistorySettings& s) { s.last = 6; }) == "history");
    CHECK(quantity([](HistorySettings& s) { s.cycles = 0; }) == "cycles");
    CHECK(quantity([](HistorySettings& s) { s.samples = -1; }) == "samples");
    CHECK(quantity([](HistorySettings& s) { s.samples = 2000000000; }) == "samples");
    CHECK(quantity([](HistorySettings& s) { s.start.x = {1}; }) == "start");
    CHECK(quantity([](HistorySettings& s) { s.start.x[0] = std::nan(""); }) == "start");
}
