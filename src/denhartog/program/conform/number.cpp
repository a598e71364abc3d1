#include "denhartog/program/conform/number.hpp"

#include <array>
#include <cstdio>

#include "denhartog/number/number_text.hpp"

namespace denhartog::program {
namespace {

std::string with_one_decimal(double x) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.1f", x);
    return text.data();
}

} // namespace

std::string rough(double x) { return number_in_digits(x, 2); }

std::string digits_cell(const std::optional<double>& digits) { return digits ? with_one_decimal(*digits) : "-"; }

std::string value_text(const conformance::Value& value) {
    constexpr std::size_t most = 4;
    if (!value.word.empty()) return value.word;
    if (value.numbers.empty()) return "nothing";
    if (value.numbers.size() == 1)
        return number_to_text(value.numbers.front()) + " (" + conformance::hexadecimal_float(value.numbers.front()) + ")";
    std::string text;
    for (std::size_t n = 0; n < value.numbers.size() && n < most; ++n)
        text += (n > 0 ? ", " : "") + number_to_text(value.numbers[n]);
    const std::size_t rest = value.numbers.size() - std::min(value.numbers.size(), most);
    return text + (rest > 0 ? " and " + std::to_string(rest) + " more" : "");
}

conformance::Value truth_of(const conformance::Vector& v) { return {v.nearest, v.word}; }

} // namespace denhartog::program
