// The command-line program as a function.
#pragma once

#include <string>

namespace denhartog::program {

// Build, as `--version` shows it.
struct Build {
    std::string commit; // empty where none is known
    std::string compiler;
};

// Reads the arguments, runs the subcommand that they name, and gives the exit status.
int run_program(int argc, char** argv, const Build& build);

} // namespace denhartog::program
