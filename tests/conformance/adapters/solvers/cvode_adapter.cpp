// SUNDIALS CVODE with root finding, under the conformance kit.
#include <iostream>

#include "tests/conformance/adapters/solvers/solver_adapter.hpp"
#include "tests/speed_accuracy/peers/cvode_integrator.hpp"

namespace {

using namespace denhartog;
using namespace denhartog::tests;

constexpr double tolerance = 1e-12; // of CVODE, absolute and relative

PeriodRecord one_period(CvodeIntegrator& integrator, std::size_t contact, const std::vector<double>& y, int nodes) {
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
    std::erase_if(record.rests, [](const Stop<double>& rest) { return !(rest.end > rest.start); });
    switch (ending) {
    case Ending::stalled: record.failure = "the contact chatters"; break;
    case Ending::not_a_number: record.failure = "the state is no longer finite"; break;
    case Ending::did_not_finish: record.failure = "CVODE gave up"; break;
    default: break;
    }
    record.end.assign(integrator.state().begin(), integrator.state().end());
    return record;
}

std::vector<Stage> stages(const Scene<double>& scene) {
    const auto integrator = std::make_shared<CvodeIntegrator>(contact_problem(scene), tolerance);
    const auto period = [integrator, j = scene.system.contact.index](const std::vector<double>& y, int nodes) {
        return one_period(*integrator, j, y, nodes);
    };
    return {{period, 10 * tolerance, 1000, 16384}};
}

} // namespace

int main() { return serve({"SUNDIALS CVODE, Adams, events, tolerance 1e-12", stages}, std::cin, std::cout); }
