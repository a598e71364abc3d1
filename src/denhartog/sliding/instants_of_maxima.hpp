/// @file
/// @brief Instants at which the demand (57) is largest, and at which the masses are farthest out while the contact slides, with
/// bounds of the largest values.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "denhartog/evaluation/mass.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/scene/scene.hpp"
#include "denhartog/search/largest.hpp"
#include "denhartog/sliding/friction_motion.hpp"
#include "denhartog/sliding/steady_state.hpp"

namespace denhartog {

/// @brief True if (57) of every mode is certain to be largest for tau -> 0, by `evaluation::excess_at_the_end`: so is the sum.
/// False says nothing. @eq{57,71}
template <class T>
[[nodiscard]] bool largest_at_start(const ModeSums<T>& sums);

/// @brief The instant in [0, pi] of the largest sum of (57)'s expression over the modes, by `global_maximum`; 0 stands for
/// the limit. The search has its share of `effort`. PrecisionError if the maximum is not settled. @eq{56,57}
[[nodiscard]] double instant_of_largest_demand(const ModeSums<double>& sums, Effort* effort = nullptr);

/// @brief N + 1 instants in [0, pi]: where the sum over the modes of (57)'s expression is largest, and where that of each mode
/// is; 0 stands for the limit. Instants that `y` remembers serve the next search. PrecisionError if a maximum is not settled. @eq{56,57}
[[nodiscard]] std::vector<double> instants_of_demands(FrictionMotions& y);

/// @brief Number of searches for the largest demand since the program started; tests gate on it.
[[nodiscard]] inline long demand_searches() { return work_counted.demand_searches; }

/// @brief `regime_boundary_at` the largest demand, with bounds: what a map asks for. It is searched for only if
/// `largest_at_start` does not decide it. PrecisionError if the maximum is not settled. @eq{54,57,58,67,69,71,72}
[[nodiscard]] RegimeBoundary<Bounded<double>> regime_boundary(const ModeSums<Bounded<double>>& sums, const Bounded<double>& mu);

/// @brief The angle in radians by which the phase of a displacement may differ from that of its maximum; zero if no other instant
/// can be that of the maximum. The places are where the displacement may be the largest, in the order of time, and no two touch. At b,
/// the end of the stretch, the motion goes on as at a, or mirrored.
template <class Sign>
[[nodiscard]] double spread_of_phases(const std::vector<Place>& places, double a, double b, double instant,
                                      const Sign& is_negative) {
    double spread(0);
    for (const Place& rival : rivals(places, a, b, instant)) {
        const bool opposite = is_negative(rival.instant) != is_negative(instant);
        const double apart = wrapped(rival.instant - instant + (opposite ? pi<double>() : 0.0));
        spread = std::max(spread, size_of_number(apart) + rival.reach);
    }
    return spread;
}

/// @brief The instant of a largest displacement, and by how many radians the phase of another may differ. `at` gives the
/// motion (46) at an instant, and the curve gets the size of the displacement. `noise` is the rounding error of the displacement,
/// and `error` bounds the error that the sums make of it.
template <class Motion>
[[nodiscard]] std::pair<double, double> instant_and_spread(Curve curve, const Motion& at, double noise, double error) {
    curve.sample = [&](double tau) {
        const evaluation::MotionOfMass<double> now = at(tau);
        return Sample{std::abs(now.x), now.x_prime, now.x_double_prime};
    };
    const Maximum found = global_maximum(curve, 0.0, pi<double>(), noise, nullptr, std::numeric_limits<double>::lowest(), error);
    const auto is_negative = [&](double tau) { return at(tau).x < 0; };
    return {found.instant, spread_of_phases(found.places, 0.0, pi<double>(), found.instant, is_negative)};
}

/// @brief Instants at which the displacements of the masses are largest.
struct InstantsOfMaxima {
    std::vector<double> instants; ///< N, in [0, pi]; 0 for the contact and for masses not asked for
    /// N, radians: how far the phase of another instant is from that of this one, where the displacement there may be the largest
    /// as well; else 0
    std::vector<double> spreads;
};

/// @brief The instants of the largest displacements, guaranteed by `global_maximum`. `only` is the one mass whose maximum
/// is wanted besides that of the contact, none for all. `errors` bound what the sums make of the displacements, or are empty.
/// Instants that `y` remembers serve the next search. @eq{46}
[[nodiscard]] InstantsOfMaxima instants_of_maxima(FrictionMotions& y, double beta, std::optional<Mass> only = std::nullopt,
                                                  const std::vector<double>& errors = {});

/// @brief A steady state with the maxima of the masses not in contact, whose instants are known to about half the digits of a
/// double: one step of Newton's method corrects them. `only` is as above.
template <class T>
[[nodiscard]] SteadyState<T> with_maxima(const ModeSums<T>& sums, SteadyState<T> state, const std::vector<T>& instants,
                                         std::optional<Mass> only = std::nullopt);

} // namespace denhartog
