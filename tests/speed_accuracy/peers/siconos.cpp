#include "tests/speed_accuracy/peers/peers.hpp"

#include "denhartog/model/modal_basis.hpp"
#include "tests/speed_accuracy/peers/settling.hpp"
#include "tests/speed_accuracy/peers/siconos_steps.hpp"

namespace denhartog::tests {
namespace {

// The number of steps that we can afford; steps of many masses cost more.
long most_steps(std::size_t N) { return 400'000 / static_cast<long>(1 + N / 16); }

std::vector<double> entries(const Matrix<double>& A) {
    std::vector<double> all;
    for (Eigen::Index row = 0; row < A.rows(); ++row)
        for (Eigen::Index column = 0; column < A.cols(); ++column) all.push_back(A(row, column));
    return all;
}

PeerAnswer answer_at(const System<double>& system, const ModalBasis<double>& basis, double decay, const ChartPoint& point,
                     int steps_a_period) {
    const NonDimensionalMatrices m = non_dimensional_matrices(system, basis, point.r);
    const std::size_t N = number_of_masses(system), j = system.contact.index;
    const double step = 2 * std::numbers::pi / steps_a_period;
    SiconosSteps stepping(entries(m.M), entries(m.C), entries(m.K), static_cast<unsigned>(j),
                          static_cast<unsigned>(system.load.index), point.beta, step, most_steps(N) + steps_a_period);
    Settling settling(decay, point.r, 1.0 / steps_a_period / steps_a_period);
    std::vector<double> state(2 * N, 0.0);
    PeerAnswer answer;
    double amplitude = 0;
    do {
        amplitude = 0;
        answer.sticks = false;
        for (int n = 0; n < steps_a_period; ++n) {
            const double x = state[j], v = state[N + j];
            stepping.advance(state);
            const double v_next = state[N + j];
            amplitude = std::max(amplitude, std::abs(state[j]));
            // The scheme's displacement is a parabola within a step; where the velocity changes sign it has its vertex.
            if (v * v_next < 0) amplitude = std::max(amplitude, std::abs(x + step * v * v / (2 * (v - v_next))));
            if (std::abs(v) < 1e-12 && std::abs(v_next) < 1e-12) answer.sticks = true;
        }
        answer.evaluations += steps_a_period;
        if (answer.evaluations > most_steps(N)) {
            answer.ending = Ending::did_not_finish;
            return answer;
        }
    } while (!settling.settled(state));
    set_amplitude(answer, amplitude);
    return answer;
}

} // namespace

std::vector<Peer> siconos_peers() {
    std::vector<Peer> peers;
    for (const int steps : {100, 300, 1000, 3000, 10000, 30000, 100000})
        peers.push_back(
            {"Siconos, Moreau-Jean", std::to_string(steps) + " steps a period", 0, [steps](const System<double>& system) {
                 return [=, basis = modal_basis(system), decay = slowest_decay(system)](const ChartPoint& point) {
                     return answer_at(system, basis, decay, point, steps);
                 };
             }});
    return peers;
}

} // namespace denhartog::tests
