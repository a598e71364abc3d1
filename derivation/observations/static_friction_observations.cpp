// Sections 2.1, 2.6 and 3.1: what static friction changes and what it does not, and where the contact rests in stick-slip.
#include <algorithm>
#include <cmath>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/observations/observed_systems.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

/// Amplitudes, and the boundary beside them, with the ratio of static to kinetic friction as a symbol.
Outcome without_static_friction() {
    const Symbols& s = symbols();
    const Complex<Symbolic> V_j = symbolic_V_j(), V_k = symbolic_V_k();
    const Symbolic U_j(s.U_j), U_k(s.U_k), G_j(s.G_j), G_k(s.G_k), beta(s.beta), H(s.H), mu(s.mu), r(s.r), gamma(s.gamma);
    const std::vector<std::pair<std::string, ex>> of_motion{
        {"(38)", paper::displacement_transmissibility_of_contact(V_j, U_j, G_j, beta).expression()},
        {"(39)", paper::phase_of_contact(V_j, U_j, beta).expression()},
        {"(52)", paper::displacement_transmissibility(V_k, V_j, U_j, U_k, G_k, beta).expression()}};
    Outcome outcome;
    for (const auto& [name, e] : of_motion)
        add_statement(outcome, e.has(s.mu) ? Verdict::refuted : Verdict::proved, name + " has no mu in it", latex(e));
    const ex demand = paper::static_friction_demand(H, mu, Symbolic(1) / (gamma * r * r)).expression();
    add_statement(outcome, demand.has(s.mu) ? Verdict::proved : Verdict::refuted, "The demand in (67) has", latex(demand));
    ++altered_statements_refuted(); // that the demand has none either
    return outcome;
}

/// A steady motion that the exact solver finds from rest.
PeriodicOrbit orbit_from_rest(const ContactSystem& system, double r, double beta, double mu) {
    ExactSolver solver(system, {r, beta, mu});
    OrbitSearch search;
    search.contact_only = true;
    return periodic_orbit(solver, at_rest(system.basis.r_n.size()), search);
}

/// A stable motion of a single mass that does not mirror itself.
Outcome asymmetric_motion() {
    const double zeta = 0.03125, r = 0.5, beta = 0.1875, mu = 2;
    const PeriodicOrbit orbit = orbit_from_rest(contact_system(single_mass(zeta)), r, beta, mu);
    Outcome outcome;
    outcome.witness = {{"system", "SDOF"},   {"zeta", text(zeta)}, {"r", text(r)},
                       {"beta", text(beta)}, {"mu", text(mu)},     {"stops a period", std::to_string(orbit.stops.size())}};
    outcome.steps.push_back({"The exact solver from rest; the contact stops at one end of the motion alone", ""});
    if (orbit.status == OrbitStatus::periodic && !orbit.symmetric && orbit.stable &&
        orbit.error_bound < 1e-9 * orbit.contact.amplitude)
        outcome.verdict = Verdict::refuted;
    return outcome;
}

/// A friction ratio at which a single mass slides throughout in one steady motion and rests for ever in another.
Outcome two_steady_motions() {
    const double zeta = 0.01, r = 1, beta = 0.6, mu = 2;
    const ObservedSystem s = observed_system("SDOF", zeta, single_mass(zeta));
    const Boundary<double> limits = boundary(sums_at(s, r), mu);
    const PeriodicOrbit orbit = orbit_from_rest(contact_system(s.system), r, beta, mu);
    Outcome outcome;
    outcome.witness = {{"system", s.name},
                       {"r", text(r)},
                       {"beta", text(beta)},
                       {"mu", text(mu)},
                       {"slides below", text(limits.exact)},
                       {"can rest from", text(*limits.sticking)}};
    outcome.steps.push_back(
        {"Below beta_lim the motion (46) slides throughout; from beta*_lim on a contact at rest stays at rest, "
         "as the exact solver finds from rest",
         ""});
    if (beta < limits.exact && beta > *limits.sticking && orbit.status == OrbitStatus::permanently_stuck)
        outcome.verdict = Verdict::refuted;
    return outcome;
}

/// Steady motions with stops over the ranges of Figs. 6 to 10: whether the contact rests where its displacement is largest.
Outcome largest_at_a_stop() {
    Outcome outcome;
    long motions = 0, at_stop = 0;
    Witness other;
    for (const ObservedSystem& s : systems_of_the_paper()) {
        if (s.basis.r_n.size() > 2) continue;
        const ContactSystem system = contact_system(s.system);
        for (int n = 1; n <= 25; ++n)
            for (const double beta : {0.05, 0.1, 0.2, 0.4, 0.6, 0.8}) {
                const double r = n / 10.0;
                const PeriodicOrbit orbit = orbit_from_rest(system, r, beta, 1);
                if (orbit.status != OrbitStatus::periodic || orbit.stops.empty()) continue;
                ++motions;
                const bool rests = std::ranges::any_of(
                    orbit.stops, [&](const Stop& stop) { return std::abs(stop.x) > orbit.contact.amplitude * (1 - 1e-9); });
                at_stop += rests;
                if (!rests) other = {{"not in", s.name}, {"r", text(r)}, {"beta", text(beta)}};
            }
    }
    const double share = static_cast<double>(at_stop) / static_cast<double>(motions);
    refute_below(outcome, share, {.what = "share of the motions with stops", .taken = 0.5, .empty = 0});
    outcome.steps.push_back({"SDOF and 2DOF of Figs. 6 to 10, r = 0.1 to 2.5, the exact solver from rest", ""});
    outcome.witness = with(
        other, {{"motions with stops", std::to_string(motions)}, {"largest displacement at a stop", std::to_string(at_stop)}});
    return outcome;
}

const Register claims_of_static_friction_observations([] {
    return std::vector<Claim>{
        observation(
            "38/independent-of-mu/text", {"38", "39", "52", "67"},
            "Observation in the text: the ratio of static to kinetic friction has no part in the motion without stops, but "
            "in its boundary",
            {"sliding regime"}, without_static_friction),
        observation("25/symmetric-for-any-mu", {"3", "25"}, "For mu > 1 the steady motion mirrors itself after half a period",
                    {"the contact sticks and slips"}, asymmetric_motion),
        observation("25/unique-for-any-mu", {"3", "69", "88"}, "For mu > 1 there is one steady motion alone", {"N = 1"},
                    two_steady_motions),
        observation("74/largest-at-a-stop/text", {"74"},
                    "Observation in the text: in stick-slip the largest displacement of the contact usually is a stop; here: in "
                    "more than half of the motions",
                    {"SDOF and 2DOF j=2 l=1", "zeta = 0.001, 0.01, 0.1", "mu = 1"}, largest_at_a_stop),
    };
});

} // namespace
} // namespace denhartog::derivation
