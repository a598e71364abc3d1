// Fig. 7: regimes of a single mass in the plane of frequency and friction ratio, (69) and (88).
#include "denhartog/formulas/high_frequency.hpp"
#include "regime_planes.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::fig07_single_mass_regimes {

/// Where (69) dips, the contact turns back within the half-period without a stop: the closed form does not hold there, but
/// nothing sticks.
std::string turning_without_stop(const Figure& figure, const RegimePlane& plane) {
    const double r = 0.2, beta = 0.002;
    PaperSettings settings;
    settings.samples = 4000;
    const PaperMotion motion = markers(figure, plane.modes.system, 1, {{r, beta}}, settings).front().motion;
    int turns = 0;
    for (std::size_t n = 0; n < motion.samples.size(); ++n) {
        const double before = motion.samples[(n + motion.samples.size() - 1) % motion.samples.size()].x_prime[0];
        turns += before * motion.samples[n].x_prime[0] < 0;
    }
    const auto seen = std::ranges::find_if(plane.seen, [&](const SeenBoundaries& s) { return s.r == r; });
    return "At r = 0.2 and zeta = 0.001 (69) is " + text(plane.at(r).paper, "%.3g") +
           ", yet the last period is free of stops up to " + text(seen->sliding, "%.3g") +
           ": between the two the contact turns " + std::to_string(turns) +
           " times a period in place of 2 (beta = 0.002; stops: " + std::to_string(motion.stops.size()) +
           "). (69) bounds the closed form, not all motion without stops.";
}

Record make(Figure& figure) {
    const std::vector<RegimePlane> planes = regime_planes(figure, [](double zeta) { return single_mass(zeta); });
    const double limit = paper::friction_ratio_limit_at_high_frequency(1.0);
    figure.add({"limit", {"r", "(86)"}, {{0, limit}, {3, limit}}});

    double off = 0, least = 2, largest = 0;
    for (const RegimePlane& p : planes) {
        off = std::max(off, std::abs(p.at(100).paper - limit));
        for (const double r : spaced(0.05, 3, 60)) {
            least = std::min(least, p.at(r).sticking.value());
            largest = std::max(largest, p.at(r).sticking.value());
        }
    }
    const double below_quarter_pi = pi<double>() / 4 - planes.front().modes.estimated_limit(0);
    const auto half_way = [](const RegimePlane& p) { return p.modes.sliding_amplitude(Mass{0}, 1, p.at(1).paper / 2); };
    bool finite = true;
    for (const RegimePlane& p : planes) finite = finite && std::isfinite(half_way(p));

    Record record = record_of(planes);
    record.title = "Regimes of motion of a single mass";
    record.equations = {"69", "88", "86", "67"};
    record.given = {"SDOF, mu = 1, zeta = 0.001, 0.01, 0.1", "boundary of sliding by (69), of permanent sticking by Section 4.3"};
    record.statements = {
        regimes_as_predicted(planes),
        {"Permanent sticking begins at beta = 1 / mu whatever the frequency and the damping",
         "from " + text(least) + " to " + text(largest) + " over r = 0.05 to 3 and all zeta",
         std::max(std::abs(least - 1), std::abs(largest - 1)) < 1e-9},
        {"At resonance the amplitude is finite in the sliding regime",
         "at r = 1 and half the boundary (69) the amplitude is " + for_each_zeta(planes, half_way) +
             " for zeta = 0.001, 0.01, 0.1",
         finite},
        limit_at_resonance(planes, 0),
        {"For zeta -> 0 (85) tends to pi / 4 in the SDOF case",
         "at zeta = 0.001 it is " + text(below_quarter_pi, "%.1g") + " below it", std::abs(below_quarter_pi) < 1e-5},
        zero_at_low_frequency(planes),
        unaffected_by_damping(planes, "low", 0.02, 0.1),
        unaffected_by_damping(planes, "high", 2.5, 100),
        {"All boundaries tend to 0.537 for high frequencies, whatever zeta; here: to 0.001 at r = 100",
         "(86) is " + text(limit) + "; (69) at r = 3 " +
             for_each_zeta(planes, [](const RegimePlane& p) { return p.at(3).paper; }) + ", at r = 100 " +
             for_each_zeta(planes, [](const RegimePlane& p) { return p.at(100).paper; }),
         off < 1e-3, "to 0.001 at r = 100"},
    };
    record.remarks = {boundaries_compared(planes), turning_without_stop(figure, planes.front())};
    return record;
}

const Listed listed("fig07_single_mass_regimes", make);

} // namespace denhartog::figures::fig07_single_mass_regimes
