// Numbers as the answers print them: in JSON, and in tables.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "denhartog/number/certified.hpp"

namespace denhartog::program {

// JSON that keeps the order of its keys.
using Json = nlohmann::ordered_json;

// Writes numbers: JSON numbers up to 15 digits, text with the digits asked for above. Never a negative zero. Throws PrecisionError
// for a number that is not finite.
struct NumberWriter {
    std::optional<int> digits; // significant digits asked for

    [[nodiscard]] Json operator()(double x) const;
    [[nodiscard]] Json operator()(const Certified& x) const;
    // A bound of an error, rounded up where it is text.
    [[nodiscard]] Json bound(double e) const;
    // A bound, null if it is infinite, as nothing is then known.
    [[nodiscard]] Json bound_or_null(double e) const;
};

// A number for a table, in at most 12 significant digits; text as it is.
[[nodiscard]] std::string in_table(const Json& x);

// A member of an answer for a table; `-` where there is none.
[[nodiscard]] std::string cell(const Json& object, const char* key);

// Rows of cells as lines, each column as wide as its widest cell.
using Rows = std::vector<std::vector<std::string>>;
[[nodiscard]] std::string aligned(const Rows& rows);

// The members of some objects, a row each, under a heading.
[[nodiscard]] std::string aligned(std::vector<std::string> heading, const Json& objects, const std::vector<const char*>& keys);

} // namespace denhartog::program
