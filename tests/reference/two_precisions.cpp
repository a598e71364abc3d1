// Double, then the reference: what double leaves open is answered, or refused with the reasons of both.
#include "denhartog/map/regime_map.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/reference/friction.hpp"
#include "denhartog/reference/series.hpp"
#include "denhartog/solve/decision.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"

#include <atomic>
#include <cmath>
#include <limits>

using namespace denhartog;

namespace {

SceneSource scene_of(const char* text) { return scene_source(SceneText{text}); }

constexpr const char* grazing =
    R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": "0.12241850185925754", "contact": 1, "load": 1,
        "r": "0.71137953845462243", "beta": "0.552171582623112"})";

// Sticking for ever begins a last digit above.
constexpr const char* nearly_held = R"({"mass_ratios": [1, 0.75446287041036153, 0.90910697215540848, 0.56008440847893404],
    "stiffness_ratios": [1, 0.73985774937320514, 0.98323358945340977, 0.50054355969969855],
    "damping_ratios": [0.00020898467548437081, 0.010192329563089624, 0.39273080301693275, 6.4521664879332649e-05],
    "contact": 1, "load": 2, "r": 0.46925342893654237, "beta": 14.109761636448946})";

std::string coupled(const std::string& tolerance) {
    return R"({"mass_ratios": [1, 1.5], "stiffness_ratios": [1, 0.8], "damping_matrix": [[0.3, -0.05], [-0.05, 0.1]],
        "damping_tolerance": )" +
           tolerance + R"(, "contact": 2, "load": 1, "r": 0.9, "beta": 0.05})";
}

} // namespace

TEST_CASE("a last digit above the boundary the stops are proved, of some 1e-15 of a radian", "[reference][orbit][eq:69]") {
    for (const int digits : {6, 12, 30}) {
        const Solution s = solve(scene_of(grazing), {Asked::motion, digits});
        CHECK(s.regime.regime == Regime::stick_slip);
        CHECK(s.method.proved);
        REQUIRE(s.stops.size() == 2);
        const double lasts = s.stops[0].end.value - s.stops[0].start.value;
        CHECK(lasts > 1e-15);
        CHECK(lasts < 1e-14);
    }
    // A last digit below it the contact slides.
    std::string below = grazing;
    below.replace(below.find("3112"), 4, "3110");
    CHECK(solve(scene_of(below.c_str()), {Asked::motion, 12}).regime.regime == Regime::continuous);
}

TEST_CASE("a motion that no proof reaches is refused with the regime that is certain", "[reference][driver]") {
    CHECK(solve(scene_of(nearly_held), {Asked::regime, 12}).regime.regime == Regime::stick_slip);
    CHECK_THROWS_AS(solve(scene_of(nearly_held), {Asked::motion, 20}), PrecisionError);
    CHECK_THROWS_WITH(solve(scene_of(nearly_held), {Asked::motion, {}}),
                      Catch::Contains("no motion with stops to start from. This much is certain: the closed form does not hold"));
}

TEST_CASE("modes of one frequency have no boundary in double, and with mu above 1 the reference proves what follows from rest",
          "[reference][driver][map]") {
    const std::string system = R"({"mass_ratios": [1, 1, 1], "stiffness_matrix": [[3, -1, -1], [-1, 3, -1], [-1, -1, 3]],
        "damping_ratios": 0.05, "contact": 1, "load": 2, "mu": 1.2)";
    const auto answer = [&](const char* beta) {
        return solve(scene_of((system + R"(, "r": 1.3, "beta": )" + beta + "}").c_str()), {Asked::motion, {}});
    };
    const Solution slides = answer("0.3"), stops = answer("1");
    CHECK(slides.regime.regime == Regime::continuous);
    CHECK(stops.regime.regime == Regime::stick_slip);
    CHECK(stops.stops.size() == 2);
    CHECK(answer("3").regime.regime == Regime::permanent_sticking);
    for (const Solution* s : {&slides, &stops}) {
        CHECK(s->method.proved);
        CHECK(s->limits.value().exact.value == Approx(0.617707853387));
    }
    for (const MapStart start : {MapStart::rest, MapStart::sliding}) {
        MapRequest request;
        request.r = {1.3};
        request.beta = {0.3, 1};
        request.masses = {Mass{0}};
        request.start = start;
        const std::atomic<bool> stop{false};
        const RegimeMap map = regime_map(scene_of((system + "}").c_str())->in_double(), request, stop);
        CHECK(map.points[0].status == PointStatus::answered);
        CHECK(map.amplitudes[0] == Approx(slides.masses[0].amplitude.value));
        CHECK(map.points[1].status == (start == MapStart::rest ? PointStatus::answered : PointStatus::failed));
    }
}

TEST_CASE("(56) of a damping matrix next to a modal one is that of the modes, in double and by the reference",
          "[reference][eq:56]") {
    const auto limits = [](const char* entry, bool proved) {
        const std::string text = std::string(R"({"mass_ratios": [1, 0.8], "stiffness_ratios": [1, 0.9], "contact": 2, "load": 1,
            "r": 0.6, "damping_matrix": [[)") +
                                 entry + R"(, -0.027], [-0.027, 0.067]]})";
        return sliding_answer(scene_of(text.c_str()), std::nullopt, proved).limits.value();
    };
    const double modal = limits("0.107", false).paper.value, exact = limits("0.107", false).exact.value;
    CHECK(modal < 0.99 * exact);
    for (const char* entry : {"0.10700000000000108", "0.107000000001", "0.10700000107"}) {
        INFO(entry);
        const Limits few = limits(entry, false), many = limits(entry, true);
        CHECK(std::abs(few.paper.value - many.paper.value) <= few.paper.error + many.paper.error);
        CHECK(many.paper.value == Approx(modal).epsilon(1e-6));
    }
    const SceneSource overdamped = scene_of(R"({"mass_ratios": [1, 1.75], "stiffness_matrix": [[2, -1], [-1, 1]], "contact": 1,
        "load": 1, "r": 4.16, "mu": 1.3, "damping_matrix": [[1.6, -0.30000000022448803], [-0.30000000022448803, 2.05]]})");
    const Limits few = sliding_answer(overdamped, std::nullopt, false).limits.value(),
                 many = sliding_answer(overdamped, std::nullopt, true).limits.value();
    CHECK(std::abs(few.paper.value - many.paper.value) <= few.paper.error + many.paper.error);
    const Limits couples = limits("0.1071", false); // no mode moves by itself
    CHECK(couples.paper.value == couples.exact.value);
    CHECK(limits("0.1071", true).paper.value == limits("0.1071", true).exact.value);
    const SceneSource with_friction = scene_of(R"({"mass_ratios": [1, 0.8], "stiffness_ratios": [1, 0.9], "contact": 2, "load": 1,
        "r": 0.6, "beta": 0.01, "damping_matrix": [[0.10700000107, -0.027], [-0.027, 0.067]]})");
    for (const Asked asked : {Asked::amplitude, Asked::motion}) { // whatever is asked
        const Solution s = solve(with_friction, {asked, std::nullopt});
        CHECK(s.method.precision == "double");
        CHECK(s.limits.value().paper.value == Approx(modal).epsilon(1e-6));
    }
}

TEST_CASE("a damping matrix counts as modal within its tolerance, to any digits", "[reference][eq:18]") {
    const auto amplitude = [](const std::string& tolerance, int digits) {
        return solve(scene_of(coupled(tolerance).c_str()), {Asked::motion, digits}).masses[1].amplitude.value;
    };
    // How far K M^-1 C is from C M^-1 K over the sizes of both is 0.218.
    CHECK(amplitude("0.5", 6) == Approx(amplitude("0.5", 30)).epsilon(1e-12));
    CHECK(amplitude("0.5", 30) == Approx(amplitude("2", 30)).epsilon(1e-15));
    CHECK(amplitude("0.01", 6) == Approx(amplitude("0.01", 30)).epsilon(1e-12));
    CHECK(amplitude("0.01", 30) == Approx(amplitude("0", 30)).epsilon(1e-15));
    CHECK(std::abs(amplitude("0", 30) - amplitude("2", 30)) > 1e-6);
}

TEST_CASE("far above the resonances an overdamped mode takes the bits that show its demand", "[reference][eq:56][eq:69]") {
    // (56) and (69) of one mode are one number.
    for (const char* r : {"1e5", "1e20", "1e50", "1e150"}) {
        const std::string scene =
            std::string(
                R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 32879.2, "contact": 1, "load": 1, "r": )") +
            r + "}";
        const Limits limits = sliding_answer(scene_of(scene.c_str()), 20, true).limits.value();
        CHECK(limits.exact.decimal == limits.paper.decimal);
        CHECK(limits.exact.value > 0);
    }
}

TEST_CASE("an amplitude below all doubles is zero to within the least of them, or text", "[reference][driver]") {
    const SceneSource far = scene_of(R"({"mass_ratios": [1, 1], "stiffness_ratios": [1, 1], "damping_ratios": 0.1, "contact": 1,
        "load": 2, "r": 1e120, "beta": 0})");
    const Solution few = solve(far, {Asked::motion, {}}), more = solve(far, {Asked::motion, 20});
    CHECK(few.masses[0].amplitude.value == 0);
    CHECK(few.masses[0].amplitude.error == std::numeric_limits<double>::denorm_min());
    CHECK(more.masses[0].amplitude.decimal.ends_with("e-362"));
}

TEST_CASE("first and third derivative of a friction motion add up to what the equation of motion says, and no other does",
          "[reference][eq:41]") {
    const Bits enough(256);
    for (const auto& [R, zeta] : {std::pair(1.0, 0x1p-20), {1 + 0x1p-20, 0x1p-10}, {0.375, 0.25}, {5.0, 0.5}}) {
        const reference::FrictionMotionOfMode mode{Ball(R), Ball(zeta)}, other{Ball(R), Ball(zeta * (1 + 0x1p-10))};
        for (const double tau : {0.25, 1.5, 3.0}) {
            const reference::Series F = mode.at(Ball(tau)), sum = mode.rate_and_third(F);
            const Ball direct = F.c[1] + 6 * F.c[3];
            INFO("R = " << R << ", zeta = " << zeta << ", tau = " << tau);
            CHECK(arb_overlaps(sum.c[0].a, direct.a) != 0);
            CHECK(arb_overlaps(sum.c[1].a, Ball(2 * F.c[2] + 24 * F.c[4]).a) != 0);
            CHECK(arb_overlaps(other.rate_and_third(F).c[0].a, direct.a) == 0);
        }
    }
}

TEST_CASE("the largest value of a quotient is the same with n'' + n given, and a wrong one is found out", "[reference][eq:69]") {
    const Bits enough(256);
    const reference::FrictionMotionOfMode mode{Ball(0.75), Ball(0.0625)};
    const auto n = [&](const Ball& tau) {
        return reference::Series(mode.u) * cos(reference::Series::time(tau)) + mode.at(tau).derivative();
    };
    const auto Z = [&](const Ball& tau) { return mode.rate_and_third(mode.at(tau)); };
    const Ball largest = reference::largest_over_sine(n).value;
    CHECK(arb_overlaps(reference::largest_over_sine(n, Z).value.a, largest.a) != 0);
    bool agrees = false;
    try {
        const auto wrong = [&](const Ball& tau) { return -Z(tau); };
        agrees = arb_overlaps(reference::largest_over_sine(n, wrong).value.a, largest.a) != 0;
    } catch (const reference::Unproved&) {
    }
    CHECK_FALSE(agrees);
}
