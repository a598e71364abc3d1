#include "tests/support/kinds_of_scenes.hpp"

#include <cmath>

#include "denhartog/model/contact_and_load.hpp"
#include "tests/support/scene_builder.hpp"
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
