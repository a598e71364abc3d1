// V, U, G, H and the friction motion in balls: by modes, by the state, and by the formulas in 100 digits.

#include "tests/reference/surveyed_scenes.hpp"
#include "tests/support/closed_form.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/named_scenes.hpp"

using namespace denhartog;
using namespace denhartog::reference;
using namespace denhartog::tests;

namespace {

constexpr slong bits = 320;

// The response functions by modes and by the state, of a scene that has both.
struct BothWays {
    SceneInBalls scene{};
    ResponsesInBalls by_modes{}, by_state{};
    explicit BothWays(const std::string& text) : scene(matrices_of_text(text.starts_with("{") ? text : text_of_scene(text))) {
        ModesInBalls modes = modes_in_balls(scene);
        scene.C = damping_matrix_in_balls(scene, modes);
        by_state = responses_of_state(scene);
        by_modes = responses_of_modes(scene, std::move(modes));
    }
};

constexpr double instants[] = {0, 0.25, 2.5};

// The numbers of both ways overlap, and their radii are small beside 1 and beside themselves.
void check_both_ways(const BothWays& both, double radius_by_modes, double radius_by_state) {
    const ResponsesInBalls &a = both.by_modes, &b = both.by_state;
    const auto same = [&](const Ball& x, const Ball& y) {
        const double size = 1 + std::abs(static_cast<double>(x));
        CHECK(apart(x, y) == 0);
        CHECK(x.radius() < radius_by_modes * size);
        CHECK(y.radius() < radius_by_state * size);
    };
    for (std::size_t k = 0; k < a.V.size(); ++k) {
        same(a.V[k].re, b.V[k].re);
        same(a.V[k].im, b.V[k].im);
        same(a.U[k], b.U[k]);
        same(a.G[k], b.G[k]);
        for (const double tau : instants)
            for (const int n : {0, 1, 2})
                same(a.friction.of(k, (*a.friction.shared)(Ball(tau))).rate(n),
                     b.friction.of(k, (*b.friction.shared)(Ball(tau))).rate(n));
    }
    same(a.H, b.H);
    same(a.squares, b.squares);
    same(a.Y.re, b.Y.re);
    same(a.Y.im, b.Y.im);
}

bool has_modes(const SurveyedScene& s) {
    if (s.json.contains("damping_matrix")) return false;
    const SceneInBalls scene = matrices_of_text(s.text);
    ModesInBalls modes = modes_in_balls(scene);
    return are_told_apart(modes);
}

double size_of(const Complex<Ball>& x) {
    return 1e-3 + std::abs(static_cast<double>(x.re)) + std::abs(static_cast<double>(x.im));
}

// K F + r C F' + r^2 M F'' - w, what the friction motion leaves of (6), a row.
Ball left_of_motion(const SceneInBalls& s, const ResponsesInBalls& r, const Ball& tau, slong row) {
    const std::vector<Series> e = (*r.friction.shared)(tau);
    Ball left = -s.w(row);
    for (slong k = 0; k < s.N(); ++k) {
        const Series F = r.friction.of(static_cast<std::size_t>(k), e);
        left += s.K(row, k) * F.rate(0) + s.r * s.C(row, k) * F.rate(1) + s.r * s.r * s.M(row, k) * F.rate(2);
    }
    return left;
}

} // namespace

TEST_CASE("the response functions by modes are those by the state", "[responses][eq:33][eq:34][eq:35][eq:41][eq:64][eq:65]") {
    const Bits enough(bits);
    int compared = 0;
    for (const SurveyedScene& s : surveyed_scenes()) {
        if (!has_modes(s)) continue;
        INFO(s.text);
        const BothWays both(s.text);
        check_both_ways(both, std::numeric_limits<double>::infinity(), 1e-40);
        ++compared;
    }
    CHECK(compared > 70);
    for (const std::string zeta : {"[0.1, 1]", "[1, 1]", "[1, 0.25]", "[1.0000001, 0.9999999]", "[2, 40]", "[1, 1e6]"}) {
        INFO("damping ratios " << zeta); // critical and beyond
        const BothWays both(R"(pair {"stiffness_ratios": [1, 2], "load": 2, "r": 0.7, "damping_ratios": )" + zeta + "}");
        CHECK(are_told_apart(both.by_modes.modes));
        check_both_ways(both, 1e-62, 1e-30);
    }
    for (const std::string rest : {R"({"r": 0.7})", R"({"damping_ratios": 0.3, "contact": [1, 3], "load": 2, "r": 0.2})",
                                   R"({"damping_ratios": 1.5, "contact": 2, "load": [1, -0.5, 0.25], "r": 1.25})",
                                   R"({"damping_ratios": 1, "contact": 3})", R"({"r": 4000})"}) {
        INFO(rest); // two modes of one frequency
        const BothWays both("triangle " + rest);
        REQUIRE(both.by_modes.modes.clusters.size() == 1);
        check_both_ways(both, 1e-62, 1e-30);
        const FrictionInTime& F = both.by_modes.friction;
        for (std::size_t k = 0; k < both.by_modes.V.size(); ++k)
            for (const double tau : instants)
                for (const int n : {0, 1, 2}) // over a stretch too
                    CHECK(apart(F.at(k, Ball(tau)).rate(n), F.at(k, Ball::within(tau, tau + 0x1p-20)).rate(n)) == 0);
    }
    const Bits few(128);
    CHECK_FALSE(is_told_from_critical(sqrt(Ball(2)) * sqrt(Ball(2)) / 2));
    CHECK_THROWS_AS(FrictionMotionOfMode(Ball(1), sqrt(Ball(2)) * sqrt(Ball(2)) / 2), Unproved);
}

TEST_CASE("the response functions are those of the formulas in 100 digits, and of no others",
          "[responses][eq:23][eq:28][eq:29][eq:33][eq:34][eq:35][eq:64]") {
    const Bits enough(bits);
    int compared = 0;
    for (const SurveyedScene& s : surveyed_scenes()) {
        if (s.couples_modes) continue;                                         // which has no such sums
        if (load_depends_on_frequency(s.source->in_double().system)) continue; // the properties have the second witness for it
        INFO(s.text);
        const Truth truth(s.source);
        const ResponsesInBalls& r = *truth.point.responses;
        const Scene<Real100> scene = read_scene<Real100>(s.text);
        const ModeSums<Real100> sums =
            mode_sums(modal_basis(scene.system), contact_row(scene.system), load_rows(scene.system), *scene.r);
        const std::size_t j = r.contact(), own = contact_row(scene.system).index;
        CHECK(holds(r.V[j].re, sums.V[own].re, size_of(r.V[j])));
        CHECK(holds(r.V[j].im, sums.V[own].im, size_of(r.V[j])));
        CHECK(holds(r.U[j], sums.U[own], 1 + std::abs(static_cast<double>(r.U[j]))));
        CHECK(holds(r.G[j], sums.G[own], 1 + std::abs(static_cast<double>(r.G[j]))));
        CHECK(holds(r.H, sums.H_j, 1 + std::abs(static_cast<double>(r.H))));
        CHECK_FALSE(holds(r.H, sums.H_j + Real100("1e-45"), 1 + std::abs(static_cast<double>(r.H))));
        for (std::size_t k = 0; k < j; ++k) {
            CHECK(holds(r.V[k].re, sums.V[k].re, size_of(r.V[j])));
            CHECK(holds(r.U[k], sums.U[k], 1 + std::abs(static_cast<double>(r.U[j]))));
            CHECK(holds(r.G[k], sums.G[k], 1 + std::abs(static_cast<double>(r.G[j]))));
        }
        ++compared;
    }
    CHECK(compared > 80);
}

TEST_CASE("the friction motion obeys the equations of motion, mirrors itself and has the values of G and U at its ends",
          "[responses][eq:6][eq:25][eq:41]") {
    const Bits enough(bits);
    for (const SurveyedScene& s : surveyed_scenes()) {
        INFO(s.text);
        const Truth truth(s.source);
        const ResponsesInBalls& r = *truth.point.responses;
        for (const double tau : {0.0, 1.5, 3.0})
            for (slong row = 0; row < truth.point.scene.N(); ++row) {
                const Ball left = left_of_motion(truth.point.scene, r, Ball(tau), row);
                CHECK(left.may_vanish());
                CHECK(left.radius() < 1e-30);
            }
        const std::vector<Series> start = (*r.friction.shared)(Ball(0)), end = (*r.friction.shared)(pi<Ball>());
        for (std::size_t k = 0; k < r.V.size(); ++k) {
            CHECK(apart(r.friction.of(k, start).rate(0), -r.G[k]) == 0);
            CHECK(apart(r.friction.of(k, end).rate(0), r.G[k]) == 0);
            CHECK(apart(r.friction.of(k, start).rate(1), -r.U[k]) == 0);
            CHECK(apart(r.friction.of(k, end).rate(1), r.U[k]) == 0);
        }
    }
}

TEST_CASE("modes whose R is in a ball are no further apart than is said, and hardly less", "[responses][eq:41]") {
    const Bits enough(bits);
    double used = 0;
    for (const double zeta : {0.0, 0.02, 0.7, 1.0, 4.0})
        for (const double R : {0.03, 0.3, 2.1, 40.0}) {
            const Ball low(R), high(R * (1 + 1e-9)), both = Ball::within(R, R * (1 + 1e-9));
            const FrictionMotionOfMode one(low, Ball(zeta)), other(high, Ball(zeta)), any(both, Ball(zeta));
            for (const double tau : {0.0, 0.1, 1.5, 3.0}) {
                const Series x = one.at(Ball(tau)), y = other.at(Ball(tau));
                Ball most = any.apart();
                for (std::size_t n = 0; n < x.c.size(); ++n) {
                    INFO("zeta " << zeta << ", R " << R << ", tau " << tau << ", order " << n);
                    const Ball off = abs(low * low * x.c[n] - high * high * y.c[n]);
                    CHECK(off <= most);
                    if (n == 0) used = std::max(used, (off / most).high());
                    most = most * any.changes() / static_cast<int>(n + 1);
                }
            }
        }
    CHECK(used > 1e-3);
}

TEST_CASE("over a stretch the friction motion holds itself at every instant of it", "[responses]") {
    const Bits enough(128);
    for (const std::string text :
         {"two underdamped",
          R"(two underdamped {"damping_ratios": null, "damping_matrix": [[0.2, -0.1], [-0.1, 0.3]], "r": 0.2})",
          R"(pair {"stiffness_ratios": [1, 2], "damping_ratios": [0.1, 1], "r": 0.7})"}) {
        SceneInBalls s = matrices_of_text(text_of_scene(text));
        if (!s.zeta.empty()) s.C = damping_matrix_in_balls(s, modes_in_balls(s));
        const ResponsesInBalls r = s.zeta.empty() || !are_told_apart(modes_in_balls(s))
                                       ? responses_of_state(s)
                                       : responses_of_modes(s, modes_in_balls(s));
        for (const double from : {0.0, 0.5, 2.75})
            for (const double width : {1e-9, 0.01, 0.3}) {
                const std::vector<Series> over = (*r.friction.shared)(Ball::within(from, from + width));
                for (const double part : {0.0, 0.3, 1.0}) {
                    const std::vector<Series> at = (*r.friction.shared)(Ball(from + part * width));
                    for (std::size_t k = 0; k < r.V.size(); ++k)
                        for (int n = 0; n < 4; ++n) {
                            INFO(text << ", from " << from << ", width " << width << ", rate " << n);
                            CHECK(apart(r.friction.of(k, over).rate(n), r.friction.of(k, at).rate(n)) == 0);
                        }
                }
            }
    }
}

TEST_CASE("what a search remembers of a ball is never taken for another ball whose ends are the same in double", "[responses]") {
    const Bits enough(128);
    const BothWays both("two underdamped");
    for (const ResponsesInBalls* r : {&both.by_modes, &both.by_state}) {
        const Ball one = Ball(1.5) + Ball(0x1p-60), other = Ball(1.5) + Ball(0x1p-54);
        const auto at = [r](const Ball& tau, slong bits) {
            const Bits few(bits);
            return r->friction.of(1, (*r->friction.shared)(tau)).rate(0);
        };
        const Ball first = at(one, 64), second = at(other, 64);
        CHECK(apart(first, at(one, 128)) == 0);
        CHECK(apart(second, at(other, 128)) == 0);
        CHECK(apart(first, at(other, 128)) > 0); // the test would tell
    }
}

TEST_CASE("by another sign of the damping the two ways differ, and the test tells", "[responses]") {
    const Bits enough(128);
    BothWays both("two underdamped");
    both.scene.C = both.scene.C * Ball(-1);
    const ResponsesInBalls wrong = responses_of_state(both.scene);
    CHECK(apart(wrong.V[0].im, both.by_modes.V[0].im) > 0);
    CHECK(apart(wrong.G[0], both.by_modes.G[0]) > 0);
    CHECK(left_of_motion(both.scene, both.by_modes, Ball(1), 0).may_vanish() == false);
}

TEST_CASE("modes of one frequency enter the sums as a whole", "[responses]") {
    const Bits enough(bits);
    const Truth truth(named_source("apart"));
    // the second mass hangs by itself: the first is an oscillator with twice the stiffness
    const Ball R = Ball(1.2) / sqrt(Ball(2)), zeta = Ball(0.05);
    const Complex<Ball> v = paper::complex_response(R, zeta);
    CHECK(apart(truth.point.responses->V[0].re, v.re / 2) == 0);
    CHECK(apart(truth.point.responses->V[0].im, v.im / 2) == 0);
    CHECK(apart(truth.point.responses->U[0], paper::first_damping_function(R, zeta) / 2) == 0);
    CHECK(truth.point.responses->V[1].re.may_vanish());
    CHECK(truth.point.responses->V[1].re.radius() < 1e-70);
    CHECK(apart(truth.point.boundary->exact, Ball::of_text("0.74387816094964130747")) < 1e-20);
}
