// The monoharmonic approximation: exact without friction, its error of second order in the friction ratio, silent where it has no
// solution. That its number is that of one harmonic with exact friction is tested with harmonic balance.
#include "tests/speed_accuracy/peers/monoharmonic.hpp"

#include "tests/accuracy/peer_checks.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

Peer monoharmonic() { return monoharmonic_peers().front(); }

/// By how much the error falls from beta = 2^-4 to 2^-7; 64 where it is of second order.
double fall(PeerPoint p, double factor = 1) {
    p.at.beta = 0x1p-4;
    const double coarse = relative_error(monoharmonic(), p, factor);
    p.at.beta = 0x1p-7;
    const double fine = relative_error(monoharmonic(), p, factor);
    std::printf("%s: monoharmonic, told beta times %g: error %.2e at beta = 1/16, %.2e at 1/128\n", p.name.c_str(), factor,
                coarse, fine);
    return coarse / fine;
}

bool second_order(double fall) { return fall > 45 && fall < 90; }

} // namespace

TEST_CASE("the monoharmonic approximation is exact without friction, and its error is of second order in the friction ratio",
          "[peers][monoharmonic]") {
    for (PeerPoint p : sliding_points()) {
        INFO(where(p));
        CHECK(second_order(fall(p)));
        p.at.beta = 0;
        CHECK(relative_error(monoharmonic(), p) <= 1e-10);
    }
}

TEST_CASE("with 2 % too much friction the error of the monoharmonic approximation is not of second order",
          "[peers][monoharmonic][mutant]") {
    for (const PeerPoint& p : sliding_points()) {
        INFO(where(p));
        CHECK_FALSE(second_order(fall(p, 1.02)));
    }
}

TEST_CASE("for a mass on a spring without damping the monoharmonic approximation ends at beta = pi / 4, whatever the frequency",
          "[peers][monoharmonic]") {
    const auto at = monoharmonic().prepare(single_mass(0.0));
    const double end = pi<double>() / 4;
    for (const double r : {0.125, 0.5, 0.875, 1.5}) {
        INFO("r = " << hexadecimal(r));
        CHECK(at({r, end * (1 - 0x1p-20)}).ending == Ending::answered);
        CHECK(at({r, end * (1 + 0x1p-20)}).ending == Ending::outside_domain);
    }
    CHECK(at({1, 0.5}).ending == Ending::not_a_number);
}
