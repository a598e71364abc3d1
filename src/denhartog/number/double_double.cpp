#include "denhartog/number/double_double.hpp"

#include <cmath>

#include "denhartog/elementary/elementary.hpp"
#include "denhartog/elementary/kernels.hpp"

namespace denhartog {
namespace {

DoubleDouble scaled(const DoubleDouble& a, int by) { return DoubleDouble(elementary::scaled_exponential(a.high, a.low, by)); }

// From here on the second part of an angle is no small one.
constexpr double of_many_turns = 0x1p40;

// The sine of the sum of two angles, or of that a quarter turn on.
DoubleDouble sine_of_sum(double x, double y, std::uint64_t steps_on) {
    const elementary::ReducedAngle of_x = elementary::reduce(x, 0), of_y = elementary::reduce(y, 0);
    const elementary::ReducedAngle on{of_x.n + steps_on, of_x.d, of_x.d_low};
    return DoubleDouble(elementary::sine(on)) * DoubleDouble(elementary::cosine(of_y)) +
           DoubleDouble(elementary::cosine(on)) * DoubleDouble(elementary::sine(of_y));
}

// An angle in half turns without whole turns, in neither part.
elementary::Parts without_many_turns(const DoubleDouble& a) {
    return elementary::exact_sum(elementary::without_many_turns(a.high), elementary::without_many_turns(a.low));
}

} // namespace

DoubleDouble exp(const DoubleDouble& a) { return scaled(a, 0); }

DoubleDouble expm1(const DoubleDouble& a) {
    if (!(std::fabs(a.high) < elementary::one_is_nothing)) return a.high > 0 ? exp(a) : exp(a) - 1;
    if (std::fabs(a.high) < 0x1p-60) return a;
    return DoubleDouble(elementary::exponential_less_one(a.high, a.low));
}

DoubleDouble sinh(const DoubleDouble& a) {
    if (a.high < 0) return -sinh(-a);
    if (!(a.high < elementary::one_is_nothing)) return scaled(a, -1);
    if (a.high < 0x1p-60) return a;
    const DoubleDouble less_one(elementary::exponential_less_one(a.high, a.low)), twice = less_one + less_one / (1 + less_one);
    return {twice.high / 2, twice.low / 2};
}

DoubleDouble cosh(const DoubleDouble& a) {
    const DoubleDouble size = abs(a);
    if (!(size.high < elementary::one_is_nothing)) return scaled(size, -1);
    const DoubleDouble power = exp(size), twice = power + 1 / power;
    return {twice.high / 2, twice.low / 2};
}

DoubleDouble sin(const DoubleDouble& a) {
    if (!elementary::is_finite(a.high)) return DoubleDouble(elementary::no_number);
    if (std::fabs(a.high) < 0x1p-40) return a;
    if (std::fabs(a.high) >= of_many_turns) return sine_of_sum(a.high, a.low, 0);
    return DoubleDouble(elementary::sine(elementary::reduce(a.high, a.low)));
}

DoubleDouble cos(const DoubleDouble& a) {
    if (!elementary::is_finite(a.high)) return DoubleDouble(elementary::no_number);
    if (std::fabs(a.high) >= of_many_turns) return sine_of_sum(a.high, a.low, 32);
    return DoubleDouble(elementary::cosine(elementary::reduce(a.high, a.low)));
}

DoubleDouble sine_of_half_turns(const DoubleDouble& a) {
    if (std::fabs(a.high) < 0x1p-60) return PiOf<DoubleDouble>::value() * a;
    if (!elementary::is_finite(a.high)) return DoubleDouble(elementary::no_number);
    const elementary::Parts x = without_many_turns(a);
    return DoubleDouble(elementary::sine(elementary::reduce_half_turns(x.high, x.low)));
}

DoubleDouble cosine_of_half_turns(const DoubleDouble& a) {
    if (!elementary::is_finite(a.high)) return DoubleDouble(elementary::no_number);
    const elementary::Parts x = without_many_turns(a);
    return DoubleDouble(elementary::cosine(elementary::reduce_half_turns(x.high, x.low)));
}

DoubleDouble atan2(const DoubleDouble& y, const DoubleDouble& x) {
    if (y.high == 0 || !elementary::is_finite(x.high) || !elementary::is_finite(y.high))
        return DoubleDouble(elementary::atan2(y.high, x.high));
    return DoubleDouble(elementary::angle_of({y.high, y.low}, {x.high, x.low}));
}

DoubleDouble remainder_of_one(const DoubleDouble& m) {
    const double n = std::nearbyint(1 / m.high);
    return m.low == 0 ? DoubleDouble(std::remainder(1.0, m.high)) : 1 - DoubleDouble(n) * m;
}

} // namespace denhartog
