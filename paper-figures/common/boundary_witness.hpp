/// @file
/// @brief Boundaries as printed and as corrected, with the paper's algorithm as the witness. Header only.
#pragma once

#include "denhartog/formulas/boundary.hpp"
#include "regimes.hpp"

namespace denhartog::figures {

/// @brief (69) with another sum in place of \f$ S_{dj} \f$. @param sums modes at a frequency ratio @param S the sum
/// @param mu static over kinetic friction @return the friction ratio
[[nodiscard]] inline double limit_with(const ModeSums<double>& sums, double S, double mu) {
    const std::size_t j = sums.contact.index;
    const double demand = std::max(S, paper::static_friction_demand(sums.H_j, mu, sums.sum_of_squares));
    return paper::friction_ratio_limit(sums.V[j], sums.U[j], demand);
}

/// @brief A boundary over an abscissa: as corrected first, then as printed, in one or more ways.
struct BoundaryPanel {
    std::string name;                                        ///< of its tables, a letter
    std::vector<std::string> curves;                         ///< names of the curves, the corrected one first
    std::function<std::vector<double>(double x)> boundaries; ///< friction ratios of the curves
    std::vector<std::pair<double, double>> seen;             ///< friction ratios by the paper's algorithm
};

/// @brief Adds the tables `NAME` and `markers NAME`, and how far every curve is from the markers.
/// @param figure  gets the tables
/// @param record  gets agreements, and a statement for every printed curve
/// @param p       the panel
/// @param x       abscissae of the curves
/// @param symbol  of the abscissa
inline void add(Figure& figure, Record& record, const BoundaryPanel& p, const std::vector<double>& x, const std::string& symbol) {
    Table lines{p.name, {symbol}, {}}, dots{"markers " + p.name, {symbol, "beta"}, {}};
    lines.columns.insert(lines.columns.end(), p.curves.begin(), p.curves.end());
    for (const double each : x) {
        lines.rows.push_back({each});
        const std::vector<double> all = p.boundaries(each);
        lines.rows.back().insert(lines.rows.back().end(), all.begin(), all.end());
    }
    std::vector<std::vector<std::pair<double, std::string>>> off(p.curves.size());
    for (const auto& [at, beta] : p.seen) {
        dots.rows.push_back({at, beta});
        const std::vector<double> all = p.boundaries(at);
        for (std::size_t n = 0; n < all.size(); ++n) off[n].emplace_back(all[n] / beta - 1, symbol + " = " + text(at));
    }
    figure.add(lines);
    figure.add(dots);
    double corrected = 0;
    for (std::size_t n = 0; n < off.size(); ++n) {
        const Agreement a = agreement("(" + p.name + ") " + p.curves[n] + ", relative to the markers", off[n]);
        record.agreements.push_back(a);
        if (n == 0)
            corrected = a.worst;
        else
            record.statements.push_back({"(" + p.name + ") The boundary is where " + p.curves[n] + " has it",
                                         "off by up to " + text(100 * a.worst, "%.3g") + " percent (" + a.where +
                                             "), as corrected by " + text(100 * corrected, "%.2g"),
                                         a.worst <= std::max(0.01, 2 * corrected)});
    }
}

} // namespace denhartog::figures
