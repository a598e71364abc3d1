/// @file
/// @brief Figs. 6, 8 and 9: the response of a mass over the frequency ratio, lines and markers. Header only.
#pragma once

#include <set>

#include "peak.hpp"
#include "sweep.hpp"

namespace denhartog::figures {

/// @brief What such a figure has to show.
struct ResponseOverR {
    Mass k;                       ///< the mass
    std::vector<double> betas;    ///< friction ratios, ascending, none of them zero; the lines have zero besides
    double from, to, step;        ///< frequency ratios of the lines, closer next to resonances
    std::vector<double> marker_r; ///< frequency ratios of the markers
    LeastPhase least_phase;       ///< where phases are drawn
};

/// @brief A system at a damping ratio: its lines and markers.
struct Damped {
    double zeta;                         ///< damping ratio, as the caption counts it
    WithModes modes;                     ///< the system
    std::vector<Sweep> lines;            ///< zero friction first
    std::vector<Sweep> points;           ///< lines at the frequency ratios of the markers
    std::vector<Comparison> markers;     ///< the paper's algorithm, 200 periods from rest
    std::vector<Comparison> on_the_line; ///< the same started on the steady motion
};

/// @brief Amplitude (52) and phase (53) of a mass on the boundary (69), as a table: `r`, `X`, `phase`.
/// @param figure  gets the table
/// @param s       the system
/// @param shown   mass and lowest phase
/// @param r       frequency ratios
/// @param name    name of the table
inline void add_boundary(Figure& figure, const WithModes& s, const ResponseOverR& shown, const std::vector<double>& r,
                         const std::string& name) {
    Table table{name, {"r", "X", "phase"}, {}};
    for (const double each : r) {
        const ModeSums<double> sums = s.at(each);
        const Boundary<double> limits = boundary(sums, 1.0);
        const MassResponse<double> mass = steady_state(sums, limits, std::nextafter(limits.exact, 0.0)).masses[shown.k.index];
        table.rows.push_back({each, mass.amplitude_monoharmonic, turned(mass.phase_monoharmonic, shown.least_phase(each))});
    }
    figure.add(table);
}

/// @brief Computes a system's lines and markers, and adds them to the figure.
///
/// Tables: `zeta=.. beta=..`, `markers zeta=.. beta=..`, `boundary zeta=..`.
/// @param figure  the figure
/// @param shown   what it shows
/// @param zeta    damping ratio, as the caption counts it
/// @param system  the system
/// @return        its lines and markers
[[nodiscard]] inline Damped damped(Figure& figure, const ResponseOverR& shown, double zeta, const System<double>& system) {
    Damped d{zeta, WithModes(system), {}, {}, {}, {}};
    std::vector<std::pair<double, double>> resonances;
    for (std::size_t i = 0; i < d.modes.basis.r_n.size(); ++i)
        resonances.emplace_back(d.modes.basis.r_n[i], d.modes.basis.zeta[i]);
    const std::vector<double> r = frequencies(shown.from, shown.to, shown.step, resonances);
    std::vector<double> betas{0};
    betas.insert(betas.end(), shown.betas.begin(), shown.betas.end());
    d.lines = sweeps(system, shown.k, r, betas);
    d.points = sweeps(system, shown.k, shown.marker_r, shown.betas);
    d.markers = compared(figure, system, shown.k, d.points);
    d.on_the_line = compared(figure, system, shown.k, d.points, true);
    const std::string of = "zeta=" + plain(zeta);
    for (const Sweep& line : d.lines) add(figure, of + " beta=" + plain(line.beta), line, shown.least_phase);
    add(figure, "markers " + of, d.markers, shown.betas, shown.least_phase);
    add_boundary(figure, d.modes, shown, r, "boundary " + of);
    return d;
}

/// @brief The largest of differences, for a sentence. @param list differences, as for `agreement` @return e.g. `1.2e-06`
[[nodiscard]] inline std::string largest(const std::vector<std::pair<double, std::string>>& list) {
    return text(agreement("", list).worst, "%.2g");
}

/// @brief Markers against lines in the record, with the statement on their agreement.
/// @param record      gets agreements and statements
/// @param d           lines and markers
/// @param in_contact  whether the mass is the one in contact, whose (52) and (53) are exact
inline void compare(Record& record, const Damped& d, bool in_contact) {
    const std::string of = "zeta = " + plain(d.zeta) + ", ";
    const auto off_52 = differences_from(d.markers, &Comparison::amplitude_off_52);
    const auto off_53 = differences_from(d.markers, &Comparison::phase_off_53);
    record.agreements.push_back(agreement(of + "amplitude while the contact slides, relative to (52)", off_52));
    record.agreements.push_back(agreement(of + "phase while the contact slides, radians from (53)", off_53));
    if (!in_contact) {
        record.agreements.push_back(
            agreement(of + "amplitude while the contact slides, relative to the largest displacement by (46)",
                      amplitudes_off(d.markers, Regime::continuous)));
        record.agreements.push_back(
            agreement(of + "phase while the contact slides, radians from that instant", phases_off(d.markers)));
    }
    record.agreements.push_back(
        agreement(of + "amplitude in stick-slip, relative to the exact solver", amplitudes_off(d.markers, Regime::stick_slip)));
    const auto started = amplitudes_off(d.on_the_line, Regime::continuous);
    record.agreements.push_back(
        agreement(of + "amplitude while the contact slides, the algorithm started on the steady motion", started));
    if (!in_contact) {
        record.agreements.push_back(agreement(of + "amplitude while the contact rests, relative to the stuck configuration",
                                              amplitudes_off(d.markers, Regime::permanent_sticking)));
        record.agreements.push_back(agreement(of + "the same, the algorithm started on it with the contact at zero",
                                              amplitudes_off(d.on_the_line, Regime::permanent_sticking)));
    }
    const double asked = 0.01;
    const auto within = [&](const std::vector<std::pair<double, std::string>>& list) {
        return std::ranges::count_if(list, [&](const auto& each) { return std::abs(each.first) < asked; });
    };
    const auto all = std::ssize(off_52) + std::ssize(off_53), close = within(off_52) + within(off_53);
    record.statements.push_back({"Closed-form and numerical amplitudes and phases agree very well; here zeta = " + plain(d.zeta),
                                 std::to_string(close) + " of " + std::to_string(all) + " within 1 % and 0.01 rad; at most " +
                                     largest(off_52) + " relative and " + largest(off_53) + " rad off",
                                 close == all, "to 1 percent and 0.01 rad"});
    std::set<double> unsteady;
    for (const Comparison& c : d.markers)
        if (c.regime == Regime::continuous && std::abs(c.amplitude_off) >= asked) unsteady.insert(c.r);
    if (unsteady.empty()) return; // what is off is (52)
    std::string at;
    for (const double r : unsteady) at += (at.empty() ? "" : ", ") + text(r);
    record.remarks.push_back(of + "200 periods from rest do not lead within 1 % of the steady amplitude at r = " + at +
                             "; started on the steady motion the algorithm stays within " + largest(started) +
                             " of it at every r");
}

/// @brief The statement that the regimes are where the boundaries have them.
/// @param all  systems with their markers
/// @return     the statement; borne out where 99 markers in 100 are as predicted, and every motion started so stays so
[[nodiscard]] inline Statement regimes_as_predicted(const std::vector<Damped>& all) {
    std::size_t points = 0, same = 0, stay = 0, leave = 0;
    std::vector<std::size_t> seen(3, 0);
    std::string others;
    for (const Damped& d : all) {
        for (const Comparison& c : d.markers) {
            ++points;
            ++seen[static_cast<std::size_t>(c.seen)];
            if (c.seen == c.regime)
                ++same;
            else
                others += (others.empty() ? "zeta = " : "; zeta = ") + plain(d.zeta) + ", " + where(c);
        }
        for (const Comparison& c : d.on_the_line) ++(c.seen == c.regime ? stay : leave);
    }
    return {"Continuous, stick-slip and permanently sticking motions occur in the numerical response where the boundaries "
            "predict them",
            std::to_string(same) + " of " + std::to_string(points) + " markers (" + std::to_string(seen[0]) + " slide, " +
                std::to_string(seen[1]) + " stick and slip, " + std::to_string(seen[2]) + " rest)" +
                (others.empty() ? "" : ", not yet after 200 periods at " + others) + "; of " + std::to_string(stay + leave) +
                " motions started as predicted, sliding or resting, " + std::to_string(stay) + " stay so",
            100 * same >= 99 * points && leave == 0, leave == 0 ? "at 99 of 100 points" : ""};
}

} // namespace denhartog::figures
