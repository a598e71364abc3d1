#include <algorithm>
#include <cmath>

#include "denhartog/formulas/other_masses.hpp"
#include "tests/support/invariant_points.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/program_table.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

Scene<double> undamped(Scene<double> scene) {
    std::fill(scene.system.damping_ratios.begin(), scene.system.damping_ratios.end(), 0.0);
    return scene;
}

Scene<double> two_masses(std::size_t j, std::size_t l) { return chain({1, 1}, {1, 1}, {0, 0}, j, l, 1, 1); }

std::vector<InvariantPointsOfMass<double>> points_of(const Scene<double>& scene, double r_a, double r_b) {
    return invariant_points_of(scene.system, r_a, r_b);
}

ModeSums<double> sums_at(Scene<double> scene, double r) {
    scene.r = r;
    return sums_of(scene);
}

double monoharmonic(const ModeSums<double>& s, std::size_t k, double beta) {
    const std::size_t j = s.contact.index;
    return paper::displacement_transmissibility(s.V[k], s.V[j], s.U[j], s.U[k], s.G[k], beta);
}

} // namespace

TEST_CASE("at an invariant point the monoharmonic amplitude is the same at every friction ratio", "[eq:87][eq:52][invariant]") {
    double worst = 0;
    int points = 0;
    for (const Scene<double>& scene : {two_masses(2, 1), two_masses(1, 2), two_masses(1, 1), undamped(three_masses())})
        for (const InvariantPointsOfMass<double>& mass : points_of(scene, 0.15, 2.5)) {
            CHECK(mass.undecided.empty());
            for (const InvariantPoint<double>& point : mass.points) {
                const ModeSums<double> s = sums_at(scene, point.r);
                const std::size_t j = s.contact.index, k = mass.mass.index;
                const double beta = boundary(s, 1.0).exact;
                for (const double fraction : {0.125, 0.5, 0.875}) {
                    const double amplitude =
                        k == j ? paper::displacement_transmissibility_of_contact(s.V[j], s.U[j], s.G[j], fraction * beta)
                               : monoharmonic(s, k, fraction * beta);
                    worst = std::max(worst, std::abs(amplitude / point.amplitude - 1));
                }
                ++points;
                CAPTURE(k, point.r);
                if (point.kind == InvariantPointKind::friction_leaves_it_alone)
                    CHECK(std::abs(s.U[k]) < 1e-9 * (1 + std::abs(s.V[k].re)));
                else
                    CHECK(std::abs(paper::invariant_point_function(s.V[k].re, s.V[j].re, s.U[k], s.U[j])) < 1e-9);
            }
        }
    CHECK(points > 60);
    CHECK(worst < 1e-10);
}

TEST_CASE("no stretch stays undecided", "[eq:87][invariant]") {
    int points = 0;
    for (const RandomScene<double>& scene : random_scenes<double>(31)) {
        if (number_of_masses(scene.scene.system) > 4) continue;
        for (const InvariantPointsOfMass<double>& mass : points_of(scene.scene, 0.25, 3.0)) {
            CAPTURE(scene.name, mass.mass.index);
            CHECK(mass.undecided.empty());
            points += static_cast<int>(mass.points.size());
        }
    }
    CHECK(points > 2000);
}

TEST_CASE("damping ratios do not matter for invariant points", "[eq:87][invariant]") {
    const auto with = points_of(three_masses(), 0.5, 2.0), without = points_of(undamped(three_masses()), 0.5, 2.0);
    for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(with[k].points.size() == without[k].points.size());
        for (std::size_t n = 0; n < with[k].points.size(); ++n) CHECK(with[k].points[n].r == without[k].points[n].r);
    }
}

TEST_CASE("the program lists the invariant points of every mass", "[eq:87][invariant][program]") {
    const std::string scene = R"(two {"damping_ratios": 0.01, "r": 0.8, "beta": null})";
    const auto found = points_of(two_masses(2, 1), 0.5, 2.5);
    for (const std::string& digits : {std::string(), std::string(" --digits 12")}) {
        const nlohmann::json masses =
            answer_of("boundary --json --invariant-points 0.5:2.5" + digits, scene).at("invariant_points");
        REQUIRE(masses.size() == 2);
        for (std::size_t k = 0; k < 2; ++k) {
            CHECK(masses[k]["mass"] == k + 1);
            CHECK_FALSE(masses[k].contains("undecided"));
            REQUIRE(masses[k]["points"].size() == found[k].points.size());
            for (std::size_t n = 0; n < found[k].points.size(); ++n) {
                CHECK(masses[k]["points"][n]["r"].get<double>() == Approx(found[k].points[n].r).epsilon(1e-12));
                CHECK(masses[k]["points"][n]["amplitude"].get<double>() == Approx(found[k].points[n].amplitude).epsilon(1e-10));
                const bool by_87 = found[k].points[n].kind == InvariantPointKind::two_effects_cancel;
                CHECK(masses[k]["points"][n]["kind"] == (by_87 ? "87" : "U_k = 0"));
            }
        }
    }
    expect("0 boundary --invariant-points 0.5:2.5 < " + scene + " > invariant at r\n" + //
           "2 boundary --json --invariant-points {0.5|0.5:|2:1|0:1|1e-9:1|a:b} < " + scene);
    const auto first_point = [&](int digits) {
        const auto masses = answer_of("boundary --json --invariant-points 0.5:2.5 --digits " + std::to_string(digits), scene);
        return masses.at("invariant_points")[0]["points"][0]["r"].get<std::string>();
    };
    CHECK(first_point(60).size() > 60);
    CHECK(first_point(60).substr(0, 28) == first_point(30).substr(0, 28));
}

TEST_CASE("a range of frequency ratios that breaks a rule is named", "[eq:87][invariant]") {
    CHECK_THROWS_AS(points_of(two_masses(2, 1), 0.0, 1.0), InputError);
    CHECK_THROWS_AS(points_of(two_masses(2, 1), 1.0, 1.0), InputError);
    CHECK_THROWS_AS(points_of(two_masses(2, 1), 1.0, std::nan("")), InputError);
    CHECK_THROWS_AS(points_of(two_masses(3, 1), 0.5, 1.0), InputError);
}
