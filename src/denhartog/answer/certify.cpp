#include "denhartog/answer/certify.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>

namespace denhartog {
namespace {

std::atomic<long> steps{0};

} // namespace

double tolerance_of(int digits) {
    constexpr int most = 323; // of a double; beyond, its smallest number stands for all
    static const std::array<double, most + 1> powers = [] {
        std::array<double, most + 1> all{};
        for (int n = 0; n <= most; ++n) {
            const std::string text = "1e-" + std::to_string(n);
            std::from_chars(text.data(), text.data() + text.size(), all[static_cast<std::size_t>(n)]);
        }
        return all;
    }();
    return powers[static_cast<std::size_t>(std::min(digits, most))];
}

Aim aim_of(std::optional<int> digits) {
    if (digits && (*digits < 1 || *digits > most_digits))
        throw InputError("digits", "must be from 1 to " + std::to_string(most_digits), std::to_string(*digits));
    const int aimed_at = digits.value_or(digits_by_default);
    return {aimed_at, digits.has_value(), tolerance_of(aimed_at)};
}

int digits_of(double error) {
    constexpr int most = 17;
    int digits = 0;
    while (digits < most && error <= tolerance_of(digits + 1)) ++digits;
    return digits;
}

Reasons verdict(const Attempted& attempted, const Aim& aim) {
    Reasons why{Why::bound, attempted.relative <= aim.tolerance, aim.digits, aim.digits == 1, aim.asked_for};
    if (!attempted.decided) why += Reasons(Why::but) + attempted.doubt;
    return why;
}

long precision_steps() { return steps; }

void count_precision_step() { ++steps; }

} // namespace denhartog
