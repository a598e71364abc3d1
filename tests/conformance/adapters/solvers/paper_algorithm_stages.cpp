// The paper's own Runge-Kutta, Section 3.1, a period at a time.
#include <numbers>

#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "tests/conformance/adapters/solvers/period.hpp"

namespace denhartog::tests {
namespace {

std::vector<double> joined(const State& state) {
    std::vector<double> y = state.x;
    y.insert(y.end(), state.x_prime.begin(), state.x_prime.end());
    return y;
}

// Stops that began before a period are told with it: with nodes it is the second of two.
PeriodRecord paper_period(const ContactProblem& problem, double tolerance, const std::vector<double>& y, int nodes) {
    const auto middle = y.begin() + static_cast<std::ptrdiff_t>(y.size() / 2);
    PaperSettings settings;
    settings.absolute_tolerance = tolerance;
    settings.most_steps = 1'000'000;
    settings.most_phases_per_cycle = 1000;
    settings.cycles = nodes > 0 ? 2 : 1;
    settings.samples = nodes;
    settings.start = State{{y.begin(), middle}, {middle, y.end()}};
    const PaperMotion motion = paper_algorithm(problem, settings);
    PeriodRecord record;
    if (motion.status != IntegrationStatus::complete) {
        record.failure = motion.reason;
        return record;
    }
    record.end = joined(motion.end);
    if (nodes == 0) return record;
    for (std::size_t n = 0; n < motion.samples.size(); ++n)
        record.nodes.push_back({motion.sample_times[n], joined(motion.samples[n])});
    record.nodes.push_back({2 * std::numbers::pi, record.end});
    const PaperMassMotion& contact = motion.masses[problem.contact.index];
    record.contact = ContactExtremum{contact.amplitude, contact.phase};
    record.rests = motion.stops;
    if (motion.rests) record.rests = {{0, 2 * std::numbers::pi, y[problem.contact.index]}};
    return record;
}

std::vector<Stage> paper_stages(const Scene<double>& scene, double tolerance) {
    const ContactProblem problem = contact_problem(scene);
    const auto period = [problem, tolerance](const std::vector<double>& y, int nodes) {
        return paper_period(problem, tolerance, y, nodes);
    };
    return {{period, 10 * tolerance, 1000, 16384}};
}

} // namespace

TimeIntegrator paper_time_integrator(double tolerance) {
    return {"the paper's Runge-Kutta, tolerance " + brief(tolerance),
            [tolerance](const Scene<double>& scene) { return paper_stages(scene, tolerance); }};
}

} // namespace denhartog::tests
