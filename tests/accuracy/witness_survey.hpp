/// @file
/// @brief What the tests against the second witness share: the set of scenes, what a scene is allowed to lose, and a record.
#pragma once

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/support/second_witness.hpp"

namespace denhartog::tests {

/// @brief Random scenes with their beta: the fraction of the boundary, as double finds it, rounded to a short binary fraction.
template <class T>
[[nodiscard]] std::vector<NamedScene<T>> random_sliding_scenes(std::uint64_t seed) {
    const std::vector<RandomScene<double>> in_double = random_scenes<double>(seed);
    const std::vector<RandomScene<T>> in_T = random_scenes<T>(seed);
    std::vector<NamedScene<T>> scenes;
    for (std::size_t n = 0; n < in_T.size(); ++n) {
        NamedScene<T> scene{in_T[n].name, in_T[n].scene};
        scene.scene.beta = T(friction_ratio_at(in_T[n].fraction_of_limit, response(in_double[n].scene).boundary.exact));
        scenes.push_back(scene);
    }
    return scenes;
}

/// @brief Modes and sums at the point of a scene. @param scene a scene @return the sums
template <class T>
[[nodiscard]] ModeSums<T> sums_at(const Scene<T>& scene) {
    return mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, *scene.r);
}

/// @brief How far an eigen-solve can know a mode, in units in the last place.
template <class T>
struct ModeCondition {
    T frequency; ///< of its natural frequency, relative
    T shape;     ///< of its shape, normwise
};

/// @brief Condition of a mode: a chain's frequencies are known relatively, and its shapes to the relative gap to the next
/// frequency; with matrices given, squared frequencies and their gaps are known against the largest one.
template <class T>
[[nodiscard]] ModeCondition<T> condition_of_mode(const ModeSums<T>& sums, bool chain, std::size_t i) {
    const T omega = 1 / sums.R[i], highest = 1 / sums.R.back();
    T gap(1);
    for (std::size_t n = 0; n < sums.R.size(); ++n) {
        const T other = 1 / sums.R[n], apart = other < omega ? T(omega - other) : T(other - omega);
        if (n != i) gap = std::min(gap, chain ? T(apart / (omega + other)) : T(apart * (omega + other) / (highest * highest)));
    }
    return {chain ? T(1) : T(highest * highest / (omega * omega)), T(1 / gap)};
}

/// @brief Condition number of the superposition: what the errors of natural frequencies and mode shapes do to it.
///
/// For every term of (33), and of beta times (34), (35) and the sum in (41): its size, plus its derivative in ln R_i times the
/// condition of the frequency, plus its change by the shapes times their condition. The sum is divided by the amplitude of the
/// mass; for the contact, whose V_dj every mass depends on, (33) also by |V_dj|. The derivatives:
/// \f$ |v'| = 2R|R-i\zeta||v|^2 \f$; (28) and (29) are parts of \f$ \tanh\frac{\delta+i\theta}{2} \f$, whose derivative is
/// \f$ \frac{\pi}{R}\,/\,(\cosh\delta+\cos\theta) \f$ in size; the motion's phases turn by at most \f$ \pi/R \f$.
template <class T>
[[nodiscard]] double condition(const ModeSums<T>& sums, const SteadyState<T>& state, bool chain) {
    const auto size = [](const T& x) { return x < 0 ? T(-x) : x; };
    const auto row = [&](std::size_t k) { return mode_shapes_at(sums, Mass{k}); };
    const auto row_size = [&](std::size_t k) {
        T sum(0);
        for (const T& psi : row(k)) sum += psi * psi;
        return T(sqrt(sum));
    };
    const std::size_t j = sums.contact.index, l = sums.load.index;
    T largest(0);
    for (std::size_t k = 0; k < state.masses.size(); ++k) {
        T V(0), friction(0);
        for (std::size_t i = 0; i < sums.R.size(); ++i) {
            const T R = sums.R[i], zeta = sums.zeta[i], w = sqrt(T(1 - zeta * zeta));
            const T v = modulus(sums.v[i]), u = size(sums.u[i]), g = size(sums.g[i]), turn = pi<T>() / R;
            const ModeCondition<T> known = condition_of_mode(sums, chain, i);
            const T tanh_prime = turn / (cosh(T(turn * zeta)) + cos(T(turn * w)));
            const T braces = 1 + g + R * u;
            const T v_rate = 2 * R * sqrt(T(R * R + zeta * zeta)) * v * v;
            const T friction_rate = braces * turn + u + tanh_prime * (1 + 1 / R) / w;
            const auto add = [&](T& sum, std::size_t other, const T& value, const T& rate) {
                const T a = size(row(k)[i]), b = size(row(other)[i]);
                sum += R * R *
                       (a * b * (value + known.frequency * rate) + known.shape * (a * row_size(other) + row_size(k) * b) * value);
            };
            add(V, l, v, v_rate);
            add(friction, j, T(braces + u), friction_rate);
        }
        largest = std::max(largest, T((V + state.beta * friction) / state.masses[k].amplitude));
        if (k == j) largest = std::max(largest, T(V / modulus(sums.V[k])));
    }
    return static_cast<double>(largest);
}

/// @brief The worst of many errors, with the scene it is from.
struct Record {
    double error = -1; ///< the largest so far
    std::string scene; ///< where
    int count = 0;     ///< how many
    /// @brief Takes note of an error. @param e the error @param name the scene
    void note(double e, const std::string& name) {
        ++count;
        if (!(e <= error)) {
            error = e;
            scene = name;
        }
    }
};

/// @brief Prints a record as a line of the test's output. @param what what was measured @param r the record
inline void print(const std::string& what, const Record& r) {
    if (r.count == 0)
        std::printf("  %s: none\n", what.c_str());
    else
        std::printf("  %s: %d, worst %.2e, %s\n", what.c_str(), r.count, r.error, r.scene.c_str());
}

} // namespace denhartog::tests
