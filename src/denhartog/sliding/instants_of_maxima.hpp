/// @file
/// @brief Where the masses are farthest out while the contact slides.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "denhartog/evaluation/mass.hpp"
#include "denhartog/scene/scene.hpp"
#include "denhartog/search/largest_in_double.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/sums/friction_motion.hpp"
#include "denhartog/sums/mode_sums.hpp"

namespace denhartog {

/// @brief How far the phase of a displacement may be from that of its maximum.
/// @param places       where the displacement may be the largest, in the order of time; no two touch
/// @param a            start of the stretch
/// @param b            its end, where the motion goes on as at a, or mirrored
/// @param instant      the instant of the maximum
/// @param is_negative  whether the displacement is negative at an instant
/// @return             radians; zero where no other instant can be that of the maximum
template <class T, class Sign>
[[nodiscard]] T spread_of_phases(const std::vector<Place<T>>& places, const T& a, const T& b, const T& instant,
                                 const Sign& is_negative) {
    T spread(0);
    for (const Place<T>& rival : rivals(places, a, b, instant)) {
        const bool opposite = is_negative(rival.instant) != is_negative(instant);
        const T apart = wrapped(T(rival.instant - instant + (opposite ? pi<T>() : T(0))));
        spread = std::max(spread, T(size_of_number(apart) + rival.reach));
    }
    return spread;
}

/// @brief Where a displacement is largest, and how far the phase of another such instant may be from that of this one.
/// @param curve  the search; gets the size of the displacement
/// @param at     motion (46) at an instant
/// @param noise  rounding error of the displacement
/// @param error  bound of the error that the sums make of it
/// @return       instant in [0, pi], and radians
template <class T, class Motion>
[[nodiscard]] std::pair<T, T> instant_and_spread(Curve<T> curve, const Motion& at, const T& noise, const T& error) {
    curve.sample = [&](const T& tau) {
        const evaluation::MotionOfMass<T> now = at(tau);
        return Sample<T>{now.x < 0 ? T(-now.x) : now.x, now.x_prime, now.x_double_prime};
    };
    const Maximum<T> found = global_maximum<T>(curve, T(0), pi<T>(), noise, nullptr, std::numeric_limits<T>::lowest(), error);
    const auto is_negative = [&](const T& tau) { return at(tau).x < 0; };
    return {found.instant, spread_of_phases(found.places, T(0), pi<T>(), found.instant, is_negative)};
}

/// @brief Where the displacements of the masses are largest.
template <class T>
struct InstantsOfMaxima {
    std::vector<T> instants; ///< N, in [0, pi]; 0 for the contact and for masses not asked for
    /// N, radians: how far the phase of another instant is from that of this one, where the displacement there may be the largest
    /// as well; else 0
    std::vector<T> spreads;
};

/// @brief Where the displacements of the masses are largest, guaranteed by `global_maximum`.
/// @eq{46}
/// @param y       braces of (40) of all modes at a frequency ratio; what it remembers serves the next search
/// @param beta    friction ratio, Eq. (11), in the sliding regime
/// @param only    the one mass whose maximum is wanted besides that of the contact; none for all
/// @param errors  bounds of the errors that the sums make of the displacements, N; empty for none
/// @return        the instants
template <class T>
[[nodiscard]] InstantsOfMaxima<T> instants_of_maxima(FrictionMotions<T>& y, const T& beta,
                                                     std::optional<Mass> only = std::nullopt, const std::vector<T>& errors = {});

} // namespace denhartog
