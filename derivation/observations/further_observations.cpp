// Statements of the text, from all over the paper, that are decided by a search for a system in which they fail.
#include <algorithm>
#include <cmath>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/observations/contact_motions.hpp"
#include "derivation/observations/observed_systems.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

double degrees_from_multiple_of_pi(double angle) { return std::abs(wrapped(2 * angle)) / 2 * 180 / pi<double>(); }

/// The largest departure from phase and phase-opposition in equal chains, the load on the contact, next to no damping: a grid of
/// frequencies, then closer round its worst place.
Outcome in_phase_in_chains() {
    Outcome outcome;
    Worst worst;
    ObservedSystem worst_system;
    double r_of_worst = 0, beta_of_worst = 0;
    const auto look = [&](const ObservedSystem& s, double r, double fraction) {
        const ModeSums<double> m = sums_at(s, r);
        const Boundary<double> limit = boundary(m, 1.0);
        const double beta = fraction * limit.exact;
        if (!(beta > 0)) return;
        const SteadyState<double> state = steady_state(m, limit, beta);
        for (std::size_t k = 0; k < state.masses.size(); ++k) {
            const double angle = degrees_from_multiple_of_pi(state.masses[k].phase - state.phi_j);
            if (!(angle > worst.error)) continue;
            worst.take(angle, [&] {
                return Witness{{"system", s.name}, {"mass", std::to_string(k + 1)}, {"r", text(r)}, {"beta", text(beta)}};
            });
            worst_system = s;
            r_of_worst = r;
            beta_of_worst = fraction;
        }
    };
    for (const std::size_t N : {2, 3, 4, 5}) {
        const std::string name = std::to_string(N) + " equal masses and springs, j = l = 1,";
        const ObservedSystem s = observed_system(name, 1e-6, equal_chain<double>(N, 1, 1, std::vector<double>(N, 1e-6)));
        for (int n = 61; n <= 251; ++n)
            for (const double fraction : {0.25, 0.75}) look(s, n / 100.0 + 0.00317, fraction);
    }
    for (double width = 0.01; width > 1e-6; width /= 10)
        for (int n = -10; n <= 10; ++n) look(ObservedSystem(worst_system), r_of_worst + n * width / 10, beta_of_worst);
    const double found = worst.error > 89.999 ? 90 : worst.error; // the phase passes through a right angle there
    refute_above(outcome, found, {.what = "degrees from a multiple of 180", .taken = 15, .empty = 90});
    outcome.steps.push_back(
        {"Searched at 191 frequency ratios of each chain, then closer and closer round the worst of them", ""});
    outcome.witness = with(worst.place, {{"degrees from a multiple of 180", text(worst.error)}});
    return outcome;
}

/// The limit of the boundary; at a frequency that is high and finite the boundary of another contact is small and not zero.
Outcome only_the_loaded_mass_slides() {
    Outcome outcome;
    add_claim(outcome, "86/rates", "where the contact is on another mass the boundary tends to zero");
    add_claim(outcome, "86/limit/N=3", "where it is on the loaded mass the boundary tends to a positive number");
    const ObservedSystem s = observed_system("2DOF j=2 l=1", 0.001, two_masses(0.001));
    std::string line = s.name + ": at r = 10, 100, 1000 the contact still slides up to beta =";
    for (const double r : {10.0, 100.0, 1000.0}) line += " " + rounded(boundary(sums_at(s, r), 1.0).exact);
    outcome.steps.push_back({line, ""});
    outcome.witness = {{"system", s.name}, {"r", text(10.0)}, {"beta_lim", text(boundary(sums_at(s, 10), 1.0).exact)}};
    return outcome;
}

/// The other modes over the resonant one in (35), at the natural frequency of the latter.
double others_over_resonant(const ObservedSystem& s, std::size_t k, std::size_t i) {
    const ModeSums<double> m = sums_at(s, s.basis.r_n[i]);
    const double term = mode_shapes_at(m, Mass{k})[i] * mode_shapes_at(m, m.contact)[i] * m.R[i] * m.R[i] * m.g[i];
    return std::abs((m.G[k] - term) / term);
}

/// The other modes over the resonant one in (35), at the natural frequencies of the paper's systems.
Outcome dominant_in_second_function() {
    Outcome outcome;
    Worst worst;
    for (const ObservedSystem& s : systems_of_the_paper())
        for (std::size_t i = 0; i < s.basis.r_n.size(); ++i)
            for (std::size_t k = 0; k < s.basis.r_n.size(); ++k)
                worst.take(others_over_resonant(s, k, i), [&] { return place(s, k, i); });
    const double bound = 0.1;
    refute_above(outcome, worst.error,
                 {.what = "other modes over the resonant one in (35), zeta up to 0.1", .taken = bound, .empty = 1});
    const auto largest = [](double zeta) {
        double most = 0;
        for (const ObservedSystem& s : systems_of_the_paper(zeta))
            for (std::size_t i = 0; i < s.basis.r_n.size(); ++i)
                for (std::size_t k = 0; k < s.basis.r_n.size(); ++k) most = std::max(most, others_over_resonant(s, k, i));
        return most;
    };
    refute_below(outcome, damping_ratio_up_to(largest, bound),
                 {.what = "damping ratio up to which it is met", .taken = 0.1, .empty = 0});
    outcome.steps.push_back({"Every mass and mode of the paper's systems, at the natural frequency of the mode", ""});
    outcome.witness = with(worst.place, {{"other modes over the resonant one in (35)", text(worst.error)}});
    return outcome;
}

/// (69) squared has its demand in the denominator alone, as a square: whatever makes the demand larger makes (69) smaller.
Outcome static_friction_reduces() {
    Outcome outcome;
    const ex V_re = new_symbol("V_re", "V'", GiNaC::numeric(-2), GiNaC::numeric(2)),
             V_im = new_symbol("V_im", "V''", GiNaC::numeric(-2), GiNaC::numeric(2)),
             U = new_symbol("U_j", "U_j", GiNaC::numeric(-2), GiNaC::numeric(2)),
             demand = new_symbol("demand", "S", GiNaC::numeric(1, 10), GiNaC::numeric(2));
    const ex limit = paper::friction_ratio_limit(Complex<Symbolic>{Symbolic(V_re), Symbolic(V_im)}, Symbolic(U), Symbolic(demand))
                         .expression();
    const ex left = limit * limit * (U * U + demand * demand), right = V_re * V_re + V_im * V_im;
    add_statement(outcome, decide_equal(left, right, domain_of({left, right})).verdict,
                  "(69) squared, times the sum of the squares of U_j and of the demand, does not depend on the demand",
                  "\\beta_{\\lim}^2\\left(U_{dj}^2+S^2\\right)=|V_{dj}|^2");
    return outcome;
}

/// The stuck response of every mass where the load acts on the contact.
Outcome all_masses_rest() {
    Outcome outcome;
    Worst worst;
    for (const std::size_t N : {1, 2, 3, 5})
        for (std::size_t j = 1; j <= N; ++j) {
            const System<double> system = equal_chain<double>(N, j, j, std::vector<double>(N, 0.01));
            const ContactSystem s = contact_system(system);
            for (int n = 1; n <= 60; ++n) {
                const StuckResponse held = stuck_response(s.stuck, s.load, n / 20.0);
                for (const StuckMass& mass : held.masses)
                    worst.take(mass.amplitude, [&] {
                        return Witness{{"masses", std::to_string(N)}, {"j = l", std::to_string(j)}, {"r", text(n / 20.0)}};
                    });
            }
        }
    if (worst.error > 0) outcome.verdict = Verdict::refuted;
    outcome.steps.push_back({"No force acts on a mass that can move: the contact takes all of the load", ""});
    outcome.witness = with(worst.place, {{"largest amplitude", text(worst.error)}});
    return outcome;
}

const Register claims_of_further_observations([] {
    return std::vector<Claim>{
        observation("53/in-phase-in-chains/text", {"53"},
                    "Observation in the text: without damping and with the load on the contact all masses are in phase or in "
                    "phase-opposition; here: in equal chains of two to five masses, to 15 degrees",
                    {"zeta_i = 1e-6", "r = 0.61 to 2.51", "a quarter and three quarters of beta_lim"}, in_phase_in_chains),
        observation(
            "86/only-loaded-mass/text", {"69", "86"},
            "Observation in the text: at high frequencies only a contact on the loaded mass can slide throughout; here: for "
            "r -> infinity, at a friction ratio that is held",
            {"mu >= 1"}, only_the_loaded_mass_slides),
        observation("80/dominant-mode/text", {"35", "80"},
                    "Observation in the text: next to a resonance its mode is much larger than the sum of the others, in (35) as "
                    "in (33); here: ten times as large",
                    {"r = r_n,i", "the paper's systems", "zeta = 0.001, 0.01, 0.1"}, dominant_in_second_function),
        observation(
            "69/static-friction/text", {"69"},
            "Observation in the text: a larger ratio of static to kinetic friction reduces the region of continuous motion",
            {"H_j + mu / (gamma_j r^2) grows with mu"}, static_friction_reduces),
        observation("88/fully-stuck/text", {"88"},
                    "Observation in the text: with the load on the contact a stuck contact means that every mass is at rest",
                    {"chains of 1, 2, 3 and 5 equal masses", "r = 0.05 to 3"}, all_masses_rest),
    };
});

} // namespace
} // namespace denhartog::derivation
