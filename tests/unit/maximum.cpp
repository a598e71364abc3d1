#include "denhartog/search/largest.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/search/zeros.hpp"
#include "tests/catch.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

/// f with w = f', z = f'' and a bound of |f'''|.
Curve smooth(std::function<double(double)> f, std::function<double(double)> w, std::function<double(double)> z, double rate) {
    return {[=](double tau) { return Sample{f(tau), w(tau), z(tau)}; }, [=](double, double) { return rate; }};
}

/// cos(w (t - shift)).
Curve cosine(double w, double shift = 0) {
    return smooth([=](double t) { return std::cos(w * (t - shift)); }, [=](double t) { return -w * std::sin(w * (t - shift)); },
                  [=](double t) { return -w * w * std::cos(w * (t - shift)); }, w * w * w);
}

/// cos t + a exp(-((t - c) / b)^2) with c off every dyadic grid; the peak is 1/4000 of [0, 3] wide.
Curve cosine_with_peak(double c) {
    const double a = 0.5, b = 1e-3;
    const auto bump = [=](double t) { return a * std::exp(-(t - c) / b * ((t - c) / b)); };
    const auto x = [=](double t) { return (t - c) / b; };
    return smooth([=](double t) { return std::cos(t) + bump(t); },
                  [=](double t) { return -std::sin(t) - 2 * x(t) / b * bump(t); },
                  [=](double t) { return -std::cos(t) + (4 * x(t) * x(t) - 2) / (b * b) * bump(t); }, 1 + 4 * a / (b * b * b));
}

} // namespace

TEST_CASE("the maximum of a cosine lies where it is known to, to all digits", "[maximum]") {
    const double shift = 5.0 / 7;
    const Maximum best = global_maximum(cosine(1, shift), 0, pi<double>());
    const double eps = std::numeric_limits<double>::epsilon();
    CHECK(std::abs(best.value - 1) <= 2 * eps);
    CHECK(std::abs(best.instant - shift) <= 4 * eps);
}

TEST_CASE("a maximum at an end of the interval is found", "[maximum]") {
    const Curve rising = smooth([](double t) { return std::exp(t); }, [](double t) { return std::exp(t); },
                                [](double t) { return std::exp(t); }, std::exp(2.0));
    CHECK(global_maximum(rising, 0.0, 2.0).instant == 2.0);
    CHECK(global_maximum(rising, 0.0, 2.0).value == std::exp(2.0));
    const Curve falling = smooth([](double t) { return std::exp(-t); }, [](double t) { return -std::exp(-t); },
                                 [](double t) { return std::exp(-t); }, 1.0);
    CHECK(global_maximum(falling, 0.0, 2.0).instant == 0.0);
}

TEST_CASE("a peak that is narrow between samples does not hide", "[maximum]") {
    const double c = 2.0 / 3;
    const Curve curve = cosine_with_peak(c);
    const auto bump = [=](double t) { return 0.5 * std::exp(-1e6 * (t - c) * (t - c)); };
    double sampled = 0, instant = 0;
    for (int n = -20000; n <= 20000; ++n) {
        const double t = c + n * 1e-7;
        if (std::cos(t) + bump(t) > sampled) sampled = std::cos(t) + bump(t), instant = t;
    }
    const Maximum best = global_maximum(curve, 0.0, 3.0);
    INFO("value " << hexadecimal(best.value) << " at " << hexadecimal(best.instant));
    CHECK(best.value >= sampled);
    CHECK(best.value - sampled < 1e-8);
    CHECK(std::abs(best.instant - instant) < 1e-7);
}

TEST_CASE("among many equal-looking peaks the highest is taken", "[maximum]") {
    // Peaks of cos(2000 t) under a parabola that is highest at 1.1.
    const auto top = [](double t) { return 1 - 1e-5 * (t - 1.1) * (t - 1.1); };
    const Curve curve = smooth([=](double t) { return top(t) + std::cos(2000 * t); },
                               [](double t) { return -2e-5 * (t - 1.1) - 2000 * std::sin(2000 * t); },
                               [](double t) { return -2e-5 - 4e6 * std::cos(2000 * t); }, 8e9);
    const Maximum best = global_maximum(curve, 0.0, 3.0);
    const double peak = 350 * pi<double>() / 1000; // the peak nearest to 1.1
    CHECK(std::abs(best.instant - peak) < 1e-7);
    CHECK(std::abs(best.value - (top(peak) + 1)) < 1e-14);
    CHECK(best.upper - best.value < 1e-14);
}

TEST_CASE("a search that does not settle ends in an error, not in an answer", "[maximum]") {
    const Curve flat = smooth([](double) { return 1.0; }, [](double) { return 0.0; }, [](double) { return 0.0; }, 1e30);
    CHECK_THROWS_AS(global_maximum(flat, 0.0, 1.0), PrecisionError);
}

TEST_CASE("a bracketed zero has all digits, whichever end it is looked for from", "[maximum]") {
    for (const int sign : {1, -1}) {
        const auto f = [&](double x) { return ValueAt{x, sign * (x * x - 2), sign * 2 * x}; };
        for (const double zero : {bracketed_zero(f, f(1), f(2)), bracketed_zero(f, f(2), f(1))})
            CHECK(std::abs(zero - std::sqrt(2.0)) <= 4 * std::numeric_limits<double>::epsilon());
    }
    const auto line = [](double x) { return ValueAt{x, x - 1, 1}; };
    CHECK(bracketed_zero(line, line(1), line(2)) == 1); // at an end
}

TEST_CASE("a bracketed zero is found however the slopes mislead", "[maximum]") {
    struct Misleading {
        const char* name;
        std::function<double(double)> f, slope;
        double error;
    };
    const std::vector<Misleading> all = {
        {"of no slope", [](double x) { return x; }, [](double) { return 0.0; }, 1e-15},
        {"of third order", [](double x) { return x * x * x; }, [](double x) { return 3 * x * x; }, 1e-14},
        {"steep in the middle", [](double x) { return std::atan(1e6 * x); }, [](double x) { return 1e6 / (1 + 1e12 * x * x); },
         1e-15},
        {"level before it", [](double x) { return x < 0 ? -1e-9 : x; }, [](double x) { return x < 0 ? 0.0 : 1.0; }, 1e-15},
        {"flat, then steep", [](double x) { return std::expm1(20 * x); }, [](double x) { return 20 * std::exp(20 * x); }, 1e-15}};
    for (const Misleading& each : all)
        for (const double far : {2.0, 30.0})
            for (const bool from_left : {true, false}) {
                int evaluations = 0;
                const auto f = [&](double x) {
                    ++evaluations;
                    return ValueAt{x, each.f(x - 1. / 3), each.slope(x - 1. / 3)};
                };
                const double zero = from_left ? bracketed_zero(f, f(-1), f(far)) : bracketed_zero(f, f(far), f(-1));
                INFO(each.name << " up to " << far << ": " << zero - 1. / 3 << ", " << evaluations << " evaluations");
                CHECK(std::abs(zero - 1. / 3) <= each.error);
                CHECK(evaluations <= 150);
            }
}

TEST_CASE("a search works on what is above the error of its samples and no further", "[maximum][effort]") {
    // A thousandth of a cosine, each sample off by up to 1e-9 with a sign that no search foresees.
    long samples = 0;
    const double noise = 1e-9;
    const auto off = [](double t) { return 1e-9 * std::sin(1e12 * t * t); };
    Curve curve = smooth(
        [&, off](double t) {
            ++samples;
            return 1e-3 * std::cos(t - 1) + off(t);
        },
        [off](double t) { return -1e-3 * std::sin(t - 1) + off(t); },
        [off](double t) { return -1e-3 * std::cos(t - 1) + off(t); }, 1e-3 + noise);
    Effort effort{1'000'000};
    const Maximum best = global_maximum(curve, 0.0, 3.0, noise, &effort);
    CHECK(best.settled);
    CHECK(best.value - noise <= 1e-3);
    CHECK(best.upper >= 1e-3);
    CHECK(best.upper <= 1e-3 + 4 * noise);
    CHECK(samples <= 100);
    CHECK(effort.spent == samples);
    REQUIRE(best.places.size() == 1);
    CHECK(best.places[0].from <= 1);
    CHECK(best.places[0].to >= 1);
    CHECK(best.places[0].to - best.places[0].from <= 3.0 / 4); // one of the first intervals: noise hides all within it
}

TEST_CASE("the bound of a largest value covers samples that are all too low", "[maximum]") {
    const double noise = 1e-9;
    const Curve curve = smooth([](double t) { return std::cos(t - 1) - 1e-9; }, [](double t) { return -std::sin(t - 1); },
                               [](double t) { return -std::cos(t - 1); }, 1);
    const Maximum best = global_maximum(curve, 0.0, 3.0, noise);
    CHECK(best.upper >= 1 - 1e-15);
    CHECK(best.upper <= 1 + 2 * noise);
}

TEST_CASE("a stretch that may be as high as the highest is looked into 256 times at most", "[maximum][effort]") {
    // Flat, its slope of a sign that no search foresees: no interval holds a larger value, and none becomes monotone.
    long samples = 0;
    const Curve flat = smooth(
        [&](double) {
            ++samples;
            return 1;
        },
        [](double t) { return 1e-9 * std::sin(1e12 * t * t); }, [](double) { return 0; }, 1e-9);
    Effort effort{1'000'000};
    const Maximum best = global_maximum(flat, 0.0, 3.0, 1e-6, &effort);
    CHECK(best.settled);
    CHECK(best.upper >= 1);
    CHECK(best.upper <= 1 + 4e-6);
    CHECK(effort.spent == samples);
    CHECK(samples > 2 * 256);
    CHECK(samples <= 2 * 256 + 50);
    REQUIRE(best.places.size() == 1);
    CHECK(best.places[0].from == 0);
    CHECK(best.places[0].to == 3);
    Effort little{200};
    CHECK(global_maximum(flat, 0.0, 3.0, 1e-6, &little).settled);
    CHECK(little.spent <= 202);
}

TEST_CASE("maxima that the samples do not tell apart are all listed", "[maximum]") {
    const Maximum best = global_maximum(cosine(6), 0.5, 4.0, 1e-12);
    REQUIRE(best.places.size() == 3);
    for (int n = 0; n < 3; ++n) {
        const Place& place = best.places[static_cast<std::size_t>(n)];
        CHECK(std::abs(place.instant - (n + 1) * pi<double>() / 3) < 1e-6);
        CHECK(place.from <= place.instant);
        CHECK(place.instant <= place.to);
        CHECK(place.value == Approx(1).epsilon(1e-12));
    }
}

TEST_CASE("a search whose effort is spent says what is certain until then", "[maximum][effort]") {
    const Curve curve =
        smooth([](double t) { return 1 + std::cos(1e6 * t) / 1e3; }, [](double t) { return -1e3 * std::sin(1e6 * t); },
               [](double t) { return -1e9 * std::cos(1e6 * t); }, 1e15);
    Effort effort{5000};
    const Maximum best = global_maximum(curve, 0.001, 1.0, 0.0, &effort);
    CHECK_FALSE(best.settled);
    CHECK(effort.exhausted());
    CHECK(effort.spent <= 5010);
    CHECK(best.value <= 1.001);
    CHECK(best.upper >= 1.001);
    const std::function<bool()> cancelled = [] { return true; };
    Effort from_outside;
    from_outside.cancelled = &cancelled;
    CHECK_FALSE(global_maximum(curve, 0.001, 1.0, 0.0, &from_outside).settled);
    CHECK(from_outside.spent <= 40);
}

TEST_CASE("where the effort is spent, bound and places hold a peak that no sample showed", "[maximum][effort]") {
    const double c = 2.0 / 3;
    const Curve curve = cosine_with_peak(c);
    for (const long most : {9, 10, 12, 16, 20}) {
        Effort effort{most};
        const Maximum best = global_maximum(curve, 0.0, 3.0, 0.0, &effort);
        INFO(effort.spent << " samples, " << best.value << " to " << best.upper << " in " << best.places.size() << " places");
        CHECK_FALSE(best.settled);
        CHECK(best.value == 1);
        CHECK(best.upper >= std::cos(c) + 0.5);
        CHECK(std::ranges::any_of(best.places, [c](const Place& p) { return p.from <= c && c <= p.to && p.upper >= 1; }));
    }
}

TEST_CASE("values that are known to be exceeded are passed over", "[maximum][effort]") {
    Effort effort;
    const Maximum best = global_maximum(cosine(6), 0.5, 4.0, 0.0, &effort, 2.0);
    CHECK(best.settled);
    CHECK(best.value == 2);
    CHECK(best.places.empty());
    CHECK(effort.spent <= 100);
}

TEST_CASE("where the terms of a curve cancel, the search ends at the error that their sum has", "[maximum][effort]") {
    // cos t - 2 cos(1 + e)t + cos(1 + 2e)t: e^2 beside terms of 1, as a mass far from the load among nearly equal ones.
    for (const double e : {1e-3, 1e-6, 1e-8, 1e-10}) {
        const std::array<std::array<double, 2>, 3> terms{{{1, 1}, {-2, 1 + e}, {1, 1 + 2 * e}}};
        const auto derivative = [&](double t, int order) {
            double sum = 0;
            for (const auto& [a, w] : terms) sum += a * std::pow(w, order) * std::cos(w * t + order * pi<double>() / 2);
            return sum;
        };
        Curve curve = smooth([&](double t) { return std::abs(derivative(t, 0)); }, [&](double t) { return derivative(t, 1); },
                             [&](double t) { return derivative(t, 2); }, 0);
        // The Taylor polynomial of the third derivative cancels as the curve does; only its remainder is bounded term by term.
        curve.rate = [&](double a, double b) {
            const double h = (b - a) / 2, middle = a + h;
            double bound = 0, power = 1;
            for (int n = 3; n < 10; power *= h / (n - 2), ++n) bound += std::abs(derivative(middle, n)) * power;
            return bound + 4 * std::pow(1 + 2 * e, 10) * power;
        };
        Effort effort{default_effort(3)};
        const double noise = 8 * std::numeric_limits<double>::epsilon();
        const Maximum best = global_maximum(curve, 0.0, pi<double>(), noise, &effort);
        double sampled = 0;
        for (int n = 0; n <= 4000; ++n) sampled = std::max(sampled, curve.sample(pi<double>() * n / 4000).f);
        INFO("e = " << e << ": " << effort.spent << " samples, value " << best.value << ", at most " << best.upper);
        CHECK(best.settled);
        CHECK(best.upper >= sampled - noise);
        CHECK(best.value <= best.upper);
        CHECK(best.upper <= best.value + 4 * noise);
        CHECK(effort.spent <= 2000);
    }
}

TEST_CASE("a peak that is lower by less than the error may be the largest", "[maximum]") {
    // |sin 2t| - d [t > pi / 2], two peaks: at pi / 4, and d lower at 3 pi / 4.
    const double d = 1e-9;
    const auto lower = [d](double t) { return t > pi<double>() / 2 ? d : 0; };
    const auto sign = [](double t) { return std::sin(2 * t) < 0 ? -1 : 1; };
    const Curve curve = smooth([&](double t) { return std::abs(std::sin(2 * t)) - lower(t); },
                               [&](double t) { return 2 * sign(t) * std::cos(2 * t); },
                               [&](double t) { return -4 * sign(t) * std::sin(2 * t); }, 8);
    const auto rivals_with = [&](double error) {
        const Maximum best =
            global_maximum(curve, 0.0, pi<double>(), 1e-15, nullptr, std::numeric_limits<double>::lowest(), error);
        CHECK(std::abs(best.instant - pi<double>() / 4) < 1e-7);
        return rivals(best.places, 0.0, pi<double>(), best.instant);
    };
    CHECK(rivals_with(0).empty());
    CHECK(rivals_with(0.49e-9).empty());
    const std::vector<Place> others = rivals_with(0.51e-9);
    REQUIRE(others.size() == 1);
    CHECK(std::abs(others[0].instant - 3 * pi<double>() / 4) < 1e-7);
    CHECK(others[0].reach == 0);
}

TEST_CASE("each of many peaks that may be the largest is found, and nothing beside them", "[maximum]") {
    // |sin 14t| - d [t > pi / 2]
    const double d = 1e-9;
    const auto sign = [](double t) { return std::sin(14 * t) < 0 ? -1 : 1; };
    const Curve curve = smooth([&](double t) { return std::abs(std::sin(14 * t)) - (t > pi<double>() / 2 ? d : 0); },
                               [&](double t) { return 14 * sign(t) * std::cos(14 * t); },
                               [&](double t) { return -196 * sign(t) * std::sin(14 * t); }, 2744);
    for (const double error : {0.49e-9, 0.51e-9}) {
        const Maximum best =
            global_maximum(curve, 0.0, pi<double>(), 1e-15, nullptr, std::numeric_limits<double>::lowest(), error);
        const std::vector<Place> others = rivals(best.places, 0.0, pi<double>(), best.instant);
        CHECK(others.size() == (error < d / 2 ? 6 : 13));
        for (const Place& each : others) {
            CHECK(std::abs(std::cos(14 * each.instant)) < 1e-6);
            CHECK(each.reach == 0);
        }
    }
}

TEST_CASE("maxima in places that touch are told apart", "[maximum]") {
    // from, to, instant, value, upper, reach
    using Places = std::vector<Place>;
    const auto reach_of = [](const Places& places) {
        const Places one = joined(places);
        REQUIRE(one.size() == 1);
        CHECK(one[0].value == 2);
        CHECK(one[0].instant == 0.25);
        return one[0].reach;
    };
    const Place larger{0, 1, 0.25, 2, 2, 0};
    CHECK(reach_of({larger, {1, 2, 1.75, 1.9, 1.9, 0}}) == 1.5);
    CHECK(reach_of({{1, 2, 1.75, 1.9, 1.9, 0}, larger}) == 1.5);
    CHECK(reach_of({{-1, 0, -0.5, 1.9, 1.9, 0.125}, larger}) == 0.875);
    CHECK(reach_of({larger, {1, 2, 1, 1.9, 1.9, 0.5}}) == 1.25);
    CHECK(reach_of({larger, {1, 2, 1, 1.9, 1.9, 0}}) == 0);  // it falls from the border on
    CHECK(reach_of({{-1, 0, 0, 1.9, 1.9, 0}, larger}) == 0); // it rises up to the border
    CHECK(reach_of({{-1, 0, 0, 2, 2, 0}, larger}) == 0);     // the border is as high as the maximum beyond, to rounding
    CHECK(reach_of({larger, {1, 1, 1, 1.9, 1.9, 0}, {1, 2, 1.5, 1.95, 1.95, 0}}) == 1.25);
    CHECK(joined(Places{larger, {1.5, 2, 1.75, 1.9, 1.9, 0}}).size() == 2);
}

TEST_CASE("a place at one end may have a maximum that the other end does not go on to", "[maximum]") {
    using Places = std::vector<Place>;
    const auto count = [](const Places& places) { return rivals(places, 0.0, 3.0, 0.25).size(); };
    const Place start{0, 0.5, 0.25, 2, 2, 0};
    CHECK(count({start, {2.5, 3, 3, 1.9, 1.9, 0}}) == 0);
    CHECK(count({start, {2.5, 3, 2.75, 1.9, 1.9, 0}}) == 1);
    CHECK(count({{0, 0.5, 0, 2, 2, 0}, {2.5, 3, 2.75, 2, 2, 0}}) == 0); // one maximum, near the end
    CHECK(count({start, {2.5, 3, 3, 1.9, 1.9, 0.5}}) == 1);
    CHECK(count({start, {1, 2, 1.5, 1.9, 1.9, 0}, {2.5, 3, 3, 1.9, 1.9, 0}}) == 1);
    CHECK(count({{0, 0.5, 0.25, 2, 2, 0.125}}) == 1);
    CHECK(count({start}) == 0);
    // Of two places with the same value the other is the rival, whichever it is.
    const Place other{1, 2, 1.5, 2, 2, 0};
    CHECK(rivals({start, other}, 0.0, 3.0, 0.25).at(0).instant == 1.5);
    CHECK(rivals({start, other}, 0.0, 3.0, 1.5).at(0).instant == 0.25);
}

TEST_CASE("the two ends of a half-period are one instant", "[maximum]") {
    const Curve curve = smooth([](double t) { return std::abs(std::cos(t)); },
                               [](double t) { return std::cos(t) < 0 ? std::sin(t) : -std::sin(t); },
                               [](double t) { return -std::abs(std::cos(t)); }, 1);
    const Maximum best = global_maximum(curve, 0.0, pi<double>());
    REQUIRE(best.places.size() == 2);
    CHECK(rivals(best.places, 0.0, pi<double>(), best.instant).empty());
    CHECK(rivals(best.places, 0.0, 4.0, best.instant).size() == 1);
}
