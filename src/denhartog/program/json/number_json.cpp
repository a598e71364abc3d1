#include "denhartog/program/json/number_json.hpp"

#include <cmath>
#include <cstdio>

#include "denhartog/number/errors.hpp"

namespace denhartog::program {
Json NumberWriter::operator()(double x) const {
    if (!std::isfinite(x)) throw PrecisionError("the answer holds a number beyond the range of a double");
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

} // namespace denhartog::program
