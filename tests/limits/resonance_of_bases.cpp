// Resonance of a moving base: (81) to (85) with |p^T psi_i| for psi_li, against the half-period problem on the physical
// coordinates, which knows neither modes nor a load at resonance.
#include <cmath>

#include "denhartog/evaluation/resonance.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "tests/catch.hpp"
#include "tests/support/second_witness.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

constexpr int steps = 64;

// Three masses on what moves at the resonance of mode i, the damping ratios in proportion, the contact on mass 2.
struct BaseAtResonance {
    Scene<Real50> scene;
    ModeSums<Real50> sums; // those of a load on the contact: its shapes, and what friction does
    std::size_t i;
    Real50 share; // |p^T psi_i|, as the page of one's own system has it

    BaseAtResonance(BaseMotion motion, std::size_t mode, const Real50& zeta) : i(mode) {
        scene = chain<Real50>({1, 2.5, 0.75}, {1, 0.625, 1.875}, {0, 0, 0}, 2, 2, 1, 1);
        System<Real50>& s = scene.system;
        s.damping_ratios = {zeta, Real50(3 * zeta / 4), Real50(5 * zeta / 4)};
        const ModalBasis<Real50> basis = modal_basis(s);
        const Real50 r = basis.r_n[i];
        sums = mode_sums(basis, s.contact, s.contact, r);
        Real50 inertia(0); // psi_i^T M 1
        for (std::size_t k = 0; k < 3; ++k) inertia += s.mass_ratios[k] * psi(k);
        const Real50 with_dampers = r * r * sqrt(Real50(1 + 4 * this->zeta() * this->zeta()));
        share = abs(inertia) * (motion == BaseMotion::with_wall ? Real50(1)
                                : motion == BaseMotion::alone   ? with_dampers
                                                                : Real50(2 * this->zeta() * r * r));
        s.base_motion = motion;
        s.load_vector = motion == BaseMotion::with_wall ? s.mass_ratios : std::vector<Real50>{1, 0, 0};
        scene.r = r;
    }

    Real50 psi(std::size_t k) const { return mode_shapes_at(sums, Mass{k})[i]; }
    Real50 psi_j() const { return psi(1); }
    Real50 zeta() const { return sums.zeta[i]; }
    Real50 limit() const { return evaluation::friction_ratio_limit_at_resonance(share, psi_j(), zeta()); } // (85)

    // (52) of the half-period problem.
    std::vector<Real50> amplitudes(const Real50& beta) const {
        Scene<Real50> at = scene;
        at.beta = beta;
        const HalfPeriodMotion<Real100> motion = half_period_motion(half_period_problem(at), steps);
        std::vector<Real50> all;
        for (Eigen::Index k = 0; k < 3; ++k)
            all.push_back(Real50(sqrt(Real100(motion.x_0(k) * motion.x_0(k) + motion.x_prime_0(k) * motion.x_prime_0(k)))));
        return all;
    }

    bool slides_at(const Real50& beta) const {
        Scene<Real50> at = scene;
        at.beta = beta;
        try {
            return slides(half_period_motion(half_period_problem(at), steps), Real100(1), Real100(beta));
        } catch (const DomainError&) { // no phase brings the contact to rest at the start of a half-period
            return false;
        }
    }
};

// Relative errors of (83) and (81) of all masses at half the friction ratio of (85).
struct ErrorsOfPeaks {
    std::vector<Real50> of_83, of_81;

    explicit ErrorsOfPeaks(const BaseAtResonance& a) {
        const Real50 beta = a.limit() / 2;
        const std::vector<Real50> truth = a.amplitudes(beta);
        for (std::size_t k = 0; k < 3; ++k) {
            const Real50 V = paper::complex_response_amplitude_at_resonance(a.psi(k), a.share, a.zeta());
            of_83.push_back(truth[k] / evaluation::resonant_peak(a.psi(k), a.share, a.psi_j(), a.zeta(), beta) - 1);
            of_81.push_back(truth[k] / paper::transmissibility_at_resonance(V, a.sums.U[k], a.sums.U[1], a.sums.G[k], a.psi(k),
                                                                            a.psi_j(), beta) -
                            1);
            // (82) is (83) by (77) and (80).
            const Real50 of_82 = paper::transmissibility_at_resonance_without_U(
                V, evaluation::second_damping_function_at_resonance(a.psi(k), a.psi_j(), a.zeta()), beta);
            CHECK(static_cast<double>(
                      abs(Real50(of_82 / evaluation::resonant_peak(a.psi(k), a.share, a.psi_j(), a.zeta(), beta) - 1))) < 1e-40);
        }
    }
};

} // namespace

TEST_CASE("at the resonance of a base, alone or with the wall, (81) to (83) have errors of second order",
          "[eq:81][eq:82][eq:83][limit][base][witness]") {
    const Real50 zeta = ldexp(Real50(1), -20);
    for (const BaseMotion motion : {BaseMotion::with_wall, BaseMotion::alone})
        for (const std::size_t i : {0, 1, 2}) {
            const ErrorsOfPeaks errors(BaseAtResonance(motion, i, zeta)), halved(BaseAtResonance(motion, i, Real50(zeta / 2)));
            for (std::size_t k = 0; k < 3; ++k) {
                INFO("motion " << static_cast<int>(motion) << ", mode " << i + 1 << ", mass " << k + 1);
                CHECK(static_cast<double>(errors.of_83[k] / halved.of_83[k]) == Approx(4).epsilon(1e-3));
                CHECK(static_cast<double>(errors.of_81[k] / halved.of_81[k]) == Approx(4).epsilon(1e-3));
            }
        }
}

TEST_CASE("at the resonance of a base, alone or with the wall, sliding ends at (85)", "[eq:85][limit][base][witness]") {
    for (const BaseMotion motion : {BaseMotion::with_wall, BaseMotion::alone})
        for (const std::size_t i : {0, 1, 2}) {
            INFO("motion " << static_cast<int>(motion) << ", mode " << i + 1);
            const BaseAtResonance a(motion, i, ldexp(Real50(1), -20));
            CHECK(a.slides_at(Real50(a.limit() * Real50("0.999"))));
            CHECK_FALSE(a.slides_at(Real50(a.limit() * Real50("1.001"))));
        }
}

TEST_CASE("(84) is the peak of one mass on a base that moves, alone or with the wall", "[eq:84][limit][base][witness]") {
    for (const BaseMotion motion : {BaseMotion::with_wall, BaseMotion::alone}) {
        const auto error = [&](const Real50& zeta) {
            Scene<Real50> at = chain<Real50>({1}, {1}, {0}, 1, 1, 1, 1);
            at.beta = Real50(0.375);
            at.system.damping_ratios = {zeta};
            at.system.base_motion = motion;
            at.system.load_vector = {1};
            const HalfPeriodMotion<Real100> m = half_period_motion(half_period_problem(at), steps);
            return Real50(Real50(m.x_0(0)) / evaluation::resonant_peak_of_single_mass(zeta, *at.beta) - 1);
        };
        const Real50 zeta = ldexp(Real50(1), -20);
        INFO("motion " << static_cast<int>(motion));
        CHECK(static_cast<double>(error(zeta) / error(Real50(zeta / 2))) == Approx(4).epsilon(1e-3)); // X = O(1 / zeta)
    }
}

TEST_CASE("a wall that moves alone has no resonance: (83) does not hold, as it moves no mass without friction",
          "[eq:83][limit][base][witness]") {
    const BaseAtResonance a(BaseMotion::wall, 0, ldexp(Real50(1), -20)), halved(BaseMotion::wall, 0, ldexp(Real50(1), -21));
    for (const Real50& X : a.amplitudes(Real50(0))) CHECK(static_cast<double>(abs(Real50(X - 1))) < 1e-30); // in its frame
    const ErrorsOfPeaks errors(a), with_less(halved);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(static_cast<double>(abs(errors.of_83[k])) > 0.1);
        CHECK(static_cast<double>(errors.of_83[k] / with_less.of_83[k]) == Approx(1).epsilon(1e-3));
    }
}
