// Balls hold what they stand for, and say no more than is certain.
#include "denhartog/number/ball.hpp"

#include <cmath>
#include <limits>

#include "denhartog/answer/reference_point.hpp"
#include "tests/catch.hpp"
#include "tests/reference/proofs.hpp"
#include "tests/support/split_mix.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

double between(SplitMix64& random, double a, double b) {
    return a + (b - a) * static_cast<double>(random.next() >> 11) * 0x1p-53;
}

// Every function of one number, in both number types.
template <class T>
std::vector<T> functions_of(const T& x) {
    using std::abs, std::atan2;
    return {sqrt(T(1 + x * x)), exp(x), sin(x), cos(x), sinh(x), cosh(x), abs(x), atan2(x, T(1 + x * x)), T(-x),
            T(1 / (2 + x * x))};
}

} // namespace

TEST_CASE("a function of a ball holds the function of every number in it", "[ball]") {
    SplitMix64 random(59);
    const Bits enough(128);
    for (int n = 0; n < 200; ++n) {
        const double from = between(random, -4, 4), to = from + std::exp2(-between(random, 1, 60)),
                     at = between(random, from, to);
        const std::vector<Ball> all = functions_of(Ball::within(from, to));
        const std::vector<Real100> truth = functions_of(Real100(at));
        for (std::size_t f = 0; f < all.size(); ++f) {
            INFO("function " << f << " of " << hexadecimal(at) << ": " << in_words(all[f]));
            CHECK(apart(all[f], ball_of(truth[f])) < 1e-90);
            CHECK(all[f].radius() < 200 * (to - from) + 1e-36);
        }
    }
}

TEST_CASE("a ball of 64 bits holds the number that 256 bits tell; one with a thousandth of its radius does not", "[ball]") {
    int outside = 0;
    for (int n = 2; n < 40; ++n) {
        const auto root = [n](slong bits) {
            const Bits here(bits);
            return sqrt(Ball(n)) + exp(Ball(1) / n) * pi<Ball>();
        };
        const Ball few = root(64), many = root(256), thousandth = widened(middle(few), radius_of(few) / 1000);
        CHECK(arb_contains(few.a, many.a) != 0);
        outside += apart(thousandth, many) > 0;
    }
    CHECK(outside > 20);
}

TEST_CASE("a comparison of balls is true only where it is true of all their numbers", "[ball]") {
    const Ball low = Ball::within(1, 2), high = Ball::within(3, 4), across = Ball::within(1.5, 3.5);
    CHECK(low < high);
    CHECK(high > low);
    CHECK_FALSE(low < across);
    CHECK_FALSE(across < low);
    CHECK_FALSE(low <= across);
    CHECK_FALSE(low >= across);
    CHECK_FALSE(low == low); // two numbers of one ball may differ
    CHECK(Ball(2) == Ball(2));
    CHECK(Ball(2) <= Ball(2));
    CHECK_FALSE(Ball::within(-1, 1) < Ball(0));
    CHECK(Ball::within(-1, 1).may_vanish());
    CHECK_FALSE(Ball::within(-1, 1).is_zero());
    CHECK_FALSE(low.may_vanish());
}

TEST_CASE("what may be divided by zero, and the root of what may be negative, is not finite", "[ball]") {
    CHECK_FALSE((Ball(1) / Ball::within(-1, 1)).finite());
    CHECK_FALSE(sqrt(Ball::within(-1, 1)).finite());
    CHECK(root_of_positive(Ball::within(-1, 4)).finite());
    CHECK(root_of_positive(Ball::within(-1, 4)).high() >= 2);
    CHECK_FALSE((Ball(1) / Ball(0) < Ball(5)));
    CHECK_FALSE((Ball(1) / Ball(0) > Ball(5)));
}

TEST_CASE("intervals, decimals, midpoints and radii hold what they are made of", "[ball]") {
    const Bits enough(2048);
    const Ball tenth = Ball::of_text("0.1");
    CHECK(apart(10 * tenth, Ball(1)) == 0);
    CHECK(tenth.radius() < 1e-300);
    CHECK(apart(tenth, Ball(0.1)) > 5e-18); // the double is another number
    CHECK_FALSE(Ball::of_text("one").finite());
    const Ball x = Ball::within(0.25, 0.75);
    CHECK(x.low() <= 0.25);
    CHECK(x.high() >= 0.75);
    CHECK(middle(x) == Ball(0.5));
    CHECK(radius_of(x).low() >= 0.25);
    CHECK(upper_bound_of(x).low() >= 0.75);
    CHECK(arb_contains(either(Ball(-1), Ball(3)).a, Ball(2).a) != 0);
    CHECK(larger(Ball::within(1, 2), Ball::within(0, 3)).high() >= 3);
    CHECK(larger(Ball::within(1, 2), Ball::within(0, 3)).low() >= 1 - 1e-8);
    CHECK(widened(Ball(1), Ball(0.5)).low() <= 0.5);
    CHECK(Ball(3).certain_bits() > 1000);
    CHECK(pi<Ball>().certain_bits() > 2000);
}

TEST_CASE("bits are those of the innermost scope", "[ball]") {
    const slong before = ball_bits;
    {
        const Bits many(1000);
        CHECK((Ball(1) / 3).certain_bits() > 990);
        {
            const Bits few(64);
            CHECK((Ball(1) / 3).certain_bits() < 70);
        }
        CHECK(ball_bits == 1000);
    }
    CHECK(ball_bits == before);
}

TEST_CASE("a solution of linear equations holds the exact one, and a matrix that may be singular has none", "[ball]") {
    const Bits enough(128);
    BallMatrix A(3, 3), b(3, 1), x; // Hilbert's matrix and the sums of its rows: the solution is one for each
    for (slong i = 0; i < 3; ++i)
        for (slong k = 0; k < 3; ++k) {
            A(i, k) = Ball(1) / (i + k + 1);
            b(i) += A(i, k);
        }
    REQUIRE(solved(A, b, x));
    for (slong i = 0; i < 3; ++i) CHECK(apart(x(i), Ball(1)) == 0);
    CHECK(arb_mat_overlaps((A * x).a, b.a) != 0);
    CHECK(arb_mat_overlaps((A * (x * Ball(2))).a, b.a) == 0);
    A(2, 2) = A(2, 2) - Ball(1) / 180 + Ball::within(-1, 1) / 100; // holds a singular matrix
    CHECK_FALSE(solved(A, b, x));
    const BallMatrix zero(2, 2);
    CHECK(arb_mat_eq(exp(zero).a, unit_matrix(2).a) != 0);
    CHECK(norm(unit_matrix(4) * Ball(-3)) >= 3);
}

TEST_CASE("a printed number is within its bound of the ball, rounding of its digits included", "[ball]") {
    const Bits enough(256);
    for (const int digits : {1, 6, 15, 16, 25, 60})
        for (const int n : {3, 7, 11, -13}) {
            const Ball x = Ball(1) / n;
            const Certified shown = printed(x, digits);
            INFO(digits << " digits of 1 / " << n << ": " << shown.decimal);
            CHECK(shown.proved);
            CHECK(shown.decimal.empty() == (digits <= 15));
            CHECK(apart(ball_of(shown), x) == 0);
            const double places = digits > 15 ? digits : 16;
            CHECK(shown.error < std::pow(10, 0.2 - places));
            Certified closer = shown; // what is left of the bound without the rounding is too little
            closer.error /= 1000;
            CHECK(apart(ball_of(closer), x) > 0);
        }
    CHECK(printed(Ball(0), 20).decimal == "0");
    CHECK(printed(Ball(0.5), 20).error == 0);
    CHECK(printed(Ball(1) / 0, 20).error == std::numeric_limits<double>::infinity());
}
