/// @file
/// @brief A phase of a motion with stops as a sum of its free motions, for phases that are long beside the fastest of them.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "denhartog/reference/free_motions.hpp"

namespace denhartog::reference {

struct ContactMechanics;

/// @brief A number that changes in time, counted from the start of a phase.
using NumberInTime = std::function<Series(const Ball& t)>;

/// @brief All phases of one kind: the contact slides in one direction, or sticks.
///
/// The coordinates y are those of the state that move freely: all while the contact slides; while it sticks all but those of the
/// mass on which w is largest, which follow from the others. They obey \f$ \mathbf y' = \mathbf B\mathbf y + \mathbf G\mathbf u \f$,
/// where u is \f$ (\cos\tau, \sin\tau, 1, \mathbf w^{\mathrm T}\bar{\mathbf x}) \f$.
class FastPhases {
public:
    /// @brief Of a direction as `ContactMechanics::phase` has it.
    /// @throws Unproved if free motions are not proved distinct, or the force may be in resonance with one without damping
    FastPhases(const ContactMechanics& s, int direction);

    /// @brief The state at the end of a phase.
    [[nodiscard]] BallMatrix state(const BallMatrix& Z, const Ball& length) const;
    /// @brief The matrix that takes any state to the end of a phase.
    [[nodiscard]] BallMatrix propagator(const Ball& length) const;
    /// @brief A number over a phase.
    [[nodiscard]] NumberInTime number(const BallMatrix& row, const BallMatrix& Z) const;

private:
    struct OverCoordinates {
        BallMatrix y, u; // a row over Z as rows over y and u
    };
    [[nodiscard]] OverCoordinates taken_apart(const BallMatrix& row) const;
    [[nodiscard]] BallMatrix inputs(const BallMatrix& Z) const;
    [[nodiscard]] std::vector<ComplexBall> shares_at(const BallMatrix& Z, const BallMatrix& u) const;

    slong N_, lead_;
    bool slides_;
    BallMatrix w_;
    std::vector<slong> place_{};                                 // of the coordinates in Z
    BallMatrix forced_{};                                        // what y is without free motions, over u
    std::unique_ptr<FreeMotions> free_{};                        // of B
    std::shared_ptr<Remembered<std::vector<Series>>> in_time_{}; // the free motions
};

} // namespace denhartog::reference
