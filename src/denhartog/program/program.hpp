/// @file
/// @brief The command-line program as a function.
#pragma once

#include <string>

namespace denhartog::program {

/// @brief What `--version` says of the build.
struct Build {
    std::string commit;   ///< the commit; empty where none is known
    std::string compiler; ///< the compiler and its version
};

/// @brief Reads the arguments, and runs the subcommand that they name.
/// @param argc   number of arguments, the program's name among them
/// @param argv   the arguments
/// @param build  what `--version` says
/// @return       the exit status
int run_program(int argc, char** argv, const Build& build);

} // namespace denhartog::program
