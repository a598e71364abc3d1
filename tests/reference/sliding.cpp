// Boundary, sliding motion, stuck response and (88) in balls, against 100 digits and against what they are defined by.
#include "denhartog/reference/sliding.hpp"

#include "denhartog/answer/models_in_double.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/reference/surveyed_scenes.hpp"
#include "tests/support/held_contact.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/named_scenes.hpp"
#include "tests/support/second_witness.hpp"

using namespace denhartog;
using namespace denhartog::reference;
using namespace denhartog::tests;

namespace {

constexpr slong bits = 320;

bool is_of_papers_form(const SurveyedScene& s) {
    return !s.json["contact"].is_array() && s.json.contains("load") && !s.json["load"].is_array();
}

bool agree(const Ball& x, const Real100& truth) {
    return x.may_vanish() ? abs(ball_of(truth) - x).high() < 1e-40 : holds(x, truth, std::abs(static_cast<double>(x)));
}

bool agree_as_angles(const Ball& x, const Real100& truth) {
    return apart(x, ball_of(truth), 2 * pi<Ball>()) <= 1e-60 && x.radius() < 1e-50;
}

} // namespace

TEST_CASE("the boundary is that of 100 digits", "[boundary][eq:54][eq:56][eq:57][eq:67][eq:69]") {
    const Bits enough(bits);
    for (const SurveyedScene& s : surveyed_scenes()) {
        if (s.couples_modes) continue;                                         // 100 digits have no sums over modes for it
        if (load_depends_on_frequency(s.source->in_double().system)) continue; // the properties have the second witness for it
        INFO(s.text);
        const Boundary<Ball> b = *Truth(s.source).point.boundary;
        Scene<Real100> scene = read_scene<Real100>(s.text);
        scene.beta.reset();
        const Boundary<Real100> truth = response(scene).boundary;
        // the search in 100 digits ends when its value no longer rises: to about 40 digits
        CHECK(apart(b.exact, ball_of(truth.exact)) <= 1e-35 * b.exact.high());
        CHECK(apart(b.approximate, ball_of(truth.approximate)) <= 1e-60 * b.exact.high());
        CHECK(apart(b.paper, ball_of(truth.paper)) <= 1e-35 * b.exact.high());
        CHECK(apart(b.S_exact, ball_of(truth.S_exact)) <= 1e-35 * (1 + abs(b.S_exact).high()));
        CHECK_FALSE(b.exact < b.paper);
        CHECK_FALSE(b.approximate < b.exact);
        CHECK(b.exact.radius() < 1e-50 * b.exact.high());
    }
}

TEST_CASE("below the boundary the contact moves down throughout the half-period, and next above it it does not",
          "[boundary][eq:54]") {
    const Bits enough(bits);
    for (const SurveyedScene& s : surveyed_scenes()) {
        if (!(s.source->in_double().mu == 1)) continue; // (54)b is another condition
        INFO(s.text);
        const Truth truth(s.source);
        const ResponsesInBalls& r = *truth.point.responses;
        const auto lowest_margin = [&](const Ball& beta) { // of -x_j' over the sine, at many instants
            const Ball cosine = contact_in_balls(r, beta).X_j + beta * r.G[r.contact()];
            double lowest = std::numeric_limits<double>::infinity();
            for (int n = 1; n < 200; ++n) {
                const Ball tau = n * pi<Ball>() / 200;
                const Ball rate = r.friction.of(r.contact(), (*r.friction.shared)(tau)).rate(1);
                lowest = std::min(lowest, (cosine - beta * (r.U[r.contact()] * cos(tau) + rate) / sin(tau)).low());
            }
            return lowest;
        };
        CHECK(lowest_margin(truth.point.boundary->exact * Ball(1 - 1e-6)) > 0);
    }
}

TEST_CASE("the sliding motion is that of 100 digits", "[sliding][eq:38][eq:39][eq:44][eq:45][eq:46][eq:47][eq:52][eq:53]") {
    const Bits enough(bits);
    int compared = 0;
    for (const SurveyedScene& s : surveyed_scenes()) {
        const Truth truth(s.source);
        if (!truth.slides || s.couples_modes || !is_of_papers_form(s)) continue;
        INFO(s.text);
        const Response<Real100> r = response(read_scene<Real100>(s.text));
        REQUIRE(r.steady_state);
        CHECK(agree(truth.contact.X_j, r.steady_state->X_j));
        CHECK(agree_as_angles(truth.contact.phi_j, r.steady_state->phi_j));
        for (std::size_t k = 0; k < truth.masses.size(); ++k) {
            const MassResponse<Ball>& m = truth.masses[k];
            const MassResponse<Real100>& of = r.steady_state->masses[k];
            if (m.amplitude.may_vanish()) continue;
            CHECK(agree(m.x0, of.x0));
            CHECK(agree(m.v0, of.v0));
            CHECK(agree(m.amplitude_monoharmonic, of.amplitude_monoharmonic));
            CHECK(agree_as_angles(m.phase_monoharmonic, of.phase_monoharmonic));
            CHECK(apart(m.amplitude, ball_of(of.amplitude)) <= 1e-35 * m.amplitude.high()); // as with the boundary
            CHECK(apart(m.phase, ball_of(of.phase), 2 * pi<Ball>()) <= 1e-20);
            CHECK(m.phase.radius() < 1e-40);
            ++compared;
        }
    }
    CHECK(compared > 120);
}

TEST_CASE("no displacement exceeds the amplitude, and that at its instant comes up to it", "[sliding][eq:46]") {
    const Bits enough(bits);
    for (const SurveyedScene& s : surveyed_scenes()) {
        const Truth truth(s.source);
        if (!truth.slides) continue;
        INFO(s.text);
        for (std::size_t k = 0; k < truth.masses.size(); ++k) {
            const MassResponse<Ball>& m = truth.masses[k];
            for (int n = 0; n <= 64; ++n) {
                const double tau = std::min(n * (3.141592653589793 / 64), 3.141592653589793);
                CHECK_FALSE(abs(truth.displacement(k, tau)) > m.amplitude);
            }
            const Ball there = abs(truth.displacement(k, std::clamp(static_cast<double>(m.instant), 0.0, 3.141592653589793)));
            if (!m.amplitude.may_vanish() && m.instant.radius() < 1e-10)
                CHECK(apart(there, m.amplitude) <= 1e-12 * m.amplitude.high());
        }
    }
}

TEST_CASE("the stuck response is that of 100 digits, and so is (88)", "[stuck][eq:87][eq:88]") {
    const Bits enough(bits);
    int chains = 0;
    for (const SurveyedScene& s : surveyed_scenes()) {
        const Truth truth(s.source);
        if (!truth.point.stuck || !is_of_papers_form(s)) continue;
        INFO(s.text);
        Scene<Real100> scene = read_scene<Real100>(s.text);
        if (const ModalBasis<Real100> basis = modal_basis(scene.system); !damping_matrix_counts(scene.system, basis)) {
            scene.system.damping_ratios = basis.zeta;
            scene.system.damping_matrix.resize(0, 0);
            scene.system.damping_tolerance = 0;
        }
        const HeldContact<Real100> held = held_contact(half_period_problem(scene));
        for (std::size_t k = 0; k < held.X.size(); ++k) {
            CHECK(apart(truth.point.stuck->X[k].re, ball_of(held.X[k].re)) <= 1e-60);
            CHECK(apart(truth.point.stuck->X[k].im, ball_of(held.X[k].im)) <= 1e-60);
        }
        CHECK(apart(truth.point.stuck->load.re, ball_of(held.load.re)) <= 1e-60); // what holds the contact
        const std::optional<Certified> by_88 = sticking_by_88(s.source->in_double());
        if (!by_88) continue;
        const Ball in_balls = sticking_limit_by_88(truth.point.scene, scene.system.load.index);
        CHECK(apart(in_balls, ball_of(*by_88)) == 0);
        CHECK(apart(in_balls * (1 + Ball(3 * by_88->error / by_88->value)), ball_of(*by_88)) > 0);
        ++chains;
    }
    CHECK(chains > 50);
}

TEST_CASE("an angle is taken to (-pi, pi], that next to -pi to pi", "[sliding]") {
    const Bits enough(128);
    CHECK(apart(wrapped_in_balls(Ball(7)), 7 - 2 * pi<Ball>()) == 0);
    CHECK(apart(wrapped_in_balls(Ball(-7)), 2 * pi<Ball>() - 7) == 0);
    CHECK(wrapped_in_balls(-pi<Ball>()) > Ball(3));
    CHECK(wrapped_in_balls(pi<Ball>()) > Ball(3));
    CHECK(wrapped_in_balls(3 * pi<Ball>()) > Ball(3));
    for (const double above : {1e-30, 1e-13, 1e-3}) { // what is certain to lie in (-pi, pi] stays there
        CHECK(wrapped_in_balls(Ball(above) - pi<Ball>()) < Ball(-3));
        CHECK(wrapped_in_balls(pi<Ball>() - Ball(above)) > Ball(3));
        CHECK(wrapped_in_balls(pi<Ball>() + Ball(above)) < Ball(-3));
    }
    const Ball anything = widened(Ball(0), pi<Ball>());
    CHECK(apart(wrapped_in_balls(anything), anything) == 0);
    CHECK(wrapped_in_balls(anything).radius() < 3.2);
}

TEST_CASE("a mass that moves by a small difference of the motions of the modes is followed over a stretch as at its instants",
          "[sliding][eq:41]") {
    const Bits enough(256);
    constexpr std::size_t N = 12;
    for (const double of_stiffness : {0.0, 0.01}) { // damping in proportion to the springs: it joins neighbours alone
        Scene<Ball> scene;
        scene.system.mass_ratios.assign(N, Ball(1));
        scene.system.stiffness_ratios.assign(N, Ball(1));
        for (std::size_t i = 0; i < N; ++i)
            scene.system.damping_ratios.emplace_back(of_stiffness * std::sin((2 * static_cast<double>(i) + 1) * 3.14159 / 50));
        scene.r = Ball(20);
        const reference::SceneInBalls s = reference::in_matrices(scene);
        const reference::ResponsesInBalls r = reference::responses_of_modes(s, reference::modes_in_balls(s));
        CHECK_FALSE(r.friction.cancels[0]);
        reference::FrictionInTime wrong = r.friction;
        for (reference::FrictionMotionOfMode& F : wrong.modes) F.stiffness = F.damping = Ball(0); // no derivative goes on
        for (const std::size_t row : {N / 2, N - 1}) {
            REQUIRE(r.friction.cancels[row]);
            const Ball stretch = Ball::within(0.5, 0.75);
            const auto holds = [&](const reference::FrictionInTime& f) {
                const reference::Series over = f.at(row, stretch);
                int held = 0;
                for (const double tau : {0.5, 0.5625, 0.75})
                    for (std::size_t n = 0; n < 5; ++n)
                        held += arb_overlaps(over.c[n].a, r.friction.at(row, Ball(tau)).c[n].a) != 0;
                return held == 15;
            };
            CHECK(holds(r.friction));
            CHECK_FALSE(holds(wrong));
            const Ball close = r.friction.at(row, stretch).c[0], terms = r.friction.of(row, (*r.friction.shared)(stretch)).c[0];
            CHECK(close.radius() < 0.5 * std::abs(static_cast<double>(middle(close))));
            CHECK(terms.radius() > std::abs(static_cast<double>(middle(close))));
        }
    }
}

TEST_CASE("twelve undamped masses far above resonance have six proved digits each with the effort by default",
          "[sliding][driver]") {
    for (const auto& [at, last] : {std::pair(R"("r": 20, "beta": 0.00075})", 6.314561150660643e-32),
                                   std::pair(R"("r": 300, "beta": 3.3333333333333333e-06})", 3.541611138832461e-60)}) {
        const std::string ones = "[1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1]";
        const Solution found =
            solve(named_source(R"(undamped {"mass_ratios": )" + ones + R"(, "stiffness_ratios": )" + ones + ", " + at), {});
        CHECK(found.method.proved);
        CHECK(found.masses[11].amplitude.value == Approx(last).epsilon(1e-12)); // by sums over modes in 100 digits
    }
}
