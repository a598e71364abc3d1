// (56), (57), (59), (68), (70), (88) as printed and as corrected: boundaries of the regimes over the frequency ratio.
#include "boundary_witness.hpp"
#include "denhartog/evaluation/mass.hpp"
#include "denhartog/formulas/as_printed.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::printed_against_corrected_boundary {

/// (69) of a single mass with (57) as printed, its maximum taken over a number of instants.
double limit_by_57_as_printed(const ModeSums<double>& m, int instants) {
    double largest = -INFINITY;
    for (int n = 1; n <= instants; ++n)
        largest =
            std::max(largest, as_printed::s_d_integrand(pi<double>() * n / (instants + 1), m.R[0], m.zeta[0], m.u[0], m.g[0]));
    return limit_with(m, m.sum_of_squares * largest, 1);
}

/// (67) of a single mass, mu = 1, with (72) from (70) as printed, for tau -> 0.
double limit_by_70_as_printed(const ModeSums<double>& m) {
    const double tau = 1e-6, s_d = as_printed::s_d_expansion(tau, m.R[0], m.zeta[0], m.u[0], m.g[0]);
    return paper::friction_ratio_limit(m.V[0], m.U[0], m.sum_of_squares * s_d);
}

/// Whether every mode of a chain of equal masses meets (63).
bool every_mode_meets_63(const ModeSums<double>& m, double mu, double beta) {
    const std::size_t j = m.contact.index;
    std::vector<double> eta(m.R.size());
    for (std::size_t k = 0; k < m.V.size(); ++k) {
        const double x_k0 = evaluation::initial_state(m.V[k], m.V[j], m.U[j], m.U[k], m.G[k], beta).x_k0;
        for (std::size_t i = 0; i < eta.size(); ++i) eta[i] += mode_shapes_at(m, Mass{k})[i] * m.r * m.r * x_k0;
    }
    for (std::size_t i = 0; i < eta.size(); ++i) {
        const ModeInScene<double> mode{m.R[i], m.zeta[i], mode_shapes_at(m, m.contact)[i], mode_shapes_at(m, m.load)[i]};
        const double load = paper::modal_contact_load_by_functions(mode, eta[i], m.u[i], m.g[i], beta);
        if (std::abs(load) <= mode.psi_ji * mu * beta) return false;
    }
    return true;
}

/// The first friction ratio, in steps of 1/256 of the boundary, at which a mode does not meet (63).
double limit_by_63_as_printed(const ModeSums<double>& m, double mu) {
    const double limit = boundary(m, mu).exact;
    for (int n = 1; n < 256; ++n)
        if (!every_mode_meets_63(m, mu, limit * n / 256)) return limit * n / 256;
    return limit;
}

/// The end of sliding by (58) and "(67) or (68)": where (68) begins below (58), (58) alone is left.
double limit_by_68_as_printed(const ModeSums<double>& m, double mu) {
    const Boundary<double> b = boundary(m, mu);
    const std::size_t j = m.contact.index;
    const double by_58 = paper::friction_ratio_limit(m.V[j], m.U[j], b.S_exact);
    const double by_68 = paper::friction_ratio_limit(m.V[j], m.U[j], m.H_j - mu * m.sum_of_squares);
    return by_68 < by_58 ? by_58 : b.exact;
}

/// Boundaries as the paper's algorithm sees them, started on the closed form; that of permanent sticking from rest.
std::vector<std::pair<double, double>> seen(const Figure& figure, const WithModes& s, double mu, const std::vector<double>& r,
                                            bool sticking = false) {
    std::vector<std::pair<double, double>> all;
    const SettingsAt settings = sticking ? [](double, double) { return PaperSettings{}; } : from_sliding(s, mu);
    for (const SeenBoundaries& b : seen_boundaries(figure, s.system, mu, r, settings))
        all.emplace_back(b.r, sticking ? b.sticking : b.sliding);
    return all;
}

/// The motion that the algorithm finds at r = 0.4 of panel d one percent beyond the boundary.
std::string beyond_the_boundary(const WithModes& s, double mu) {
    Scene<double> scene{.system = s.system, .mu = mu, .r = 0.4, .beta = 0, .static_load = {}};
    const double limit = boundary(s.at(0.4), mu).exact;
    scene.beta = 1.01 * limit;
    const PaperMotion m = paper_algorithm(scene, from_sliding(s, mu)(0.4, 1.01 * limit));
    const double X = s.sliding_amplitude(s.system.contact, 0.4, 0.9999 * limit);
    return "(d) The marker at r = 0.4 is beyond the curve: at 1.01 times the boundary " + text(limit) +
           " the algorithm ends in a motion with " + std::to_string(m.stops.size()) + " stops a period and amplitude " +
           text(m.masses[0].amplitude) + "; the closed form has " + text(X) + " at the boundary, so that it is another motion.";
}

/// Small motion of the contact below the boundary of permanent sticking, panel f at r = 2.2.
std::string near_permanent_sticking(const WithModes& s) {
    Scene<double> scene{.system = s.system, .mu = 1, .r = 2.2, .beta = 0, .static_load = {}};
    scene.beta = 0.98 * boundary(s.at(2.2), 1.0).sticking.value();
    PaperSettings settings;
    settings.absolute_tolerance = 1e-9;
    settings.cycles = 1000;
    const PaperMotion m = paper_algorithm(scene, settings);
    return "(f) At r = 2.2 and 0.98 times the boundary the contact still moves with amplitude " +
           text(m.masses[s.system.contact.index].amplitude, "%.2g") +
           " (tolerance 1e-9, 1000 periods), too little for the tolerance of the markers.";
}

Record make(Figure& figure) {
    const double mu = 2.5;
    const WithModes one(single_mass(0.1)), light(single_mass(0.01)),
        fourth(equal_chain<double>(5, 4, 1, std::vector<double>(5, 0.02))), paper_5(five_masses(1, 0.1)),
        last(equal_chain<double>(5, 5, 1, std::vector<double>(5, 0.1)));
    const StuckConfiguration stuck = stuck_configuration(last.system, last.basis);
    const std::optional<StuckChain> chain = stuck_chain(last.system, stuck);
    const std::vector<double> r = spaced(0.05, 2.5, 491), few = spaced(0.2, 2.4, 12);
    Record record;
    record.title = "Boundaries of the regimes as printed and as corrected: (56), (57), (59), (68), (70), (88)";
    record.equations = {"56", "57", "58", "59", "63", "67", "68", "69", "70", "88"};
    record.given = {"equal masses and springs, the same damping ratio for all modes", "200 periods, absolute tolerance 1e-6"};
    record.chosen = {"(a) SDOF, zeta = 0.1, mu = 1; (57) as printed has no finite maximum, so 99 and 999 instants are taken",
                     "(b) 5DOF, j = 4, l = 1, zeta_i = 0.02, mu = 1",
                     "(c) 5DOF, j = 1, l = 1, zeta_i = 0.1, mu = 1; steps of 1/256 of the boundary",
                     "(d) SDOF, zeta = 0.01, mu = 2.5",
                     "(e) SDOF, zeta = 0.1, mu = 1, tau = 1e-6 in (70)",
                     "(f) 5DOF, j = 5, l = 1, zeta_i = 0.1, mu = 1",
                     "the algorithm is started on the closed form, in (f) at rest"};
    const std::vector<BoundaryPanel> panels{
        {"a",
         {"(69) as corrected", "(57) as printed over 99 instants", "(57) as printed over 999 instants"},
         [&](double x) {
             const ModeSums<double> m = one.at(x);
             return std::vector<double>{boundary(m, 1.0).exact, limit_by_57_as_printed(m, 99), limit_by_57_as_printed(m, 999)};
         },
         seen(figure, one, 1, few)},
        {"b",
         {"(69) as corrected", "(69) with (56) as printed"},
         [&](double x) {
             const Boundary<double> b = boundary(fourth.at(x), 1.0);
             return std::vector<double>{b.exact, b.paper};
         },
         seen(figure, fourth, 1, spaced(0.2, 1, 17))},
        {"c",
         {"(69) as corrected", "(59) as printed for every mode"},
         [&](double x) {
             const ModeSums<double> m = paper_5.at(x);
             return std::vector<double>{boundary(m, 1.0).exact, limit_by_63_as_printed(m, 1)};
         },
         seen(figure, paper_5, 1, few)},
        {"d",
         {"(69) as corrected", "(68) as printed"},
         [&](double x) {
             const ModeSums<double> m = light.at(x);
             return std::vector<double>{boundary(m, mu).exact, limit_by_68_as_printed(m, mu)};
         },
         seen(figure, light, mu, few)},
        {"e",
         {"(67) as corrected", "(70) as printed"},
         [&](double x) {
             const ModeSums<double> m = one.at(x);
             return std::vector<double>{boundary(m, 1.0).approximate, limit_by_70_as_printed(m)};
         },
         seen(figure, one, 1, spaced(0.6, 2.4, 10))},
        {"f",
         {"(88) as corrected", "(88) as printed"},
         [&](double x) {
             const StickingBoundary b = sticking_boundary(stuck_response(stuck, last.system.load, x), chain, 1.0);
             return std::vector<double>{b.exact, b.paper.value()};
         },
         seen(figure, last, 1, few, true)}};
    for (const BoundaryPanel& p : panels) add(figure, record, p, r, "r");
    record.remarks = {beyond_the_boundary(light, mu), near_permanent_sticking(last)};
    return record;
}

const Listed listed("printed_against_corrected_boundary", make);

} // namespace denhartog::figures::printed_against_corrected_boundary
