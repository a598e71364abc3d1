/// @file
/// @brief The regimes of motion in the plane of frequency and friction ratio: boundaries, and where the paper's algorithm has
/// them. Header only.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <optional>

#include "denhartog/map/regime_map.hpp"
#include "denhartog/number/parallel.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "markers.hpp"
#include "peak.hpp"

namespace denhartog::figures {

/// @brief Boundaries over the frequency ratio.
struct RegimeCurves {
    std::vector<double> r;             ///< frequency ratios, ascending
    std::vector<BoundaryPoint> points; ///< boundaries there
};

/// @brief Frequency ratios that boundaries are drawn at: closer to each other next to resonances of the system, of its parts
/// while the contact rests, and next to the first fractions of the former, where the boundary has its waves.
/// @param system  the system
/// @param from    least, positive
/// @param to      largest
/// @param step    between them elsewhere
/// @return        frequency ratios, ascending
[[nodiscard]] inline std::vector<double> frequencies_for_boundaries(const System<double>& system, double from, double to,
                                                                    double step) {
    const ModalBasis<double> basis = modal_basis(system);
    const StuckConfiguration stuck = stuck_configuration(system, basis);
    std::vector<double> all = spaced(from, to, static_cast<std::size_t>(std::lround((to - from) / step)) + 1);
    const auto closer_to = [&](double r_n, double width) {
        all.push_back(r_n);
        for (const double distance : spaced_in_octaves(std::max(width, 1e-5) * r_n / 16, 4 * step, 20)) {
            all.push_back(r_n - distance);
            all.push_back(r_n + distance);
        }
    };
    for (std::size_t i = 0; i < basis.r_n.size(); ++i)
        for (int n = 1; n <= 5; ++n) closer_to(basis.r_n[i] / n, basis.zeta[i] * n);
    for (std::size_t i = 0; i < stuck.r_n.size(); ++i) {
        const Eigen::Index n = static_cast<Eigen::Index>(i);
        closer_to(stuck.r_n[i], stuck.damping(n, n) / (2 * stuck.r_n[i]));
    }
    std::erase_if(all, [&](double r) { return r < from || r > to; });
    std::ranges::sort(all);
    return all;
}

/// @brief Boundaries of the regimes. @param system the system @param mu static over kinetic friction @param r frequency ratios
/// @return the curves
[[nodiscard]] inline RegimeCurves regime_curves(const System<double>& system, double mu, const std::vector<double>& r) {
    Scene<double> scene;
    scene.system = system;
    scene.mu = mu;
    return {r, boundary_curves(scene, r)};
}

/// @brief Boundaries at one frequency ratio. @param system the system @param mu static over kinetic friction @param r frequency
/// ratio @return the boundaries @throws std::runtime_error where there are none
[[nodiscard]] inline BoundaryPoint boundaries_at(const System<double>& system, double mu, double r) {
    const BoundaryPoint point = regime_curves(system, mu, {r}).points.front();
    if (point.status != PointStatus::answered) throw std::runtime_error("r = " + text(r) + ": " + name(point.status));
    return point;
}

/// @brief Puts boundaries into a table: `r`, (69) as the paper has it, exact, (67), permanent sticking.
/// @param figure  gets the table
/// @param name    its name
/// @param curves  the boundaries; a gap where there is none
inline void add(Figure& figure, const std::string& name, const RegimeCurves& curves) {
    Table table{name, {"r", "(69)", "exact", "(67)", "sticking"}, {}};
    const double none = std::nan("");
    for (std::size_t n = 0; n < curves.r.size(); ++n) {
        const BoundaryPoint& p = curves.points[n];
        const bool answered = p.status == PointStatus::answered;
        table.rows.push_back({curves.r[n], answered ? p.paper : none, answered ? p.exact : none, answered ? p.approximate : none,
                              answered && p.sticking ? *p.sticking : none});
    }
    figure.add(table);
}

/// @brief Whether the contact creeps one way over the last period.
///
/// A contact that comes to rest where it just cannot stay slips back by less and less in every period, without end. It moves one
/// way then, and never returns: that is not a steady motion with stick-slip, but the way to permanent sticking.
/// @param motion   the motion, with samples
/// @param contact  the mass in contact
/// @return         true where the displacement over the period is more than half of the way to and fro
[[nodiscard]] inline bool creeps(const PaperMotion& motion, Mass contact) {
    const double first = motion.samples.at(0).x[contact.index];
    double least = first, largest = first;
    for (const State& state : motion.samples) {
        least = std::min(least, state.x[contact.index]);
        largest = std::max(largest, state.x[contact.index]);
    }
    return std::abs(motion.end.x[contact.index] - first) > (largest - least) / 2;
}

/// @brief Friction ratios at which the regimes change by the paper's algorithm.
struct SeenBoundaries {
    double r;        ///< frequency ratio
    double sliding;  ///< end of sliding throughout
    double sticking; ///< begin of permanent sticking, from where it rests or creeps
};

/// @brief Settings of the algorithm at a friction ratio, given what (r, beta) is.
using SettingsAt = std::function<PaperSettings(double r, double beta)>;

/// @brief The closed form at a friction ratio, or next to the boundary where there is none.
/// @param sums modes at the frequency ratio @param mu static over kinetic friction @param beta friction ratio @return the state
[[nodiscard]] inline State on_closed_form(const ModeSums<double>& sums, double mu, double beta) {
    const Boundary<double> limits = boundary(sums, mu);
    return at_maximum_of_force(sums, steady_state(sums, limits, std::min(beta, 0.9999 * limits.exact)));
}

/// @brief Settings that start the paper's algorithm on the closed form.
/// @param s   a system
/// @param mu  static over kinetic friction
/// @return    the settings
[[nodiscard]] inline SettingsAt from_sliding(const WithModes& s, double mu) {
    return [&s, mu](double r, double beta) {
        PaperSettings settings;
        settings.start = on_closed_form(s.at(r), mu, beta);
        return settings;
    };
}

/// @brief The middle of the interval in which a regime ends, after doubling its upper end from 1 and halving.
/// @param is_below  whether a friction ratio is below the boundary
/// @param halvings  how often the interval is halved
/// @return          the friction ratio
[[nodiscard]] inline double halved(const std::function<bool(double beta)>& is_below, int halvings) {
    double low = 0, high = 1;
    while (is_below(high) && high < 1e6) low = high, high *= 2;
    for (int n = 0; n < halvings; ++n) {
        const double beta = (low + high) / 2;
        (is_below(beta) ? low : high) = beta;
    }
    return (low + high) / 2;
}

/// @brief Looks for the boundaries with the paper's algorithm, without knowing those of the closed form.
/// @param figure    is told how far the work is
/// @param system    the system
/// @param mu        static over kinetic friction
/// @param r         frequency ratios
/// @param settings  of the algorithm, start included
/// @return          the boundaries at each r
[[nodiscard]] inline std::vector<SeenBoundaries> seen_boundaries(const Figure& figure, const System<double>& system, double mu,
                                                                 const std::vector<double>& r, const SettingsAt& settings) {
    const int halvings = 16;
    std::vector<SeenBoundaries> all(r.size());
    std::atomic<std::size_t> done{0};
    parallel_for(r.size(), threads(), [&](std::size_t n) {
        Scene<double> scene;
        scene.system = system;
        scene.mu = mu;
        scene.r = r[n];
        const auto motion_at = [&](double beta) {
            scene.beta = beta;
            PaperSettings here = settings(r[n], beta);
            here.samples = 64;
            PaperMotion motion = paper_algorithm(scene, here);
            if (motion.status != IntegrationStatus::complete)
                throw std::runtime_error("r = " + text(r[n]) + ": " + motion.reason);
            return motion;
        };
        const auto slides = [&](double beta) { return regime_seen(motion_at(beta)) == Regime::continuous; };
        const auto moves = [&](double beta) {
            const PaperMotion motion = motion_at(beta);
            return !motion.rests && !creeps(motion, system.contact);
        };
        all[n] = {r[n], halved(slides, halvings), halved(moves, halvings)};
        figure.progress(++done, r.size());
        return true;
    });
    return all;
}

/// @brief A point with the regime that the boundaries predict, the paper's algorithm sees, and the exact solver finds.
struct RegimeCheck {
    double r, beta;              ///< the point
    Regime predicted;            ///< by the boundaries
    Regime seen;                 ///< in the last period of the paper's algorithm
    bool creeps;                 ///< whether it creeps to its rest there
    std::optional<Regime> exact; ///< of the periodic orbit from rest; asked for where the two differ, none where it is not found
};

/// @brief The regime of the periodic orbit that the start from rest leads to.
/// @param system  the system
/// @param mu      static over kinetic friction
/// @param r       frequency ratio
/// @param beta    friction ratio
/// @return        the regime; none where no orbit is found
[[nodiscard]] inline std::optional<Regime> regime_of_orbit(const System<double>& system, double mu, double r, double beta) {
    const ContactSystem contact = contact_system(system);
    ExactSolver solver(contact, {r, beta, mu});
    const PeriodicOrbit orbit = periodic_orbit(solver, at_rest(number_of_masses(system)));
    if (orbit.status == OrbitStatus::not_converged) return std::nullopt;
    if (orbit.status == OrbitStatus::permanently_stuck) return Regime::permanent_sticking;
    return orbit.stops.empty() ? Regime::continuous : Regime::stick_slip;
}

/// @brief Compares the regimes at points; boundaries are those of (69) with the maximum over the sum, and of permanent sticking.
/// @param figure    is told how far the work is
/// @param system    the system
/// @param mu        static over kinetic friction
/// @param points    pairs of frequency ratio and friction ratio
/// @return          a check for every point
[[nodiscard]] inline std::vector<RegimeCheck> checked_regimes(const Figure& figure, const System<double>& system, double mu,
                                                              const std::vector<std::pair<double, double>>& points) {
    PaperSettings settings;
    settings.samples = 64;
    std::vector<RegimeCheck> all;
    const ModalBasis<double> basis = modal_basis(system);
    for (const Marker& m : markers(figure, system, mu, points, settings)) {
        const Regime predicted = regime_of(boundary(mode_sums(basis, system.contact, system.load, m.r), mu), m.beta);
        const Regime seen = regime_seen(m.motion);
        all.push_back({m.r, m.beta, predicted, seen, creeps(m.motion, system.contact), std::nullopt});
        if (all.back().seen != predicted) all.back().exact = regime_of_orbit(system, mu, m.r, m.beta);
    }
    return all;
}

/// @brief Puts the points of each regime, as the paper's algorithm sees it, into tables `PREFIX continuous;` and so on.
/// @param figure  gets the tables
/// @param prefix  of their names
/// @param checks  the points
inline void add(Figure& figure, const std::string& prefix, const std::vector<RegimeCheck>& checks) {
    for (const Regime regime : {Regime::continuous, Regime::stick_slip, Regime::permanent_sticking}) {
        Table table{prefix + " " + name(regime), {"r", "beta"}, {}};
        for (const RegimeCheck& c : checks)
            if (c.seen == regime) table.rows.push_back({c.r, c.beta});
        figure.add(table);
    }
}

/// @brief Puts boundaries by the paper's algorithm into a table: `r`, end of sliding, begin of permanent sticking.
/// @param figure  gets the table
/// @param name    its name
/// @param seen    the boundaries
inline void add(Figure& figure, const std::string& name, const std::vector<SeenBoundaries>& seen) {
    Table table{name, {"r", "sliding", "sticking"}, {}};
    for (const SeenBoundaries& s : seen) table.rows.push_back({s.r, s.sliding, s.sticking});
    figure.add(table);
}

} // namespace denhartog::figures
