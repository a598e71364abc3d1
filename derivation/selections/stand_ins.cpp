#include "derivation/selections/stand_ins.hpp"

#include <sstream>

namespace denhartog::derivation {

namespace scalar {

namespace {

/// f(x) / x, and 1 where x is zero: what the quotient is by its series.
Symbolic over_itself(const Symbolic& f, const Symbolic& x) { return x.expression().is_zero() ? Symbolic(1) : f / x; }

} // namespace

Symbolic sin_pi(const Symbolic& x) { return sin(pi<Symbolic>() * x); }
Symbolic cos_pi(const Symbolic& x) { return cos(pi<Symbolic>() * x); }
SineCosine<Symbolic> sine_cosine_of_half_period(const Symbolic& R, const Symbolic& y) {
    const Symbolic angle = pi<Symbolic>() * (1 / (2 * R) - y);
    return {sin(angle), cos(angle)};
}
Symbolic sinc(const Symbolic& x) { return over_itself(sin(x), x); }
Symbolic sinhc_minus_one(const Symbolic& x) { return over_itself(sinh(x), x) - 1; }
Symbolic one_minus_exp_over(const Symbolic& x) { return over_itself(1 - exp(-x), x); }
Complex<Symbolic> exp_minus_one_over(const Complex<Symbolic>& z) {
    const Symbolic E = exp(z.re), re = E * cos(z.im) - 1, im = E * sin(z.im), size = squared_modulus(z);
    return {(re * z.re + im * z.im) / size, (im * z.re - re * z.im) / size};
}
Symbolic odd_series_without_leading_term(const Symbolic& s) {
    const Symbolic x = sqrt(s);
    return over_itself(sinh(x), x) - 1;
}
Symbolic sinhc_less_sinc_over_square(const Symbolic& q, const Symbolic& zeta) {
    const Symbolic delta = q * zeta, theta = q * sqrt(1 - zeta * zeta);
    return (over_itself(sinh(delta), delta) - sin(theta) / theta) / (q * q);
}
Symbolic sinhc_less_sinhc_over_square(const Symbolic& q, const Symbolic& zeta) {
    const Symbolic delta = q * zeta, angle = q * sqrt(zeta * zeta - 1);
    return (sinh(delta) / delta - over_itself(sinh(angle), angle)) / (q * q);
}
Symbolic product_over(const Symbolic& p, const Symbolic& K, const Symbolic& R) { return p * K / R; }
Symbolic sum_error(const Symbolic& x, const Symbolic& y, const Symbolic& sum) { return x + y - sum; }

} // namespace scalar

namespace {

std::string latex_of(const Symbolic& value) {
    std::ostringstream out;
    out << GiNaC::latex << value.expression();
    return out.str();
}

} // namespace

std::vector<StandIn> stand_ins() {
    const auto name = [](const char* latex) { return Symbolic(GiNaC::possymbol(latex, latex)); };
    const Symbolic x = name("x"), y = name("y"), R = name("R"), s = name("s"), q = name("q"), zeta = name("\\zeta"),
                   p = name("p"), K = name("K");
    const std::string special = "evaluation/special.hpp", entire = "evaluation/detail/entire_functions.hpp";
    const auto pair = [](const Symbolic& a, const Symbolic& b) { return latex_of(a) + ",\\ " + latex_of(b); };
    const SineCosine<Symbolic> half = scalar::sine_cosine_of_half_period(R, y);
    const Complex<Symbolic> quotient = scalar::exp_minus_one_over({x, y});
    return {
        {"sin_pi", special, "x \\mapsto " + latex_of(scalar::sin_pi(x))},
        {"cos_pi", special, "x \\mapsto " + latex_of(scalar::cos_pi(x))},
        {"sine_cosine_of_half_period", "number/reduced_angle.hpp", "(R, y) \\mapsto " + pair(half.s, half.c)},
        {"sinc", special, "x \\mapsto " + latex_of(scalar::sinc(x))},
        {"sinhc_minus_one", special, "x \\mapsto " + latex_of(scalar::sinhc_minus_one(x))},
        {"one_minus_exp_over", special, "x \\mapsto " + latex_of(scalar::one_minus_exp_over(x))},
        {"exp_minus_one_over", "evaluation/driven_motion.hpp", "x+iy \\mapsto " + pair(quotient.re, quotient.im)},
        {"odd_series_without_leading_term", special, "s \\mapsto " + latex_of(scalar::odd_series_without_leading_term(s))},
        {"sinhc_less_sinc_over_square", special,
         "(q, \\zeta) \\mapsto " + latex_of(scalar::sinhc_less_sinc_over_square(q, zeta))},
        {"sinhc_less_sinhc_over_square", entire,
         "(q, \\zeta) \\mapsto " + latex_of(scalar::sinhc_less_sinhc_over_square(q, zeta))},
        {"product_over", entire, "(p, K, R) \\mapsto " + latex_of(scalar::product_over(p, K, R))},
        {"sum_error", "evaluation/contact.hpp", "(x, y, s) \\mapsto " + latex_of(scalar::sum_error(x, y, s))},
    };
}

} // namespace denhartog::derivation
