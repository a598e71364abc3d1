/// @file
/// @brief Numbers as the answers print them.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "denhartog/number/certified.hpp"

namespace denhartog::program {

/// @brief JSON that keeps the order of its keys.
using Json = nlohmann::ordered_json;

/// @brief Writes numbers: JSON numbers up to 15 digits, text with the digits asked for above.
struct NumberWriter {
    std::optional<int> digits; ///< significant digits asked for

    /// @param x  a finite number
    /// @return   the number as JSON; never a negative zero
    /// @throws   PrecisionError where it is not finite, or no double holds it
    [[nodiscard]] Json operator()(double x) const;
    /// @copydoc operator()(double) const
    [[nodiscard]] Json operator()(const Certified& x) const;
    /// @brief Writes a bound of an error, rounded up where it is text. @param e the bound @return the bound as JSON
    [[nodiscard]] Json bound(double e) const;
    /// @brief The same, null where nothing is known. @param e the bound, or infinity @return the bound as JSON
    [[nodiscard]] Json bound_or_null(double e) const;
};

/// @brief A number for a table.
/// @param x  a JSON number, or text
/// @return   text of at most 12 significant digits for a number; the text as it is
[[nodiscard]] std::string in_table(const Json& x);

/// @brief A member of an answer for a table.
/// @param object  the answer
/// @param key     its key
/// @return        the member as `in_table` has it; `-` where there is none
[[nodiscard]] std::string cell(const Json& object, const char* key);

} // namespace denhartog::program
