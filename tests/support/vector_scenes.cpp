#include "tests/support/vector_scenes.hpp"

#include "tests/support/split_mix.hpp"

namespace denhartog {
namespace {

// On several masses; in one of six scenes, and on a single mass, on the contact alone, with any size and sign.
std::vector<double> random_forces(SplitMix64& random, std::size_t N, std::size_t contact) {
    std::vector<double> forces(N);
    for (double& force : forces) force = random.one_in(3) ? 0 : random.integer(-8, 8) / 8.0;
    if (N > 1) forces[contact == 0 ? 1 : 0] = random.integer(1, 8) / 8.0;
    if (N == 1 || random.one_in(6)) {
        forces.assign(N, 0);
        forces[contact] = (random.one_in(2) ? 1 : -1) * random.integer(1, 16) / 8.0;
    }
    return forces;
}

std::vector<double> forces_of_inertia(const System<double>& s) {
    if (s.mass_matrix.size() == 0) return s.mass_ratios;
    const Eigen::VectorXd sums = s.mass_matrix.rowwise().sum();
    return {sums.begin(), sums.end()};
}

} // namespace

std::vector<RandomScene<double>> random_vector_scenes(std::uint64_t seed) {
    SplitMix64 random(seed);
    std::vector<RandomScene<double>> scenes;
    for (RandomScene<double> each : random_scenes<double>(seed)) {
        System<double>& s = each.scene.system;
        const std::size_t N = number_of_masses(s);
        const int kind = N == 1 ? 2 : random.integer(1, 5);
        if (kind != 2 && kind != 4) {
            const auto away = static_cast<std::size_t>(random.integer(1, static_cast<int>(N) - 1));
            s.contact_with = Mass{(s.contact.index + away) % N};
        }
        if (kind == 2 || kind == 3) s.load_vector = random_forces(random, N, s.contact.index);
        if (kind == 4 || kind == 5) s.load_vector = forces_of_inertia(s);
        scenes.push_back(std::move(each));
    }
    return scenes;
}

} // namespace denhartog
