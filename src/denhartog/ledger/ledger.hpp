// The equation ledger and the steps of the derivation as the program finds, selects and prints them.
#pragma once

#include <string>

#include "denhartog/ledger/ledger_entry.hpp"

namespace denhartog::ledger {

// Where a ledger may be; the first that is given is taken.
struct Places {
    std::string option;      // named on the command line; empty where it was not
    std::string environment; // named by the environment; empty where it was not
    std::string built;       // where the derivation run of this build leaves it
    std::string rows;        // the hand-written rows, for want of a run
};

// A ledger that was read.
struct Ledger {             // NOLINT(bugprone-exception-escape): a JSON value moves without throwing
    Json entries;           // one object an equation
    bool from_a_run = true; // false: the hand-written rows alone, every verdict unknown
    std::string file;       // where it comes from
};

// Reads a file that holds a JSON array. Throws InputError where it cannot be read, is no JSON, or is no array of objects.
[[nodiscard]] Json read_array(const std::string& file, const std::string& what);

// Reads the ledger. A place that the caller named must hold one; the place of the build need not. Throws InputError where it
// cannot be read or an entry lacks a key.
[[nodiscard]] Ledger read_ledger(const Places& places);

// The number of an equation that a user asks for, as the ledger writes it. Throws InputError naming the range.
[[nodiscard]] std::string asked_equation(const std::string& text);

// Entries of one equation, or of all where it is empty; where an entry has `equations` besides `equation`, each of them counts.
[[nodiscard]] Json entries_of(const Json& entries, const std::string& equation);

// The ledger as a table, a line an equation, and its counts.
[[nodiscard]] std::string table(const Json& entries);

// All that the ledger has on one equation.
[[nodiscard]] std::string card(const Json& entry);

// Reads the steps of the derivation as its last run recorded them, `derivation.json`; the first place that is given is
// taken. It is an array with an object for each claim: claim, equation, title, assumptions, steps (text and latex), verdict; and
// equations where there are several. Throws InputError where there is none, or one that lacks a key.
[[nodiscard]] Json read_derivation(const std::string& option, const std::string& environment, const std::string& built);

// The steps for reading.
[[nodiscard]] std::string derivation_as_text(const Json& claims, const std::string& equation);

// The steps for typesetting: a fragment of LaTeX with a heading a claim; it needs amsmath.
[[nodiscard]] std::string derivation_as_latex(const Json& claims);

} // namespace denhartog::ledger
