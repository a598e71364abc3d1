/// @file
/// @brief Newton's method for a fixed point of the map over half-periods.
#pragma once

#include "denhartog/orbit/orbit_map.hpp"

namespace denhartog {

/// @brief How many steps after which the residual does not fall Newton's method bears: it halves such a step, and may then go on
/// from the image of the last good state.
enum class BadSteps : int { none = 0, some = 16, all_and_go_on_from_image = 40 };

/// @brief Newton's method with the exact Jacobian.
class Shooting {
public:
    /// @brief Of a map, which must outlive this.
    explicit Shooting(OrbitMap& map) : map_(&map), contact_(&map.solver().system().stuck.contact) {}

    /// @brief Looks from z for a fixed point of h half-periods in which the contact moves. Where one was found the map was
    /// applied to it last, with its Jacobian; else z is the state that the search ended at.
    ///
    /// Where the map jumps, or the contact rests for ever, Newton's method may come nearer to that place by every half step and
    /// be taken back by every whole one. Nearly every orbit is found without a bad step.
    bool fixed_point(State& z, int h, BadSteps bad_steps);

    /// @brief Smallest residual that the last search saw; negative where the contact rested throughout.
    [[nodiscard]] double residual() const { return residual_; }
    /// @brief Steps of Newton's method so far.
    [[nodiscard]] int steps() const { return steps_; }

private:
    bool prepare_step(const State& z);
    void take_step(double part, State& z) const;

    OrbitMap* map_;
    const Contact* contact_;
    State from_, image_; // where the step starts, and the image of that
    Column<double> step_;
    bool rests_at_0_ = false; // the contact sticks at the end of the stretch: its velocity is zero there, without rounding
    double residual_ = -1;
    int steps_ = 0;
};

} // namespace denhartog
