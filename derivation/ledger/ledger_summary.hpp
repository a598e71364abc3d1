/// @file
/// @brief Counts and lists over the entries of the ledger and the claims, and the words that verdicts and departures have.
#pragma once

#include <string>
#include <vector>

#include "denhartog/ledger/ledger_entry.hpp"
#include "derivation/claims/claim_result.hpp"

namespace denhartog::derivation {

/// @brief The words for a verdict. @return the words, from the best to the worst
[[nodiscard]] const std::vector<std::string>& verdict_words();

/// @brief The words for a departure from the print. @return the words, from the best to the worst
[[nodiscard]] const std::vector<std::string>& departure_words();

/// @brief Whether a claim speaks of neither the printed nor the shipped form. @param claim a claim @return true where it does not
[[nodiscard]] bool aside(const ClaimResult& claim);

/// @brief Counts and lists. @param entries the ledger @param claims what the run found @param tests_ran whether tests were judged
/// @return  an object
[[nodiscard]] ledger::Json summary_of(const ledger::Json& entries, const std::vector<ClaimResult>& claims, bool tests_ran);

} // namespace denhartog::derivation
