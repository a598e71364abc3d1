// Stops of a single mass in a period of the force, over frequency and friction ratio.
#include "regimes.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::stops_per_period {

/// The grid: a column for every frequency ratio, cells of equal height in the friction ratio.
struct Grid {
    std::vector<double> r = spaced_in_octaves(0.02, 3, 360); ///< frequency ratios, the columns
    std::vector<double> beta = spaced(0.0025, 1.0975, 220);  ///< friction ratios, the middles of the cells

    [[nodiscard]] double r_of(std::size_t cell) const { return r[cell / beta.size()]; }
    [[nodiscard]] double beta_of(std::size_t cell) const { return beta[cell % beta.size()]; }
};

/// The map at one damping ratio, with the paper's algorithm at some of its points.
struct StopMap {
    double zeta;                 ///< damping ratio
    System<double> system;       ///< the single mass
    RegimeMap map;               ///< regime, stops and amplitude over the grid
    std::vector<Marker> markers; ///< the paper's algorithm
    std::vector<MapPoint> there; ///< the map's answers at the markers
};

bool sticks_and_slips(const MapPoint& p) { return has_numbers(p.status) && p.regime == Regime::stick_slip; }

/// Stops per period as the picture colours them: 0 while the contact slides, -1 in permanent sticking.
double shown(const MapPoint& p) {
    if (!has_numbers(p.status)) return std::nan("");
    return p.regime == Regime::permanent_sticking ? -1 : static_cast<double>(p.stops) / p.periods;
}

/// Stops in the last of 200 periods by the paper's algorithm.
double shown(const Marker& m) { return m.motion.rests ? -1 : static_cast<double>(m.motion.stops.size()); }

std::string where(double r, double beta) { return "r = " + text(r, "%.3g") + ", beta = " + text(beta, "%.3g"); }

std::string where(const Grid& grid, std::size_t cell) { return where(grid.r_of(cell), grid.beta_of(cell)); }

RegimeMap map_of(const System<double>& system, const std::vector<double>& r, const std::vector<double>& beta) {
    Scene<double> scene;
    scene.system = system;
    const std::atomic<bool> stop{false};
    return regime_map(scene, {r, beta, {Mass{0}}, MapStart::rest, threads()}, stop);
}

void add_map(Figure& figure, const std::string& name, const Grid& grid, const RegimeMap& map) {
    Table table{name, {}, {}};
    for (const double r : grid.r) table.columns.push_back(text(r));
    for (std::size_t n = 0; n < grid.beta.size(); ++n) {
        std::vector<double> row;
        for (std::size_t m = 0; m < grid.r.size(); ++m) row.push_back(shown(map.points[m * grid.beta.size() + n]));
        table.rows.push_back(row);
    }
    figure.add(table);
}

StopMap stop_map(Figure& figure, const Grid& grid, double zeta) {
    StopMap m{zeta, single_mass(zeta), {}, {}, {}};
    m.map = map_of(m.system, grid.r, grid.beta);
    for (std::size_t n = 0; n < m.map.points.size(); ++n)
        if (!has_numbers(m.map.points[n].status)) throw std::runtime_error("no steady motion at " + where(grid, n));
    const std::string of = "zeta=" + text(zeta);
    add_map(figure, "map " + of, grid, m.map);
    add(figure, "boundary " + of, regime_curves(m.system, 1, spaced_in_octaves(0.02, 3, 1500)));

    const std::vector<double> r = spaced_in_octaves(0.03, 2.4, 14), beta = spaced(0.08, 1.08, 11);
    std::vector<std::pair<double, double>> points;
    for (const double a : r)
        for (const double b : beta) points.emplace_back(a, b);
    m.markers = markers(figure, m.system, 1, points);
    m.there = map_of(m.system, r, beta).points;
    Table table{"markers " + of, {"r", "beta", "stops", "stops by the exact solver"}, {}};
    for (std::size_t n = 0; n < points.size(); ++n)
        table.rows.push_back({points[n].first, points[n].second, shown(m.markers[n]), shown(m.there[n])});
    figure.add(table);
    return m;
}

Agreement stops_off(const StopMap& m) {
    std::vector<std::pair<double, std::string>> off;
    for (std::size_t n = 0; n < m.markers.size(); ++n)
        off.emplace_back(shown(m.markers[n]) - shown(m.there[n]), where(m.markers[n].r, m.markers[n].beta));
    return agreement("zeta = " + text(m.zeta) + ": stops in the last of 200 periods from rest, less those of the exact solver",
                     off);
}

std::string from_to(const StopMap& light, const StopMap& heavy) {
    return "from zeta = " + text(light.zeta) + " to " + text(heavy.zeta);
}

/// Change of the number of stops with damping, at points that stick and slip in two maps.
struct ChangeOfStops {
    int fewer = 0, equal = 0, more = 0; ///< points
    double most = 0;                    ///< the most that a number rises by
    std::size_t at = 0;                 ///< the first cell where it does
};

ChangeOfStops change_of_stops(const StopMap& light, const StopMap& heavy) {
    ChangeOfStops c;
    for (std::size_t n = 0; n < light.map.points.size(); ++n) {
        if (!sticks_and_slips(light.map.points[n]) || !sticks_and_slips(heavy.map.points[n])) continue;
        const double rise = shown(heavy.map.points[n]) - shown(light.map.points[n]);
        (rise < 0 ? c.fewer : rise > 0 ? c.more : c.equal) += 1;
        if (rise > c.most) {
            c.most = rise;
            c.at = n;
        }
    }
    return c;
}

Statement fewer_with_damping(const std::vector<StopMap>& maps) {
    bool reduced = true;
    std::string found;
    for (std::size_t n = 1; n < maps.size(); ++n) {
        const ChangeOfStops c = change_of_stops(maps[n - 1], maps[n]);
        const int all = c.fewer + c.equal + c.more;
        reduced = reduced && c.fewer > 0 && 20 * c.more < all;
        found += (n == 1 ? "" : "; ") + from_to(maps[n - 1], maps[n]) + " fewer at " + std::to_string(c.fewer) + " of " +
                 std::to_string(all) + " points in stick-slip with both, more at " + std::to_string(c.more);
    }
    return {"Damping can reduce the number of stops in most cases; here: it raises it at fewer than 5 points in 100", found,
            reduced};
}

/// A point where damping raises the number of stops most, asked of the paper's algorithm too.
std::string more_with_damping(const Figure& figure, const Grid& grid, const StopMap& light, const StopMap& heavy) {
    const ChangeOfStops c = change_of_stops(light, heavy);
    const std::string change = "F" + from_to(light, heavy).substr(1);
    if (c.most == 0) return change + " the number of stops rises nowhere.";
    const auto seen = [&](const StopMap& m) {
        return text(shown(markers(figure, m.system, 1, {{grid.r_of(c.at), grid.beta_of(c.at)}}).front()));
    };
    return change + " the number of stops rises most at " + where(grid, c.at) + ": from " + text(shown(light.map.points[c.at])) +
           " to " + text(shown(heavy.map.points[c.at])) + ", by the paper's algorithm from " + seen(light) + " to " +
           seen(heavy) + ".";
}

/// Change of the amplitude in stick-slip with damping, up to a frequency ratio.
Agreement change_of_amplitude(const Grid& grid, const StopMap& light, const StopMap& heavy, double up_to) {
    std::vector<std::pair<double, std::string>> off;
    for (std::size_t n = 0; n < light.map.points.size(); ++n)
        if (grid.r_of(n) <= up_to && sticks_and_slips(light.map.points[n]) && sticks_and_slips(heavy.map.points[n]))
            off.emplace_back(heavy.map.amplitudes[n] - light.map.amplitudes[n], where(grid, n));
    return agreement("", off);
}

/// The text on amplitudes in stick-slip at low frequencies; here: up to the frequency ratio of Fig. 13.
Statement amplitude_with_damping(const Grid& grid, const std::vector<StopMap>& maps) {
    std::string found;
    double worst = 0;
    for (std::size_t m = 1; m < maps.size(); ++m) {
        const Agreement low = change_of_amplitude(grid, maps[0], maps[m], 0.1);
        const Agreement farther = change_of_amplitude(grid, maps[0], maps[m], 0.2);
        worst = std::max(worst, std::abs(low.worst));
        found += (m == 1 ? "" : "; ") + from_to(maps[0], maps[m]) + " at the most by " + text(std::abs(low.worst), "%.2g") +
                 " at " + low.where + ", and for r up to 0.2 by " + text(std::abs(farther.worst), "%.2g") + " at " +
                 farther.where;
    }
    return {"Damping does not change the amplitude in stick-slip at low frequencies significantly; here: by less than a tenth of "
            "P / k_1, r = 0.02 to 0.1",
            found, worst < 0.1};
}

/// Whether nothing but stick-slip is found between the boundaries at the least frequency ratio.
Statement quasi_static(const Grid& grid, const std::vector<StopMap>& maps) {
    bool all = true;
    std::string limits, numbers;
    for (const StopMap& m : maps) {
        double most = 0;
        for (std::size_t n = 0; n < grid.beta.size() && grid.beta[n] < 1; ++n) {
            all = all && sticks_and_slips(m.map.points[n]);
            most = std::max(most, shown(m.map.points[n]));
        }
        limits += (limits.empty() ? "" : ", ") + text(boundaries_at(m.system, 1, grid.r.front()).paper, "%.2g");
        numbers += (numbers.empty() ? "" : ", ") + text(most);
    }
    return {"For r -> 0 the response sticks and slips; here: at every friction ratio from 0.0025 to 0.9975 at r = 0.02",
            "(69) is " + limits + " for zeta = 0.001, 0.01, 0.1; the contact stops up to " + numbers + " times a period", all};
}

Statement at_the_point_of_fig_13(Figure& figure, const std::vector<StopMap>& maps) {
    const double r = 0.1, beta = 0.2;
    figure.add({"point of Fig. 13", {"r", "beta"}, {{r, beta}}});
    std::string found;
    std::vector<double> stops;
    for (const StopMap& m : maps) {
        stops.push_back(shown(map_of(m.system, {r}, {beta}).points.front()));
        found += (found.empty() ? "" : ", ") + text(stops.back());
    }
    const bool falls = std::ranges::is_sorted(stops, std::greater<>());
    return {
        "Damping can smooth the response, most of all zeta = 0.1 at r = 0.1, beta = 0.2 of Fig. 13; here: by fewer stops there",
        found + " stops for zeta = 0.001, 0.01, 0.1", falls && stops.back() < stops.front()};
}

Statement regimes_as_predicted(const std::vector<StopMap>& maps) {
    std::size_t points = 0, same = 0;
    for (const StopMap& m : maps)
        for (const Marker& marker : m.markers) {
            const BoundaryPoint limits = boundaries_at(m.system, 1, marker.r);
            const double stops = shown(marker);
            const bool slides = marker.beta < limits.exact, rests = marker.beta >= limits.sticking.value();
            ++points;
            same += slides ? stops == 0 : rests ? stops == -1 : stops > 0;
        }
    return {
        "Continuous, stick-slip and permanent sticking responses occur as the boundaries predict",
        "at " + std::to_string(same) + " of " + std::to_string(points) +
            " points the last of 200 periods has no stop below (69), stops between the boundaries, and no motion from (88) on",
        same == points};
}

std::string numbers_in_all(const Grid& grid, const std::vector<StopMap>& maps) {
    std::string line;
    bool even = true;
    int without = 0;
    for (const StopMap& m : maps) {
        std::size_t at = 0;
        for (std::size_t n = 0; n < m.map.points.size(); ++n) {
            const MapPoint& p = m.map.points[n];
            if (shown(p) > shown(m.map.points[at])) at = n;
            even = even && (!sticks_and_slips(p) || p.stops % (2 * p.periods) == 0);
        }
        for (std::size_t a = 0; a < grid.r.size(); ++a) {
            const double limit = boundaries_at(m.system, 1, grid.r[a]).exact;
            for (std::size_t b = 0; b < grid.beta.size(); ++b)
                without += grid.beta[b] > limit && m.map.points[a * grid.beta.size() + b].regime == Regime::continuous;
        }
        line += (line.empty() ? "" : "; ") + text(shown(m.map.points[at])) + " at " + where(grid, at);
    }
    return "Most stops for zeta = 0.001, 0.01, 0.1: " + line + ". The number in a period of the force is " +
           (even ? "even everywhere" : "not always even") + "; at " + std::to_string(without) +
           " points above (69) the contact moves without a stop.";
}

Record make(Figure& figure) {
    const Grid grid;
    std::vector<StopMap> maps;
    for (const double zeta : {0.001, 0.01, 0.1}) maps.push_back(stop_map(figure, grid, zeta));
    Record record;
    record.title = "Stops of a single mass in a period of the force";
    record.equations = {"69", "88"};
    record.given = {"SDOF, mu = 1, zeta = 0.001, 0.01, 0.1, as in Fig. 7"};
    record.chosen = {"r = 0.02 to 3, 360 values, logarithmic; beta = 0.0025 to 1.0975, 220 values",
                     "numbers of stops by the exact solver",
                     "markers: the last of 200 periods from rest, r = 0.03 to 2.4, 14 values, beta = 0.08 to 1.08, 11 values; a "
                     "cross where the number is another"};
    for (const StopMap& m : maps) record.agreements.push_back(stops_off(m));
    record.statements = {regimes_as_predicted(maps), fewer_with_damping(maps), amplitude_with_damping(grid, maps),
                         quasi_static(grid, maps), at_the_point_of_fig_13(figure, maps)};
    record.remarks = {numbers_in_all(grid, maps), more_with_damping(figure, grid, maps[0], maps[1]),
                      more_with_damping(figure, grid, maps[1], maps[2])};
    return record;
}

const Listed listed("stops_per_period", make);

} // namespace denhartog::figures::stops_per_period
