/// @file
/// @brief Claims and their derivations as text.
#pragma once

#include <string>

#include "run_record.hpp"
#include "sources.hpp"

namespace denhartog::pages {

/// @brief What the pages share while they are made.
struct Book {
    const RunRecord& run;   ///< what the run wrote
    const Sources& sources; ///< the sources
};

/// @brief The label of the place where a claim's steps stand. @param record the derivation's record of it @return the label
[[nodiscard]] std::string claim_label(const Json& record);

/// @brief A link to a claim's steps. @param record the derivation's record of it @return the link
[[nodiscard]] std::string claim_link(const Json& record);

/// @brief The steps of a claim as the run recorded them, each a sentence and its formula.
/// @param claim  its record
/// @return       text for Doxygen
[[nodiscard]] std::string steps_text(const Json& claim);

/// @brief A claim in full: what it says, role, assumptions, verdict, witness, source, steps.
/// @param book      the run
/// @param claim     the ledger's entry of it
/// @param equation  on whose page it is to stand; the steps stand on one page alone, the others link to it
/// @return          text for Doxygen
/// @throws          InputError where the derivation has no record of it, or no source makes it
[[nodiscard]] std::string claim_text(const Book& book, const Json& claim, const std::string& equation);

/// @brief A witness as a paragraph of names and values. @param run with the symbols of the names @param witness of the ledger
/// @return text for Doxygen; empty where there is none
[[nodiscard]] std::string witness_text(const RunRecord& run, const Json& witness);

/// @brief The scene that shows that a printed equation does not hold, or why there is none. @param entry of the ledger
/// @return text for Doxygen; empty where the printed form stands
[[nodiscard]] std::string scene_text(const Json& entry);

} // namespace denhartog::pages
