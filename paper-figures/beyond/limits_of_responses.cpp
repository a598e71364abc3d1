// (38) on its way to limits of the response: natural frequencies that merge, heavy and light masses, resonance next to the
// boundary, the boundary from both sides, chains of up to 200 masses. Digits of plain sums over modes in the paper's forms, of
// the library's sums and of `answer`, against the paper's forms in 100 digits with modes by a route of their own.
#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include "figure.hpp"
#include "response_paths.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::figures::limits_of_responses {

/// Digits at a point: float, double, long double, 50 digits.
struct Digits {
    std::array<double, 4> printed, shipped;
};

Digits digits_at(const Scene<double>& scene, const ModesAtContact<Real100>& modes, const Real100& X) {
    const auto printed = [&]<class T>(const T&) {
        return digits_kept(amplitude_of_contact(rounded<T>(modes), Forms::printed), X);
    };
    const auto library = [&]<class T>(const T&) { return digits_kept(amplitude_by_library(converted<T>(scene)), X); };
    // The library is not built for float and long double; its forms of the modes are.
    const auto shipped = [&]<class T>(const T&) {
        return digits_kept(amplitude_of_contact(rounded<T>(modes), Forms::shipped), X);
    };
    const bool large = modes.r_n.size() > 2; // an eigen-solve in 50 digits would take minutes
    const double in_50 = large ? shipped(Real50()) : library(Real50());
    return {{printed(float()), printed(double()), printed(0.0L), printed(Real50())},
            {shipped(float()), library(double()), shipped(0.0L), in_50}};
}

/// Findings on a path.
struct Found {
    std::array<double, 4> printed{99, 99, 99, 99}, shipped{99, 99, 99, 99}; ///< fewest digits
    double answered = 99;                                                   ///< fewest of `answer`
    double off = 0; ///< largest difference from the limit, relative, over x, where x is 2^-16 or less
};

Found follow(Figure& figure, const ResponsePath& path) {
    Table table{path.name, {"x", "pf", "pd", "pl", "p50", "sf", "sd", "sl", "s50", "answer"}, {}};
    Found found;
    for (const int k : path.steps) {
        const Scene<double> scene = path.scene(k);
        const ModesAtContact<Real100> modes = path.modes(scene);
        const Real100 X = amplitude_of_contact(modes, Forms::printed);
        const Digits d = digits_at(scene, modes, X);
        const double answered = std::min(16.0, digits_kept(answered_amplitude(scene), X)), x = std::ldexp(1, -k);
        std::vector<double> row{x};
        row.insert(row.end(), d.printed.begin(), d.printed.end());
        row.insert(row.end(), d.shipped.begin(), d.shipped.end());
        row.push_back(answered);
        table.rows.push_back(row);
        for (std::size_t t = 0; t < 4; ++t) {
            found.printed[t] = std::min(found.printed[t], d.printed[t]);
            found.shipped[t] = std::min(found.shipped[t], d.shipped[t]);
        }
        found.answered = std::min(found.answered, answered);
        if (k >= 16) found.off = std::max(found.off, static_cast<double>(Real100(abs(Real100(X / path.limit(scene) - 1)))) / x);
    }
    figure.add(table);
    return found;
}

std::string in_types(const std::array<double, 4>& digits) {
    std::string words;
    for (const double each : digits) words += (words.empty() ? "" : ", ") + text(std::floor(each), "%.0f");
    return words;
}

/// The four paths that have a limit in x.
void add_paths(Figure& figure, Record& record) {
    std::vector<ResponsePath> paths = paths_of_two_masses();
    paths.push_back(path_to_resonance_at_boundary());
    double off = 0, answered = 99;
    for (const ResponsePath& path : paths) {
        const Found found = follow(figure, path);
        off = std::max(off, found.off), answered = std::min(answered, found.answered);
        record.remarks.push_back(path.words + ", fewest digits in float, double, long double, 50 digits: printed " +
                                 in_types(found.printed) + "; shipped " + in_types(found.shipped) + ".");
    }
    record.statements.push_back({"(38) tends to the limits that the derivation has, on the four paths of (a) to (d)",
                                 off < 10 ? "relative difference below 10 x for x below 1e-4, in 100 digits"
                                          : "relative difference up to " + text(off, "%.1g") + " x",
                                 off < 10});
    record.statements.push_back({"`answer`, asked for 12 digits, has them at every point of these paths",
                                 "12 or more: " + std::string(answered >= 12 ? "everywhere" : "not everywhere"), answered >= 12});
}

/// beta -> beta_lim from both sides.
void add_boundary(Figure& figure, Record& record) {
    const AtBoundary b = boundary_of_single_mass();
    Table table{"boundary", {"x", "below", "above", "float", "double", "long double", "50 digits"}, {}};
    bool regimes = true;
    double off = 0;
    const ModesAtContact<Real100> modes = response_paths::modes_of_chain(single_mass_at(b.exact)->in_double());
    for (int e = -1; e >= -19; --e) {
        const Real100 x = pow(Real100(10), e);
        std::vector<double> row{static_cast<double>(x)};
        for (const int side : {-1, 1}) {
            const SolvedAmplitude s = solved_next_to(b, x, side, std::min(40, 8 - 2 * e));
            regimes = regimes && s.regime == (side < 0 ? Regime::continuous : Regime::stick_slip);
            row.push_back(static_cast<double>(Real100(abs(Real100(s.X / b.X - 1)))));
            if (e <= -4)
                off = std::max(off, std::abs(static_cast<double>(Real100(-side * (s.X - b.X) / (b.slope * x) - 1))) / row[0]);
        }
        const auto plain = [&]<class T>(const T&) {
            ModesAtContact<T> m = rounded<T>(modes);
            m.beta = static_cast<T>(Real100(b.exact * (1 - x)));
            const double difference =
                static_cast<double>(Real100(abs(Real100(Real100(amplitude_of_contact(m, Forms::printed)) / b.X - 1))));
            return difference > 0 ? difference : std::nan("");
        };
        row.insert(row.end(), {plain(float()), plain(double()), plain(0.0L), plain(Real50())});
        table.rows.push_back(row);
    }
    figure.add(table);
    record.statements.push_back({"For beta -> beta_lim the amplitude tends to beta_lim (S - G) from both sides, sliding below, "
                                 "stick-slip above, with one slope",
                                 regimes && off < 10
                                     ? "regimes as said down to 1e-19 off the boundary; the slopes differ by less than 10 x"
                                     : "not so: slopes off by " + text(off, "%.1g") + " x",
                                 regimes && off < 10});
}

/// (38) of a chain without end with load and contact on mass 1: integrals in place of the sums.
double amplitude_of_endless_chain(const Scene<double>& scene) {
    boost::math::quadrature::tanh_sinh<double> rule;
    const double r = *scene.r, zeta = scene.system.damping_ratios[0];
    const auto integral = [&](const std::function<double(const evaluation::ModeFunctions<double>&)>& part) {
        const auto integrand = [&](double theta) {
            const double half = std::sin(theta / 2),
                         cosine = std::cos(theta / 2); // sin^2 theta / lambda is their squares' product
            return half == 0 ? 0 : cosine * cosine * part(evaluation::mode_functions(r / (2 * half), zeta));
        };
        return 2 / pi<double>() * rule.integrate(integrand, 0.0, pi<double>(), 1e-13);
    };
    using Functions = evaluation::ModeFunctions<double>;
    const Complex<double> V{integral([](const Functions& f) { return f.v.re; }),
                            integral([](const Functions& f) { return f.v.im; })};
    return paper::displacement_transmissibility_of_contact(V, integral([](const Functions& f) { return f.u; }),
                                                           integral([](const Functions& f) { return f.g; }), *scene.beta);
}

void add_chains(Figure& figure, Record& record) {
    Table table{"chain", {"N", "pf", "pd", "pl", "p50", "sf", "sd", "sl", "s50"}, {}};
    std::array<double, 2> far{}, off{};
    const double endless = amplitude_of_endless_chain(chain_of(1, 1, 0.75, 0.125));
    Digits at_200{}, near_200{};
    for (const int N : {2, 3, 5, 7, 10, 14, 20, 32, 50, 71, 100, 141, 200}) {
        const Scene<double> scene = chain_of(N, 0, 3, 0), near = chain_of(N, 1, 0.75, 0.125);
        const ModesAtContact<Real100> modes = response_paths::modes_of_chain(scene);
        const Real100 X = amplitude_of_contact(modes, Forms::printed);
        at_200 = digits_at(scene, modes, X);
        std::vector<double> row{static_cast<double>(N)};
        row.insert(row.end(), at_200.printed.begin(), at_200.printed.end());
        row.insert(row.end(), at_200.shipped.begin(), at_200.shipped.end());
        table.rows.push_back(row);
        if (N != 100 && N != 200) continue;
        const ModesAtContact<Real100> near_modes = response_paths::modes_of_chain(near);
        const Real100 near_X = amplitude_of_contact(near_modes, Forms::printed);
        near_200 = digits_at(near, near_modes, near_X);
        far[N == 200] = static_cast<double>(X), off[N == 200] = std::abs(static_cast<double>(near_X) / endless - 1);
    }
    figure.add(table);
    record.statements.push_back({"With load and contact on mass 1 a chain of 200 masses has the amplitude of one without end",
                                 "relative difference from the integrals " + text(off[0], "%.1e") + " at N = 100, " +
                                     (off[1] < 1e-8 ? std::string("below 1e-8") : text(off[1], "%.1e")) + " at N = 200",
                                 off[1] < 1e-8});
    record.statements.push_back(
        {"Plain sums keep half of their digits or more at N = 200 with the load at the other end, r = 3",
         "the shipped ones in float, double, long double, 50 digits keep " + in_types(at_200.shipped),
         at_200.shipped[0] >= 3.6 && at_200.shipped[1] >= 8 && at_200.shipped[2] >= 9.6 && at_200.shipped[3] >= 25.5});
    record.remarks.push_back(
        "N = 200, load and contact on mass 1, r = 3/4, digits in float, double, long double, 50 digits: printed " +
        in_types(near_200.printed) + "; shipped " + in_types(near_200.shipped) + ".");
    record.remarks.push_back(
        "Load on mass 1, contact on the last, r = 3, beta = 0: from N = 100 to 200 the amplitude falls like N to "
        "the power of " +
        text(std::log2(far[1] / far[0]), "%.2f") + ".");
}

Record make(Figure& figure) {
    Record record;
    record.title = "Limits of the response: merging frequencies, mass ratios to 1e30, the boundary from both sides, 200 masses";
    record.equations = {"33", "34", "35", "38", "67"};
    record.chosen = {
        "(a) to (c): two masses, zeta = 1/16, r = 3/4, beta = 1/8; (a), (c): j = 1, l = 2; (b): j = l = 1",
        "(d): a single mass, beta rounded to double",
        "(e): a single mass, zeta = 1/16, r = 3/4, mu = 1",
        "(f): N equal masses and springs, zeta = 1/16, l = 1, j = N, r = 3, beta = 0",
        "printed: the paper's forms summed over modes without error, rounded to the type; shipped: the library's modes and "
        "sums, in float, and in (f) in 50 digits, the shipped forms on modes without error",
        "the truth: the paper's forms in 100 digits, modes of two masses by the quadratic equation, of a chain in closed "
        "form"};
    add_paths(figure, record);
    add_boundary(figure, record);
    add_chains(figure, record);
    return record;
}

const Listed listed("limits_of_responses", make);

} // namespace denhartog::figures::limits_of_responses
