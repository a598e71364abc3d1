#include "tests/support/sample_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/multiprecision.hpp"
#include "tests/support/paper_systems.hpp"
#include "tests/support/split_mix.hpp"

namespace denhartog {
namespace {

/// A fraction with an integer numerator, correctly rounded in T.
template <class T>
T fraction(int numerator, int denominator) {
    return T(numerator) / T(denominator);
}

/// A decimal fraction as text, e.g. "0.2".
std::string decimal(int numerator, int denominator) {
    std::string text = std::to_string(static_cast<double>(numerator) / denominator);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

/// A point of the figures in hundredths of r and of beta.
struct Point {
    int r;
    int beta;
};

template <class T>
void add_points(std::vector<NamedScene<T>>& scenes, const std::string& name, const System<T>& system,
                const std::vector<Point>& points) {
    for (const Point& p : points) {
        Scene<T> scene;
        scene.system = system;
        scene.r = fraction<T>(p.r, 100);
        scene.beta = fraction<T>(p.beta, 100);
        scenes.push_back({name + " r=" + decimal(p.r, 100) + " beta=" + decimal(p.beta, 100), scene});
    }
}

/// A random short binary fraction 8 / 2^k .. 15 / 2^k with k between two bounds: spread over the octaves.
template <class T>
T over_octaves(SplitMix64& random, int k_low, int k_high) {
    const int numerator = random.integer(8, 15);
    return fraction<T>(numerator, 1 << random.integer(k_low, k_high));
}

/// r = (1 + m/64) 2^e in [0.1, 3], equally often in every octave that lies inside.
template <class T>
T random_frequency_ratio(SplitMix64& random) {
    for (;;) {
        const int sixty_fourths = 64 + random.integer(0, 63);
        const int denominator = 64 << random.integer(0, 5);
        const int doubled = 2 * sixty_fourths; // over the denominator: from 1/16 to 4
        if (10 * doubled >= denominator && doubled <= 3 * denominator) return fraction<T>(doubled, denominator);
    }
}

template <class T>
std::vector<T> random_ratios(SplitMix64& random, std::size_t N) {
    std::vector<T> ratios{T(1)};
    while (ratios.size() < N) ratios.push_back(fraction<T>(random.integer(4, 64), 16));
    return ratios;
}

/// Replaces the chain's ratios by matrices: the chain, one spring more between two masses and one to the ground; where asked
/// for, masses coupled in a row as by consistent finite elements.
template <class T>
void change_topology(SplitMix64& random, System<T>& s, bool coupled_masses) {
    const int N = static_cast<int>(s.mass_ratios.size());
    Matrix<T> K = matrix_of_chain(s.stiffness_ratios);
    const int grounded = random.integer(0, N - 1), first = random.integer(0, N - 1), second = random.integer(0, N - 1);
    const T to_ground = fraction<T>(random.integer(4, 32), 16), between = fraction<T>(random.integer(4, 32), 16);
    connect(K, grounded, -1, to_ground);
    if (first != second) connect(K, first, second, between);
    s.stiffness_matrix = K;
    s.stiffness_ratios.clear();
    if (!coupled_masses) return;
    s.mass_matrix = Matrix<T>::Zero(N, N);
    for (int i = 0; i < N; ++i) {
        s.mass_matrix(i, i) = s.mass_ratios[static_cast<std::size_t>(i)];
        if (i > 0) s.mass_matrix(i, i - 1) = s.mass_matrix(i - 1, i) = fraction<T>(random.integer(1, 3), 32);
    }
    s.mass_ratios.clear();
}

/// C = a M + b K, in units of sqrt(k_1 m_1).
template <class T>
Matrix<T> proportional_damping(SplitMix64& random, const System<T>& s) {
    const Eigen::Index N = static_cast<Eigen::Index>(number_of_masses(s));
    const T a = over_octaves<T>(random, 8, 13);
    const T b = over_octaves<T>(random, 8, 13);
    Matrix<T> C = s.stiffness_matrix.size() > 0 ? s.stiffness_matrix : matrix_of_chain(s.stiffness_ratios);
    C *= b;
    if (s.mass_matrix.size() > 0) return C + a * s.mass_matrix;
    for (Eigen::Index i = 0; i < N; ++i) C(i, i) += a * s.mass_ratios[static_cast<std::size_t>(i)];
    return C;
}

/// Damping ratios from 1/1024 to 15/16; in a fifth of the calls half of the modes, at random, have none.
template <class T>
std::vector<T> random_damping_ratios(SplitMix64& random, std::size_t N) {
    const bool some_without = random.integer(0, 4) == 0;
    std::vector<T> zeta;
    while (zeta.size() < N) {
        const T ratio = over_octaves<T>(random, 4, 13);
        zeta.push_back(some_without && random.integer(0, 1) == 0 ? T(0) : ratio);
    }
    return zeta;
}

template <class T>
RandomScene<T> random_scene(SplitMix64& random, std::size_t N, std::size_t n) {
    RandomScene<T> result;
    System<T>& s = result.scene.system;
    s.contact = Mass{n / N % N};
    s.load = Mass{n % N};
    s.mass_ratios = random_ratios<T>(random, N);
    s.stiffness_ratios = random_ratios<T>(random, N);
    const int topology = random.integer(0, 15);
    if (topology < 3) change_topology(random, s, topology == 0);
    if (random.integer(0, 3) == 0)
        s.damping_matrix = proportional_damping(random, s);
    else
        s.damping_ratios = random_damping_ratios<T>(random, N);
    result.scene.mu = fraction<T>(random.integer(16, 48), 16);
    result.scene.r = random_frequency_ratio<T>(random);
    result.fraction_of_limit = random.integer(1, 63) / 64.0;
    return result;
}

} // namespace

template <class T>
std::vector<NamedScene<T>> paper_scenes() {
    std::vector<NamedScene<T>> scenes;
    const std::vector<Point> grid = [] {
        std::vector<Point> points;
        for (int r : {10, 20, 40, 60, 80, 90, 95, 100, 105, 110, 125, 150, 160, 175, 200, 250})
            for (int beta : {2, 5, 10, 20, 40, 60, 80}) points.push_back({r, beta});
        return points;
    }();
    for (int thousandths : {1, 10, 100}) {
        const T zeta = fraction<T>(thousandths, 1000);
        add_points(scenes, "SDOF zeta=" + decimal(thousandths, 1000), single_mass(zeta), grid);
    }
    for (int thousandths : {1, 10, 100}) {
        const T z = fraction<T>(thousandths, 1000);
        add_points(scenes, "2DOF j=2 l=1 zeta_i=" + decimal(thousandths, 1000) + "/r_n,i", two_masses(z), grid);
    }
    for (int j : {1, 3})
        for (int hundredths : {1, 10})
            add_points(scenes, "5DOF j=" + std::to_string(j) + " l=1 zeta=" + decimal(hundredths, 100),
                       five_masses(static_cast<std::size_t>(j), fraction<T>(hundredths, 100)), {{90, 20}});
    return scenes;
}

template <class T>
std::vector<RandomScene<T>> random_scenes(std::uint64_t seed) {
    SplitMix64 random(seed);
    std::vector<RandomScene<T>> scenes;
    for (std::size_t N = 1; N <= 10; ++N)
        for (std::size_t n = 0; n < std::max<std::size_t>(40, N * N); ++n) {
            RandomScene<T> scene = random_scene<T>(random, N, n);
            scene.name = "seed " + std::to_string(seed) + " N=" + std::to_string(N) +
                         " j=" + std::to_string(scene.scene.system.contact.index + 1) +
                         " l=" + std::to_string(scene.scene.system.load.index + 1) + " #" + std::to_string(scenes.size());
            scenes.push_back(scene);
        }
    return scenes;
}

double friction_ratio_at(double fraction, double beta_lim) {
    int exponent = 0;
    const double mantissa = std::frexp(fraction * beta_lim, &exponent);
    return std::ldexp(std::floor(std::ldexp(mantissa, 20)), exponent - 20);
}

template std::vector<NamedScene<double>> paper_scenes();
template std::vector<NamedScene<Real50>> paper_scenes();
template std::vector<NamedScene<Real100>> paper_scenes();
template std::vector<RandomScene<double>> random_scenes(std::uint64_t);
template std::vector<RandomScene<Real50>> random_scenes(std::uint64_t);
template std::vector<RandomScene<Real100>> random_scenes(std::uint64_t);

} // namespace denhartog
