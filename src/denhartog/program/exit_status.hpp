/// @file
/// @brief The exit status of the program, and how faults get there.
#pragma once

#include <stdexcept>
#include <string>

namespace denhartog::program {

/// @brief What went wrong so far.
struct ExitStatus {
    bool bad_input = false;      ///< a scene, an option or a file: status 2
    bool digits_missing = false; ///< an answer not to the digits asked for: status 3
    bool failed = false;         ///< an implementation under test does not conform: status 1
    bool broken = false;         ///< an implementation under test broke: status 3
    int signal = 0;              ///< the signal that interrupted the program: status 128 plus its number

    /// @return the status, 0 where nothing went wrong
    [[nodiscard]] int value() const {
        return signal != 0 ? 128 + signal : bad_input ? 2 : digits_missing || broken ? 3 : failed ? 1 : 0;
    }
};

/// @brief Prints a fault as one line on standard error.
/// @param fault  what was wrong
void report(const std::string& fault);

} // namespace denhartog::program
