#include "denhartog/program/number_json.hpp"

#include <cmath>
#include <cstdio>

#include "denhartog/number/errors.hpp"

namespace denhartog::program {
namespace {

constexpr int most_digits_of_a_double = 15;

template <class T>
Json written(const T& x, const std::optional<int>& digits) {
    if (digits.value_or(0) > most_digits_of_a_double && boost::multiprecision::isfinite(x))
        return x == 0 ? std::string("0") : x.str(*digits - 1, std::ios_base::scientific);
    return NumberWriter{digits}(static_cast<double>(x));
}

} // namespace

Json NumberWriter::operator()(double x) const {
    if (!std::isfinite(x)) throw PrecisionError("the answer holds a number beyond the range of a double");
    return x == 0 ? 0.0 : x;
}

Json NumberWriter::operator()(const Real50& x) const { return written(x, digits); }

Json NumberWriter::operator()(const Real100& x) const { return written(x, digits); }

std::string in_table(const Json& x) {
    if (x.is_string()) return x.get<std::string>();
    if (x.is_null()) return "-";
    if (x.is_number_integer()) return std::to_string(x.get<long>());
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", x.get<double>());
    return text;
}

std::string cell(const Json& object, const char* key) { return object.contains(key) ? in_table(object.at(key)) : "-"; }

} // namespace denhartog::program
