/// @file
/// @brief The equation ledger as the program finds, selects and prints it.
#pragma once

#include <string>

#include "denhartog/ledger/ledger_entry.hpp"

namespace denhartog::ledger {

/// @brief Where a ledger may be; the first that is given is taken.
struct Places {
    std::string option;      ///< named on the command line; empty where it was not
    std::string environment; ///< named by the environment; empty where it was not
    std::string built;       ///< where the derivation run of this build leaves it
    std::string rows;        ///< the hand-written rows, for want of a run
};

/// @brief A ledger that was read.
struct Ledger {           // NOLINT(bugprone-exception-escape): a JSON value moves without throwing
    Json entries;         ///< one object an equation
    bool of_a_run = true; ///< false: the hand-written rows alone, every verdict unknown
    std::string file;     ///< where it comes from
};

/// @brief Reads a file that holds a JSON array.
/// @param file  its path
/// @param what  what it is to be, for the message
/// @return      the array
/// @throws      InputError where it cannot be read, is no JSON, or is no array of objects
[[nodiscard]] Json read_array(const std::string& file, const std::string& what);

/// @brief Reads the ledger. A place that the caller named must hold one; the place of the build need not.
/// @param places  where to look
/// @return        the ledger, or the rows alone
/// @throws        InputError where it cannot be read or an entry lacks a key
[[nodiscard]] Ledger read_ledger(const Places& places);

/// @brief The number of an equation that a user asks for.
/// @param text  as the user wrote it, e.g. `(46)`
/// @return      the number as the ledger writes it
/// @throws      InputError naming the range
[[nodiscard]] std::string asked_equation(const std::string& text);

/// @brief Entries of one equation, or all.
/// @param entries   objects with the key `equation`; where one has `equations` too, each of them counts
/// @param equation  a number, or empty for all
/// @return          an array
[[nodiscard]] Json entries_of(const Json& entries, const std::string& equation);

/// @brief The ledger as a table, a line an equation, and its counts.
/// @param entries  the ledger
/// @return         lines of text
[[nodiscard]] std::string table(const Json& entries);

/// @brief All that the ledger has on one equation.
/// @param entry  its entry
/// @return       lines of text
[[nodiscard]] std::string card(const Json& entry);

} // namespace denhartog::ledger
