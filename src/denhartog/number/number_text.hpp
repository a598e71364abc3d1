// Numbers as decimal text, in both directions.
#pragma once

#include <string>
#include <string_view>

namespace denhartog {

// A number as text from which the same number can be read again: the shortest such text for `double`; `inf`, `-inf` or
// `nan` if it is no number.
template <class T>
[[nodiscard]] std::string number_to_text(const T& x);
template <>
std::string number_to_text(const double& x);

// A number rounded for people, e.g. `1.2e-05`.
[[nodiscard]] std::string number_in_digits(double x, int digits);

// A number rounded for people to the digits that its error leaves, 12 at most. `0 to within` the
// error if no digit is certain. As many more as tell it from another number that is farther away than its error.
[[nodiscard]] std::string number_in_certain_digits(double x, double error, double other);

template <class T>
struct Bounded;

template <class T>
[[nodiscard]] std::string number_to_text(const Bounded<T>& x) {
    return number_to_text(x.x);
}

// Why a text gives no number.
enum class NumberFault {
    none,      // it gives one
    no_number, // not written as a JSON number: digits, point, exponent, minus sign
    too_large, // beyond the largest number of the type
    too_small, // not zero, but nearer to zero than the smallest number of the type
    too_long   // more than 5000 characters, or an exponent beyond 5000
};

// A fault in words, as the rule that the text breaks.
[[nodiscard]] std::string number_rule(NumberFault fault);

// A number from its decimal text, rounded once and to nearest: `0.1` is one tenth to all the digits of the type. The
// number stays as it was if there is a fault.
template <class T>
[[nodiscard]] NumberFault number_from_text(std::string_view text, T& value);

} // namespace denhartog
