#include "denhartog/sliding/contact_alone.hpp"

#include <limits>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/table.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

TEST_CASE("over an array X_j has the digits of the form for one friction ratio, and those are right", "[eq:38]") {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    Worst worst;
    long points = 0;
    for (const Scene<double>& scene : {oscillator(0.015625, 1), oscillator(0.75, 1), three_masses()}) {
        const ModalBasis<double> basis = modal_basis(scene.system);
        for (int m = 1; m <= 100; ++m) {
            const double r = m / 33.0;
            const ModeSums<double> sums = mode_sums(basis, scene.system.contact, scene.system.load, r);
            const double limit = boundary(sums, scene.mu).exact;
            const std::size_t j = sums.contact.index;
            std::vector<double> beta{0, std::nextafter(limit, 0)};
            for (int n = 1; n < 30; ++n) beta.push_back(limit * n / 30.0);
            std::vector<double> X(beta.size());
            contact_amplitudes(sums.V[j], sums.U[j], sums.G[j], beta, X);
            const auto of_V = std::hypot(static_cast<long double>(sums.V[j].re), static_cast<long double>(sums.V[j].im));
            for (std::size_t n = 0; n < beta.size(); ++n, ++points) {
                const std::string at = "r = " + hexadecimal(r) + ", beta = " + hexadecimal(beta[n]);
                INFO(at);
                CHECK(X[n] == evaluation::displacement_transmissibility_of_contact(sums.V[j], sums.U[j], sums.G[j], beta[n]));
                const long double lag = static_cast<long double>(beta[n]) * sums.U[j];
                const long double root = std::sqrt((of_V - lag) * (of_V + lag));
                const auto exact = static_cast<double>(root - static_cast<long double>(beta[n]) * sums.G[j]);
                worst.note(std::abs(X[n] - exact) / (eps * (static_cast<double>(root) + beta[n] * std::abs(sums.G[j]))), at);
            }
        }
    }
    INFO(points << " points, worst " << worst.error << " eps at " << worst.where);
    CHECK(worst.error <= 2);
}
