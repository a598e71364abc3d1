// How a program under test is started: two pipes, a group of its own, and a death that follows the runner's.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace denhartog::conformance {

// A program that was started. Whoever has it closes the pipes and waits for its end.
struct StartedProgram {
    pid_t group = -1; // its process, which leads a group of the same number
    int to = -1;      // end of the pipe to its standard input, which does not block
    int from = -1;    // end of the pipe from its standard output, which does not block
};

// Starts a program. Its standard error is the runner's: what it writes there is never kept. Where the system has it, the system
// kills the program as soon as the thread that started it ends, in whatever way: a runner that is killed leaves no program behind
// that computes for ever. The program's own children do not end with it; they find their standard input at its end. Throws
// std::system_error where it cannot be started.
[[nodiscard]] StartedProgram start(const std::vector<std::string>& command);

} // namespace denhartog::conformance
