// The largest value of a function, proved; and twins that say too little of their function, which the same tests notice.
#include "denhartog/search/largest.hpp"

#include "denhartog/reference/maximum.hpp"
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

// Whether the stretches hold an instant, and the bounds a value.
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
