// A conversation with a program under test: handshake, questions, answers, crashes, and whether it keeps to the protocol.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/session/process.hpp"
#include "conformance/verdict.hpp"

namespace denhartog::conformance {

// The program cannot be started, or does not answer the handshake as the protocol has it.
struct BrokenProgram : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Number of times that a program which breaks is started again without an answer in between, before the rest is skipped.
inline constexpr int most_restarts = 5;

// The handshake may take this many times as long as an answer: interpreters start slowly.
inline constexpr double patience_at_start = 3;

// Settings of a run.
struct RunSettings {
    std::vector<std::string> command; // the program and its arguments
    double seconds = 10;              // time for an answer
    unsigned jobs = 1;                // processes side by side
    double total_seconds = 0;         // time for all answers, after which nothing more is asked; 0: no end
};

// A program that answered the handshake.
struct Partner {
    std::unique_ptr<Process> process; // the program
    std::string dialect;              // `json` or `plain`
    std::string name;                 // its name
};

// Starts a program and shakes hands. Throws BrokenProgram.
[[nodiscard]] Partner shake_hands(const RunSettings& settings);

// A question in the dialect of a program.
[[nodiscard]] std::string line_for(const Partner& partner, const ProtocolQuestion& q);

// The answer in a line of a program.
[[nodiscard]] Answer answer_in(const Partner& partner, std::string_view line, std::string_view id);

// The verdict on a reply of a program.
[[nodiscard]] Judged judge(const Vector& v, const Partner& partner, const Reply& reply);

// A whole conversation.
struct Conversation {
    std::vector<Judged> judged;     // the verdicts, in the order of the questions
    std::string name;               // of the program
    std::string dialect;            // `json` or `plain`
    std::vector<std::string> notes; // breaches of the protocol that decide no verdict
    bool broken = false;            // the program broke at every question, or too often in a row
    std::string cut_short;          // why not every question was asked, and how many were; empty where all were
};

// Asks a program the questions of some vectors. Those of one process come in their order. `progress` is told how many are done, from any
// thread but never twice at a time. The conversation is the same for any number of jobs if the program answers each question by
// itself. Throws BrokenProgram where it cannot be started in the first place.
[[nodiscard]] Conversation converse(const RunSettings& settings, std::span<const Vector* const> vectors,
                                    const std::function<void(std::size_t)>& progress);

// One thing looked at.
struct SmokeCheck {
    std::string what;      // e.g. `amplitude`
    std::string found;     // what the program did, in words
    bool good = false;     // whether the protocol allows it
    bool of_input = false; // whether the fault is one of checking input, and the protocol is kept
};

// Findings of a look at the protocol.
struct Smoke {
    std::vector<SmokeCheck> checks; // in the order in which they were made
    bool broken = false;            // the program broke
};

// Shakes hands, asks for every quantity once, for one that there is not, and one question that breaks a rule. Throws
// BrokenProgram where it cannot be started or does not shake hands.
[[nodiscard]] Smoke smoke(const RunSettings& settings);

} // namespace denhartog::conformance
