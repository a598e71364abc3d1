#include "denhartog/answer/certify.hpp"

#include <algorithm>
#include <atomic>

namespace denhartog {
namespace {

std::atomic<long> steps{0};

} // namespace

Aim aim_of(std::optional<int> digits) {
    if (digits && (*digits < 1 || *digits > most_digits))
        throw InputError("digits", "must be from 1 to " + std::to_string(most_digits), std::to_string(*digits));
    const int aimed_at = digits.value_or(digits_by_default);
    return {aimed_at, digits.has_value(), std::pow(10.0, -aimed_at)};
}

std::string in_words(const Aim& aim) {
    return std::to_string(aim.digits) + (aim.digits == 1 ? " digit" : " digits") + (aim.asked_for ? " asked for" : " aimed at");
}

int digits_of(double error) {
    return error > 0 ? std::clamp(static_cast<int>(std::floor(-std::log10(error))), 0, most_digits) : most_digits;
}

std::string name(Precision precision) {
    switch (precision) {
    case Precision::in_double: return "double";
    case Precision::in_50_digits: return "50 digits";
    case Precision::in_100_digits: return "100 digits";
    }
    return {};
}

int most_digits_in(Precision precision) {
    switch (precision) {
    case Precision::in_double: return 14;
    case Precision::in_50_digits: return 45;
    case Precision::in_100_digits: return most_digits;
    }
    return 0;
}

std::string verdict(const Attempted& attempted, const Aim& aim) {
    const bool reached = attempted.relative <= aim.tolerance;
    return (reached ? "the error bound leaves the " : "the error bound does not leave the ") + in_words(aim) +
           (attempted.decided ? "" : ", but beta lies on a boundary");
}

long precision_steps() { return steps; }

void count_precision_step() { ++steps; }

} // namespace denhartog
