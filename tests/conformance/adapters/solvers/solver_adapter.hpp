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
/// Answered is what the integrated motion shows: amplitude, phase, regime, stops_per_period, stop_durations,
/// motion_under_force. All else is skipped; a scene that breaks a rule is rejected.
/// @param integrator  the integrator
/// @param in          questions
/// @param out         answers
/// @return            exit status: 0, or 1 where the handshake is none
int serve(const TimeIntegrator& integrator, std::istream& in, std::ostream& out);

/// @brief The same with another way to answer.
/// @param name    as the handshake gives it
/// @param answer  `value` or `skip` to a question that keeps the rules
/// @param in      questions
/// @param out     answers
/// @return        exit status: 0, or 1 where the handshake is none
int serve(const std::string& name,
          const std::function<nlohmann::ordered_json(const conformance::ProtocolQuestion&, const Scene<double>&)>& answer,
          std::istream& in, std::ostream& out);

/// @brief Serves an integrator by its first argument.
/// @param argc     number of arguments
/// @param argv     the program, and the setting if there is one
/// @param setting  the setting without an argument
/// @param made     the integrator at a setting
/// @return         exit status: as `serve`, or 2 where the setting is no positive number
int serve_at(int argc, char** argv, double setting, const std::function<TimeIntegrator(double)>& made);

} // namespace denhartog::tests
