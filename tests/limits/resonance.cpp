#include <cmath>

#include "denhartog/evaluation/resonance.hpp"
#include "tests/support/second_witness.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog::tests;
using namespace denhartog;

// Resonance: (67) along paths to zeta = 0 and R = 1, and the orders of the errors of (77)-(85), in 50 and 100 digits.

namespace {

/// Correct digits of a double by what it should be, 16 if exact.
double digits_of(double value, const Real100& truth) {
    const double error = static_cast<double>(abs(Real100(Real100(value) - truth)) / abs(truth));
    return error == 0 ? 16 : -std::log10(error);
}

/// Three unequal masses with damping ratios in proportion, the first the given one.
System<Real50> three_masses_with(const Real50& zeta, std::size_t j, std::size_t l) {
    System<Real50> system = chain<Real50>({1, 2.5, 0.75}, {1, 0.625, 1.875}, {0, 0, 0}, j, l, 1, 1).system;
    system.damping_ratios = {zeta, Real50(3 * zeta / 4), Real50(5 * zeta / 4)};
    return system;
}

/// Modes at the resonance of mode i, where the shapes of that mode are taken.
struct AtResonance {
    ModeSums<Real50> sums;
    std::size_t i;
    Real50 psi(std::size_t k) const { return mode_shapes_at(sums, Mass{k})[i]; }
    Real50 psi_j() const { return psi(sums.contact.index); }
    Real50 psi_l() const { return psi(sums.load.index); }
    Real50 zeta() const { return sums.zeta[i]; }
};

AtResonance at_resonance(const System<Real50>& system, std::size_t i) {
    const ModalBasis<Real50> basis = modal_basis(system);
    return {mode_sums(basis, system.contact, system.load, basis.r_n[i]), i};
}

/// The ratio of an error at zeta and at zeta / 2, which is 2 to its order.
double ratio_of_errors(const std::function<Real50(const Real50& zeta)>& error, int exponent) {
    const Real50 zeta = ldexp(Real50(1), -exponent);
    return static_cast<double>(error(zeta) / error(Real50(zeta / 2)));
}

} // namespace

TEST_CASE("(67) tends to the value of (85) without damping along every path zeta = c |R - 1|^p", "[eq:67][eq:85][limit]") {
    const Real50 distance = ldexp(Real50(1), -60), mu(1.375);
    for (const std::size_t i : {0, 1, 2})
        for (const double p : {0.5, 1.0, 2.0, 3.0})
            for (const double c : {0.0, 0.25, 3.0})
                for (const int side : {-1, 1}) {
                    const System<Real50> system = three_masses_with(Real50(c * pow(distance, Real50(p))), 2, 1);
                    const ModalBasis<Real50> basis = modal_basis(system);
                    const Real50 r = basis.r_n[i] * (1 + side * distance);
                    const AtResonance a{mode_sums(basis, system.contact, system.load, r), i};
                    const Real50 limit = evaluation::friction_ratio_limit_at_resonance(a.psi_l(), a.psi_j(), Real50(0));
                    INFO("mode " << i + 1 << ", p = " << p << ", c = " << c << ", side " << side);
                    const Boundary<Real50> b = boundary_at(a.sums, mu, Real50(0), std::vector<Real50>(3, Real50(0)));
                    CHECK(static_cast<double>(b.approximate / limit) == Approx(1).epsilon(1e-5));
                }
}

TEST_CASE("amplitude, second damping function and peak at resonance have relative errors of second order",
          "[eq:52][eq:77][eq:80][eq:82][eq:83][limit]") {
    for (const std::size_t i : {0, 1, 2})
        for (const std::size_t k : {0, 1, 2}) {
            const auto response = [&](const Real50& zeta) {
                const AtResonance a = at_resonance(three_masses_with(zeta, 2, 1), i);
                const Real50 amplitude = paper::complex_response_amplitude_at_resonance(a.psi(k), a.psi_l(), a.zeta());
                return Real50(modulus(a.sums.V[k]) / amplitude - 1);
            };
            const auto second = [&](const Real50& zeta) {
                const AtResonance a = at_resonance(three_masses_with(zeta, 2, 1), i);
                return Real50(a.sums.G[k] / evaluation::second_damping_function_at_resonance(a.psi(k), a.psi_j(), a.zeta()) - 1);
            };
            const auto peak = [&](const Real50& zeta) {
                const AtResonance a = at_resonance(three_masses_with(zeta, 2, 1), i);
                const Real50 beta = evaluation::friction_ratio_limit_at_resonance(a.psi_l(), a.psi_j(), a.zeta()) / 2;
                const SteadyState<Real50> state = steady_state_without_maxima(a.sums, beta);
                const Real50 estimate = evaluation::resonant_peak(a.psi(k), a.psi_l(), a.psi_j(), a.zeta(), beta);
                return Real50(state.masses[k].amplitude_monoharmonic / estimate - 1);
            };
            INFO("mode " << i + 1 << ", mass " << k + 1);
            CHECK(ratio_of_errors(response, 20) == Approx(4).epsilon(1e-4));
            CHECK(ratio_of_errors(second, 20) == Approx(4).epsilon(1e-4));
            CHECK(ratio_of_errors(peak, 20) == Approx(4).epsilon(1e-4));
        }
}

TEST_CASE("in (78) the sine is of first order, and the cosine one but for second order", "[eq:78][limit]") {
    const auto difference = [](const Real50& zeta) {
        const AtResonance a = at_resonance(three_masses_with(zeta, 2, 1), 1);
        return Real50(argument(a.sums.V[0]) - argument(a.sums.V[1]));
    };
    const AtResonance a = at_resonance(three_masses_with(ldexp(Real50(1), -20), 2, 1), 1);
    const double cosine = static_cast<double>(paper::cosine_of_phase_difference_at_resonance(a.psi(0), a.psi_j()));
    const auto sine = [&](const Real50& zeta) { return Real50(sin(difference(zeta))); };
    const auto cosine_error = [&](const Real50& zeta) { return Real50(cos(difference(zeta)) - cosine); };
    CHECK(ratio_of_errors(sine, 20) == Approx(2).epsilon(1e-4));
    CHECK(ratio_of_errors(cosine_error, 20) == Approx(4).epsilon(1e-4));
}

TEST_CASE("the single mass is above (84) at r = 1 by (3 beta / (2 pi) - beta^2 / pi^2) zeta", "[eq:38][eq:84][limit]") {
    const Real50 one_pi = 1 / pi<Real50>();
    for (const double b : {0.125, 0.375, 0.75}) {
        const Real50 zeta = ldexp(Real50(1), -30), beta(b);
        const evaluation::ModeFunctions<Real50> f = evaluation::mode_functions(Real50(1), zeta);
        const Real50 X = paper::displacement_transmissibility_of_contact(f.v, f.u, f.g, beta);
        const Real50 slope = (X - evaluation::resonant_peak_of_single_mass(zeta, beta)) / zeta;
        CHECK(static_cast<double>(slope) == Approx(static_cast<double>(3 * beta * one_pi / 2 - beta * beta * one_pi * one_pi)));
    }
}

TEST_CASE("(85) lies above the exact boundary by an error of first order", "[eq:69][eq:85][limit]") {
    for (const double mu : {1.0, 1.375, 3.0}) { // a single mass: pi mu zeta / 2
        const double zeta = 0x1p-20, exact = boundary(sums_of(oscillator(zeta, 1, mu)), mu).exact;
        const double slope = (1 - exact / evaluation::friction_ratio_limit_at_resonance(1.0, 1.0, zeta)) / zeta;
        CHECK(slope == Approx(pi<double>() * mu / 2).epsilon(1e-4));
    }
    for (const std::size_t i : {0, 1, 2}) {
        const auto error = [&](const Real50& zeta) {
            const AtResonance a = at_resonance(three_masses_with(zeta, 2, 1), i);
            return Real50(1 - boundary(a.sums, Real50(1)).exact /
                                  evaluation::friction_ratio_limit_at_resonance(a.psi_l(), a.psi_j(), a.zeta()));
        };
        INFO("mode " << i + 1);
        CHECK(static_cast<double>(error(ldexp(Real50(1), -16))) > 0);
        CHECK(ratio_of_errors(error, 16) == Approx(2).epsilon(1e-3));
    }
}

TEST_CASE("the forms at resonance keep their digits where the printed ones lose them",
          "[eq:79][eq:83][eq:84][eq:85][limit][form]") {
    for (int k = 1; k <= 60; ++k) {
        const double zeta = std::ldexp(1.0, -k), beta = 0.375;
        const Real100 z(zeta), b(beta), one(1);
        INFO("zeta = " << hexadecimal(zeta));
        CHECK(digits_of(evaluation::second_damping_function_at_resonance(zeta), paper::second_damping_function_at_resonance(z)) >
              15);
        CHECK(digits_of(evaluation::friction_ratio_limit_at_resonance(1.0, 1.0, zeta),
                        paper::friction_ratio_limit_at_resonance(one, one, z)) > 15);
        CHECK(digits_of(evaluation::resonant_peak_of_single_mass(zeta, beta), paper::resonant_peak_of_single_mass(z, b)) > 14.5);
        CHECK(digits_of(evaluation::resonant_peak(0.75, -0.5, 0.25, zeta, beta),
                        paper::resonant_peak(Real100(0.75), Real100(-0.5), Real100(0.25), z, b)) > 14.5);
        if (k > 30) CHECK_FALSE(std::isfinite(paper::second_damping_function_at_resonance(zeta)));
    }
    CHECK(digits_of(paper::second_damping_function_at_resonance(0x1p-20),
                    paper::second_damping_function_at_resonance(Real100(0x1p-20))) < 6);
}

TEST_CASE("next to its zero the peak is that of a friction ratio off in the last place", "[eq:84][limit][form]") {
    for (const double zeta : {0x1p-30, 0x1p-10, 0x1p-3}) {
        const double limit = evaluation::friction_ratio_limit_at_resonance(1.0, 1.0, zeta);
        for (int n = 1; n <= 8; ++n) {
            const double beta = limit * (1 - std::ldexp(1.0, -6 * n)),
                         peak = evaluation::resonant_peak_of_single_mass(zeta, beta);
            const auto truth = [&](const Real100& b) { return paper::resonant_peak_of_single_mass(Real100(zeta), b); };
            const Real100 ulp = ldexp(Real100(1), -51) * limit;
            INFO("zeta = " << hexadecimal(zeta) << ", beta = " << hexadecimal(beta));
            CHECK(Real100(peak) <= truth(Real100(beta - ulp)));
            CHECK(Real100(peak) >= truth(Real100(beta + ulp)));
        }
    }
}

// Resonance of a moving base: (81) to (85) with |p^T psi_i| for psi_li, against the half-period problem on the physical
// coordinates, which knows neither modes nor a load at resonance.

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
