/// @file
/// @brief The plane of frequency and friction ratio for three damping ratios at mu = 1: what Figs. 7 and 10 share. Header only.
#pragma once

#include "regimes.hpp"
#include "tests/support/largest_over_range.hpp"

namespace denhartog::figures {

/// @brief The plane at one damping ratio.
struct RegimePlane {
    double zeta;                              ///< the damping ratio that names it
    WithModes modes;                          ///< the system
    std::vector<SeenBoundaries> seen;         ///< boundaries by the paper's algorithm, from rest
    std::vector<SeenBoundaries> from_sliding; ///< the same, from the closed form
    std::vector<RegimeCheck> checks;          ///< regimes on a grid by the paper's algorithm, from rest

    /// @brief Boundaries at a frequency ratio. @param r frequency ratio @return the boundaries
    [[nodiscard]] Boundary<double> at(double r) const { return boundary(modes.at(r), 1.0); }
};

/// @brief Computes the planes: boundaries, the same with the paper's algorithm at r = 0.1, 0.2 .. 2.9, regimes on a grid.
/// @param figure  gets the tables `zeta=..` and `numerical zeta=..`
/// @param family  the system with a damping ratio
/// @return        planes for 0.001, 0.01, 0.1
[[nodiscard]] inline std::vector<RegimePlane> regime_planes(Figure& figure,
                                                            const std::function<System<double>(double zeta)>& family) {
    std::vector<double> frequencies;
    std::vector<std::pair<double, double>> grid;
    for (int n = 1; n <= 29; ++n) {
        frequencies.push_back(n / 10.0);
        for (int m = 0; m < 13; ++m) grid.emplace_back(n / 10.0, (7 + 10 * m) / 100.0);
    }
    std::vector<RegimePlane> planes;
    for (const double zeta : {0.001, 0.01, 0.1}) {
        RegimePlane plane{zeta, WithModes(family(zeta)), {}, {}, {}};
        const System<double>& system = plane.modes.system;
        plane.seen = seen_boundaries(figure, system, 1, frequencies, [](double, double) { return PaperSettings{}; });
        plane.from_sliding = seen_boundaries(figure, system, 1, frequencies, from_sliding(plane.modes, 1));
        plane.checks = checked_regimes(figure, system, 1, grid);
        const std::string name = "zeta=" + text(zeta);
        add(figure, name, regime_curves(system, 1, frequencies_for_boundaries(system, 0.01, 3, 0.005)));
        add(figure, "numerical " + name, plane.seen);
        planes.push_back(plane);
    }
    return planes;
}

/// @brief How far the boundaries by the paper's algorithm are from the closed form, plane by plane.
/// @param planes  the planes
/// @return        (69) from rest and from the closed form, permanent sticking from rest; relative
[[nodiscard]] inline std::vector<Agreement> agreements(const std::vector<RegimePlane>& planes) {
    std::vector<Agreement> all;
    for (const RegimePlane& plane : planes) {
        std::vector<std::pair<double, std::string>> rest, sliding, sticking;
        for (std::size_t n = 0; n < plane.seen.size(); ++n) {
            const SeenBoundaries& seen = plane.seen[n];
            const Boundary<double> limits = plane.at(seen.r);
            const std::string where = "r = " + text(seen.r);
            rest.emplace_back(seen.sliding / limits.exact - 1, where);
            sliding.emplace_back(plane.from_sliding[n].sliding / limits.exact - 1, where);
            sticking.emplace_back(seen.sticking / limits.sticking.value() - 1, where);
        }
        const std::string zeta = "zeta = " + text(plane.zeta) + ": ";
        all.push_back(agreement(zeta + "end of sliding, from rest, relative", rest));
        all.push_back(agreement(zeta + "end of sliding, from the closed form, relative", sliding));
        all.push_back(agreement(zeta + "begin of permanent sticking, from rest, relative", sticking));
    }
    return all;
}

/// @brief The text on the regimes of the numerical response: as predicted.
/// @param planes  the planes
/// @return        the statement, with what becomes of the points where they differ
[[nodiscard]] inline Statement regimes_as_predicted(const std::vector<RegimePlane>& planes) {
    int points = 0, differ = 0, creep = 0, settled = 0;
    std::string where;
    for (const RegimePlane& plane : planes)
        for (const RegimeCheck& c : plane.checks) {
            ++points;
            if (c.seen == c.predicted) continue;
            ++differ;
            creep += c.creeps;
            settled += c.exact == c.predicted;
            if (!c.creeps)
                where += std::string(where.empty() ? "" : "; ") + "zeta = " + text(plane.zeta) + ", r = " + text(c.r) +
                         ", beta = " + text(c.beta);
        }
    Statement s{"Continuous, stick-slip and permanent sticking responses occur as the boundaries predict", "", differ == 0};
    s.found = "the last of 200 periods has the predicted regime at " + std::to_string(points - differ) + " of " +
              std::to_string(points) + " points";
    if (differ > 0)
        s.found += "; at " + std::to_string(creep) + " of the other " + std::to_string(differ) +
                   " the contact still creeps one way to its rest" + (where.empty() ? "" : ", not so at " + where) +
                   "; the exact solver finds the predicted regime at " + std::to_string(settled) + " of them";
    return s;
}

/// @brief Values of a function for the three damping ratios as text. @param planes the planes @param f the function @return text
[[nodiscard]] inline std::string for_each_zeta(const std::vector<RegimePlane>& planes,
                                               const std::function<double(const RegimePlane&)>& f) {
    std::string line;
    for (const RegimePlane& plane : planes) line += (line.empty() ? "" : ", ") + text(f(plane), "%.3g");
    return line;
}

/// @brief The text on low frequencies: (69) tends to zero; here: below 1e-4 at r = 0.01, whatever the damping.
/// @param planes  the planes
/// @return        the statement
[[nodiscard]] inline Statement zero_at_low_frequency(const std::vector<RegimePlane>& planes) {
    const double r = 0.01;
    double largest = 0;
    for (const RegimePlane& plane : planes) largest = std::max(largest, plane.at(r).paper);
    return {"The boundary (69) tends to zero for r -> 0; here: below 1e-4 at r = 0.01",
            "at r = 0.1 " + for_each_zeta(planes, [](const RegimePlane& p) { return p.at(0.1).paper; }) + "; at r = 0.01 " +
                for_each_zeta(planes, [&](const RegimePlane& p) { return p.at(r).paper; }),
            largest < 1e-4, "to 1e-4 at r = 0.01"};
}

/// @brief How a boundary changes from the least damping ratio to larger ones.
struct ChangeWithDamping {
    double least;    ///< least quotient with it at the least damping ratio
    double largest;  ///< largest
    double absolute; ///< largest difference
};

/// @brief How a boundary changes with damping over frequency ratios.
/// @param planes  the planes
/// @param from    least frequency ratio
/// @param to      largest
/// @param of      which boundary
/// @return        the change
[[nodiscard]] inline ChangeWithDamping change_with_damping(const std::vector<RegimePlane>& planes, double from, double to,
                                                           const std::function<double(const Boundary<double>&)>& of) {
    ChangeWithDamping change{1, 1, 0};
    for (const double r : spaced_in_octaves(from, to, 200)) {
        const double light = of(planes.front().at(r));
        for (const RegimePlane& plane : planes) {
            const double here = of(plane.at(r));
            change = {std::min(change.least, here / light), std::max(change.largest, here / light),
                      std::max(change.absolute, std::abs(here - light))};
        }
    }
    return change;
}

/// @brief A change as a sentence. @param change the change @return e.g. `0.95 to 1.2 times that at zeta = 0.001, ..`
[[nodiscard]] inline std::string as_text(const ChangeWithDamping& change) {
    return text(change.least, "%.3g") + " to " + text(change.largest, "%.3g") + " times that at zeta = 0.001, at the most by " +
           text(change.absolute, "%.2g") + " off it";
}

/// @brief The text on low and high frequencies: damping does not change them significantly; here: (69) by less than a tenth of
/// itself.
/// @param planes  the planes
/// @param end     `low` or `high`
/// @param from    least frequency ratio
/// @param to      largest
/// @return        the statement
[[nodiscard]] inline Statement unaffected_by_damping(const std::vector<RegimePlane>& planes, const std::string& end, double from,
                                                     double to) {
    const ChangeWithDamping change = change_with_damping(planes, from, to, [](const Boundary<double>& b) { return b.paper; });
    return {"Damping does not change the behaviour at " + end +
                " frequencies significantly; here: (69) by less than a tenth of itself, r = " + text(from) + " to " + text(to),
            "(69) at zeta = 0.01 and 0.1 is " + as_text(change), change.least > 0.9 && change.largest < 1.1,
            "by less than a tenth"};
}

/// @brief The text on (85): at resonance it approximates (69); here: to a tenth for damping ratios up to 0.01.
/// @param planes  the planes
/// @param mode    a mode, from 0
/// @return        the statement
[[nodiscard]] inline Statement limit_at_resonance(const std::vector<RegimePlane>& planes, std::size_t mode) {
    const auto estimate = [&](const RegimePlane& p) { return p.modes.estimated_limit(mode); };
    const auto limit = [&](const RegimePlane& p) { return p.at(p.modes.basis.r_n[mode]).paper; };
    double worst = 0;
    for (const RegimePlane& p : planes)
        if (p.zeta < 0.1) worst = std::max(worst, std::abs(estimate(p) / limit(p) - 1));
    return {"At resonance " + std::to_string(mode + 1) + " (85) approximates (69); here: to a tenth for zeta = 0.001 and 0.01",
            "(85) " + for_each_zeta(planes, estimate) + ", (69) " + for_each_zeta(planes, limit), worst < 0.1, "to a tenth"};
}

/// @brief How much larger the boundaries with less cost are than (69), as a remark.
/// @param planes  the planes
/// @return        (67) and the maximum over the sum against (69) with (56), the largest found over r = 0.02 to 3
[[nodiscard]] inline std::string boundaries_compared(const std::vector<RegimePlane>& planes) {
    const auto largest = [](const RegimePlane& p, const std::function<double(const Boundary<double>&)>& of) {
        const auto departure = [&](double r) {
            const Boundary<double> b = p.at(r);
            return of(b) / b.paper - 1;
        };
        return largest_over_range(departure, 0.02, 3, 1490);
    };
    const auto with_place = [&](const std::function<LargestOverRange(const RegimePlane&)>& most) {
        std::string line;
        for (const RegimePlane& p : planes) {
            const LargestOverRange found = most(p);
            line += (line.empty() ? "" : ", ") + text(100 * found.value, "%.3g") + " (r = " + text(found.x) + ")";
        }
        return line;
    };
    const auto approximate = [&](const RegimePlane& p) { return largest(p, [](const auto& b) { return b.approximate; }); };
    const auto exact = [&](const RegimePlane& p) { return largest(p, [](const auto& b) { return b.exact; }); };
    std::string line = "For zeta = 0.001, 0.01, 0.1 the approximate boundary (67) is as much as " + with_place(approximate) +
                       " percent above (69), the largest that a search over r = 0.02 to 3 finds";
    bool differs = false;
    for (const RegimePlane& p : planes) differs = differs || exact(p).value > 1e-8;
    return line + (differs ? "; the maximum over the sum of the modes in place of the sum of their maxima (56) raises it by " +
                                 with_place(exact) + " percent, likewise."
                           : ".");
}

/// @brief The half of the record that Figs. 7 and 10 share.
/// @param planes  the planes
/// @return        parameters and agreements
[[nodiscard]] inline Record record_of(const std::vector<RegimePlane>& planes) {
    Record record;
    record.chosen = {"r = 0.01 to 3",
                     "markers: friction ratios at which the last of 200 periods from rest changes its regime, found by halving, "
                     "r = 0.1 to 2.9 in steps of 0.1",
                     "a contact that still creeps one way in the last period counts as resting for the markers",
                     "regimes: the same r, beta = 0.07 to 1.27 in steps of 0.1, every slip counted"};
    record.agreements = agreements(planes);
    return record;
}

} // namespace denhartog::figures
