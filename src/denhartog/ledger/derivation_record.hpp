/// @file
/// @brief The steps of the derivation as its last run recorded them, `derivation.json`.
#pragma once

#include <string>

#include "denhartog/ledger/ledger_entry.hpp"

namespace denhartog::ledger {

/// @brief Reads the record; the first place that is given is taken.
/// @param option       named on the command line; empty where it was not
/// @param environment  named by the environment; empty where it was not
/// @param built        where the derivation run of this build leaves it
/// @return             an array, an object a claim: claim, equation, title, assumptions, steps (text and latex), verdict; and
///                     equations where there are several
/// @throws             InputError where there is none, or one that lacks a key
[[nodiscard]] Json read_derivation(const std::string& option, const std::string& environment, const std::string& built);

/// @brief The steps for reading.
/// @param claims    what `entries_of` selects from the record
/// @param equation  the equation asked for, or empty
/// @return          lines of text
[[nodiscard]] std::string derivation_as_text(const Json& claims, const std::string& equation);

/// @brief The steps for typesetting: a fragment of LaTeX with a heading a claim.
/// @param claims  what `entries_of` selects from the record
/// @return        lines of LaTeX that need amsmath
[[nodiscard]] std::string derivation_as_latex(const Json& claims);

} // namespace denhartog::ledger
