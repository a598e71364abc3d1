/// @file
/// @brief What a run wrote, as the pages take it: ledger, derivation, figures, measurements.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "denhartog/ledger/ledger_entry.hpp"
#include "departures.hpp"
#include "offers.hpp"
#include "symbols.hpp"

namespace denhartog::pages {

using ledger::Json;

/// @brief A figure of the run.
struct FigureRecord {
    std::string name;                   ///< of its files
    std::string title;                  ///< what is drawn
    Json record;                        ///< what its program wrote; null where it has none
    std::string script;                 ///< its plot script, from the root of the sources
    std::vector<std::string> data = {}; ///< names of the files with its data
    std::string caption = {};           ///< what to see in it, as a person wrote it, with formulas between dollars
};

/// @brief The number of a figure in the paper. @param figure the figure @return e.g. `Fig. 7`; empty where the paper has
/// none of it
[[nodiscard]] std::string figure_number(const FigureRecord& figure);

/// @brief A figure's title with its number. @param figure the figure @return e.g. `Fig. 7: Regimes of motion of a single mass`
[[nodiscard]] std::string figure_title(const FigureRecord& figure);

/// @brief All that the pages are made of.
struct RunRecord {
    Json ledger;                                ///< entries in the paper's order
    std::map<std::string, Json> claims;         ///< records of the derivation by claim
    std::map<std::string, std::string> symbols; ///< LaTeX of the names in witnesses, where the derivation has written it
    Json run;                                   ///< the run's own record: agreement, mutants
    std::map<std::string, Json> certificates;   ///< lemmas for the kernel by claim; empty where none were exported
    std::vector<FigureRecord> figures;          ///< those of the paper first
    std::vector<Json> accuracy; ///< worst errors by function, a record a survey; empty where the tests have not run
    std::string chart;          ///< tables of speed against accuracy, Markdown; empty where it was not measured
    std::string batch;          ///< tables of batches, Markdown; empty where they were not measured
    Departures departures;      ///< what a person wrote on each departure
    std::map<std::string, std::string> remarks; ///< what a person wrote on other equations, with formulas between dollars
    std::vector<Symbol> notation;               ///< the paper's symbols
    std::map<std::string, std::vector<CheckScene>> checks; ///< certified questions by equation, for the reader's own number
    /// What the conformance kit was tried on, Markdown by the name of its file; those that were not made are not there.
    std::map<std::string, std::string> conformance;
};

/// @brief Reads what a run wrote.
/// @param verify  the run's folder, with `paper`, `figures`, `chart` and `test-results`
/// @param source  the root of the sources
/// @return        the record
/// @throws        InputError where the ledger or the derivation cannot be read, or an equation of the paper has no entry
[[nodiscard]] RunRecord read_run(const std::filesystem::path& verify, const std::filesystem::path& source);

/// @brief The entry of an equation. @param run the record @param equation its number @return the entry
/// @throws InputError where there is none
[[nodiscard]] const Json& entry_of(const RunRecord& run, const std::string& equation);

/// @brief The record of a claim's steps.
///
/// A claim whose loss differs from equation to equation is in the ledger once for each, its id with the equation at the end.
/// @param run    the record
/// @param claim  the claim's id in the ledger
/// @return       its entry in the derivation's record
/// @throws       InputError where there is none
[[nodiscard]] const Json& record_of(const RunRecord& run, const std::string& claim);

/// @brief The statement that holds: the correction, or what the scan is read as, or what is printed. @param entry of the ledger
/// @return LaTeX
[[nodiscard]] std::string statement_that_holds(const Json& entry);

/// @brief Whether a printed form does not hold as it stands: refuted, or illegible in the text at hand. @param verdict its
/// verdict
/// @return  true where another form holds
[[nodiscard]] inline bool fails(const std::string& verdict) { return verdict == "refuted" || verdict == "illegible"; }

/// @brief A verdict as a reader reads it. @param verdict as the ledger has it @return e.g. `not applicable`
[[nodiscard]] std::string verdict_text(const std::string& verdict);

/// @brief A verdict as an element with the class of the style sheet. @param verdict as the ledger has it @return HTML
[[nodiscard]] std::string verdict_mark(const std::string& verdict);

/// @brief The kind of a departure in words. @param departure as the ledger has it @return e.g. `a slip of the scan`
[[nodiscard]] std::string departure_text(const std::string& departure);

} // namespace denhartog::pages
