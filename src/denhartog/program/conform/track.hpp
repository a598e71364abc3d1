/// @file
/// @brief Verdicts kept from run to run, and what got better and worse.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "conformance/verdict.hpp"

namespace denhartog::program {

/// @brief Verdicts by id.
using Verdicts = std::map<std::string, conformance::Verdict>;

/// @brief A verdict that changed for better or worse.
struct Change {
    std::string id;              ///< the vector
    conformance::Verdict before; ///< in the file
    conformance::Verdict now;    ///< in this run
};

/// @brief This run beside the file.
struct Comparison {
    std::vector<Change> better; ///< by id
    std::vector<Change> worse;  ///< by id
};

/// @brief The verdicts of a file.
/// @param path  the file
/// @return      its verdicts; none where there is no file yet
/// @throws      InputError where it cannot be read or is no such file
[[nodiscard]] std::optional<Verdicts> tracked_verdicts(const std::string& path);

/// @brief Compares a run with a file. @param before the file's verdicts @param judged the run's @return what changed
[[nodiscard]] Comparison compare(const Verdicts& before, std::span<const conformance::Judged> judged);

/// @brief The text of a file of verdicts: those of a run, and the earlier ones of vectors that were not asked.
/// @param before  the earlier verdicts
/// @param judged  the run's
/// @return        the text
[[nodiscard]] std::string tracked_text(Verdicts before, std::span<const conformance::Judged> judged);

} // namespace denhartog::program
