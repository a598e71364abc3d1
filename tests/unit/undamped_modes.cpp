// Modes that only friction damps, mu = 1: what they keep of a start, and what they do not.
#include <cmath>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/solve/solve.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "tests/catch.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

double distance(const State& a, const State& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.x.size(); ++k)
        largest = std::max({largest, std::abs(a.x[k] - b.x[k]), std::abs(a.x_prime[k] - b.x_prime[k])});
    return largest;
}

// The sliding motion with a part of the largest share of a mode, at the maximum of the force.
State with_share(const Scene<double>& scene, const Solution& s, double part) {
    const auto basis = modes_with_errors(scene.system);
    const ModeSums<double> sums = values_of(bounded_sums(scene.system, *basis, as_input(*scene.r)));
    State z = sliding_at_maximum_of_force(sums, *scene.beta);
    const auto i = static_cast<Eigen::Index>(s.kept_mode->mode), j = static_cast<Eigen::Index>(scene.system.contact.index);
    const double n = std::round(basis->r_n[s.kept_mode->mode].x / *scene.r), phase = s.phase(scene.system.contact)->value;
    const double share =
        part * (s.kept_mode->contact_at_most.value - s.amplitude(scene.system.contact).value) / basis->phi(j, i).x;
    for (std::size_t k = 0; k < z.x.size(); ++k) {
        const double of_mass = share * basis->phi(static_cast<Eigen::Index>(k), i).x;
        z.x[k] += of_mass * std::cos(n * phase);
        z.x_prime[k] += of_mass * n * std::sin(n * phase);
    }
    return z;
}

Scene<double> undamped(double r, double beta) { return with_beta(oscillator(0, r), beta); }

} // namespace

TEST_CASE("a mode without damping and an even number of periods in one of the force keeps any share up to the largest",
          "[solve][eq:38]") {
    // One mass: x = 4/3 cos tau + beta + A cos 2 tau while it falls is steady for every A from -1/3 to 1/3 - 2 beta.
    const Solution one = solve(scene_source(undamped(0.5, 0.2)), {});
    CHECK(one.amplitude(Mass{0}).value == Approx(4 / 3.0).epsilon(1e-14));
    REQUIRE(one.kept_mode);
    CHECK(std::abs(one.kept_mode->contact_at_most.value - 22 / 15.0) <= one.kept_mode->contact_at_most.error);
    // A chain, of which the second mode is damped otherwise.
    Scene<double> chain_of_two = with_beta(chain({1, 0.5}, {1, 0.75}, {0, 0.125}, 2, 1, 1, 1), 0.02);
    chain_of_two.r = modal_basis(chain_of_two.system).r_n[0] / 2;
    for (const Scene<double>& scene : {undamped(0.5, 0.2), undamped(0.25, 0.05), chain_of_two}) {
        const Solution s = solve(scene_source(scene), {});
        REQUIRE(s.kept_mode);
        CHECK_FALSE(s.unique);
        CHECK(in_words(s.unique_because).substr(0, 3) == "no:");
        CHECK_FALSE(s.not_from_rest.empty());
        const ContactSystem system = contact_system(scene.system);
        ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
        for (const double part : {0.5, 0.99, -0.99}) {
            const State start = with_share(scene, s, part);
            const ExactMotion& motion = solver.run(start, 0.0, 2 * pi<double>());
            CHECK(distance(motion.end, start) < 1e-12);
            for (const Phase& p : motion.phases) CHECK((p.direction != 0 || p.end == p.start));
        }
        const State beyond = with_share(scene, s, 1.02);
        CHECK(distance(solver.run(beyond, 0.0, 2 * pi<double>()).end, beyond) > 1e-6);
    }
}

TEST_CASE("what friction damps is told at each point of a system that is prepared once", "[solve][eq:38]") {
    Question question;
    question.asked = Asked::amplitude;
    question.mass = Mass{0};
    const PreparedSystem prepared = prepare(scene_source(undamped(0.7, 0.05)), question);
    REQUIRE(prepared.contact); // the contact alone, whose modes know no point
    const Solution kept = solve(prepared, 0.5, 0.2, question);
    REQUIRE(kept.kept_mode);
    CHECK(std::abs(kept.kept_mode->contact_at_most.value - 22 / 15.0) <= kept.kept_mode->contact_at_most.error);
    CHECK(solve(prepared, 0.7, 0.05, question).unique);
    CHECK_FALSE(solve(prepared, 0.7, 0, question).unique);
}

TEST_CASE("friction damps modes without damping elsewhere, and the answer is unique", "[solve][eq:38]") {
    const Scene<double> two = with_beta(chain({1, 0.5}, {1, 0.75}, {0, 0}, 1, 2, 1, 0.625), 0.02);
    for (const Scene<double>& scene : {undamped(0.7, 0.05), undamped(0.3, 0.05), undamped(0.4, 0.9), undamped(0.4, 1.25), two}) {
        const Solution s = solve(scene_source(scene), {});
        INFO("r = " << *scene.r << ", beta = " << *scene.beta);
        CHECK(s.unique);
        CHECK(in_words(s.unique_because).find("friction damps every mode") != std::string::npos);
        const ContactSystem system = contact_system(scene.system);
        ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
        State a = at_rest(scene.system.mass_ratios.size()), b = a;
        b.x[0] = 0.1;
        b.x_prime[0] = 0.2;
        const double cycles = 4000 * pi<double>();
        a = State(solver.run(a, 0.0, cycles).end);
        b = State(solver.run(b, 0.0, cycles).end);
        for (std::size_t k = 0; k < a.x.size(); ++k) CHECK(std::abs(a.x_prime[k] - b.x_prime[k]) < 1e-6);
    }
    // Without friction nothing damps it; at a node of the contact, and with two modes that turn alike, friction does not.
    const auto is_open = [](const Scene<double>& scene) {
        const Solution s = solve(scene_source(scene), {});
        return !s.unique && in_words(s.not_from_rest).find("nothing is known to damp") != std::string::npos;
    };
    CHECK(is_open(undamped(0.7, 0)));
    Scene<double> held = with_beta(chain({1, 0.5}, {1, 0.75}, {0, 0}, 1, 2, 1, 0.3), 3); // what is not held goes on
    CHECK(is_open(held));
    held.mu = 2;
    CHECK(is_open(held));
    Scene<double> node = with_beta(chain({1, 1, 1}, {1, 1, 1}, {0.03125, 0, 0.03125}, 2, 1, 1, 0.3125), 0.01);
    node.system.stiffness_ratios.clear();
    node.system.stiffness_matrix.resize(3, 3);
    node.system.stiffness_matrix << 2, -1, 0, -1, 2, -1, 0, -1, 2;
    CHECK(is_open(node));
    Scene<double> alike = two;
    const std::vector<double> r_n = modal_basis(two.system).r_n;
    alike.r = (r_n[0] + r_n[1]) / 4; // both turn by angles over pi whose sum is four times pi
    CHECK(is_open(alike));
    CHECK(is_open(undamped(0x1p-12, 0x1p-40))); // 4096 periods in one of the force
    // Without friction a damped motion is unique whatever mu is.
    CHECK(solve(scene_source(with_beta(oscillator(0.05, 0.7, 2.5), 0)), {}).unique);
}
