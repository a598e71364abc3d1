// x(tau) of a single mass far above resonance, where it is of the size of 1 / r^2: through the library, the C interface and the
// program, against the paper's (38) and (41) for one mass as they stand in 100 digits.
#include <denhartog.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/modal_coordinate.hpp"
#include "denhartog/formulas/mode.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "tests/conformance/c_fixtures.hpp"
#include "tests/conformance/shell.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

/// Displacement by the formulas of the paper, in the first half-period.
Real100 displacement_as_it_stands(double at_r, double at_zeta, double at_beta, double at_tau) {
    const Real100 r(at_r), zeta(at_zeta), beta(at_beta), tau(at_tau);
    const Complex<Real100> v = paper::complex_response(r, zeta);
    const Real100 u = paper::first_damping_function(r, zeta), g = paper::second_damping_function(r, zeta);
    const Real100 X = paper::displacement_transmissibility_of_contact(v, u, g, beta);
    return paper::displacement(tau, X, Real100(0), g, u, beta, paper::friction_motion(tau, r, zeta, u, g));
}

double error_in_eps(double found, const Real100& truth) {
    return static_cast<double>(Real100(abs(Real100((Real100(found) - truth) / truth)))) / std::numeric_limits<double>::epsilon();
}

constexpr double zeta = 0.0625, beta = 0.25;

} // namespace

TEST_CASE("the displacement of a single mass keeps its digits at r = 1e4, 1e6 and 1e8", "[eq:41][eq:46][motion][c_interface]") {
    const System<double> system = chain_of({1}, {1}, {zeta}, 1, 1);
    const Handle handle = handle_of(system);
    const std::vector<double> tau{0.001, 0.5, 1, 1.25, 2, 2.5, 3, 3.125};
    for (const double r : {1e4, 1e6, 1e8}) {
        const ModeSums<double> sums = mode_sums(modal_basis(system), system.contact, system.load, r);
        const SteadyState<double> state = steady_state_without_maxima(sums, beta);
        std::vector<double> x(tau.size());
        REQUIRE(dh_displacement(handle.get(), r, beta, 1, 1, tau.size(), tau.data(), x.data()) == DH_OK);
        double worst = 0, by_difference = 0;
        for (std::size_t n = 0; n < tau.size(); ++n) {
            const Real100 truth = displacement_as_it_stands(r, zeta, beta, tau[n]);
            const double found = motion(sums, state, tau[n]).x[0], error = error_in_eps(found, truth);
            // The displacement crosses zero near tau = pi / 2: there the last place of tau and of the phase is what is left.
            const double size = static_cast<double>(Real100(state.X_j / abs(truth)));
            INFO("r = " << hexadecimal(r) << ", tau = " << hexadecimal(tau[n]) << ": " << hexadecimal(found) << ", off by "
                        << error << " eps, " << size << " times less than the amplitude");
            CHECK(x[n] == found);
            CHECK(error < 5 * std::max(1.0, size));
            worst = std::max(worst, error / std::max(1.0, size));
            const evaluation::FreeMotion<double> free =
                evaluation::free_motion(tau[n], r, zeta, evaluation::w_if_oscillating(zeta));
            const double braces = 1 - (1 + sums.g[0]) * free.d - sums.u[0] * r * free.q;
            const double other = paper::displacement(tau[n], state.X_j, 0.0, sums.g[0], sums.u[0], beta, braces);
            by_difference = std::max(by_difference, error_in_eps(other, truth));
        }
        std::printf(
            "x(tau) of a single mass at r = %g: at most %.2f eps of it and of the amplitude; by the difference %.1e eps\n", r,
            worst, by_difference);
        CHECK(by_difference > 1e5); // 1 - d as a difference fails at the same instants
    }
}

TEST_CASE("the program's table of the motion keeps its digits at r = 1e4 and 1e6", "[eq:46][motion][program]") {
    for (const char* r : {"1e4", "1e6"}) {
        const Run run = run_program("motion --samples 16",
                                    std::string(R"({"mass_ratios":[1],"stiffness_ratios":[1],"damping_ratios":[0.0625],)"
                                                R"("contact":1,"load":1,"mu":1,"beta":0.25,"r":)") +
                                        r + "}");
        REQUIRE(run.status == 0);
        const std::vector<std::string> lines = lines_of(run.output);
        REQUIRE(lines.size() == 17);
        const double amplitude = numbers_of(lines[1])[1];
        for (std::size_t n = 1; n < 8; ++n) {
            const std::vector<double> row = numbers_of(lines[n + 1]);
            const Real100 truth = displacement_as_it_stands(std::stod(r), zeta, beta, row[0]);
            INFO("r = " << r << ", tau = " << hexadecimal(row[0]) << ": " << hexadecimal(row[1]));
            CHECK(static_cast<double>(Real100(abs(Real100(Real100(row[1]) - truth)))) <
                  4 * std::numeric_limits<double>::epsilon() * amplitude);
        }
    }
}
