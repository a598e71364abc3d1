#include "tests/speed_accuracy/surveys.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/support/plain_response.hpp"
#include "tests/support/sample_scenes.hpp"

namespace denhartog::tests {
namespace {

const double period = 2 * pi<double>();
constexpr int periods_to_settle = 500;

PeriodicOrbit orbit_of(ExactSolver& solver) {
    OrbitSearch search;
    search.most_periods = periods_to_settle;
    search.with_stability = false;
    return periodic_orbit(solver, at_rest(solver.system().basis.r_n.size()), search);
}

bool sticks_and_slips(const Scene<double>& scene) {
    const ContactSystem system = contact_system(scene.system);
    ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
    const PeriodicOrbit orbit = orbit_of(solver);
    return orbit.status == OrbitStatus::periodic && !orbit.stops.empty() && orbit.touching == 0;
}

/// The stops that end in the last period of a motion, as the paper's algorithm lists them.
std::vector<Stop> stops_in_last_period(const ExactMotion& motion, double start, double end) {
    std::vector<Stop> stops;
    double since = -1;
    for (const Phase& p : motion.phases) {
        if (p.direction != 0 || !(p.end > p.start)) continue;
        if (!(since >= 0)) since = p.start;
        const bool goes_on = &p != &motion.phases.back() && (&p)[1].direction == 0;
        if (goes_on) continue;
        const double shift = since < start ? period : 0;
        if (p.end > start && p.end < end) stops.push_back({since - start + shift, p.end - start + shift, 0});
        since = -1;
    }
    std::ranges::sort(stops, {}, &Stop::start);
    return stops;
}

/// Whether the contact rests from an instant to the end of a motion.
bool rests_from(const ExactMotion& motion, double start) {
    return std::ranges::all_of(motion.phases,
                               [&](const Phase& p) { return p.direction == 0 || p.end <= std::max(start, p.start); });
}

double apart(double a, double b) { return std::abs(std::remainder(a - b, period)); }

void compare_stops(const std::vector<Stop>& a, const std::vector<Stop>& b, const std::string& name, StickSlipSurvey& survey) {
    if (a.size() != b.size()) {
        survey.differently.push_back(name + ": " + std::to_string(a.size()) + " stops against " + std::to_string(b.size()));
        return;
    }
    survey.stops += static_cast<int>(a.size());
    survey.most_stops = std::max(survey.most_stops, static_cast<int>(a.size()));
    for (std::size_t n = 0; n < a.size(); ++n)
        survey.event.note(std::max(apart(a[n].start, b[n].start), apart(a[n].end, b[n].end)), name);
}

void compare_states(const State& a, const State& b, const std::string& name, StickSlipSurvey& survey) {
    double size = 0, difference = 0;
    for (std::size_t k = 0; k < a.x.size(); ++k) {
        size = std::max({size, std::abs(b.x[k]), std::abs(b.x_prime[k])});
        difference = std::max({difference, std::abs(a.x[k] - b.x[k]), std::abs(a.x_prime[k] - b.x_prime[k])});
    }
    survey.state.note(difference / size, name);
}

void compare_amplitudes(double a, double b, const std::string& name, StickSlipSurvey& survey) {
    survey.amplitude.note(std::abs(a - b) / b, name);
    survey.mixed.note(std::abs(a - b) / (1 + b), name);
}

template <class F>
void each_with_solver(const std::vector<StickSlipScene>& scenes, const F& f) {
    for (const StickSlipScene& named : scenes) {
        const Scene<double>& scene = named.scene;
        const ContactSystem system = contact_system(scene.system);
        ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
        f(named, solver);
    }
}

} // namespace

std::vector<StickSlipScene> stick_slip_scenes(int scenes, std::uint64_t seed) {
    std::vector<StickSlipScene> found;
    std::mt19937_64 random(seed);
    while (static_cast<int>(found.size()) < scenes) {
        std::size_t of_this_size = 0, N = 0;
        for (const RandomScene<double>& named : random_scenes<double>(random())) {
            Scene<double> scene = named.scene;
            if (number_of_masses(scene.system) > 6 || static_cast<int>(found.size()) == scenes) break;
            if (number_of_masses(scene.system) != N) {
                N = number_of_masses(scene.system);
                of_this_size = 0;
            }
            if (of_this_size == 12) continue; // of 40 of this size: leaves room for the others
            if (random() >> 63) scene.mu = 1;
            const double part = static_cast<double>(1 + (random() >> 58)) / 66;
            try {
                const Boundary<double> limits = response(scene).boundary;
                const double upper = limits.sticking.value_or(2 * limits.exact);
                if (!(upper > limits.exact)) continue;
                scene.beta = friction_ratio_at(1, limits.exact + part * (upper - limits.exact));
            } catch (const DomainError&) {
                continue;
            }
            if (!sticks_and_slips(scene)) continue;
            ++of_this_size;
            found.push_back({named.name + " mu=" + digits(scene.mu, "%.17g") + " beta=" + digits(*scene.beta, "%a"), scene});
        }
    }
    return found;
}

StickSlipSurvey from_rest(const std::vector<StickSlipScene>& scenes, int periods, double tolerance) {
    StickSlipSurvey survey;
    PaperSettings settings;
    settings.cycles = periods;
    settings.absolute_tolerance = tolerance;
    each_with_solver(scenes, [&](const StickSlipScene& named, ExactSolver& solver) {
        const PaperMotion paper = paper_algorithm(named.scene, settings);
        if (paper.status != IntegrationStatus::complete) {
            survey.differently.push_back(named.name + ": " + paper.reason);
            return;
        }
        const double end = periods * period, start = end - period;
        const ExactMotion& motion = solver.run(at_rest(paper.masses.size()), 0, end);
        if (rests_from(motion, start) != paper.rests)
            survey.differently.push_back(named.name + ": one rests all through the last period");
        else if (!paper.rests)
            compare_stops(stops_in_last_period(motion, start, end), paper.stops, named.name, survey);
        compare_states(paper.end, motion.end, named.name, survey);
        const State before = solver.run(at_rest(paper.masses.size()), 0, start).end;
        (void)solver.run(before, 0, period);
        const std::vector<Extremum> largest = solver.largest_displacements();
        for (std::size_t k = 0; k < largest.size(); ++k)
            compare_amplitudes(paper.masses[k].amplitude, std::abs(largest[k].x), named.name, survey);
    });
    return survey;
}

StickSlipSurvey on_orbits(const std::vector<StickSlipScene>& scenes, double tolerance) {
    StickSlipSurvey survey;
    PaperSettings settings;
    settings.absolute_tolerance = tolerance;
    each_with_solver(scenes, [&](const StickSlipScene& named, ExactSolver& solver) {
        const PeriodicOrbit orbit = orbit_of(solver);
        settings.start = orbit.start;
        settings.cycles = 2 * orbit.periods;
        const PaperMotion paper = paper_algorithm(named.scene, settings);
        if (orbit.status != OrbitStatus::periodic || paper.status != IntegrationStatus::complete) {
            survey.differently.push_back(named.name + ": " + in_words(orbit.reason) + paper.reason);
            return;
        }
        compare_states(paper.end, orbit.start, named.name, survey);
        if (orbit.periods > 1) return; // the paper's algorithm looks at one period of the force alone
        compare_stops(orbit.stops, paper.stops, named.name, survey);
        for (std::size_t k = 0; k < orbit.masses.size(); ++k)
            compare_amplitudes(paper.masses[k].amplitude, orbit.masses[k].amplitude, named.name, survey);
    });
    return survey;
}

std::vector<std::string> stick_slip_head() {
    return {"what",          "amplitudes",  "relative error", "over 1 + X", "stops",
            "most a period", "their times", "state",          "differently"};
}

std::vector<std::string> row_of(const std::string& what, const StickSlipSurvey& s) {
    return {what,
            std::to_string(s.amplitude.count),
            digits(s.amplitude.error, "%.1e"),
            digits(s.mixed.error, "%.1e"),
            std::to_string(s.stops),
            std::to_string(s.most_stops),
            digits(s.event.error, "%.1e"),
            digits(s.state.error, "%.1e"),
            std::to_string(s.differently.size())};
}

} // namespace denhartog::tests
