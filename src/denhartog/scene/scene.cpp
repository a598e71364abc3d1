// The rules that a scene keeps: every number finite and in its range, matrices symmetric and positive definite, contact and load
// that exist. The first rule that is broken is named with its value. Read `check_system`.
#include "denhartog/scene/scene.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/number/ball_or_none.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/cholesky.hpp"
#include "denhartog/scene/converted.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/scene/scene_rules.hpp"

namespace denhartog {
namespace {

/// Throws with the place `/quantity/index...` where places are asked for; indices of the place count from 0, as JSON pointers do.
[[noreturn]] void fail(const SceneNames& names, std::string_view quantity, std::string rule, std::string value,
                       const std::string& within = {}) {
    throw InputError(std::string(quantity), std::move(rule), std::move(value),
                     names.places ? std::string("/").append(quantity).append(within) : "");
}

/// Rule that a number breaks: it must be finite, and keep the rule of its own; null if it breaks none.
template <class T>
const char* broken_rule(const T& x, bool kept = true, const char* rule = nullptr) {
    using std::isfinite;
    return !isfinite(x) ? "must be finite" : kept ? nullptr : rule;
}

/// A number of the scene by itself.
template <class T>
void check_number(const SceneNames& names, std::string_view name, const T& x, bool kept, const char* rule) {
    if (const char* broken = broken_rule(x, kept, rule)) fail(names, name, broken, number_to_text(x));
}

std::string at(std::size_t i) { return std::string("/").append(std::to_string(i)); }
std::string at(std::size_t i, std::size_t k) { return at(i) + at(k); }
std::string number(std::size_t index) { return std::to_string(index + 1); }

template <class T>
void check_given_once(const std::vector<T>& ratios, const Matrix<T>& matrix, const SceneNames& names,
                      std::string_view ratios_name, std::string_view matrix_name) {
    if (!ratios.empty() && matrix.size() > 0)
        fail(names, matrix_name, std::string("must not be given together with ").append(ratios_name), "");
    if (ratios.empty() && matrix.size() == 0)
        throw InputError(std::string(ratios_name),
                         std::string("must have at least one value (or ").append(matrix_name).append(" be given)"), "");
}

/// Ratios of masses or springs: `of` is `mass` or `spring`.
template <class T>
void check_ratios(const std::vector<T>& x, std::size_t N, const SceneNames& names, std::string_view name, const char* of) {
    if (x.size() != N)
        fail(names, name, "must have as many values as there are masses (" + std::to_string(N) + ")", std::to_string(x.size()));
    for (std::size_t i = 0; i < N; ++i) {
        const char* rule = broken_rule(x[i], x[i] > 0, "must be positive");
        if (rule == nullptr && i == 0 && x[i] != 1) rule = "must be 1, its own unit";
        if (rule != nullptr)
            fail(names, name, std::string("of ") + of + " " + number(i) + " " + rule, number_to_text(x[i]), at(i));
    }
}

template <class T>
void check_symmetric(const Matrix<T>& A, std::size_t N, const SceneNames& names, std::string_view name) {
    const auto n = static_cast<Eigen::Index>(N);
    if (A.rows() != n || A.cols() != n)
        fail(names, name, "must have " + std::to_string(N) + " rows and columns",
             std::to_string(A.rows()) + " by " + std::to_string(A.cols()));
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t k = 0; k < N; ++k)
            if (const char* rule = broken_rule(A(i, k)))
                fail(names, name, "in row " + number(i) + ", column " + number(k) + " " + rule, number_to_text(A(i, k)),
                     at(i, k));
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (A(i, k) != A(k, i))
                fail(names, name,
                     "must be symmetric: in row " + number(i) + ", column " + number(k) + " must be " + number_to_text(A(k, i)) +
                         " as in row " + number(k) + ", column " + number(i),
                     number_to_text(A(i, k)), at(i, k));
}

template <class T>
void check_positive_definite(const Matrix<T>& A, const SceneNames& names, std::string_view name) {
    const Cholesky<T> factor = cholesky(A);
    if (factor.failed_order == 0) return;
    const std::string order = std::to_string(factor.failed_order);
    fail(names, name, "must be positive definite",
         factor.singular ? "singular: its leading minor of order " + order + " is zero to working precision"
                         : "not: its leading minor of order " + order + " is negative");
}

template <class T>
void check_damping_ratios(const std::vector<T>& zeta, std::size_t N, const SceneNames& names) {
    constexpr std::string_view name = "damping_ratios";
    if (zeta.size() != N)
        fail(names, name, "must have as many values as there are masses (" + std::to_string(N) + ")",
             std::to_string(zeta.size()));
    for (std::size_t i = 0; i < N; ++i) {
        const char* rule = broken_rule(zeta[i], !(zeta[i] < 0), "must not be negative");
        if (rule == nullptr && zeta[i] > largest_damping_ratio) rule = "must be at most 1e300";
        if (rule != nullptr)
            fail(names, name, std::string("of mode ").append(number(i)).append(" ").append(rule), number_to_text(zeta[i]),
                 names.one_zeta ? "" : at(i));
    }
}

template <class T>
void check_load(const System<T>& s, const SceneNames& names) {
    const std::size_t N = number_of_masses(s);
    const std::vector<T>& p = s.load_vector;
    if (p.size() != N)
        fail(names, "load", "must be one mass, or have as many values as there are masses (" + std::to_string(N) + ")",
             std::to_string(p.size()));
    bool loads = false;
    for (std::size_t k = 0; k < N; ++k) {
        if (const char* rule = broken_rule(p[k]))
            fail(names, "load", "on mass " + number(k) + " " + rule, number_to_text(p[k]), at(k));
        loads = loads || p[k] != 0;
    }
    if (!loads) fail(names, "load", "must act on at least one mass", "0 on all");
    const std::vector<T>& theta = s.load_phases;
    if (!theta.empty() && theta.size() != N)
        fail(names, "load_phases", "must have as many values as there are masses (" + std::to_string(N) + ")",
             std::to_string(theta.size()));
    for (std::size_t k = 0; k < theta.size(); ++k)
        if (const char* rule = broken_rule(theta[k]))
            fail(names, "load_phases", "of the force on mass " + number(k) + " " + rule, number_to_text(theta[k]), at(k));
}

// A direction of the contact. What is zero and what is rounding is told by numbers of the size of displacements: the entries are
// not far from 1.
template <class T>
void check_direction(const System<T>& s, std::size_t N, const SceneNames& names) {
    const std::vector<T>& w = s.contact_direction;
    if (w.empty()) return;
    const auto wrong = [&](std::string rule, std::string value, const std::string& within = {}) {
        throw InputError("direction", std::move(rule), std::move(value), names.places ? "/contact/direction" + within : "");
    };
    if (s.contact_with) wrong("must not be given together with a contact between two masses", "");
    if (w.size() != N)
        wrong("must have as many values as there are masses (" + std::to_string(N) + ")", std::to_string(w.size()));
    T largest(0);
    for (std::size_t k = 0; k < N; ++k) {
        if (const char* rule = broken_rule(w[k])) wrong("of mass " + number(k) + " " + rule, number_to_text(w[k]), at(k));
        largest = std::max(largest, w[k] < 0 ? T(-w[k]) : w[k]);
    }
    if (largest == 0) wrong("must have an entry that is not zero", "0 for all");
    if (largest < 1e-6 || largest > 1e6)
        wrong("must have its largest entry from 1e-6 to 1e6 in size; a factor belongs to the friction", number_to_text(largest));
    if (std::ranges::count(w, T(0)) + 1 == std::ssize(w))
        wrong((N == 1 ? "must be 1 for a single mass"
                      : "must have two entries at least that are not zero: of one mass contact is the number") +
                  std::string(", and a factor belongs to the friction"),
              number_to_text(*std::ranges::find_if(w, [](const T& x) { return x != 0; })));
    const T sum = evaluation::sum_with_rests<T>(w); // zero as decimal fractions may be rounding as doubles
    if (s.base_motion == BaseMotion::wall && !((sum < 0 ? T(-sum) : sum) > T(0x1p-48) * largest))
        wrong("must have entries whose sum is not zero where the wall moves: else nothing rubs against it", "0");
}

template <class T>
void check_static_load(const std::vector<T>& s, std::size_t N, const SceneNames& names) {
    if (s.empty()) return;
    if (s.size() != N)
        fail(names, "static_load", "must have as many values as there are masses (" + std::to_string(N) + ")",
             std::to_string(s.size()));
    for (std::size_t k = 0; k < N; ++k)
        if (const char* rule = broken_rule(s[k]))
            fail(names, "static_load", "on mass " + number(k) + " " + rule, number_to_text(s[k]), at(k));
}

template <class T>
void check_system(const System<T>& s, const SceneNames& names) {
    check_given_once(s.mass_ratios, s.mass_matrix, names, names("mass_ratios"), "mass_matrix");
    check_given_once(s.stiffness_ratios, s.stiffness_matrix, names, names("stiffness_ratios"), "stiffness_matrix");
    check_given_once(s.damping_ratios, s.damping_matrix, names, "damping_ratios", "damping_matrix");
    const std::size_t N = number_of_masses(s);
    if (N > most_masses) {
        const bool matrix = s.mass_matrix.size() > 0;
        fail(names, matrix ? names("mass_matrix") : names("mass_ratios"), most_masses_rule(matrix ? "rows" : "values"),
             std::to_string(N));
    }
    if (s.mass_matrix.size() > 0) {
        check_symmetric(s.mass_matrix, N, names, names("mass_matrix"));
        check_positive_definite(s.mass_matrix, names, names("mass_matrix"));
    } else {
        check_ratios(s.mass_ratios, N, names, names("mass_ratios"), "mass");
    }
    if (s.stiffness_matrix.size() > 0) {
        check_symmetric(s.stiffness_matrix, N, names, names("stiffness_matrix"));
        check_positive_definite(s.stiffness_matrix, names, names("stiffness_matrix"));
    } else {
        check_ratios(s.stiffness_ratios, N, names, names("stiffness_ratios"), "spring");
    }
    if (!(s.damping_tolerance >= 0 && s.damping_tolerance <= largest_damping_tolerance))
        fail(names, "damping_tolerance", "must be from 0 to 2", number_to_text(s.damping_tolerance));
    if (s.damping_matrix.size() > 0)
        check_symmetric(s.damping_matrix, N, names, "damping_matrix");
    else
        check_damping_ratios(s.damping_ratios, N, names);
    check_direction(s, N, names);
    if (s.contact.index >= N) fail(names, "contact", mass_rule(N), number(s.contact.index));
    if (s.load_vector.empty() && s.load.index >= N) fail(names, "load", mass_rule(N), number(s.load.index));
    if (s.contact_with && s.contact_with->index >= N) fail(names, "contact", mass_rule(N), number(s.contact_with->index), at(1));
    if (s.contact_with && *s.contact_with == s.contact)
        fail(names, "contact", "must be between two masses, not between one and itself", number(s.contact.index), at(1));
    if (s.base_motion == BaseMotion::wall && s.contact_with)
        fail(names, "base_motion",
             "must be \"with_wall\" or \"alone\" where the contact is between two masses: nothing rubs against the wall", "wall");
    if (s.load_vector.empty() && !s.load_phases.empty())
        fail(names, "load_phases", "must be given together with load as a force on each mass", "given with a load on one mass");
    if (!s.load_vector.empty()) check_load(s, names);
}

} // namespace

template <class T>
void check_under_names(const Scene<T>& scene, const SceneNames& names) {
    check_system(scene.system, names);
    check_static_load(scene.static_load, number_of_masses(scene.system), names);
    check_number(names, "mu", scene.mu, !(scene.mu < 1), rule_of_mu);
    if (scene.r) check_number(names, names("r"), *scene.r, *scene.r > 0, "must be positive");
    if (scene.beta) check_number(names, names("beta"), *scene.beta, !(*scene.beta < 0), "must not be negative");
}

template <class T>
void check(const Scene<T>& scene) {
    check_under_names(scene, SceneNames{});
}

template <class T>
void check(const System<T>& system) {
    check_system(system, SceneNames{});
}

template <class T>
Scene<T> converted(const Scene<double>& scene) {
    Scene<T> out;
    out.system = in_type<T>(scene.system);
    out.mu = T(scene.mu);
    if (scene.r) out.r = T(*scene.r);
    if (scene.beta) out.beta = T(*scene.beta);
    out.units = scene.units;
    out.static_load = in_type<T>(scene.static_load);
    return out;
}

template void check_under_names(const Scene<double>&, const SceneNames&);
template void check(const Scene<double>&);
template void check(const System<double>&);

template Scene<double> converted(const Scene<double>&);
#if DENHARTOG_REFERENCE
template Scene<Ball> converted(const Scene<double>&);
#endif

} // namespace denhartog
