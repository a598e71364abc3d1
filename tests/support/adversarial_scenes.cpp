#include "tests/support/adversarial_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "denhartog/denhartog.hpp"
#include "denhartog/model/modal_basis.hpp"
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

std::size_t AdversarialScenes::masses() {
    const int kind = random_.integer(0, 99);
    const auto up_to = [this](int low, int high) {
        const auto N = static_cast<std::size_t>(random_.integer(low, high));
        return std::min(N, range_.most);
    };
    return kind < 20 ? 1 : kind < 75 ? up_to(2, 4) : kind < 94 ? up_to(5, 12) : kind < 99 ? up_to(13, 40) : up_to(41, 200);
}

// A ratio of masses or springs: all the same, mild, nearly the same, or at the ends of the contrast.
double AdversarialScenes::ratio(int kind) {
    if (kind == 0) return 1;
    if (kind == 1) return random_.over_octaves(-2, 1);
    if (kind == 2) return random_.near_one(-52, -8);
    if (kind == 3) return random_.over_octaves(-range_.contrast, range_.contrast - 1);
    const int end = random_.integer(-1, 1);
    return std::ldexp(1, end * range_.contrast);
}

void AdversarialScenes::chain(System<double>& s, std::size_t N) {
    const int of_masses = random_.integer(0, 4), of_springs = random_.integer(0, 4);
    for (std::size_t i = 0; i < N; ++i) {
        s.mass_ratios.push_back(i == 0 ? 1 : ratio(of_masses));
        s.stiffness_ratios.push_back(i == 0 ? 1 : ratio(of_springs));
    }
}

// Every mass on a spring to the ground of its own, nearly the same for all or not, and weak springs between some of them.
void AdversarialScenes::coupled(System<double>& s, std::size_t N) {
    const int of_masses = random_.integer(0, 2), of_springs = random_.integer(0, 4);
    const int weak = random_.integer(-60, 0);
    const auto n = static_cast<Eigen::Index>(N);
    Matrix<double> K = Matrix<double>::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        s.mass_ratios.push_back(i == 0 ? 1 : ratio(of_masses));
        K(i, i) += ratio(of_springs);
        for (Eigen::Index k = 0; k < i; ++k) {
            if (k + 1 < i && !random_.one_in(3)) continue;
            const double spring = random_.over_octaves(weak, weak + 3);
            connect(K, i, k, spring);
        }
    }
    s.stiffness_matrix = K;
}

// A mass matrix in place of mass ratios, with couplings that leave it positive definite.
void AdversarialScenes::mass_matrix(System<double>& s) {
    const auto n = static_cast<Eigen::Index>(s.mass_ratios.size());
    Matrix<double> M = Matrix<double>::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        M(i, i) = s.mass_ratios[static_cast<std::size_t>(i)];
        if (i > 0) M(i, i - 1) = M(i - 1, i) = std::min(M(i, i), M(i - 1, i - 1)) * random_.over_octaves(-40, -3);
    }
    s.mass_matrix = M;
    s.mass_ratios.clear();
}

void AdversarialScenes::damping(System<double>& s, std::size_t N) {
    const int kind = random_.integer(0, 9);
    if (kind == 9) { // C = a M + b K
        const double a = random_.over_octaves(-20, 2), b = random_.over_octaves(-20, 2);
        const auto n = static_cast<Eigen::Index>(N);
        Matrix<double> M = s.mass_matrix;
        if (M.size() == 0) M = Eigen::Map<const Eigen::VectorXd>(s.mass_ratios.data(), n).asDiagonal();
        s.damping_matrix = a * M + b * (s.stiffness_matrix.size() > 0 ? s.stiffness_matrix : matrix_of_chain(s.stiffness_ratios));
        return;
    }
    const double same = random_.over_octaves(range_.zeta_low, range_.zeta_high);
    for (std::size_t i = 0; i < N; ++i) {
        const double own = random_.over_octaves(range_.zeta_low, range_.zeta_high), usual = random_.over_octaves(-10, -4);
        const double critical = random_.near_one(-52, -4);
        const double mixed = random_.one_in(3) ? 0 : own;
        s.damping_ratios.push_back(kind == 0   ? 0
                                   : kind < 3  ? same
                                   : kind < 6  ? usual
                                   : kind == 6 ? critical
                                   : kind == 7 ? mixed
                                               : own);
    }
}

void AdversarialScenes::frequency(AdversarialScene& made, std::size_t N) {
    const int kind = random_.integer(0, 9);
    const double any = random_.over_octaves(range_.r_low, range_.r_high), usual = random_.over_octaves(-4, 1);
    const double near = random_.near_one(-52, -3);
    const int odd = 2 * random_.integer(0, 10) + 1;
    if (kind >= 7) made.mode = static_cast<std::size_t>(random_.integer(0, static_cast<int>(N) - 1));
    made.scene.r = kind < 3 ? any : kind < 7 ? usual : kind < 9 ? near : near / odd;
}

void AdversarialScenes::friction(AdversarialScene& made) {
    const int kind = random_.integer(0, 19);
    const double any = random_.over_octaves(range_.beta_low, range_.beta_high), usual = random_.over_octaves(-6, 1);
    const double near = random_.near_one(-52, -3), part = random_.over_octaves(-20, 1);
    if (kind < 2) {
        made.scene.beta = 0;
    } else if (kind < 4) {
        made.scene.beta = any;
    } else if (kind < 9) {
        made.scene.beta = usual;
    } else if (kind == 9) {
        made.scene.beta = std::ldexp(1, range_.beta_high);
    } else {
        made.of_limit = kind == 10 ? 1 : kind < 15 ? near : part;
    }
    const int of_mu = random_.integer(0, 9);
    const double much = random_.over_octaves(0, range_.mu_high), little = random_.over_octaves(-52, 0);
    made.scene.mu = of_mu < 6 ? 1 : of_mu < 9 ? 1 + little : much;
}

// A contact between two masses, a load on several, dashpots anywhere: each in one scene of four.
void AdversarialScenes::other_kinds(System<double>& s, std::size_t N) {
    const auto last = static_cast<int>(N) - 1;
    if (of_kinds_.one_in(4)) {
        const Mass other{static_cast<std::size_t>(of_kinds_.integer(0, last))};
        if (other != s.contact) s.contact_with = other;
    }
    if (of_kinds_.one_in(4)) {
        const int kind = of_kinds_.integer(0, 2);
        for (std::size_t k = 0; k < N; ++k) {
            const double size = kind == 0 ? 1 : of_kinds_.over_octaves(kind == 1 ? -2 : -range_.contrast, 1);
            const bool none = of_kinds_.one_in(3);
            s.load_vector.push_back(none ? 0 : of_kinds_.one_in(2) ? size : -size);
        }
        if (std::ranges::count(s.load_vector, 0) == static_cast<std::ptrdiff_t>(N)) s.load_vector.clear();
    }
    if (!of_kinds_.one_in(4)) return;
    const auto n = static_cast<Eigen::Index>(N);
    if (s.damping_matrix.size() == 0) s.damping_matrix = Matrix<double>::Zero(n, n);
    s.damping_ratios.clear();
    const int octave = of_kinds_.integer(-30, range_.zeta_high);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double c = of_kinds_.one_in(2) ? 0 : of_kinds_.over_octaves(octave, octave + 3);
        const auto k = static_cast<Eigen::Index>(of_kinds_.integer(0, last));
        connect(s.damping_matrix, i, k, c);
    }
}

AdversarialScene AdversarialScenes::next() {
    if (range_.in_units) return scene_in_units(random_);
    AdversarialScene made;
    System<double>& s = made.scene.system;
    const std::size_t N = masses();
    s.contact = Mass{static_cast<std::size_t>(random_.integer(0, static_cast<int>(N) - 1))};
    s.load = Mass{static_cast<std::size_t>(random_.integer(0, static_cast<int>(N) - 1))};
    const bool as_matrix = random_.one_in(4);
    if (as_matrix)
        coupled(s, N);
    else
        chain(s, N);
    if (as_matrix) s.stiffness_ratios.clear();
    if (random_.one_in(8)) mass_matrix(s);
    damping(s, N);
    if (range_.every_kind) other_kinds(s, N);
    frequency(made, N);
    friction(made);
    return made;
}

Scene<double> placed(const AdversarialScene& drawn) {
    Scene<double> scene = drawn.scene;
    if (drawn.mode) {
        check(scene);
        *scene.r *= modal_basis(scene.system).r_n[*drawn.mode];
    }
    if (drawn.of_limit) scene.beta = *drawn.of_limit * boundary(scene, 12).exact.value;
    return scene;
}

std::string json_of(const Scene<double>& scene) { return write_scene(scene).dump(); }

} // namespace denhartog
