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
class Shooting {
public:
    /// @param map        the map; must outlive this
    /// @param tolerance  residual relative to the state at which to end; 0 for rounding
    Shooting(OrbitMap& map, double tolerance)
        : map_(&map), tolerance_(tolerance), contact_(&map.solver().system().stuck.contact) {}

    /// @brief Looks for a fixed point in which the contact moves.
    ///
    /// Where the map jumps, or the contact rests for ever, Newton's method may come nearer to that place by every half step and
    /// be taken back by every whole one. Nearly every orbit is found without a bad step.
    /// @param z               where to start; the fixed point, or the state that the search ended at
    /// @param h               half-periods of the map
    /// @param after_bad_step  what to do where the residual does not fall
    /// @return                true where it was found; the map was then applied to it last, with its Jacobian
    bool fixed_point(State& z, int h, AfterBadStep after_bad_step);

    /// @brief Smallest residual that the last search saw. @return the residual; negative where the contact rested throughout
    [[nodiscard]] double residual() const { return residual_; }
    /// @brief Steps of Newton's method so far. @return their number
    [[nodiscard]] int steps() const { return steps_; }

private:
    static constexpr int most_runs = 40;

    static int most_bad_steps(AfterBadStep after_bad_step) {
        return after_bad_step == AfterBadStep::end ? 0 : after_bad_step == AfterBadStep::shorten ? 16 : most_runs;
    }

    double enough(const State& z, double rounding) const;

    // The step from z, where the map was applied last. Returns 1, or 0 where there is none.
    double prepare_step(const State& z);

    void take_step(double part, State& z) const;

    OrbitMap* map_;
    double tolerance_;
    const Contact* contact_;
    State from_, image_; // where the step starts, and the image of that
    Column<double> step_;
    bool rests_at_0_ = false; // the contact sticks at the end of the stretch: its velocity is zero there, without rounding
    double residual_ = -1;
    int steps_ = 0;
};

} // namespace denhartog
