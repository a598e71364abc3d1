// Section 4.2: what the text says of low frequency ratios. Stick-slip motions are periodic orbits of the exact solver.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "denhartog/orbit/periodic_orbit.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/observations/contact_motions.hpp"
#include "derivation/observations/observed_systems.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

namespace {

/// Both systems at r = 0.02 to 0.3.
const std::vector<GridPoint>& low_frequencies() {
    static const std::vector<GridPoint> grid = [] {
        std::vector<double> frequencies;
        for (int n = 1; n <= 15; ++n) frequencies.push_back(n / 50.0);
        return contact_over_grid(frequencies);
    }();
    return grid;
}

/// All of the low frequencies decide; what is left of the change at the lowest is a step.
Outcome amplitude_at_low_frequency() {
    const auto any = [](const ContactMotion&) { return true; };
    Outcome outcome = change_with_damping(low_frequencies(), any, 0.1);
    std::vector<GridPoint> lowest = low_frequencies();
    std::erase_if(lowest, [](const GridPoint& p) { return p.r > 0.1; });
    for (const Step& step : change_with_damping(lowest, any, 0.1).steps) outcome.steps.push_back({"r <= 0.1: " + step.text, ""});
    return outcome;
}

/// Stops a period at zeta = 0.001, 0.01, 0.1: whether more damping adds none in all pairs, or in most.
Outcome number_of_stops(bool in_all) {
    Outcome outcome;
    long fewer = 0, same = 0, more = 0;
    for (const GridPoint& p : low_frequencies()) {
        if (p.motions[0].rests || p.motions[1].rests || p.motions[2].rests) continue;
        for (std::size_t d = 1; d < p.motions.size(); ++d) {
            const std::size_t before = p.motions[d - 1].stops, after = p.motions[d].stops;
            fewer += after<before, same += after == before, more += after> before;
            if (after > before && outcome.witness.empty())
                outcome.witness = with(place(p), {{"zeta", text(damping_ratios_of_figures()[d - 1])},
                                                  {"stops", std::to_string(before)},
                                                  {"larger zeta", text(damping_ratios_of_figures()[d])},
                                                  {"stops with it", std::to_string(after)}});
        }
    }
    outcome.steps.push_back({"From zeta = 0.001 to 0.01 and from 0.01 to 0.1, r = 0.02 to 0.3: fewer stops a period in " +
                                 std::to_string(fewer) + " pairs, as many in " + std::to_string(same) + ", more in " +
                                 std::to_string(more),
                             ""});
    const ContactMotion* const fig_13 = [] {
        for (const GridPoint& p : low_frequencies())
            if (p.system == "SDOF" && std::abs(p.r - 0.1) < 1e-9 && p.beta == 0.2) return p.motions.data();
        throw std::logic_error("the grid lacks the point of Fig. 13");
    }();
    outcome.steps.push_back({"Fig. 13, r = 0.1, beta = 0.2: " + std::to_string(fig_13[0].stops) + ", " +
                                 std::to_string(fig_13[1].stops) + ", " + std::to_string(fig_13[2].stops) +
                                 " stops a period, amplitudes " + rounded(fig_13[0].X) + ", " + rounded(fig_13[1].X) + ", " +
                                 rounded(fig_13[2].X),
                             ""});
    const double share = static_cast<double>(fewer + same) / static_cast<double>(fewer + same + more);
    if (in_all)
        outcome.verdict = more > 0 ? Verdict::refuted : Verdict::unknown;
    else
        refute_below(outcome, fewer > 0 ? share : 0, {.what = "share of the pairs without more stops", .taken = 0.5, .empty = 0});
    outcome.witness = with(outcome.witness,
                           {{"fewer", std::to_string(fewer)}, {"as many", std::to_string(same)}, {"more", std::to_string(more)}});
    return outcome;
}

/// The largest velocity of the contact over the steady motion from rest of a single mass at the point of Fig. 13.
double largest_velocity(double zeta) {
    const ContactSystem system = contact_system(single_mass(zeta));
    ExactSolver solver(system, {0.1, 0.2, 1});
    OrbitSearch search;
    search.contact_only = true;
    search.with_stability = false;
    const PeriodicOrbit orbit = periodic_orbit(solver, at_rest(1), search);
    if (orbit.status != OrbitStatus::periodic) throw std::logic_error("no steady motion: " + in_words(orbit.reason));
    const std::vector<Phase> phases = solver.run(orbit.start, 0, 2 * pi<double>()).phases;
    double largest = 0;
    for (std::size_t n = 0; n < phases.size(); ++n)
        for (int part = 0; part <= 64; ++part) {
            const double tau = phases[n].start + (phases[n].end - phases[n].start) * part / 64;
            largest = std::max(largest, std::abs(solver.state_at(n, tau).x_prime[0]));
        }
    return largest;
}

Outcome smoother_motion() {
    Outcome outcome;
    std::string line = "SDOF, r = 0.1, beta = 0.2: largest velocity at zeta = 0.001, 0.01, 0.1:";
    for (const double zeta : damping_ratios_of_figures()) line += " " + rounded(largest_velocity(zeta));
    outcome.steps.push_back({line, ""});
    const double fall = 1 - largest_velocity(0.1) / largest_velocity(0.001);
    refute_below(outcome, fall, {.what = "fall of the largest velocity from zeta = 0.001 to 0.1", .taken = 0.1, .empty = 0});
    outcome.witness = {{"fall of the largest velocity", text(fall)}};
    return outcome;
}

/// (69) is at most |V_dj| gamma_j r^2 / mu, and |V_dj| tends to a static flexibility.
Outcome boundary_at_low_frequency() {
    Outcome outcome;
    add_claim(outcome, "64/not-negative", "H_j is not negative");
    outcome.steps.push_back(
        {"The demand in (69) is at least mu / (gamma_j r^2), and V_dj tends to the displacement under a static load",
         "\\beta_{\\lim}\\le\\frac{\\gamma_jr^2}{\\mu}|V_{dj}|\\to 0"});
    for (const ObservedSystem& s : systems_of_the_paper())
        if (s.basis.r_n.size() <= 2) {
            std::string line = s.name + ": beta_lim / r^2 at r = 0.1, 0.01, 0.001:";
            for (const double r : {0.1, 0.01, 0.001}) line += " " + rounded(boundary(sums_at(s, r), 1.0).exact / (r * r));
            outcome.steps.push_back({line, ""});
        }
    return outcome;
}

const Register claims_of_low_frequency_observations([] {
    const std::vector<std::string> low{"SDOF and 2DOF j=2 l=1", "r = 0.02 to 0.3 in steps of 0.02", "beta = 0.02 to 0.8",
                                       "mu = 1"};
    return std::vector<Claim>{
        observation("69/low-frequency/text", {"69"}, "Observation in the text: (69) tends to zero for r -> 0", {"mu >= 1"},
                    boundary_at_low_frequency),
        observation("38/low-frequency/text", {"38", "69"},
                    "Observation in the text: damping hardly changes the amplitude at low frequencies, stick-slip included; "
                    "here: that of the contact by less than a tenth",
                    low, amplitude_at_low_frequency),
        observation("74/stops/text", {"74"},
                    "Observation in the text: damping can reduce the number of stops at low frequencies, in most cases; here: it "
                    "does in some, and adds none in more than half",
                    low, [] { return number_of_stops(false); }),
        observation(
            "74/smoothing/text", {"74"},
            "Observation in the text: damping smooths the motion of Fig. 13, most of all at zeta = 0.1; here: the largest "
            "velocity falls by a tenth at least",
            {"SDOF", "r = 0.1", "beta = 0.2", "mu = 1"}, smoother_motion),
        observation("74/never-more-stops", {"74"}, "More damping never adds a stop at low frequencies", low,
                    [] { return number_of_stops(true); }),
    };
});

} // namespace
} // namespace denhartog::derivation
