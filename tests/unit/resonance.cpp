// (76)-(85): what each formula says, and its stable form.
#include "denhartog/evaluation/resonance.hpp"

#include <cmath>
#include <limits>

#include "denhartog/evaluation/mode.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

namespace {

/// Mode shapes at the mass, at the load and at the contact, all choices of signs.
struct Shapes {
    double k, l, j;
};

const std::vector<Shapes>& shapes() {
    static const std::vector<Shapes> all{{0.75, 0.5, 1.25}, {-0.75, 0.5, 1.25}, {0.75, -0.5, 1.25}, {0.75, 0.5, -1.25}};
    return all;
}

} // namespace

TEST_CASE("the response at resonance is the term of the mode at R = 1", "[eq:76][eq:77][resonance]") {
    for (const Shapes& psi : shapes())
        for (const double zeta : {0.001, 0.01, 0.1}) {
            const Complex<double> v = paper::complex_response(1.0, zeta);
            const Complex<double> V = paper::complex_response_at_resonance(psi.k, psi.l, zeta);
            CHECK(V.re == 0);
            CHECK(V.im == Approx(psi.k * psi.l * v.im).epsilon(1e-15));
            CHECK(paper::complex_response_amplitude_at_resonance(psi.k, psi.l, zeta) == Approx(modulus(V)).epsilon(1e-15));
            CHECK(argument(V) == Approx(psi.k * psi.l > 0 ? -pi<double>() / 2 : pi<double>() / 2));
        }
}

TEST_CASE("at resonance two masses are in phase or in phase opposition", "[eq:78][resonance]") {
    for (const Shapes& psi : shapes()) {
        const Complex<double> V_k = paper::complex_response_at_resonance(psi.k, psi.l, 0.01);
        const Complex<double> V_j = paper::complex_response_at_resonance(psi.j, psi.l, 0.01);
        const double Delta = argument(V_k) - argument(V_j), cosine = paper::cosine_of_phase_difference_at_resonance(psi.k, psi.j);
        CHECK(cosine == (psi.k * psi.j > 0 ? 1 : -1));
        CHECK(cosine == Approx(std::cos(Delta)).epsilon(1e-15));
        CHECK(std::abs(std::sin(Delta)) < 1e-15);
    }
}

TEST_CASE("the second damping function at resonance is that of the mode but for three quarters of zeta squared",
          "[eq:79][eq:80][resonance]") {
    for (const double zeta : {0.001, 0.01, 0.1}) {
        const double g = evaluation::mode_functions(1.0, zeta).g,
                     approximation = evaluation::second_damping_function_at_resonance(zeta);
        CHECK((g / approximation - 1) / (zeta * zeta) == Approx(-0.75).margin(0.2 * zeta + 1e-8));
        CHECK(paper::second_damping_function_at_resonance(zeta) == Approx(approximation).epsilon(1e-9));
        for (const Shapes& psi : shapes()) {
            CHECK(evaluation::second_damping_function_at_resonance(psi.k, psi.j, zeta) == Approx(psi.k * psi.j * approximation));
            CHECK(paper::second_damping_function_at_resonance(psi.k, psi.j, zeta) == Approx(psi.k * psi.j * approximation));
        }
    }
}

TEST_CASE("for the mass in contact (81) is (38) with |V| for the root in the product", "[eq:81][eq:38][resonance]") {
    const double V = 5, U = 0.375, G = 6.25, beta = 0.25, psi = -0.5;
    const double X = paper::transmissibility_at_resonance(V, U, U, G, psi, psi, beta);
    // (38) squared is V^2 - (beta U)^2 + (beta G)^2 - 2 beta G root
    CHECK(X * X == Approx(V * V - beta * beta * U * U + beta * beta * G * G - 2 * beta * G * V).epsilon(1e-15));
}

TEST_CASE("without first damping functions (81) is (82)", "[eq:81][eq:82][resonance]") {
    for (const Shapes& psi : shapes())
        for (const double G : {-6.25, 6.25})
            CHECK(paper::transmissibility_at_resonance(5.0, 0.0, 0.0, G, psi.k, psi.j, 0.25) ==
                  Approx(paper::transmissibility_at_resonance_without_U(5.0, G, 0.25)).epsilon(1e-14));
}

TEST_CASE("the resonant peak is (82) with (77) and (80), and falls linearly with the friction ratio",
          "[eq:82][eq:83][eq:84][resonance]") {
    for (const Shapes& psi : shapes())
        for (const double zeta : {0.001, 0.01, 0.1}) {
            const auto peak = [&](double beta) { return evaluation::resonant_peak(psi.k, psi.l, psi.j, zeta, beta); };
            const double V = paper::complex_response_amplitude_at_resonance(psi.k, psi.l, zeta);
            const double G = evaluation::second_damping_function_at_resonance(psi.k, psi.j, zeta);
            CHECK(peak(0.125) == Approx(paper::transmissibility_at_resonance_without_U(V, G, 0.125)).epsilon(1e-13));
            CHECK(peak(0.125) == Approx(paper::resonant_peak(psi.k, psi.l, psi.j, zeta, 0.125)).epsilon(1e-8));
            CHECK(peak(0.0) - peak(0.125) == Approx(peak(0.125) - peak(0.25)).epsilon(1e-12));
            CHECK(peak(0.0) == Approx(V).epsilon(1e-14));
            CHECK(evaluation::resonant_peak(1.0, 1.0, 1.0, zeta, 0.25) ==
                  Approx(evaluation::resonant_peak_of_single_mass(zeta, 0.25)).epsilon(1e-14));
            CHECK(paper::resonant_peak_of_single_mass(zeta, 0.25) ==
                  Approx(evaluation::resonant_peak_of_single_mass(zeta, 0.25)).epsilon(1e-8));
        }
}

TEST_CASE("the peak of a single mass is positive exactly below the boundary at resonance", "[eq:84][eq:85][resonance]") {
    for (const double zeta : {1e-12, 1e-6, 0.001, 0.01, 0.03125, 0.1}) {
        const double limit = evaluation::friction_ratio_limit_at_resonance(1.0, 1.0, zeta);
        CHECK(evaluation::resonant_peak_of_single_mass(zeta, limit) == 0);
        CHECK(evaluation::resonant_peak_of_single_mass(zeta, std::nextafter(limit, 0.0)) > 0);
        CHECK(evaluation::resonant_peak_of_single_mass(zeta, std::nextafter(limit, 1.0)) < 0);
        CHECK(paper::friction_ratio_limit_at_resonance(1.0, 1.0, std::max(zeta, 1e-4)) ==
              Approx(evaluation::friction_ratio_limit_at_resonance(1.0, 1.0, std::max(zeta, 1e-4))).epsilon(1e-7));
    }
}

TEST_CASE("without damping the boundary at resonance is pi/4 times the ratio of the mode shapes", "[eq:85][resonance]") {
    for (const Shapes& psi : shapes())
        CHECK(evaluation::friction_ratio_limit_at_resonance(psi.l, psi.j, 0.0) ==
              Approx(pi<double>() / 4 * std::abs(psi.l / psi.j)).epsilon(1e-15));
}

TEST_CASE("a peak that is a double is one, however little damping there is", "[eq:83][resonance]") {
    // The cotangent is all but out of range; 64 times it is, and what is left of the load brings the peak back.
    const double zeta = 0x1p-1022, psi_ki = 64;
    const double beta = pi<double>() / 4 - 0x1p-10;
    const double peak = evaluation::resonant_peak(psi_ki, 1.0, 1.0, zeta, beta);
    CHECK(evaluation::second_damping_function_at_resonance(zeta) > std::numeric_limits<double>::max() / psi_ki);
    CHECK(std::isfinite(peak));
    CHECK(peak == Approx(0x1p-3 / pi<double>() * 0x1p1022).epsilon(1e-12));
}
