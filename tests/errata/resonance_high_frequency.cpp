// (81), (82) and (86) as printed, beside the forms that hold and the response or boundary itself.
#include <cmath>

#include "denhartog/evaluation/resonance.hpp"
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

TEST_CASE("(81) is the square of (38) with |V_dj| for the root, but not with the sign as printed", "[eq:81][erratum]") {
    const double V = 5, U = 0.375, G = 6.25, beta = 0.25;
    const double square = V * V - beta * beta * U * U + beta * beta * G * G - 2 * beta * G * V;
    CHECK(std::pow(paper::transmissibility_at_resonance(V, U, U, G, 0.5, 0.5, beta), 2) == Approx(square).epsilon(1e-14));
    CHECK(std::pow(as_printed::transmissibility_at_resonance(V, U, U, G, beta), 2) - square ==
          Approx(2 * beta * beta * U * U + beta * U * U).epsilon(1e-12));
}

TEST_CASE("next to the boundary at resonance (81) is the amplitude to better than a percent, but not as printed",
          "[eq:81][eq:38][erratum]") {
    const double zeta = 0x1p-10;
    const ModeSums<double> m = sums_of(oscillator(zeta, 1));
    const double beta = 0.99 * boundary(m, 1.0).exact;
    const double X = paper::displacement_transmissibility_of_contact(m.V[0], m.U[0], m.G[0], beta);
    const double V = paper::complex_response_amplitude_at_resonance(1.0, 1.0, zeta);
    const double G = evaluation::second_damping_function_at_resonance(zeta);
    CHECK(paper::transmissibility_at_resonance(V, m.U[0], m.U[0], G, 1.0, 1.0, beta) ==
          Approx(X).epsilon(1e-3)); // (81) is off by 9.3e-4
    CHECK(as_printed::transmissibility_at_resonance(V, m.U[0], m.U[0], G, beta) > X * (1 + 1e-3));
}

TEST_CASE("the peak at resonance is |V| - beta |G|, not the modulus of the complex V - beta |G|", "[eq:82][erratum]") {
    const double zeta = 0x1p-7, beta = 0.375;
    const ModeSums<double> m = sums_of(oscillator(zeta, 1));
    const double X = paper::displacement_transmissibility_of_contact(m.V[0], m.U[0], m.G[0], beta);
    const Complex<double> V = paper::complex_response_at_resonance(1.0, 1.0, zeta);
    const double G = evaluation::second_damping_function_at_resonance(zeta);
    CHECK(paper::transmissibility_at_resonance_without_U(modulus(V), G, beta) ==
          Approx(X).epsilon(1e-4)); // (82) is off by 3.9e-5
    CHECK(as_printed::transmissibility_at_resonance_without_U(V, G, beta) > 2 * X);
}

TEST_CASE("at high frequencies the exact boundary is (86) with mu squared, not with mu", "[eq:69][eq:86][erratum]") {
    for (const double mu : {1.375, 2.0, 3.0}) {
        const double exact = boundary(sums_of(oscillator(0.01, 1e5, mu)), mu).exact;
        CHECK(paper::friction_ratio_limit_at_high_frequency(mu) == Approx(exact).epsilon(1e-5));
        CHECK(as_printed::friction_ratio_limit_at_high_frequency(mu) > 1.05 * exact);
    }
    CHECK(as_printed::friction_ratio_limit_at_high_frequency(1.0) == paper::friction_ratio_limit_at_high_frequency(1.0));
}
