#include "tests/speed_accuracy/peers/peers.hpp"

#include "tests/speed_accuracy/peers/cvode_integrator.hpp"
#include "tests/speed_accuracy/peers/settling.hpp"

namespace denhartog::tests {
namespace {

PeerAnswer answer_at(const System<double>& system, double decay, const ChartPoint& point, double tolerance) {
    Scene<double> scene;
    scene.system = system;
    scene.r = point.r;
    scene.beta = point.beta;
    CvodeIntegrator integrator(contact_problem(scene), tolerance);
    Settling settling(decay, point.r, tolerance);
    PeerAnswer answer;
    double amplitude = 0;
    do {
        amplitude = 0;
        answer.sticks = false;
        answer.ending = integrator.period(1, [&](double, std::span<const double> y, int direction) {
            amplitude = std::max(amplitude, std::abs(y[system.contact.index]));
            answer.sticks = answer.sticks || direction == 0;
        });
    } while (answer.ending == Ending::answered && !settling.settled(integrator.state()));
    answer.evaluations = integrator.evaluations();
    if (answer.ending == Ending::answered) set_amplitude(answer, amplitude);
    return answer;
}

} // namespace

std::vector<Peer> cvode_peers() {
    std::vector<Peer> peers;
    for (const double tolerance : chart_tolerances())
        peers.push_back({"SUNDIALS CVODE", tolerance_text(tolerance), tolerance, [tolerance](const System<double>& system) {
                             return [=, decay = slowest_decay(system)](const ChartPoint& point) {
                                 return answer_at(system, decay, point, tolerance);
                             };
                         }});
    return peers;
}

} // namespace denhartog::tests
