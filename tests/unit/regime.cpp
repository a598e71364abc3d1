#include "denhartog/sliding/boundary.hpp"

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/support/plain_response.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

Boundary<Bounded<double>> known_exactly(const Boundary<double>& boundary) {
    Boundary<Bounded<double>> b{};
    b.exact = Bounded<double>(boundary.exact);
    if (boundary.sticking) b.sticking = Bounded<double>(*boundary.sticking);
    b.binding = boundary.binding;
    return b;
}

Response<double> response_of(Scene<double> scene, double beta) {
    scene.beta = beta;
    return response(scene);
}

} // namespace

TEST_CASE("the regimes follow each other as friction grows", "[eq:69][regime]") {
    const Scene<double> scene = three_masses();
    const Boundary<double> b = boundary(sums_of(scene), scene.mu);
    REQUIRE(b.exact < *b.sticking);
    CHECK(regime_at(known_exactly(b), 0.0).regime == Regime::continuous);
    CHECK(regime_at(known_exactly(b), std::nextafter(b.exact, 0.0)).regime == Regime::continuous);
    CHECK(regime_at(known_exactly(b), b.exact).regime == Regime::stick_slip);
    CHECK(regime_at(known_exactly(b), std::nextafter(*b.sticking, 0.0)).regime == Regime::stick_slip);
    CHECK(regime_at(known_exactly(b), *b.sticking).regime == Regime::permanent_sticking);
    CHECK(regime_at(known_exactly(b), 100.0).regime == Regime::permanent_sticking);
}

TEST_CASE("outside the sliding regime there is a reason and no steady state", "[eq:69][regime]") {
    const Response<double> slipping = response_of(three_masses(), 0.75);
    CHECK(slipping.regime->regime == Regime::stick_slip);
    CHECK_FALSE(slipping.steady_state);
    CHECK(in_words(slipping.regime->reason).find("is not below beta_lim = ") != std::string::npos);
    CHECK(in_words(slipping.regime->reason).find("(54)b") != std::string::npos);
    const Response<double> resting = response_of(three_masses(), 4);
    CHECK(resting.regime->regime == Regime::permanent_sticking);
    CHECK_FALSE(resting.steady_state);
    CHECK(in_words(resting.regime->reason).find("never moves") != std::string::npos);
    const Response<double> sliding = response_of(three_masses(), 0.125);
    CHECK(sliding.regime->regime == Regime::continuous);
    CHECK(sliding.steady_state);
    CHECK(sliding.regime->other.empty());
}

TEST_CASE("with much static friction a contact that slides could also rest", "[eq:69][regime]") {
    // The dynamic load at resonance is far above the load at rest, which alone decides whether a contact at rest stays there.
    const Scene<double> scene = oscillator(0.0078125, 1, 2);
    const Boundary<double> b = boundary(sums_of(scene), scene.mu);
    REQUIRE(*b.sticking == 0.5);
    REQUIRE(b.exact > 0.625);
    const Response<double> both = response_of(scene, 0.5625);
    CHECK(both.regime->regime == Regime::continuous);
    CHECK(both.steady_state);
    CHECK(both.regime->other == std::vector<Regime>{Regime::permanent_sticking});
}

TEST_CASE("a friction ratio within rounding of a boundary is said to be there", "[regime]") {
    const Scene<double> scene = three_masses();
    const Boundary<double> b = boundary(sums_of(scene), scene.mu);
    CHECK(response_of(scene, b.exact).regime->on_boundary);
    CHECK(response_of(scene, b.exact * (1 + 1e-15)).regime->on_boundary);
    CHECK(response_of(scene, *b.sticking).regime->on_boundary);
    CHECK_FALSE(response_of(scene, b.exact * (1 + 1e-12)).regime->on_boundary);
    CHECK_FALSE(response_of(scene, b.exact * (1 - 1e-12)).regime->on_boundary);
}

TEST_CASE("without friction the contact slides if the load reaches it", "[regime]") {
    CHECK(response_of(three_masses(), 0).regime->regime == Regime::continuous);
    const Response<double> unmoved = response_of(chain({1, 1}, {1, 1}, {0, 0}, 1, 1, 1, 1), 0);
    CHECK(unmoved.regime->regime != Regime::continuous);
    CHECK_FALSE(unmoved.steady_state);
}

TEST_CASE("a friction ratio that is none is refused", "[domain]") {
    const Boundary<double> b = boundary(sums_of(three_masses()), 1.375);
    for (const double beta : {-0.125, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        CHECK_THROWS_AS(regime_at(known_exactly(b), beta), InputError);
}

TEST_CASE("a response needs a frequency ratio; without beta it is the boundary alone", "[domain]") {
    Scene<double> scene = three_masses();
    CHECK_FALSE(response(scene).regime);
    CHECK(response(scene).boundary.exact > 0);
    scene.r.reset();
    CHECK_THROWS_AS(response(scene), InputError);
}

TEST_CASE("regimes have the names of the interface", "[regime]") {
    CHECK(name(Regime::continuous) == "continuous");
    CHECK(name(Regime::stick_slip) == "stick_slip");
    CHECK(name(Regime::permanent_sticking) == "permanent_sticking");
}
