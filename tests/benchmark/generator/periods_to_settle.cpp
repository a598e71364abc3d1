// The motion from rest on the physical coordinates, phase by phase: matrix exponentials in 50 digits, and no modes.
#include <algorithm>

#include "tests/benchmark/generator/motion.hpp"
#include "tests/support/event_integrator.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog::benchmark {
namespace {

using Number = Real50;
using std::abs;

constexpr int most_periods = 20000;
constexpr int steps = 128; // a period: no phase of the scenes that ends in one and starts another is shorter

} // namespace

std::vector<int> periods_to_settle(const Scene<double>& scene, const Motion& settled, const std::vector<double>& tolerances) {
    const Sample& end = settled.samples.front();
    const std::size_t N = end.x.size();
    Number largest(0);
    for (std::size_t k = 0; k < N; ++k) largest = std::max({largest, Number(abs(end.x[k])), Number(abs(end.x_prime[k]))});
    if (largest == 0) largest = 1;
    std::vector<int> periods(tolerances.size(), 0);
    std::size_t next = 0;
    const HalfPeriodProblem<Number> problem = half_period_problem(scene);
    tests::EventIntegrator<Number> motion(problem, Number(scene.mu) * problem.beta, steps);
    const Vector<Number> zero = Vector<Number>::Zero(static_cast<Eigen::Index>(N));
    motion.start(zero, zero);
    for (int n = 1; n <= most_periods && next < tolerances.size(); ++n) {
        const tests::FollowedMotion<Number>& now = motion.go_on(steps);
        Number apart(0);
        for (std::size_t k = 0; k < N; ++k)
            apart = std::max({apart, Number(abs(now.x(static_cast<Eigen::Index>(k)) - end.x[k])),
                              Number(abs(now.x_prime(static_cast<Eigen::Index>(k)) - end.x_prime[k]))});
        while (next < tolerances.size() && apart <= tolerances[next] * largest) periods[next++] = n;
    }
    return periods;
}

} // namespace denhartog::benchmark
