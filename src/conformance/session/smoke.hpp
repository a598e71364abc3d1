/// @file
/// @brief Whether a program keeps to the protocol: the form of its answers, and no number.
#pragma once

#include <string>
#include <vector>

#include "conformance/session/session.hpp"

namespace denhartog::conformance {

/// @brief One thing looked at.
struct SmokeCheck {
    std::string what;  ///< e.g. `amplitude`
    std::string found; ///< what the program did, in words
    bool good = false; ///< whether the protocol allows it
};

/// @brief What a look at the protocol found.
struct Smoke {
    std::string name;               ///< of the program
    std::string dialect;            ///< `json` or `plain`
    std::vector<SmokeCheck> checks; ///< in the order in which they were made
    bool broken = false;            ///< the program broke
};

/// @brief Shakes hands, asks for every quantity once, for one that there is not, and one question that breaks a rule.
/// @param settings  how the program is run
/// @return          what was found
/// @throws          BrokenProgram where it cannot be started or does not shake hands
[[nodiscard]] Smoke smoke(const RunSettings& settings);

} // namespace denhartog::conformance
