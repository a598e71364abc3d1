/// @file
/// @brief Whether a motion that is followed comes nearer to an orbit for long, as the linearisation of the orbit tells.
#pragma once

#include <algorithm>
#include <utility>

#include "denhartog/orbit/orbit_map.hpp"

namespace denhartog {

/// @brief A fixed point of h half-periods, with what is known of its neighbourhood.
struct OrbitCandidate {
    State z;                       ///< its state at tau = 0
    int h = 0;                     ///< half-periods; 0 where there is none
    Matrix<double> jacobian;       ///< of the map over them
    double rounding = 0;           ///< norm of the map's rounding
    double error = 0;              ///< of the state, in the norm
    double reach = 0;              ///< nearer than this every motion is proved to tend to it; 0 where that is not known
    bool stable = false;           ///< whether it attracts its neighbours
    double largest_multiplier = 0; ///< over h half-periods
};

/// @brief How a motion comes nearer to a candidate. A motion of another orbit that passes by does so for some periods too.
class Approach {
public:
    /// @brief Forgets what was seen.
    void start_over() { maps_ = -1; }

    /// @brief Takes the state after one more half-period.
    /// @param map   the map, applied there last
    /// @param to    the candidate
    /// @param z     the state
    /// @param held  whether the contact rested over the half-period
    void take(const OrbitMap& map, const OrbitCandidate& to, const State& z, bool held) {
        moved_ = moved_ || !held;
        if (maps_ >= 0 && ++half_periods_ % to.h != 0) return;
        Column<double> apart = difference(z, to.z);
        const double distance = map.norm(apart), rounding = 64 * to.rounding;
        const double gain = std::max(0.0, 1 - to.largest_multiplier) / 4;
        const bool as_told =
            maps_ >= 0 && moved_ && map.norm(Column<double>(apart - to.jacobian * apart_)) <= gain * distance_ + rounding;
        maps_ = as_told ? maps_ + 1 : 0;
        if (maps_ == 0) {
            first_ = distance;
            half_periods_ = 0;
        }
        apart_ = std::move(apart);
        distance_ = distance;
        moved_ = false;
        // The reach is proved but for the rounding of its proof.
        has_arrived_ = distance <= rounding || distance + to.error < to.reach * (1 - 1.0 / (1 << 20));
    }

    /// @brief Whether the motion comes nearer for some time already. @return whether
    [[nodiscard]] bool is_under_way() const { return maps_ >= least; }
    /// @brief Whether it was seen for long enough. @return whether
    [[nodiscard]] bool is_seen() const {
        if (maps_ < 0) return false;
        return has_arrived_ || (maps_ >= least && least * distance_ <= first_) || (maps_ >= most && distance_ < first_);
    }

private:
    static constexpr int least = 16; // maps in which an approach is seen, and how much nearer the motion comes
    static constexpr int most = 512; // maps after which slow approach is enough

    int maps_ = -1; // that brought it nearer, one after the other; negative before the first state
    int half_periods_ = 0;
    bool moved_ = false; // since the last map
    bool has_arrived_ = false;
    Column<double> apart_;
    double first_ = 0, distance_ = 0; // from the candidate
};

} // namespace denhartog
