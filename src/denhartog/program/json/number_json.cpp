// Numbers as answers print them: JSON numbers up to 15 digits, text with more, and cells of tables that are aligned. A number
// that is not finite is refused here, so that none is ever printed.
#include "denhartog/program/json/number_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "denhartog/number/errors.hpp"

namespace denhartog::program {
Json NumberWriter::operator()(double x) const {
    if (!std::isfinite(x)) throw PrecisionError("the answer holds a number beyond the range of a double", Outcome::out_of_range);
    return x == 0 ? 0.0 : x;
}

Json NumberWriter::operator()(const Certified& x) const {
    if (!x.decimal.empty()) return x.decimal;
    return (*this)(x.value);
}

Json NumberWriter::bound(double e) const {
    if (digits.value_or(0) <= most_digits_of_a_double) return (*this)(e);
    char text[32];
    std::snprintf(text, sizeof text, "%.3e", (*this)(e * 1.001).get<double>());
    return text;
}

Json NumberWriter::bound_or_null(double e) const { return std::isfinite(e) ? bound(e) : Json(nullptr); }

std::string in_table(const Json& x) {
    if (x.is_string()) return x.get<std::string>();
    if (x.is_null()) return "-";
    if (x.is_number_integer()) return std::to_string(x.get<long>());
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", x.get<double>());
    return text;
}

std::string cell(const Json& object, const char* key) { return object.contains(key) ? in_table(object.at(key)) : "-"; }

std::string aligned(const Rows& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c) line += "  " + row[c] + std::string(widths[c] - row[c].size(), ' ');
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string aligned(std::vector<std::string> heading, const Json& objects, const std::vector<const char*>& keys) {
    Rows rows{std::move(heading)};
    for (const Json& object : objects) {
        rows.emplace_back();
        for (const char* key : keys) rows.back().push_back(cell(object, key));
    }
    return aligned(rows);
}

} // namespace denhartog::program
