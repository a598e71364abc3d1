/// @file
/// @brief What is asked of the search for an orbit, how long it follows a motion, and what it says of one that leads to none.
#pragma once

#include <algorithm>
#include <boost/math/special_functions/fpclassify.hpp>
#include <limits>
#include <string>
#include <utility>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"

namespace denhartog {

/// @brief What was seen of a motion that leads to no orbit. Lengths count half-periods.
struct SearchWithoutOrbit {
    int periods = 0;               ///< of the force, for which it was followed
    std::string ended{};           ///< why it was followed no further; empty where that is long enough
    bool chattering = false;       ///< phases of no length followed each other
    bool restless = false;         ///< rounding keeps it from settling
    double grows_to = 0;           ///< its size, where it still grows; else 0
    int repeats_after = 0;         ///< the length after which it repeats itself best; 0 where that is not known
    double repeats_to = 0;         ///< how well, over its size
    int orbit = 0;                 ///< length of a periodic motion that is there; 0 where none was found
    bool orbit_is_stable = false;  ///< whether that attracts its neighbours
    double largest_multiplier = 0; ///< of it
    double away = 0;               ///< how far the motion is from it, over its size
};

/// @brief The same in words. @param seen what was seen @return sentences, the first without a capital, the last without its stop
[[nodiscard]] std::string in_words(const SearchWithoutOrbit& seen);

/// @brief What a half-period changes of a motion, where no two motions move apart: less than the one before, but for rounding.
template <class T>
struct Settling {
    T change = T(-1); ///< of the last half-period, as `OrbitMap` measures it; negative before the first
    int rises = 0;    ///< half-periods that changed more than the one before

    /// @brief Takes the change of one more half-period. @param next the change
    void take(const T& next) {
        rises += change >= 0 && next > change * T(1.001);
        change = next;
    }
    /// @brief Whether rounding keeps the motion from settling: Newton's method would have to end at it too. @return whether
    [[nodiscard]] bool is_restless() const { return rises >= 16; }
};

/// @brief Checks what is asked of the search. Throws InputError.
/// @param search  what is asked
/// @param start   state at tau = 0
/// @param N       masses
template <class T>
void check_search(const OrbitSearch<T>& search, const State<T>& start, std::size_t N) {
    if (search.periods_before < 0)
        throw InputError("periods_before", "must not be negative", std::to_string(search.periods_before));
    for (const auto& [name, value] :
         {std::pair("most_periods", search.most_periods), std::pair("most_subharmonic", search.most_subharmonic)})
        if (value < 1) throw InputError(name, "must be at least 1", std::to_string(value));
    if (!(search.tolerance >= 0)) throw InputError("tolerance", "must be zero or positive", number_to_text(search.tolerance));
    if (start.x.size() != N || start.x_prime.size() != N)
        throw InputError("start", "must have a displacement and a velocity for each mass", std::to_string(start.x.size()));
    for (const std::vector<T>* part : {&start.x, &start.x_prime})
        for (const T& each : *part)
            if (!boost::math::isfinite(each)) throw InputError("start", "must be finite", "");
}

/// @brief Periods after which a motion from a start is no transient any more, where it has not become periodic.
/// @param solver  system, frequency and friction
/// @param most    no more than these @return 500 and thirty times a mode's slowest decay time; `most` if damping couples modes
template <class T>
[[nodiscard]] int periods_to_follow(const ExactSolver<T>& solver, int most) {
    const ModalBasis<T>& basis = solver.system().basis;
    if (basis.coupled()) return most;               // a motion may decay more slowly than the diagonal of the damping tells
    T slowest = std::numeric_limits<T>::infinity(); // decay rate, a period of the force
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const T& zeta = basis.zeta[i];
        const T rate = zeta < 1 ? zeta : T(1 / (zeta + sqrt(T((zeta - 1) * (zeta + 1)))));
        slowest = std::min(slowest, T(2 * pi<T>() * rate * basis.r_n[i] / solver.excitation().r));
    }
    if (!(slowest > 0)) return most; // 30 over a damping ratio of -0 is no number of periods
    const T periods = 500 + 30 / slowest;
    return periods < most ? static_cast<int>(periods) : most;
}

} // namespace denhartog
