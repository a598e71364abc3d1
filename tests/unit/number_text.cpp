#include "denhartog/number/number_text.hpp"

#include <cstdlib>
#include <limits>
#include <random>

#include "tests/catch.hpp"

using namespace denhartog;

namespace {

double read(std::string_view text) {
    double x = -7;
    INFO(text);
    REQUIRE(number_from_text(text, x) == NumberFault::none);
    return x;
}

} // namespace

TEST_CASE("decimal text is rounded to the nearest double", "[scene][number]") {
    std::mt19937_64 random(11);
    for (int trial = 0; trial < 2000; ++trial) {
        std::string text = random() % 2 == 0 ? "-" : "";
        text += std::to_string(random() % 10) + "." + std::to_string(random()) + std::to_string(random() % 1000);
        text += (random() % 2 == 0 ? "e" : "E-") + std::to_string(random() % 300);
        REQUIRE(read(text) == std::strtod(text.c_str(), nullptr));
    }
}

TEST_CASE("a number written as text is read again as the same number", "[scene][number]") {
    std::mt19937_64 random(12);
    for (int trial = 0; trial < 200; ++trial) {
        const double x = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 400) - 230);
        REQUIRE(read(number_to_text(x)) == x);
    }
}

TEST_CASE("text that is no number is refused", "[scene][number]") {
    const std::string text = GENERATE("", " ", "nan", "NaN", "inf", "-inf", "Infinity", "abc", "1 ", " 1", "1,5", "0x1p3", "1e",
                                      "1e+", "--1", "+1", ".5", "5.", "007", "-", "1.2.3", "1e5.0", "1e+-5", "1_000", "½");
    double x = 3;
    INFO(text);
    REQUIRE(number_from_text(text, x) == NumberFault::no_number);
    REQUIRE(x == 3);
}

TEST_CASE("a number beyond the type is refused and not rounded to zero or infinity", "[scene][number]") {
    double x = 3;
    REQUIRE(number_from_text("1e309", x) == NumberFault::too_large);
    REQUIRE(number_from_text("-1e309", x) == NumberFault::too_large);
    REQUIRE(number_from_text("1e-400", x) == NumberFault::too_small);
    REQUIRE(number_from_text("0." + std::string(400, '0') + "1", x) == NumberFault::too_small);
    REQUIRE(number_from_text("0." + std::string(800, '0') + "1e400", x) == NumberFault::too_small);
    REQUIRE(number_from_text("1" + std::string(400, '0'), x) == NumberFault::too_large);
    REQUIRE(number_from_text("1" + std::string(800, '0') + "e-400", x) == NumberFault::too_large);
    REQUIRE(number_from_text("0.0e-400", x) == NumberFault::none);
    REQUIRE(x == 0);
    REQUIRE(read("4.9406564584124654e-324") == std::numeric_limits<double>::denorm_min());
    REQUIRE(read("1.7976931348623157e308") == std::numeric_limits<double>::max());
    double y = 3;
    REQUIRE(number_from_text("1e1000000000", y) == NumberFault::too_long);
    REQUIRE(number_from_text("1e99999999999999999999", y) == NumberFault::too_long);
    REQUIRE(number_from_text(std::string(6000, '1'), y) == NumberFault::too_long);
    REQUIRE(y == 3);
}

TEST_CASE("numbers that are none are named", "[scene][number]") {
    REQUIRE(number_to_text(std::numeric_limits<double>::quiet_NaN()) == "nan");
    REQUIRE(number_to_text(-std::numeric_limits<double>::infinity()) == "-inf");
    REQUIRE(number_to_text(0.1) == "0.1");
}

TEST_CASE("a number for people has the digits that its error leaves", "[number]") {
    CHECK(number_in_certain_digits(0.63974569583012345, 0.0) == "0.63974569583");
    CHECK(number_in_certain_digits(0.63974569583012345, 1e-16) == "0.63974569583");
    CHECK(number_in_certain_digits(0.63974569583012345, 4e-10) == "0.639745696");
    CHECK(number_in_certain_digits(-0.63974569583012345, 0.03) == "-0.6");
    CHECK(number_in_certain_digits(1e-51, 7.9e-46) == "0 to within 7.9e-46");
    CHECK(number_in_certain_digits(-1e-51, 1e300 * 1e300) == "0 to within inf");
    CHECK(number_in_certain_digits(0.0, 1e-50) == "0");
}
