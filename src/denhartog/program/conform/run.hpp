/// @file
/// @brief What the subcommands of `denhartog conform` do.
#pragma once

#include "denhartog/program/conform/options.hpp"
#include "denhartog/program/exit_status.hpp"

namespace denhartog::program {

/// @brief `conform run`: asks a program the chosen questions and reports. @param options the options @param status for faults
/// @throws InputError, and BrokenProgram where the program cannot be started or does not shake hands
void conform_run(const ConformOptions& options, ExitStatus& status);

/// @brief `conform grade`: reports on answers in a file. @param options the options @param status for faults @throws InputError
void conform_grade(const ConformOptions& options, ExitStatus& status);

/// @brief `conform run --repro`: one question as a command, and what comes of it. @param options the options
/// @param status for faults @throws as `conform_run`
void conform_repro(const ConformOptions& options, ExitStatus& status);

/// @brief `conform smoke`: whether a program keeps to the protocol. @param options the options @param status for faults
/// @throws as `conform_run`
void conform_smoke(const ConformOptions& options, ExitStatus& status);

} // namespace denhartog::program
