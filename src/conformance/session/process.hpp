// A program under test behind two pipes: one line to it, one line back, whatever the program does instead.
//
// Nothing here waits without an end: reads and writes do not block, a clock ends them. The program runs in a process group of
// its own, which is killed as a whole. A process that leaves the group is not followed. Where the runner itself is killed, the
// system kills the program.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <optional>
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
    // Starts a program. Its standard error is the runner's: what it writes there is never kept. Where the system has it, the
    // system kills the program as soon as the thread that started it ends, in whatever way: a runner that is killed leaves no
    // program behind that computes for ever. The program's own children do not end with it; they find their standard input at
    // its end. Throws std::system_error where it cannot be started.
    explicit Process(const std::vector<std::string>& command);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    // Sends a line and waits for one. What the program wrote since the last line was read is set aside as unasked; before the
    // first line is sent nothing is. A program that was silent all the time is told apart by the processor time of its group in
    // the second half of the wait: with less than a fiftieth of that half it was waiting (`stall`), else computing. Where /proc
    // does not tell, `timeout`.
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

} // namespace denhartog::conformance
