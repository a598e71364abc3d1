// (86) as printed and as corrected: the boundary of the sliding regime at high frequency ratios.
#include "boundary_witness.hpp"
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::printed_against_corrected_high_frequency {

const double far = 1000, near = 20;

/// The friction ratio at the boundary by the paper's algorithm at r = 20, started on the closed form, for a number of mu.
std::vector<std::pair<double, double>> seen(const Figure& figure, const WithModes& s, const std::vector<double>& mus) {
    std::vector<std::pair<double, double>> all;
    for (const double mu : mus) {
        const SettingsAt start = from_sliding(s, mu);
        const auto settings = [&](double r, double beta) {
            PaperSettings each = start(r, beta);
            each.absolute_tolerance = 1e-9;
            return each;
        };
        all.emplace_back(mu, seen_boundaries(figure, s.system, mu, {near}, settings).front().sliding);
    }
    return all;
}

/// The statement that neither damping nor the number of masses matters, at r = 1000.
Statement only_mu_matters(const std::vector<double>& mus) {
    double worst = 0;
    std::string where;
    for (const double zeta : {0.001, 0.1})
        for (const NamedSystem<double>& named : {NamedSystem<double>{"SDOF", single_mass(zeta)},
                                                 {"2DOF j = l = 2", equal_chain<double>(2, 2, 2, {zeta, zeta})},
                                                 {"5DOF j = l = 1", five_masses(1, zeta)},
                                                 {"5DOF j = l = 3", equal_chain<double>(5, 3, 3, std::vector<double>(5, zeta))}})
            for (const double mu : mus) {
                const double limit = boundary(WithModes(named.system).at(far), mu).exact;
                const double off = std::abs(limit / paper::friction_ratio_limit_at_high_frequency(mu) - 1);
                if (off > worst) worst = off, where = named.name + ", zeta = " + text(zeta) + ", mu = " + text(mu);
            }
    return {"With load and friction on one mass neither damping nor the number of masses matters at high frequency; here: (69) "
            "at r = "
            "1000 within 0.1 percent of (86) as corrected",
            "at most " + text(100 * worst, "%.2g") + " percent off (" + where + ")", worst < 1e-3};
}

Record make(Figure& figure) {
    const WithModes s(single_mass(0.1));
    const std::vector<double> drawn{1, 1.5, 2, 3}, r = spaced_in_octaves(0.5, 300, 401), mus = spaced(1, 3, 201);
    Record record;
    record.title = "The boundary of sliding at high frequency as printed and as corrected: (86)";
    record.equations = {"69", "86"};
    record.given = {"beta_inf = 0.537 for mu = 1"};
    record.chosen = {
        "SDOF, zeta = 0.1; mu = 1, 1.5, 2, 3 in (a), 1 to 3 in (b)",
        "(b) (69) at r = 1000, and the algorithm at r = 20, 200 periods, started on the closed form, absolute tolerance 1e-9, "
        "as amplitudes fall with the square of r"};
    Table curves{"a", {"r", "mu=1", "mu=1.5", "mu=2", "mu=3"}, {}};
    for (const double each : r) {
        curves.rows.push_back({each});
        for (const double mu : drawn) curves.rows.back().push_back(boundary(s.at(each), mu).exact);
    }
    figure.add(curves);
    Table limits{"limits", {"mu", "corrected", "printed"}, {}};
    for (const double mu : drawn)
        limits.rows.push_back(
            {mu, paper::friction_ratio_limit_at_high_frequency(mu), as_printed::friction_ratio_limit_at_high_frequency(mu)});
    figure.add(limits);
    const BoundaryPanel over_mu{"b",
                                {"(86) as corrected", "(86) as printed", "(69) at r = 1000"},
                                [&](double mu) {
                                    return std::vector<double>{paper::friction_ratio_limit_at_high_frequency(mu),
                                                               as_printed::friction_ratio_limit_at_high_frequency(mu),
                                                               boundary(s.at(far), mu).exact};
                                },
                                seen(figure, s, spaced(1, 3, 9))};
    add(figure, record, over_mu, mus, "mu");
    const double at_one = paper::friction_ratio_limit_at_high_frequency(1.0);
    record.statements.push_back(
        {"beta_inf = 0.537 for mu = 1", "(86), as printed and as corrected: " + text(at_one),
         text(at_one, "%.3f") == "0.537" && as_printed::friction_ratio_limit_at_high_frequency(1.0) == at_one});
    record.statements.push_back(only_mu_matters({1, 1.5, 2, 3}));
    const WithModes other(two_masses(0.1));
    const double at_10 = boundary(other.at(10), 1.0).exact, at_far = boundary(other.at(far), 1.0).exact;
    record.statements.push_back(
        {"With the load on another mass the boundary tends to zero; here: 2DOF of Fig. 10, zeta = 0.1, mu = 1",
         text(at_10, "%.3g") + " at r = 10, " + text(at_far, "%.3g") + " at r = 1000; slope in the logarithms " +
             text(std::log(at_far / at_10) / std::log(far / 10), "%.3f"),
         at_far < 0.01 * at_10});
    record.remarks = {"At mu = 3 (86) as printed is " + text(limits.rows.back()[2]) + " and as corrected " +
                      text(limits.rows.back()[1]) + "; (69) at r = 1000 is " + text(boundary(s.at(far), 3.0).exact) + "."};
    return record;
}

const Listed listed("printed_against_corrected_high_frequency", make);

} // namespace denhartog::figures::printed_against_corrected_high_frequency
