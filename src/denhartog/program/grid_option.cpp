#include "denhartog/program/grid_option.hpp"

#include <cmath>
#include <cstdint>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"

namespace denhartog::program {
namespace {

constexpr double most_values = 10'000'000;

} // namespace

std::vector<double> grid_values(const std::string& quantity, const std::string& text) {
    const std::size_t first = text.find(':');
    const std::size_t second = first == std::string::npos ? first : text.find(':', first + 1);
    const auto is_number = [](const std::string& part, double& x) { return number_from_text(part, x) == NumberFault::none; };
    double from = 0, to = 0, count = 0;
    if (second == std::string::npos || !is_number(text.substr(0, first), from) ||
        !is_number(text.substr(first + 1, second - first - 1), to) || !is_number(text.substr(second + 1), count))
        throw InputError(quantity, "must be FROM:TO:COUNT, three numbers", text);
    if (!(count >= 1 && count <= most_values) || count != std::floor(count))
        throw InputError(quantity, "must have a whole COUNT from 1 to 10000000", text);
    if (to < from) throw InputError(quantity, "must have TO not below FROM", text);
    if (count == 1 && to != from) throw InputError(quantity, "must have TO equal to FROM where COUNT is 1", text);
    const auto last = static_cast<std::int64_t>(count) - 1;
    std::vector<double> values;
    for (std::int64_t n = 0; n <= last; ++n) {
        const double part = last == 0 ? 0 : static_cast<double>(n) / static_cast<double>(last);
        values.push_back(n == last ? to : from + (to - from) * part);
    }
    return values;
}

} // namespace denhartog::program
