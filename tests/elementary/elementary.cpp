#include "elementary/elementary.hpp"

#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "elementary/angle_tables.hpp"
#include "elementary/circle_tables.hpp"
#include "elementary/kernels.hpp"
#include "elementary/logarithm_tables.hpp"
#include "elementary/power_tables.hpp"
#include "elementary/series_tables.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A number of MPFR, of 300 bits.
struct Exact {
    mpfr_t x;
    explicit Exact(double value = 0) {
        mpfr_init2(x, 300);
        mpfr_set_d(x, value, MPFR_RNDN);
    }
    explicit Exact(const elementary::Parts& value) : Exact(value.high) { mpfr_add_d(x, x, value.low, MPFR_RNDN); }
    Exact(const Exact&) = delete;
    Exact& operator=(const Exact&) = delete;
    ~Exact() { mpfr_clear(x); }
};

using Mpfr = int (*)(mpfr_t, const mpfr_t, mpfr_rnd_t);

int sine_of_half_turns_by_mpfr(mpfr_t y, const mpfr_t x, mpfr_rnd_t rounding) { return mpfr_sinpi(y, x, rounding); }
int cosine_of_half_turns_by_mpfr(mpfr_t y, const mpfr_t x, mpfr_rnd_t rounding) { return mpfr_cospi(y, x, rounding); }

/// Distance of a number from an exact one, in units in the last place of the exact one.
double units_apart(const elementary::Parts& found, const Exact& exact) {
    if (mpfr_zero_p(exact.x) != 0) return found.high == 0 ? 0 : infinite;
    const long exponent = std::max(static_cast<long>(mpfr_get_exp(exact.x)) - 53, -1074L);
    if (!std::isfinite(found.high)) return mpfr_get_exp(exact.x) > 1024 ? 0 : infinite;
    Exact difference(found);
    mpfr_sub(difference.x, difference.x, exact.x, MPFR_RNDN);
    mpfr_mul_2si(difference.x, difference.x, -exponent, MPFR_RNDN);
    return std::fabs(mpfr_get_d(difference.x, MPFR_RNDN));
}

/// The worst of many.
struct Worst {
    double units = 0, x = 0, y = 0;
    void take(double found, double x_, double y_ = 0) {
        if (found <= units) return;
        *this = {found, x_, y_};
    }
};

/// A function with what MPFR has for it, and the range of its arguments.
struct Function {
    const char* name;
    double (*ours)(double) noexcept;
    Mpfr exact;
    double most;        ///< units in the last place
    double from, to;    ///< for uniform arguments
    int least, largest; ///< binary exponents of arguments drawn by size
    bool negative;      ///< whether these have either sign
};

const std::vector<Function>& functions() {
    static const std::vector<Function> all{
        {"exp", elementary::exp, mpfr_exp, 0.55, -708, 709.7, -60, 9, true},
        {"expm1", elementary::expm1, mpfr_expm1, 0.55, -40, 40, -60, 9, true},
        {"sinh", elementary::sinh, mpfr_sinh, 0.7, -710, 710, -60, 9, true},
        {"cosh", elementary::cosh, mpfr_cosh, 0.55, -710, 710, -60, 9, true},
        {"log", elementary::log, mpfr_log, 0.505, 0.5, 2, -1074, 1023, false},
        {"log10", elementary::log10, mpfr_log10, 0.505, 0.5, 2, -1074, 1023, false},
        {"sin", elementary::sin, mpfr_sin, 0.53, -10, 10, -1074, 1023, true},
        {"cos", elementary::cos, mpfr_cos, 0.53, -10, 10, -1074, 1023, true},
        {"sine of half turns", elementary::sine_of_half_turns, sine_of_half_turns_by_mpfr, 0.53, -3, 3, -1074, 60, true},
        {"cosine of half turns", elementary::cosine_of_half_turns, cosine_of_half_turns_by_mpfr, 0.53, -3, 3, -1074, 60, true},
        {"atan", elementary::atan, mpfr_atan, 0.51, -3, 3, -1074, 1023, true},
    };
    return all;
}

// Of results in the normal range, or of those below it.
Worst worst_of(const Function& f, const std::vector<double>& arguments, bool below_normal) {
    Worst worst;
    Exact y;
    for (const double x : arguments) {
        const Exact argument(x);
        f.exact(y.x, argument.x, MPFR_RNDN);
        if ((mpfr_regular_p(y.x) != 0 && mpfr_get_exp(y.x) < -1020) != below_normal) continue;
        worst.take(units_apart({f.ours(x), 0}, y), x);
    }
    return worst;
}

std::vector<double> seeded_arguments(const Function& f, int count) {
    std::mt19937_64 random(23);
    const auto share = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
    std::vector<double> all;
    for (int n = 0; n < count; ++n) {
        all.push_back(f.from + (f.to - f.from) * share());
        const double size =
            std::ldexp(1 + share(), f.least + static_cast<int>(random() % static_cast<unsigned>(f.largest - f.least + 1)));
        all.push_back(f.negative && random() % 2 == 0 ? -size : size);
    }
    return all;
}

/// Doubles next to the multiples of pi / 128, where an argument is reduced to almost nothing or goes over to the next step.
std::vector<double> next_to_multiples() {
    std::mt19937_64 random(29);
    std::vector<double> all;
    Exact x;
    for (int n = 0; n < 4000; ++n) {
        const double multiple =
            n < 300 ? n + 1 : std::ldexp(static_cast<double>(random() >> 11U), static_cast<int>(random() % 960));
        mpfr_const_pi(x.x, MPFR_RNDN);
        mpfr_mul_d(x.x, x.x, multiple / 128, MPFR_RNDN);
        const double nearest = mpfr_get_d(x.x, MPFR_RNDN);
        for (const double each : {nearest, std::nextafter(nearest, 0), std::nextafter(nearest, infinite)}) all.push_back(each);
    }
    // The double that comes nearest to a multiple of pi / 2 of all, and others that are known to come near.
    for (const double each : {0x1.6ac5b262ca1ffp+849, 0x1.4ab650b8c60dep+100, 0x1.2b089b3c2f4c9p+23, 0x1p24, 0x1.fffffffffffffp23,
                              0x1.fffffffffffffp1023, 0x1p1023, 0x1.921fb54442d18p1, 0x1.921fb54442d18p0, 0x1.2d97c7f3321d2p2})
        all.push_back(each);
    return all;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

} // namespace

TEST_CASE("each elementary function is within its units in the last place of MPFR's", "[accuracy][elementary]") {
    for (const Function& f : functions()) {
        const std::vector<double> arguments = seeded_arguments(f, 8000);
        const Worst worst = worst_of(f, arguments, false), below_normal = worst_of(f, arguments, true);
        INFO(f.name << ": " << worst.units << " units at " << tests::hexadecimal(worst.x));
        CHECK(worst.units <= f.most);
        CHECK(worst.units > 0.49); // a measure that sees nothing would pass
        INFO(f.name << " below the normal range: " << below_normal.units << " units at " << tests::hexadecimal(below_normal.x));
        CHECK(below_normal.units <= 1);
    }
}

TEST_CASE("sines and cosines keep their digits next to every multiple of a 128th of a half turn, up to 1e308",
          "[accuracy][elementary]") {
    const std::vector<double> arguments = next_to_multiples();
    for (const Function& f : functions()) {
        if (f.ours != elementary::sin && f.ours != elementary::cos) continue;
        const Worst worst = worst_of(f, arguments, false);
        INFO(f.name << ": " << worst.units << " units at " << tests::hexadecimal(worst.x));
        CHECK(worst.units <= f.most);
    }
}

TEST_CASE("angles of points are within 0.53 units of MPFR's and lengths within 0.6, however far the coordinates are apart",
          "[accuracy][elementary]") {
    std::mt19937_64 random(31);
    const auto share = [&] { return 1 + static_cast<double>(random() >> 11U) * 0x1p-53; };
    const auto side = [&] { return random() % 2 == 0 ? 1 : -1; };
    Worst angle, length;
    Exact exact;
    for (int n = 0; n < 30000; ++n) {
        const int most = n % 3 == 0   ? 1000
                         : n % 3 == 1 ? 60
                                      : 3,
                  shift = n % 2 == 0 ? 0 : static_cast<int>(random() % 2000) - 1000;
        const auto coordinate = [&] {
            const int exponent = static_cast<int>(random() % static_cast<unsigned>(2 * most)) - most + shift;
            return side() * std::ldexp(share(), std::min(1020, std::max(-1020, exponent)));
        };
        const double y = coordinate(), x = coordinate();
        const Exact of_y(y), of_x(x);
        mpfr_atan2(exact.x, of_y.x, of_x.x, MPFR_RNDN);
        if (mpfr_get_exp(exact.x) > -1021) angle.take(units_apart({elementary::atan2(y, x), 0}, exact), y, x);
        mpfr_hypot(exact.x, of_y.x, of_x.x, MPFR_RNDN);
        length.take(units_apart({elementary::hypot(y, x), 0}, exact), y, x);
    }
    INFO("angle " << angle.units << " units at " << tests::hexadecimal(angle.x) << ", " << tests::hexadecimal(angle.y));
    CHECK(angle.units <= 0.53);
    INFO("length " << length.units << " units at " << tests::hexadecimal(length.x) << ", " << tests::hexadecimal(length.y));
    CHECK(length.units <= 0.6);
}

TEST_CASE("the kernels of the elementary functions are good to 57 bits", "[accuracy][elementary]") {
    using elementary::Parts;
    struct Case {
        const char* name;
        Parts (*ours)(double);
        Mpfr exact;
        double from, to;
        int doublings = 0; ///< up to so many are drawn for each argument
    };
    const auto exponential = [](double x) {
        const elementary::TakenApart e = elementary::exponential(x);
        const double first = e.t * elementary::power_of_two(e.m);
        return Parts{first, first * (e.r + e.s)};
    };
    const auto sine = [](double x) { return elementary::sine(elementary::reduce(x)); };
    const auto cosine = [](double x) { return elementary::cosine(elementary::reduce(x)); };
    const auto sine_of_half_turns = [](double x) {
        return elementary::sine(elementary::reduce_half_turns(elementary::without_many_turns(x)));
    };
    const auto cosine_of_half_turns = [](double x) {
        return elementary::cosine(elementary::reduce_half_turns(elementary::without_many_turns(x)));
    };
    const std::vector<Case> cases{{"exp", exponential, mpfr_exp, -600, 700},
                                  {"expm1", [](double x) { return elementary::exponential_less_one(x); }, mpfr_expm1, -2, 2},
                                  {"sin", sine, mpfr_sin, -100, 100},
                                  {"cos", cosine, mpfr_cos, -100, 100},
                                  {"sine of half turns", sine_of_half_turns, sine_of_half_turns_by_mpfr, -3, 3},
                                  {"cosine of half turns", cosine_of_half_turns, cosine_of_half_turns_by_mpfr, -3, 3},
                                  {"sin of many turns", sine, mpfr_sin, -100, 100, 1000},
                                  {"cos of many turns", cosine, mpfr_cos, -100, 100, 1000},
                                  {"sine of many half turns", sine_of_half_turns, sine_of_half_turns_by_mpfr, -3, 3, 1000},
                                  {"cosine of many half turns", cosine_of_half_turns, cosine_of_half_turns_by_mpfr, -3, 3, 1000}};
    std::mt19937_64 random(37);
    const auto share = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
    Exact exact;
    for (const Case& f : cases) {
        Worst worst;
        for (int n = 0; n < 4000; ++n) {
            const int doublings = f.doublings > 0 ? static_cast<int>(random() % static_cast<unsigned>(f.doublings)) : 0;
            const double x = std::ldexp(f.from + (f.to - f.from) * share(), doublings);
            f.exact(exact.x, Exact(x).x, MPFR_RNDN);
            const Parts found = f.ours(x);
            worst.take(units_apart(found, exact), x);
        }
        INFO(f.name << ": " << worst.units << " units of a double at " << tests::hexadecimal(worst.x));
        CHECK(worst.units <= 0x1p-4);
    }
}

TEST_CASE("what is exact of the elementary functions is exact, and what is odd or even is so to the bit", "[elementary]") {
    using namespace elementary;
    CHECK(elementary::exp(0.0) == 1);
    CHECK(elementary::cosh(0.0) == 1);
    CHECK(elementary::cos(0.0) == 1);
    CHECK(elementary::log(1.0) == 0);
    for (int n = 0; n < 16; ++n) CHECK(elementary::log10(std::stod("1e" + std::to_string(n))) == n);
    for (int n = -1074; n < 1024; ++n)
        CHECK(elementary::log(std::ldexp(1, n)) == Approx(n * elementary::log(2.0)).epsilon(1e-15));
    for (const double zero : {0.0, -0.0}) {
        for (const auto f :
             {elementary::sin, elementary::sinh, elementary::expm1, elementary::atan, elementary::sine_of_half_turns})
            CHECK(same_bits(f(zero), zero));
        CHECK(same_bits(elementary::atan2(zero, 1), zero));
        CHECK(elementary::atan2(zero, -1.0) == std::copysign(0x1.921fb54442d18p1, zero));
    }
    for (int n = -8; n <= 8; ++n) {
        CHECK(elementary::sine_of_half_turns(n) == 0);
        CHECK(elementary::cosine_of_half_turns(n + 0.5) == 0);
        CHECK(elementary::cosine_of_half_turns(n) == (n % 2 == 0 ? 1 : -1));
        CHECK(elementary::sine_of_half_turns(2 * n + 0.5) == 1);
    }
    CHECK(elementary::cosine_of_half_turns(0x1p53) == 1);
    CHECK(elementary::cosine_of_half_turns(0x1p52 + 1) == -1);
    CHECK(elementary::hypot(3, 4) == 5);
    CHECK(elementary::hypot(3e300, 4e300) == Approx(5e300).epsilon(1e-15));
    for (const Function& f : functions())
        for (const double x : seeded_arguments(f, 500)) {
            const std::string name = f.name;
            if (name == "exp" || name == "expm1" || name == "log" || name == "log10") continue;
            const bool even = name.starts_with("cos");
            const double mirrored = f.ours(-x), there = even ? f.ours(x) : -f.ours(x);
            if (!same_bits(mirrored, there) && there != 0) FAIL_CHECK(name << " at " << tests::hexadecimal(x));
        }
}

TEST_CASE("sine and cosine together are to the bit what they are apart", "[elementary]") {
    std::vector<double> arguments = next_to_multiples();
    for (const Function& f : functions())
        if (f.ours == elementary::sin)
            for (const double x : seeded_arguments(f, 8000)) arguments.push_back(x);
    for (const double x : {0.0, -0.0, 0x1p-30, 0x1.fffffffffffffp-31, 1e308, infinite, -infinite}) arguments.push_back(x);
    std::size_t same = 0;
    for (const double x : arguments) {
        const SineCosine<double> together = elementary::sine_cosine(x);
        same += same_bits(together.s, elementary::sin(x)) && same_bits(together.c, elementary::cos(x)) ? 1 : 0;
    }
    CHECK(same == arguments.size());
}

TEST_CASE("elementary functions end where a double ends, and give no number outside their domain", "[elementary]") {
    const double none = std::numeric_limits<double>::quiet_NaN();
    CHECK(elementary::exp(0x1.62e42fefa39efp9) == 0x1.fffffffffff2ap1023);
    CHECK(elementary::exp(0x1.62e42fefa39f0p9) == infinite);
    CHECK(elementary::exp(-0x1.74910d52d3051p9) == 0x1p-1074);
    CHECK(elementary::exp(-0x1.74910d52d3053p9) == 0);
    CHECK(elementary::exp(infinite) == infinite);
    CHECK(elementary::exp(-infinite) == 0);
    CHECK(elementary::expm1(-infinite) == -1);
    CHECK(elementary::cosh(0x1.633ce8fb9f87dp9) == Approx(1.7976931348621744e308).epsilon(1e-12));
    CHECK(elementary::cosh(-infinite) == infinite);
    CHECK(elementary::sinh(-infinite) == -infinite);
    CHECK(elementary::log(0.0) == -infinite);
    CHECK(elementary::log(infinite) == infinite);
    CHECK(elementary::atan(infinite) == 0x1.921fb54442d18p0);
    CHECK(elementary::atan2(infinite, -infinite) == Approx(0.75 * 0x1.921fb54442d18p1).epsilon(1e-15));
    CHECK(elementary::hypot(infinite, none) == infinite);
    for (const auto f : {elementary::sin, elementary::cos, elementary::sine_of_half_turns, elementary::cosine_of_half_turns})
        for (const double x : {infinite, -infinite}) CHECK(std::isnan(f(x)));
    CHECK(std::isnan(elementary::log(-1.0)));
    for (const Function& f : functions()) CHECK(std::isnan(f.ours(none)));
    CHECK(std::isnan(elementary::atan2(none, 1)));
    CHECK(std::isnan(elementary::atan2(1, none)));
}

namespace {

// The coefficients of an expansion in their order, from that of the first power, less one, to that of the eighth.
std::vector<double> coefficients_of(const elementary::Expansion& at) {
    return {at.slope_less_one, at.second, at.third, at.fourth, at.fifth, at.sixth, at.seventh, at.eighth};
}

// Coefficient k of atan next to c: (-1)^(k-1) sin(k theta) / (k (1 + c^2)^(k/2)), tan(theta) = 1 / c.
void coefficient_of_arc_tangent(mpfr_t y, double c, unsigned long k) {
    Exact theta(1), size(c * c + 1);
    mpfr_atan2(theta.x, theta.x, Exact(c).x, MPFR_RNDN);
    mpfr_mul_ui(theta.x, theta.x, k, MPFR_RNDN);
    mpfr_sin(y, theta.x, MPFR_RNDN);
    mpfr_sqrt(size.x, size.x, MPFR_RNDN);
    mpfr_pow_ui(size.x, size.x, k, MPFR_RNDN);
    mpfr_mul_ui(size.x, size.x, k, MPFR_RNDN);
    mpfr_div(y, y, size.x, MPFR_RNDN);
    if (k % 2 == 0) mpfr_neg(y, y, MPFR_RNDN);
    if (mpfr_regular_p(y) != 0 && mpfr_get_exp(y) < -200) mpfr_set_zero(y, 1); // the sine of a multiple of pi
}

void check_expansions(const elementary::Expansion* table, int count, Mpfr value,
                      void (*coefficient)(mpfr_t y, double c, unsigned long k)) {
    Exact x, rest;
    for (int n = 0; n < count; ++n) {
        INFO("expansion " << n);
        value(x.x, Exact(n / 64.0).x, MPFR_RNDN);
        CHECK(table[n].high == mpfr_get_d(x.x, MPFR_RNDN));
        mpfr_sub_d(rest.x, x.x, table[n].high, MPFR_RNDN);
        CHECK(table[n].low == mpfr_get_d(rest.x, MPFR_RNDN));
        const std::vector<double> found = coefficients_of(table[n]);
        for (std::size_t k = 1; k <= found.size(); ++k) {
            coefficient(x.x, n / 64.0, k);
            if (k == 1) mpfr_sub_ui(x.x, x.x, 1, MPFR_RNDN);
            CHECK(found[k - 1] == mpfr_get_d(x.x, MPFR_RNDN));
        }
    }
}

} // namespace

TEST_CASE("the expansions of the arc tangent are MPFR's to the last bit", "[elementary]") {
    check_expansions(elementary::arc_tangents, 65, mpfr_atan, coefficient_of_arc_tangent);
}

TEST_CASE("the tables of the elementary functions are MPFR's to the last bit", "[elementary]") {
    Exact x, rest, pi;
    mpfr_const_pi(pi.x, MPFR_RNDN);
    const auto split = [&](double high) { // what is left of x, as a double
        mpfr_sub_d(rest.x, x.x, high, MPFR_RNDN);
        return mpfr_get_d(rest.x, MPFR_RNDN);
    };
    for (int n = 0; n < 128; ++n) {
        INFO("entry " << n);
        const elementary::Direction& at = elementary::circle[n];
        Exact half_turns(n / 64.0);
        mpfr_sinpi(x.x, half_turns.x, MPFR_RNDN);
        CHECK(at.sine == mpfr_get_d(x.x, MPFR_RNDN));
        CHECK(at.rest == split(at.sine));
        mpfr_cospi(x.x, half_turns.x, MPFR_RNDN);
        CHECK(at.whole == std::floor(mpfr_get_d(x.x, MPFR_RNDN) + 0.5));
        CHECK(at.cosine_less_whole == split(at.whole));
    }
    for (int n = 0; n < 256; ++n) {
        INFO("entry " << n);
        const elementary::Power& power = elementary::powers[n];
        const Exact exponent(n / 256.0);
        mpfr_exp2(x.x, exponent.x, MPFR_RNDN);
        CHECK(power.value == mpfr_get_d(x.x, MPFR_RNDN));
        mpfr_div_d(x.x, x.x, power.value, MPFR_RNDN);
        CHECK(power.relative == split(1));
        const elementary::Logarithm& logarithm = elementary::logarithms[n];
        mpfr_set_d(rest.x, logarithm.inverse, MPFR_RNDN);
        mpfr_log(x.x, rest.x, MPFR_RNDN);
        mpfr_neg(x.x, x.x, MPFR_RNDN);
        CHECK(logarithm.low == split(logarithm.high));
        CHECK(logarithm.high * 0x1p42 == std::trunc(logarithm.high * 0x1p42));
    }
    mpfr_t bits;
    mpfr_init2(bits, 1300);
    mpfr_const_pi(bits, MPFR_RNDN);
    mpfr_ui_div(bits, 2, bits, MPFR_RNDN);
    for (int n = 2; n < 22; ++n) {
        mpfr_mul_2ui(bits, bits, 32, MPFR_RNDN);
        const std::uint64_t high = mpfr_get_ui(bits, MPFR_RNDZ);
        mpfr_sub_ui(bits, bits, high, MPFR_RNDN);
        mpfr_mul_2ui(bits, bits, 32, MPFR_RNDN);
        const std::uint64_t low = mpfr_get_ui(bits, MPFR_RNDZ);
        mpfr_sub_ui(bits, bits, low, MPFR_RNDN);
        CHECK(elementary::two_over_pi[n] == (high << 32U | low));
    }
    mpfr_clear(bits);
    CHECK(elementary::pi_high == mpfr_get_d(pi.x, MPFR_RNDN));
    mpfr_set(x.x, pi.x, MPFR_RNDN);
    CHECK(elementary::pi_low == split(elementary::pi_high));
    for (int n = 0; n < 28; ++n) {
        mpfr_fac_ui(x.x, static_cast<unsigned long>(n), MPFR_RNDN);
        mpfr_ui_div(x.x, 1, x.x, MPFR_RNDN);
        CHECK(elementary::inverse_factorials[n] == mpfr_get_d(x.x, MPFR_RNDN));
    }
}

TEST_CASE("products are exact in two parts, by the instruction of the processor and without it", "[elementary]") {
    std::mt19937_64 random(3);
    const auto number = [&](int exponent) {
        const double sized = std::ldexp(static_cast<double>(random() >> 11U), static_cast<int>(random() % 780) - 390 - 53);
        return std::ldexp(random() % 2 == 0 ? sized : -sized, exponent);
    };
    int differ = 0;
    double a_differing = 0, b_differing = 0;
    for (int n = 0; n < 100000; ++n) {
        const double a = number(0), b = number(0), product = a * b, low = std::fma(a, b, -product);
        const double a_1 = elementary::rounded_half(a), b_1 = elementary::rounded_half(b);
        const elementary::Parts by_halves = elementary::product_by_halves(a, b, a_1, b_1);
        const elementary::Parts fused = elementary::exact_product_in_range(a, b);
        const double near_product = std::nextafter(-product, 0), far = number(-500);
        if (by_halves.high == product && by_halves.low == low && fused.high == product && fused.low == low &&
            elementary::fused_product(a, b, near_product) == std::fma(a, b, near_product) &&
            elementary::fused_product(a, far, far) == std::fma(a, far, far))
            continue;
        ++differ;
        a_differing = a;
        b_differing = b;
    }
    INFO(tests::hexadecimal(a_differing) << " " << tests::hexadecimal(b_differing));
    CHECK(differ == 0);
}
