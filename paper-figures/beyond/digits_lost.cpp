// (23), (28), (29) over (R, zeta): decimal digits that double loses in the forms of the paper and in those shipped, against 50
// digits, beside the condition number.
#include <atomic>

#include "denhartog/number/parallel.hpp"
#include "digits_map.hpp"
#include "markers.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::figures::map_of_digits_lost {

void fill(const Figure& figure, Map& map) {
    map.points.resize(map.R.size() * map.zeta.size());
    std::atomic<std::size_t> done{0};
    parallel_for(map.R.size(), threads(), [&](std::size_t a) {
        for (std::size_t b = 0; b < map.zeta.size(); ++b) map.points[a * map.zeta.size() + b] = places(map.R[a], map.zeta[b]);
        figure.progress(++done, map.R.size());
        return true;
    });
}

/// For the colours: digits or a power of ten, 16.5 where there is no number, -0.5 below the range of double.
double shown(const Place& p, double value) {
    if (p.below_range) return -0.5;
    return value < INFINITY ? std::round(100 * std::clamp(value, 0.0, 15.99)) / 100 : 16.5;
}

void add(Figure& figure, const Map& map) {
    for (std::size_t n = 0; n < 3; ++n) {
        const auto table = [&](const std::string& what, const auto& value) {
            Table t{map.name + " " + names_of_functions[n] + " " + what, {}, {}};
            for (const double R : map.R) t.columns.push_back(text(R, "%.17g"));
            for (std::size_t b = 0; b < map.zeta.size(); ++b) {
                std::vector<double> row;
                for (std::size_t a = 0; a < map.R.size(); ++a) {
                    const Place& p = map.points[a * map.zeta.size() + b][n];
                    row.push_back(shown(p, value(p)));
                }
                t.rows.push_back(row);
            }
            figure.add(t);
        };
        table("printed", [](const Place& p) { return p.printed; });
        table("shipped", [](const Place& p) { return p.shipped; });
        table("condition", [](const Place& p) { return std::log10(p.condition()); });
    }
}

/// Fewest decimal digits that the reference has in common with the paper's forms in 100 digits, at every 23rd point.
double check(const std::vector<Map>& maps) {
    double fewest = INFINITY;
    for (const Map& map : maps)
        for (std::size_t n = 0; n < map.points.size(); n += 23) {
            const Three<Complex<Real50>> reference = shipped_functions(Real50(map.R_of(n)), Real50(map.zeta_of(n)));
            const Three<Complex<Real100>> truth = printed_functions(Real100(map.R_of(n)), Real100(map.zeta_of(n)));
            for (std::size_t f = 0; f < 3; ++f) {
                const Complex<Real100> r{Real100(reference[f].re), Real100(reference[f].im)};
                const Real100 off = difference(r, truth[f]);
                if (off > 0) fewest = std::min(fewest, -static_cast<double>(log10(off)));
            }
        }
    return fewest;
}

/// A point in hexadecimal, so that it can be pasted back.
std::string hexadecimal(double R, double zeta) {
    return "R = " + text(R, "%a") + ", zeta = " + text(zeta, "%a") + " (" + text(R, "%.6g") + ", " + text(zeta, "%.3g") + ")";
}

/// A largest number, and where it is.
struct Most {
    double value = -INFINITY;
    std::string where;
    void meet(double other, double R, double zeta) {
        if (other > value) *this = {other, hexadecimal(R, zeta)};
    }
};

/// Numbers of points of the maps of a function, by what a form gives there.
struct Count {
    std::size_t points = 0, below_range = 0, good = 0; ///< in the range of double, below it; of the former well conditioned
    std::size_t many = 0;         ///< well conditioned, and the printed form loses many digits or gives no number
    std::size_t many_at_R = 0;    ///< well conditioned in zeta, and the printed form loses many digits or gives no number
    std::size_t none = 0;         ///< the printed form gives no number
    std::size_t overflows = 0;    ///< of these, pi zeta / R beyond the range of cosh
    std::size_t shipped_none = 0; ///< the shipped form gives no number
    double heaviest = 0;          ///< largest damping ratio where the printed form gives no number though cosh is in range
    Most printed_worst;           ///< digits lost where well conditioned
    Most beyond;                  ///< digits that the shipped form loses beyond the condition number
};

Count count(const std::vector<Map>& maps, std::size_t f) {
    Count c;
    for (const Map& map : maps)
        for (std::size_t n = 0; n < map.points.size(); ++n) {
            const Place& p = map.points[n][f];
            const double R = map.R_of(n), zeta = map.zeta_of(n);
            if (p.below_range) {
                ++c.below_range;
                continue;
            }
            ++c.points;
            c.many_at_R += p.by_zeta < moderate && p.printed > many;
            c.shipped_none += std::isinf(p.shipped);
            c.beyond.meet(p.shipped - std::log10(std::max(1.0, p.condition())), R, zeta);
            if (std::isinf(p.printed)) {
                const bool overflows = std::isinf(std::cosh(pi<double>() * zeta / R));
                ++c.none;
                c.overflows += overflows;
                if (!overflows) c.heaviest = std::max(c.heaviest, zeta);
            }
            if (!p.good()) continue;
            ++c.good;
            c.many += p.printed > many;
            c.printed_worst.meet(p.printed, R, zeta);
        }
    return c;
}

std::string of(std::size_t part, std::size_t all) {
    return std::to_string(part) + " of " + std::to_string(all) + " points (" +
           text(100.0 * static_cast<double>(part) / static_cast<double>(all), "%.2g") + " percent)";
}

/// @return e.g. `less than 3 digits`
std::string less_than(double digits) {
    if (std::isinf(digits)) return "all digits";
    const double above = std::max(1.0, std::floor(digits) + 1);
    return "less than " + text(above) + (above == 1 ? " digit" : " digits");
}

void describe(Record& record, std::size_t f, const Count& c) {
    const std::string& symbol = names_of_functions[f];
    record.statements.push_back({numbers_of_functions[f] +
                                     " as printed loses more than 8 digits, or gives no number, only where its condition "
                                     "number is 100 or more",
                                 "it does so at " + of(c.many, c.good) + " with a condition number below 100", c.many == 0});
    record.statements.push_back({"The shipped form of " + numbers_of_functions[f] +
                                     " loses less than a digit beyond what its condition number costs, everywhere",
                                 less_than(c.beyond.value) + " beyond the condition number", c.beyond.value < 1});
    std::string words = symbol + " as printed, condition number below 100: ";
    words += std::isinf(c.printed_worst.value) ? "no number" : less_than(c.printed_worst.value) + " lost";
    words += ", as at " + c.printed_worst.where + ". It gives no number at " + of(c.none, c.points);
    if (c.overflows > 0) words += ", at " + std::to_string(c.overflows) + " of them by overflow of cosh";
    if (c.none > c.overflows)
        words +=
            ", at " + std::to_string(c.none - c.overflows) + " by a denominator of zero, zeta up to " + text(c.heaviest, "%.2g");
    record.remarks.push_back(words + ".");
    if (c.many_at_R > c.many)
        record.remarks.push_back(symbol +
                                 " as printed at an R that is exact, where only the condition number in zeta counts: more "
                                 "than 8 digits lost, or no number, at " +
                                 of(c.many_at_R, c.points) + ".");
    // No place: where a fraction of a digit is lost, the last places of the library's functions decide which is the worst.
    words = symbol + " as shipped loses beyond the condition number, anywhere: " + less_than(c.beyond.value) + ". ";
    words += c.shipped_none == 0 ? "It is a number everywhere" : "It is no number at " + of(c.shipped_none, c.points);
    if (c.below_range > 0)
        words += "; " + std::to_string(c.below_range) + " points, where it is below the range of double, are not counted";
    record.remarks.push_back(words + ".");
}

/// Condition numbers of u at the resonance, by R and by zeta. @return a sentence
std::string at_resonance() {
    const double zeta = std::ldexp(1.0, -20);
    const Place p = places(1, zeta)[1];
    return "u at R = 1, zeta = 2^-20: condition number " + text(p.by_R, "%.2g") + " in R (2 / zeta^2 is " +
           text(2 / (zeta * zeta), "%.2g") + "), " + (p.by_zeta < 1e-6 ? "below 1e-6" : text(p.by_zeta, "%.2g")) +
           " in zeta; as printed it loses " + text(p.printed, "%.0f") + " digits, as shipped " + less_than(p.shipped) + ".";
}

Record make(Figure& figure) {
    std::vector<Map> maps{wide(), near_one()};
    for (Map& map : maps) {
        fill(figure, map);
        add(figure, map);
    }
    Record record;
    record.title =
        "Digits that (23), (28), (29) lose in double over (R, zeta), as printed and as shipped, beside the condition number";
    record.equations = {"23", "28", "29"};
    record.chosen = {
        "R = 0.001 to 100, 186 values, logarithmic, those nearest to 1/n, n = 1 to 12, put on the double next to it; and R = 1 "
        "and 1 - x, 1 + x, x = 10^-15.5 to 10^-0.5, 61 values each",
        "zeta = 10^-16 to 10^-0.5, 63 values, and 1 - zeta = 10^-0.5 to 10^-16, 32 values, logarithmic; the last is the last "
        "double below 1",
        "digits lost: log10 of the relative error over 2^-53, for v of the complex number, against the shipped form in 50 digits",
        "condition number: relative change of the function over that of R or of zeta, the larger of the two, by differences in "
        "50 digits",
        "points of both maps are counted together"};
    for (std::size_t f = 0; f < 3; ++f) describe(record, f, count(maps, f));
    const double common = check(maps);
    record.remarks.push_back(at_resonance());
    record.remarks.push_back("The reference and the paper's forms in 100 digits have " +
                             (common > 17 ? "more than 17" : text(common, "%.0f")) +
                             " digits in common at every 23rd point, double has 16.");
    return record;
}

const Listed listed("digits_lost", make);

} // namespace denhartog::figures::map_of_digits_lost
