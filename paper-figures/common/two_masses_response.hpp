/// @file
/// @brief Figs. 8 and 9: two masses, load on the first, contact on the second. Header only.
#pragma once

#include <boost/math/tools/roots.hpp>

#include "response_statements.hpp"
#include "tests/support/invariant_points.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures {

/// @brief Friction ratios of the two figures. @return the ratios, ascending, without zero
[[nodiscard]] inline std::vector<double> two_masses_betas() { return {0.1, 0.2, 0.4, 0.8, 1.2}; }

/// @brief The invariant points of a mass where its contact still slides at a friction ratio.
/// @param s     the system; its damping matters for the boundary alone
/// @param k     the mass
/// @param beta  friction ratio
/// @param to    largest frequency ratio
/// @return      the points, ascending
[[nodiscard]] inline std::vector<InvariantPoint<double>> sliding_invariant_points(const WithModes& s, Mass k, double beta,
                                                                                  double to) {
    std::vector<InvariantPoint<double>> points = tests::invariant_points_of(s.system, 0.1, to)[k.index].points;
    std::erase_if(points, [&](const auto& p) { return boundary(s.at(p.r), 1.0).exact <= beta; });
    return points;
}

/// @brief Crossings of curves (52) next to an invariant point.
struct Crossings {
    int pairs = 0;       ///< pairs of neighbouring friction ratios that slide at the point
    int found = 0;       ///< pairs whose curves cross in the stretch looked at
    double farthest = 0; ///< largest distance of a crossing from the point
};

/// @brief Where curves (52) of neighbouring friction ratios cross next to an invariant point.
/// @param s       the system
/// @param k       the mass
/// @param betas   friction ratios, ascending
/// @param near    frequency ratio of the invariant point
/// @param within  how far from it is looked
/// @return        the crossings
[[nodiscard]] inline Crossings crossings(const WithModes& s, Mass k, const std::vector<double>& betas, double near,
                                         double within) {
    const double limit = boundary(s.at(near), 1.0).exact;
    const std::vector<double> r = spaced(near - within, near + within, 200);
    std::vector<std::vector<double>> X(r.size(), std::vector<double>(betas.size(), std::nan("")));
    parallel_for(r.size(), threads(), [&](std::size_t n) {
        const ModeSums<double> sums = s.at(r[n]);
        const Boundary<double> limits = boundary(sums, 1.0);
        for (std::size_t b = 0; b < betas.size() && betas[b] < limits.exact; ++b)
            X[n][b] = steady_state(sums, limits, betas[b]).masses[k.index].amplitude_monoharmonic;
        return true;
    });
    Crossings c;
    for (std::size_t b = 1; b < betas.size() && betas[b] < limit; ++b) {
        const auto f = [&](double at) { return s.sliding_amplitude(k, at, betas[b - 1]) - s.sliding_amplitude(k, at, betas[b]); };
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t n = 1; n < r.size(); ++n) {
            const double left = X[n - 1][b - 1] - X[n - 1][b], right = X[n][b - 1] - X[n][b];
            if (!(left * right < 0)) continue;
            std::uintmax_t steps = 100;
            const auto ends = boost::math::tools::toms748_solve(f, r[n - 1], r[n], left, right,
                                                                boost::math::tools::eps_tolerance<double>(40), steps);
            nearest = std::min(nearest, std::abs(ends.first - near));
        }
        ++c.pairs;
        if (std::isinf(nearest)) continue;
        ++c.found;
        c.farthest = std::max(c.farthest, nearest);
    }
    return c;
}

/// @brief The two figures' record as far as they share it.
/// @param title  what is to be seen
/// @return       title, equations, what is given and chosen
[[nodiscard]] inline Record two_masses_record(const std::string& title) {
    Record record;
    record.title = title;
    record.given = {"two equal masses and springs, load on m_1, contact on m_2", "mu = 1",
                    "zeta_i = zeta / r_n,i with zeta = 0.001, 0.01, 0.1"};
    record.chosen = {"beta = 0, 0.1, 0.2, 0.4, 0.8, 1.2; beta = 0 without markers",
                     "r from 0.05 to 2.5, markers from 0.1 on in steps of 0.05",
                     "transmissibilities on a logarithmic axis, for peaks between 1 and 400"};
    return record;
}

/// @brief The systems at three damping ratios, with lines and markers.
/// @param figure       gets the tables
/// @param k            the mass shown
/// @param least_phase  where phases are drawn
/// @return             the systems, damping ascending
[[nodiscard]] inline std::vector<Damped> two_damped_masses(Figure& figure, Mass k, LeastPhase least_phase) {
    const ResponseOverR shown{k, two_masses_betas(), 0.05, 2.5, 0.01, spaced(0.1, 2.5, 49), least_phase};
    std::vector<Damped> all;
    for (const double zeta : {0.001, 0.01, 0.1}) all.push_back(damped(figure, shown, zeta, two_masses(zeta)));
    return all;
}

/// @brief Statements that both figures have.
/// @param record  gets agreements and statements
/// @param all     the systems
/// @param k       the mass shown
inline void two_masses_statements(Record& record, const std::vector<Damped>& all, Mass k) {
    for (const Damped& d : all) compare(record, d, k.index == d.modes.system.contact.index);
    record.statements.push_back(regimes_as_predicted(all));
    peak_statements(record, all, k, two_masses_betas());
    low_frequency_statements(record, all, 0.3);
    high_frequency_statements(record, all, k, two_masses_betas());
}

} // namespace denhartog::figures
