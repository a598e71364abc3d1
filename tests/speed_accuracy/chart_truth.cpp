#include "tests/speed_accuracy/chart_truth.hpp"

#include <algorithm>

#include "denhartog/solve/solve.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::tests {
namespace {

Real100 whole(const PeerAnswer& answer) {
    Real100 sum(answer.amplitude);
    for (const double part : answer.beyond) sum += Real100(part);
    return sum;
}

ChartTruth solved(const System<double>& system, const ChartPoint& point, int digits) {
    Scene<double> scene;
    scene.system = system;
    scene.r = point.r;
    scene.beta = point.beta;
    const Solution s = solve(scene_source(scene), {Asked::amplitude, digits, false, system.contact});
    ChartTruth truth;
    truth.regime = s.regime.regime;
    truth.answer.sticks = truth.regime != Regime::continuous;
    const Certified& X_j = s.masses.front().amplitude;
    set_amplitude(truth.answer, X_j.decimal.empty() ? Real100(X_j.value) : Real100(X_j.decimal));
    return truth;
}

} // namespace

ChartTruth truth_at(const System<double>& system, const ChartPoint& point) {
    ChartTruth truth = solved(system, point, 40);
    if (truth.regime == Regime::permanent_sticking) return truth;
    constexpr double step = 0x1p-20;
    for (const bool of_r : {true, false}) {
        const auto moved = [&](double by) {
            return ChartPoint{of_r ? point.r * (1 + by) : point.r, of_r ? point.beta : point.beta * (1 + by)};
        };
        const Real100 change = whole(solved(system, moved(step), 20).answer) - whole(solved(system, moved(-step), 20).answer);
        truth.condition += std::abs(static_cast<double>(change / whole(truth.answer))) / (2 * step);
    }
    return truth;
}

double error_of(const PeerAnswer& answer, const ChartTruth& truth) {
    if (truth.regime == Regime::permanent_sticking) return 0;
    const Real100 exact = whole(truth.answer);
    return std::max(1e-36, std::abs(static_cast<double>((whole(answer) - exact) / exact)));
}

} // namespace denhartog::tests
