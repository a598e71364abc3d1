#include "tests/speed_accuracy/peers/cvode.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <array>

#include "denhartog/integration/contact_equations.hpp"
#include "tests/speed_accuracy/peers/settling.hpp"

namespace denhartog::tests {
namespace {

constexpr long most_right_hand_sides = 2'000'000;
constexpr int most_phases_a_period = 1000;

/// The equations in the phase that they are in, as CVODE's functions see them.
struct Problem {
    ContactEquations equations;
    int direction = 1;
    std::vector<double> y, y_prime;
};

int right_hand_side(double tau, N_Vector y, N_Vector y_prime, void* data) {
    auto& p = *static_cast<Problem*>(data);
    std::copy_n(N_VGetArrayPointer(y), p.y.size(), p.y.begin());
    p.equations(p.y, p.y_prime, tau);
    std::ranges::copy(p.y_prime, N_VGetArrayPointer(y_prime));
    return 0;
}

// While the contact slides its velocity, while it sticks what is left of static friction on either side.
int events(double tau, N_Vector y, double* event, void* data) {
    const auto& p = *static_cast<Problem*>(data);
    const std::span<const double> state(N_VGetArrayPointer(y), p.y.size());
    const double held = p.equations.mu * p.equations.beta;
    const double load = p.direction == 0 ? p.equations.load_on_contact(state, tau) : 0;
    event[0] = p.direction == 0 ? held - load : state[p.equations.N + p.equations.j];
    event[1] = held + load;
    return 0;
}

/// An integrator at rest at tau = 0.
class Integrator {
public:
    Integrator(Problem& problem, double tolerance) : problem_(problem) {
        SUNContext_Create(nullptr, &context_);
        y_ = N_VNew_Serial(static_cast<sunindextype>(problem.y.size()), context_);
        N_VConst(0, y_);
        memory_ = CVodeCreate(CV_ADAMS, context_);
        CVodeInit(memory_, right_hand_side, 0, y_);
        CVodeSStolerances(memory_, tolerance, tolerance);
        iteration_ = SUNNonlinSol_FixedPoint(y_, 0, context_);
        CVodeSetNonlinearSolver(memory_, iteration_);
        CVodeSetUserData(memory_, &problem);
        CVodeSetMaxNumSteps(memory_, most_right_hand_sides);
        CVodeSetMaxStep(memory_, std::numbers::pi / 8);
        CVodeRootInit(memory_, 2, events);
        CVodeSetNoInactiveRootWarn(memory_);
        CVodeSetErrFile(memory_, nullptr);
        start_phase();
    }
    ~Integrator() {
        CVodeFree(&memory_);
        SUNNonlinSolFree(iteration_);
        N_VDestroy(y_);
        SUNContext_Free(&context_);
    }
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;

    /// One period of the force; says how it ended, the largest displacement of the contact and whether it stuck.
    Ending period(double& amplitude, bool& sticks) {
        const std::size_t N = problem_.equations.N, j = problem_.equations.j;
        const double end = 2 * std::numbers::pi * ++periods_;
        amplitude = std::abs(state()[j]);
        sticks = problem_.direction == 0;
        CVodeSetStopTime(memory_, end);
        for (int phases = 0; phases <= most_phases_a_period; ++phases) {
            const int flag = CVode(memory_, end, y_, &tau_, CV_NORMAL);
            if (flag < 0 || problem_.equations.evaluations > most_right_hand_sides) return Ending::did_not_finish;
            amplitude = std::max(amplitude, std::abs(state()[j]));
            if (!std::isfinite(amplitude)) return Ending::not_a_number;
            if (flag != CV_ROOT_RETURN) return Ending::answered;
            state()[N + j] = 0;
            start_phase();
            CVodeReInit(memory_, tau_, y_);
            CVodeSetStopTime(memory_, end);
            sticks = sticks || problem_.direction == 0;
        }
        return Ending::stalled;
    }
    [[nodiscard]] std::span<double> state() { return {N_VGetArrayPointer(y_), problem_.y.size()}; }

private:
    // The contact is at rest: a sticking one lets go, a sliding one sticks or turns back.
    void start_phase() {
        const double load = problem_.equations.load_on_contact(state(), tau_);
        const bool was_sticking = problem_.direction == 0;
        const bool holds = !was_sticking && std::abs(load) <= problem_.equations.mu * problem_.equations.beta;
        problem_.direction = holds ? 0 : (load > 0 ? 1 : -1);
        problem_.equations.set(problem_.direction);
        std::array<int, 2> falling{-1, -1};
        if (!holds) falling = {-problem_.direction, -1};
        CVodeSetRootDirection(memory_, falling.data());
    }

    Problem& problem_;
    SUNContext context_ = nullptr;
    N_Vector y_ = nullptr;
    void* memory_ = nullptr;
    SUNNonlinearSolver iteration_ = nullptr;
    double tau_ = 0;
    int periods_ = 0;
};

PeerAnswer answer_at(const System<double>& system, double decay, const ChartPoint& point, double tolerance) {
    Scene<double> scene;
    scene.system = system;
    scene.r = point.r;
    scene.beta = point.beta;
    const std::size_t size = 2 * number_of_masses(system);
    Problem problem{ContactEquations(contact_problem(scene)), 1, std::vector<double>(size), std::vector<double>(size)};
    Integrator integrator(problem, tolerance);
    Settling settling(decay, point.r, tolerance);
    PeerAnswer answer;
    double amplitude = 0;
    do {
        answer.ending = integrator.period(amplitude, answer.sticks);
    } while (answer.ending == Ending::answered && !settling.settled(integrator.state()));
    answer.evaluations = problem.equations.evaluations;
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
