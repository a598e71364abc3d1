#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/support/scene_builder.hpp"
#include "tests/support/second_witness.hpp"

using namespace denhartog;

// The comparison by itself: what it measures, and that nothing slips through it.

namespace {

Scene<double> small_scene() {
    return scene_of(chain_of({1, 2.5, 0.75}, {1, 0.625, 1.875}, {0.03125, 0.0625, 0.09375}, 2), 1.125, 0.015625, 1.375);
}

/// Its motion by the closed form and by the witness, and what the comparison says of the first if it is changed.
struct Compared {
    Scene<double> scene = small_scene();
    ModeSums<double> sums = mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, *scene.r);
    SampledMotion<double> good = sampled_motion(sums, *response(scene).steady_state, 16);
    HalfPeriodMotion<Real50> witness = half_period_motion(half_period_problem(scene), 16);

    template <class Change>
    [[nodiscard]] Agreement<double> with(Change change) const {
        SampledMotion<double> bad = good;
        change(bad);
        return compare(bad, witness);
    }
};

} // namespace

TEST_CASE("the comparison finds an error put into any of its figures", "[witness][mutant]") {
    const Compared motion;
    CHECK(worst(compare(motion.good, motion.witness)) < 1e-13);
    const double wrong = 1 + 0x1p-20, least = 0x1p-21, most = 0x1p-19;
    const auto error = [&](auto change) { return motion.with(change); };
    for (Eigen::Index k = 0; k < 3; ++k) {
        const double amplitude = error([&](auto& m) { m.amplitude(k) *= wrong; }).amplitude;
        CHECK(amplitude > least);
        CHECK(amplitude < most);
        CHECK(error([&](auto& m) { m.x.row(k) *= wrong; }).displacement > least);
        CHECK(error([&](auto& m) { m.x_0(k) += 0x1p-20 * m.amplitude(k); }).x_0 > least);
        CHECK(error([&](auto& m) { m.x_prime_0(k) += 0x1p-20; }).x_prime_0 > 0x1p-23);
        CHECK(error([&](auto& m) { m.phase(k) += 0x1p-20; }).phase > least);
    }
    CHECK(error([](auto& m) { m.phase(1) += 0x1p-20; }).phi_j > least);
    CHECK(error([](auto& m) { m.phase(1) += 2 * pi<double>(); }).phi_j < 1e-14);
    CHECK(error([](auto& m) { m.x(2, 7) += 1; }).worst_mass == Mass{2});
}

TEST_CASE("a number that is not finite is no agreement", "[witness]") {
    const Compared motion;
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        CHECK_THROWS_AS(motion.with([&](auto& m) { m.x(2, 3) = bad; }), DomainError);
        CHECK_THROWS_AS(motion.with([&](auto& m) { m.x_0(0) = bad; }), DomainError);
        CHECK_THROWS_AS(motion.with([&](auto& m) { m.x_prime_0(0) = bad; }), DomainError);
        CHECK_THROWS_AS(motion.with([&](auto& m) { m.amplitude(0) = bad; }), DomainError);
        CHECK_THROWS_AS(motion.with([&](auto& m) { m.phase(0) = bad; }), DomainError);
    }
    const SampledMotion<double> coarse = sampled_motion(motion.sums, *response(motion.scene).steady_state, 8);
    CHECK_THROWS_AS(compare(coarse, motion.witness), InputError);
}

TEST_CASE("a scene without r or beta, or beyond the boundary, is not compared", "[witness][input]") {
    Scene<double> scene = small_scene();
    scene.beta = 8;
    CHECK_THROWS_AS(compare_with_second_witness(scene), DomainError);
    scene.beta.reset();
    CHECK_THROWS_AS(half_period_problem(scene), InputError);
    CHECK_THROWS_AS(compare_with_second_witness(scene), InputError);
    scene = small_scene();
    scene.r.reset();
    CHECK_THROWS_AS(half_period_problem(scene), InputError);
    CHECK_THROWS_AS(compare_with_second_witness(scene), InputError);
}

// The scenes that are computed on: what the sets hold.

namespace {

bool some_without_damping(const System<double>& s) {
    return std::any_of(s.damping_ratios.begin(), s.damping_ratios.end(), [](double zeta) { return zeta == 0; });
}

} // namespace

TEST_CASE("the paper's scenes obey the rules, have names of their own and are those of Figs. 4 to 10", "[scenes]") {
    std::set<std::string> names;
    int of_one_mass = 0, of_two = 0, of_five = 0;
    for (const NamedScene<double>& named : paper_scenes<double>()) {
        INFO(named.name);
        CHECK(names.insert(named.name).second);
        REQUIRE_NOTHROW(check(named.scene));
        REQUIRE(named.scene.r);
        REQUIRE(named.scene.beta);
        CHECK(named.scene.mu == 1);
        const System<double>& s = named.scene.system;
        const std::size_t N = number_of_masses(s);
        (N == 1 ? of_one_mass : N == 2 ? of_two : of_five) += 1;
        if (N == 2) {
            CHECK(s.contact == Mass{1});
            CHECK(s.load == Mass{0});
            CHECK(s.damping_ratios[0] / s.damping_ratios[1] == Approx((3 + std::sqrt(5.0)) / 2).epsilon(1e-14));
        }
        if (N != 5) continue;
        CHECK(named.scene.r == 0.9);
        CHECK(named.scene.beta == 0.2);
        CHECK(s.load == Mass{0});
    }
    CHECK(of_one_mass == of_two);
    CHECK(of_five == 4);
}

TEST_CASE("decimal fractions of the paper's scenes are rounded correctly in every number type", "[scenes]") {
    CHECK(paper_scenes<Real50>().back().scene.r == Real50("0.9"));
    CHECK(paper_scenes<Real100>().back().scene.beta == Real100("0.2"));
    CHECK(paper_scenes<Real50>().front().scene.system.damping_ratios[0] == Real50("0.001"));
}

TEST_CASE("random scenes hold every placing of contact and load, and everything that they promise", "[scenes]") {
    std::set<std::tuple<std::size_t, std::size_t, std::size_t>> placings;
    std::set<std::string> names;
    int damping_matrices = 0, undamped = 0, networks = 0, coupled = 0;
    for (const RandomScene<double>& named : random_scenes<double>(1)) {
        const Scene<double>& scene = named.scene;
        const System<double>& s = scene.system;
        INFO(named.name);
        REQUIRE_NOTHROW(check(scene));
        CHECK(names.insert(named.name).second);
        placings.emplace(number_of_masses(s), s.contact.index, s.load.index);
        damping_matrices += s.damping_matrix.size() > 0;
        undamped += some_without_damping(s);
        networks += s.stiffness_matrix.size() > 0;
        coupled += s.mass_matrix.size() > 0;
        CHECK(scene.mu >= 1);
        CHECK(scene.mu <= 3);
        CHECK(*scene.r >= 0.1);
        CHECK(*scene.r <= 3);
        CHECK_FALSE(scene.beta);
        CHECK(named.fraction_of_limit > 0);
        CHECK(named.fraction_of_limit < 1);
    }
    CHECK(names.size() == 534);
    CHECK(placings.size() == 385); // 1 + 4 + 9 + ... + 100
    CHECK(damping_matrices >= 50);
    CHECK(undamped >= 50);
    CHECK(networks >= 50);
    CHECK(coupled >= 15);
}

TEST_CASE("a friction ratio at a fraction of the boundary is short and never above it", "[scenes]") {
    for (const double beta_lim : {1e-9, 0.1, 0.7, 1.0, 3.5}) {
        const double beta = friction_ratio_at(0.75, beta_lim);
        CHECK(beta <= 0.75 * beta_lim);
        CHECK(beta > 0.75 * beta_lim * (1 - 0x1p-19));
        int exponent = 0;
        const double mantissa = std::ldexp(std::frexp(beta, &exponent), 20);
        CHECK(mantissa == std::floor(mantissa));
    }
}
