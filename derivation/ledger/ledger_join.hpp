/// @file
/// @brief The ledger: hand-written rows, functions, tests and claims brought together, and what is missing among them.
#pragma once

#include <string>
#include <vector>

#include "denhartog/ledger/ledger_entry.hpp"
#include "derivation/claims/claim_result.hpp"
#include "derivation/ledger/source_index.hpp"
#include "derivation/ledger/test_index.hpp"

namespace denhartog::derivation {

/// @brief The parts of the ledger.
struct LedgerParts {
    ledger::Json rows;                    ///< `docs/ledger/equations.json`, without faults
    std::vector<FunctionEntry> functions; ///< from `functions_of_sources`
    std::vector<DeclaredTest> declared;   ///< from `tests_of_sources`
    TestResults results;                  ///< from `read_test_results`; where none was found, tests are not judged
    std::vector<ClaimResult> claims;      ///< from the run
};

/// @brief The ledger.
struct JoinedLedger {
    ledger::Json entries;            ///< an object an equation, in the paper's order; what `ledger.json` holds
    ledger::Json summary;            ///< counts and lists over the entries
    std::vector<std::string> faults; ///< why the run has to fail, a sentence each; empty where it need not
};

/// @brief Brings the parts together.
///
/// As printed: the worst verdict of the claims on the printed form, of each on this equation. As shipped: the worst verdict of
/// the claims on the formula, `not_applicable` where none is shipped. Neither is proved without a claim of the kind `derived`, or
/// of the kind `refinement` where what it refines is derived, that says what no other claim has said: without one a definition is
/// a `definition`, an assumption an `assumption`, and anything else `unknown`, a fault. A printed form that is refuted by claims
/// on slips of the scan alone is `illegible`. Functions are listed with the paper's form first, then the evaluation forms, then
/// what makes use of the equation elsewhere in the library.
///
/// Faults: an equation without a verdict or with an unknown one; a formula without a claim or without a test that ran and
/// passed; neither a formula nor a reason why not, or both; a refuted printed form without its kind of departure, without a
/// correction or without a shipped form that is proved; a refuted shipped form; a loss that is not finite; a tagged test that
/// did not run or failed; a claim, a function or a test that speaks of no equation.
///
/// A step or an observation decides no equation. Either may be `argued`: a part of it is the argument of a person. An observation
/// may be `measured`: a range was searched without a counterexample, and the witness has the largest departure from what the text
/// says.
/// @param parts  what the run found
/// @return       entries, summary and faults
[[nodiscard]] JoinedLedger join_ledger(const LedgerParts& parts);

} // namespace denhartog::derivation
