#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/peers/peer.hpp"
#include "tests/speed_accuracy/peers/peers.hpp"
#include "tests/support/paper_systems.hpp"

using namespace denhartog::tests;
using namespace denhartog;

// Methods of others at points, against the answers of `solve`.

namespace {

// The answer of `solve` at a point.
struct Truth {
    double amplitude = 0;               // X_j, to ten digits
    Regime regime = Regime::continuous; // the regime
};

// A system at a point.
struct PeerPoint {
    std::string name;      // unique
    System<double> system; // the system
    ChartPoint at;         // the point

    // By the closed form where the contact slides, by the exact solver's orbit where it sticks and slips.
    Truth truth() const {
        const Solution solution = solve(scene_source(scene_of(system, at.r, at.beta)), {Asked::amplitude, 10, false});
        Truth found{0, solution.regime.regime};
        if (found.regime != Regime::permanent_sticking) found.amplitude = mass_of(solution, system.contact).amplitude.value;
        return found;
    }
};

// Points where the contact slides.
std::vector<PeerPoint> sliding_points() {
    return {{"SDOF, r = 0.9, beta = 0.2", single_mass(0.01), {0.9, 0.2}},
            {"2DOF, r = 0.8, beta = 0.3", two_masses(0.01), {0.8, 0.3}}};
}

// Points where it sticks and slips.
std::vector<PeerPoint> stick_slip_points() {
    return {{"SDOF, r = 0.1, beta = 0.2", single_mass(0.01), {0.1, 0.2}},
            {"SDOF, r = 0.1, beta = 0.7", single_mass(0.01), {0.1, 0.7}}};
}

// A point in a message.
std::string where(const PeerPoint& p) { return p.name + ", r = " + hexadecimal(p.at.r) + ", beta = " + hexadecimal(p.at.beta); }

// Relative error of a method at a point; infinite where it does not answer or sees another regime.
double relative_error(const Peer& peer, const PeerPoint& p, double factor = 1) {
    const Truth truth = p.truth();
    const PeerAnswer found = peer.prepare(p.system)({p.at.r, p.at.beta * factor});
    if (found.ending != Ending::answered || found.sticks != (truth.regime != Regime::continuous)) return HUGE_VAL;
    return std::abs(found.amplitude / truth.amplitude - 1);
}

// A point with the gate that an error times what it falls with must keep.
struct GatedPoint {
    PeerPoint point;
    double gate;
    std::vector<double> eps{}; // what controlled steps reach without stalling
};

} // namespace

// Harmonic balance against the closed form where the contact slides, against the exact solver's orbit where it sticks and slips.
// Its error falls as 1 / H with the highest harmonic H: the velocity of the contact has kinks, its truncated series errs by 1 / H
// there, and friction changes sign there. The gates are the error times H, about a third above the largest measured.

namespace {

constexpr FrictionLaw laws[] = {FrictionLaw::regularised, FrictionLaw::augmented_lagrangian};

// Their gates are of the error times the highest harmonic.
std::vector<GatedPoint> points_of_harmonic_balance() {
    const std::vector<PeerPoint> slides = sliding_points(), rests = stick_slip_points();
    return {{slides[0], 0.011}, {slides[1], 0.2}, {rests[0], 0.65}, {rests[1], 1.4}};
}

double amplitude(const Peer& peer, const PeerPoint& p) { return peer.prepare(p.system)(p.at).amplitude; }

} // namespace

TEST_CASE("the error of harmonic balance falls with the number of harmonics, sliding and in stick-slip",
          "[peers][harmonic-balance]") {
    for (const FrictionLaw law : laws)
        for (const auto& [p, gate, eps] : points_of_harmonic_balance()) {
            INFO(where(p));
            double first = 0, last = 0, worst = 0;
            for (const int highest : {1, 3, 5, 11, 21, 51, 101}) {
                const Peer peer = harmonic_balance({law, highest});
                last = relative_error(peer, p);
                if (highest == 1) first = last;
                worst = std::max(worst, last * highest);
                INFO(peer.method << ", " << peer.setting << ": error " << last);
                CHECK(last * highest <= gate);
            }
            std::printf("%s, law %d: error %.2e with one harmonic, %.2e with 101, at most %.2g / H\n", p.name.c_str(),
                        static_cast<int>(law), first, last, worst);
            CHECK(last < first / 30);
        }
}

TEST_CASE("harmonic balance with 2 % too much friction fails the gate", "[peers][harmonic-balance][mutant]") {
    for (const FrictionLaw law : laws)
        for (const auto& [p, gate, eps] : points_of_harmonic_balance()) {
            INFO(where(p));
            CHECK_FALSE(relative_error(harmonic_balance({law, 101}), p, 1.02) * 101 <= gate);
        }
}

TEST_CASE("one harmonic with sharp friction is the monoharmonic approximation", "[peers][harmonic-balance][monoharmonic]") {
    constexpr double gate = 3e-5;
    for (const FrictionLaw law : laws)
        for (const PeerPoint& p : sliding_points()) {
            INFO(where(p));
            const double one_harmonic = amplitude(harmonic_balance({law, 1, 1000}), p);
            PeerPoint spoilt = p;
            spoilt.at.beta *= 1.02;
            const double apart = std::abs(one_harmonic / amplitude(monoharmonic_peers().front(), p) - 1);
            std::printf("%s, law %d: monoharmonic and one harmonic differ by %.1e\n", p.name.c_str(), static_cast<int>(law),
                        apart);
            CHECK(apart <= gate);
            CHECK_FALSE(std::abs(one_harmonic / amplitude(monoharmonic_peers().front(), spoilt) - 1) <= gate);
        }
}

TEST_CASE("without friction one harmonic is exact, and the maximum between the instants is found", "[peers][harmonic-balance]") {
    for (const FrictionLaw law : laws)
        for (PeerPoint p : sliding_points()) {
            p.at.beta = 0;
            INFO(where(p));
            CHECK(relative_error(harmonic_balance({law, 1}), p) <= 1e-10);
        }
}

TEST_CASE("harmonic balance answers across all regimes, and tells them apart nearly everywhere", "[peers][harmonic-balance]") {
    for (const FrictionLaw law : laws) {
        int points = 0, resting = 0, answered = 0, wrong_regime = 0;
        double largest_at_rest = 0;
        long most_steps = 0;
        for (const NamedSystem<double>& s : paper_systems(0.01)) {
            const auto at = harmonic_balance({law, 21}).prepare(s.system);
            for (int n = 1; n <= 15; ++n)
                for (const double beta : {0.0625, 0.25, 0.5, 1.0}) {
                    const PeerPoint p{s.name, s.system, {n / 8.0, beta}};
                    const Truth truth = p.truth();
                    const PeerAnswer found = at(p.at);
                    ++points;
                    answered += found.ending == Ending::answered;
                    wrong_regime += found.sticks != (truth.regime != Regime::continuous);
                    most_steps = std::max(most_steps, found.evaluations);
                    if (truth.regime != Regime::permanent_sticking) continue;
                    ++resting;
                    largest_at_rest = std::max(largest_at_rest, found.amplitude);
                }
        }
        std::printf("law %d: %d points, %d answered, %d in the wrong regime, at most %ld Newton steps; %d at rest, X_j <= %.1e\n",
                    static_cast<int>(law), points, answered, wrong_regime, most_steps, resting, largest_at_rest);
        CHECK(answered == points);
        CHECK(wrong_regime <= points / 50);
        CHECK(most_steps <= 90);
        CHECK(resting >= 20);
        // A contact at rest creeps where friction is regularised, and does not where it is exact.
        if (law == FrictionLaw::regularised)
            CHECK(largest_at_rest > 1e-6);
        else
            CHECK(largest_at_rest <= 1e-9);
    }
}

TEST_CASE("harmonic balance has no number at a pole", "[peers][harmonic-balance]") {
    const auto at = harmonic_balance({FrictionLaw::augmented_lagrangian, 5}).prepare(single_mass(0.0));
    for (const double r : {1.0, 1 / 3.0}) CHECK(at({r, 0.25}).ending == Ending::not_a_number);
    CHECK(at({0.5, 0.25}).ending == Ending::answered);
}

// The monoharmonic approximation: exact without friction, its error of second order in the friction ratio, silent where it has no
// solution. That its number is that of one harmonic with exact friction is tested with harmonic balance.

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

// Integrators without events: their errors against the closed form and the exact solver's orbit, and where they stall.
// Regularised friction errs by a multiple of eps, which depends on the point; fixed steps across sgn(v) err by a multiple of the
// step. The gates are these multiples, about a third above the largest measured.

namespace {

// Their gates are of the error over eps.
std::vector<GatedPoint> points_of_integrators() {
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
    for (const auto& [p, gate, all_eps] : points_of_integrators()) {
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
    for (const auto& [p, gate, all_eps] : points_of_integrators()) {
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
