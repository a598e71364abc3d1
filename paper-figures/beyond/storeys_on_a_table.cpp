// Three storeys on a shaking table, in millimetres, newtons and hertz: the frame of docs/your-own-system.md.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "denhartog/map/regime_map.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "figure.hpp"
#include "regimes.hpp"

namespace denhartog::figures::storeys_on_a_table {

constexpr Mass top{2}; // the third storey

/// The scene of the page.
Scene<double> frame() {
    std::ifstream in(DENHARTOG_DOCS "/example_dashpots.json");
    if (!in) throw std::runtime_error("docs/example_dashpots.json cannot be read");
    return read_scene<double>(std::string(std::istreambuf_iterator<char>(in), {}));
}

/// Largest displacements of the top over a grid, in millimetres, frequency by friction.
RegimeMap map_of_top(const Scene<double>& scene, const std::vector<double>& hertz, const std::vector<double>& friction) {
    MapRequest request;
    request.masses = {top};
    request.threads = threads();
    const std::atomic<bool> stop{false};
    RegimeMap map = map_in_units(scene, frequencies_in_units(scene, "frequency_hz", hertz), RowsOf::friction, friction, request,
                                 stop, [](std::size_t) {});
    for (double& each : map.amplitudes) each *= 1000;
    return map;
}

/// Where the column of a map is largest over frequency, for one friction force of it.
std::size_t column_of_peak(const RegimeMap& map, std::size_t rows, std::size_t row) {
    std::size_t at = 0;
    for (std::size_t m = 0; m * rows < map.amplitudes.size(); ++m)
        if (map.amplitudes[m * rows + row] > map.amplitudes[at * rows + row]) at = m;
    return at;
}

Record make(Figure& figure) {
    const Scene<double> scene = frame();
    const std::vector<double> hertz = spaced(1, 4.5, 351), shown{0, 5, 20, 40, 60, 120};
    const std::vector<double> friction = spaced(0, 120, 121), at{2.6, 2.9, 3.2};
    const RegimeMap over_frequency = map_of_top(scene, hertz, shown), over_friction = map_of_top(scene, at, friction);
    const RegimeMap all = map_of_top(scene, hertz, friction);
    figure.progress(1, 1);
    Record record;
    record.title = "Three storeys on a shaking table: displacement of the top over frequency and over the friction force";
    record.equations = {"38", "69"};
    record.given = {"none: a system of ours, docs/your-own-system.md"};
    record.chosen = {"docs/example_dashpots.json: masses 12, 11.5, 9.8 kg, dashpots that couple the modes, a friction damper "
                     "between the first "
                     "storey and the second, the table moving by 2 mm; displacements relative to the table"};
    for (std::size_t n = 0; n < shown.size(); ++n) {
        Table table{"a " + text(shown[n]) + " N", {"frequency_hz", "top_mm", "slides"}, {}};
        for (std::size_t m = 0; m < hertz.size(); ++m) {
            const std::size_t place = m * shown.size() + n;
            const bool slides = over_frequency.points[place].regime == Regime::continuous;
            table.rows.push_back({hertz[m], over_frequency.amplitudes[place], slides ? 1.0 : 0.0});
        }
        figure.add(table);
    }
    for (std::size_t m = 0; m < at.size(); ++m) {
        Table table{"b " + text(at[m]) + " Hz", {"friction", "top_mm"}, {}};
        for (std::size_t n = 0; n < friction.size(); ++n)
            table.rows.push_back({friction[n], over_friction.amplitudes[m * friction.size() + n]});
        figure.add(table);
    }
    std::vector<double> peaks;
    for (std::size_t n = 0; n < friction.size(); ++n)
        peaks.push_back(all.amplitudes[column_of_peak(all, friction.size(), n) * friction.size() + n]);
    const auto best = static_cast<std::size_t>(std::ranges::min_element(peaks) - peaks.begin());
    record.statements = {{"There is a friction force that is best: less slides without taking energy, more holds the damper",
                          "of the forces from 0 to 120 N, " + text(friction[best]) + " N gives the lowest peak over frequency, " +
                              text(peaks[best], "%.3g") + " mm; without friction it is " + text(peaks.front(), "%.3g") +
                              " mm, with 120 N " + text(peaks.back(), "%.3g") + " mm",
                          best > 0 && best + 1 < friction.size()}};
    return record;
}

const Listed listed("storeys_on_a_table", make);

} // namespace denhartog::figures::storeys_on_a_table
