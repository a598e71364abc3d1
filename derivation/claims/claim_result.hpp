/// @file
/// @brief The findings on one claim, in words and numbers; the ledger is joined from these.
///
/// Plain text on purpose: the ledger is joined and tested without GiNaC.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "derivation/claims/threshold.hpp"

namespace denhartog::derivation {

/// @brief One claim after the run.
struct ClaimResult {
    std::string id;                                    ///< unique, e.g. `A.7/velocity`
    std::vector<std::string> equations;                ///< equations it concerns, as the ledger writes them: `46`, `A.7`
    std::string role = "step";                         ///< both, printed, shipped, step or observation, as in `Role`
    std::string verdict = "unknown";                   ///< one of the ledger's words for a verdict
    std::map<std::string, std::string> by_equation;    ///< verdict of each equation, where it is not the same for all
    std::string kind = "derived";                      ///< derived, refinement, restated, consequence, argument or observation
    std::vector<std::string> refines;                  ///< of a refinement: other equations whose formulas its derived side calls
    std::string same_as;                               ///< a claim before it that says the same; empty where none does
    std::string what;                                  ///< the claim in a sentence
    std::vector<std::string> assumptions;              ///< where it is claimed, divisions included
    std::string departure = "none";                    ///< of a printed form: none, scan, misprint, substance, convention
    std::string correction_latex;                      ///< of a printed form that does not hold: what holds instead
    std::string correction_by = "hand";                ///< who wrote it: hand, or run where it is printed from the derived side
    nlohmann::json witness = nlohmann::json::object(); ///< the point that refutes it, or the cases that were searched
    std::vector<Threshold> thresholds; ///< of an observation: numbers that vague words of the text were taken to be
    std::optional<double> loss;        ///< worst relative error for who codes the printed form; dimensionless
    std::string consequence;           ///< the loss in words, with the scene it was found on
};

} // namespace denhartog::derivation
