// Contacts between two masses and loads on several: what must be the same, named or built otherwise.
#include <cmath>

#include "denhartog/denhartog.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

TEST_CASE("two masses that rub against each other may be named in either order", "[vectors]") {
    const std::string chain =
        R"({"mass_ratios": [1, 2, 1.5], "stiffness_ratios": [1, 0.75, 1.25], "damping_ratios": [0.05, 0.04, 0.06],
            "load": [0.25, 1, 0.5], "r": 0.75, "contact": )";
    for (const std::string beta : {"0.0625", "0.25"}) {
        const Solution a = solve(scene(chain + R"([1, 3], "beta": )" + beta + "}"));
        const Solution b = solve(scene(chain + R"([3, 1], "beta": )" + beta + "}"));
        INFO("beta = " << beta);
        CHECK(b.between.value().amplitude.value == Approx(a.between.value().amplitude.value).epsilon(1e-9));
        CHECK(std::abs(std::cos(b.between->phase.value().value - a.between->phase.value().value) + 1) < 1e-9);
        for (std::size_t k = 0; k < 3; ++k) CHECK(b.amplitude(Mass{k}).value == Approx(a.amplitude(Mass{k}).value).epsilon(1e-9));
    }
}

TEST_CASE("a mass that cannot move is a wall", "[vectors]") {
    // The last mass of three is heavy: rubbing against it is rubbing against a wall, as a chain of two does.
    const std::string heavy =
        R"({"mass_ratios": [1, 2, 1e6], "stiffness_matrix": [[1.75, -0.75, 0], [-0.75, 0.75, 0], [0, 0, 1]],
        "damping_matrix": [[0.1, 0, 0], [0, 0.2, 0], [0, 0, 1e5]], "contact": [2, 3], "load": 1, "r": 0.875, "beta": )";
    const std::string wall = R"({"mass_ratios": [1, 2], "stiffness_matrix": [[1.75, -0.75], [-0.75, 0.75]],
        "damping_matrix": [[0.1, 0], [0, 0.2]], "contact": 2, "load": 1, "r": 0.875, "beta": )";
    for (const char* beta : {"0.125", "0.5", "2"}) {
        const Solution a = solve(scene(heavy + beta + "}")), b = solve(scene(wall + beta + "}"));
        INFO("beta = " << beta);
        CHECK(a.regime.regime == b.regime.regime);
        CHECK(a.stops.size() == b.stops.size());
        for (std::size_t k = 0; k < 2; ++k)
            CHECK(a.masses[k].amplitude.value == Approx(b.masses[k].amplitude.value).margin(1e-4)); // it moves by a millionth
    }
}
