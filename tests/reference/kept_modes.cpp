// The modes of one system in balls are solved for once in each precision, whatever is asked about it and by how many threads.
#include <atomic>

#include "denhartog/answer/reference.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/parallel.hpp"
#include "denhartog/reference/modes.hpp"
#include "denhartog/solve/decision.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"
#include "tests/reference/proofs.hpp"

using namespace denhartog;
using namespace denhartog::reference;

namespace {

constexpr const char* four_masses =
    R"({"mass_ratios": [1, 0.75, 2, 1.25], "stiffness_ratios": [1, 0.5, 1.5, 2], "damping_ratios": [0.02, 0.03, 0.05, 0.04],
        "contact": 3, "load": 1, "r": 1, "beta": 0})";

// A damping matrix that couples no modes, as far as its tolerance goes.
constexpr const char* nearly_modal =
    R"({"mass_ratios": [1, 1.5], "stiffness_ratios": [1, 0.75], "damping_matrix": [[0.35, -0.15], [-0.15, 0.15]],
        "damping_tolerance": 0.5, "contact": 2, "load": 1, "r": 0.9, "beta": 0.05})";

SceneSource source_of(const char* text) { return scene_source(SceneText{text}); }

// How many eigenproblems of a system are solved by some work.
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
