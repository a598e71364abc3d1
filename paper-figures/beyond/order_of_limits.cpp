// (23), (28), (29) near the resonance of a lightly damped mode: the limits along several paths, in 50 and 100 digits, and the
// digits that are left of them in double.
#include <functional>

#include "denhartog/evaluation/mode.hpp"
#include "figure.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::figures::order_of_limits {

/// A path to R = 1, zeta = 0: x falls to zero.
struct Path {
    std::string name;                                 ///< of its tables
    std::string words;                                ///< for the record
    int side;                                         ///< R = 1 + side x
    std::function<Real100(const Real100& x)> damping; ///< zeta at x
};

std::vector<Path> paths() {
    return {{"R=1", "R = 1, zeta = x", 0, [](const Real100& x) { return x; }},
            {"p=1/2", "R = 1 + x, zeta = x^(1/2)", 1, [](const Real100& x) { return Real100(sqrt(x)); }},
            {"p=1", "R = 1 + x, zeta = x", 1, [](const Real100& x) { return x; }},
            {"p=2", "R = 1 + x, zeta = x^2", 1, [](const Real100& x) { return Real100(x * x); }},
            {"p=3", "R = 1 + x, zeta = x^3", 1, [](const Real100& x) { return Real100(x * x * x); }},
            {"zeta=0", "R = 1 + x, zeta = 0", 1, [](const Real100&) { return Real100(0); }},
            {"p=1/2 below", "R = 1 - x, zeta = x^(1/2)", -1, [](const Real100& x) { return Real100(sqrt(x)); }}};
}

/// |v|, u, g.
template <class T>
using Three = std::array<T, 3>;
const Three<std::string> symbols{"|v|", "u", "g"};

/// The functions in the forms that callers get.
template <class T>
Three<T> shipped(const T& R, const T& zeta) {
    const evaluation::ModeFunctions<T> f = evaluation::mode_functions(R, zeta);
    return {modulus(f.v), f.u, f.g};
}

/// The functions as the paper writes them.
template <class T>
Three<T> written(const T& R, const T& zeta) {
    return {modulus(paper::complex_response(R, zeta)), paper::first_damping_function(R, zeta),
            paper::second_damping_function(R, zeta)};
}

/// Decimal digits of a value, at most 17. @param value the value @param truth what it should be
double digits(const Real100& value, const Real100& truth) {
    const Real100 error = abs(Real100(value - truth));
    if (error == 0) return 17;
    return truth == 0 ? 0 : std::clamp(-std::log10(static_cast<double>(Real100(error / abs(truth)))), 0.0, 17.0);
}

/// A limit of a function along a path: factor times x to a power.
struct Limit {
    double factor;   ///< as computed at the last x
    double exponent; ///< slope in the logarithms between the last two x
};

Limit limit_of(const Real100& before, const Real100& last, const Real100& x_before, const Real100& x_last) {
    if (last == 0) return {0, 0};
    const double slope = std::log10(static_cast<double>(Real100(abs(last) / abs(before)))) /
                         std::log10(static_cast<double>(Real100(x_last / x_before)));
    const double exponent = std::round(2 * slope) / 2; // exponents here are multiples of one half
    return {static_cast<double>(Real100(last * Real100(exp(Real100(-exponent * log(x_last)))))), exponent};
}

std::string text_of(const Limit& l) {
    if (l.factor == 0) return "0";
    return text(l.factor, "%.6f") + (l.exponent == 0 ? "" : " x^(" + text(l.exponent) + ")");
}

/// Limits along the paths to resonance, in many digits.
struct Limits {
    std::vector<std::vector<Limit>> of; ///< path by path: |v|, u, g
    double fewest = INFINITY;           ///< decimal digits that 50 digits and 100 digits, two forms, have in common
};

Limits follow(Figure& figure) {
    Limits limits;
    for (const Path& path : paths()) {
        Table table{path.name, {"x", "|v|", "|u|", "g"}, {}};
        Three<Real100> before, last;
        Real100 x_before, x_last;
        for (const double exponent : spaced(-0.5, -15, 59)) {
            const Real100 x = pow(Real100(10), Real100(exponent)), R = 1 + path.side * x, zeta = path.damping(x);
            const Three<Real100> by_100 = shipped(R, zeta), by_paper = written(R, zeta);
            const Three<Real50> by_50 = shipped(Real50(R), Real50(zeta));
            table.rows.push_back({static_cast<double>(x)});
            for (std::size_t n = 0; n < 3; ++n) {
                const double size = static_cast<double>(Real100(abs(by_100[n])));
                table.rows.back().push_back(size > 0 ? size : std::nan(""));
                if (by_100[n] == 0) continue;
                const Real100 off = std::max(abs(Real100(Real100(by_50[n]) - by_100[n])), abs(Real100(by_paper[n] - by_100[n])));
                if (off > 0) limits.fewest = std::min(limits.fewest, -static_cast<double>(log10(Real100(off / abs(by_100[n])))));
            }
            before = last, x_before = x_last, last = by_100, x_last = x;
        }
        figure.add(table);
        limits.of.emplace_back();
        for (std::size_t n = 0; n < 3; ++n) limits.of.back().push_back(limit_of(before[n], last[n], x_before, x_last));
    }
    return limits;
}

/// u along R = 1 + t zeta^2. @return the largest difference from (1 + 2 t) / pi at zeta = 1e-12
double beside_resonance(Figure& figure) {
    Table table{"beside", {"t", "zeta=0.3", "zeta=0.1", "limit"}, {}};
    double largest = 0;
    for (const double t : spaced(-2, 2, 81)) {
        table.rows.push_back({t});
        for (const double zeta : {0.3, 0.1, 1e-12})
            table.rows.back().push_back(
                static_cast<double>(shipped(Real50(1 + Real50(t) * Real50(zeta) * Real50(zeta)), Real50(zeta))[1]));
        largest = std::max(largest, std::abs(table.rows.back().back() - (1 + 2 * t) / pi<double>()));
    }
    figure.add(table);
    return largest;
}

/// Digits left in double along the paths.
struct Kept {
    double fewest = 17;            ///< digits of a shipped form
    std::string where;             ///< of which, and along which path
    double less_than_rounding = 0; ///< digits that a shipped form lacks of what a rounding of R would leave, or of 15
    Three<double> gone{0, 0, 0};   ///< largest x at which a form of the paper has less than half a digit, |v|, u, g
};

/// Digits in double of the shipped forms and of the paper's, at R and zeta that are doubles, and those that R (1 + 2^-53) in
/// place of R would leave.
Kept double_precision(Figure& figure) {
    Kept kept;
    for (const Path& path : paths()) {
        Table table{"digits " + path.name, {"x"}, {}};
        for (const char* of : {"shipped ", "written ", "rounded "})
            for (const std::string& f : symbols) table.columns.push_back(of + f);
        for (const double exponent : spaced(-0.5, -15, 59)) {
            const double R = 1 + path.side * std::pow(10, exponent),
                         x = path.side == 0 ? std::pow(10, exponent) : std::abs(R - 1);
            const double zeta = static_cast<double>(path.damping(Real100(x)));
            const Real100 rounded = Real100(R) * (1 + ldexp(Real100(1), -53));
            const Three<Real100> truth = shipped(Real100(R), Real100(zeta)), beside = shipped(rounded, Real100(zeta));
            const Three<double> ours = shipped(R, zeta), theirs = written(R, zeta);
            Three<double> left{}, by_paper{}, after_rounding{};
            for (std::size_t n = 0; n < 3; ++n) {
                left[n] = digits(Real100(ours[n]), truth[n]);
                by_paper[n] = std::isfinite(theirs[n]) ? digits(Real100(theirs[n]), truth[n]) : 0;
                after_rounding[n] = digits(beside[n], truth[n]);
                kept.less_than_rounding = std::max(kept.less_than_rounding, std::min(15.0, after_rounding[n]) - left[n]);
                if (left[n] < kept.fewest) kept.fewest = left[n], kept.where = symbols[n] + " along " + path.words;
                if (by_paper[n] < 0.5) kept.gone[n] = std::max(kept.gone[n], x);
            }
            table.rows.push_back({x});
            for (const Three<double>& each : {left, by_paper, after_rounding})
                table.rows.back().insert(table.rows.back().end(), each.begin(), each.end());
        }
        figure.add(table);
    }
    return kept;
}

Record make(Figure& figure) {
    const Limits limits = follow(figure);
    const double beside = beside_resonance(figure);
    const Kept kept = double_precision(figure);
    Record record;
    record.title =
        "The order of the limits R -> 1 and zeta -> 0: (23), (28), (29) along several paths, and the digits left in double";
    record.equations = {"23", "28", "29", "76", "79"};
    record.chosen = {
        "R = 1 + x, zeta = x^p, p = 1/2, 1, 2, 3; R = 1, zeta = x; zeta = 0; R = 1 - x, zeta = x^(1/2); x = 10^-0.5 to 10^-15",
        "50 and 100 digits, the shipped forms and those of the paper", "(d) R = 1 + t zeta^2",
        "(e), (f) double at R and zeta that are doubles, against 100 digits; (e) besides, what R off by 2^-53 of itself leaves "
        "of u"};
    const std::vector<Path> all = paths();
    const auto along_all = [&](std::size_t function) {
        std::string words;
        for (std::size_t n = 0; n < all.size(); ++n)
            words += (n == 0 ? "" : "; ") + text_of(limits.of[n][function]) + " along " + all[n].words;
        return words;
    };
    bool zero = true;
    for (const std::vector<Limit>& of : limits.of) zero = zero && (of[1].factor == 0 || of[1].exponent > 0);
    record.statements.push_back({"u_di = 0 for R_i -> 1; here: along every path", along_all(1), zero});
    const Limit v = limits.of[0][0], g = limits.of[0][2];
    record.statements.push_back({"|v_di| tends to 1 / (2 zeta_i) for R_i -> 1, (77); here: along R = 1, zeta = x", text_of(v),
                                 v.exponent == -1 && std::abs(v.factor - 0.5) < 1e-6});
    record.statements.push_back(
        {"(79) tends to infinity for zeta_i -> 0; here: g along R = 1, zeta = x", text_of(g), g.exponent < 0});
    const std::string common = limits.fewest > 30 ? "more than 30" : text(limits.fewest, "%.0f");
    const std::string no_worse =
        kept.less_than_rounding < 1 ? "no more than R off by 2^-53 costs, to within a digit"
                                    : "up to " + text(kept.less_than_rounding, "%.0f") + " digits more than R off by 2^-53 costs";
    const std::string few = text(std::max(2.0, std::ceil(kept.fewest)));
    record.remarks = {"|v| tends to " + along_all(0) + ".",
                      "g tends to " + along_all(2) + ".",
                      "Along R = 1 + t zeta^2 u tends to (1 + 2 t) / pi, at zeta = 1e-12 to " +
                          std::string(beside < 1e-12 ? "below 1e-12" : text(beside, "%.1e")) +
                          ": every number is a limit, zero at t = -1/2, which is R = sqrt(1 - zeta^2) to this order.",
                      "50 and 100 digits, shipped forms and the paper's, have " + common +
                          " digits in common on all paths; R next to 1 costs 15.",
                      "In double the shipped forms lose " + no_worse + ". Fewest are left of " + kept.where + ", less than " +
                          few + " next to x = 1e-15, where 1 / R is rounded.",
                      "In double the paper's forms have no digit left from x = " + text(kept.gone[1], "%.0e") +
                          " on of u, from x = " + text(kept.gone[2], "%.0e") +
                          " on of g, each on the worst path; one that divides by zero counts as none.",
                      "On zeta = 0 g is zero and has no line in (c); in (e), (f) zeta = 0 is left out."};
    return record;
}

const Listed listed("order_of_limits", make);

} // namespace denhartog::figures::order_of_limits
