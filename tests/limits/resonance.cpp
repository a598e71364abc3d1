// Resonance: the limits zeta -> 0 and R -> 1 along several paths, and the orders of the errors of (77)-(85), in 50 and 100
// digits.
#include "denhartog/evaluation/resonance.hpp"
#include "denhartog/formulas/contact.hpp"

#include <cmath>

#include "denhartog/sliding/steady_state.hpp"
#include "tests/catch.hpp"
#include "tests/limits/digits_of.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

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

TEST_CASE("response and damping functions depend on the slope of the path to resonance", "[eq:28][eq:76][eq:79][limit]") {
    const Real100 zeta = ldexp(Real100(1), -40), one_pi = 1 / pi<Real100>();
    for (const double slope : {-3.0, -1.0, -0.25, 0.0, 0.5, 2.0}) {
        const Real100 c(slope), y = 1 / (1 + c * c), R = 1 + c * zeta;
        const evaluation::ModeFunctions<Real100> f = evaluation::mode_functions(R, zeta);
        INFO("c = " << slope);
        CHECK(static_cast<double>(abs(Real100(4 * zeta * zeta * squared_modulus(f.v) - y))) < 1e-10);
        CHECK(static_cast<double>(abs(Real100(zeta * f.g - 2 * one_pi * y))) < 1e-10);
        CHECK(static_cast<double>(abs(Real100(zeta * f.u - 2 * one_pi * c * y))) < 1e-10);
    }
}

TEST_CASE("along zeta = c |R - 1|^p one formula for each function holds, whichever of zeta and |R - 1| is the larger",
          "[eq:28][eq:76][eq:79][limit]") {
    const Real100 one_pi = 1 / pi<Real100>(), distance = ldexp(Real100(1), -80);
    for (const double p : {0.5, 1.0, 2.0, 3.0})
        for (const double c : {0.25, 1.0, 3.0})
            for (const int side : {-1, 1}) {
                const Real100 zeta = c * pow(distance, Real100(p)), squares = zeta * zeta + distance * distance;
                const evaluation::ModeFunctions<Real100> f = evaluation::mode_functions(Real100(1 + side * distance), zeta);
                const auto error = [](const Real100& value, const Real100& limit) {
                    return static_cast<double>(abs(Real100(value / limit - 1)));
                };
                INFO("p = " << p << ", c = " << c << ", side " << side);
                CHECK(error(Real100(4 * squares * squared_modulus(f.v)), Real100(1)) < 1e-20);
                CHECK(error(Real100(squares * f.g), Real100(2 * one_pi * zeta)) < 1e-20);
                CHECK(error(Real100(squares * f.u), Real100(one_pi * (2 * side * distance + zeta * zeta))) < 1e-20);
            }
}

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
