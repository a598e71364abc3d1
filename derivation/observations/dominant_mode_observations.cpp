// Section 4.1: what the text says is large and what small at a natural frequency ratio, over the paper's systems.
#include <algorithm>
#include <cmath>

#include "derivation/observations/observed_systems.hpp"

namespace denhartog::derivation {

namespace {

using NumberAtResonance = std::function<double(const ModeSums<double>&, std::size_t, std::size_t)>;

/// Largest of a number over all masses and modes of the paper's systems at a damping ratio.
double largest_at(double zeta, const NumberAtResonance& error) {
    double largest = 0;
    for (const ObservedSystem& s : systems_of_the_paper(zeta))
        for (std::size_t i = 0; i < s.basis.r_n.size(); ++i) {
            const ModeSums<double> m = sums_at(s, s.basis.r_n[i]);
            for (std::size_t k = 0; k < s.basis.r_n.size(); ++k) largest = std::fmax(largest, error(m, k, i));
        }
    return largest;
}

/// Worst of a number over all masses and modes of the paper's systems, each at its natural frequency ratio.
Outcome at_resonances(const NumberAtResonance& error, double threshold, const std::string& what) {
    Outcome outcome;
    Worst worst;
    long tried = 0, above = 0;
    for (const double zeta : damping_ratios_of_figures()) {
        Worst here;
        for (const ObservedSystem& s : systems_of_the_paper())
            for (std::size_t i = 0; i < s.basis.r_n.size() && s.zeta == zeta; ++i) {
                const ModeSums<double> m = sums_at(s, s.basis.r_n[i]);
                for (std::size_t k = 0; k < s.basis.r_n.size(); ++k) {
                    const double e = error(m, k, i);
                    if (std::isnan(e)) continue;
                    ++tried;
                    above += e > threshold;
                    here.take(e, [&] { return place(s, k, i); });
                }
            }
        outcome.steps.push_back({"zeta = " + rounded(zeta) + ": " + what + ", largest: " + rounded(here.error) + ", " +
                                     here.place[0].second + ", mass " + here.place[1].second + ", mode " + here.place[2].second,
                                 ""});
        worst.take(here.error, [&] { return here.place; });
    }
    refute_above(outcome, worst.error, {.what = what + ", zeta up to 0.1", .taken = threshold, .empty = 1});
    if (outcome.verdict == Verdict::refuted)
        refute_below(outcome, damping_ratio_up_to([&](double zeta) { return largest_at(zeta, error); }, threshold),
                     {.what = "damping ratio up to which it is met", .taken = 0.1, .empty = 0});
    outcome.witness = with(
        worst.place, {{what, text(worst.error)}, {"cases", std::to_string(tried)}, {"above the bound", std::to_string(above)}});
    return outcome;
}

double others_over_term(const ModeSums<double>& m, std::size_t k, std::size_t i) {
    const double psi = mode_shapes_at(m, Mass{k})[i] * mode_shapes_at(m, m.load)[i] * m.R[i] * m.R[i];
    const Complex<double> term = psi * m.v[i];
    return modulus(Complex<double>{m.V[k].re - term.re, m.V[k].im - term.im}) / modulus(term);
}

double error_of_root(const ModeSums<double>& m, std::size_t k, std::size_t) {
    if (k != m.contact.index) return std::nan("");
    const double share = boundary(m, 1.0).exact * m.U[k] / modulus(m.V[k]);
    return 1 / std::sqrt(1 - share * share) - 1;
}

double first_over_second(const ModeSums<double>& m, std::size_t k, std::size_t) {
    return std::abs(m.U[k]) / std::min(std::abs(m.G[k]), modulus(m.V[k]));
}

const Register claims_of_dominant_mode_observations([] {
    const std::vector<std::string> paper{"r = r_n,i", "the paper's systems", "zeta = 0.001, 0.01, 0.1", "mu = 1"};
    return std::vector<Claim>{
        observation("76/dominant-mode/text", {"76", "80"},
                    "Observation in the text: next to a resonance its mode is much larger than the sum of the others in (33); "
                    "here: ten times as large",
                    paper, [] { return at_resonances(others_over_term, 0.1, "other modes over the resonant one"); }),
        observation("81/root/text", {"81"},
                    "Observation in the text: at resonance the root in (38) is |V_dj|; here: to 1 percent up to the boundary",
                    paper,
                    [] { return at_resonances(error_of_root, 0.01, "relative error of |V_dj| for the root at beta_lim"); }),
        observation(
            "82/first-function/text", {"82"},
            "Observation in the text: at resonance |V_dk| and |G_k| are much larger than |U_dk|; here: ten times as large", paper,
            [] { return at_resonances(first_over_second, 0.1, "|U_dk| over the smaller of |G_k| and |V_dk|"); }),
    };
});

} // namespace
} // namespace denhartog::derivation
