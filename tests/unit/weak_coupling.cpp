// Modes that a damping matrix couples by less than rounding tells.
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/sums/coupled_sums.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;

TEST_CASE("a coupling below rounding counts in a second damping function next to a pole", "[modes][damping][eq:35]") {
    // An undamped mode next to an eleventh of its frequency beside damped ones: their coupling of 1e-24 makes 1.5e-16 of G_1.
    const char* text = R"({"mass_ratios": [1, 1.706606325004763, 0.4032277098542443],
        "stiffness_ratios": [1, 8.881784197001252e-16, 1], "damping_matrix": [[0, 0, 0],
        [0, 1.2648251221268454e-08, -1.2648251221268454e-08], [0, -1.2648251221268454e-08, 1.2648251221268454e-08]],
        "contact": 2, "load": 1, "r": 0.09090909094014846, "beta": 0.025})";
    const Quantities<Bounded<double>> narrow = quantities(scene_source(SceneText{text}), {}, 10, PointNumbers::sums).numbers;
    const Scene<Real50> wide_scene = read_scene<Real50>(text);
    const ModeSums<Real50> wide = values_of(coupled_sums(wide_scene.system, Bounded<Real50>(*wide_scene.r)));
    CHECK(wide.G[0] < -1e-16);
    const double of_wide = 1 + 1e-6; // which loses digits next to the pole, and the bound is hardly more than a rounding to double
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(abs(Real50(wide.G[k] - narrow.G[k].x)) <= of_wide * narrow.G[k].e);
        CHECK(abs(Real50(wide.U[k] - narrow.U[k].x)) <= of_wide * narrow.U[k].e);
    }
}
