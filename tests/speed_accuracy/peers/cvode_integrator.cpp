#include "tests/speed_accuracy/peers/cvode_integrator.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace denhartog::tests {
namespace {

constexpr long most_right_hand_sides = 2'000'000; // from a start on
constexpr int most_phases_a_period = 1000;

/// The equations in the phase that they are in, as CVODE's functions see them.
struct Problem {
    ContactEquations equations;
    int direction = 1;
    std::vector<double> y, y_prime;

    [[nodiscard]] double contact_velocity(const double* state) const { return equations.contact.of(state + equations.N); }
};

int right_hand_side(double tau, N_Vector y, N_Vector y_prime, void* data) {
    auto& p = *static_cast<Problem*>(data);
    std::copy_n(N_VGetArrayPointer(y), p.y.size(), p.y.begin());
    p.equations(p.y, p.y_prime, tau);
    if (y_prime != nullptr) std::ranges::copy(p.y_prime, N_VGetArrayPointer(y_prime));
    return 0;
}

enum Root : std::uint8_t { first, second, extremum, number_of_roots };

// While the contact slides, the first event is its velocity. While it sticks, the first two are what the load leaves of static
// friction on either side, and the third is the rate of the load. CVODE compares the ends of a step, and within one the load can
// exceed static friction and come back; at the root of its rate it is largest.
int events(double tau, N_Vector y, double* event, void* data) {
    auto& p = *static_cast<Problem*>(data);
    const std::span<const double> state(N_VGetArrayPointer(y), p.y.size());
    const double held = p.equations.mu * p.equations.beta;
    const double load = p.direction == 0 ? p.equations.load_on_contact(state, tau) : 0;
    event[first] = p.direction == 0 ? held - load : p.contact_velocity(state.data());
    event[second] = held + load;
    event[extremum] = 1;
    if (p.direction != 0) return 0;
    right_hand_side(tau, y, nullptr, data);
    event[extremum] = p.equations.linear_load(p.y_prime) + p.equations.harmonic_load_at(tau).sine;
    return 0;
}

} // namespace

struct CvodeIntegrator::Memory {
    Memory(const ContactProblem& contact_problem, double tolerance) : problem{ContactEquations(contact_problem), 1, {}, {}} {
        problem.y.assign(2 * problem.equations.N, 0);
        problem.y_prime = problem.y;
        SUNContext_Create(nullptr, &context);
        y = N_VNew_Serial(static_cast<sunindextype>(problem.y.size()), context);
        N_VConst(0, y);
        cvode = CVodeCreate(CV_ADAMS, context);
        CVodeInit(cvode, right_hand_side, 0, y);
        CVodeSStolerances(cvode, tolerance, tolerance);
        iteration = SUNNonlinSol_FixedPoint(y, 0, context);
        CVodeSetNonlinearSolver(cvode, iteration);
        CVodeSetUserData(cvode, &problem);
        CVodeSetMaxNumSteps(cvode, most_right_hand_sides);
        CVodeSetMaxStep(cvode, std::numbers::pi / 8);
        CVodeRootInit(cvode, number_of_roots, events);
        CVodeSetNoInactiveRootWarn(cvode);
        CVodeSetErrFile(cvode, nullptr);
        start_phase();
    }
    ~Memory() {
        CVodeFree(&cvode);
        SUNNonlinSolFree(iteration);
        N_VDestroy(y);
        SUNContext_Free(&context);
    }
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;

    [[nodiscard]] std::span<double> state() const { return {N_VGetArrayPointer(y), problem.y.size()}; }

    // A contact that moves slides on. One that stuck until now is let go. Any other at rest sticks if friction holds the load,
    // and turns back if not.
    void start_phase() {
        const double load = problem.equations.load_on_contact(state(), tau), velocity = problem.contact_velocity(state().data());
        const bool was_sticking = problem.direction == 0;
        const bool holds = velocity == 0 && !was_sticking && std::abs(load) <= problem.equations.mu * problem.equations.beta;
        problem.direction = holds ? 0 : ((velocity != 0 ? velocity : load) > 0 ? 1 : -1);
        problem.equations.set(problem.direction);
        std::array<int, number_of_roots> falling{-1, -1, 0};
        if (!holds) falling[first] = -problem.direction;
        CVodeSetRootDirection(cvode, falling.data());
    }

    Problem problem;
    SUNContext context = nullptr;
    N_Vector y = nullptr;
    void* cvode = nullptr;
    SUNNonlinearSolver iteration = nullptr;
    double tau = 0;
    int periods = 0;
    long evaluations_before = 0;
};

CvodeIntegrator::CvodeIntegrator(const ContactProblem& problem, double tolerance) : memory_(new Memory(problem, tolerance)) {}
CvodeIntegrator::~CvodeIntegrator() = default;
std::span<const double> CvodeIntegrator::state() const { return memory_->state(); }
long CvodeIntegrator::evaluations() const { return memory_->problem.equations.evaluations; }

void CvodeIntegrator::restart(const std::vector<double>& y) {
    Memory& m = *memory_;
    std::ranges::copy(y, m.state().begin());
    m.tau = 0;
    m.periods = 0;
    m.evaluations_before = evaluations();
    m.problem.direction = 1;
    m.start_phase();
    CVodeReInit(m.cvode, 0, m.y);
}

Ending CvodeIntegrator::period(int parts, const Seen& seen) {
    Memory& m = *memory_;
    const double start = 2 * std::numbers::pi * m.periods, end = 2 * std::numbers::pi * ++m.periods;
    seen(m.tau, m.state(), m.problem.direction);
    CVodeSetStopTime(m.cvode, end);
    int phases = 0;
    for (int part = 1; part <= parts;) {
        const double wanted = part == parts ? end : start + 2 * std::numbers::pi * part / parts;
        const int flag = CVode(m.cvode, wanted, m.y, &m.tau, CV_NORMAL);
        if (flag < 0 || evaluations() - m.evaluations_before > most_right_hand_sides) return Ending::did_not_finish;
        if (!std::ranges::all_of(m.state(), [](double x) { return std::isfinite(x); })) return Ending::not_a_number;
        if (flag == CV_ROOT_RETURN) {
            std::array<int, number_of_roots> found{};
            CVodeGetRootInfo(m.cvode, found.data());
            if (found[first] == 0 && found[second] == 0) continue; // the contact stays
            if (++phases > most_phases_a_period) return Ending::stalled;
            m.problem.equations.contact.hold(m.state().data() + m.problem.equations.N);
            m.start_phase();
            CVodeReInit(m.cvode, m.tau, m.y);
            CVodeSetStopTime(m.cvode, end);
        } else {
            ++part;
        }
        seen(m.tau, m.state(), m.problem.direction);
    }
    return Ending::answered;
}

} // namespace denhartog::tests
