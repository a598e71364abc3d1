/// @file
/// @brief What the surveys share: the worst of many errors, Markdown tables.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace denhartog::tests {

/// @brief A Markdown table.
struct Table {
    std::string title;                          ///< heading
    std::vector<std::string> head;              ///< names of the columns
    std::vector<std::vector<std::string>> rows; ///< cells
    std::string note;                           ///< what stands below the table; may be empty
};

/// @brief A table as text. @param t the table @return Markdown, with an empty line at its end
[[nodiscard]] std::string markdown(const Table& t);

/// @brief A number in few digits. @param x the number @param format how, as `printf` has it @return its text
[[nodiscard]] inline std::string digits(double x, const char* format = "%.3g") {
    char text[40];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

/// @brief The worst of many errors.
struct Worst {
    double error = 0;    ///< the largest so far
    std::string where{}; ///< where
    int count = 0;       ///< how many were noted

    /// @brief Takes note of an error; one that is no number is the worst. @param e the error @param at where
    void note(double e, const std::string& at) {
        ++count;
        if (!(e <= error)) {
            error = e;
            where = at;
        }
    }
};

} // namespace denhartog::tests
