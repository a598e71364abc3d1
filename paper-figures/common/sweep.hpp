/// @file
/// @brief A mass over the frequency ratio: closed form, exact solver and the paper's algorithm, side by side. Header only.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "denhartog/map/regime_map.hpp"
#include "denhartog/number/parallel.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "markers.hpp"

namespace denhartog::figures {

/// @brief The state where the force is largest while the contact rests at zero.
[[nodiscard]] inline State held_at_maximum_of_force(const StuckResponse& stuck) {
    State state;
    for (const StuckMass& mass : stuck.masses) {
        state.x.push_back(mass.X.re);
        state.x_prime.push_back(-mass.X.im);
    }
    return state;
}

/// @brief A mass at a frequency ratio and a friction ratio.
struct SweepPoint {
    double r;                                 ///< frequency ratio
    Regime regime;                            ///< regime of the steady motion
    double X;                                 ///< its amplitude, the largest displacement over the motion
    int stops;                                ///< stops in a period of the force
    std::optional<MassResponse<double>> mass; ///< the closed form, where the contact slides throughout
    std::optional<State> start;               ///< the state at a maximum of the force; none in stick-slip
};

/// @brief A mass over the frequency ratio at a friction ratio.
struct Sweep {
    double beta;                    ///< friction ratio
    std::vector<SweepPoint> points; ///< frequency ratios ascending
};

/// @brief The text that tables and records name a number by. @param x the number @return e.g. `0.1`
[[nodiscard]] inline std::string plain(double x) { return text(x, "%g"); }

/// @brief Frequency ratios of a figure, closer to each other next to resonances.
/// @param from        least
/// @param to          largest
/// @param step        between them, away from resonances
/// @param resonances  natural frequency ratios, each with its damping ratio
/// @return            frequency ratios, ascending
[[nodiscard]] inline std::vector<double> frequencies(double from, double to, double step,
                                                     const std::vector<std::pair<double, double>>& resonances) {
    std::vector<double> all = spaced(from, to, static_cast<std::size_t>(std::lround((to - from) / step)) + 1);
    for (const auto& [r_n, zeta] : resonances) {
        all.push_back(r_n);
        for (const double distance : spaced_in_octaves(r_n * zeta / 16, 3 * step, 30)) {
            all.push_back(r_n - distance);
            all.push_back(r_n + distance);
        }
    }
    std::erase_if(all, [&](double r) { return r < from || r > to; });
    std::ranges::sort(all);
    return all;
}

/// @brief Steady motions of a mass over frequency and friction.
/// @param system       the system
/// @param k            the mass
/// @param frequencies  frequency ratios
/// @param betas        friction ratios, ascending
/// @return             a sweep for every friction ratio; mu = 1
/// @throws             std::runtime_error where a steady motion is not found
[[nodiscard]] inline std::vector<Sweep> sweeps(const System<double>& system, Mass k, const std::vector<double>& frequencies,
                                               const std::vector<double>& betas) {
    Scene<double> scene;
    scene.system = system;
    const std::atomic<bool> stop{false};
    const RegimeMap map = regime_map(scene, {frequencies, betas, {k}, MapStart::rest, threads()}, stop);
    const ModalBasis<double> basis = modal_basis(system);
    const StuckConfiguration stuck = stuck_configuration(system, basis);
    std::vector<Sweep> all(betas.size());
    for (std::size_t b = 0; b < betas.size(); ++b) {
        all[b].beta = betas[b];
        all[b].points.resize(frequencies.size());
    }
    parallel_for(frequencies.size(), threads(), [&](std::size_t m) {
        const ModeSums<double> sums = mode_sums(basis, system.contact, system.load, frequencies[m]);
        const Boundary<double> limits = boundary(sums, scene.mu);
        for (std::size_t b = 0; b < betas.size(); ++b) {
            const MapPoint& point = map.points[m * betas.size() + b];
            const double X = map.amplitudes[m * betas.size() + b];
            if (std::isnan(X)) throw std::runtime_error("r = " + text(frequencies[m]) + ": " + name(point.status));
            SweepPoint& here = all[b].points[m] = {frequencies[m], point.regime, X, point.stops / point.periods, {}, {}};
            if (point.regime == Regime::permanent_sticking)
                here.start = held_at_maximum_of_force(stuck_response(stuck, system.load, frequencies[m]));
            if (point.regime != Regime::continuous) continue;
            const SteadyState<double> state = steady_state(sums, limits, betas[b]);
            here.mass = state.masses[k.index];
            here.start = at_maximum_of_force(sums, state);
        }
        return true;
    });
    return all;
}

/// @brief Lower end of the full turn that phases are drawn in, over the frequency ratio: it keeps their lines in one piece.
using LeastPhase = double (*)(double r);

/// @brief A phase within a full turn. @param phase radians @param least lower end of the turn @return the same direction
[[nodiscard]] inline double turned(double phase, double least) {
    const double turn = 2 * pi<double>();
    return phase - turn * std::floor((phase - least) / turn);
}

/// @brief Puts a sweep into a table: `r`, the amplitude by regime, and the phase where the contact slides; then (52) and (53).
///
/// Each part of a line reaches to the first point of the next regime, so that the parts meet.
/// @param figure       gets the table
/// @param name         its name
/// @param sweep        the sweep
/// @param least_phase  where phases are drawn
inline void add(Figure& figure, const std::string& name, const Sweep& sweep, LeastPhase least_phase) {
    const double none = std::nan("");
    Table table{
        name, {"r", "X sliding", "X in stick-slip", "X in permanent sticking", "phase", "X by (52)", "phase by (53)"}, {}};
    for (std::size_t n = 0; n < sweep.points.size(); ++n) {
        const SweepPoint& p = sweep.points[n];
        const auto next_to = [&](Regime regime) {
            return (n > 0 && sweep.points[n - 1].regime == regime) ||
                   (n + 1 < sweep.points.size() && sweep.points[n + 1].regime == regime);
        };
        const bool sticks_and_slips = p.regime == Regime::stick_slip || (next_to(Regime::stick_slip) && p.X > 0) ||
                                      (p.regime == Regime::continuous && next_to(Regime::permanent_sticking));
        table.rows.push_back({p.r, p.regime == Regime::continuous ? p.X : none, sticks_and_slips ? p.X : none,
                              p.regime == Regime::permanent_sticking && p.X > 0 ? p.X : none,
                              p.mass ? turned(p.mass->phase, least_phase(p.r)) : none,
                              p.mass ? p.mass->amplitude_monoharmonic : none,
                              p.mass ? turned(p.mass->phase_monoharmonic, least_phase(p.r)) : none});
    }
    figure.add(table);
}

/// @brief How far a marker is from its line.
struct Comparison {
    double r, beta;                         ///< the point
    Regime regime;                          ///< regime of the line
    Regime seen;                            ///< regime of the marker's last period
    double X;                               ///< amplitude of the marker
    double X_line;                          ///< amplitude of the line
    std::optional<double> phase;            ///< phase of the marker
    double amplitude_off;                   ///< amplitude less that of the line, relative to it
    std::optional<double> phase_off;        ///< phase less that of the line, radians, where both have one
    std::optional<double> amplitude_off_52; ///< amplitude less (52), relative to it, where the contact slides
    std::optional<double> phase_off_53;     ///< phase less (53), radians, where both have one
};

/// @brief The paper's algorithm at the points of sweeps.
/// @param figure       is told how far the work is
/// @param system       the system
/// @param k            the mass
/// @param sweeps       the points
/// @param on_the_line  whether to start on the steady motion in place of rest
/// @return             a comparison for every point; in stick-slip none where the start is on the steady motion
[[nodiscard]] inline std::vector<Comparison> compared(const Figure& figure, const System<double>& system, Mass k,
                                                      const std::vector<Sweep>& sweeps, bool on_the_line = false) {
    std::vector<std::pair<const SweepPoint*, double>> points;
    for (const Sweep& sweep : sweeps)
        for (const SweepPoint& p : sweep.points)
            if (p.start || !on_the_line) points.emplace_back(&p, sweep.beta);
    std::vector<Comparison> all(points.size());
    std::atomic<std::size_t> done{0};
    parallel_for(points.size(), threads(), [&](std::size_t n) {
        const auto& [p, beta] = points[n];
        PaperSettings settings;
        if (on_the_line) settings.start = *p->start;
        Scene<double> scene;
        scene.system = system;
        scene.r = p->r;
        scene.beta = beta;
        const PaperMotion motion = paper_algorithm(scene, settings);
        if (motion.status != IntegrationStatus::complete) throw std::runtime_error("r = " + text(p->r) + ": " + motion.reason);
        const PaperMassMotion& of_mass = motion.masses[k.index];
        Comparison& c =
            all[n] = {p->r, beta, p->regime, regime_seen(motion), of_mass.amplitude, p->X, of_mass.phase, 0, {}, {}, {}};
        c.amplitude_off = p->X > 0 ? of_mass.amplitude / p->X - 1 : of_mass.amplitude;
        if (p->mass) c.amplitude_off_52 = of_mass.amplitude / p->mass->amplitude_monoharmonic - 1;
        if (p->mass && of_mass.phase) {
            c.phase_off = wrapped(*of_mass.phase - p->mass->phase);
            c.phase_off_53 = wrapped(*of_mass.phase - p->mass->phase_monoharmonic);
        }
        figure.progress(++done, points.size());
        return true;
    });
    return all;
}

/// @brief Where a comparison is. @param c a comparison @return `r = .., beta = ..`
[[nodiscard]] inline std::string where(const Comparison& c) { return "r = " + text(c.r) + ", beta = " + plain(c.beta); }

/// @brief Markers of the sweeps as tables, one for every friction ratio: `r`, amplitude, phase.
///
/// Where the steady motion is none, a marker would show the place where the mass came to rest, and is left out.
/// @param figure       gets the tables
/// @param prefix       of the names; ` beta=..` follows
/// @param markers      the comparisons
/// @param betas        friction ratios
/// @param least_phase  where phases are drawn
inline void add(Figure& figure, const std::string& prefix, const std::vector<Comparison>& markers,
                const std::vector<double>& betas, LeastPhase least_phase) {
    for (const double beta : betas) {
        Table table{prefix + " beta=" + plain(beta), {"r", "X", "phase"}, {}};
        for (const Comparison& c : markers)
            if (c.beta == beta)
                table.rows.push_back(
                    {c.r, c.X_line > 0 ? c.X : std::nan(""), c.phase_off ? turned(*c.phase, least_phase(c.r)) : std::nan("")});
        figure.add(table);
    }
}

/// @brief Differences of amplitudes in a regime. @param markers comparisons @param regime the regime @return for `agreement`
[[nodiscard]] inline std::vector<std::pair<double, std::string>> amplitudes_off(const std::vector<Comparison>& markers,
                                                                                Regime regime) {
    std::vector<std::pair<double, std::string>> list;
    for (const Comparison& c : markers)
        if (c.regime == regime) list.emplace_back(c.amplitude_off, where(c));
    return list;
}

/// @brief Differences that not every comparison has.
/// @param markers     comparisons
/// @param difference  which one
/// @return            for `agreement`
[[nodiscard]] inline std::vector<std::pair<double, std::string>> differences_from(const std::vector<Comparison>& markers,
                                                                                  std::optional<double> Comparison::*difference) {
    std::vector<std::pair<double, std::string>> list;
    for (const Comparison& c : markers)
        if (c.*difference) list.emplace_back(*(c.*difference), where(c));
    return list;
}

/// @brief Differences of phases while the contact slides. @param markers comparisons @return for `agreement`
[[nodiscard]] inline std::vector<std::pair<double, std::string>> phases_off(const std::vector<Comparison>& markers) {
    return differences_from(markers, &Comparison::phase_off);
}

} // namespace denhartog::figures
