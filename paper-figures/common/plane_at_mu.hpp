/// @file
/// @brief The plane of frequency and friction ratio where static friction exceeds kinetic friction, and more than one motion can
/// be steady. Header only.
#pragma once

#include "denhartog/formulas/high_frequency.hpp"
#include "regimes.hpp"
#include "sweep.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures {

/// @brief Friction ratios at which the motion changes by the paper's algorithm, for three starts.
struct SeenFromStarts {
    double r;            ///< frequency ratio
    double from_sliding; ///< end of sliding, started on the closed form
    double from_rest;    ///< end of sliding, started at rest
    double held;         ///< end of slipping within a period, started on the stuck motion
};

/// @brief The plane of a system at one mu.
struct PlaneAtMu {
    std::string of;                   ///< name of the system
    double mu;                        ///< static over kinetic friction
    System<double> system;            ///< the system
    ModalBasis<double> basis;         ///< its modes
    StuckConfiguration stuck;         ///< its stuck configuration
    std::vector<SeenFromStarts> seen; ///< boundaries by the paper's algorithm
    std::vector<RegimeCheck> checks;  ///< regimes on a grid by the paper's algorithm, from rest

    /// @brief Modes and sums. @param r frequency ratio @return the sums
    [[nodiscard]] ModeSums<double> sums(double r) const { return mode_sums(basis, system.contact, system.load, r); }
    /// @brief Boundaries. @param r frequency ratio @return the boundaries
    [[nodiscard]] Boundary<double> at(double r) const { return boundary(sums(r), mu); }
    /// @brief Begin of permanent sticking. @param r frequency ratio @return the friction ratio
    [[nodiscard]] double sticking(double r) const { return at(r).sticking.value(); }
    /// @brief Whether the load acts on the contact. @return true where it does
    [[nodiscard]] bool loaded_contact() const { return system.contact.index == system.load.index; }
};

/// @brief The motion by the paper's algorithm.
/// @param p the plane @param r frequency ratio @param beta friction ratio @param settings of the algorithm @return the motion
[[nodiscard]] inline PaperMotion motion_at(const PlaneAtMu& p, double r, double beta, const PaperSettings& settings) {
    Scene<double> scene;
    scene.system = p.system;
    scene.mu = p.mu;
    scene.r = r;
    scene.beta = beta;
    PaperMotion motion = paper_algorithm(scene, settings);
    if (motion.status != IntegrationStatus::complete) throw std::runtime_error("r = " + text(r) + ": " + motion.reason);
    return motion;
}

/// @brief Looks for the boundaries with the paper's algorithm. @param p the plane @param r frequency ratio @return the boundaries
[[nodiscard]] inline SeenFromStarts seen_at(const PlaneAtMu& p, double r) {
    const int halvings = 16;
    const ModeSums<double> sums = p.sums(r);
    const State held = held_at_maximum_of_force(stuck_response(p.stuck, p.system.load, r));
    const auto slides_on = [&](double beta) {
        PaperSettings settings;
        settings.start = on_closed_form(sums, p.mu, beta);
        return motion_at(p, r, beta, settings).slides;
    };
    const auto slides_from_rest = [&](double beta) { return motion_at(p, r, beta, {}).slides; };
    const auto slips = [&](double beta) {
        PaperSettings settings;
        settings.start = held;
        settings.cycles = 1;
        return !motion_at(p, r, beta, settings).rests;
    };
    return {r, halved(slides_on, halvings), halved(slides_from_rest, halvings), halved(slips, halvings)};
}

/// @brief Computes a plane; tables `NAME mu=..`, `wide NAME mu=..`, `numerical NAME mu=..`.
/// @param figure gets the tables @param of system and name @param mu static over kinetic friction @return the plane
[[nodiscard]] inline PlaneAtMu plane_at_mu(Figure& figure, const NamedSystem<double>& of, double mu) {
    const ModalBasis<double> basis = modal_basis(of.system);
    PlaneAtMu p{of.name, mu, of.system, basis, stuck_configuration(of.system, basis), {}, {}};
    const std::string name = of.name + " mu=" + text(mu);
    add(figure, name, regime_curves(p.system, mu, spaced(0.01, 3, 500)));
    add(figure, "wide " + name, regime_curves(p.system, mu, spaced_in_octaves(0.02, 30, 500)));

    std::vector<std::pair<double, double>> grid;
    for (int n = 1; n <= 14; ++n)
        for (int m = 0; m < 13; ++m) grid.emplace_back(n / 5.0, (7 + 10 * m) / 100.0);
    p.seen.resize(14);
    parallel_for(p.seen.size(), threads(), [&](std::size_t n) {
        p.seen[n] = seen_at(p, static_cast<double>(n + 1) / 5);
        return true;
    });
    p.checks = checked_regimes(figure, p.system, mu, grid);
    Table table{"numerical " + name, {"r", "from the closed form", "from rest", "from the stuck motion"}, {}};
    for (const SeenFromStarts& s : p.seen) table.rows.push_back({s.r, s.from_sliding, s.from_rest, s.held});
    figure.add(table);
    return p;
}

/// @brief What (69) falls like for r -> 0; the static displacement is that at a low frequency.
/// @param p the plane @param r frequency ratio @return the friction ratio
[[nodiscard]] inline double at_low_frequency(const PlaneAtMu& p, double r) {
    const std::size_t j = p.system.contact.index;
    return paper::friction_ratio_limit_at_low_frequency(p.sums(1e-4).V[j].re, p.system.mass_ratios[j], r, p.mu);
}

/// @brief Adds what (69) falls like at low frequencies, and tends to at high ones: `limits NAME mu=..`.
/// @param figure gets the table @param p the plane
inline void add_limits(Figure& figure, const PlaneAtMu& p) {
    const double limit = paper::friction_ratio_limit_at_high_frequency(p.mu), none = std::nan("");
    Table table{"limits " + p.of + " mu=" + text(p.mu), {"r", "r -> 0", "(86)"}, {}};
    for (const double r : {0.02, 0.2}) table.rows.push_back({r, at_low_frequency(p, r), none});
    for (const double r : {1.0, 30.0}) table.rows.push_back({r, none, p.loaded_contact() ? limit : none});
    figure.add(table);
}

/// @brief A function for planes as text. @param planes the planes @param f the function @return e.g. `0.5, 0.4`
[[nodiscard]] inline std::string for_each_mu(const std::vector<PlaneAtMu>& planes,
                                             const std::function<double(const PlaneAtMu&)>& f) {
    std::string line;
    for (const PlaneAtMu& p : planes) line += (line.empty() ? "" : ", ") + text(f(p), "%.3g");
    return line;
}

/// @brief Where a point is. @param p the plane @param r frequency ratio @return `mu = .., r = ..`
[[nodiscard]] inline std::string where(const PlaneAtMu& p, double r) { return "mu = " + text(p.mu) + ", r = " + text(r); }

/// @brief The boundaries of a system by the paper's algorithm against the closed form. @param planes the planes @return three
[[nodiscard]] inline std::vector<Agreement> agreements(const std::vector<PlaneAtMu>& planes) {
    std::vector<std::pair<double, std::string>> sliding, rest, held;
    for (const PlaneAtMu& p : planes)
        for (const SeenFromStarts& s : p.seen) {
            const Boundary<double> limits = p.at(s.r);
            const double lower = p.loaded_contact() ? std::min(limits.exact, *limits.sticking) : limits.exact;
            sliding.emplace_back(s.from_sliding / limits.exact - 1, where(p, s.r));
            rest.emplace_back(s.from_rest / lower - 1, where(p, s.r));
            held.emplace_back(s.held / *limits.sticking - 1, where(p, s.r));
        }
    const std::string& of = planes.front().of;
    return {agreement(of + ": end of sliding, started on the closed form, relative to (69)", sliding),
            agreement(of + ": end of sliding, from rest, relative to " +
                          (planes.front().loaded_contact() ? "the lower of (69) and permanent sticking" : "(69)"),
                      rest),
            agreement(of + ": end of slipping, started on the stuck motion, relative to the begin of permanent sticking", held)};
}

} // namespace denhartog::figures
