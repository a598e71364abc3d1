#include "denhartog/program/json/solution_json.hpp"

#include <limits>

#include "denhartog/denhartog.hpp"
#include "tests/catch.hpp"
#include "tests/support/paper_systems.hpp"

using namespace denhartog;

TEST_CASE("a multiplier that has no bound is printed with null for it", "[program][stability]") {
    Scene<double> scene;
    scene.system = single_mass(0.01);
    scene.r = 0.1;
    scene.beta = 0.2;
    Solution s = solve(scene);
    REQUIRE(s.stability);
    REQUIRE(s.stability->multipliers.size() == 2);
    s.stability->multipliers.back().error = std::numeric_limits<double>::infinity();
    const program::Json bounds = program::solution_json(s, {})["multiplier_error_bounds"];
    REQUIRE(bounds.size() == 2);
    CHECK(bounds.front().is_number());
    CHECK(bounds.back().is_null());
}
