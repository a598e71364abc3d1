// Section 4.3: what the text says of stuck configurations and of invariant points, by sweeps and searches.
#include <algorithm>
#include <cmath>

#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "derivation/observations/observation.hpp"
#include "derivation/observations/observed_systems.hpp"
#include "derivation/observations/stuck_systems.hpp"
#include "tests/support/invariant_points.hpp"

namespace denhartog::derivation {

namespace {

Witness place(const StuckSystem& s, double r) { return {{"system", s.name}, {"r", text(r)}}; }

Outcome stuck_modes() {
    Outcome outcome;
    const StuckSystem* worst = nullptr;
    for (const StuckSystem& s : stuck_systems()) {
        outcome.steps.push_back({s.name + ": " + std::to_string(s.stuck.masses.size()) + " stuck modes, " +
                                     (s.stuck.modes_diagonalise_damping ? "uncoupled" : "coupled") +
                                     ", largest |D_ik| / sqrt(D_ii D_kk) = " + rounded(largest_coupling(s.stuck.damping)),
                                 ""});
        if (!s.stuck.modes_diagonalise_damping &&
            (worst == nullptr || largest_coupling(s.stuck.damping) > largest_coupling(worst->stuck.damping)))
            worst = &s;
    }
    outcome.witness = {{"systems", std::to_string(stuck_systems().size())}};
    if (worst == nullptr) return outcome;
    outcome.verdict = Verdict::refuted;
    outcome.witness =
        with(outcome.witness, {{"system", worst->name}, {"largest coupling", text(largest_coupling(worst->stuck.damping))}});
    return outcome;
}

/// Largest amplitude beyond the contact over the largest before it, over a sweep.
Outcome far_side_at_rest() {
    Outcome outcome;
    double largest = 0, at = 0;
    const StuckSystem* worst = nullptr;
    for (const StuckSystem& s : stuck_systems()) {
        const std::size_t j = s.system.contact.index;
        if (s.system.load == s.system.contact) continue;
        for (int n = 1; n <= 600; ++n) {
            const double r = n / 200.0;
            const StuckResponse response = stuck_response(s.stuck, s.system.load, r);
            double near = 0, far = 0;
            for (std::size_t k = 0; k < response.masses.size(); ++k) {
                double& largest_there = (k < j) == (s.system.load.index < j) ? near : far;
                largest_there = std::max(largest_there, response.masses[k].amplitude);
            }
            if (far > largest * near) {
                largest = far / near;
                at = r;
                worst = &s;
            }
        }
    }
    outcome.steps.push_back(
        {"The damping matrix (19) couples the masses on both sides of the contact; largest amplitude beyond it over "
         "the largest on the load's side, r = 1/200 to 3: " +
             rounded(largest),
         ""});
    if (largest < 1e-9 || worst == nullptr) return outcome;
    outcome.verdict = Verdict::refuted;
    outcome.witness = with(place(*worst, at), {{"ratio of amplitudes", text(largest)}});
    return outcome;
}

/// (88) and its parts over all systems.
Outcome measured_88() {
    Outcome outcome;
    double worst_error = 0;
    for (const StuckSystem& s : stuck_systems()) {
        const WorstOfSweep all = worst_over_r(s, [](const StickingBoundary& b) { return *b.paper; });
        const WorstOfSweep force = worst_over_r(s, [](const StickingBoundary& b) { return b.without_damping_load; });
        outcome.steps.push_back({s.name + ": (88) over exact " + rounded(all.ratio) + " at r = " + rounded(all.r) +
                                     "; the damping forces on the contact alone left out: " + rounded(force.ratio) +
                                     " at r = " + rounded(force.r),
                                 ""});
        if (all.error <= worst_error) continue;
        worst_error = all.error;
        outcome.witness = with(place(s, all.r), {{"(88) over exact", text(all.ratio)}});
    }
    if (worst_error > 1e-9) outcome.verdict = Verdict::refuted;
    outcome.witness.emplace_back("systems", std::to_string(stuck_systems().size()));
    return outcome;
}

/// The relative error of (88) at a resonance of the masses beyond the contact, as damping goes to zero.
Outcome small_damping() {
    Outcome outcome;
    double least = 1;
    for (const double zeta : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        const StuckSystem s = equal_chain(5, 3, 5, zeta);
        const double r = s.stuck.r_n[1]; // a mode of the first two masses, the load on the last
        const StickingBoundary b = *sticking_at(s, r);
        outcome.steps.push_back({s.name + ", r = " + rounded(r) + ": (88) over exact " + rounded(*b.paper / b.exact), ""});
        if (std::abs(*b.paper / b.exact - 1) < least) {
            least = std::abs(*b.paper / b.exact - 1);
            outcome.witness = with(place(s, r), {{"(88) over exact", text(*b.paper / b.exact)}});
        }
    }
    if (least > 0.01) outcome.verdict = Verdict::refuted;
    return outcome;
}

/// The boundary at a high frequency ratio, with and without damping.
Outcome high_frequency() {
    Outcome outcome;
    double worst = 0;
    for (const StuckSystem& s : stuck_systems()) {
        if (s.system.load == s.system.contact) continue;
        System<double> undamped = s.system;
        std::fill(undamped.damping_ratios.begin(), undamped.damping_ratios.end(), 0.0);
        const StuckConfiguration stuck = stuck_configuration(undamped, modal_basis(undamped));
        const double r = 20, with_damping = sticking_at(s, r)->exact;
        const double without = modulus(stuck_response(stuck, undamped.load, r).contact_load);
        outcome.steps.push_back({s.name + ", r = 20: beta*_lim " + rounded(with_damping) + ", undamped " + rounded(without), ""});
        if (with_damping / without <= worst) continue;
        worst = with_damping / without;
        outcome.witness = with(place(s, r), {{"beta*_lim", text(with_damping)}, {"undamped", text(without)}});
    }
    refute_above(outcome, worst - 1, {.what = "relative change of the boundary at r = 20", .taken = 0.1, .empty = 1});
    return outcome;
}

ModeSums<double> sums_of(const StuckSystem& s, const std::vector<double>& zeta, double r) {
    ModalBasis<double> basis = s.basis;
    basis.zeta = zeta;
    return mode_sums(basis, s.system.contact, s.system.load, r);
}

/// (52) squared is |V_k|^2 + 2 beta root(beta) a + beta^2 b: it does not depend on beta where both a and b are zero.
std::pair<double, double> dependence_on_friction(const ModeSums<double>& m, std::size_t k) {
    const std::size_t j = m.contact.index;
    const double Delta = argument(m.V[k]) - argument(m.V[j]), ratio = modulus(m.V[k]) / modulus(m.V[j]);
    const double C = std::cos(Delta), S = std::sin(Delta), G = m.G[k], U = m.U[k];
    return {G * C - U * S, G * G + U * U - 2 * ratio * m.U[j] * (G * S + U * C)};
}

/// Newton's method for r and zeta_2 with zeta_1 given.
Outcome damped_invariant_point() {
    const StuckSystem s = equal_chain(2, 2, 1, 0);
    const double zeta_1 = 0.01, h = 1e-7;
    double r = 0.828, zeta_2 = 0.0014;
    const auto f = [&](double at, double zeta) { return dependence_on_friction(sums_of(s, {zeta_1, zeta}, at), 0); };
    for (int n = 0; n < 20; ++n) {
        const auto [a, b] = f(r, zeta_2);
        const auto [a_r, b_r] = f(r + h, zeta_2);
        const auto [a_z, b_z] = f(r, zeta_2 + h * zeta_1);
        const double A = (a_r - a) / h, B = (a_z - a) / (h * zeta_1), C = (b_r - b) / h, D = (b_z - b) / (h * zeta_1);
        r -= (a * D - b * B) / (A * D - B * C);
        zeta_2 -= (A * b - C * a) / (A * D - B * C);
    }
    const ModeSums<double> m = sums_of(s, {zeta_1, zeta_2}, r);
    const double limit = boundary(m, 1.0).exact;
    Outcome outcome;
    double spread = 0;
    for (const double fraction : {0.125, 0.25, 0.5, 0.75, 0.96875})
        spread = std::max(spread, std::abs(monoharmonic_amplitude(m, 0, fraction * limit) / modulus(m.V[0]) - 1));
    outcome.witness = {{"system", "2DOF j=2 l=1"},
                       {"mass", "1"},
                       {"r", text(r)},
                       {"zeta_1", text(zeta_1)},
                       {"zeta_2", text(zeta_2)},
                       {"amplitude", text(modulus(m.V[0]))},
                       {"spread over beta", text(spread)}};
    outcome.steps.push_back(
        {"Both factors of beta in (52) vanish: two conditions for r and the ratio of the damping ratios", ""});
    if (zeta_2 > 0 && spread < 1e-12) outcome.verdict = Verdict::refuted;
    return outcome;
}

/// The points of mass 1 of the paper's system of two masses, undamped, over the frequency ratios of its figures.
std::vector<InvariantPoint<double>> points_of_first_mass() {
    return tests::invariant_points_of(equal_chain(2, 2, 1, 0).system, 0.1, 2.5)[0].points;
}

Outcome all_by_87() {
    Outcome outcome;
    const StuckSystem s = equal_chain(2, 2, 1, 0);
    const std::vector<InvariantPoint<double>> points = points_of_first_mass();
    long others = 0;
    for (const InvariantPoint<double>& point : points) {
        const ModeSums<double> m = sums_of(s, {0, 0}, point.r);
        const double limit = boundary(m, 1.0).exact;
        double spread = 0;
        for (const double fraction : {0.25, 0.5, 0.75})
            spread = std::max(spread, std::abs(monoharmonic_amplitude(m, 0, fraction * limit) / point.amplitude - 1));
        outcome.steps.push_back(
            {"r = " + rounded(point.r) + ", amplitude " + rounded(point.amplitude) + ", spread over beta " + rounded(spread) +
                 (point.kind == InvariantPointKind::two_effects_cancel ? ", by (87)" : ", U_k = 0, not by (87)"),
             ""});
        if (point.kind == InvariantPointKind::two_effects_cancel || spread > 1e-12) continue;
        ++others;
        outcome.witness = {{"system", "2DOF j=2 l=1 undamped"},
                           {"mass", "1"},
                           {"r", text(point.r)},
                           {"spread over beta", text(spread)},
                           {"U_k", text(m.U[0])}};
    }
    if (others > 0) outcome.verdict = Verdict::refuted;
    outcome.witness.emplace_back("points", std::to_string(points.size()));
    outcome.witness.emplace_back("of them not by (87)", std::to_string(others));
    return outcome;
}

Outcome exact_amplitude() {
    Outcome outcome;
    const StuckSystem s = equal_chain(2, 2, 1, 0);
    double worst = 0;
    for (const InvariantPoint<double>& point : points_of_first_mass()) {
        const ModeSums<double> m = sums_of(s, {0, 0}, point.r);
        const Boundary<double> limit = boundary(m, 1.0);
        const double beta = 0.875 * limit.exact, amplitude = steady_state(m, limit, beta).masses[0].amplitude;
        const double change = amplitude / point.amplitude - 1;
        outcome.steps.push_back({"r = " + rounded(point.r) + ": amplitude at 7/8 of beta_lim over that without friction " +
                                     text(amplitude / point.amplitude),
                                 ""});
        if (std::abs(change) <= worst) continue;
        worst = std::abs(change);
        outcome.witness = {{"system", "2DOF j=2 l=1 undamped"},
                           {"mass", "1"},
                           {"r", text(point.r)},
                           {"beta", text(beta)},
                           {"change of the amplitude", text(change)}};
    }
    if (worst > 1e-6) outcome.verdict = Verdict::refuted;
    return outcome;
}

const Register claims_of_stuck_observations([] {
    const std::vector<std::string> sweep{"r = 1/200 to 3 in steps of 1/200, and at the stuck resonances", "mu = 1"};
    const auto observed = [](std::string id, std::string equation, std::string title, std::vector<std::string> assumptions,
                             std::function<Outcome()> check) {
        return Claim{.id = std::move(id),
                     .equations = {std::move(equation)},
                     .role = Role::observation,
                     .title = std::move(title),
                     .assumptions = std::move(assumptions),
                     .check = std::move(check)};
    };
    return std::vector<Claim>{
        observed("87/all-points", "87", "Every invariant point of (52) without damping is a root of (87)", {"all zeta_i = 0"},
                 all_by_87),
        observed("87/exact-amplitude", "87",
                 "At an invariant point the amplitude itself, not only (52), is the same at every friction ratio",
                 {"all zeta_i = 0"}, exact_amplitude),
        observed("87/only-without-damping/text", "87",
                 "Observation in the text: (52) admits invariant points only where all zeta_i = 0", {"sliding regime"},
                 damped_invariant_point),
        observed(
            "88/stuck-modes/text", "88",
            "Observation in the text: (18) gives the damping ratios of the stuck configuration; here: its modes diagonalise C*",
            {}, stuck_modes),
        observed("88/far-side-at-rest/text", "88",
                 "Observation in the text: with the contact stuck only the masses on the load's side of it oscillate",
                 {"r = 1/200 to 3 in steps of 1/200"}, far_side_at_rest),
        observed("88/sweep", "88",
                 "(88), with zeta* read by (18), is the boundary over the paper's systems and other equal chains", sweep,
                 measured_88),
        observed("88/small-damping", "88", "(88) tends to the boundary as the damping ratios tend to zero",
                 {"r at a stuck resonance"}, small_damping),
        observed("88/resonance-only/text", "88",
                 "Observation in the text: damping changes the boundary of permanent sticking at resonance only; here: at r = 20 "
                 "by less "
                 "than a tenth",
                 {"mu = 1"}, high_frequency),
    };
});

} // namespace
} // namespace denhartog::derivation
