/// @file
/// @brief Newton's method for a fixed point of the map over half-periods.
#pragma once

#include <cstdint>

#include "denhartog/orbit/orbit_map.hpp"

namespace denhartog {

/// @brief What Newton's method does where the residual does not fall by a step.
enum class AfterBadStep : std::uint8_t {
    end,                     ///< it ends
    shorten,                 ///< it halves the step, a few times in all
    go_on_from_image_at_last ///< it halves the step, and then goes on from the image of the last good state
};

/// @brief Newton's method with the exact Jacobian.
template <class T>
class Shooting {
public:
    /// @param map        the map; must outlive this
    /// @param tolerance  residual relative to the state at which to end; 0 for rounding
    Shooting(OrbitMap<T>& map, const T& tolerance) : map_(&map), tolerance_(tolerance), j_(map.solver().system().contact.index) {}

    /// @brief Looks for a fixed point in which the contact moves.
    ///
    /// Where the map jumps, or the contact rests for ever, Newton's method may come nearer to that place by every half step and
    /// be taken back by every whole one. Nearly every orbit is found without a bad step.
    /// @param z               where to start; the fixed point, or the state that the search ended at
    /// @param h               half-periods of the map
    /// @param after_bad_step  what to do where the residual does not fall
    /// @return                true where it was found; the map was then applied to it last, with its Jacobian
    bool fixed_point(State<T>& z, int h, AfterBadStep after_bad_step) {
        residual_ = T(-1);
        T least(-1), part(1); // residual where the last step started, negative where there is none; part of it that is taken
        int bad_steps = 0;
        for (int n = 0; n < most_runs; ++n) {
            if (!map_->apply(z, h, true)) return false;
            const bool held = map_->held();
            if (held && least < 0) return false;
            const T residual = map_->norm(map_->difference());
            if (!(residual - residual == T(0))) return false;
            const T rounding = map_->rounding_in_energy().norm();
            const bool falls = !held && (least < 0 || residual < least * (1 - part / 8));
            if (falls) residual_ = residual;
            if (!held && (residual <= enough(z, rounding) || (!falls && residual <= 8 * rounding))) return true;
            bad_steps += !falls;
            if (bad_steps > most_bad_steps(after_bad_step)) return false;
            part = falls ? prepare_step(z) : T(part / 2);
            if (falls) least = residual;
            if (8 * part >= 1) {
                take_step(part, z);
                continue;
            }
            if (after_bad_step != AfterBadStep::go_on_from_image_at_last) return false;
            z = image_;
            least = T(-1);
            part = T(1);
        }
        return false;
    }

    /// @brief Smallest residual that the last search saw. @return the residual; negative where the contact rested throughout
    [[nodiscard]] const T& residual() const { return residual_; }
    /// @brief Steps of Newton's method so far. @return their number
    [[nodiscard]] int steps() const { return steps_; }

private:
    static constexpr int most_runs = 40;

    static int most_bad_steps(AfterBadStep after_bad_step) {
        return after_bad_step == AfterBadStep::end ? 0 : after_bad_step == AfterBadStep::shorten ? 16 : most_runs;
    }

    T enough(const State<T>& z, const T& rounding) const {
        const T at_rounding = rounding / 8; // which is a bound, and some way above what is seen
        return tolerance_ > 0 ? std::max(at_rounding, T(tolerance_ * map_->norm(z))) : at_rounding;
    }

    // The step from z, where the map was applied last. Returns 1, or 0 where there is none.
    T prepare_step(const State<T>& z) {
        from_ = z;
        image_ = map_->image();
        rests_at_0_ = image_.x_prime[j_] == 0 && map_->motion().phases.back().direction == 0;
        const LinearSystem<T> system(map_->newton_matrix());
        if (!system.is_regular()) return T(0);
        step_ = system.solve(map_->difference());
        ++steps_;
        return T(1);
    }

    void take_step(const T& part, State<T>& z) const {
        for (Eigen::Index k = 0; k < map_->N; ++k) {
            const auto n = static_cast<std::size_t>(k);
            z.x[n] = from_.x[n] + part * step_(k);
            z.x_prime[n] = from_.x_prime[n] + part * step_(map_->N + k);
        }
        if (rests_at_0_ && part == 1) z.x_prime[j_] = T(0);
    }

    OrbitMap<T>* map_;
    T tolerance_;
    std::size_t j_;
    State<T> from_, image_; // where the step starts, and the image of that
    Column<T> step_;
    bool rests_at_0_ = false; // the contact sticks at the end of the stretch: its velocity is zero there, without rounding
    T residual_ = T(-1);
    int steps_ = 0;
};

} // namespace denhartog
