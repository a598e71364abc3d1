/// @file
/// @brief Newton's method for a fixed point of the map over half-periods.
#pragma once

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/orbit/orbit_map.hpp"

namespace denhartog {

/// @brief Largest number of steps of Newton's method without a fall of the residual: it halves such a step, and may then go on
/// from the image of the last good state.
enum class BadSteps : int { none = 0, some = 16, all_and_go_on_from_image = 40 };

/// @brief Newton's method with the exact Jacobian.
class Shooting {
public:
    /// @brief Of a map, which must outlive this.
    explicit Shooting(OrbitMap& map) : map_(&map), contact_(&map.solver().system().stuck.contact) {}

    /// @brief Looks from z for a fixed point of h half-periods in which the contact moves. If one was found the map was
    /// applied to it last, with its Jacobian; else z is the state that the search ended at.
    ///
    /// If the map jumps, or the contact rests for ever, Newton's method may come nearer to that place by every half step and
    /// be taken back by every whole one. Nearly every orbit is found without a bad step.
    bool fixed_point(State& z, int h, BadSteps bad_steps) {
        constexpr int most_runs = 40;
        residual_ = -1;
        double least = -1,
               part = 1; // residual where the last step started, negative if there is none; part of it that is taken
        int bad = 0;
        for (int n = 0; n < most_runs; ++n) {
            if (!map_->apply(z, h, true)) return false;
            const bool held = map_->held();
            if (held && least < 0) return false;
            const double residual = map_->norm(map_->difference());
            if (!(residual - residual == 0)) return false;
            const double rounding = map_->rounding_in_energy().norm();           // a bound, and some way above what is seen
            const int above = map_->solver().system().basis.coupled() ? 128 : 8; // farther with a damping matrix
            const bool falls = !held && (least < 0 || residual < least * (1 - part / 8));
            if (falls) residual_ = residual;
            if (!held && residual <= (falls ? rounding / above : 8 * rounding)) return true;
            bad += !falls;
            if (bad > static_cast<int>(bad_steps)) return false;
            part = !falls ? part / 2 : prepare_step(z) ? 1 : 0;
            if (falls) least = residual;
            if (8 * part >= 1) {
                take_step(part, z);
                continue;
            }
            if (bad_steps != BadSteps::all_and_go_on_from_image) return false;
            z = image_;
            least = -1;
            part = 1;
        }
        return false;
    }

    /// @brief Smallest residual that the last search saw; negative if the contact rested throughout.
    [[nodiscard]] double residual() const { return residual_; }
    /// @brief Steps of Newton's method so far.
    [[nodiscard]] int steps() const { return steps_; }

private:
    // The step from z, where the map was applied last; false if there is none.
    bool prepare_step(const State& z) {
        from_ = z;
        image_ = map_->image();
        rests_at_0_ = contact_->of(image_.x_prime) == 0 && map_->motion().phases.back().direction == 0;
        const LinearSystem system(Matrix<double>(Matrix<double>::Identity(2 * map_->N, 2 * map_->N) - map_->jacobian()));
        if (!system.is_regular()) return false;
        step_ = system.solve(map_->difference());
        ++steps_;
        return true;
    }

    void take_step(double part, State& z) const {
        for (Eigen::Index k = 0; k < map_->N; ++k) {
            const auto n = static_cast<std::size_t>(k);
            z.x[n] = from_.x[n] + part * step_(k);
            z.x_prime[n] = from_.x_prime[n] + part * step_(map_->N + k);
        }
        if (rests_at_0_ && part == 1) contact_->hold(z.x_prime.data());
    }

    OrbitMap* map_;
    const Contact* contact_;
    State from_, image_; // where the step starts, and the image of that
    Column step_;
    bool rests_at_0_ = false; // the contact sticks at the end of the stretch: its velocity is zero there, without rounding
    double residual_ = -1;
    int steps_ = 0;
};

} // namespace denhartog
