#include "tests/support/scenes_in_units.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "denhartog/denhartog.hpp"
#include "tests/support/scene_builder.hpp"

namespace denhartog {
namespace {

using nlohmann::json;

json rows_of(const Matrix<double>& A) {
    json rows = json::array();
    for (const auto& row : A.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
    return rows;
}

// Masses of about one size, some of them light.
std::vector<double> masses(SplitMix64& random, int N) {
    const double size = random.over_octaves(-4, 12);
    const bool with_light = random.one_in(2);
    std::vector<double> m;
    for (int i = 0; i < N; ++i) {
        const double usual = random.over_octaves(-1, 0), light = random.over_octaves(-33, -4);
        const bool is_light = with_light && random.one_in(3);
        m.push_back(size * (is_light ? light : usual));
    }
    return m;
}

// The masses on a chain of springs to the ground; with further springs where it is no chain.
Matrix<double> springs(SplitMix64& random, int N, double size, bool chain, std::vector<double>& of_chain) {
    for (int i = 0; i < N; ++i) of_chain.push_back(size * random.over_octaves(-1, 1));
    Matrix<double> K = matrix_of_chain(of_chain);
    for (int i = 0; i < N && !chain; ++i) {
        for (int k = -1; k + 1 < i; ++k) {
            const double spring = size * random.over_octaves(-4, 0);
            if (random.one_in(3)) connect(K, i, k, spring);
        }
    }
    return K;
}

// The inertia of rods between neighbours.
Matrix<double> with_rods(SplitMix64& random, const std::vector<double>& m) {
    const auto N = static_cast<Eigen::Index>(m.size());
    Matrix<double> M = Matrix<double>::Zero(N, N);
    for (Eigen::Index i = 0; i < N; ++i) {
        M(i, i) += m[static_cast<std::size_t>(i)];
        if (i == 0) continue;
        const double rod =
            std::min(m[static_cast<std::size_t>(i)], m[static_cast<std::size_t>(i - 1)]) * random.over_octaves(-6, -1);
        M(i, i) += rod / 3;
        M(i - 1, i - 1) += rod / 3;
        M(i, i - 1) = M(i - 1, i) = rod / 6;
    }
    return M;
}

// Dashpots to the ground and between some of the masses.
Matrix<double> dashpots(SplitMix64& random, int N, double size) {
    Matrix<double> C = Matrix<double>::Zero(N, N);
    for (int i = 0; i < N; ++i) {
        const double c = size * random.over_octaves(-8, -3);
        const int k = random.one_in(2) ? i - 1 : random.integer(-1, N - 1);
        if (!random.one_in(3)) connect(C, i, k, c);
    }
    return C;
}

void set_damping(SplitMix64& random, const Matrix<double>& M, const Matrix<double>& K, double of_dashpots, double omega,
                 json& scene) {
    const auto N = static_cast<int>(K.rows());
    const int kind = random.integer(0, 9);
    if (kind < 1) {
        scene["damping_ratios"] = 0;
    } else if (kind < 3) {
        scene["damping_ratios"] = random.over_octaves(-9, -4);
    } else if (kind < 5) {
        scene["damping_ratios"] = json::array();
        for (int i = 0; i < N; ++i) scene["damping_ratios"].push_back(random.over_octaves(-10, -3));
    } else if (kind < 7) {
        const double of_masses = omega * random.over_octaves(-9, -4), of_springs = random.over_octaves(-9, -4) / omega;
        scene["damping_matrix"] = rows_of(Matrix<double>(of_masses * M + of_springs * K));
    } else {
        scene["damping_matrix"] = rows_of(dashpots(random, N, of_dashpots));
    }
}

void set_contact_and_load(SplitMix64& random, int N, bool undamped, json& scene) {
    const int contact = random.integer(1, N), other = random.integer(1, N), load = random.integer(1, N);
    if (other != contact && random.one_in(3))
        scene["contact"] = {contact, other};
    else
        scene["contact"] = contact;
    const int kind = random.integer(0, 9);
    if (kind < 3) {
        scene["base_motion"] = undamped && random.one_in(2) ? "alone" : "with_wall";
    } else if (kind < 5) {
        scene["load"] = json::array();
        for (int i = 1; i <= N; ++i) {
            const double size = random.over_octaves(-3, 0);
            const bool none = i != load && random.one_in(2);
            scene["load"].push_back(none ? 0 : size);
        }
    } else {
        scene["load"] = load;
    }
}

} // namespace

AdversarialScene scene_in_units(SplitMix64& random) {
    const int N = random.one_in(4) ? 1 : random.integer(2, 8);
    const std::vector<double> m = masses(random, N);
    const double heaviest = *std::ranges::max_element(m), omega = random.over_octaves(0, 10);
    const bool chain = random.one_in(2), rods = !chain && random.one_in(3);
    std::vector<double> of_chain;
    const Matrix<double> K = springs(random, N, heaviest * omega * omega, chain, of_chain);
    const Matrix<double> M =
        rods ? with_rods(random, m) : Matrix<double>(Eigen::Map<const Eigen::VectorXd>(m.data(), N).asDiagonal());
    json text;
    text["masses"] = chain ? json(m) : rows_of(M);
    text["stiffnesses"] = chain ? json(of_chain) : rows_of(K);
    set_damping(random, M, K, heaviest * omega, omega, text);
    const bool undamped = text.contains("damping_ratios") && text["damping_ratios"] == 0;
    set_contact_and_load(random, N, undamped, text);
    const double mu = 1 + random.over_octaves(-5, -2);
    if (random.one_in(4)) text["mu"] = mu;
    AdversarialScene made;
    made.scene = scene(text.dump());
    const bool low = random.one_in(2); // a mode that people look at, or any
    made.mode = static_cast<std::size_t>(random.integer(0, low ? 0 : N - 1));
    made.scene.r = random.one_in(4) ? random.near_one(-8, -4) : random.over_octaves(-3, 1);
    const double friction = random.over_octaves(-6, 1), of_limit = random.over_octaves(-2, 1);
    if (random.one_in(2))
        made.scene.beta = friction;
    else
        made.of_limit = of_limit;
    return made;
}

} // namespace denhartog
