/// @file
/// @brief The whole derivation: every claim decided, every mutated twin tried, every loss measured.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "derivation/claim_result.hpp"

namespace denhartog::derivation {

/// @brief What the run found.
struct Run {
    std::vector<ClaimResult> claims;   ///< one a claim
    nlohmann::json record;             ///< what `denhartog derive` shows: the steps of every claim
    nlohmann::json mutants;            ///< counts of the mutated twins
    std::vector<std::string> faults;   ///< why the run has to fail; empty where it need not
};

/// @brief Decides every claim and tries its mutated twins.
/// @param progress  called with a line of text before each claim
/// @return          the run
[[nodiscard]] Run run_claims(const std::function<void(const std::string&)>& progress);

/// @brief Writes the claims of a run so that the ledger can be joined later. @param claims the claims @return JSON
[[nodiscard]] nlohmann::json to_json(const std::vector<ClaimResult>& claims);

/// @brief Reads them back. @param json what `to_json` wrote @return the claims
[[nodiscard]] std::vector<ClaimResult> claims_from_json(const nlohmann::json& json);

} // namespace denhartog::derivation
