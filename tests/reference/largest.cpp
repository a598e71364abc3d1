// The largest value of a function, proved; and twins that say too little of their function, which the same tests notice.
#include "denhartog/search/largest.hpp"

#include <array>
#include <random>

#include "denhartog/reference/series.hpp"
#include "tests/catch.hpp"
#include "tests/reference/proofs.hpp"

using namespace denhartog;
using namespace denhartog::reference;
using namespace denhartog::tests;

namespace {

template <class T>
    requires std::same_as<T, Series>
T operator/(const T& x, int n) {
    return x * (Ball(1) / Ball(n));
}

// A function by its series, and where it is largest on [0, pi].
struct KnownMaximum {
    const char* name;
    std::function<Series(const Series&)> of;
    std::function<Ball()> value, instant;
};

Ball fraction(int n, int d) { return Ball(n) / d; }

std::vector<KnownMaximum> known_maxima() {
    return {{"one maximum within", [](const Series& t) { return cos(t - Series(fraction(1, 3))); }, [] { return Ball(1); },
             [] { return fraction(1, 3); }},
            {"falls", [](const Series& t) { return exp(-t); }, [] { return Ball(1); }, [] { return Ball(0); }},
            {"rises", [](const Series& t) { return t * t; }, [] { return pi<Ball>() * pi<Ball>(); }, [] { return pi<Ball>(); }},
            {"the higher of two", [](const Series& t) { return sin(3 * t) + Series(fraction(1, 100)) * t; },
             [] { // where 3 cos(3 t) = -1/100 in the last third
                 const Ball t = (2 * pi<Ball>() + atan2(sqrt(1 - fraction(1, 90000)), -fraction(1, 300))) / 3;
                 return sin(3 * t) + t / 100;
             },
             [] { return (2 * pi<Ball>() + atan2(sqrt(1 - fraction(1, 90000)), -fraction(1, 300))) / 3; }},
            {"flat at its maximum", [](const Series& t) { return 1 - (t - 1) * (t - 1) * (t - 1) * (t - 1) / 30; },
             [] { return Ball(1); }, [] { return Ball(1); }}};
}

SearchedFunction<Ball> searched(const std::function<Series(const Series&)>& f) {
    return {[f](const Ball& t) { return f(Series(t)).rate(0); },
            [f](double a, double b) {
                const Series over = f(Series::time(Ball::within(a, b)));
                const Ball slope = over.rate(1);
                const TrendOnStretch trend = slope > Ball(0)   ? TrendOnStretch::rises
                                             : slope < Ball(0) ? TrendOnStretch::falls
                                                               : TrendOnStretch::unknown;
                return SeenOverStretch<Ball>{over.rate(0), trend};
            }};
}

// True if one of the stretches holds an instant, and the bounds hold a value.
bool holds_largest(const LargestOnStretches& found, double value, double instant) {
    double upper = found.lower;
    bool there = false;
    for (const StretchOfLargest& s : found.stretches) {
        upper = std::max(upper, s.upper);
        there = there || (s.from - 1e-12 <= instant && instant <= s.to + 1e-12);
    }
    return found.settled && there && found.lower <= value + 1e-15 && value <= upper + 1e-15 && upper - found.lower < 1e-6;
}

// Of a function whose largest value is the largest in size.
LargestInBalls largest_of(const std::function<Series(const Series&)>& f) {
    return largest_size_of([f](const Ball& t) { return f(Series::time(t)); }).up.value();
}

LargestOnStretches stretches(const SearchedFunction<Ball>& f, int looks = 4000) {
    return stretches_of_largest(f, 0.0, 3.141592653589793, 1e-3, 1e-9, looks);
}

} // namespace

TEST_CASE("the stretches that are left hold the largest value, on either side as near as the search goes", "[largest]") {
    for (const KnownMaximum& known : known_maxima()) {
        INFO(known.name);
        const auto value = static_cast<double>(known.value()), instant = static_cast<double>(known.instant());
        CHECK(holds_largest(stretches(searched(known.of)), value, instant));
    }
}

TEST_CASE("a range that is too small is noticed: the largest value is missed", "[largest]") {
    int missed = 0;
    for (const KnownMaximum& known : known_maxima()) {
        SearchedFunction<Ball> wrong = searched(known.of);
        wrong.stretch = [&, right = wrong.stretch](double a, double b) {
            return SeenOverStretch<Ball>{wrong.value(Ball(a + (b - a) / 2)) - Ball(b - a), right(a, b).trend};
        };
        missed += !holds_largest(stretches(wrong), static_cast<double>(known.value()), static_cast<double>(known.instant()));
    }
    CHECK(missed >= 3);
}

TEST_CASE("a wrong trend is noticed: the largest value is missed", "[largest]") {
    int missed = 0;
    for (const KnownMaximum& known : known_maxima()) {
        SearchedFunction<Ball> wrong = searched(known.of);
        wrong.stretch = [right = wrong.stretch](double a, double b) {
            return SeenOverStretch<Ball>{right(a, b).range, TrendOnStretch::falls};
        };
        missed += !holds_largest(stretches(wrong), static_cast<double>(known.value()), static_cast<double>(known.instant()));
    }
    CHECK(missed == 4); // of one it is right
}

TEST_CASE("of a value that is not certain only the lower end is reached", "[largest]") {
    for (const KnownMaximum& known : known_maxima()) {
        INFO(known.name);
        SearchedFunction<Ball> wide = searched(known.of);
        wide.value = [right = wide.value](const Ball& t) { return widened(right(t) + Ball(0.125), Ball(0.125)); };
        CHECK(stretches(wide).lower <= static_cast<double>(known.value()) + 1e-15);
    }
}

TEST_CASE("a search whose looks are spent says that it is not settled", "[largest]") {
    const SearchedFunction<Ball> f = searched([](const Series& t) { return sin(3 * t); });
    CHECK_FALSE(stretches(f, 4).settled);
    CHECK(stretches(f).settled);
}

TEST_CASE("a largest value has all the bits of the moment", "[largest]") {
    for (const slong bits : {128, 512}) {
        const Bits here(bits);
        const double small = std::exp2(-0.8 * static_cast<double>(bits));
        for (const KnownMaximum& known : known_maxima()) {
            if (std::string(known.name) == "flat at its maximum") continue; // see below
            INFO(known.name << ", " << bits << " bits");
            const LargestInBalls found = largest_of(known.of);
            CHECK(apart(found.value, known.value()) == 0);
            CHECK(apart(found.instant, known.instant()) == 0);
            CHECK(found.value.radius() < 20 * small);
            CHECK(found.instant.radius() < 20 * small);
        }
    }
}

TEST_CASE("where Newton's method stops short of a zero, its place is held all the same", "[largest]") {
    const Bits enough(128);
    const auto wavy = [](const Ball& t) { // its slope changes within far less than half of the bits
        const Ball fast = t * Ball(0x1p80);
        return ValueAndSlope{-t - sin(fast) * Ball(0x1p-81), -1 - cos(fast) / 2};
    };
    const auto flat = [](const Ball& t) {
        const Ball eighth = t * t * t * t * t * t * t * t;
        return ValueAndSlope{-t * eighth, -9 * eighth};
    };
    for (int n = 1; n <= 64; ++n) {
        INFO("from " << n);
        CHECK(place_of_zero(widened(Ball(n * 0x1p-66), Ball(0x1p-58)), wavy).may_vanish());
        CHECK(place_of_zero(widened(Ball(n * 0x1p-64), Ball(0x1p-57)), flat).may_vanish());
    }
}

TEST_CASE("where it is not certain on which side of an instant of the search a function is largest, both are held", "[largest]") {
    const Bits enough(128);
    for (const int eighths : {1, 2, 4}) {
        const Ball place = widened(Ball(eighths * 3.141592653589793 / 8), Ball(0x1p-42));
        const LargestInBalls found = largest_of([&](const Series& t) { return cos(t - Series(place)); });
        CHECK(arb_contains(found.instant.a, place.a) != 0);
        CHECK(found.instant.radius() < 1e-6);
        CHECK(apart(found.value, Ball(1)) == 0);
    }
}

TEST_CASE("of many maxima within a tenth the highest is found", "[largest]") {
    const Bits enough(128);
    const LargestInBalls found = largest_of([](const Series& t) { return 2 - (t - 1) * (t - 1) / 4 + sin(400 * t) / 1000; });
    double sampled = 0;
    for (int n = 0; n <= 40'000; ++n) {
        const double t = 0.9 + n * 5e-6;
        sampled = std::max(sampled, 2 - (t - 1) * (t - 1) / 4 + std::sin(400 * t) / 1000);
    }
    CHECK(found.value.high() >= sampled - 1e-15);
    CHECK(found.value.low() <= sampled + 1e-8);
    CHECK(found.value.radius() < 1e-25);
}

TEST_CASE("where several instants may be the largest, the ball holds them all", "[largest]") {
    const Bits enough(128);
    const LargestBothWays both = largest_size_of([](const Ball& t) { return cos(4 * Series::time(t)); });
    REQUIRE((both.up && both.down));
    CHECK(apart(both.up->value, Ball(1)) == 0);
    CHECK(apart(both.down->value, Ball(1)) == 0);
    CHECK(both.down->value.radius() < 1e-25);
    CHECK(both.down->instant.low() <= 0.7854);
    CHECK(both.down->instant.high() >= 2.3561);
    const LargestInBalls flat = largest_of(known_maxima().back().of);
    CHECK(apart(flat.value, Ball(1)) == 0);
    CHECK(apart(flat.instant, Ball(1)) == 0);
    CHECK(flat.value.radius() < 1e-25);
}

TEST_CASE("of functions that differ in their slopes where they are equal the largest value of each is held", "[largest]") {
    const Bits enough(128);
    const double most = 0x1p-20; // 8 + s (t - 1) - (t - 1)^2 is 8 + s^2 / 4 at 1 + s / 2
    const auto f = [&](const Ball& t) {
        const Series d = Series::time(t) - Series(Ball(1));
        return 8 + Series(widened(Ball(0), Ball(most))) * d - d * d;
    };
    const LargestBothWays largest = largest_size_of(f);
    REQUIRE(largest.up);
    const LargestInBalls quotient = largest_over_sine([&](const Ball& t) { return f(t) * sin(Series::time(t)); });
    for (const LargestInBalls& each : {*largest.up, quotient}) {
        CHECK(arb_contains(each.value.a, Ball::within(8, 8 + most * most / 4).a) != 0);
        CHECK(arb_contains(each.instant.a, Ball::within(1 - most / 2, 1 + most / 2).a) != 0);
        CHECK(each.value.radius() < 1e-8);
    }
}

TEST_CASE("of maxima that are not told apart the value holds the larger, whichever is found first", "[largest]") {
    const Bits enough(128);
    const Ball small = widened(Ball(0), Ball(0x1p-40));
    const auto of = [&](const Ball& from) { // 1 at an end, where it is `from`, and up to 1 + 2^-40 pi at the other
        return largest_of([&](const Series& t) { return 8 + cos(2 * t) + Series(small) * (t - Series(from)); }).value;
    };
    for (const Ball& from : {Ball(0), pi<Ball>()}) CHECK(arb_contains(of(from).a, (9 + Ball(0x1p-40) * Ball(3)).a) != 0);
}

TEST_CASE("over a stretch a function holds itself at every instant, by its terms and by what drives it", "[largest]") {
    const Bits enough(96);
    const FunctionOfTime n = [](const Ball& t) { return exp(2 * Series::time(t)); };
    const FunctionOfTime wide = [&](const Ball& t) { // its terms over a stretch say nothing
        Series x = n(t);
        if (t.radius() > 1e-9)
            for (Ball& c : x.c) c = widened(c, Ball(1000));
        return x;
    };
    const FunctionOfTime Z = [&](const Ball& t) { return 5 * n(t); };
    for (const double h : {0x1p-9, 0x1p-5, 0x1p-2}) {
        const Ball X = widened(Ball(1), Ball(h));
        const Series by_terms = over_stretch(n, X);
        Series by_drive = over_stretch(wide, X);
        const Ball drive = narrowed_by_drive(by_drive, wide, Z, X);
        for (int k = -8; k <= 8; ++k) {
            const Series at = n(Ball(1 + h * k / 8));
            INFO("half width " << h << ", " << k << " eighths");
            for (const int order : {0, 1, 2}) CHECK(arb_contains(by_terms.c[order].a, at.c[order].a) != 0);
            for (const int order : {0, 1}) CHECK(arb_contains(by_drive.c[order].a, at.c[order].a) != 0);
            CHECK(arb_contains(drive.a, (5 * at.c[0]).a) != 0);
        }
        CHECK(by_terms.c[0].radius() < 4 * h * n(Ball(1)).c[0].high());
        CHECK(by_drive.c[0].radius() < 4 * h * n(Ball(1)).c[0].high());
    }
}

TEST_CASE("largest values of seeded sums of waves are those that samples show, by themselves and over the sine", "[largest]") {
    const Bits enough(96);
    std::mt19937_64 random(7);
    const auto draw = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    for (int n = 0; n < 30; ++n) {
        std::array<std::array<double, 3>, 3> waves{};
        for (auto& wave : waves) wave = {draw(-1, 1), draw(0.5, 12), draw(0, 6.28)};
        const FunctionOfTime f = [&](const Ball& t) {
            Series sum(0);
            for (const auto& [a, w, p] : waves) sum = sum + Series(Ball(a)) * cos(Ball(w) * Series::time(t) + Series(Ball(p)));
            return sum;
        };
        double highest = -10, lowest = 10;
        for (int i = 0; i <= 2000; ++i) {
            double sum = 0;
            for (const auto& [a, w, p] : waves) sum += a * std::cos(w * 3.14159265358979 * i / 2000 + p);
            highest = std::max(highest, sum);
            lowest = std::min(lowest, sum);
        }
        const auto shown = [](const LargestInBalls& found, double sampled) {
            return found.value.high() >= sampled - 1e-12 && found.value.low() <= sampled + 1e-3 && found.value.radius() < 1e-20;
        };
        const FunctionOfTime over = [&](const Ball& t) { return f(t) * sin(Series::time(t)); };
        const FunctionOfTime Z = [&](const Ball& t) { // n'' + n with slope and curvature
            const Series x = over(t), first = x.derivative(), second = first.derivative();
            return second + x;
        };
        const LargestBothWays both = largest_size_of(f);
        INFO("sum of waves " << n);
        CHECK((highest > -lowest ? both.up && shown(*both.up, highest) : both.down && shown(*both.down, -lowest)));
        CHECK(shown(largest_over_sine(over), highest));
        CHECK(shown(largest_over_sine(over, Z), highest));
    }
}

TEST_CASE("of the largest value and that of the negative only what may be the larger is given", "[largest]") {
    const Bits enough(128);
    const LargestBothWays down = largest_size_of([](const Ball& t) { return -2 * sin(Series::time(t)) + cos(Series::time(t)); });
    CHECK_FALSE(down.up);
    REQUIRE(down.down);
    CHECK(apart(down.down->value, sqrt(Ball(5))) == 0);
}

TEST_CASE("the largest quotient by the sine is found within, at the start and at the end of the half-period",
          "[largest][eq:56]") {
    const Bits enough(128);
    const auto of = [](const std::function<Series(const Series&)>& quotient) {
        return largest_over_sine([quotient](const Ball& t) {
            const Series time = Series::time(t);
            return quotient(time) * sin(time);
        });
    };
    const LargestInBalls start = of([](const Series&t) { return exp(-t); }), end = of([](const Series&t) { return t; }),
                         within = of([](const Series&t) { return sin(t); });
    CHECK(apart(start.value, Ball(1)) == 0);
    CHECK(start.instant.is_zero());
    CHECK(apart(end.value, pi<Ball>()) == 0);
    CHECK(apart(within.value, Ball(1)) == 0);
    CHECK(apart(within.instant, pi<Ball>() / 2) == 0);
    for (const LargestInBalls& each : {start, end, within}) CHECK(each.value.radius() < 1e-25);
}
