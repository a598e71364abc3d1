#include "tests/speed_accuracy/surveys.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/number/number.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"

namespace denhartog::tests {
namespace {

std::vector<double> amplitudes_in_last_cycle(ExactSolver& solver, std::size_t N, int cycles) {
    const double period = 2 * pi<double>();
    State z = at_rest(N);
    for (int n = 1; n < cycles; ++n) z = solver.run(z, 0, period).end;
    (void)solver.run(z, 0, period);
    std::vector<double> amplitudes;
    for (const Extremum& e : solver.largest_displacements()) amplitudes.push_back(std::abs(e.x));
    return amplitudes;
}

} // namespace

CyclesSurvey survey_cycles(const std::string& name, const System<double>& system, double zeta, double beta,
                           const std::vector<double>& r, int cycles) {
    CyclesSurvey survey{name, zeta, beta, {}, 0, 0};
    const ContactSystem contact = contact_system(system);
    const std::size_t N = contact.basis.r_n.size(), j = contact.contact.index;
    ExactSolver solver(contact, {1, beta, 1});
    State start = at_rest(N);
    for (const double each : r) {
        solver.set({each, beta, 1});
        const PeriodicOrbit orbit = periodic_orbit(solver, start);
        survey.stuck += orbit.status == OrbitStatus::permanently_stuck;
        survey.unanswered += !is_from_start(orbit);
        if (orbit.status != OrbitStatus::periodic) continue;
        start = orbit.start;
        const std::vector<double> last = amplitudes_in_last_cycle(solver, N, cycles);
        CyclesError error{each, 0, 0, orbit.masses[j].amplitude};
        for (std::size_t k = 0; k < N; ++k) {
            const double of_mass = std::abs(last[k] / orbit.masses[k].amplitude - 1);
            if (k == j) error.contact = of_mass;
            error.others = std::max(error.others, of_mass);
        }
        survey.errors.push_back(error);
    }
    return survey;
}

const CyclesError& worst(const CyclesSurvey& s) {
    return *std::ranges::max_element(s.errors, {}, [](const CyclesError& e) { return e.contact; });
}

Table table_of(const std::vector<CyclesSurvey>& all, int cycles) {
    Table table{"Amplitude in the last of " + std::to_string(cycles) + " cycles from rest, against the periodic orbit",
                {"system", "zeta", "beta", "largest error, contact", "at r", "largest error, any mass", "at r", "above 1e-3",
                 "above 1e-6", "points", "stuck", "unanswered"},
                {},
                ""};
    for (const CyclesSurvey& s : all) {
        if (s.errors.empty()) continue;
        const CyclesError& contact = worst(s);
        const CyclesError& any = *std::ranges::max_element(s.errors, {}, [](const CyclesError& e) { return e.others; });
        const auto above = [&](double e) {
            return std::to_string(std::ranges::count_if(s.errors, [e](const CyclesError& x) { return x.contact > e; }));
        };
        table.rows.push_back({s.name, digits(s.zeta), digits(s.beta), digits(contact.contact, "%.2e"), digits(contact.r, "%.4g"),
                              digits(any.others, "%.2e"), digits(any.r, "%.4g"), above(1e-3), above(1e-6),
                              std::to_string(s.errors.size()), std::to_string(s.stuck), std::to_string(s.unanswered)});
    }
    return table;
}

} // namespace denhartog::tests
