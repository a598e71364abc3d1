// Fig. 13: steady stick-slip motion of a single mass at a low frequency for three damping ratios.
#include "denhartog/solve/sampled_solution.hpp"
#include "denhartog/solve/solve.hpp"
#include "markers.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::fig13_quasi_static_response {

/// The motion at a damping ratio: exact, and by the paper's algorithm.
struct StickSlipMotion {
    double zeta;           ///< damping ratio
    SampledSolution exact; ///< over a period of the force
    double amplitude;      ///< exact
    int stops;             ///< in a period of the force, exact
    double resting;        ///< part of the period that the contact rests, exact
    double largest_speed;  ///< largest velocity, exact
    PaperMotion numerical; ///< last period
};

StickSlipMotion motion_at(const Figure& figure, double zeta, double r, double beta) {
    const std::size_t samples = 2000, markers_per_period = 40;
    Scene<double> scene;
    scene.system = single_mass(zeta);
    scene.r = r;
    scene.beta = beta;
    const SceneSource source = scene_source(scene);
    const Solution solution = solve(source, {});
    StickSlipMotion motion{zeta, sampled_solution(source, solution, samples), solution.masses.front().amplitude.value, 0, 0, 0,
                           {}};
    motion.stops = static_cast<int>(solution.stops.size()) / solution.periods;
    for (const SolvedStop& stop : solution.stops)
        motion.resting += (stop.end.value - stop.start.value) / (2 * pi<double>() * solution.periods);
    for (const double speed : motion.exact.x_prime) motion.largest_speed = std::max(motion.largest_speed, std::abs(speed));
    PaperSettings settings;
    settings.samples = markers_per_period;
    motion.numerical = markers(figure, scene.system, 1, {{r, beta}}, settings).front().motion;
    return motion;
}

Record make(Figure& figure) {
    const double r = 0.1, beta = 0.2;
    std::vector<StickSlipMotion> motions;
    for (const double zeta : {0.001, 0.01, 0.1}) motions.push_back(motion_at(figure, zeta, r, beta));

    Record record;
    std::string stops, amplitudes, speeds, resting;
    double least = 1e300, largest = 0;
    bool same_stops = true, fewer = true;
    for (const StickSlipMotion& m : motions) {
        const std::string name = "zeta=" + text(m.zeta), comma = stops.empty() ? "" : ", ";
        Table line{name, {"tau over pi", "x", "x'"}, {}}, dots{"numerical " + name, {"tau over pi", "x", "x'"}, {}};
        for (std::size_t n = 0; n < m.exact.tau.size(); ++n)
            line.rows.push_back({m.exact.tau[n] / pi<double>(), m.exact.x[n], m.exact.x_prime[n]});
        std::vector<std::pair<double, std::string>> off;
        const std::size_t step = m.exact.tau.size() / m.numerical.samples.size();
        for (std::size_t n = 0; n < m.numerical.samples.size(); ++n) {
            const double tau = m.numerical.sample_times[n] / pi<double>(), x = m.numerical.samples[n].x[0];
            dots.rows.push_back({tau, x, m.numerical.samples[n].x_prime[0]});
            off.emplace_back((x - m.exact.x[n * step]) / m.amplitude, "tau = " + text(tau) + " pi");
        }
        figure.add(line);
        figure.add(dots);
        record.agreements.push_back(agreement("zeta = " + text(m.zeta) + ": displacements, over the amplitude", off));
        stops += comma + std::to_string(m.stops);
        amplitudes += comma + text(m.amplitude);
        speeds += comma + text(m.largest_speed, "%.3g");
        resting += comma + text(100 * m.resting, "%.3g");
        least = std::min(least, m.amplitude);
        largest = std::max(largest, m.amplitude);
        same_stops = same_stops && m.stops == static_cast<int>(m.numerical.stops.size());
        fewer = fewer && m.stops <= motions.front().stops;
    }
    const double slower = motions.back().largest_speed / motions.front().largest_speed;
    record.title = "Steady stick-slip motion of a single mass at a low frequency";
    record.equations = {"6", "74", "75"};
    record.given = {"SDOF, r = 0.1, beta = 0.2, mu = 1", "zeta = 0.1 for one of the curves"};
    record.chosen = {"zeta = 0.001 and 0.01 besides, as in Fig. 6", "a period of the force from its maximum, tau = 0",
                     "(b) the velocity besides: where it is zero the contact rests, or turns back",
                     "lines: exact solver; markers: 40 instants of the last of 200 periods from rest"};
    record.statements = {
        {"The motion is stick-slip at low frequencies whatever zeta",
         "stops in a period: " + stops + " at zeta = 0.001, 0.01, 0.1",
         std::ranges::all_of(motions, [](const StickSlipMotion& m) { return m.stops > 0; })},
        {"Damping can reduce the number of stops",
         stops + " at zeta = 0.001, 0.01, 0.1" +
             (same_stops ? "; the paper's algorithm counts the same" : "; the paper's algorithm counts otherwise"),
         fewer && motions.back().stops < motions.front().stops && same_stops},
        {"Damping does not change the amplitude significantly; here: by less than 5 percent",
         "amplitude " + amplitudes + ": by " + text(100 * (largest / least - 1), "%.3g") + " percent", largest / least < 1.05,
         "by less than 5 percent"},
        {"Damping smooths the motion, most of all at zeta = 0.1; here: the largest velocity falls by a tenth at least",
         "largest velocity " + speeds + " at zeta = 0.001, 0.01, 0.1", slower < 0.9, "by a tenth"}};
    record.remarks = {"The contact rests " + resting + " percent of the time at zeta = 0.001, 0.01, 0.1."};
    return record;
}

const Listed listed("fig13_quasi_static_response", make);

} // namespace denhartog::figures::fig13_quasi_static_response
