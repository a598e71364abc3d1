#include "denhartog/search/zeros.hpp"

#include <cmath>
#include <random>

#include "denhartog/number/number.hpp"
#include "tests/catch.hpp"

namespace {

using namespace denhartog;

// offset + sum of a cos(w t + p), with a bound of the sixth derivative that holds everywhere.
struct Waves {
    double offset;
    std::vector<std::array<double, 3>> waves; // a, w, p
    int evaluations = 0;

    Jet operator()(double t) {
        using std::abs;
        ++evaluations;
        Jet jet{{offset}, 0, 0, std::numeric_limits<double>::epsilon() * abs(offset)};
        for (const auto& [a, w, p] : waves) {
            const double c = a * cos(w * t + p), s = a * sin(w * t + p);
            const std::array<double, 4> turn{c, -s, -c, s};
            double power = 1;
            for (std::size_t k = 0; k < jet.f.size(); ++k, power *= w) jet.f[k] += power * turn[k % 4];
            jet.bound += abs(a) * power;
            jet.noise += std::numeric_limits<double>::epsilon() * abs(c);
        }
        return jet;
    }
};

std::optional<Crossing> first(Waves& f, double from, double to, int order = 0) {
    double step = 1;
    return first_crossing(f, from, to, order, step, Effort{});
}

} // namespace

TEST_CASE("where rounding spoils the higher derivatives the tangent keeps steps long", "[unit][exact-solver][events]") {
    Waves f{0, {{1, 3, 0}}};
    // Errors grow by 1e8 with each derivative, from the second on, as in a mode of 1e8 times the frequency that hardly moves.
    auto spoilt = [&f](const double& t) {
        Jet jet = f(t);
        double spoils = std::numeric_limits<double>::epsilon();
        for (std::size_t k = 0; k < jet.f.size(); ++k, spoils *= 1e8)
            if (k > 1) jet.f[k] += k % 2 == 0 ? spoils : -spoils;
        jet.bound += spoils;
        jet.second = 9;
        return jet;
    };
    double step = 1;
    const auto zero = first_crossing(spoilt, 0.0, 10.0, 0, step, Effort{});
    REQUIRE(zero);
    CHECK(std::abs(zero->t - pi<double>() / 6) <= 1e-14);
    CHECK(f.evaluations <= 1000);
}

TEST_CASE("a zero at the start is not found again", "[unit][exact-solver][events]") {
    Waves sine{0, {{1, 1, -pi<double>() / 2}}};
    const auto after_simple = first(sine, 0.0, 10.0, 1);
    REQUIRE(after_simple);
    CHECK(std::abs(after_simple->t - pi<double>()) <= 1e-15);

    Waves versine{1, {{-1, 1, 0}}}; // 1 - cos t: second order at 0, touches again at 2 pi
    const auto after_double = first(versine, 0.0, 6.0, 2);
    CHECK_FALSE(after_double);
}

TEST_CASE("two zeros however close together are not stepped over", "[unit][exact-solver][events]") {
    // 1 + depth below its minimum: zeros at pi -+ sqrt(2 depth).
    for (const double depth : {1e-3, 1e-6, 1e-9, 1e-12}) {
        Waves f{1 - depth, {{1, 1, 0}}};
        const auto zero = first(f, 0.0, 6.0);
        REQUIRE(zero);
        const double expected = std::acos(depth - 1);
        INFO("depth " << depth << ", found " << zero->t << ", expected " << expected);
        CHECK(std::abs(zero->t - expected) <= 4e-16 / std::sqrt(2 * depth) + 4e-16);
    }
}

TEST_CASE("a near miss is passed by", "[unit][exact-solver][events]") {
    for (const double height : {1e-3, 1e-6, 1e-9, 1e-12, 1e-14}) {
        Waves f{1 + height, {{1, 1, 0}}};
        INFO("height " << height);
        CHECK_FALSE(first(f, 0.0, 6.0));
        CHECK(f.evaluations <= 200);
    }
}

TEST_CASE("a tangency within rounding is reported as one, at its place", "[unit][exact-solver][events]") {
    Waves f{1, {{1, 1, 0}}};
    const auto zero = first(f, 0.0, 6.0);
    REQUIRE(zero);
    CHECK(zero->touches);
    CHECK(std::abs(zero->t - pi<double>()) <= 1e-7); // the square root of rounding
}

TEST_CASE("a jet stays positive or falls only if every function within its bounds does", "[unit][exact-solver][events]") {
    std::mt19937_64 random(5);
    const auto draw = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    std::array<int, 3> positive{}, falling{};
    int too_soon = 0;
    for (std::size_t n = 0; n < 9000; ++n) {
        const int order = static_cast<int>(n % 3);
        const std::size_t kind = n / 3 % 3, derivative = 2 * kind + 2; // that is bounded
        const double h = derivative == 2 ? draw(0.1, 1) * tangent_up_to : draw(0.1, 2), grows = n % 5 < 2 ? 1 / h : 0;
        Jet jet{{draw(0, 2) * (derivative == 2 ? h : 1), draw(-2, 2), draw(-4, 4), draw(-12, 12), draw(-24, 24), draw(-60, 60)},
                std::numeric_limits<double>::infinity(),
                0,
                0};
        for (int k = 0; k < order; ++k) jet.f[static_cast<std::size_t>(k)] = 0;
        double& bound = derivative == 2 ? jet.second : derivative == 4 ? jet.fourth : jet.bound;
        // the function, or its slope, if the derivative has a constant value
        const auto value = [&](std::size_t from, double t, double constant) {
            double sum = 0, power = 1; // t^k / k!
            for (std::size_t k = from; k < derivative; power *= t / static_cast<double>(++k - from)) sum += jet.f[k] * power;
            return sum + constant * power;
        };
        bool is_positive = false, is_falling = false;
        for (double most = 1e5; most > 1e-3; most *= 0.95) {
            bound = most;
            jet.growth = most * grows;
            const bool stays = !is_positive && stays_positive(jet, order, h), goes_down = !is_falling && falls(jet, h);
            is_positive = is_positive || stays;
            is_falling = is_falling || goes_down;
            const double worst = most + jet.growth * h;
            for (double t = h / 64; t <= h; t += h / 64)
                too_soon += (stays && value(0, t, -worst) <= 0) + (goes_down && value(1, t, worst) >= 0);
        }
        positive[kind] += is_positive;
        falling[kind] += is_falling;
    }
    CHECK(too_soon == 0);
    for (const std::size_t kind : {0u, 1u, 2u}) {
        CHECK(positive[kind] > 500);
        CHECK(falling[kind] > 200);
    }
}

TEST_CASE("of several functions the first to cross is found, also if one starts from a zero", "[unit][exact-solver][events]") {
    std::mt19937_64 random(7);
    const auto draw = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    std::array<int, 2> told{};
    for (int n = 0; n < 300; ++n) {
        std::array<Waves, 2> f;
        for (Waves& each : f) {
            each.offset = draw(0.5, 1.5);
            for (int m = 0; m < 3; ++m) each.waves.push_back({draw(-0.6, 0.6), draw(0.2, 5), draw(0, 6.28)});
        }
        std::array<int, 2> order{};
        if (n % 3 == 0) { // the first function starts from a zero
            f[0].offset -= f[0](0).f[0];
            if (f[0](0).f[1] <= 0) continue;
            order[0] = 1;
        }
        if ((order[0] == 0 && f[0](0).f[0] <= 0) || f[1](0).f[0] <= 0) continue;
        const auto both = [&](double t) { return std::array{f[0](t), f[1](t)}; };
        double step = 1;
        const int order_of_first = order[0];
        const auto zero = first_crossing(both, 0.0, 20.0, order, step, Effort{});
        const std::array alone{first(f[0], 0.0, 20.0, order_of_first), first(f[1], 0.0, 20.0)};
        const double infinity = std::numeric_limits<double>::infinity(), t_0 = alone[0] ? alone[0]->t : infinity,
                     t_1 = alone[1] ? alone[1]->t : infinity;
        CAPTURE(n, t_0, t_1);
        REQUIRE(zero.has_value() == (std::min(t_0, t_1) < infinity));
        if (!zero) continue;
        CHECK(zero->which == (t_1 < t_0 ? 1u : 0u));
        CHECK(std::abs(zero->t - std::min(t_0, t_1)) <= 1e-13);
        ++told[zero->which];
    }
    CHECK(told[0] > 60);
    CHECK(told[1] > 40);
}

TEST_CASE("behind a touch of one function the search goes on to the crossing of the other", "[unit][exact-solver][events]") {
    Waves touches{1, {{1, 1, 0}}}, crosses{-std::cos(1.5), {{1, 0.3, 0}}}; // at pi; at 5
    const auto both = [&](double t) { return std::array{touches(t), crosses(t)}; };
    std::array<int, 2> order{};
    double step = 1;
    const auto touch = first_crossing(both, 0.0, 8.0, order, step, Effort{});
    REQUIRE(touch);
    CHECK(touch->touches);
    CHECK(touch->which == 0);
    CHECK(std::abs(touch->t - pi<double>()) <= 1e-7);
    order[0] = 2;
    const auto crossing = first_crossing(both, touch->t, 8.0, order, step, Effort{});
    REQUIRE(crossing);
    CHECK_FALSE(crossing->touches);
    CHECK(crossing->which == 1);
    CHECK(std::abs(crossing->t - 5) <= 1e-14);
    CHECK(order == std::array{0, 0});
}

TEST_CASE("a zero where a step ends is a crossing", "[unit][exact-solver][events]") {
    auto line = [](const double& t) { return Jet{{1 - t, -1}, 0, 0, 0}; };
    double step = 1;
    const auto zero = first_crossing(line, 0.0, 2.0, 0, step, Effort{});
    REQUIRE(zero);
    CHECK(zero->t == 1);
    CHECK_FALSE(zero->touches);
}

TEST_CASE("no crossing of a seeded sum of waves is missed that 100 000 instants show", "[unit][exact-solver][events]") {
    std::mt19937_64 random(3);
    const auto draw = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    int found = 0;
    for (int n = 0; n < 40; ++n) {
        Waves f{draw(0.2, 1.5), {}};
        for (int m = 0; m < 4; ++m) f.waves.push_back({draw(-0.6, 0.6), draw(0.2, 15), draw(0, 6.28)});
        if (f(0).f[0] <= 0) continue;
        const double end = 20;
        double sampled = end;
        for (int i = 1; i <= 100000 && sampled == end; ++i)
            if (f(end * i / 100000).f[0] < 0) sampled = end * i / 100000;
        const auto zero = first(f, 0.0, end);
        INFO("sum of waves " << n);
        if (!zero) {
            CHECK(sampled == end);
            continue;
        }
        ++found;
        CHECK(zero->t <= sampled);
        CHECK(std::abs(f(zero->t).f[0]) <= 1e-13);
        CHECK(f(zero->t / 2).f[0] > 0);
    }
    CHECK(found >= 15);
}

TEST_CASE("zeros of 2000 seeded sums of waves are found to rounding, in few evaluations", "[unit][exact-solver][events]") {
    std::mt19937_64 random(3);
    const auto draw = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    double worst = 0;
    long evaluations = 0, found = 0;
    for (int n = 0; n < 2000; ++n) {
        Waves f{draw(0, 1), {}};
        for (int m = 0; m < 4; ++m) f.waves.push_back({draw(-0.6, 0.6), draw(0.2, 5), draw(0, 6.28)});
        if (f(0).f[0] <= 0) continue;
        const auto zero = first(f, 0.0, 20.0);
        evaluations += f.evaluations;
        if (!zero || zero->touches) continue;
        ++found;
        const Jet jet = f(zero->t);
        const double rounding = std::numeric_limits<double>::epsilon() * zero->t + 4 * jet.noise / std::abs(jet.f[1]);
        worst = std::max(worst, std::abs(jet.f[0] / jet.f[1]) / rounding);
        for (const double behind : {1e-2, 1e-4, 1e-6, 1e-8}) { // the last step ends right behind the zero
            const auto again = first(f, 0.0, zero->t + behind);
            REQUIRE(again);
            CHECK(std::abs(again->t - zero->t) <= 8 * rounding);
        }
    }
    INFO("worst error " << worst << ", " << evaluations << " evaluations for " << found << " zeros");
    CHECK(found > 1000);
    CHECK(worst <= 4);
    CHECK(evaluations <= 30'000);
}

TEST_CASE("a function that changes faster than the number type can follow ends the search",
          "[unit][exact-solver][events][effort]") {
    for (const double w : {1e19, 1e60, 1e200, std::numeric_limits<double>::infinity()}) {
        Waves f{1.5, {{1, w, 0}}};
        Effort effort{1000};
        const auto counted = [&](double t) {
            effort.spend(1);
            return f(t);
        };
        double step = 1;
        const auto end = first_crossing(counted, 0.0, 10.0, 0, step, effort);
        INFO("w = " << w << ", " << f.evaluations << " evaluations");
        REQUIRE(end);
        CHECK(end->open);
        CHECK(end->t < 1e-3);
        CHECK(f.evaluations <= 1001);
    }
}

TEST_CASE("a search for a crossing ends where its effort is spent", "[unit][exact-solver][events][effort]") {
    Waves f{1.5, {{1, 1e6, 0}}};
    Effort effort{500};
    const auto counted = [&](const double& t) {
        effort.spend(1);
        return f(t);
    };
    double step = 1;
    const auto end = first_crossing(counted, 0.0, 10.0, 0, step, effort);
    REQUIRE(end);
    CHECK(end->open);
    CHECK(end->t > 0);
    CHECK(f.evaluations <= 502);
}
