#include "derivation/observations/contact_motions.hpp"

#include <cmath>
#include <stdexcept>

#include "denhartog/orbit/periodic_orbit.hpp"
#include "derivation/observations/observed_systems.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

namespace {

const std::vector<double>& friction_ratios() {
    static const std::vector<double> list{0.02, 0.05, 0.1, 0.2, 0.4, 0.6, 0.8};
    return list;
}

} // namespace

ContactMotion motion_of_contact(ExactSolver& solver, double r, double beta) {
    solver.set({r, beta, 1});
    OrbitSearch search;
    search.contact_only = true;
    search.with_stability = false;
    const PeriodicOrbit orbit = periodic_orbit(solver, at_rest(solver.system().basis.r_n.size()), search);
    if (orbit.status == OrbitStatus::not_converged) throw std::logic_error("no steady motion: " + in_words(orbit.reason));
    if (orbit.status == OrbitStatus::permanently_stuck) return {0, 0, true};
    return {orbit.contact.amplitude, orbit.stops.size(), false};
}

std::vector<GridPoint> contact_over_grid(const std::vector<double>& frequencies) {
    std::vector<GridPoint> grid;
    for (const std::string system : {"SDOF", "2DOF j=2 l=1"})
        for (const double r : frequencies)
            for (const double beta : friction_ratios()) grid.push_back({system, r, beta, {}});
    for (const double zeta : damping_ratios_of_figures()) {
        const ContactSystem one = contact_system(single_mass(zeta)), two = contact_system(two_masses(zeta));
        ExactSolver solver_of_one(one, {1, 1, 1}), solver_of_two(two, {1, 1, 1});
        for (GridPoint& point : grid)
            point.motions.push_back(
                motion_of_contact(point.system == "SDOF" ? solver_of_one : solver_of_two, point.r, point.beta));
    }
    return grid;
}

Witness place(const GridPoint& p) { return {{"system", p.system}, {"r", text(p.r)}, {"beta", text(p.beta)}}; }

Outcome change_with_damping(const std::vector<GridPoint>& grid, const std::function<bool(const ContactMotion&)>& counts,
                            double threshold) {
    Outcome outcome;
    Worst worst;
    long tried = 0, above = 0;
    for (const std::string system : {"SDOF", "2DOF j=2 l=1"})
        for (std::size_t d = 1; d < damping_ratios_of_figures().size(); ++d) {
            Worst here;
            for (const GridPoint& p : grid) {
                const ContactMotion &least = p.motions[0], &more = p.motions[d];
                if (p.system != system || least.rests || more.rests || !counts(least) || !counts(more)) continue;
                const double change = std::abs(more.X / least.X - 1);
                ++tried;
                above += change > threshold;
                here.take(change, [&] {
                    return with(place(p), {{"zeta", text(damping_ratios_of_figures()[d])},
                                           {"amplitude", text(more.X)},
                                           {"amplitude, zeta = 0.001", text(least.X)}});
                });
            }
            outcome.steps.push_back({system + ", zeta = 0.001 and " + rounded(damping_ratios_of_figures()[d]) +
                                         ": largest change of the amplitude " + rounded(here.error) +
                                         ", r = " + here.place[1].second + ", beta = " + here.place[2].second,
                                     ""});
            worst.take(here.error, [&] { return here.place; });
        }
    refute_above(outcome, worst.error, {.what = "relative change of the amplitude", .taken = threshold, .empty = 1});
    outcome.witness = with(worst.place, {{"relative change", text(worst.error)},
                                         {"pairs compared", std::to_string(tried)},
                                         {"changed by more", std::to_string(above)}});
    return outcome;
}

} // namespace denhartog::derivation
