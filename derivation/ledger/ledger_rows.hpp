/// @file
/// @brief The hand-written half of the ledger, `docs/ledger/equations.json`: how it is read and what it has to obey.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "denhartog/ledger/ledger_entry.hpp"

namespace denhartog::derivation {

/// @brief Reads the rows; says nothing of their content.
/// @param file  `docs/ledger/equations.json`
/// @return      a JSON array
/// @throws      InputError where the file cannot be read or is no JSON
[[nodiscard]] ledger::Json read_rows(const std::filesystem::path& file);

/// @brief The fault of LaTeX at which a formula typesetter would stop: braces, `\left` and `\right`, environments.
/// @param latex  a formula
/// @return       the fault in words; empty where there is none
[[nodiscard]] std::string latex_fault(const std::string& latex);

/// @brief Checks the rows: all 103 in the paper's order, known keys and words, LaTeX that can be set, and what rests on what.
///
/// A row rests on rows before it, on rows of the Appendix (Section 2 quotes its results), or on definitions, which the paper
/// often gives after their first use; nothing rests on itself, however far round.
/// @param rows  as read by `read_rows`
/// @return      the faults, one sentence each; empty where there is none
[[nodiscard]] std::vector<std::string> faults_of_rows(const ledger::Json& rows);

} // namespace denhartog::derivation
