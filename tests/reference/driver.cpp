// The answers of the reference: digits, regimes, kinds of scenes, and what it refuses.
#include <cmath>

#include "denhartog/answer/reference.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"
#include "tests/reference/proofs.hpp"
#include "tests/support/named_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

Solution proved(const std::string& scene, int digits, Asked asked = Asked::motion, Effort* effort = nullptr) {
    Question question{asked, digits};
    question.proved = true;
    return solve(with_effort(named_source(scene), effort), question);
}

// The digits that two numbers share, from texts d.ddd...e+00 of which one is longer.
bool begins_alike(const std::string& few, const std::string& many, std::size_t digits) {
    return few.substr(0, digits) == many.substr(0, digits) && few.substr(few.find('e')) == many.substr(many.find('e'));
}

// True if the bounds allow two answers to be one number: all decimals but the last are then those of more digits.
bool is_the_same_number(const Certified& few, const Certified& many) { return apart(ball_of(few), ball_of(many)) == 0; }

} // namespace

TEST_CASE("as many digits as are asked for are certain, and more digits begin with them", "[driver]") {
    const Bits enough(8192);
    for (const std::string text : {"tenth", "chain of three"}) {
        const Solution all = proved(text, 1000);
        for (const int digits : {1, 6, 15, 16, 30, 200, 1000}) {
            INFO(digits << " digits of " << text);
            const Solution s = proved(text, digits);
            CHECK(s.method.proved);
            CHECK(s.method.precision == "reference");
            CHECK(s.regime.regime == Regime::continuous);
            CHECK(s.relative_error <= std::pow(10, -std::min(digits, 300)));
            for (std::size_t k = 0; k < s.masses.size(); ++k) {
                const Certified &amplitude = s.masses[k].amplitude, &phase = *s.masses[k].phase;
                CHECK(amplitude.proved);
                CHECK(amplitude.decimal.empty() == (digits <= 15));
                CHECK(amplitude.error <= std::pow(10, 1 - std::min(digits, 17)) * amplitude.value);
                CHECK(is_the_same_number(amplitude, all.masses[k].amplitude));
                CHECK(is_the_same_number(phase, all.masses[k].phase.value()));
                if (digits < 16) continue;
                CHECK(amplitude.decimal.size() == static_cast<std::size_t>(digits) + 5); // the point, e-01
                CHECK(begins_alike(amplitude.decimal, all.masses[k].amplitude.decimal, static_cast<std::size_t>(digits) - 2));
            }
        }
    }
}

TEST_CASE("numbers of a point that double does not have to all digits come from the reference, proved", "[driver][eq:69]") {
    const std::vector<double> tau{0.5};
    const QuantitiesAnswer all = quantities(named_source(R"(two {"beta": 0.0625})"), tau, 15),
                           few = quantities(named_source(R"(two {"beta": 0.0625})"), tau, 6);
    CHECK(all.method.precision == "reference");
    CHECK(all.method.proved);
    CHECK(few.method.precision == "double");
    CHECK_FALSE(few.method.proved);
}

TEST_CASE("one tenth as text is one tenth to a thousand digits, and as a number it is the double", "[driver]") {
    const Bits enough(8192);
    const Solution text = proved(R"(tenth {"beta": "0.1"})", 1000), number = proved(R"(tenth {"beta": 0.1})", 1000);
    REQUIRE(text.beta);
    CHECK(text.beta->decimal == "1." + std::string(999, '0') + "e-01");
    CHECK(number.beta->decimal.substr(0, 40) == "1.00000000000000005551115123125782702118");
    CHECK(apart(ball_of(text.masses[0].amplitude), ball_of(number.masses[0].amplitude)) > 1e-18);
    // (38) and the formulas of one mode, with one tenth for zeta and beta and seven tenths for r
    const Ball zeta = Ball(1) / 10, R = Ball(7) / 10, beta = Ball(1) / 10, w = sqrt(1 - zeta * zeta);
    const Ball theta = pi<Ball>() * w / R, delta = pi<Ball>() * zeta / R, below = cosh(delta) + cos(theta);
    const Ball u = sin(theta) / (R * w * below), g = (sinh(delta) - zeta / w * sin(theta)) / below;
    const Ball square = 1 / ((1 - R * R) * (1 - R * R) + 4 * zeta * zeta * R * R);
    const Ball amplitude = sqrt(square - beta * beta * u * u) - beta * g;
    CHECK(apart(ball_of(text.masses[0].amplitude), amplitude) == 0);
    CHECK(amplitude.certain_bits() > 8000);
    const Ball decimals = Ball::of_text(text.masses[0].amplitude.decimal); // a bound in double ends at 5e-324
    CHECK(abs(decimals - amplitude) < Ball::of_text("1e-999"));
    CHECK(abs(decimals - amplitude * (1 + Ball::of_text("1e-995"))) > Ball::of_text("1e-999"));
}

TEST_CASE("an answer with stops has the digits asked for as well", "[driver]") {
    const Bits enough(4096);
    const std::string text = R"(chain of three {"beta": 0.75})";
    const Solution all = proved(text, 200);
    REQUIRE(all.regime.regime == Regime::stick_slip);
    REQUIRE_FALSE(all.stops.empty());
    for (const int digits : {1, 15, 16, 30}) {
        const Solution s = proved(text, digits);
        CHECK(is_the_same_number(s.masses[0].amplitude, all.masses[0].amplitude));
        CHECK(is_the_same_number(s.stops[0].start, all.stops[0].start));
        CHECK(s.method.model == "exact solver");
        CHECK(s.relative_error <= std::pow(10, -digits));
    }
}

TEST_CASE("each regime is told from its neighbours next to their boundaries", "[driver][eq:69][eq:87]") {
    const Bits enough(256);
    const Solution limits = proved("chain of three", 40, Asked::regime);
    const Certified &exact = limits.limits->exact, &sticking = *limits.limits->sticking;
    const auto at = [](const Certified& limit, const char* factor) { // in text: further digits of the limit, times the factor
        const Bits many(512);
        const Ball beta = Ball::of_text(limit.decimal) * Ball::of_text(factor);
        char* digits = arb_get_str(beta.a, 60, ARB_STR_NO_RADIUS);
        const std::string text = R"(chain of three {"beta": ")" + std::string(digits) + "\"}";
        flint_free(digits);
        return text;
    };
    CHECK(proved(at(exact, "0.99999999999999999999"), 6, Asked::regime).regime.regime == Regime::continuous);
    CHECK(proved(at(exact, "1.00000000000000000001"), 6, Asked::regime).regime.regime == Regime::stick_slip);
    CHECK(proved(at(sticking, "0.99999999999999999999"), 6, Asked::regime).regime.regime == Regime::stick_slip);
    CHECK(proved(at(sticking, "1.00000000000000000001"), 6, Asked::regime).regime.regime == Regime::permanent_sticking);
    const Solution next = proved(at(exact, "0.99999999999999999999"), 20);
    CHECK(next.masses.size() == 3);
    CHECK(next.method.model == "closed form");
    CHECK(proved(at(sticking, "1.00000000000000000001"), 20).method.model == "stuck response");
}

TEST_CASE("contacts between two masses, load vectors, dashpots and modes beyond critical are answered", "[driver]") {
    const Bits enough(512);
    for (const std::string change :
         {R"({"contact": [1, 3], "load": 2})", R"({"contact": 2, "load": [0.5, "0.1", -1]})",
          R"({"damping_ratios": null, "damping_matrix": [[0.2, -0.1, 0], [-0.1, 0.15, -0.02], [0, -0.02, 0.1]], "contact": 2})",
          R"({"damping_ratios": [0.5, 1.5, 3]})", R"({"damping_ratios": [0.5, 1, 1]})",
          R"({"damping_ratios": [0, 0.05, 0.05]})"}) {
        INFO(change);
        const Solution s = proved("of every kind " + change, 60), few = proved("of every kind " + change, 10);
        CHECK(s.method.model == "closed form");
        CHECK(s.masses.size() == 3);
        for (std::size_t k = 0; k < 3; ++k) CHECK(is_the_same_number(s.masses[k].amplitude, few.masses[k].amplitude));
        CHECK(s.between.has_value() == (s.contact_with.has_value()));
    }
}

TEST_CASE("two modes of one frequency are answered", "[driver][eq:69]") {
    const Bits enough(256);
    const Solution s = proved("apart", 21);
    CHECK(s.limits->exact.decimal.substr(0, 21) == "7.4387816094964130746");
    CHECK(s.regime.regime == Regime::continuous);
    REQUIRE(s.masses.size() == 2);
    CHECK_FALSE(s.masses[1].phase);
    CHECK(s.masses[1].amplitude.error < 1e-30);
    const Solution alone = proved("half of apart", 21);
    CHECK(is_the_same_number(s.masses[0].amplitude, alone.masses[0].amplitude));
    CHECK(is_the_same_number(*s.masses[0].phase, *alone.masses[0].phase));
    // decimals as text are balls, which say of themselves that they are the same
    const Solution text = proved(R"(apart {"damping_ratios": "0.05"})", 21);
    CHECK(text.limits->exact.decimal.substr(0, 17) == s.limits->exact.decimal.substr(0, 17));
    CHECK(apart(ball_of(text.limits->exact), ball_of(s.limits->exact)) > 0);
}

TEST_CASE("masses of which two modes have one frequency stop as those do whose frequencies are nearly the same",
          "[driver][eq:69]") {
    const Bits enough(256);
    for (const std::string rest : {R"("r": 0.03, "beta": 0.3)", R"("contact": [1, 2], "r": 0.04, "beta": 0.1, "mu": 1.25)"}) {
        const auto answer = [&](const std::string& last) {
            return proved("triangle {" + rest + R"(, "stiffness_matrix": [[2, -0.5, -0.5], [-0.5, 2, -0.5], [-0.5, -0.5, )" +
                              last + "]]}",
                          20);
        };
        INFO(rest);
        const Solution one = answer("2"), near = answer("\"2.0000000000000000000000001\""), other = answer("2.0001");
        CHECK(one.regime.regime == Regime::stick_slip);
        REQUIRE(one.stops.size() == near.stops.size());
        for (std::size_t k = 0; k < 3; ++k) {
            const Ball x = ball_of(one.masses[k].amplitude);
            CHECK(abs(x - ball_of(near.masses[k].amplitude)) < Ball(1e-17) * x);
            CHECK(apart(x, ball_of(other.masses[k].amplitude)) > 1e-10); // the test would tell
        }
        for (std::size_t n = 0; n < one.stops.size(); ++n)
            CHECK(abs(ball_of(one.stops[n].start) - ball_of(near.stops[n].start)) < Ball(1e-16));
        CHECK(abs(ball_of(one.limits->paper) - ball_of(near.limits->paper)) < Ball(1e-17));
    }
}

TEST_CASE("at a pole of a mode without damping the answer is refused, or is that of the motion itself", "[driver]") {
    // at resonance nothing but friction bounds the motion, and below pi/4 of the load it does not
    CHECK_THROWS_WITH(proved(R"(undamped {"r": 1, "beta": 0.3})", 10), Catch::Contains("mode 1 has no damping and R = 1"));
    // at r = 1/3 the friction motion has a pole, (28), but the load none: with a rest it is answered
    CHECK(proved(R"(undamped {"r": 0.3333333333333333, "beta": 2})", 10).regime.regime == Regime::permanent_sticking);
    // next to a pole every number is there
    CHECK(proved(R"(undamped {"r": 0.99, "beta": 0.3})", 10).regime.regime == Regime::continuous);
}

TEST_CASE("static friction above kinetic by a last digit is not the same as none", "[driver]") {
    const Bits enough(256);
    const std::string equal = R"(chain of three {"mu": 1})", above = R"(chain of three {"mu": "1.000000000000001"})";
    const Solution a = proved(equal, 30, Asked::regime), b = proved(above, 30, Asked::regime);
    CHECK(ball_of(*a.limits->sticking) > ball_of(*b.limits->sticking));
    CHECK_FALSE(ball_of(a.limits->approximate) < ball_of(b.limits->approximate));
    CHECK(apart(ball_of(*a.limits->sticking), ball_of(*b.limits->sticking) * Ball::of_text("1.000000000000001")) == 0);
    CHECK(is_the_same_number(proved(equal, 30).masses[0].amplitude, proved(above, 30).masses[0].amplitude));
}

TEST_CASE("a budget that is spent is said", "[driver]") {
    QuestionEffort little(3, 2000);
    CHECK_THROWS_WITH(proved("chain of three", 5000, Asked::motion, &little), Catch::Contains("the work allowed is spent"));
}

TEST_CASE("digits are those of any number of bits", "[driver]") {
    const Bits enough(1024);
    const Solution few = proved("chain of three", 20), many = proved("chain of three", 120);
    CHECK(few.method.why != many.method.why);
    for (std::size_t k = 0; k < few.masses.size(); ++k) {
        const SlidingOfMass &a = *few.masses[k].sliding, &b = *many.masses[k].sliding;
        for (const auto& [x, y] : {std::pair(&a.x0, &b.x0), std::pair(&a.v0, &b.v0), std::pair(&a.instant, &b.instant),
                                   std::pair(&a.amplitude_monoharmonic, &b.amplitude_monoharmonic),
                                   std::pair(&a.phase_monoharmonic, &b.phase_monoharmonic)})
            CHECK(is_the_same_number(*x, *y));
        Certified wrong = few.masses[k].amplitude; // of another last digit but two
        wrong.decimal[wrong.decimal.find('e') - 3] = wrong.decimal[wrong.decimal.find('e') - 3] == '5' ? '6' : '5';
        if (wrong.decimal != few.masses[k].amplitude.decimal) CHECK_FALSE(is_the_same_number(wrong, many.masses[k].amplitude));
    }
}

TEST_CASE("what the fast floor does not reach the reference does, where digits are asked for", "[driver]") {
    Question question;
    question.digits = 120;
    const Solution s = solve(named_source("chain of three"), question);
    CHECK(s.method.precision == "reference");
    CHECK(s.masses[0].amplitude.decimal.size() == 125);
    question.digits = 6;
    CHECK(solve(named_source("chain of three"), question).method.precision == "double");
    question.all = true;
    question.proved = true;
    CHECK_THROWS_AS(solve(named_source("chain of three"), question), InputError);
}

TEST_CASE("damping of each mode by itself is not taken of modes that are not told apart", "[driver][eq:18]") {
    // The modes are told apart by so many bits, whatever the digits are.
    const Solution few = proved("modes told apart by 60 digits", 6), more = proved("modes told apart by 60 digits", 60);
    CHECK(std::abs(few.masses[0].amplitude.value - more.masses[0].amplitude.value) <= few.masses[0].amplitude.error * 1.01);
    CHECK(more.masses[0].amplitude.value == Approx(1.68173804246).epsilon(1e-11));
}

TEST_CASE("of a matrix that damps modes of one frequency alike each has its damping by itself", "[driver][eq:18][eq:56]") {
    const Bits enough(256);
    const auto answer = [](const std::string& damping) {
        return proved(R"(triangle {"damping_ratios": null, )" + damping + "}", 30);
    };
    // frequencies 1 and sqrt(5/2): C = 0.125 I, and C = 0.0625 K, whose ratios are 0.03125 times the frequencies
    for (const std::string C : {"[[0.125, 0, 0], [0, 0.125, 0], [0, 0, 0.125]]",
                                "[[0.125, -0.03125, -0.03125], [-0.03125, 0.125, -0.03125], [-0.03125, -0.03125, 0.125]]"}) {
        INFO(C);
        const Solution each = answer(R"("damping_tolerance": 2, "damping_matrix": )" + C),
                       all = answer(R"("damping_matrix": )" + C);
        CHECK(each.regime.regime == Regime::continuous);
        for (std::size_t k = 0; k < 3; ++k) CHECK(is_the_same_number(each.masses[k].amplitude, all.masses[k].amplitude));
        CHECK(is_the_same_number(each.limits->exact, all.limits->exact));
        CHECK(is_the_same_number(each.limits->paper, all.limits->paper));
    }
    CHECK_THROWS_WITH(answer(R"("damping_tolerance": 2, "damping_matrix": [[0.125, 0, 0], [0, 0.25, 0], [0, 0, 0.125]])"),
                      Catch::Contains("modes are not told apart, and neither is the damping of each by itself"));
}

TEST_CASE("(88) of masses of nearly one frequency beside the contact is the same to any digits", "[driver][eq:88]") {
    const Certified few = proved("loosely joined", 30).sticking_by_88.value(),
                    more = proved("loosely joined", 60).sticking_by_88.value();
    CHECK(std::abs(few.value - more.value) < 1e-15);
    CHECK(more.value == Approx(1.10812804876007).epsilon(1e-13));
}

TEST_CASE("a load on the contact alone never moves it from rest where static friction reaches it", "[driver][eq:88]") {
    const Solution s =
        proved(R"(loaded contact {"beta": "0.83333333333333333333333333333333334"})", 20); // 1 / mu, and a little more
    CHECK(s.regime.regime == Regime::permanent_sticking);
}

TEST_CASE("a load that does not reach the contact leaves it at rest, of modes of one frequency too", "[driver][eq:69]") {
    for (const std::string zeta : {"0", "0.05"}) {
        const Solution s = proved(R"(unloaded contact {"damping_ratios": )" + zeta + "}", 6);
        CHECK(s.regime.regime == Regime::permanent_sticking);
        CHECK(s.limits->exact.value == 0);
    }
}

TEST_CASE("a contact whose response is real and negative has a phase, and so have the masses beside it",
          "[driver][eq:39][eq:44]") {
    const Solution s = proved("on the cut", 20), narrow = solve(named_source("on the cut"), {});
    CHECK(s.regime.regime == Regime::continuous);
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(std::abs(s.masses[k].amplitude.value - narrow.masses[k].amplitude.value) <= narrow.masses[k].amplitude.error);
        CHECK(std::abs(s.masses[k].phase->value - narrow.masses[k].phase->value) <= narrow.masses[k].phase->error);
        CHECK(s.masses[k].phase->error < 1e-18);
    }
    CHECK(std::abs(s.between->phase->value - narrow.between->phase->value) <= narrow.between->phase->error);
}

TEST_CASE("stops that rounding makes next to the boundary are none in a proof, of the motion and of its regime",
          "[driver][eq:69]") {
    for (const Asked asked : {Asked::motion, Asked::regime}) {
        const Solution s = proved("stops of rounding", 30, asked);
        CHECK(s.method.proved);
        CHECK(s.regime.regime == Regime::continuous);
        CHECK(s.stops.empty());
    }
}

TEST_CASE("rules of a scene that double is too coarse for hold all the same", "[driver]") {
    CHECK_THROWS_WITH(proved(R"(two {"mu": "0.99999999999999999999999"})", 6), Catch::Contains("mu must be at least 1"));
    CHECK_THROWS_WITH(proved(R"(matrices {"stiffness_matrix": [[2, "0.5"], ["0.50000000000000000000000000000000001", 2]]})", 6),
                      Catch::Contains("stiffness_matrix must be symmetric"));
    CHECK_FALSE(proved(R"(two {"mu": "1.00000000000000000000000000001", "beta": 0.1})", 6).unique);
}
