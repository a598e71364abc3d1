/// @file
/// @brief The command-line program. A new commit compiles this source alone.
#include "denhartog/program/program.hpp"

int main(int argc, char** argv) { return denhartog::program::run_program(argc, argv, {DENHARTOG_COMMIT, DENHARTOG_COMPILER}); }
