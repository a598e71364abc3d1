// Sections 4.3 and 5: what the text says damping does away from resonances and next to invariant points.
#include <algorithm>
#include <cmath>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/number/errors.hpp"
#include "derivation/observations/observed_systems.hpp"
#include "tests/support/invariant_points.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

namespace {

bool slides(const ModeSums<double>& m, double beta) {
    const std::size_t j = m.contact.index;
    return beta < paper::friction_ratio_limit(m.V[j], m.U[j], paper::static_friction_demand(m.H_j, 1.0, m.sum_of_squares));
}

constexpr double searched = 0.2; // how far from a frequency ratio a crossing is looked for, over it

/// Where the curves (52) of two friction ratios cross, nearest to a frequency ratio; none within a fifth of it.
std::optional<double> crossing(const ObservedSystem& s, std::size_t k, double beta_a, double beta_b, double near) {
    const auto difference = [&](double r) {
        const ModeSums<double> m = sums_at(s, r);
        if (!slides(m, beta_a) || !slides(m, beta_b)) return std::nan("");
        return monoharmonic_amplitude(m, k, beta_a) - monoharmonic_amplitude(m, k, beta_b);
    };
    std::optional<double> nearest;
    const int parts = 800;
    double a = (1 - searched) * near, D_a = difference(a);
    for (int n = 1; n <= parts; ++n) {
        const double b = near * (1 - searched + 2 * searched * n / parts), D_b = difference(b);
        if (D_a * D_b < 0) {
            double low = a, high = b;
            for (int step = 0; step < 50; ++step) {
                const double middle = (low + high) / 2;
                (difference(middle) * D_a > 0 ? low : high) = middle;
            }
            if (!nearest || std::abs(low - near) < std::abs(*nearest - near)) nearest = low;
        }
        a = b, D_a = D_b;
    }
    return nearest;
}

/// The crossings of the curves of mass 1 of Fig. 8 next to its invariant points without damping.
Outcome inversions() {
    Outcome outcome;
    const ObservedSystem undamped = observed_system("2DOF j=2 l=1", 0, two_masses(0.0));
    const std::vector<InvariantPoint<double>> points = tests::invariant_points_of(undamped.system, 0.1, 2.5)[0].points;
    Worst worst;
    long pairs = 0, without = 0;
    Witness lost;
    for (const double zeta : damping_ratios_of_figures()) {
        const ObservedSystem s = observed_system("2DOF j=2 l=1", zeta, two_masses(zeta));
        double below = 0;
        long below_without = 0;
        for (const InvariantPoint<double>& point : points) {
            const double limit = boundary(sums_at(s, point.r), 1.0).exact;
            double least = 1, largest = -1;
            long none = 0;
            for (const double a : {0.0, 0.125, 0.25, 0.5})
                for (const double b : {0.25, 0.5, 0.75}) {
                    if (b <= a) continue;
                    ++pairs;
                    const std::optional<double> r = crossing(s, 0, a * limit, b * limit, point.r);
                    if (!r) {
                        ++none, ++without;
                        lost = {{"system", s.name},
                                {"invariant point r", text(point.r)},
                                {"beta", text(a * limit) + " and " + text(b * limit)}};
                        continue;
                    }
                    const double shift = *r / point.r - 1;
                    least = std::min(least, shift), largest = std::max(largest, shift);
                    worst.take(std::abs(shift), [&] {
                        return Witness{{"system", s.name},
                                       {"invariant point r", text(point.r)},
                                       {"beta", text(a * limit) + " and " + text(b * limit)},
                                       {"crossing at r", text(*r)}};
                    });
                }
            const bool in_figure = point.r > 0.5;
            if (in_figure)
                outcome.steps.push_back({s.name + ", point at r = " + rounded(point.r) + ": " +
                                             (none == 9 ? "no pair of curves crosses"
                                                        : "crossings shifted by " + rounded(least) + " to " + rounded(largest) +
                                                              " of r, " + std::to_string(none) + " of 9 pairs do not cross"),
                                         ""});
            else if (none < 9)
                below = std::max(below, std::max(std::abs(least), std::abs(largest)));
            below_without += in_figure ? 0 : none;
        }
        outcome.steps.push_back({s.name + ", points at r = 0.1 to 0.5: largest shift " + rounded(below) + ", " +
                                     std::to_string(below_without) + " pairs do not cross",
                                 ""});
    }
    refute_above(outcome, without > 0 ? searched : worst.error,
                 {.what = "shift of a crossing over r", .taken = 0.05, .empty = searched});
    outcome.witness =
        with(without > 0 ? lost : worst.place, {{"largest shift", text(worst.error)},
                                                {"pairs of curves", std::to_string(pairs)},
                                                {"without a crossing within a fifth of r", std::to_string(without)}});
    return outcome;
}

/// Distance from the nearest natural frequency ratio, over it.
double distance_from_resonance(const ObservedSystem& s, double r) {
    double least = INFINITY;
    for (const double r_n : s.basis.r_n) least = std::min(least, std::abs(r / r_n - 1));
    return least;
}

constexpr double away = 0.2; // the distance from which on a frequency ratio is taken to be away from resonances

/// A system with all damping ratios put to zero.
ObservedSystem undamped(const ObservedSystem& s) {
    ObservedSystem without = s;
    std::ranges::fill(without.basis.zeta, 0.0);
    return without;
}

/// The steady state at a frequency ratio and half of the smaller boundary, with and without damping.
struct WithAndWithout {
    double r;
    SteadyState<double> with, without;
};

std::vector<WithAndWithout> away_from_resonances(const ObservedSystem& s) {
    std::vector<WithAndWithout> list;
    const ObservedSystem without = undamped(s);
    for (int n = 20; n <= 600; ++n) {
        const double r = n / 200.0;
        if (distance_from_resonance(s, r) < away) continue;
        try {
            const ModeSums<double> m = sums_at(s, r), m_0 = sums_at(without, r);
            const Boundary<double> b = boundary(m, 1.0), b_0 = boundary(m_0, 1.0);
            const double beta = std::min(b.exact, b_0.exact) / 2;
            list.push_back({r, steady_state(m, b, beta), steady_state(m_0, b_0, beta)});
        } catch (const DomainError&) { // a pole of (28) without damping
        }
    }
    return list;
}

/// Amplitudes of the closed form with all damping ratios put to zero, away from the resonances.
Outcome without_damping(bool of_contact, double threshold) {
    Outcome outcome;
    Worst worst;
    long tried = 0, above = 0;
    double farthest = 0, range_end = 0; // the largest distance with a larger change, and the largest that is looked at
    for (const ObservedSystem& s : systems_of_the_paper()) {
        Worst here;
        long tried_here = 0, above_here = 0;
        for (const WithAndWithout& at : away_from_resonances(s))
            for (std::size_t k = 0; k < at.with.masses.size(); ++k) {
                if ((k == s.system.contact.index) != of_contact) continue;
                const double X = at.with.masses[k].amplitude, X_0 = at.without.masses[k].amplitude, error = std::abs(X_0 / X - 1);
                ++tried_here;
                range_end = std::max(range_end, distance_from_resonance(s, at.r));
                above_here += error > threshold;
                if (error > threshold) farthest = std::max(farthest, distance_from_resonance(s, at.r));
                here.take(error, [&] {
                    return Witness{{"system", s.name},           {"r", text(at.r)},      {"mass", std::to_string(k + 1)},
                                   {"beta", text(at.with.beta)}, {"amplitude", text(X)}, {"without damping", text(X_0)}};
                });
            }
        if (tried_here == 0) continue;
        outcome.steps.push_back({s.name + ": " + std::to_string(above_here) + " of " + std::to_string(tried_here) +
                                     " off by more; largest relative error " + rounded(here.error) +
                                     " at r = " + rounded(std::stod(here.place[1].second)) + ", mass " + here.place[2].second,
                                 ""});
        worst.take(here.error, [&] { return here.place; });
        tried += tried_here, above += above_here;
    }
    refute_above(outcome, worst.error, {.what = "relative change of the amplitude", .taken = threshold, .empty = 1});
    if (above > 0)
        refute_above(outcome, farthest,
                     {.what = "distance from the nearest r_n,i, over it, r = 0.1 to 3", .taken = away, .empty = range_end});
    outcome.witness = with(worst.place, {{"relative error", text(worst.error)},
                                         {"amplitudes compared", std::to_string(tried)},
                                         {"off by more", std::to_string(above)}});
    return outcome;
}

const Register claims_of_damping_observations([] {
    const std::vector<std::string> range{"the paper's systems", "r = 0.1 to 3, a fifth or more from each r_n,i",
                                         "half of the smaller boundary", "mu = 1"};
    return std::vector<Claim>{
        observation("87/with-damping/text", {"87"},
                    "Observation in the text: with damping the curves of mass 1 still cross in a small region about each "
                    "invariant point; here: every pair, within 5 percent of r",
                    {"2DOF j=2 l=1", "zeta = 0.001, 0.01, 0.1", "invariant points of 0.1 < r < 2.5",
                     "friction ratios 0 to 3/4 of the boundary there", "scan in steps of r / 2000"},
                    inversions),
        observation("38/neglecting-damping/text", {"38"},
                    "Observation in the text: away from resonances damping may be left out; here: the amplitude of the contact "
                    "changes by less than 1 percent",
                    range, [] { return without_damping(true, 0.01); }),
        observation("52/neglecting-damping/text", {"52"},
                    "Observation in the text: away from resonances damping may be left out; here: the amplitudes of the other "
                    "masses change by less than 1 percent",
                    range, [] { return without_damping(false, 0.01); }),
    };
});

} // namespace
} // namespace denhartog::derivation
