/// @file
/// @brief A time integrator behind the protocol of docs/protocol.md.
#pragma once

#include <iosfwd>

#include "tests/conformance/adapters/solvers/period.hpp"

namespace denhartog::tests {

/// @brief Answers questions, one a line, in the `json` dialect until the input ends.
///
/// Answered is what the integrated motion shows: amplitude, phase, regime, stops_per_period, stop_durations,
/// motion_under_force. All else is skipped; a scene that breaks a rule is rejected.
/// @param integrator  the integrator
/// @param in          questions
/// @param out         answers
/// @return            exit status: 0, or 1 where the handshake is none
int serve(const TimeIntegrator& integrator, std::istream& in, std::ostream& out);

} // namespace denhartog::tests
