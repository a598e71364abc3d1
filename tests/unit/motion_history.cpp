// The history of a motion: its last period is that of `exact_cycles`, its stops those of the paper's algorithm, period by period.
#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/support/scene_builder.hpp"

using namespace denhartog;

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
