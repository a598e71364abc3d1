// The root of (38) where it cancels: as printed and as shipped, against 100 digits at the same V, U and beta.
#include <random>

#include "denhartog/evaluation/contact.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;

namespace {

struct Errors {
    double root = 0, phase = 0;
    std::string at{};
};

// Error of a root in units of eps of itself.
double units(double x, const Real100& truth) {
    return static_cast<double>(Real100(abs(Real100((Real100(x) - truth) / truth)))) / std::numeric_limits<double>::epsilon();
}

} // namespace

TEST_CASE("near the end of the domain of (38) the root keeps its digits, and the phase (39) with it",
          "[eq:36][eq:38][eq:39][accuracy][form]") {
    std::mt19937_64 bits(7);
    const auto uniform = [&bits] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
    Errors printed, shipped;
    for (int n = 0; n < 20000; ++n) {
        const Complex<double> V{2 * uniform() - 1, 2 * uniform() - 1};
        const double U = std::pow(10.0, 6 * uniform() - 3), away = std::pow(10.0, -16 * uniform());
        const double beta = std::hypot(V.re, V.im) / U * (1 - away);
        const Complex<Real100> wide_V{Real100(V.re), Real100(V.im)};
        const Real100 truth = paper::contact_root(wide_V, Real100(U), Real100(beta));
        if (!(truth > 0)) continue; // a beta rounded beyond the domain
        const Real100 phase = paper::phase_of_contact(wide_V, Real100(U), Real100(beta));
        const double root = evaluation::contact_root(V, U, beta), before = paper::contact_root(V, U, beta);
        const double of_root = units(root, truth);
        if (!(of_root <= shipped.root)) {
            shipped.root = of_root;
            char text[200];
            std::snprintf(text, sizeof text, "V = %a, %a, U = %a, beta = %a", V.re, V.im, U, beta);
            shipped.at = text;
        }
        const auto off = [&phase](double x) {
            return static_cast<double>(Real100(abs(Real100(Real100(x) - phase)))) / std::numeric_limits<double>::epsilon();
        };
        printed.root = std::max(printed.root, before > 0 ? units(before, truth) : 1e300);
        printed.phase = std::max(printed.phase, off(paper::phase_of_contact(V, U, beta)));
        shipped.phase = std::max(shipped.phase, off(evaluation::phase_of_contact(V, U, beta)));
    }
    std::printf("root of (38): printed %.3g eps, shipped %.3g eps at %s; phase (39): printed %.3g eps, shipped %.3g eps\n",
                printed.root, shipped.root, shipped.at.c_str(), printed.phase, shipped.phase);
    INFO(shipped.at);
    CHECK(shipped.root < 2);
    CHECK(shipped.phase < 8);
    CHECK(printed.root > 1e6);
    CHECK(printed.phase > 1e6);
}
