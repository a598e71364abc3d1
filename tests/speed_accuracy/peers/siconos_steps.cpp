#include "tests/speed_accuracy/peers/siconos_steps.hpp"

#include <SiconosKernel.hpp>
#include <cmath>

namespace denhartog::tests {
namespace {

// Siconos hands the load's own numbers back: here the loaded mass.
void load_at(double tau, unsigned size, double* force, unsigned, double* loaded) {
    for (unsigned k = 0; k < size; ++k) force[k] = 0;
    force[static_cast<unsigned>(*loaded)] = std::cos(tau);
}

SP::SimpleMatrix matrix(const std::vector<double>& entries, unsigned N) {
    SP::SimpleMatrix A(new SimpleMatrix(N, N));
    for (unsigned row = 0; row < N; ++row)
        for (unsigned column = 0; column < N; ++column) (*A)(row, column) = entries[row * N + column];
    return A;
}

} // namespace

struct SiconosSteps::Simulation {
    SP::LagrangianLinearTIDS system;
    SP::TimeStepping stepping;
};

SiconosSteps::SiconosSteps(const std::vector<double>& M, const std::vector<double>& C, const std::vector<double>& K,
                           unsigned contact, unsigned load, double beta, double step, long steps,
                           const std::vector<double>& start)
    : simulation_(new Simulation) {
    unsigned N = 1;
    while (N * N < M.size()) ++N;
    SP::SiconosVector x(new SiconosVector(N, 0.0)), v(new SiconosVector(N, 0.0)), loaded(new SiconosVector(1, load));
    for (unsigned k = 0; k < N && !start.empty(); ++k) {
        (*x)(k) = start[k];
        (*v)(k) = start[N + k];
    }
    simulation_->system.reset(new LagrangianLinearTIDS(x, v, matrix(M, N), matrix(K, N), matrix(C, N)));
    simulation_->system->setzPtr(loaded);
    simulation_->system->setComputeFExtFunction(load_at);
    SP::SimpleMatrix H(new SimpleMatrix(1, N));
    H->zero();
    (*H)(0, contact) = 1;
    SP::SiconosVector offset(new SiconosVector(1, -1e6));
    SP::NonSmoothLaw relay(new RelayNSL(1, -beta * step, beta * step));
    SP::Interaction interaction(new Interaction(relay, SP::Relation(new LagrangianLinearTIR(H, offset))));
    SP::NonSmoothDynamicalSystem whole(new NonSmoothDynamicalSystem(0, step * static_cast<double>(steps + 2)));
    whole->insertDynamicalSystem(simulation_->system);
    whole->link(interaction, simulation_->system);
    simulation_->stepping.reset(new TimeStepping(whole, SP::TimeDiscretisation(new TimeDiscretisation(0, step)),
                                                 SP::OneStepIntegrator(new MoreauJeanOSI(0.5)),
                                                 SP::OneStepNSProblem(new Relay(SICONOS_RELAY_LEMKE))));
}

SiconosSteps::~SiconosSteps() = default;

void SiconosSteps::advance(std::vector<double>& state) {
    simulation_->stepping->computeOneStep();
    simulation_->stepping->nextStep();
    const std::size_t N = state.size() / 2;
    for (std::size_t k = 0; k < N; ++k) {
        state[k] = (*simulation_->system->q())(static_cast<unsigned>(k));
        state[N + k] = (*simulation_->system->velocity())(static_cast<unsigned>(k));
    }
}

} // namespace denhartog::tests
