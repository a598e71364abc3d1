// Section 3.2: what the text says of the agreement between closed form and the paper's algorithm in Figs. 6 to 10: 200 cycles
// from rest at an absolute tolerance of 1e-6.
#include <algorithm>
#include <cmath>

#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "derivation/observations/observed_systems.hpp"

namespace denhartog::derivation {

namespace {

/// A point of Figs. 6 to 10, by the closed form and by the paper's algorithm.
struct ComparedPoint {
    std::string system;                       ///< its name, with the damping ratio
    double zeta, r, beta;                     ///< the point
    Boundary<double> boundary;                ///< the boundaries there
    std::size_t contact;                      ///< the mass in contact
    std::optional<SteadyState<double>> state; ///< the closed form, where the contact slides
    PaperMotion numerical;                    ///< the last of 200 cycles
};

ComparedPoint compared_point(const ObservedSystem& s, double r, double beta) {
    const ModeSums<double> m = sums_at(s, r);
    ComparedPoint point{s.name, s.zeta, r, beta, boundary(m, 1.0), m.contact.index, std::nullopt, {}};
    if (beta < point.boundary.exact) point.state = steady_state(m, point.boundary, beta);
    Scene<double> scene;
    scene.system = s.system;
    scene.r = r;
    scene.beta = beta;
    PaperSettings settings;
    settings.history = true;
    point.numerical = paper_algorithm(scene, settings);
    if (point.numerical.status != IntegrationStatus::complete)
        throw std::logic_error("the paper's algorithm did not end: " + point.numerical.reason);
    return point;
}

/// Systems and ranges of Figs. 6 to 10: a grid of r and beta, the natural frequency ratios besides.
const std::vector<ComparedPoint>& compared_points() {
    static const std::vector<ComparedPoint> all = [] {
        std::vector<ComparedPoint> list;
        for (const ObservedSystem& s : systems_of_the_paper()) {
            if (s.basis.r_n.size() > 2) continue;
            std::vector<double> frequencies = s.basis.r_n;
            for (const int hundredths : {10, 20, 40, 80, 90, 110, 130, 150, 200, 250}) frequencies.push_back(hundredths / 100.0);
            for (const double r : frequencies)
                for (const int hundredths : {5, 10, 20, 40, 60, 80}) list.push_back(compared_point(s, r, hundredths / 100.0));
        }
        return list;
    }();
    return all;
}

Witness place(const ComparedPoint& p) { return {{"system", p.system}, {"r", text(p.r)}, {"beta", text(p.beta)}}; }

/// Amplitudes of the algorithm against (38) and (52), relative to these.
Outcome amplitudes_agree(bool of_contact) {
    Outcome outcome;
    Worst worst;
    long tried = 0, above = 0;
    for (const double zeta : damping_ratios_of_figures()) {
        Worst here;
        for (const ComparedPoint& p : compared_points())
            for (std::size_t k = 0; p.zeta == zeta && p.state && k < p.state->masses.size(); ++k) {
                if ((k == p.contact) != of_contact) continue;
                const double analytical = p.state->masses[k].amplitude_monoharmonic, numerical = p.numerical.masses[k].amplitude;
                const double error = std::abs(numerical / analytical - 1);
                ++tried;
                above += error > 0.01;
                here.take(error, [&] {
                    return with(place(p), {{"analytical", text(analytical)},
                                           {"numerical", text(numerical)},
                                           {"largest displacement of the closed form", text(p.state->masses[k].amplitude)}});
                });
            }
        outcome.steps.push_back({"zeta = " + rounded(zeta) + ": largest relative difference " + rounded(here.error) + ", " +
                                     here.place[0].second + ", r = " + here.place[1].second + ", beta = " + here.place[2].second,
                                 ""});
        worst.take(here.error, [&] { return here.place; });
    }
    refute_above(outcome, worst.error, {.what = "relative difference of the amplitudes", .taken = 0.01, .empty = 1});
    outcome.witness = with(worst.place, {{"relative difference", text(worst.error)},
                                         {"amplitudes compared", std::to_string(tried)},
                                         {"off by more than 1 percent", std::to_string(above)}});
    return outcome;
}

/// Phases of the mass in contact by (39), or of the others by (53).
Outcome phases_agree(bool of_contact) {
    Outcome outcome;
    Worst worst;
    long tried = 0;
    for (const double zeta : damping_ratios_of_figures()) {
        Worst here;
        for (const ComparedPoint& p : compared_points())
            for (std::size_t k = 0; p.zeta == zeta && p.state && k < p.state->masses.size(); ++k) {
                if ((k == p.contact) != of_contact || !p.numerical.masses[k].phase) continue;
                const double numerical = *p.numerical.masses[k].phase, analytical = p.state->masses[k].phase_monoharmonic;
                ++tried;
                here.take(std::abs(wrapped(numerical - analytical)), [&] {
                    return with(place(p), {{"analytical", text(analytical)}, {"numerical", text(numerical)}});
                });
            }
        outcome.steps.push_back({"zeta = " + rounded(zeta) + ": largest difference " + rounded(here.error) + " radians, " +
                                     here.place[0].second + ", r = " + here.place[1].second + ", beta = " + here.place[2].second,
                                 ""});
        worst.take(here.error, [&] { return here.place; });
    }
    refute_above(outcome, worst.error,
                 {.what = "difference of the phases in radians", .taken = 0.01 * pi<double>(), .empty = pi<double>()});
    outcome.witness = with(worst.place, {{"difference", text(worst.error)}, {"phases compared", std::to_string(tried)}});
    return outcome;
}

/// Cycles after which the amplitude of the contact stays within 1 percent of the steady one.
Outcome most_converge_early() {
    Outcome outcome;
    std::vector<int> cycles;
    Worst slowest;
    for (const ComparedPoint& p : compared_points()) {
        if (!p.state) continue;
        int last = 0;
        const std::vector<ContactPeriod>& history = p.numerical.history;
        for (std::size_t n = 0; n < history.size(); ++n)
            if (std::abs(history[n].amplitude / p.state->X_j - 1) > 0.01) last = static_cast<int>(n) + 1;
        cycles.push_back(last);
        slowest.take(last, [&] { return place(p); });
    }
    const auto within = [&](int most) { return std::ranges::count_if(cycles, [most](int c) { return c <= most; }); };
    const auto tried = static_cast<long>(cycles.size());
    const long early = within(100), never = tried - within(199);
    std::ranges::sort(cycles);
    outcome.steps.push_back({"Within 1 percent of (38) after 100 cycles at the most: " + std::to_string(early) + " of " +
                                 std::to_string(tried) + " sliding points; not after 200: " + std::to_string(never),
                             ""});
    refute_above(outcome, cycles[cycles.size() / 2], // more than half need no more
                 {.what = "cycles that are long before 200", .taken = 100, .empty = 200});
    outcome.witness = with(slowest.place, {{"sliding points", std::to_string(tried)},
                                           {"after 100 cycles at most", std::to_string(early)},
                                           {"not after 200 cycles", std::to_string(never)}});
    return outcome;
}

/// The regime of the steady motion from rest by the exact solver.
std::string steady_regime(const ComparedPoint& p) {
    for (const ObservedSystem& s : systems_of_the_paper()) {
        if (s.name != p.system) continue;
        const ContactSystem system = contact_system(s.system);
        ExactSolver solver(system, {p.r, p.beta, 1});
        const PeriodicOrbit orbit = periodic_orbit(solver, at_rest(s.basis.r_n.size()));
        if (orbit.status == OrbitStatus::not_converged) return "not found";
        if (orbit.status == OrbitStatus::permanently_stuck) return name(Regime::permanent_sticking);
        return name(orbit.stops.empty() ? Regime::continuous : Regime::stick_slip);
    }
    throw std::logic_error("no system named " + p.system);
}

/// A point refutes where the steady motion has another regime than the boundaries predict; where the algorithm has not settled
/// after its cycles, it is counted apart.
Outcome regimes_agree() {
    Outcome outcome;
    long tried = 0, unsettled = 0, differ = 0;
    for (const ComparedPoint& p : compared_points()) {
        const Regime predicted = denhartog::regime_of(p.boundary, p.beta), numerical = regime_seen(p.numerical);
        ++tried;
        if (predicted == numerical) continue;
        const std::string steady = steady_regime(p);
        ++(steady == name(predicted) ? unsettled : differ);
        outcome.steps.push_back({p.system + ", r = " + rounded(p.r) + ", beta = " + rounded(p.beta) + ": predicted " +
                                     name(predicted) + ", steady by the exact solver " + steady + ", in the last of 200 cycles " +
                                     name(numerical) + "; boundaries " + rounded(p.boundary.exact) + " and " +
                                     rounded(*p.boundary.sticking),
                                 ""});
        if (steady != name(predicted))
            outcome.witness = with(place(p), {{"predicted", name(predicted)}, {"steady by the exact solver", steady}});
    }
    if (differ > 0) outcome.verdict = Verdict::refuted;
    outcome.witness = with(outcome.witness, {{"points", std::to_string(tried)},
                                             {"points whose steady regime differs", std::to_string(differ)},
                                             {"points not settled after 200 cycles", std::to_string(unsettled)}});
    return outcome;
}

const Register claims_of_numerical_observations([] {
    const std::vector<std::string> points{"SDOF and 2DOF j=2 l=1", "zeta = 0.001, 0.01, 0.1", "r = 0.1 to 2.5 and r_n,i",
                                          "beta = 0.05 to 0.8", "mu = 1"};
    return std::vector<Claim>{
        observation(
            "38/agreement/text", {"38"},
            "Observation in the text: numerical and analytical amplitudes of the contact agree very well; here: to 1 percent",
            points, [] { return amplitudes_agree(true); }),
        observation("52/agreement/text", {"52"},
                    "Observation in the text: numerical and analytical amplitudes of the other masses agree very well; here: to "
                    "1 percent",
                    points, [] { return amplitudes_agree(false); }),
        observation(
            "39/agreement/text", {"39"},
            "Observation in the text: numerical and analytical phases of the contact agree very well; here: to 1 percent of pi",
            points, [] { return phases_agree(true); }),
        observation("53/agreement/text", {"53"},
                    "Observation in the text: numerical and analytical phases of the other masses agree very well; here: to 1 "
                    "percent of pi",
                    points, [] { return phases_agree(false); }),
        observation("74/cycles/text", {"74"},
                    "Observation in the text: most responses are steady long before 200 cycles; here: within 1 percent after 100",
                    points, most_converge_early),
        observation("69/regimes/text", {"69", "88"},
                    "Observation in the text: the regimes of the numerical motions are those that the boundaries predict; here: "
                    "once they "
                    "have settled",
                    points, regimes_agree),
    };
});

} // namespace
} // namespace denhartog::derivation
