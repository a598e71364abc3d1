/// @file
/// @brief What a person wrote on each departure from the print: a sentence, and both formulas with the difference marked.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "denhartog/ledger/ledger_entry.hpp"

namespace denhartog::pages {

/// @brief A departure in words.
struct DepartureText {
    std::string said;    ///< what is wrong, which way it errs, whether it matters
    std::string printed; ///< LaTeX as printed, `\misprint{}` around what is wrong; empty where the formulas do not differ
    std::string holds;   ///< LaTeX of what holds in the paper's symbols, `\mended{}` around what is other
};

/// @brief The departures by their equations.
using Departures = std::map<std::string, DepartureText>;

/// @brief Reads `departures.json` of the ledger's hand-written half. @param file its path @return the departures
/// @throws InputError where it cannot be read
[[nodiscard]] Departures read_departures(const std::filesystem::path& file);

/// @brief Why the departures do not fit the run: an equation that departs without a sentence, a sentence on one that does not, a
/// formula that without its marks is not what is printed.
/// @param departures  the departures
/// @param entries     the entries of the ledger
/// @return            a sentence each
[[nodiscard]] std::vector<std::string> faults_of(const Departures& departures, const ledger::Json& entries);

/// @brief LaTeX without the marks of a difference. @param latex LaTeX @return the same without them
[[nodiscard]] std::string without_marks(const std::string& latex);

} // namespace denhartog::pages
