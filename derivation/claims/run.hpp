/// @file
/// @brief The whole derivation: what was found of the claims and of their mutated twins, and every loss.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "derivation/claims/claim_result.hpp"
#include "derivation/claims/findings.hpp"

namespace denhartog::derivation {

/// @brief The findings of a run.
struct Run {
    std::vector<ClaimResult> claims; ///< one a claim
    nlohmann::json record;           ///< what `denhartog derive` shows: the steps of every claim
    nlohmann::json mutants;          ///< counts of the mutated twins
    std::vector<std::string> faults; ///< why the run has to fail; empty where it need not
};

/// @brief Sums up what was found of all claims, and measures the loss of each printed equation that is refuted.
/// @param claims    the claims, in the order that the run is to have
/// @param findings  what was found of each
/// @return          the run
[[nodiscard]] Run run_of(const std::vector<Claim>& claims, const Findings& findings);

/// @brief Writes the claims of a run so that the ledger can be joined later. @param claims the claims @return JSON
[[nodiscard]] nlohmann::json to_json(const std::vector<ClaimResult>& claims);

/// @brief Reads them back. @param json what `to_json` wrote @return the claims
[[nodiscard]] std::vector<ClaimResult> claims_from_json(const nlohmann::json& json);

} // namespace denhartog::derivation
