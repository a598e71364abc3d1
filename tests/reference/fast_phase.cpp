// A phase by its free motions is the phase by the exponential of its matrix.
#include "denhartog/reference/phases.hpp"

#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"
#include "tests/reference/proofs.hpp"
#include "tests/support/named_scenes.hpp"

using namespace denhartog;
using namespace denhartog::reference;
using namespace denhartog::tests;

namespace {

const std::string scenes[] = {
    "slow", R"(slow {"contact": [3, 1], "load": [0.5, -1, 0.25], "r": 0.7, "mu": null})",
    R"(coupled {"mass_ratios": [1, 2], "stiffness_ratios": [1, 2], "damping_matrix": [[0.2, -0.1], [-0.1, 0.3]], "contact": 1,
        "load": 2, "r": 0.2, "beta": 0.1})",
    R"(one critical {"damping_ratios": 1.5, "beta": 0.1})"};
const std::string out_of_phase =
    R"(pair {"stiffness_ratios": [1, 2], "damping_ratios": 0.05, "load": [1, 0.5], "load_phases": [0, 1.25], "r": 0.6, "beta": 0.2})";

ContactMechanics mechanics_of(const std::string& scene) {
    SceneInBalls s = matrices_of_text(text_of_scene(scene));
    if (!s.zeta.empty()) s.C = damping_matrix_in_balls(s, modes_in_balls(s));
    return ContactMechanics(s);
}

// A state in which the contact has no velocity, as in a phase of sticking.
BallMatrix some_state(const ContactMechanics& s) {
    BallMatrix Z(s.n(), 1);
    Ball along(0);
    for (slong k = 0; k < 2 * s.N; ++k) Z(k) = Ball(1 + k) / Ball(7) - Ball(k * k) / Ball(11);
    for (slong k = 0; k < s.N; ++k) along += k == s.lead ? Ball(0) : s.w(k) * Z(s.N + k);
    Z(s.N + s.lead) = -along / s.w(s.lead);
    Z(2 * s.N) = cos(Ball(0.4));
    Z(2 * s.N + 1) = sin(Ball(0.4));
    Z(2 * s.N + 2) = Ball(1);
    return Z;
}

BallMatrix by_exponential(const ContactMechanics& s, int direction, const Ball& length) {
    return exp(s.phase(direction) * length) * some_state(s);
}

} // namespace

TEST_CASE("a phase by its free motions, or of sliding by its modes, ends as by the exponential of its matrix",
          "[reference][fast_phase][eq:20][eq:21]") {
    const Bits enough(256);
    int compared = 0;
    const auto check = [&](const BallMatrix& found, const BallMatrix& by_matrix, const BallMatrix& other,
                           const BallMatrix& expected) {
        bool differs = false;
        for (slong k = 0; k < found.rows(); ++k, ++compared) {
            CHECK(apart(found(k), expected(k)) == 0);
            CHECK(apart(by_matrix(k), expected(k)) == 0);
            CHECK(found(k).radius() < 1e-40);
            differs = differs || apart(other(k), expected(k)) > 0;
        }
        CHECK(differs); // the test would tell
    };
    for (const std::string& text : {scenes[0], scenes[1], scenes[2], scenes[3], out_of_phase})
        for (const int direction : {1, -1, 0}) {
            const ContactMechanics s = mechanics_of(text);
            REQUIRE(bool(s.sliding) == (text != scenes[2] && text != scenes[3]));
            const PhasesByFreeMotions fast(s, direction);
            for (const double length : {0.0, 0.03, 1.75}) {
                INFO(text << ", direction " << direction << ", length " << length);
                const BallMatrix start = some_state(s), expected = by_exponential(s, direction, Ball(length));
                check(fast.state(start, Ball(length)), fast.propagator(Ball(length)) * start,
                      fast.state(start, Ball(length + 1e-9)), expected);
                if (!s.sliding || direction == 0) continue;
                const BallMatrix other = s.after_sliding(start, Ball(length + 1e-9), -direction);
                check(s.after_sliding(start, Ball(length), direction), s.propagator(direction, Ball(length)) * start, other,
                      expected);
            }
        }
    CHECK(compared > 450);
}

TEST_CASE("a number over a phase has the rates of its matrix, at every instant of a stretch", "[reference][fast_phase]") {
    const Bits enough(256);
    for (const std::string& text : scenes)
        for (const int direction : {1, 0}) {
            INFO(text << ", direction " << direction);
            const ContactMechanics s = mechanics_of(text);
            const BallMatrix A = s.phase(direction);
            for (slong which = 0; which < s.n(); ++which) {
                BallMatrix row(1, s.n());
                row(0, which) = Ball(1);
                const NumberInTime number = PhasesByFreeMotions(s, direction).number(row, some_state(s));
                const Series over = number(Ball::within(0.5, 0.625));
                for (const double t : {0.5, 0.5625, 0.625}) {
                    const BallMatrix Z = by_exponential(s, direction, Ball(t));
                    const Series at = number(Ball(t));
                    BallMatrix rate = row;
                    for (int order = 0; order < 3; ++order, rate = rate * A) {
                        CHECK(apart(at.rate(order), (rate * Z)(0)) == 0);
                        CHECK(apart(over.rate(order), (rate * Z)(0)) == 0);
                        CHECK(at.rate(order).radius() < 1e-30);
                    }
                }
                if (which == 2 * s.N) CHECK(apart(number(Ball(0.5)).rate(0), number(Ball(0.5 + 1e-9)).rate(0)) > 0);
            }
        }
}

TEST_CASE(
    "sliding is not followed by modes that are damped critically, at a pole or not told apart, or that a damping matrix couples",
    "[reference][fast_phase]") {
    const Bits enough(128);
    for (const std::string& scene : {scenes[2], scenes[3]}) CHECK(!mechanics_of(scene).sliding);
    CHECK(!mechanics_of(R"(undamped {"r": 1, "beta": 0.1})").sliding);
    CHECK(!mechanics_of(R"(unloaded contact {"damping_ratios": 0.1, "load": [1, 1], "r": 0.5, "beta": 0.1})").sliding);
}

TEST_CASE("free motions that coincide, and a resonance without damping, are not followed", "[reference][fast_phase]") {
    const Bits enough(128);
    CHECK_THROWS_WITH(PhasesByFreeMotions(mechanics_of("one critical"), 1), Catch::Contains("free motions are not told apart"));
    CHECK_THROWS_WITH(PhasesByFreeMotions(mechanics_of(R"(undamped {"r": 1, "beta": 0.1})"), 1),
                      Catch::Contains("resonance without damping"));
    CHECK_NOTHROW(PhasesByFreeMotions(mechanics_of(R"(one critical {"damping_ratios": 0.5})"), 1));
}

TEST_CASE("long phases whose free motions coincide are followed by series", "[reference][fast_phase][orbit]") {
    const std::string scene = "one critical";
    const Bits enough(128);
    const ContactMechanics s = mechanics_of(scene);
    CHECK(s.by_free_motions(1) == nullptr);
    CHECK(s.by_free_motions(0) != nullptr); // nothing moves while the contact sticks
    Question question{Asked::motion, 12};
    question.proved = true;
    const Solution proved = solve(named_source(scene), question);
    const Solution in_double = solve(named_source(scene), {Asked::motion, 6});
    REQUIRE(proved.stops.size() == 2);
    CHECK(in_double.method.precision == "double");
    for (std::size_t n = 0; n < 2; ++n) {
        CHECK(std::abs(in_double.stops[n].start.value - proved.stops[n].start.value) <= in_double.stops[n].start.error);
        CHECK(std::abs(in_double.stops[n].x.value - proved.stops[n].x.value) <= in_double.stops[n].x.error);
    }
    // so fast that series are too many
    CHECK_THROWS_WITH(solve(named_source(R"(one critical {"r": 1e-5, "beta": 1e-6})"), question),
                      Catch::Contains("too fast to be followed otherwise"));
}

TEST_CASE("motions with stops whose modes are a thousand times as fast as the force are proved",
          "[reference][fast_phase][orbit]") {
    const SceneSource source = named_source("thousandfold");
    Question question{Asked::motion, 12};
    question.proved = true;
    const Solution few = solve(source, question);
    question.digits = 40;
    const Solution more = solve(source, question);
    REQUIRE(few.stops.size() == 2);
    REQUIRE(more.stops.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(apart(ball_of(few.masses[k].amplitude), ball_of(more.masses[k].amplitude)) == 0);
        CHECK(apart(ball_of(*few.masses[k].phase), ball_of(*more.masses[k].phase)) == 0);
    }
}
