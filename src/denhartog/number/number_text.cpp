// Which double is a decimal, and which decimal shows a double? Read `number_from_text` for the first question and
// `number_to_text` for the second; `number_in_certain_digits` cuts a number where its error begins.
#include "denhartog/number/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "denhartog/number/ball_or_none.hpp"

namespace denhartog {
namespace {

constexpr std::size_t longest_text = 5000;
constexpr int largest_exponent = 5000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The parts of a text that is written as a JSON number.
struct NumberParts {
    bool valid = false;        ///< written as JSON writes a number
    bool zero = true;          ///< no digit but 0 before the exponent
    long order = 0;            ///< power of ten of the first digit that is not 0, the exponent left out
    std::string_view exponent; ///< what follows the e, without a plus sign
};

NumberParts take_apart(std::string_view text) {
    NumberParts parts;
    std::size_t at = 0;
    std::size_t first = text.npos; // digit that is not 0
    const auto digits = [&] {
        const std::size_t from = at;
        for (; at < text.size() && is_digit(text[at]); ++at)
            if (text[at] != '0') first = std::min(first, at);
        return at - from;
    };
    if (at < text.size() && text[at] == '-') ++at;
    const std::size_t whole_from = at;
    const std::size_t whole = digits();
    if (whole == 0 || (whole > 1 && text[whole_from] == '0')) return parts;
    if (at < text.size() && text[at] == '.') {
        ++at;
        if (digits() == 0) return parts;
    }
    parts.zero = first == text.npos;
    const std::size_t units = whole_from + whole - 1;
    if (!parts.zero) parts.order = first <= units ? static_cast<long>(units - first) : 1 - static_cast<long>(first - units);
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        ++at;
        if (at < text.size() && text[at] == '+') ++at;
        const std::size_t from = at;
        if (at < text.size() && text[at] == '-' && text[at - 1] != '+') ++at;
        const std::size_t digits_from = at;
        while (at < text.size() && is_digit(text[at])) ++at;
        if (at == digits_from) return parts;
        parts.exponent = text.substr(from, at - from);
    }
    parts.valid = at == text.size();
    return parts;
}

NumberFault finite_from_text(std::string_view text, long order, bool zero, double& value) {
    double x = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), x);
    if (result.ec == std::errc::result_out_of_range) return order < 0 ? NumberFault::too_small : NumberFault::too_large;
    if (x == 0 && !zero) return NumberFault::too_small;
    value = x;
    return NumberFault::none;
}

} // namespace

template <>
std::string number_to_text(const double& x) {
    if (std::isnan(x)) return "nan";
    if (!std::isfinite(x)) return x > 0 ? "inf" : "-inf";
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

std::string number_rule(NumberFault fault) {
    switch (fault) {
    case NumberFault::none: return "is a number";
    case NumberFault::no_number: return "must be written as a number";
    case NumberFault::too_large: return "must not be beyond the largest number of this precision";
    case NumberFault::too_small: return "must be zero or not below the smallest number of this precision";
    case NumberFault::too_long: return "must have at most 5000 characters and an exponent of at most 5000";
    }
    return {};
}

template <class T>
NumberFault number_from_text(std::string_view text, T& value) {
    if (text.size() > longest_text) return NumberFault::too_long;
    const NumberParts parts = take_apart(text);
    if (!parts.valid) return NumberFault::no_number;
    int exponent = 0;
    const auto read = std::from_chars(parts.exponent.data(), parts.exponent.data() + parts.exponent.size(), exponent);
    if (read.ec == std::errc::result_out_of_range || std::abs(exponent) > largest_exponent) return NumberFault::too_long;
#if DENHARTOG_REFERENCE
    if constexpr (is_ball<T>) {
        value = Ball::of_text(std::string(text));
        return NumberFault::none;
    } else
#endif
        return finite_from_text(text, parts.order + exponent, parts.zero, value);
}

std::string number_in_digits(double x, int digits) {
    std::array<char, 64> text{};
    return {text.data(), std::to_chars(text.begin(), text.end(), x, std::chars_format::general, digits).ptr};
}

std::string number_in_certain_digits(double x, double error, double other) {
    constexpr int most = 12;
    const double size = std::abs(x);
    if (x != 0 && size <= error) return "0 to within " + number_in_digits(size + error, 2);
    int digits = most;
    for (double smaller = error * 1e12; digits > 1 && smaller > size; smaller /= 10) --digits;
    const auto reads_as_other = [&] { return number_in_digits(x, digits) == number_in_digits(other, digits); };
    while (std::abs(x - other) > error && digits < std::numeric_limits<double>::max_digits10 && reads_as_other()) ++digits;
    return number_in_digits(x, digits);
}

template NumberFault number_from_text(std::string_view, double&);
#if DENHARTOG_REFERENCE
template NumberFault number_from_text(std::string_view, Ball&);
#endif

} // namespace denhartog
