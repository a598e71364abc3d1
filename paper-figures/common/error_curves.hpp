/// @file
/// @brief Errors of approximations over a parameter, and where they are below 1 and 0.01 percent. Header only.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "figure.hpp"

namespace denhartog::figures {

/// @brief An approximation over a parameter.
struct ErrorCurve {
    std::string panel;                     ///< letter of its panel
    std::string name;                      ///< of its table, after the panel
    std::string what;                      ///< which approximation, of which system
    std::string symbol;                    ///< the parameter
    std::vector<double> x;                 ///< its values, ascending
    std::function<double(double x)> error; ///< not negative; not a number where nothing is approximated
};

/// @brief Where errors are below a limit, in words: intervals of the parameter, at most four, else the share of the points.
/// @param x       values of the parameter, ascending
/// @param errors  errors there; points that are no number are left out
/// @param limit   the limit
/// @param symbol  the parameter
/// @return        e.g. `r = 0.1 to 0.3, 0.8 to 2.5`, `everywhere`, `nowhere`
[[nodiscard]] inline std::string where_below(const std::vector<double>& x, const std::vector<double>& errors, double limit,
                                             const std::string& symbol) {
    std::vector<std::pair<double, double>> intervals;
    std::size_t below = 0, all = 0;
    bool open = false;
    for (std::size_t n = 0; n < x.size(); ++n) {
        if (std::isnan(errors[n])) continue;
        ++all;
        const bool good = errors[n] < limit;
        below += good ? 1 : 0;
        if (good && open) intervals.back().second = x[n];
        if (good && !open) intervals.emplace_back(x[n], x[n]);
        open = good;
    }
    if (below == 0) return "nowhere";
    if (below == all) return "everywhere";
    std::string words;
    for (std::size_t n = 0; n < intervals.size() && n < 4; ++n)
        words += (n == 0 ? symbol + " = " : ", ") + text(intervals[n].first, "%.3g") +
                 (intervals[n].second > intervals[n].first ? " to " + text(intervals[n].second, "%.3g") : "");
    if (intervals.size() <= 4) return words;
    const auto& [from, to] = intervals.back();
    return "at " + text(100.0 * static_cast<double>(below) / static_cast<double>(all), "%.0f") + " percent of the points" +
           (to == x.back() ? ", last from " + symbol + " = " + text(from, "%.3g") + " on" : "");
}

/// @brief Adds the table `PANEL NAME` and the statement that the approximation is good to 1 percent over the range.
/// @param figure  gets the table
/// @param record  gets the statement, with where it is good to 1 and 0.01 percent and where it is worst
/// @param c       the approximation
inline void add(Figure& figure, Record& record, const ErrorCurve& c) {
    Table table{c.panel + " " + c.name, {c.symbol, "error"}, {}};
    std::vector<double> errors;
    double worst = 0, at = 0, from = std::nan(""), to = std::nan("");
    for (const double x : c.x) {
        errors.push_back(c.error(x));
        const double e = errors.back();
        table.rows.push_back({x, std::isnan(e) ? e : std::max(e, 1e-16)}); // zero has no logarithm
        if (std::isnan(e)) continue;
        if (std::isnan(from)) from = x;
        to = x;
        if (e > worst) worst = e, at = x;
    }
    figure.add(table);
    record.statements.push_back({"(" + c.panel + ") " + c.what + ": good to 1 percent over " + c.symbol + " = " +
                                     text(from, "%.3g") + " to " + text(to, "%.3g"),
                                 "to 1 percent: " + where_below(c.x, errors, 1e-2, c.symbol) +
                                     "; to 0.01 percent: " + where_below(c.x, errors, 1e-4, c.symbol) + "; worst " +
                                     text(100 * worst, "%.3g") + " percent at " + c.symbol + " = " + text(at, "%.3g"),
                                 worst < 1e-2});
}

} // namespace denhartog::figures
