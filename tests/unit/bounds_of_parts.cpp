// Bounds and tolerances inside the library that no answer shows by itself.
#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/denhartog.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "tests/catch.hpp"
#include "tests/support/scene_builder.hpp"

using namespace denhartog;

TEST_CASE("the distance by which an instant is moved into the half-period is part of its bound", "[sliding][bounds]") {
    const double beyond = 0x1p-20, error = 0x1p-40;
    const Bounded<double> before = in_half_period(Bounded<double>(-beyond, error)), inside = in_half_period({1.0, error}),
                          after = in_half_period(Bounded<double>(pi<double>() + beyond, error));
    CHECK(before.x == 0);
    CHECK(before.e == error + beyond);
    CHECK(inside.x == 1);
    CHECK(inside.e == error);
    CHECK(after.x == pi<double>());
    CHECK(after.e == Approx(error + beyond).epsilon(1e-9));
}

TEST_CASE("a coupling of a mode without damping is measured beside the rounding of damping", "[model][bounds]") {
    const double most = 8, rounding = rounding_of_modes(2) * most; // of a matrix with this largest entry
    const auto coupled_by = [most](double d) { return Matrix<double>{{0, d}, {d, most}}; };
    CHECK(largest_coupling(coupled_by(rounding / 2)) == 0.5);
    CHECK(largest_coupling(coupled_by(rounding / 2), 2 * rounding) == 0.25);
    CHECK(largest_coupling(Matrix<double>{{2, 1}, {1, 8}}) == 0.25);
}

TEST_CASE("a damping matrix with eigenvalues of zero is accepted, however many masses there are", "[model][bounds]") {
    for (const int N : {2, 12, 24, 48}) {
        System<double> s =
            chain_of(std::vector<double>(static_cast<std::size_t>(N), 1), std::vector<double>(static_cast<std::size_t>(N), 1));
        s.damping_ratios.clear();
        s.damping_matrix = Matrix<double>::Ones(N, N); // dashpots act on the sum of all velocities alone
        INFO(N << " masses");
        CHECK_NOTHROW(modal_basis(s));
        s.damping_matrix(0, 0) = 1 - 1e-9;
        CHECK_THROWS_WITH(modal_basis(s), Catch::Contains("no negative eigenvalue"));
    }
}

TEST_CASE("if the work runs out in the search for a maximum, its entry says by how much the mass may move further",
          "[exact-solver][bounds]") {
    const ContactSystem system = contact_system(chain_of({1, 2.5, 0.75}, {1, 0.625, 1.875}, {0.03, 0.06, 0.09}, 2, 1));
    ExactSolver solver(system, {0.05, 0.4, 1.25});
    (void)solver.run(at_rest(3), 0.0, 2 * pi<double>());
    const std::vector<Extremum> settled = solver.largest_displacements();
    Effort little;
    little.allowed = 1;
    (void)solver.allow(&little);
    const std::vector<Extremum> found = solver.largest_displacements();
    for (const std::size_t k : {0U, 2U}) {
        INFO("mass " << k + 1);
        CHECK(settled[k].unsure == 0);
        CHECK(found[k].unsure > 0);
        CHECK(std::abs(found[k].x) + found[k].unsure >= std::abs(settled[k].x));
    }
}

TEST_CASE("at a pole the mode that resonates is named", "[sliding][bounds]") {
    Scene<double> scene;
    scene.system = chain_of({1, 2.25}, {1, 2.25}, {0.0, 0.0}, 1, 2); // of natural frequency ratios 1/2 and 2
    scene.beta = 0.25;
    for (const auto& [r, mode] : {std::pair(0.5, "mode 1 has"), std::pair(2.0, "mode 2 has")}) {
        scene.r = r;
        CHECK_THROWS_WITH(solve(scene, {Asked::amplitude, {}}), Catch::Contains(mode));
    }
}

TEST_CASE("a sliding contact that can also rest for ever is said to, and no other", "[eq:54][bounds]") {
    Boundary<Bounded<double>> limits{};
    limits.exact = 0.5;
    limits.sticking = 0.25;
    const auto says = [&](double beta) {
        return std::ranges::count(regime_at(limits, beta).reason, Why::can_rest, &Reason::says);
    };
    CHECK(says(0.125) == 0);
    CHECK(says(0.375) == 1);
    CHECK(says(0.625) == 0);
}

TEST_CASE("a motion whose damping is no more than the rounding of the largest is not known to decay", "[model][bounds]") {
    ModalBasis<double> basis = modal_basis(chain_of({1, 1}, {1, 1}, {0.125, 0.125}));
    basis.couples = true;
    for (const auto& [units, decays] : {std::pair(50.0, false), std::pair(511.0, false), std::pair(512.5, true)}) {
        basis.D = Matrix<double>{{1, 0}, {0, units * std::numeric_limits<double>::epsilon()}};
        INFO(units << " units");
        CHECK(every_motion_is_damped(basis) == decays);
    }
}

TEST_CASE("masses beside a contact at rest are seen from the ground if a base moves, and else not", "[stuck][bounds]") {
    Scene<double> scene;
    scene.system = chain_of({1, 2.25}, {1, 2.25}, {0.125, 0.125}, 1, 2);
    scene.r = 0.5;
    scene.beta = 8;
    Question of_amplitude;
    of_amplitude.asked = Asked::amplitude;
    for (const BaseMotion motion : {BaseMotion::none, BaseMotion::with_wall}) {
        scene.system.base_motion = motion;
        const Solution s = solve(scene);
        REQUIRE(s.rest_interval);
        CHECK(s.from_ground.size() == (motion == BaseMotion::none ? 0 : 2));
        CHECK(solve(scene, of_amplitude).from_ground.empty()); // that is of the whole motion
    }
}
