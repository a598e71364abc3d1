#if DENHARTOG_REFERENCE
#include "denhartog/answer/printed.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/reference/modes.hpp"

namespace denhartog {
namespace {

// d.ddde+00, rounded to nearest.
std::string decimal_of(const Ball& x, int digits) {
    if (arf_is_zero(arb_midref(x.a)) != 0) return "0";
    mpfr_t exact;
    mpfr_init2(exact, std::max<slong>(arf_bits(arb_midref(x.a)), 2));
    arf_get_mpfr(exact, arb_midref(x.a), MPFR_RNDN);
    mpfr_exp_t exponent = 0;
    char* text = mpfr_get_str(nullptr, &exponent, 10, static_cast<std::size_t>(digits), exact, MPFR_RNDN);
    std::string all = text;
    mpfr_free_str(text);
    mpfr_clear(exact);
    const std::size_t first = all.front() == '-' ? 1 : 0;
    if (digits > 1) all.insert(first + 1, ".");
    const long power = exponent - 1;
    std::string exponent_in_words = std::to_string(std::abs(power));
    if (exponent_in_words.size() < 2) exponent_in_words.insert(0, "0");
    return all + (power < 0 ? "e-" : "e+") + exponent_in_words;
}

} // namespace

Certified printed(const Ball& x, int digits) {
    Certified number;
    number.proved = true;
    if (!x.finite()) {
        number.error = std::numeric_limits<double>::infinity();
        return number;
    }
    number.value = static_cast<double>(x);
    Ball written(0);
    if (digits > most_digits_of_a_double) {
        number.decimal = decimal_of(x, digits);
        const Bits enough(std::max<slong>(ball_bits, arf_bits(arb_midref(x.a)) + 64));
        written = Ball::of_text(number.decimal);
    } else {
        written = Ball(number.value);
    }
    number.error = abs(written - x).high();
    return number;
}

Certified WrittenNumbers::shown(const Ball& x) const {
    if (!x.finite()) throw reference::Unproved(Why::no_bound);
    const Certified number = printed(x, digits_);
    if (!std::isfinite(number.value) && digits_ <= most_digits_of_a_double) throw PrecisionError({Why::out_of_double, 0});
    return number;
}

Certified WrittenNumbers::relative(const Ball& x) {
    count(x.is_zero() ? Ball(0) : radius_of(x) / abs(x));
    Certified number = shown(x);
    // Doubles are few next to zero; what is below them all is told by its bound.
    if (number.decimal.empty() && number.value != 0) count(Ball(number.error) / abs(x) / 2);
    return number;
}

SolvedMass WrittenNumbers::mass(const Ball& amplitude, const std::optional<Ball>& phase, bool asked, const Ball& largest) {
    Ball nothing = largest;
    arb_mul_2exp_si(nothing.a, nothing.a, -static_cast<slong>(bits_of_digit * digits_) - 32);
    if (amplitude.is_zero() || (last_ && amplitude.may_vanish() && amplitude <= nothing))
        return {shown(widened(Ball(0), upper_bound_of(amplitude))), std::nullopt, std::nullopt};
    SolvedMass out{relative(amplitude), std::nullopt, std::nullopt};
    if (phase) out.phase = asked ? absolute(*phase) : shown(*phase);
    return out;
}

void WrittenNumbers::count(const Ball& error) {
    const Ball tolerance = 1 / Ball::of_text("4e" + std::to_string(digits_));
    enough_ = enough_ && error.finite() && error < tolerance;
    largest_ = std::max(largest_, error.finite() ? error.high() : std::numeric_limits<double>::infinity());
}

} // namespace denhartog
#endif
