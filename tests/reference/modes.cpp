#include <algorithm>
#include <atomic>

#include "denhartog/answer/reference.hpp"
#include "denhartog/number/parallel.hpp"
#include "denhartog/reference/modes.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"
#include "tests/reference/proofs.hpp"
#include "tests/support/closed_form.hpp"
#include "tests/support/sample_scenes.hpp"

using namespace denhartog::reference;
using namespace denhartog::tests;
using namespace denhartog;

// Modes in balls against those in 100 digits, and what the balls of shapes leave open.

namespace {

// Every fifth of the random systems, 1 to 10 masses, chains and others.
std::vector<RandomScene<double>> systems() {
    std::vector<RandomScene<double>> some;
    const std::vector<RandomScene<double>> all = random_scenes<double>(59);
    for (std::size_t n = 0; n < all.size(); n += 5) some.push_back(all[n]);
    return some;
}

// Largest errors of modes in few bits against 100 digits, as parts of their radii.
struct ModesUsed {
    double of_R = 0, of_psi = 0;
};

double used(const Ball& x, const Real100& truth) {
    const double off = abs(middle(x) - ball_of(truth)).high();
    return off <= 1e-80 ? 0 : off / x.radius();
}

ModesUsed compared(const Scene<double>& scene, const ModesInBalls& m) {
    const ModalBasis<Real100> basis = modal_basis(converted<Real100>(scene).system);
    ModesUsed most;
    for (std::size_t i = 0; i < m.R.size(); ++i) {
        most.of_R = std::max(most.of_R, used(m.R[i], Real100(*scene.r / basis.r_n[i])));
        const auto mode = static_cast<Eigen::Index>(i);
        Eigen::Index largest = 0;
        basis.phi.col(mode).head(m.N).cwiseAbs().maxCoeff(&largest);
        const bool turned =
            (basis.phi(largest, mode) < 0) != (static_cast<double>(m.psi[static_cast<std::size_t>(largest)][i]) < 0);
        for (slong k = 0; k < m.N; ++k) {
            const Real100 psi = basis.phi(k, mode) / *scene.r;
            most.of_psi = std::max(most.of_psi, used(m.psi[static_cast<std::size_t>(k)][i], turned ? Real100(-psi) : psi));
        }
    }
    return most;
}

} // namespace

TEST_CASE("frequencies and shapes in balls hold those of 100 digits; a thousandth of the radii would not",
          "[modes][eq:13][eq:14][eq:15][eq:16][eq:17][eq:22]") {
    ModesUsed most;
    for (const RandomScene<double>& each : systems()) {
        INFO(each.name);
        const Bits few(96);
        const ModesInBalls m = modes_in_balls(matrices_of(each.scene));
        REQUIRE(m.clusters.empty());
        const ModesUsed here = compared(each.scene, m);
        CHECK(here.of_R <= 1);
        CHECK(here.of_psi <= 1);
        most = {std::max(most.of_R, here.of_R), std::max(most.of_psi, here.of_psi)};
        for (const Ball& R : m.R) CHECK(R.certain_bits() > 60);
    }
    INFO(most.of_R << " and " << most.of_psi << " of the radii are used");
    CHECK(most.of_R > 1e-3);
    CHECK(most.of_psi > 1e-3);
}

TEST_CASE("a shape that is wrong by a millionth is noticed", "[modes]") {
    const Bits enough(128);
    const Scene<double> scene = systems()[40].scene;
    ModesInBalls m = modes_in_balls(matrices_of(scene));
    CHECK(compared(scene, m).of_psi <= 1);
    m.psi[0][1] = m.psi[0][1] * (1 + Ball(1e-6));
    CHECK(compared(scene, m).of_psi > 1);
    m = modes_in_balls(matrices_of(scene));
    m.R[2] = m.R[2] + Ball(1e-20);
    CHECK(compared(scene, m).of_R > 1);
}

TEST_CASE("masses and springs over many decades keep their modes, each to its own size", "[modes][eq:15]") {
    for (
        const char* text :
        {R"({"mass_ratios": [1, 1e-4, 1e-8, 1e-12], "stiffness_ratios": [1, 1e-6, 1e3, 1e-9], "damping_ratios": 0.05,
              "contact": 1, "load": 1, "r": 1})",
         R"({"mass_ratios": [1, 1e12], "stiffness_ratios": [1, 1e-12], "damping_ratios": 0.05, "contact": 1, "load": 1, "r": 1})"}) {
        const Scene<Real100> scene = read_scene<Real100>(text);
        const ModalBasis<Real100> basis = modal_basis(scene.system);
        const Bits enough(300);
        const ModesInBalls m = modes_in_balls(matrices_of_text(text));
        for (std::size_t i = 0; i < m.R.size(); ++i) {
            INFO(text << ", mode " << i + 1 << ": " << in_words(m.R[i]));
            CHECK(apart(m.R[i] * ball_of(basis.r_n[i]), Ball(1)) < 1e-60);
            CHECK(m.R[i].certain_bits() > 80);
        }
    }
}

TEST_CASE("modes that share a frequency are one cluster, and sums over it are what its plane says", "[modes]") {
    const Bits enough(128);
    const ModesInBalls m = modes_in_balls(matrices_of_text(R"({"mass_ratios": [1, 1, 1],
        "stiffness_matrix": [[3, -1, -1], [-1, 3, -1], [-1, -1, 3]], "damping_ratios": 0.05, "contact": 1, "load": 1, "r": 1.25})"));
    REQUIRE(m.clusters.size() == 1);
    CHECK(m.clusters[0].first == 1);
    CHECK(m.clusters[0].last == 3);
    CHECK(apart(m.R[0], Ball(5) / 4) == 0);
    CHECK(apart(m.R[1], Ball(5) / 8) == 0);
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t n = 0; n < 3; ++n) {
            const Ball in_plane = (m.psi[k][1] * m.psi[n][1] + m.psi[k][2] * m.psi[n][2]) * Ball(25) / 16; // times r^2
            CHECK(apart(in_plane, (k == n ? Ball(1) : Ball(0)) - Ball(1) / 3) == 0);
            CHECK(in_plane.radius() < 1e-30);
        }
    // f known to a ball on the cluster: the sum with any f of it is within what is left open.
    const Ball f = Ball::within(2, 2.5), middle_f = middle(f);
    std::vector<Ball> wide{Ball(1), f, f}, sharp{Ball(1), Ball(2), Ball(2.5)};
    Ball by_middle = m.left_open(m.psi[0], m.psi[1], wide), truth(0);
    const Ball open = by_middle;
    for (std::size_t i = 0; i < 3; ++i) {
        by_middle += m.psi[0][i] * m.psi[1][i] * (i == 0 ? Ball(1) : middle_f);
        truth += m.psi[0][i] * m.psi[1][i] * sharp[i];
    }
    CHECK(apart(by_middle, truth) == 0);
    CHECK(radius_of(open) > Ball(0.01));
}

TEST_CASE("masses and frequencies that are not proved positive are refused", "[modes]") {
    const Bits enough(128);
    SceneInBalls s = matrices_of_text(
        R"({"mass_ratios": [1, 1], "stiffness_ratios": [1, 1], "damping_ratios": 0.05, "contact": 1, "load": 1, "r": 1})");
    SceneInBalls free = s;
    free.K(0, 0) = Ball(1); // no spring to the ground
    CHECK_THROWS_AS(modes_in_balls(free), Unproved);
    s.M(0, 1) = s.M(1, 0) = Ball(1);
    CHECK_THROWS_AS(modes_in_balls(s), Unproved);
}

TEST_CASE("the damping matrix made of the modes gives them their damping ratios", "[modes][eq:18][eq:19]") {
    const Bits enough(192);
    for (const RandomScene<double>& each : systems()) {
        const SceneInBalls s = matrices_of(each.scene);
        if (s.zeta.empty()) continue;
        const ModesInBalls m = modes_in_balls(s);
        const BallMatrix C = damping_matrix_in_balls(s, m);
        for (std::size_t i = 0; i < m.R.size(); ++i)
            for (std::size_t n = 0; n < m.R.size(); ++n) {
                Ball between(0); // psi^T C psi, with 2 zeta omega = r^2 times it on the diagonal, omega = r / R
                for (slong k = 0; k < s.N(); ++k)
                    for (slong l = 0; l < s.N(); ++l)
                        between += m.psi[static_cast<std::size_t>(k)][i] * C(k, l) * m.psi[static_cast<std::size_t>(l)][n];
                INFO(each.name << ", modes " << i + 1 << " and " << n + 1);
                CHECK(apart(between * s.r * m.R[i], i == n ? 2 * m.zeta[i] : Ball(0)) == 0);
            }
    }
}

// The modes of one system in balls are solved for once in each precision, whatever is asked about it and by how many threads.

namespace {

constexpr const char* four_masses =
    R"({"mass_ratios": [1, 0.75, 2, 1.25], "stiffness_ratios": [1, 0.5, 1.5, 2], "damping_ratios": [0.02, 0.03, 0.05, 0.04],
        "contact": 3, "load": 1, "r": 1, "beta": 0})";

// A damping matrix that couples no modes, as far as its tolerance goes.
constexpr const char* nearly_modal =
    R"({"mass_ratios": [1, 1.5], "stiffness_ratios": [1, 0.75], "damping_matrix": [[0.35, -0.15], [-0.15, 0.15]],
        "damping_tolerance": 0.5, "contact": 2, "load": 1, "r": 0.9, "beta": 0.05})";

SceneSource source_of(const char* text) { return scene_source(SceneText{text}); }

// Number of eigenproblems of a system that some work solves.
template <class Work>
long modes_solved(const KeptModes& kept, const Work& work) {
    const long before = kept.solved();
    work();
    return kept.solved() - before;
}

bool same_bits(const std::vector<Ball>& x, const std::vector<Ball>& y) {
    bool same = x.size() == y.size();
    for (std::size_t i = 0; same && i < x.size(); ++i) same = arb_equal(x[i].a, y[i].a) != 0;
    return same;
}

} // namespace

TEST_CASE("many points of one system solve for its modes in balls once in each precision", "[reference][modes][eq:15]") {
    const PreparedSystem system = prepare(source_of(four_masses), {Asked::motion, 20}, Prepared::every_regime);
    const auto ask = [&](int digits, int points) {
        for (int n = 0; n < points; ++n)
            CHECK(solve(system, 0.3 + 0.1 * n, n % 3 == 0 ? 0.01 : 0.4, {Asked::motion, digits}).method.proved);
    };
    for (const int digits : {20, 100}) { // with the contact free, and for (88) those beside the contact
        CHECK(modes_solved(*system.source->kept_modes, [&] { ask(digits, 9); }) == 2);
        CHECK(modes_solved(*system.source->kept_modes, [&] { ask(digits, 9); }) == 0);
    }
    CHECK(modes_solved(*system.source->kept_modes, [&] { ask(20, 9); }) == 0);
}

TEST_CASE("boundaries and responses of one system, at any frequency and any static friction, share its modes",
          "[reference][modes][eq:15]") {
    for (const char* text : {four_masses, nearly_modal}) {
        const SceneSource source = source_of(text);
        const auto ask = [&](double r, double mu) {
            const SceneSource point = with_static_friction(source, mu);
            CHECK(sliding_answer(at_frequency(point, r), {Asked::motion, 20}).method.proved);
            CHECK(sliding_answer(at_point(point, r, 0.01), {Asked::motion, 20}).method.proved);
        };
        CHECK(modes_solved(*source->kept_modes, [&] { ask(0.7, 1); }) == 1);
        CHECK(modes_solved(*source->kept_modes, [&] {
                  for (const double r : {0.4, 0.9, 1.1, 2.0})
                      for (const double mu : {1.0, 1.5}) ask(r, mu);
              }) == 0);
    }
}

TEST_CASE("threads that ask about one system at a time solve for its modes once", "[reference][modes]") {
    const SceneSource source = source_of(four_masses);
    std::atomic<int> proved = 0;
    const long solved = modes_solved(*source->kept_modes, [&] {
        parallel_for(16, 4, [&](std::size_t n) {
            const SceneSource point = at_point(source, 0.4 + 0.0625 * static_cast<double>(n), 0.01);
            if (sliding_answer(point, {Asked::motion, 20}).method.proved) ++proved;
            return true;
        });
    });
    CHECK(solved == 1);
    CHECK(proved == 16);
}

TEST_CASE("modes that were kept are those solved for, to the last bit, and cost a question the same", "[reference][modes]") {
    const Bits bits(160);
    SceneInBalls alone = tests::matrices_of_text(four_masses), keeps = alone;
    keeps.kept = std::make_shared<KeptModes>();
    const auto cost = [](SceneInBalls s, ModesInBalls& m) {
        QuestionEffort effort(4);
        s.effort = &effort;
        m = modes_in_balls(s);
        return effort.spent;
    };
    ModesInBalls first, again, other;
    const long of_first = cost(alone, first);
    for (const double r : {1.0, 0.375}) {
        alone.r = keeps.r = Ball(r);
        CHECK(cost(alone, first) == of_first);
        CHECK(cost(keeps, again) == of_first);
        CHECK(same_bits(first.R, again.R));
        for (std::size_t k = 0; k < first.psi.size(); ++k) CHECK(same_bits(first.psi[k], again.psi[k]));
    }
    // Another system, or other bits, do not get them.
    SceneInBalls heavier = keeps;
    heavier.M(0, 0) *= Ball(2);
    CHECK(modes_solved(*keeps.kept, [&] { (void)modes_in_balls(heavier); }) == 1);
    const Bits more(320);
    CHECK(modes_solved(*keeps.kept, [&] { (void)modes_in_balls(keeps); }) == 1);
    CHECK(modes_solved(*keeps.kept, [&] { (void)modes_in_balls(keeps); }) == 0);
}
