// Scenes of every kind, random, against routes that share nothing with the answer: the half-period by the exponential of the
// state in more digits, which knows no modes and no coordinates of the contact; and the paper's Runge-Kutta.
#include "tests/support/kinds_of_scenes.hpp"
#include "tests/properties/against_witness.hpp"
#include "tests/support/named_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

// A kind of scenes: one in `every` is compared, and `least` must be comparable.
struct Kind {
    const char* name;
    std::vector<RandomScene<double>> (*scenes)(std::uint64_t seed);
    std::uint64_t seed;
    struct Taken {
        std::size_t every;
        int least;
    } to_12_digits, to_45_digits; // the latter of the first scenes only
    std::size_t first;
    std::uint64_t seed_of_stops;
    Taken with_stops;
    int surveys;         // seeds of which every scene is compared
    int least_in_survey; // as many of these must be comparable to 12 digits
};

const Kind kinds[] = {
    {"contact and load as vectors", random_vector_scenes, 20261, {6, 70}, {20, 5}, 120, 20263, {3, 60}, 2, 800},
    {"damping that couples the modes", random_coupled_scenes, 20262, {7, 60}, {20, 3}, 80, 20264, {3, 40}, 2, 700},
    {"forces out of phase", random_phased_scenes, 20264, {9, 45}, {24, 4}, 120, 20266, {4, 20}, 2, 500},
    {"moving bases and walls", random_base_scenes, 20265, {18, 20}, {22, 4}, 110, 20268, {4, 15}, 1, 200},
    {"any direction of the contact", random_direction_scenes, 20267, {2, 200}, {20, 4}, 120, 20270, {3, 40}, 1, 350}};

} // namespace

TEST_CASE("the closed form agrees with the second witness to 12 digits in scenes of every kind",
          "[eq:33][eq:34][eq:35][eq:38][eq:39][eq:46][eq:65][vectors][coupled-damping][phases][base][direction][witness]") {
    for (const Kind& kind : kinds) {
        INFO(kind.name);
        check_by_witness<double>(kind.scenes(kind.seed), kind.to_12_digits.every, 12, kind.to_12_digits.least);
    }
}

TEST_CASE("the closed form agrees with the second witness to 45 digits in scenes of every kind",
          "[eq:33][eq:38][vectors][coupled-damping][phases][base][direction][witness]") {
    for (const Kind& kind : kinds) {
        INFO(kind.name);
        std::vector<RandomScene<double>> scenes = kind.scenes(kind.seed + 1);
        scenes.resize(kind.first);
        check_by_witness<Real50>(scenes, kind.to_45_digits.every, 45, kind.to_45_digits.least);
    }
}

TEST_CASE("every scene of every kind agrees with the second witness to 12 digits",
          "[.][sweep][vectors][coupled-damping][phases][base][direction][witness]") {
    for (const Kind& kind : kinds) {
        INFO(kind.name);
        int compared = 0;
        for (int n = 0; n < kind.surveys; ++n)
            compared += survey_by_witness<double>(kind.scenes(kind.seed + static_cast<std::uint64_t>(n)), 12, SIZE_MAX);
        std::printf("%s: %d scenes\n", kind.name, compared);
        CHECK(compared >= kind.least_in_survey);
    }
}

TEST_CASE("every scene of every kind with up to four masses agrees with the second witness to 45 digits",
          "[.][sweep][vectors][coupled-damping][phases][base][direction][witness]") {
    for (const Kind& kind : kinds) {
        INFO(kind.name);
        for (int n = 0; n < kind.surveys; ++n)
            CHECK(survey_by_witness<Real50>(kind.scenes(kind.seed + static_cast<std::uint64_t>(n)), 45, 4) > 0);
    }
}

TEST_CASE("stick-slip in scenes of every kind is the paper's algorithm's",
          "[eq:74][eq:75][vectors][coupled-damping][phases][base][direction]") {
    for (const Kind& kind : kinds) {
        INFO(kind.name);
        const int most = kind.with_stops.least;
        CHECK(compare_stick_slip_with_paper(kind.scenes(kind.seed_of_stops), kind.with_stops.every, most) == most);
    }
}

TEST_CASE("map and motion of scenes of every kind are those of solve", "[vectors][coupled-damping][phases][base][direction]") {
    const std::vector<double> r{0.5, 0.75, 1.5}, beta{0.0625, 0.5, 4};
    for (const std::string kind :
         {R"({"contact": [1, 2], "load": [0.25, 1, 0.5]})", R"({"load": [1, 0.5, 0.25], "load_phases": [0, 1.25, -2]})",
          R"({"load": null, "base_motion": "alone"})", R"({"load": null, "base_motion": "wall"})",
          R"({"contact": {"direction": [0.5, -1, 1.5]}, "load": [0.25, 1, 0.5]})",
          R"({"contact": {"direction": [0, -0.5, 0.25]}})", R"({"damping_ratios": [0.0625, 1.5, 0.25]})"}) {
        INFO(kind);
        CHECK(check_map_by_solve(named_scene("storeys " + kind), r, beta) > 0);
    }
    CHECK(check_map_by_solve(named_scene("dashpots"), {0.3, 0.5, 1.5}, {0.01, 0.3, 0.9, 4}) > 0);
}
