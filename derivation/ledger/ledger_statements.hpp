/// @file
/// @brief The statements of the paper's text, with the verdict on each: the rows of `docs/ledger/statements.json`
///        and the claims that decide them brought together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "denhartog/ledger/ledger_entry.hpp"
#include "derivation/claims/claim_result.hpp"

namespace denhartog::derivation {

/// @brief The statements with their verdicts.
struct Statements {
    ledger::Json rows;               ///< an object a statement: section, statement, verdict, claims with their verdicts, remark
    ledger::Json counts;             ///< how many have which verdict
    std::vector<std::string> faults; ///< what is missing, a sentence each
};

/// @brief Decides every statement by the worst verdict of its claims.
///
/// A claim that is named stands for all claims whose ids begin with it and a slash, as `19/damping-matrix` for those of each N.
/// A verdict is one of `proved`, `argued`, `measured`, `refuted at a threshold of ours`, `refuted`; a reference to the wrong
/// equation is a `slip of reference` where the equations cited lack the symbol in question and those meant have it, or where the
/// figures cited do not draw the equation in question and those meant do; what the paper sets out from is an
/// `assumption`; what nothing decides is `not decided`, with the reason.
///
/// Faults: a claim that does not exist; an observation of the text that stands in no row; a row that nothing decides and that
/// does not say why; a reference that is no slip.
/// @param rows       the rows of the file
/// @param claims     what the run found
/// @param equations  the rows of `equations.json`
/// @param figures    records of the figures; where there are none, references to figures are `not decided`
/// @return           the statements
[[nodiscard]] Statements join_statements(const ledger::Json& rows, const std::vector<ClaimResult>& claims,
                                         const ledger::Json& equations, const std::vector<nlohmann::json>& figures);

} // namespace denhartog::derivation
