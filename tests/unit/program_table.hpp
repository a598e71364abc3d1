/// @file
/// @brief Runs of the program as tables in text: status, arguments, standard input, and what is printed.
///
/// A row is `STATUS ARGUMENTS < SCENE > TEXT ! TEXT`; all but the status may be left out.
/// - `{a|b}` among the arguments stands for one run with each. In a text, `{}` is what was taken.
/// - SCENE is the name of a line of tests/named_scenes.jsonl, and a merge patch that changes it: `two {"r": 2, "beta": null}`.
///   `two + + one` are three lines of input, one of them empty; `<<` gives the input itself.
/// - `> TEXT` must stand in the output, `! TEXT` in the error. Each may come several times.
/// - Lines below a row that begin with `=` have a pattern of the JSON that is printed: of its members those that are named.
///   `null` is a member that is absent. `0`, `1` ... name the places of a list, `*` all of them. A text is a rule where it begins
///   with `~ 2 1e-9` (near 2, relatively), `>`, `>=`, `<` (a number), `#` (size), `keys` (those of an object, in their order),
///   `has` (part of a text), `longer` (more characters), `text` or `number` (a type). Where there are several scenes the pattern
///   is of the list of lines.
/// - A line below a row that begins with `|` is a line of the output, the next one that of the next `|`; `| # 9` is their number.
/// - A line that begins with none of these goes on with the line above.
///
/// A run that fails, and has one scene at most, leaves the output empty; each that fails has one line of printable text for its
/// error, which begins with `denhartog: `; one that does not fail and has no `!` has no error.
#pragma once

#include <string>

#include "tests/unit/program_runs.hpp"

namespace denhartog::tests {

/// @brief Checks every row of a table. @param table the rows @param begin what the arguments of each begin with
void expect(const std::string& table, const std::string& begin = "");

/// @brief What of a table is not so. @param table the rows @param begin as above @return the claims that are wrong
[[nodiscard]] std::vector<std::string> faults_of(const std::string& table, const std::string& begin = "");

/// @brief Standard input by what a row has for it. @param text names of scenes with patches, joined by ` + ` @return the input
[[nodiscard]] std::string scene_text(const std::string& text);

/// @brief Runs a command that must not fail. @param arguments its own @param scene as in a row @return what it prints, as JSON
[[nodiscard]] nlohmann::json answer_of(const std::string& arguments, const std::string& scene);

/// @brief One short line of printable text on standard error, and nothing else, is what a run that is refused leaves.
void check_refused(const Run& run, int status, const std::string& piece);

} // namespace denhartog::tests
