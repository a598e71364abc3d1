// Fig. 10: regimes of two masses, contact on the second, load on the first, in the plane of frequency and friction ratio.
#include "regime_planes.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::fig10_two_masses_regimes {

double limit(const RegimePlane& p, double r) { return p.at(r).paper; }
double sticking(const RegimePlane& p, double r) { return p.at(r).sticking.value(); }

Statement zero_at_high_frequency(const std::vector<RegimePlane>& planes) {
    double largest = 0;
    for (const RegimePlane& p : planes) largest = std::max(largest, limit(p, 100));
    return {"With the load on the other mass the boundaries (69) tend to zero for high frequencies; here: below 1e-4 at r = 100",
            "at r = 3 " + for_each_zeta(planes, [](const RegimePlane& p) { return limit(p, 3); }) + ", at r = 10 " +
                for_each_zeta(planes, [](const RegimePlane& p) { return limit(p, 10); }) + ", at r = 100 " +
                for_each_zeta(planes, [](const RegimePlane& p) { return limit(p, 100); }),
            largest < 1e-4, "to 1e-4 at r = 100"};
}

/// The boundary of permanent sticking tends to zero as (69) does: at a given friction ratio the contact rests.
Statement stick_slip_at_high_frequency(const std::vector<RegimePlane>& planes) {
    const double r = 10, beta = 0.1;
    bool sticks_and_slips = true;
    std::string regimes;
    for (const RegimePlane& p : planes) {
        const std::optional<Regime> regime = regime_of_orbit(p.modes.system, 1, r, beta);
        sticks_and_slips = sticks_and_slips && regime == Regime::stick_slip;
        regimes += (regimes.empty() ? "" : ", ") + (regime ? name(*regime) : std::string("no steady motion found"));
    }
    const auto quotient = [](double at) { return [at](const RegimePlane& p) { return sticking(p, at) / limit(p, at); }; };
    return {"Stick-slip is always to be expected at high frequencies; here: at r = 10, beta = 0.1 for all zeta",
            "there " + regimes + " by the exact solver; permanent sticking begins at " +
                for_each_zeta(planes, [&](const RegimePlane& p) { return sticking(p, r); }) + ", which is (69) times " +
                for_each_zeta(planes, quotient(r)) + ", and at r = 100 times " + for_each_zeta(planes, quotient(100)),
            sticks_and_slips};
}

Statement sticking_at_both_ends(const std::vector<RegimePlane>& planes) {
    const auto of = [](const Boundary<double>& b) { return b.sticking.value(); };
    const ChangeWithDamping low = change_with_damping(planes, 0.02, 0.5, of), high = change_with_damping(planes, 2.5, 100, of);
    const double least = std::min(low.least, high.least), largest = std::max(low.largest, high.largest);
    return {"Damping changes the boundary of permanent sticking at its resonance alone, not for r -> 0 nor for high frequencies; "
            "here: "
            "by less than 2 percent for r < 0.5 and r > 2.5",
            "for r < 0.5 at zeta = 0.01 and 0.1 " + as_text(low) + "; for r > 2.5 " + as_text(high) + "; at r = 1.414 it is " +
                for_each_zeta(planes, [](const RegimePlane& p) { return sticking(p, std::sqrt(2.0)); }),
            least > 0.98 && largest < 1.02, "by less than 2 percent"};
}

Statement limit_without_damping(const RegimePlane& p) {
    std::string found;
    double worst = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const double shapes = std::abs(p.modes.psi(p.modes.system.load, i) / p.modes.psi(p.modes.system.contact, i));
        const double estimate = p.modes.estimated_limit(i);
        found += std::string(i == 0 ? "" : ", ") + text(estimate, "%.3g") + " where the quotient is " + text(shapes, "%.3g") +
                 ", " + text(estimate / shapes, "%.3g") + " of it";
        worst = std::max(worst, std::abs(estimate / shapes - 1));
    }
    return {"Without damping (85) is the quotient |psi_li / psi_ji|; here: to a hundredth at zeta = 0.001", "(85) is " + found,
            worst < 0.01};
}

/// (88) as printed against all forces on the contact.
std::string sticking_as_printed(const std::vector<RegimePlane>& planes) {
    double worst = 0;
    for (const RegimePlane& p : planes) {
        const StuckConfiguration stuck = stuck_configuration(p.modes.system, p.modes.basis);
        const std::optional<StuckChain> chain = stuck_chain(p.modes.system, stuck);
        for (const double r : spaced(0.02, 3, 150)) {
            const StuckResponse response = stuck_response(stuck, p.modes.system.load, r);
            const StickingBoundary limits = sticking_boundary(response, chain, 1.0);
            worst = std::max(worst, std::abs(limits.paper.value() / limits.exact - 1));
        }
    }
    return std::string(
               "(88) leaves out the damping forces of the moving mass on the contact. With zeta_i r_n,i the same for both ") +
           "modes there are none: the two boundaries of permanent sticking differ by " +
           (worst < 1e-12 ? "less than 1e-12" : text(worst, "%.2g")) + ".";
}

/// The boundaries over a wide range, for logarithmic axes.
void add_wide(Figure& figure, const RegimePlane& p) {
    std::vector<double> r = spaced_in_octaves(0.05, 30, 1200);
    for (const double near : frequencies_for_boundaries(p.modes.system, 0.05, 3, 0.005)) r.push_back(near);
    std::ranges::sort(r);
    add(figure, "wide zeta=" + text(p.zeta), regime_curves(p.modes.system, 1, r));
}

Record make(Figure& figure) {
    const std::vector<RegimePlane> planes = regime_planes(figure, [](double zeta) { return two_masses(zeta); });
    for (const RegimePlane& p : planes) add_wide(figure, p);
    Record record = record_of(planes);
    record.title = "Regimes of motion of two masses, contact on mass 2, load on mass 1";
    record.equations = {"69", "88", "86", "67"};
    record.given = {"2DOF, equal masses and springs, j = 2, l = 1, mu = 1, zeta_i = zeta / r_n,i with zeta = 0.001, 0.01, 0.1",
                    "boundary of sliding by (69), of permanent sticking by Section 4.3"};
    record.chosen.push_back("panel (b): r = 0.05 to 30, both axes logarithmic");
    record.statements = {
        regimes_as_predicted(planes),
        limit_at_resonance(planes, 0),
        limit_at_resonance(planes, 1),
        limit_without_damping(planes.front()),
        zero_at_low_frequency(planes),
        unaffected_by_damping(planes, "low", 0.02, 0.1),
        unaffected_by_damping(planes, "high", 2.5, 100),
        zero_at_high_frequency(planes),
        stick_slip_at_high_frequency(planes),
        sticking_at_both_ends(planes),
    };
    record.remarks = {boundaries_compared(planes), sticking_as_printed(planes)};
    return record;
}

const Listed listed("fig10_two_masses_regimes", make);

} // namespace denhartog::figures::fig10_two_masses_regimes
