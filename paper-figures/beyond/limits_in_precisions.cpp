// (28), (29) on their way to the ends of the domain: decimal digits that the paper's forms and those that callers get keep in
// double, long double and 50 digits, against the paper's forms in 200 digits.
#include <algorithm>
#include <functional>

#include "figure.hpp"
#include "kept_digits.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::figures::limits_in_precisions {

using Real200 = Multiprecision<200>;

/// R and zeta.
struct Point {
    Real200 R, zeta;
};

/// A path to an end of the domain: x falls to zero.
struct Path {
    std::string name;                          ///< of its tables
    std::string words;                         ///< for the record
    std::function<Point(const Real200& x)> at; ///< where it is at x
    double last = -40;                         ///< power of ten of x where it ends
};

std::vector<Path> paths() {
    const Real200 three_quarters = Real200(3) / 4, tenth = Real200(1) / 10, hundredth = Real200(1) / 100, third = Real200(1) / 3;
    return {{"undamped", "zeta = x -> 0 at R = 3/4",
             [=](const Real200& x) {
                 return Point{three_quarters, x};
             }},
            {"resonance", "zeta = x -> 0 at R = 1",
             [](const Real200& x) {
                 return Point{Real200(1), x};
             }},
            {"third", "R = (1 + x) / 3, zeta = x -> 0",
             [=](const Real200& x) {
                 return Point{Real200(third * (1 + x)), x};
             }},
            {"low", "R = x -> 0 at zeta = 0.1",
             [=](const Real200& x) {
                 return Point{x, tenth};
             },
             -8},
            {"high", "R = 1 / x -> infinity at zeta = 0.01",
             [=](const Real200& x) {
                 return Point{Real200(1 / x), hundredth};
             }},
            {"critical", "zeta = 1 - x -> 1 at R = 3/4", [=](const Real200& x) {
                 return Point{three_quarters, Real200(1 - x)};
             }}};
}

/// The functions drawn: u and g, which come after v.
constexpr std::array<std::size_t, 2> drawn{1, 2};
template <class T>
using Two = std::array<T, 2>;

/// Digits left along a path in a number type.
struct Kept {
    Two<double> printed{INFINITY, INFINITY}, shipped{INFINITY, INFINITY}; ///< fewest digits of u and g
};

/// Digits in a number type along a path, from x = 0.1 down to where the point is the limit itself.
template <class T>
Kept follow(Figure& figure, const Path& path, const std::string& type) {
    Table table{path.name + " " + type, {"x", "printed u", "printed g", "shipped u", "shipped g"}, {}};
    Kept kept;
    for (const double exponent : spaced(-1, -40, 118)) {
        if (exponent < path.last - 0.01) break;
        const Point p = path.at(Real200(pow(Real200(10), Real200(exponent))));
        const T R = static_cast<T>(p.R), zeta = static_cast<T>(p.zeta);
        if (!(zeta < 1)) break;
        const Three<Complex<Real200>> truth = printed_functions(Real200(R), Real200(zeta));
        const Three<Complex<T>> theirs = printed_functions(R, zeta), ours = shipped_functions(R, zeta);
        std::vector<double> row{std::pow(10, exponent), 0, 0, 0, 0};
        for (std::size_t n = 0; n < 2; ++n) {
            const std::size_t f = drawn[n];
            const bool in_range = abs(truth[f].re) >= Real200((std::numeric_limits<T>::min)());
            row[1 + n] = in_range ? digits_kept(theirs[f], truth[f]) : std::nan("");
            row[3 + n] = in_range ? digits_kept(ours[f], truth[f]) : std::nan("");
            if (!in_range) continue;
            kept.printed[n] = std::min(kept.printed[n], row[1 + n]);
            kept.shipped[n] = std::min(kept.shipped[n], row[3 + n]);
        }
        table.rows.push_back(row);
    }
    figure.add(table);
    return kept;
}

/// Fewest digits, in the three types. @param kept along a path @param of of which form @param n of which function
std::string fewest(const std::array<Kept, 3>& kept, Two<double> Kept::*of, std::size_t n) {
    std::string words;
    for (const Kept& each : kept) words += (words.empty() ? "" : ", ") + text(std::floor((each.*of)[n]), "%.0f");
    return words;
}

Record make(Figure& figure) {
    Record record;
    record.title = "Digits of (28), (29) as printed and as shipped on their way to the ends of the domain, in three precisions";
    record.equations = {"28", "29"};
    record.chosen = {
        "x = 0.1 to 1e-40, to 1e-8 for R -> 0, three values a decade; a path ends where zeta rounds to 1 in its number type",
        "double (16 digits), long double (19) and 50 digits (51), at R and zeta rounded to the type",
        "the truth: the paper's forms in 200 digits; nothing is drawn where it is below the range of the number type",
        "a form that gives no number has no digit"};
    bool never_worse = true;
    std::string worse;
    const std::vector<Path> all = paths();
    for (std::size_t n = 0; n < all.size(); ++n) {
        const std::array<Kept, 3> kept{follow<double>(figure, all[n], "double"), follow<long double>(figure, all[n], "long"),
                                       follow<Real50>(figure, all[n], "50")};
        figure.progress(n + 1, all.size());
        std::string words = all[n].words + ", fewest digits in double, long double, 50 digits:";
        for (std::size_t f = 0; f < 2; ++f) {
            words += (f == 0 ? " " : "; ") + names_of_functions[drawn[f]] + " printed " + fewest(kept, &Kept::printed, f) +
                     ", shipped " + fewest(kept, &Kept::shipped, f);
            for (const Kept& each : kept)
                if (each.shipped[f] < each.printed[f] - 1) {
                    never_worse = false;
                    const std::string here = names_of_functions[drawn[f]] + " for " + all[n].words;
                    if (worse.find(here) == std::string::npos) worse += (worse.empty() ? "fewer of " : ", ") + here;
                }
        }
        record.remarks.push_back(words + ".");
    }
    record.statements.push_back(
        {"The fewest digits of a shipped form along a path are those of the printed form or more, to within one",
         never_worse ? "so for u and g on all paths, in each precision" : worse, never_worse});
    return record;
}

const Listed listed("limits_in_precisions", make);

} // namespace denhartog::figures::limits_in_precisions
