// The comparison by itself: what it measures, and that nothing slips through it.
#include "tests/support/second_witness.hpp"

#include <Eigen/LU>
#include <limits>

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/support/scene_builder.hpp"

using namespace denhartog;

namespace {

Scene<double> small_scene() {
    return scene_of(chain_of({1, 2.5, 0.75}, {1, 0.625, 1.875}, {0.03125, 0.0625, 0.09375}, 2), 1.125, 0.015625, 1.375);
}

} // namespace

TEST_CASE("the witness's damping matrix has the damping ratios it was made from", "[eq:18][eq:19][witness]") {
    const Scene<double> scene = small_scene();
    const HalfPeriodProblem<Real50> p = half_period_problem(scene);
    CHECK(static_cast<double>((p.C - p.C.transpose()).norm()) < 1e-48);
    const Matrix<Real50> D = p.K * p.M.inverse() * p.C;
    CHECK(static_cast<double>((D - D.transpose()).norm()) < 1e-46);
    // det(M^-1 C) is the product of 2 zeta_i Omega_i, its trace their sum; det(M^-1 K) the product of Omega_i^2.
    const Real50 det_K = Matrix<Real50>(p.M.inverse() * p.K).determinant();
    const Real50 det_C = Matrix<Real50>(p.M.inverse() * p.C).determinant();
    const Real50 expected = 8 * Real50(0.03125) * Real50(0.0625) * Real50(0.09375) * sqrt(det_K);
    CHECK(static_cast<double>(abs(Real50(det_C / expected - 1))) < 1e-46);
}

TEST_CASE("damping ratios go to the modes by ascending frequency", "[eq:18][witness]") {
    Scene<double> scene = small_scene();
    scene.system.damping_ratios = {0.25, 0, 0};
    const HalfPeriodProblem<Real50> p = half_period_problem(scene);
    // C = 2 zeta_1 Omega_1 (M psi)(M psi)^T: the trace of M^-1 C is 2 zeta_1 Omega_1, and Omega_1^2 is an eigenvalue of M^-1 K.
    const Real50 Omega = Matrix<Real50>(p.M.inverse() * p.C).trace() * 2;
    const Matrix<Real50> shifted = p.K - p.M * Real50(Omega * Omega);
    CHECK(static_cast<double>(abs(shifted.determinant())) < 1e-46);
    // The lowest of three: both smaller principal minors of the shifted matrix of a chain are positive.
    CHECK(shifted(0, 0) > 0);
    CHECK(Matrix<Real50>(shifted.topLeftCorner(2, 2)).determinant() > 0);
}

TEST_CASE("the comparison finds an error put into any of its figures", "[witness][mutant]") {
    const Scene<double> scene = small_scene();
    const ModeSums<double> sums = mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, *scene.r);
    const SampledMotion<double> good = sampled_motion(sums, *response(scene).steady_state, 16);
    const HalfPeriodMotion<Real50> witness = half_period_motion(half_period_problem(scene), 16);
    CHECK(worst(compare(good, witness)) < 1e-13);
    const double wrong = 1 + 0x1p-20, least = 0x1p-21, most = 0x1p-19;
    const auto error = [&](auto change) {
        SampledMotion<double> bad = good;
        change(bad);
        return compare(bad, witness);
    };
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
    const Scene<double> scene = small_scene();
    const ModeSums<double> sums = mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, *scene.r);
    const SampledMotion<double> good = sampled_motion(sums, *response(scene).steady_state, 16);
    const HalfPeriodMotion<Real50> witness = half_period_motion(half_period_problem(scene), 16);
    const auto refused = [&](auto change) {
        SampledMotion<double> bad = good;
        change(bad);
        try {
            (void)compare(bad, witness);
        } catch (const DomainError&) {
            return true;
        }
        return false;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity}) {
        CHECK(refused([&](auto& m) { m.x(2, 3) = bad; }));
        CHECK(refused([&](auto& m) { m.x_0(0) = bad; }));
        CHECK(refused([&](auto& m) { m.x_prime_0(0) = bad; }));
        CHECK(refused([&](auto& m) { m.amplitude(0) = bad; }));
        CHECK(refused([&](auto& m) { m.phase(0) = bad; }));
    }
    CHECK_THROWS_AS(compare(sampled_motion(sums, *response(scene).steady_state, 8), witness), InputError);
}

TEST_CASE("a scene compares with the second witness in one call, in every number type but the widest", "[witness]") {
    CHECK(worst(compare_with_second_witness(small_scene())) < 1e-13);
    const NamedScene<Real50> in_50_digits = paper_scenes<Real50>().back();
    CHECK(worst(compare_with_second_witness(in_50_digits.scene, 16)) < Real50("1e-46"));
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
