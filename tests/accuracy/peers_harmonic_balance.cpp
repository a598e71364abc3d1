// Harmonic balance against the closed form where the contact slides, against the exact solver's orbit where it sticks and slips.
//
// Its error falls as 1 / H with the highest harmonic H: the velocity of the contact has kinks, its truncated series errs by 1 / H
// there, and friction changes sign there. The gates are the error times H, about a third above the largest measured.
#include "tests/speed_accuracy/peers/harmonic_balance.hpp"

#include <algorithm>

#include "tests/accuracy/peer_checks.hpp"
#include "tests/speed_accuracy/peers/monoharmonic.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

constexpr FrictionLaw laws[] = {FrictionLaw::regularised, FrictionLaw::augmented_lagrangian};

struct GatedPoint {
    PeerPoint point;
    double gate; // of the error times the highest harmonic
};

std::vector<GatedPoint> gated_points() {
    const std::vector<PeerPoint> slides = sliding_points(), rests = stick_slip_points();
    return {{slides[0], 0.011}, {slides[1], 0.2}, {rests[0], 0.65}, {rests[1], 1.4}};
}

double amplitude(const Peer& peer, const PeerPoint& p) { return peer.prepare(p.system)(p.at).amplitude; }

} // namespace

TEST_CASE("the error of harmonic balance falls with the number of harmonics, sliding and in stick-slip",
          "[peers][harmonic-balance]") {
    for (const FrictionLaw law : laws)
        for (const auto& [p, gate] : gated_points()) {
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
        for (const auto& [p, gate] : gated_points()) {
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
