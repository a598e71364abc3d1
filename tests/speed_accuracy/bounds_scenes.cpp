#include "tests/speed_accuracy/bounds_scenes.hpp"

#include <algorithm>
#include <cmath>

#include "tests/speed_accuracy/table.hpp"
#include "tests/support/scene_builder.hpp"

namespace denhartog::tests {

double BoundsScenes::spread(double low, double high) { return std::pow(10.0, uniform(low, high)); }

// 1 with a deviation of either sign.
double BoundsScenes::near_one(double low, double high) {
    const double deviation = spread(low, high);
    return whole(0, 1) == 0 ? 1 + deviation : 1 - deviation;
}

std::vector<double> BoundsScenes::damping(std::size_t N) {
    const int kind = whole(0, 5);
    const double same = std::min(0.99, spread(-12, 0));
    std::vector<double> zeta;
    for (std::size_t i = 0; i < N; ++i) {
        const double own = std::min(0.99, spread(-12, 0)), usual = spread(-3, -1);
        zeta.push_back(kind == 0 ? 0 : kind == 1 ? same : kind < 4 ? usual : own);
    }
    return zeta;
}

System<double> BoundsScenes::system() {
    const auto N = static_cast<std::size_t>(whole(1, 12));
    System<double> made;
    for (std::size_t i = 0; i < N; ++i) {
        made.mass_ratios.push_back(i == 0 ? 1 : spread(-1, 1));
        made.stiffness_ratios.push_back(i == 0 ? 1 : spread(-1, 1));
    }
    made.damping_ratios = damping(N);
    made.contact = Mass{static_cast<std::size_t>(whole(0, static_cast<int>(N) - 1))};
    made.load = Mass{static_cast<std::size_t>(whole(0, static_cast<int>(N) - 1))};
    if (N == 1 || whole(0, 3) > 0) return made;
    const auto n = static_cast<Eigen::Index>(N);
    Matrix<double> K = Matrix<double>::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index k = -1; k < i; ++k) { // -1 is the ground; every pair is joined by chance, neighbours always
            if (k + 1 < i && whole(0, 3) > 0) continue;
            connect(K, i, k, spread(-1, 1));
        }
    made.stiffness_matrix = K;
    made.stiffness_ratios.clear();
    return made;
}

SurveyedFrequency BoundsScenes::frequency(const ModalBasis<Bounded<double>>& basis) {
    const int kind = whole(0, 9);
    const double r_n = basis.r_n[static_cast<std::size_t>(whole(0, static_cast<int>(basis.r_n.size()) - 1))].x;
    const double near = near_one(-13, -1), any = spread(-3, 3);
    const int odd = 2 * whole(1, 10) + 1;
    if (kind < 6) return {any, "any r"};
    if (kind < 8) return {r_n * near, "near a resonance"};
    return {r_n * near / odd, "near R = 1/n, n odd"};
}

double BoundsScenes::friction(double beta_lim) {
    const int kind = whole(0, 9);
    const double part = spread(-6, 0.2), near = near_one(-15, -2), any = spread(-6, 1);
    return kind < 4 ? part * beta_lim : kind < 7 ? near * beta_lim : any;
}

double BoundsScenes::instant() {
    const int kind = whole(0, 7);
    const double any = uniform(0, 4 * pi<double>());
    return kind == 0 ? 0 : kind == 1 ? pi<double>() * whole(1, 4) : any;
}

std::string text_of(const Scene<double>& scene, double tau) {
    const auto list = [](const char* name, const std::vector<double>& x) {
        std::string text = std::string(" ") + name + " =";
        for (const double each : x) text += " " + digits(each, "%a");
        return text;
    };
    const System<double>& s = scene.system;
    const Matrix<double>& K = s.stiffness_matrix;
    return "r = " + digits(*scene.r, "%a") + (scene.beta ? " beta = " + digits(*scene.beta, "%a") : "") +
           " tau = " + digits(tau, "%a") + " j = " + std::to_string(s.contact.index + 1) +
           " l = " + std::to_string(s.load.index + 1) + list("gamma", s.mass_ratios) + list("kappa", s.stiffness_ratios) +
           list("K", std::vector<double>(K.data(), K.data() + K.size())) + list("zeta", s.damping_ratios);
}

} // namespace denhartog::tests
