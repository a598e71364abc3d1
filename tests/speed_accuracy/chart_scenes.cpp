#include "tests/speed_accuracy/chart_scenes.hpp"

#include <random>

#include "denhartog/sliding/boundary.hpp"
#include "tests/support/paper_systems.hpp"
#include "tests/support/sample_scenes.hpp"

namespace denhartog::tests {
namespace {

/// Numbers from 0 to 1 that do not depend on the platform.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : engine_(seed) {}
    double between(double from, double to) { return from + (to - from) * static_cast<double>(engine_() >> 11) * 0x1p-53; }

private:
    std::mt19937_64 engine_;
};

double beta_lim(const System<double>& system, double r) {
    return boundary(mode_sums(modal_basis(system), system.contact, system.load, r), 1.0).exact;
}

// Points that slide, at 1/64 to 63/64 of the boundary.
ChartScene sliding(const std::string& name, const System<double>& system, double from, double to, int points, Draw& draw) {
    ChartScene scene{name, system, {}};
    while (static_cast<int>(scene.points.size()) < points) {
        const double r = draw.between(from, to), limit = beta_lim(system, r);
        if (limit > 0) scene.points.push_back({r, friction_ratio_at(draw.between(1.0 / 64, 63.0 / 64), limit)});
    }
    return scene;
}

} // namespace

std::vector<ChartScene> chart_scenes(std::uint64_t seed, int points) {
    Draw draw(seed);
    std::vector<ChartScene> scenes{sliding("SDOF, sliding", single_mass(0.1), 0.3, 2.5, points, draw)};
    ChartScene stick_slip{"SDOF, stick-slip", single_mass(0.01), {}};
    const double limit = beta_lim(stick_slip.system, 0.1);
    for (int n = 0; n < points; ++n) stick_slip.points.push_back({0.1, draw.between(limit + 0.01, 0.95)});
    scenes.push_back(stick_slip);
    ChartScene sweep{"2DOF, all regimes", two_masses(0.01), {}};
    for (int n = 0; n < 2 * points; ++n) sweep.points.push_back({0.1 + 2.9 * (n + 0.5) / (2 * points), 0.3});
    scenes.push_back(sweep);
    scenes.push_back(sliding("5DOF, j = 3, l = 1", five_masses<double>(3, 0.1), 0.3, 1.9, points, draw));
    const System<double> long_chain = equal_chain<double>(50, 10, 1, std::vector<double>(50, 0.05));
    scenes.push_back(sliding("N = 50", long_chain, 0.3, 1.9, std::max(1, points / 4), draw));
    return scenes;
}

} // namespace denhartog::tests
