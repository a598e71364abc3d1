#include <cstdio>
#include <denhartog/denhartog.hpp>

int main() {
    const denhartog::Scene<double> scene = denhartog::scene(R"({
        "mass_ratios": [1, 2.5, 0.75], "stiffness_ratios": [1, 0.625, 1.875], "damping_ratios": [0.03, 0.06, 0.09],
        "contact": 2, "load": 1, "r": 1.125, "beta": 0.15625})");

    const denhartog::Solution answer = denhartog::solve(scene, {.digits = 10});
    const denhartog::Certified X_j = answer.amplitude(scene.system.contact);
    std::printf("%s: X_j = %.10f, off by %.1e at most\n", name(answer.regime.regime).c_str(), X_j.value, X_j.error);

    const denhartog::Limits limits = denhartog::boundary(scene);
    std::printf("the contact slides throughout below beta = %.6f\n", limits.exact.value);

    const denhartog::RegimeMap map = denhartog::map(scene, {0.5, 1.0, 1.5}, {0.1, 0.4, 0.7, 1.0});
    for (const denhartog::MapPoint& point : map.points) std::printf("%s ", name(point.regime).c_str());

    const denhartog::SampledSolution motion = denhartog::motion(scene, 200);
    std::printf("\nx_2 at the maximum of the force: %.6f\n", motion.at(0).x[1]);
}
