// SUNDIALS CVODE with root finding, a period at a time.
#include "tests/conformance/adapters/solvers/period.hpp"
#include "tests/speed_accuracy/peers/cvode_integrator.hpp"

namespace denhartog::tests {
namespace {

PeriodRecord cvode_period(CvodeIntegrator& integrator, std::size_t contact, const std::vector<double>& y, int nodes) {
    PeriodRecord record;
    bool resting = false;
    integrator.restart(y);
    const Ending ending = integrator.period(std::max(nodes, 1), [&](double tau, std::span<const double> at, int direction) {
        if (nodes > 0 && (record.nodes.empty() || tau > record.nodes.back().tau))
            record.nodes.push_back({tau, {at.begin(), at.end()}});
        if (direction == 0 && !resting) record.rests.push_back({tau, tau, at[contact]});
        if (resting) record.rests.back().end = tau;
        resting = direction == 0;
    });
    std::erase_if(record.rests, [](const Stop& rest) { return !(rest.end > rest.start); });
    switch (ending) {
    case Ending::stalled: record.failure = "the contact chatters"; break;
    case Ending::not_a_number: record.failure = "the state is no longer finite"; break;
    case Ending::did_not_finish: record.failure = "CVODE gave up"; break;
    default: break;
    }
    record.end.assign(integrator.state().begin(), integrator.state().end());
    return record;
}

std::vector<Stage> cvode_stages(const Scene<double>& scene, double tolerance) {
    const auto integrator = std::make_shared<CvodeIntegrator>(contact_problem(scene), tolerance);
    const auto period = [integrator, j = scene.system.contact.index](const std::vector<double>& y, int nodes) {
        return cvode_period(*integrator, j, y, nodes);
    };
    return {{period, 10 * tolerance, 1000, 16384}};
}

} // namespace

TimeIntegrator cvode_time_integrator(double tolerance) {
    return {"SUNDIALS CVODE, Adams, events, tolerance " + brief(tolerance),
            [tolerance](const Scene<double>& scene) { return cvode_stages(scene, tolerance); }};
}

} // namespace denhartog::tests
