// Integrators without events: their errors against the closed form and the exact solver's orbit, and where they stall.
//
// Regularised friction errs by a multiple of eps, which depends on the point; fixed steps across sgn(v) err by a multiple of the
// step. The gates are these multiples, about a third above the largest measured.
#include "tests/speed_accuracy/peers/plain_integrators.hpp"

#include "tests/accuracy/peer_checks.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

struct GatedPoint {
    PeerPoint point;
    double gate;             // of the error over eps
    std::vector<double> eps; // what controlled steps reach without stalling
};

std::vector<GatedPoint> gated_points() {
    const std::vector<PeerPoint> slides = sliding_points(), rests = stick_slip_points();
    return {{slides[0], 0.5, {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}},
            {slides[1], 1.6, {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}},
            {rests[0], 0.2, {1e-2, 1e-3}},
            {rests[1], 3, {1e-2, 1e-3}}};
}

constexpr double gate_of_steps = 2.5; // of the error times the steps a period

PlainSetting fixed_steps(double eps) { return {eps, 200, eps / 100, true}; }
PlainSetting controlled_steps(double eps) { return {eps, 0, eps / 100}; }

double error_over_eps(const PlainSetting& setting, const PeerPoint& p, double factor = 1) {
    const Peer peer = plain_integrator(setting);
    const double error = relative_error(peer, p, factor);
    std::printf("%s, %s, %s, told beta times %g: error %.2e\n", p.name.c_str(), peer.method.c_str(), peer.setting.c_str(), factor,
                error);
    return error / setting.eps;
}

double error_times_steps(int steps, const PeerPoint& p, double factor = 1) {
    const double error = relative_error(plain_integrator({0, steps, 1.0 / steps}), p, factor);
    std::printf("%s, sgn(v), %d steps, told beta times %g: error %.2e\n", p.name.c_str(), steps, factor, error);
    return error * steps;
}

} // namespace

TEST_CASE("with friction as tanh(v / eps) the error falls with eps, sliding and in stick-slip", "[peers][plain-integrators]") {
    for (const auto& [p, gate, all_eps] : gated_points()) {
        INFO(where(p));
        for (const double eps : all_eps) CHECK(error_over_eps(controlled_steps(eps), p) <= gate);
        for (const double eps : {1e-2, 1e-3}) CHECK(error_over_eps(fixed_steps(eps), p) <= gate);
    }
}

TEST_CASE("with friction as sgn(v) the error of fixed steps falls with their number where the contact slides",
          "[peers][plain-integrators]") {
    for (const PeerPoint& p : sliding_points()) {
        INFO(where(p));
        for (const int steps : {100, 1000, 10000}) CHECK(error_times_steps(steps, p) <= gate_of_steps);
    }
}

TEST_CASE("with 2 % too much friction both gates fail", "[peers][plain-integrators][mutant]") {
    for (const auto& [p, gate, all_eps] : gated_points()) {
        INFO(where(p));
        CHECK_FALSE(error_over_eps(controlled_steps(1e-3), p, 1.02) <= gate);
        CHECK_FALSE(error_over_eps(fixed_steps(1e-3), p, 1.02) <= gate);
    }
    for (const PeerPoint& p : sliding_points()) {
        INFO(where(p));
        CHECK_FALSE(error_times_steps(10000, p, 1.02) <= gate_of_steps);
    }
}

TEST_CASE("without friction the integrators are of fourth order or reach what is asked: the maximum between their steps is found",
          "[peers][plain-integrators]") {
    const PeerPoint p{"SDOF without friction", single_mass(0.125), {0.75, 0}};
    INFO(where(p));
    double coarser = relative_error(plain_integrator({0, 50, 1e-12}), p);
    for (const int steps : {100, 200, 400}) {
        const double error = relative_error(plain_integrator({0, steps, 1e-12}), p);
        INFO(steps << " steps: error " << error);
        CHECK(coarser / error > 12);
        CHECK(coarser / error < 20);
        coarser = error;
    }
    for (const double tolerance : {1e-3, 1e-6, 1e-9})
        CHECK(relative_error(plain_integrator({0, 0, tolerance}), p) <= 2 * tolerance);
}

TEST_CASE("with friction as sgn(v) controlled steps stall in stick-slip, and say so", "[peers][plain-integrators]") {
    for (const PeerPoint& p : stick_slip_points()) {
        INFO(where(p));
        const PeerAnswer found = plain_integrator({0, 0, 1e-6}).prepare(p.system)(p.at);
        CHECK(found.ending == Ending::stalled);
        CHECK(found.amplitude == 0);
        CHECK(found.evaluations == most_plain_evaluations + 1);
    }
}

TEST_CASE("integrators without events have no number where the motion grows beyond all bounds", "[peers][plain-integrators]") {
    // A step far too long for the stiff mode of a chain with one very light mass.
    System<double> s = equal_chain<double>(2, 1, 1, {0.01, 0.01});
    s.mass_ratios[1] = 1e-8;
    CHECK(plain_integrator({0, 100, 0.01}).prepare(s)({0.5, 0.125}).ending == Ending::not_a_number);
}
