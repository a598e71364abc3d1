/// @file
/// @brief Whether a motion that is followed comes nearer to an orbit for long, as the linearisation of the orbit predicts.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "denhartog/orbit/orbit_map.hpp"

namespace denhartog {

/// @brief Number of periods for which a motion is followed that does not become periodic: 500 and thirty decay times of the
/// slowest mode, but at most `most`; `most` if damping couples the modes.
[[nodiscard]] inline int periods_to_follow(const ExactSolver& solver, int most) {
    const ModalBasis<double>& basis = solver.system().basis;
    if (basis.coupled()) return most; // a motion may decay more slowly than the diagonal of the damping tells
    double slowest = std::numeric_limits<double>::infinity(); // decay rate, a period of the force
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const double zeta = basis.zeta[i];
        const double rate = zeta < 1 ? zeta : 1 / (zeta + sqrt((zeta - 1) * (zeta + 1)));
        slowest = std::min(slowest, 2 * pi<double>() * rate * basis.r_n[i] / solver.excitation().r);
    }
    if (!(slowest > 0)) return most; // 30 over a damping ratio of -0 is no number of periods
    const double periods = 500 + 30 / slowest;
    return periods < most ? static_cast<int>(periods) : most;
}

/// @brief The states of a motion after its last half-periods, mirrored after each, and how nearly it repeats itself.
struct RecentStates {
    static constexpr int most_subharmonic = 8; ///< longest period looked for, in periods of the force
    std::vector<State> states;                 ///< the last comes last

    /// @brief Takes the next one.
    void take(const State& z) {
        if (states.size() > 2 * most_subharmonic) states.erase(states.begin());
        states.push_back(z);
    }
    /// @brief Distance of the last state from that h half-periods before; 0 if there is none.
    [[nodiscard]] double recurrence(const OrbitMap& map, int h) const {
        const auto back = static_cast<std::size_t>(h) + 1;
        return back > states.size() ? 0.0 : map.norm(difference(states.back(), states[states.size() - back]));
    }
    /// @brief Numbers of half-periods after which the motion nearly repeats itself, each better than those before.
    [[nodiscard]] std::vector<int> lengths(const OrbitMap& map) const {
        std::vector<int> found{1};
        double least = recurrence(map, 1);
        for (int h = 2; h < static_cast<int>(states.size()); ++h) {
            if (h % 2 != 0 && h > most_subharmonic) continue;
            const double now = recurrence(map, h);
            if (2 * now < least) {
                found.push_back(h);
                least = now;
            }
        }
        return found;
    }
};

/// @brief A fixed point of h half-periods, with what is known of its neighbourhood.
struct OrbitCandidate {
    State z;                       ///< its state at tau = 0
    int h = 0;                     ///< half-periods; 0 if there is none
    Matrix<double> jacobian;       ///< of the map over them
    double rounding = 0;           ///< norm of the map's rounding
    double error = 0;              ///< of the state, in the norm
    double reach = 0;              ///< nearer than this every motion is proved to tend to it; 0 if that is not known
    bool stable = false;           ///< whether it attracts its neighbours
    double largest_multiplier = 0; ///< over h half-periods
};

/// @brief A record of how a motion approaches a candidate. One that only passes by comes nearer for some periods too.
class Approach {
public:
    /// @brief Forgets what was seen.
    void start_over() { maps_ = -1; }

    /// @brief Takes the state z after one more half-period, to which the map was applied last; `held` says whether the contact
    /// rested over it.
    void take(const OrbitMap& map, const OrbitCandidate& to, const State& z, bool held) {
        moved_ = moved_ || !held;
        if (maps_ >= 0 && ++half_periods_ % to.h != 0) return;
        Column apart = difference(z, to.z);
        const double distance = map.norm(apart), rounding = 64 * to.rounding;
        const double gain = std::max(0.0, 1 - to.largest_multiplier) / 4;
        const bool as_told =
            maps_ >= 0 && moved_ && map.norm(Column(apart - to.jacobian * apart_)) <= gain * distance_ + rounding;
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

    /// @brief Whether the motion comes nearer for some time already.
    [[nodiscard]] bool is_under_way() const { return maps_ >= least; }
    /// @brief Whether it was seen for long enough.
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
    Column apart_;
    double first_ = 0, distance_ = 0; // from the candidate
};

} // namespace denhartog
