/// @file
/// @brief What Section 4 of the paper says of Figs. 6, 8 and 9, with numbers. Header only.
#pragma once

#include "response_over_r.hpp"

namespace denhartog::figures {

/// @brief A list with a separator. @param list the list so far @param more what is added @param by the separator @return both
[[nodiscard]] inline std::string joined(const std::string& list, const std::string& more, const std::string& by = "; ") {
    return list.empty() ? more : list + by + more;
}

/// @brief Resonant peaks: whether they are finite, where they are, and how high (83) has them.
/// @param record  gets three statements
/// @param all     the systems
/// @param k       the mass
/// @param betas   friction ratios, ascending
inline void peak_statements(Record& record, const std::vector<Damped>& all, Mass k, const std::vector<double>& betas) {
    std::string heights, shifts;
    bool finite = true, shifted = true;
    double worst = 0, worst_to_half = 0;
    for (const Damped& d : all)
        for (std::size_t i = 0; i < d.modes.basis.r_n.size(); ++i) {
            const double r_n = d.modes.basis.r_n[i];
            const std::string at = "zeta = " + plain(d.zeta) + (d.modes.basis.r_n.size() > 1 ? ", r = " + text(r_n, "%.3f") : "");
            std::optional<Peak> last;
            double beta_last = 0;
            for (const double beta : betas) {
                const std::optional<Peak> peak = sliding_peak(d.modes, k, i, beta);
                // closer to the boundary at resonance the contact may stick at the peak
                if (beta < 0.8 * d.modes.estimated_limit(i)) finite = finite && peak && std::isfinite(peak->X);
                if (!peak || beta >= d.modes.estimated_limit(i)) continue;
                const double off = std::abs(d.modes.estimated_peak(k, i, beta) / peak->X - 1);
                worst = std::max(worst, off);
                if (beta <= d.modes.estimated_limit(i) / 2) worst_to_half = std::max(worst_to_half, off);
                last = peak;
                beta_last = beta;
                if (beta == betas.front()) heights = joined(heights, text(peak->X) + " at " + at);
            }
            if (!last) continue;
            const double excess = last->X / d.modes.estimated_peak(k, i, beta_last) - 1;
            shifted = shifted && last->r < r_n && excess > 0;
            shifts = joined(shifts, at + ", beta = " + plain(beta_last) + ": r / r_n = 1 " + (last->r < r_n ? "- " : "+ ") +
                                        text(std::abs(1 - last->r / r_n), "%.2g") + ", " + text(100 * std::abs(excess), "%.2g") +
                                        " % " + (excess > 0 ? "above" : "below"));
        }
    record.statements.push_back({"With damping the resonant peaks are finite while the contact slides",
                                 "beta = " + plain(betas.front()) + ": " + heights, finite});
    record.statements.push_back(
        {"At large friction ratios the peak is shifted slightly to the left, and (83) underestimates it", shifts, shifted});
    record.statements.push_back({"Peaks estimated by (83) and actual ones agree very well",
                                 "at friction ratios up to half of (85) (83) is at most " + text(100 * worst_to_half, "%.2g") +
                                     " % off, at all up to (85) at most " + text(100 * worst, "%.2g") + " %",
                                 worst < 0.05, "to 5 percent"});
}

/// @brief Whether damping changes amplitudes.
/// @param what     the statement
/// @param range    which amplitudes, in words
/// @param changes  relative changes, as for `agreement`
/// @return         the statement; borne out where nine amplitudes in ten change by less than 5 %
[[nodiscard]] inline Statement little_changed(const std::string& what, const std::string& range,
                                              const std::vector<std::pair<double, std::string>>& changes) {
    const Agreement a = agreement(what, changes);
    const auto little = std::ranges::count_if(changes, [](const auto& each) { return std::abs(each.first) < 0.05; });
    return {what,
            range + ": " + std::to_string(little) + " of " + std::to_string(a.points) +
                " amplitudes change by less than 5 %, median " + text(100 * a.median, "%.2g") + " %, largest " +
                text(100 * a.worst, "%.2g") + " % at " + a.where,
            10 * little >= 9 * a.points, "by less than 5 percent at nine points in ten"};
}

/// @brief Changes of amplitudes from one damping ratio to another.
/// @param from  sweeps at one damping ratio
/// @param to    at the other, same points
/// @param r_a   least frequency ratio
/// @param r_b   largest
/// @return      relative changes, as for `agreement`
[[nodiscard]] inline std::vector<std::pair<double, std::string>> changes(const std::vector<Sweep>& from,
                                                                         const std::vector<Sweep>& to, double r_a, double r_b) {
    std::vector<std::pair<double, std::string>> list;
    for (std::size_t b = 0; b < from.size(); ++b)
        for (std::size_t n = 0; n < from[b].points.size(); ++n) {
            const SweepPoint &p = from[b].points[n], &q = to[b].points[n];
            if (p.r >= r_a && p.r <= r_b && p.X > 0)
                list.emplace_back(q.X / p.X - 1, "r = " + text(p.r) + ", beta = " + plain(from[b].beta));
        }
    return list;
}

/// @brief The quasi-static response: amplitudes and stops over damping, and where the motion slides.
/// @param record  gets statements
/// @param all     systems, damping ascending
/// @param to      largest frequency ratio that counts as low
inline void low_frequency_statements(Record& record, const std::vector<Damped>& all, double to) {
    const std::string range = "r up to " + plain(to);
    for (std::size_t n = 1; n < all.size(); ++n)
        record.statements.push_back(
            little_changed("At low frequency ratios damping does in general not change the amplitudes significantly",
                           range + ", zeta from " + plain(all[0].zeta) + " to " + plain(all[n].zeta),
                           changes(all[0].points, all[n].points, 0, to)));
    std::vector<int> stops;
    std::string numbers;
    double slides_from = all[0].lines[0].points.back().r;
    for (const Damped& d : all) {
        stops.push_back(0);
        for (const Sweep& line : d.lines)
            for (const SweepPoint& p : line.points)
                if (p.r <= to) stops.back() += p.stops;
        numbers = joined(numbers, std::to_string(stops.back()) + " at zeta = " + plain(d.zeta), ", ");
        for (const SweepPoint& p : d.lines[1].points)
            if (p.regime == Regime::continuous) slides_from = std::min(slides_from, p.r);
    }
    record.statements.push_back({"Damping can reduce the number of stops at low frequency ratios",
                                 "stops per period, summed over all points of the lines, " + range + ": " + numbers,
                                 stops.back() < stops.front()});
    const auto largest_limit = [&](double r) {
        double limit = 0;
        for (const Damped& d : all)
            for (const double each : spaced_in_octaves(r / 3, r, 60))
                limit = std::max(limit, boundary(d.modes.at(each), 1.0).exact);
        return limit;
    };
    const double near = largest_limit(0.1), nearer = largest_limit(0.01);
    record.statements.push_back({"The quasi-static response has stops: the boundary of continuous motion tends to zero with r",
                                 "beta = " + plain(all[0].lines[1].beta) + " slides throughout at no r of the lines below " +
                                     text(slides_from, "%.3f") + "; the boundary is at most " + text(near, "%.2g") +
                                     " for r next to 0.1 and " + text(nearer, "%.2g") + " next to 0.01",
                                 slides_from > all[0].lines[1].points.front().r && nearer < near / 5});
}

/// @brief What damping changes far beyond the figure's range, and how the amplitude falls there.
/// @param record  gets two statements
/// @param all     systems, damping ascending
/// @param k       the mass
/// @param betas   friction ratios
inline void high_frequency_statements(Record& record, const std::vector<Damped>& all, Mass k, std::vector<double> betas) {
    betas.insert(betas.begin(), 0);
    std::vector<std::vector<Sweep>> far;
    double near_most = 0, far_most = 0;
    for (const Damped& d : all) {
        far.push_back(sweeps(d.modes.system, k, {10, 100}, betas));
        for (const Sweep& sweep : far.back()) {
            near_most = std::max(near_most, sweep.points[0].X);
            far_most = std::max(far_most, sweep.points[1].X);
        }
    }
    const std::vector<SweepPoint>& without_friction = far[0][0].points;
    record.statements.push_back(
        little_changed("Damping does not change the behaviour at high frequency ratios significantly",
                       "r = 10 and 100, zeta from " + plain(all.front().zeta) + " to " + plain(all.back().zeta),
                       changes(far.front(), far.back(), 10, 100)));
    record.statements.push_back(
        {"The transmissibility tends to zero for high frequency ratios",
         "at most " + text(near_most, "%.3g") + " at r = 10 and " + text(far_most, "%.3g") +
             " at r = 100, over all damping and friction ratios; without friction it falls as 1 / r to the power " +
             text(std::log10(without_friction[0].X / without_friction[1].X), "%.3f"),
         far_most < near_most / 10});
}

} // namespace denhartog::figures
