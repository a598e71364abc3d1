// (23), (28), (29) on 22 paths to the ends of their domain: what they tend to, and the fewest digits that the paper's forms and
// those that callers get keep on the way in float, double, long double and 50 digits, against the paper's forms in 400 digits.
#include <algorithm>
#include <atomic>

#include "denhartog/number/parallel.hpp"
#include "figure.hpp"
#include "limit_paths.hpp"
#include "markers.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::figures::limits_of_modes {

constexpr std::size_t types = 4;
const std::array<std::string, types> names_of_types{"float", "double", "long double", "50 digits"};
constexpr double step = 2.5; ///< decades

/// A path to the edge of the domain, with its limits.
struct Row {
    std::array<KeptAlongPath, types> kept;
    double x = 0;        ///< 1e-40, or the last
    Three<double> off{}; ///< from the leading terms there
};

/// Fewest digits. @param row of a path @param t number type @param shipped which form @param f function
const Kept& kept(const Row& row, std::size_t t, bool shipped, std::size_t f) {
    return (shipped ? row.kept[t].shipped : row.kept[t].printed)[f];
}

std::vector<Row> follow_all(const Figure& figure, const std::vector<LimitPath>& paths) {
    std::vector<Row> rows(paths.size());
    std::atomic<std::size_t> done{0};
    parallel_for(paths.size(), threads(), [&](std::size_t n) {
        const LimitPath& p = paths[n];
        const Real400 x = pow(Real400(10), Real400(std::max(p.last, -40.0)));
        rows[n] = {{follow<float>(p, step), follow<double>(p, step), follow<long double>(p, step), follow<Real50>(p, step)},
                   static_cast<double>(x),
                   off_leading_terms(p, x, p.leading(x))};
        figure.progress(++done, paths.size());
        return true;
    });
    return rows;
}

const std::array<double, types>& digits_of_types() {
    static const std::array<double, types> digits{digits_of_type<float>(), digits_of_type<double>(),
                                                  digits_of_type<long double>(), digits_of_type<Real50>()};
    return digits;
}

/// Whether a form keeps less than half of the digits of a type.
bool fails(const Row& row, std::size_t t, bool shipped, std::size_t f) {
    return kept(row, t, shipped, f).digits < digits_of_types()[t] / 2;
}

/// A head for each function, and below it the paths on which a form of it fails in some type: digits and their share, a column a
/// form and type, and what is written beside them.
void add(Figure& figure, const std::vector<LimitPath>& paths, const std::vector<Row>& rows) {
    Table cells{"cells", {"column", "row", "digits", "share"}, {}};
    Table words{"words", {"row"}, {}, {}};
    const auto write = [&](const std::string& path, const std::string& limit) {
        words.rows.push_back({static_cast<double>(words.rows.size())});
        words.words.push_back({path, limit});
    };
    for (std::size_t f = 0; f < 3; ++f) {
        write(numbers_of_functions[f] + ", path", (f == 0 ? "|v|" : names_of_functions[f]) + " →");
        for (std::size_t n = 0; n < rows.size(); ++n) {
            bool any = false;
            for (std::size_t t = 0; t < types; ++t) any = any || fails(rows[n], t, false, f) || fails(rows[n], t, true, f);
            if (!any) continue;
            for (std::size_t t = 0; t < types; ++t)
                for (const bool shipped : {false, true}) {
                    const double digits = kept(rows[n], t, shipped, f).digits;
                    cells.rows.push_back({static_cast<double>((shipped ? 4 : 0) + t), static_cast<double>(words.rows.size()),
                                          std::floor(digits + 0.5), digits / digits_of_types()[t]});
                }
            write(paths[n].words, paths[n].limits[f]);
        }
    }
    figure.add(cells);
    figure.add(words);
}

/// Fewest digits in the four types.
std::string in_types(const Row& row, bool shipped, std::size_t f) {
    std::string words;
    for (std::size_t t = 0; t < types; ++t)
        words += (t == 0 ? "" : ", ") + text(std::floor(kept(row, t, shipped, f).digits + 0.5), "%.0f");
    return words;
}

/// The paths on which the paper's form of a function keeps less than half of the digits of a type.
std::size_t lost_on(const std::vector<Row>& rows, std::size_t t, std::size_t f) {
    return static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [&](const Row& row) { return fails(row, t, false, f); }));
}

void describe(Record& record, const std::vector<LimitPath>& paths, const std::vector<Row>& rows) {
    double off = 0, most_lost = 0;
    for (const Row& row : rows)
        for (std::size_t f = 0; f < 3; ++f) {
            off = std::max(off, row.off[f] / row.x);
            for (std::size_t t = 0; t < types; ++t)
                most_lost = std::max(most_lost, digits_of_types()[t] - kept(row, t, true, f).of_attainable);
        }
    record.statements.push_back({"(23), (28), (29) tend to the leading terms that the derivation has, on all paths",
                                 "their relative difference at x = 1e-40, for R -> 0 at 1e-8, in 400 digits, is " +
                                     std::string(off < 1000 ? "below" : "not below") + " 1000 x",
                                 off < 1000});
    record.statements.push_back({"The shipped forms lose less than a digit and a half beyond what the condition number in zeta "
                                 "costs, on every path, in each of the four types",
                                 "less than " + text(std::ceil(2 * most_lost) / 2, "%.1f") + " digits", most_lost < 1.5});
    for (std::size_t f = 0; f < 3; ++f) {
        std::string words;
        bool all = true;
        for (std::size_t t = 0; t < types; ++t) {
            const std::size_t lost = lost_on(rows, t, f);
            all = all && lost == 0;
            words += (t == 0 ? "" : ", ") + std::to_string(lost) + " in " + names_of_types[t];
        }
        record.statements.push_back({numbers_of_functions[f] + " as printed keeps half of its digits or more on every path",
                                     "it does not on " + words + ", of " + std::to_string(rows.size()) + " paths", all});
    }
    for (std::size_t n = 0; n < rows.size(); ++n) {
        std::string words = paths[n].words + ": ";
        for (std::size_t f = 0; f < 3; ++f)
            words += (f == 0 ? "" : "; ") + names_of_functions[f] + " ~ " + paths[n].limits[f] + ", printed " +
                     in_types(rows[n], false, f) + ", shipped " + in_types(rows[n], true, f);
        record.remarks.push_back(words + ".");
    }
}

Record make(Figure& figure) {
    const std::vector<LimitPath> paths = limit_paths_of_modes();
    const std::vector<Row> rows = follow_all(figure, paths);
    add(figure, paths, rows);
    Record record;
    record.title = "(23), (28), (29) at the ends of their domain: limits along " + std::to_string(paths.size()) +
                   " paths, and the digits that printed and shipped forms keep in four precisions";
    record.equations = {"23", "28", "29"};
    record.chosen = {"x = 0.1 down to 1e-100, for R -> 0 to 1e-8, by " + text(step) +
                         " decades; a path ends where R or zeta rounds to the limit in the number type",
                     "digits: the fewest on the path, in float (7), double (16), long double (19), 50 digits (51), at R and zeta "
                     "rounded to the type; values beyond the range of the type are left out",
                     "the truth: the paper's forms in 400 digits", "a form that gives no number has no digit"};
    describe(record, paths, rows);
    return record;
}

const Listed listed("limits_of_modes", make);

} // namespace denhartog::figures::limits_of_modes
