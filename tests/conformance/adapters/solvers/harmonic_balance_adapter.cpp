// Harmonic balance with exact friction in time under the conformance kit: harmonic_balance_adapter [HIGHEST].
#include <cmath>
#include <iostream>
#include <numbers>

#include "denhartog/number/errors.hpp"
#include "tests/conformance/adapters/solvers/solver_adapter.hpp"
#include "tests/speed_accuracy/peers/peers.hpp"

namespace {

using namespace denhartog;
using namespace denhartog::tests;
using Json = nlohmann::ordered_json;

constexpr double period = 2 * std::numbers::pi;

// Where a motion is largest: the largest of equally spaced samples, and the parabola through it and its neighbours.
double instant_of_largest(const std::function<double(double)>& motion) {
    constexpr int steps = 4096;
    constexpr double h = period / steps;
    int largest = 0;
    for (int n = 1; n < steps; ++n)
        if (motion(n * h) > motion(largest * h)) largest = n;
    const double before = motion((largest - 1) * h), at = motion(largest * h), after = motion((largest + 1) * h);
    return std::remainder(h * (largest + (before - after) / 2 / (before - 2 * at + after)), period);
}

Json answer(const conformance::ProtocolQuestion& q, const Scene<double>& scene, const Peer& method) {
    if (q.quantity != "amplitude" && q.quantity != "phase" && q.quantity != "motion_under_force")
        return {{"skip", "no quantity of a motion of some harmonics"}};
    if (q.mass != q.contact) return {{"skip", "harmonic balance is condensed to the contact"}};
    if (scene.mu > 1) return {{"skip", "one bound for rest and sliding: mu = 1 only"}};
    const PeerAnswer found = method.prepare(scene.system)({*scene.r, *scene.beta});
    if (found.ending != Ending::answered || !found.motion) return {{"skip", "Newton's method does not converge"}};
    if (q.quantity == "amplitude") return {{"value", found.amplitude}};
    if (q.quantity == "phase") return {{"value", instant_of_largest(found.motion)}};
    std::vector<double> x;
    for (int n = 0; n < q.samples; ++n) x.push_back(found.motion(period * n / q.samples));
    return {{"value", x}};
}

} // namespace

int main(int argc, char** argv) {
    try {
        const int highest = argc > 1 ? static_cast<int>(positive(argv[1])) : 51;
        const Peer method = harmonic_balance({FrictionLaw::augmented_lagrangian, highest});
        return serve(
            "harmonic balance up to harmonic " + std::to_string(highest),
            [&](const conformance::ProtocolQuestion& q, const Scene<double>& scene) { return answer(q, scene, method); },
            std::cin, std::cout);
    } catch (const InputError& e) {
        std::cerr << e.what() << '\n';
        return 2;
    }
}
