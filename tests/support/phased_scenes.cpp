#include "tests/support/phased_scenes.hpp"

#include "denhartog/model/contact_and_load.hpp"
#include "tests/support/split_mix.hpp"
#include "tests/support/vector_scenes.hpp"

namespace denhartog {

std::vector<RandomScene<double>> random_phased_scenes(std::uint64_t seed) {
    SplitMix64 random(seed);
    std::vector<RandomScene<double>> scenes = random_vector_scenes(seed);
    for (RandomScene<double>& each : scenes) {
        System<double>& s = each.scene.system;
        const std::size_t N = number_of_masses(s);
        if (s.load_vector.empty()) {
            s.load_vector.assign(N, 0);
            s.load_vector[s.load.index] = 1;
        }
        s.load_vector[(s.load.index + 1) % N] = random.integer(1, 12) / 8.0;
        for (std::size_t k = 0; k < N; ++k) s.load_phases.push_back(random.integer(-32, 32) / 8.0);
        s.load_phases[s.load.index] = random.integer(1, 20) / 8.0;
    }
    return scenes;
}

std::vector<RandomScene<double>> random_base_scenes(std::uint64_t seed) {
    SplitMix64 random(seed);
    std::vector<RandomScene<double>> scenes;
    for (RandomScene<double> each : random_scenes<double>(seed)) {
        System<double>& s = each.scene.system;
        const std::size_t N = number_of_masses(s);
        constexpr BaseMotion motions[] = {BaseMotion::with_wall, BaseMotion::alone, BaseMotion::wall};
        s.base_motion = motions[random.integer(0, 2)];
        if (N > 1 && s.base_motion != BaseMotion::wall && random.one_in(4)) s.contact_with = Mass{(s.contact.index + 1) % N};
        const Matrix<double> A = s.base_motion == BaseMotion::with_wall ? mass_matrix(s) : stiffness_matrix(s);
        const Eigen::VectorXd sums = A.rowwise().sum();
        s.load_vector.assign(sums.begin(), sums.end());
        if (N > 1 || s.damping_ratios.empty() || s.damping_ratios[0] > 0) scenes.push_back(std::move(each));
    }
    return scenes;
}

std::vector<RandomScene<double>> random_direction_scenes(std::uint64_t seed) {
    SplitMix64 random(seed);
    std::vector<RandomScene<double>> all = random_vector_scenes(seed), phased = random_phased_scenes(seed), scenes;
    for (std::size_t n = 0; n < all.size(); ++n) {
        RandomScene<double>& each = n % 2 != 0 ? phased[n] : all[n];
        System<double>& s = each.scene.system;
        s.contact_with.reset();
        const std::size_t N = number_of_masses(s), j = s.contact.index;
        if (N == 1) continue;
        constexpr double sizes[] = {0.5, 1, 2};
        for (std::size_t k = 0; k < N; ++k) s.contact_direction.push_back(random.one_in(3) ? 0 : random.integer(-16, 16) / 8.0);
        s.contact_direction[(j + 1) % N] = random.integer(1, 16) / 8.0;
        s.contact_direction[j] = (random.one_in(2) ? 1 : -1) * sizes[random.integer(0, 2)];
        scenes.push_back(std::move(each));
    }
    return scenes;
}

} // namespace denhartog
