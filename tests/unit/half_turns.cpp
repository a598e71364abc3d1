#include "denhartog/number/reduced_angle.hpp"

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;

namespace {

// Quarters of a turn are exact, however many turns there are before them.
template <class T>
void check_quarters(const T& whole_turns) {
    for (const int sign : {1, -1}) {
        const auto at = [&](double quarters) { return T(sign * (2 * whole_turns + T(quarters) / 2)); };
        REQUIRE(sine_of_half_turns(at(1)) == sign);
        REQUIRE(sine_of_half_turns(at(3)) == -sign);
        REQUIRE(cosine_of_half_turns(at(0)) == 1);
        REQUIRE(cosine_of_half_turns(at(1)) == 0);
        REQUIRE(cosine_of_half_turns(at(2)) == -1);
    }
}

} // namespace

TEST_CASE("half turns are counted beyond the largest int", "[number]") {
    for (const double whole_turns : {0.0, 3.0, 0x1p29, 0x1p30, 0x1p31, 0x1p33, 0x1p49}) {
        check_quarters(whole_turns);
        check_quarters(Real50(whole_turns));
    }
    check_quarters(Real100("1e60"));
}

TEST_CASE("few half turns have the sine and cosine of 50 digits, rounded once", "[number]") {
    std::mt19937_64 random(5);
    const auto units = [](double value, const Real50& exact) {
        const double unit = std::ldexp(1.0, std::ilogb(static_cast<double>(exact)) - 52);
        return static_cast<double>(abs(Real50(value - exact))) / unit;
    };
    for (int trial = 0; trial < 2000; ++trial) {
        const double x =
            std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 60) - 98) * (trial % 2 == 0 ? 1 : -1);
        REQUIRE(units(sine_of_half_turns(x), boost::math::sin_pi(Real50(x))) < 0.51);
        REQUIRE(units(cosine_of_half_turns(x), boost::math::cos_pi(Real50(x))) < 0.51);
    }
}

TEST_CASE("an angle that is not finite has neither sine nor cosine", "[number]") {
    for (const double x : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        REQUIRE(std::isnan(sine_of_half_turns(x)));
        REQUIRE(std::isnan(cosine_of_half_turns(-x)));
    }
}
