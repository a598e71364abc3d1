#include "tests/support/coupled_scenes.hpp"

#include <cmath>

#include "tests/support/scene_builder.hpp"
#include "tests/support/split_mix.hpp"
#include "tests/support/vector_scenes.hpp"

namespace denhartog {
namespace {

double random_dashpot(SplitMix64& random) {
    if (random.one_in(3)) return 0;
    const int octave = random.integer(3, 10), eighths = random.integer(8, 15);
    return std::ldexp(eighths, -octave); // 2^-7 to 2
}

// To the ground for the first, between neighbours, and to the ground wherever there is another.
Matrix<double> random_dashpots(SplitMix64& random, std::size_t masses) {
    const auto N = static_cast<Eigen::Index>(masses);
    Matrix<double> C = Matrix<double>::Zero(N, N);
    for (Eigen::Index i = 0; i < N; ++i) connect(C, i, i - 1, random_dashpot(random));
    const int octave = random.integer(4, 8), eighths = random.integer(8, 15),
              grounded = random.integer(0, static_cast<int>(N) - 1);
    connect(C, grounded, -1, std::ldexp(eighths, -octave));
    return C;
}

} // namespace

std::vector<RandomScene<double>> random_coupled_scenes(std::uint64_t seed) {
    SplitMix64 random(seed);
    std::vector<RandomScene<double>> scenes = random_vector_scenes(seed);
    std::erase_if(scenes, [](const RandomScene<double>& each) { return number_of_masses(each.scene.system) == 1; });
    for (std::size_t n = 0; n < scenes.size(); ++n) {
        Scene<double>& scene = scenes[n].scene;
        System<double>& s = scene.system;
        s.damping_ratios.clear();
        s.damping_matrix = random_dashpots(random, number_of_masses(s));
        if (n % 2 == 0) scene.mu = 1;
        if (n % 3 != 0) continue;
        s.contact_with.reset();
        s.load_vector.clear();
    }
    return scenes;
}

} // namespace denhartog
