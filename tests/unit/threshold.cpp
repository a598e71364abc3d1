#include "derivation/claims/threshold.hpp"

#include "tests/catch.hpp"
#include "tests/support/largest_over_range.hpp"

using namespace denhartog;
using namespace denhartog::derivation;

TEST_CASE("a threshold decides where another number turns the verdict and is not empty", "[ledger][thresholds]") {
    CHECK(decides({"relative error", 0.01, 0.3, 1}));
    CHECK_FALSE(decides({"ratio", 0.1, 5, 1}));
    CHECK(decides({"degrees between phases", 15, 4, 0}));
    CHECK_FALSE(decides({"fall", 0.01, -0.2, 0}));
    CHECK(decides({"distance", 0.2, 5}));
    CHECK(refuted_whatever_the_threshold({}));
    CHECK_FALSE(refuted_whatever_the_threshold({{"ratio", 0.1, 5, 1}, {"relative error", 0.01, 0.3, 1}}));
}

TEST_CASE("thresholds go through JSON and back", "[ledger][thresholds]") {
    const std::vector<Threshold> list{{"relative error", 0.01, 0.3, 1}, {"distance", 0.2, 5}};
    const std::vector<Threshold> back = thresholds_from_json(thresholds_to_json(list));
    REQUIRE(back.size() == 2);
    CHECK(sentence(back[0]) == "relative error: 0.01 taken, turns at 0.3");
    CHECK(back[0].empty == 1.0);
    CHECK_FALSE(back[1].empty.has_value());
}

TEST_CASE("the largest value over a range is found between the points of the grid", "[ledger]") {
    const auto peak = [](double x) { return 1 / (1e-4 + (x - 0.2295) * (x - 0.2295)) + std::sin(9 * x); };
    const LargestOverRange found = largest_over_range(peak, 0, 3, 100);
    CHECK(found.x == Approx(0.2295).margin(1e-5));
    CHECK(found.value == Approx(peak(0.2295)).epsilon(1e-8));
    const auto with_a_hole = [&](double x) { return x > 1 ? std::nan("") : x; };
    CHECK(largest_over_range(with_a_hole, 0, 3, 90).value == Approx(1).margin(1e-6));
}
