// The steady response to friction of unit size that changes its sign every half-period, without any modes: by the exponential of
// the equations of the first order.
#pragma once

#include "conformance/plain/system.hpp"

namespace denhartog::conformance {

// A displacement and its rate.
struct PlainMotion {
    double x = 0; // displacement, units of P / k_1
    double v = 0; // its derivative in tau
};

// A of z' = A z, where z has the displacements, their rates, cos(tau), sin(tau) and the friction force beta sgn(w x'). With the
// contact held the last entry is beta, and no other entry of z depends on it.
[[nodiscard]] PlainMatrix equations_of(const PlainSystem& s, bool held);

// The weights of a row as weights of a state: of its displacements, from 0 on, or of its rates, from N on.
[[nodiscard]] PlainRow in_state(const PlainRow& row, std::size_t from);

// Steps in a period that show every oscillation and decay of the modes.
[[nodiscard]] int steps_of(const PlainSystem& s);

// The motion F that a unit of friction adds in (46), and the functions (34), (35) and (64), between 0 and pi.
class FrictionResponse {
public:
    explicit FrictionResponse(const PlainSystem& s);

    // A row of weights of the masses: its displacement, and its rate less what that is at the start.
    [[nodiscard]] PlainMotion at(const PlainRow& row, double tau) const;
    [[nodiscard]] double rate_gained(const PlainRow& row, double tau) const;
    [[nodiscard]] double acceleration_at_start(const PlainRow& row) const;

private:
    PlainMatrix A;
    double step;
    std::vector<PlainRow> nodes; // states at equal steps from 0 to pi
};

} // namespace denhartog::conformance
