/// @file
/// @brief What a figure is made of: its data, and the record of what it shows.
///
/// A figure is a source, which computes `NAME.dat` and `NAME.json`, and a gnuplot script of the same name, which draws the data.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace denhartog::figures {

/// @brief A statement of the paper's text that the figure's data bear out, or do not; in a figure beyond the paper one of ours.
struct Statement {
    std::string text;  ///< what the text says, in words of ours
    std::string found; ///< what the data say, with its number
    bool borne_out;    ///< whether they bear it out
    std::string
        measure{}; ///< the number of ours that decides where the text has none, e.g. `to 1 percent`; empty where none does
};

/// @brief How far markers are from lines.
struct Agreement {
    std::string what;  ///< which markers, which lines, relative to what
    int points = 0;    ///< how many were compared
    double median = 0; ///< median of the differences
    double worst = 0;  ///< largest difference
    std::string where; ///< where it is
};

/// @brief What a figure shows: all of it goes into `paper-figures/README.md`.
struct Record {
    std::string title;                  ///< what is to be seen, in a line
    std::vector<std::string> equations; ///< whose curves are drawn, as the ledger numbers them, e.g. `69`
    std::vector<std::string> given;     ///< parameters that caption and text give
    std::vector<std::string> chosen;    ///< parameters and ranges that they do not give
    std::vector<Agreement> agreements;  ///< markers against lines
    std::vector<Statement> statements;  ///< what the text says of it
    std::vector<std::string> remarks;   ///< what is to be seen besides; may be empty
};

/// @brief A table of numbers; NaN leaves a gap in a line.
struct Table {
    std::string name;                              ///< how the plot script asks for it: `index "name;"`. Unique in its file
    std::vector<std::string> columns;              ///< names of the columns
    std::vector<std::vector<double>> rows;         ///< numbers, as many as there are columns in each
    std::vector<std::vector<std::string>> words{}; ///< texts of the rows, after the numbers in quotes; none, or those of each row
};

/// @brief Where a figure puts its data, and says how far it is.
class Figure {
public:
    /// @brief Opens the data file of a figure.
    /// @param folder  where it is written
    /// @param name    the figure's name
    Figure(std::filesystem::path folder, std::string name);

    /// @brief Adds a table. @param table the table @throws std::invalid_argument for a second table of a name, or a ragged row
    void add(const Table& table);

    /// @brief Shows on a terminal how far the work is. @param done pieces done @param all pieces in all
    void progress(std::size_t done, std::size_t all) const;

    /// @brief Writes `NAME.dat` and `NAME.json`, each whole or not at all. Data that are there already stay untouched, so that
    ///        their pictures need not be drawn again.
    /// @param record   what the figure shows
    /// @param seconds  time taken
    void write(const Record& record, double seconds) const;

private:
    std::filesystem::path folder_;
    std::string name_;
    std::vector<std::string> tables_;
    std::string data_;
};

/// @brief Computes what a figure shows.
using Make = Record (*)(Figure& figure);

/// @brief Lists a figure when constructed at namespace scope.
struct Listed {
    /// @param name  the figure's name
    /// @param make  computes it
    Listed(const std::string& name, Make make);
};

/// @brief All figures by their names. @return the list
[[nodiscard]] const std::map<std::string, Make>& listed_figures();

/// @brief A number as text in a few digits, e.g. `0.537`. @param x the number @param format as `printf` has it @return its text
[[nodiscard]] std::string text(double x, const char* format = "%.4g");

/// @brief Equally spaced numbers. @param a first @param b last @param n how many, at least 2 @return the numbers
[[nodiscard]] std::vector<double> spaced(double a, double b, std::size_t n);

/// @brief Numbers spaced equally in their logarithms. @param a first @param b last @param n how many, at least 2
/// @return the numbers
[[nodiscard]] std::vector<double> spaced_in_octaves(double a, double b, std::size_t n);

/// @brief Sums up differences.
/// @param what         which markers, which lines, relative to what
/// @param differences  differences, none of them NaN, and where each is
/// @return             their median and the largest
/// @throws             std::invalid_argument where there are none, or one is no number
[[nodiscard]] Agreement agreement(const std::string& what, const std::vector<std::pair<double, std::string>>& differences);

} // namespace denhartog::figures
