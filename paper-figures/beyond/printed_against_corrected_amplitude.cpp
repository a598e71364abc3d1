// (50), (52), (81), (82) as printed and as corrected, with the paper's algorithm as the witness.
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "peak.hpp"
#include "sweep.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::printed_against_corrected_amplitude {

const double zeta = 0.1;
const Mass first{0};
const std::vector<std::string> columns{"corrected", "(52) as printed", "(50) as printed, with (51)"};

/// The amplitude of the first mass: (52), (52) as printed, (50) as printed with (51). None where the contact does not slide.
std::vector<double> amplitudes(const WithModes& s, double r, double beta) {
    const ModeSums<double> sums = s.at(r);
    const std::size_t k = first.index, j = sums.contact.index;
    if (beta >= boundary(sums, 1.0).exact) return {std::nan(""), std::nan(""), std::nan("")};
    const double cosine = as_printed::monoharmonic_cosine(sums.V[k], sums.V[j], sums.U[j], sums.G[k], beta);
    const double sine = paper::monoharmonic_sine(sums.V[k], sums.V[j], sums.U[j], sums.U[k], beta);
    return {paper::displacement_transmissibility(sums.V[k], sums.V[j], sums.U[j], sums.U[k], sums.G[k], beta),
            as_printed::displacement_transmissibility(sums.V[k], sums.V[j], sums.U[j], sums.U[k], sums.G[k], beta),
            std::hypot(cosine, sine)};
}

/// Estimates at the first resonance: (81), (82), then both as printed, with (77), (80), and with U from (34).
std::vector<double> estimates(const WithModes& s, double beta) {
    const ModeSums<double> sums = s.at(s.basis.r_n[0]);
    const std::size_t k = first.index, j = sums.contact.index;
    const double psi_k = s.psi(first, 0), psi_j = s.psi(sums.contact, 0), psi_l = s.psi(sums.load, 0);
    const double V = paper::complex_response_amplitude_at_resonance(psi_k, psi_l, s.basis.zeta[0]);
    const double G = evaluation::second_damping_function_at_resonance(psi_k, psi_j, s.basis.zeta[0]);
    const Complex<double> complex_V = paper::complex_response_at_resonance(psi_k, psi_l, s.basis.zeta[0]);
    return {paper::transmissibility_at_resonance(V, sums.U[k], sums.U[j], G, psi_k, psi_j, beta),
            paper::transmissibility_at_resonance_without_U(V, G, beta),
            as_printed::transmissibility_at_resonance(V, sums.U[k], sums.U[j], G, beta),
            as_printed::transmissibility_at_resonance_without_U(complex_V, G, beta)};
}

/// Friction ratios of the markers. @param limit they are below it
std::vector<double> steps_below(double limit) {
    std::vector<double> betas;
    for (int n = 1; n < 40 * limit; ++n) betas.push_back(n / 40.0);
    return betas;
}

using Differences = std::vector<std::pair<double, std::string>>;

/// Markers over r and beta, as tables; their relative differences from each of the three curves while the contact slides.
std::vector<Differences> witness(Figure& figure, const WithModes& s, const std::string& name, const std::vector<double>& r,
                                 const std::vector<double>& betas) {
    Table table{name, {"r", "beta", "X"}, {}};
    std::vector<Differences> off(3);
    for (const Comparison& c : compared(figure, s.system, first, sweeps(s.system, first, r, betas))) {
        if (c.regime != Regime::continuous) continue;
        table.rows.push_back({c.r, c.beta, c.X});
        const std::vector<double> lines = amplitudes(s, c.r, c.beta);
        for (std::size_t n = 0; n < lines.size(); ++n)
            if (!std::isnan(lines[n])) off[n].emplace_back(lines[n] / c.X - 1, where(c));
    }
    figure.add(table);
    return off;
}

/// Curves of (50) and (52) and what the markers say of each.
void curves(Figure& figure, Record& record, const WithModes& s, const std::string& panel, const std::vector<double>& r,
            const std::vector<double>& betas, const std::vector<Differences>& off) {
    Table table{panel, {"r", "beta", "(52)", "(52) as printed", "(50) as printed"}, {}};
    for (const double each : r)
        for (const double beta : betas) {
            table.rows.push_back({each, beta});
            const std::vector<double> X = amplitudes(s, each, beta);
            table.rows.back().insert(table.rows.back().end(), X.begin(), X.end());
        }
    figure.add(table);
    for (std::size_t n = 0; n < off.size(); ++n)
        record.agreements.push_back(
            agreement("(" + panel + ") " + (n == 0 ? "(52) as corrected" : columns[n]) + ", relative to the markers", off[n]));
    const double corrected = record.agreements[record.agreements.size() - 3].worst;
    for (std::size_t n = 1; n < off.size(); ++n) {
        const Agreement& printed = record.agreements[record.agreements.size() - 3 + n];
        record.statements.push_back({"(" + panel + ") " + columns[n] + " gives the amplitude as well as (52) as corrected does",
                                     "at most " + text(100 * printed.worst, "%.3g") + " percent from the markers (" +
                                         printed.where + "), as corrected " + text(100 * corrected, "%.3g"),
                                     printed.worst <= 2 * corrected});
    }
}

Record make(Figure& figure) {
    Record record;
    record.title = "Amplitudes as printed and as corrected: (50), (52), (81), (82)";
    record.equations = {"50", "51", "52", "81", "82"};
    record.given = {"2DOF of Figs. 8 and 9: j = 2, l = 1, equal masses and springs, zeta_i = 0.1 / r_n,i, mu = 1",
                    "200 periods from rest, absolute tolerance 1e-6"};
    const WithModes s(two_masses(zeta));
    const double beta_a = 0.25, r_b = 0.9, limit_b = boundary(s.at(r_b), 1.0).exact;
    const double r_c = s.basis.r_n[0], limit_c = boundary(s.at(r_c), 1.0).exact;
    record.chosen = {"(a) over r, beta = " + text(beta_a), "(b) over beta, r = " + text(r_b),
                     "(c) over beta at r_n,1 = " + text(r_c) + ", (77) and (80) with U from (34)",
                     "mass 1, which the contact is not on"};

    const std::vector<double> markers_r = spaced(0.4, 1.9, 31);
    const auto off_a = witness(figure, s, "markers a", markers_r, {beta_a});
    curves(figure, record, s, "a", spaced(0.4, 1.9, 601), {beta_a}, off_a);
    const auto off_b = witness(figure, s, "markers b", {r_b}, steps_below(limit_b));
    curves(figure, record, s, "b", {r_b}, spaced(0, 0.9999 * limit_b, 201), off_b);

    Table table{"c", {"beta", "(52)", "(81)", "(82)", "(81) as printed", "(82) as printed"}, {}};
    for (const double beta : spaced(0, 0.9999 * limit_c, 201)) {
        table.rows.push_back({beta, amplitudes(s, r_c, beta)[0]});
        const std::vector<double> X = estimates(s, beta);
        table.rows.back().insert(table.rows.back().end(), X.begin(), X.end());
    }
    figure.add(table);
    Table seen{"markers c", {"beta", "X"}, {}};
    std::vector<Differences> off(4);
    for (const Comparison& c : compared(figure, s.system, first, sweeps(s.system, first, {r_c}, steps_below(limit_c)))) {
        seen.rows.push_back({c.beta, c.X});
        const std::vector<double> X = estimates(s, c.beta);
        for (std::size_t n = 0; n < X.size(); ++n) off[n].emplace_back(X[n] / c.X - 1, where(c));
    }
    figure.add(seen);
    for (const std::size_t n : {0U, 1U}) {
        const std::string name = n == 0 ? "(81)" : "(82)";
        const Agreement corrected = agreement("(c) " + name + " as corrected, relative to the markers", off[n]);
        const Agreement printed = agreement("(c) " + name + " as printed, relative to the markers", off[n + 2]);
        record.agreements.push_back(corrected);
        record.agreements.push_back(printed);
        record.statements.push_back({"(c) " + name + " as printed is as near to the amplitude as it is as corrected",
                                     "at most " + text(100 * printed.worst, "%.3g") + " percent from the markers (" +
                                         printed.where + "), as corrected " + text(100 * corrected.worst, "%.3g"),
                                     printed.worst <= corrected.worst});
    }
    const std::vector<double> at_zero = estimates(s, 0), at_limit = estimates(s, limit_c);
    record.statements.push_back({"Friction lowers the peak; (c) at the boundary against zero friction",
                                 "(82) as corrected: " + text(at_zero[1]) + " falls to " + text(at_limit[1]) +
                                     "; as printed it goes to " + text(at_limit[3]),
                                 at_limit[1] < at_zero[1]});
    record.remarks = {"(52) as printed has no real value at " + std::to_string(off_a[0].size() - off_a[1].size()) + " of the " +
                          std::to_string(off_a[0].size()) + " markers of (a), at " +
                          std::to_string(off_b[0].size() - off_b[1].size()) + " of the " + std::to_string(off_b[0].size()) +
                          " of (b); they are left out of its differences.",
                      "The contact slides throughout up to beta = " + text(limit_b) + " in (b) and " + text(limit_c) +
                          " in (c); no line is drawn beyond.",
                      "In (a) the lines have a gap where the contact stops.",
                      "(52) is the amplitude of the harmonic part; the markers are the largest displacement."};
    return record;
}

const Listed listed("printed_against_corrected_amplitude", make);

} // namespace denhartog::figures::printed_against_corrected_amplitude
