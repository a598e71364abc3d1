/// @file
/// @brief Time responses of the chain of five masses at r = 0.9, beta = 0.2, mu = 1: what Figs. 4 and 5 share. Header only.
#pragma once

#include <algorithm>
#include <cmath>

#include "denhartog/sliding/steady_state.hpp"
#include "markers.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures {

/// @brief A panel of Fig. 4 or 5: closed form and last period of the paper's algorithm.
struct TimeResponse {
    std::string panel;         ///< `a` or `b`
    double zeta;               ///< damping ratio of every mode
    ModeSums<double> sums;     ///< modes at r
    SteadyState<double> state; ///< the closed form
    PaperMotion numerical;     ///< last period by the paper's algorithm, with samples and history
};

/// @brief Angle in degrees. @param radians the angle @return degrees
[[nodiscard]] inline double degrees(double radians) { return radians * 180 / pi<double>(); }

/// @brief How far two masses are from moving in phase or in phase-opposition. @param a phase @param b phase @return degrees
[[nodiscard]] inline double from_line(double a, double b) { return degrees(std::abs(wrapped(2 * (a - b))) / 2); }

/// @brief Computes both panels and puts their curves, markers and labels of curves into tables.
/// @param figure  gets the tables
/// @param j       the mass in contact, from 1
/// @return        the panels, zeta = 0.01 and 0.1
[[nodiscard]] inline std::vector<TimeResponse> time_responses(Figure& figure, std::size_t j) {
    const double r = 0.9, beta = 0.2, mu = 1;
    PaperSettings settings;
    settings.samples = 40;
    settings.history = true;
    std::vector<TimeResponse> panels;
    for (const double zeta : {0.01, 0.1}) {
        const System<double> system = five_masses(j, zeta);
        const ModeSums<double> sums = mode_sums(modal_basis(system), system.contact, system.load, r);
        const SteadyState<double> state = steady_state(sums, boundary(sums, mu), beta);
        const PaperMotion numerical = markers(figure, system, mu, {{r, beta}}, settings).front().motion;
        panels.push_back({panels.empty() ? "a" : "b", zeta, sums, state, numerical});
    }
    for (const TimeResponse& p : panels) {
        const std::vector<std::string> columns{"tau over pi", "x1", "x2", "x3", "x4", "x5"};
        Table lines{"lines " + p.panel, columns, {}}, dots{"markers " + p.panel, columns, {}};
        for (const double part : spaced(0, 2, 401)) {
            lines.rows.push_back({part});
            const std::vector<double> x = motion(p.sums, p.state, part * pi<double>() - p.state.phi_j).x;
            lines.rows.back().insert(lines.rows.back().end(), x.begin(), x.end());
        }
        for (std::size_t n = 0; n < p.numerical.samples.size(); ++n) {
            dots.rows.push_back({p.numerical.sample_times[n] / pi<double>()});
            const std::vector<double>& x = p.numerical.samples[n].x;
            dots.rows.back().insert(dots.rows.back().end(), x.begin(), x.end());
        }
        figure.add(lines);
        figure.add(dots);
    }
    return panels;
}

/// @brief How far the markers are from the lines, panel by panel.
/// @param panels  the panels
/// @return        displacements over a period and amplitudes, both over the amplitude of the mass; phases in radians
[[nodiscard]] inline std::vector<Agreement> agreements(const std::vector<TimeResponse>& panels) {
    std::vector<Agreement> all;
    for (const TimeResponse& p : panels) {
        std::vector<std::pair<double, std::string>> displacements, amplitudes, phases;
        for (std::size_t k = 0; k < p.state.masses.size(); ++k) {
            const std::string mass = "mass " + std::to_string(k + 1);
            const double X = p.state.masses[k].amplitude;
            const PaperMassMotion& of_mass = p.numerical.masses[k];
            amplitudes.emplace_back(of_mass.amplitude / X - 1, mass);
            phases.emplace_back(wrapped(of_mass.phase.value() - p.state.masses[k].phase), mass);
            for (std::size_t n = 0; n < p.numerical.samples.size(); ++n) {
                const double tau = p.numerical.sample_times[n];
                const double x = motion(p.sums, p.state, tau - p.state.phi_j).x[k];
                displacements.emplace_back((p.numerical.samples[n].x[k] - x) / X,
                                           mass + ", tau = " + text(tau / pi<double>()) + " pi");
            }
        }
        const std::string panel = "(" + p.panel + ") ";
        all.push_back(agreement(panel + "displacements, over the amplitude of the mass", displacements));
        all.push_back(agreement(panel + "amplitudes of the masses, relative", amplitudes));
        all.push_back(agreement(panel + "phases of the masses, radians", phases));
    }
    return all;
}

/// @brief The text on the agreement of Figs. 4 and 5: excellent; here to 1 percent of the amplitude.
/// @param panels  the panels
/// @return        the statement
[[nodiscard]] inline Statement excellent_agreement(const std::vector<TimeResponse>& panels) {
    Statement s{"Numerical and analytical time responses agree excellently; here: to 1 percent of the amplitude of each mass", "",
                true, "to 1 percent"};
    const std::vector<Agreement> all = agreements(panels);
    for (std::size_t p = 0; p < panels.size(); ++p) {
        const Agreement& displacements = all[3 * p];
        const double percent = 100 * displacements.worst;
        s.found += std::string(p == 0 ? "" : "; ") + "(" + panels[p].panel + ") largest difference " +
                   (percent < 0.001 ? "below 0.001 percent" : text(percent, "%.2g") + " percent, " + displacements.where);
        s.borne_out = s.borne_out && displacements.worst < 0.01;
    }
    return s;
}

/// @brief The text on the number of periods: most motions are steady long before 200; here: the contact's amplitude within 1
/// percent of the closed form after 100.
/// @param panels  the panels
/// @return        the statement
[[nodiscard]] inline Statement steady_early(const std::vector<TimeResponse>& panels) {
    Statement s{"Most motions are steady long before 200 periods; here: amplitude of the contact within 1 percent after 100", "",
                true, "after 100 periods"};
    for (std::size_t p = 0; p < panels.size(); ++p) {
        std::size_t last = 0;
        const std::vector<ContactPeriod>& history = panels[p].numerical.history;
        for (std::size_t n = 0; n < history.size(); ++n)
            if (std::abs(history[n].amplitude / panels[p].state.X_j - 1) > 0.01) last = n + 1;
        s.found += std::string(p == 0 ? "" : ", ") + "(" + panels[p].panel + ") after " + std::to_string(last) + " periods";
        s.borne_out = s.borne_out && last <= 100;
    }
    return s;
}

/// @brief The largest departure of masses from moving in phase or in phase-opposition with the contact.
struct Departure {
    double degrees;   ///< how far
    std::size_t mass; ///< which mass, from 1
};

/// @brief The largest departure of some masses. @param p a panel @param from first mass @param to last mass @return the largest
[[nodiscard]] inline Departure largest_departure(const TimeResponse& p, std::size_t from, std::size_t to) {
    Departure largest{0, from};
    for (std::size_t k = from; k <= to; ++k) {
        const double here = from_line(p.state.masses[k - 1].phase, p.state.phi_j);
        if (here > largest.degrees) largest = {here, k};
    }
    return largest;
}

/// @brief The text on Figs. 4b and 5b: every mass has a phase of its own; here: no two are within 15 degrees.
/// @param p  panel b
/// @return   the statement
[[nodiscard]] inline Statement every_phase_differs(const TimeResponse& p) {
    double nearest = 180;
    std::string pair;
    for (std::size_t a = 0; a < p.state.masses.size(); ++a)
        for (std::size_t b = a + 1; b < p.state.masses.size(); ++b) {
            const double apart = degrees(std::abs(wrapped(p.state.masses[a].phase - p.state.masses[b].phase)));
            if (apart < nearest) nearest = apart, pair = std::to_string(a + 1) + " and " + std::to_string(b + 1);
        }
    return {"With modal damping ratios of 0.1 each mass has a phase of its own; here: no two phases within 15 degrees",
            "nearest are masses " + pair + ", " + text(nearest, "%.3g") + " degrees apart", nearest >= 15, "by 15 degrees"};
}

/// @brief The text on damping: the change of the phases matters only where damping is significant; here: at 0.1 above 15 degrees,
/// at 0.01 below.
/// @param a  panel a
/// @param b  panel b
/// @param from  first mass that would be in phase or in phase-opposition with the contact without damping
/// @return   the statement
[[nodiscard]] inline Statement damping_matters_late(const TimeResponse& a, const TimeResponse& b, std::size_t from) {
    const Departure light = largest_departure(a, from, 5), heavy = largest_departure(b, from, 5);
    return {"Damping alters the phases between the masses, to an extent that matters only where it is significant; here: by more "
            "than 15 degrees at 0.1, by less at 0.01",
            "from phase or phase-opposition with the contact at the most " + text(light.degrees, "%.3g") + " degrees (mass " +
                std::to_string(light.mass) + ") at 0.01 and " + text(heavy.degrees, "%.3g") + " (mass " +
                std::to_string(heavy.mass) + ") at 0.1",
            light.degrees < 15 && heavy.degrees > 15, "by 15 degrees"};
}

/// @brief Phases of the masses behind the contact as a remark. @param p a panel @return e.g. `(a) .. 0, 179, ..`
[[nodiscard]] inline std::string phases_behind_contact(const TimeResponse& p) {
    std::string line;
    for (const MassResponse<double>& mass : p.state.masses)
        line += (line.empty() ? "" : ", ") + text(degrees(wrapped(mass.phase - p.state.phi_j)), "%.1f");
    return "(" + p.panel + ") degrees behind the contact, masses 1 to 5: " + line + ".";
}

/// @brief The half of the record that Figs. 4 and 5 share.
/// @param panels  the panels
/// @param j       the mass in contact, from 1
/// @return        title, equations, parameters, agreements, the remarks on phases
[[nodiscard]] inline Record record_of(const std::vector<TimeResponse>& panels, std::size_t j) {
    Record record;
    record.title = "Steady time response of five masses, contact on mass " + std::to_string(j) + ", load on mass 1";
    record.equations = {"46", "6", "74", "75"};
    record.given = {"5DOF, equal masses and springs, j = " + std::to_string(j) + ", l = 1, mu = 1, beta = 0.2, r = 0.9",
                    "modal damping ratios 0.01 (a) and 0.1 (b), the same for all modes",
                    "200 periods from rest, absolute tolerance 1e-6"};
    record.chosen = {"the last period, tau = 0 at a maximum of the force", "40 markers a period"};
    record.agreements = agreements(panels);
    record.remarks = {"The line is (46) as corrected.", phases_behind_contact(panels[0]), phases_behind_contact(panels[1])};
    return record;
}

} // namespace denhartog::figures
