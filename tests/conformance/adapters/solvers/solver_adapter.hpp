/// @file
/// @brief A time integrator behind the protocol of docs/protocol.md.
#pragma once

#include <functional>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>

#include "conformance/question.hpp"
#include "tests/conformance/adapters/solvers/period.hpp"

namespace denhartog::tests {

/// @brief Answers questions, one a line, in the `json` dialect until the input ends.
///
/// Answered is what the integrated motion shows: amplitude, phase, regime, stops_per_period, stop_durations, motion_under_force.
/// All else is skipped; a scene that breaks a rule is rejected. Gives the exit status: 0, or 1 where the handshake is none.
int serve(const TimeIntegrator& integrator, std::istream& in, std::ostream& out);

/// @brief The same with another way to answer. The handshake has the name; `answer` gives `value` or `skip` to a question that
/// keeps the rules.
int serve(const std::string& name,
          const std::function<nlohmann::ordered_json(const conformance::ProtocolQuestion&, const Scene<double>&)>& answer,
          std::istream& in, std::ostream& out);

/// @brief Serves an integrator by its first argument. It is the integrator's setting, which is `setting` without it. The exit
/// status is that of `serve`, or 2 where the setting is no positive number.
int serve_at(int argc, char** argv, double setting, const std::function<TimeIntegrator(double)>& made);

} // namespace denhartog::tests
