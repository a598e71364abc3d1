// A program under test behind two pipes: one line to it, one line back, whatever the program does instead. And the conversation
// with it: handshake, questions, answers, crashes, and whether it keeps to the protocol.
//
// Nothing here waits without an end: reads and writes do not block, a clock ends them. The program runs in a process group of
// its own, which is killed as a whole. A process that leaves the group is not followed. Where the runner itself is killed, the
// system kills the program.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/verdict.hpp"

namespace denhartog::conformance {

// Longest line that is read from a program, in bytes; also the most that it may write without being asked.
inline constexpr std::size_t longest_line = 1'000'000;

// The reply to a line.
struct Reply {
    std::string line;               // the line without its end
    std::optional<Verdict> trouble; // in place of one: `crash`, `timeout`, `stall`; `skipped` where the runner itself is to end
    std::string told;               // what happened then, as a phrase: `it ended with status 1`
};

// Output of a program that it was not asked for.
struct Unasked {
    std::size_t lines = 0; // number of lines, a piece without an end counted as one
    std::string first;     // the first of them
};

// Set to end all waiting; a handler of signals may do so.
[[nodiscard]] std::atomic<bool>& interruption();

// Writing to a program that is gone is a fault of that program, not the runner's death: no SIGPIPE while this lives.
class WithoutBrokenPipeSignal {
public:
    WithoutBrokenPipeSignal();
    ~WithoutBrokenPipeSignal();
    WithoutBrokenPipeSignal(const WithoutBrokenPipeSignal&) = delete;
    WithoutBrokenPipeSignal& operator=(const WithoutBrokenPipeSignal&) = delete;

private:
    void (*earlier)(int);
};

// A running program; killed with all its group where this ends.
class Process {
public:
    // Starts a program, with the runner's standard error. Where the system has it, the program is killed as soon as the thread
    // that started it ends, in whatever way; its own children find their standard input at its end. Throws std::system_error
    // where it cannot be started.
    explicit Process(const std::vector<std::string>& command);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    // Sends a line and waits for one. Output since the last line is set aside as unasked, but for that before the first line is
    // sent. Of a silent program the processor time of its group in the second half of the wait tells whether it was waiting
    // (`stall`: less than a fiftieth of that half) or computing (`timeout`, also where /proc does not tell).
    [[nodiscard]] Reply ask(std::string_view line, double seconds);

    // Closes the program's standard input and waits for its end; kills it where that does not come. Empty where it ended with
    // status 0; else what it did, as a phrase.
    [[nodiscard]] std::string finish(double seconds);

    // Output of the program so far that it was not asked for.
    [[nodiscard]] const Unasked& unasked() const { return extra; }

private:
    pid_t group = -1;
    int to = -1, from = -1; // ends of the pipes to its standard input and from its output, which do not block
    bool asked = false;
    std::string received;
    Unasked extra;

    bool receive(bool& at_end);
    void send(std::string_view& rest);
    bool set_aside();
    [[nodiscard]] Reply no_line(double second_half, double processor_time_at_half);
    [[nodiscard]] Reply broken_off();
    [[nodiscard]] std::string how_it_ended(double seconds);
    void kill_group();
};

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
    int jobs = 1;                     // processes side by side
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

// Asks a program the questions of some vectors. Those of one process come in their order. `progress` is told how many are done,
// from any thread but never twice at a time. The conversation is the same for any number of jobs if the program answers each
// question by itself. Throws BrokenProgram where it cannot be started in the first place.
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
