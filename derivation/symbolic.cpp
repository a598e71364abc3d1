#include "symbolic.hpp"

#include <stdexcept>

namespace denhartog::derivation {

namespace {
Mutation* in_force = nullptr;
}

Mutation::Mutation(long position) : position_(position) {
    if (in_force != nullptr) throw std::logic_error("two mutations at once");
    in_force = this;
}

Mutation::~Mutation() { in_force = nullptr; }

long Mutation::operations() const { return count_; }

const std::string& Mutation::replaced() const { return replaced_; }

bool Mutation::here(const char* what) {
    if (in_force == nullptr) return false;
    const bool replace = in_force->count_ == in_force->position_;
    if (replace) in_force->replaced_ = what;
    ++in_force->count_;
    return replace;
}

Symbolic::Symbolic(int n) : value_(Mutation::here("n -> n + 1") ? n + 1 : n) {}

Symbolic operator+(const Symbolic& a, const Symbolic& b) {
    return Symbolic(Mutation::here("+ -> -") ? a.value_ - b.value_ : a.value_ + b.value_);
}
Symbolic operator-(const Symbolic& a, const Symbolic& b) {
    return Symbolic(Mutation::here("- -> +") ? a.value_ + b.value_ : a.value_ - b.value_);
}
Symbolic operator*(const Symbolic& a, const Symbolic& b) {
    return Symbolic(Mutation::here("* -> /") ? a.value_ / b.value_ : a.value_ * b.value_);
}
Symbolic operator/(const Symbolic& a, const Symbolic& b) {
    return Symbolic(Mutation::here("/ -> *") ? a.value_ * b.value_ : a.value_ / b.value_);
}
Symbolic operator-(const Symbolic& a) { return Symbolic(Mutation::here("-x -> x") ? a.value_ : -a.value_); }

Symbolic sqrt(const Symbolic& x) {
    return Symbolic(Mutation::here("sqrt(x) -> x") ? x.expression() : GiNaC::sqrt(x.expression()));
}
Symbolic exp(const Symbolic& x) {
    return Symbolic(Mutation::here("exp(x) -> exp(-x)") ? GiNaC::exp(-x.expression()) : GiNaC::exp(x.expression()));
}
Symbolic sin(const Symbolic& x) {
    return Symbolic(Mutation::here("sin -> cos") ? GiNaC::cos(x.expression()) : GiNaC::sin(x.expression()));
}
Symbolic cos(const Symbolic& x) {
    return Symbolic(Mutation::here("cos -> sin") ? GiNaC::sin(x.expression()) : GiNaC::cos(x.expression()));
}
Symbolic sinh(const Symbolic& x) {
    return Symbolic(Mutation::here("sinh -> cosh") ? GiNaC::cosh(x.expression()) : GiNaC::sinh(x.expression()));
}
Symbolic cosh(const Symbolic& x) {
    return Symbolic(Mutation::here("cosh -> sinh") ? GiNaC::sinh(x.expression()) : GiNaC::cosh(x.expression()));
}
Symbolic atan2(const Symbolic& y, const Symbolic& x) {
    return Symbolic(Mutation::here("atan2(y, x) -> atan2(x, y)") ? GiNaC::atan2(x.expression(), y.expression())
                                                                 : GiNaC::atan2(y.expression(), x.expression()));
}
Symbolic sin_pi(const Symbolic& x) { return sin(Symbolic(GiNaC::Pi * x.expression())); }
Symbolic cos_pi(const Symbolic& x) { return cos(Symbolic(GiNaC::Pi * x.expression())); }
Symbolic exp_minus_one(const Symbolic& x) { return exp(x) - 1; }
Symbolic one_minus_w(const Symbolic& zeta) { return 1 - sqrt(1 - zeta * zeta); }
Symbolic sinhc_minus_one(const Symbolic& x) { return sinh(x) / x - 1; }
Symbolic one_minus_exp_over(const Symbolic& x) { return (1 - exp(-x)) / x; }
Complex<Symbolic> exp_minus_one_over(const Complex<Symbolic>& z) {
    const Symbolic E = exp(z.re), re = E * cos(z.im) - 1, im = E * sin(z.im), size = squared_modulus(z);
    return {(re * z.re + im * z.im) / size, (im * z.re - re * z.im) / size};
}
Symbolic sinc(const Symbolic& x) { return sin(x) / x; }
Symbolic sinhc_less_sinc_over_square(const Symbolic& q, const Symbolic& zeta) {
    const Symbolic delta = q * zeta, theta = q * sqrt(1 - zeta * zeta);
    return (sinh(delta) / delta - sin(theta) / theta) / (q * q);
}
Symbolic product_error(const Symbolic& x, const Symbolic& y, const Symbolic& xy) { return x * y - xy; }
Symbolic sum_error(const Symbolic& x, const Symbolic& y, const Symbolic& sum) { return x + y - sum; }
Symbolic contact_root(const Complex<Symbolic>& V_dj, const Symbolic& U_dj, const Symbolic& beta) {
    return sqrt(squared_modulus(V_dj) - beta * U_dj * (beta * U_dj));
}
Symbolic overdamped_w(const Symbolic& zeta) { return sqrt(zeta * zeta - 1); }
Symbolic slow_rate(const Symbolic& zeta) { return zeta - overdamped_w(zeta); }
Symbolic overdamped_sinc(const Symbolic& zeta, const Symbolic& x) {
    const Symbolic angle = overdamped_w(zeta) * x;
    return angle.expression().is_zero() ? Symbolic(1) : sinh(angle) / angle; // entire: at zeta = 1 its series is 1
}
Symbolic overdamped_cosine(const Symbolic& zeta, const Symbolic& x) { return cosh(overdamped_w(zeta) * x); }
Symbolic overdamped_difference(const Symbolic& zeta, const Symbolic& x) {
    const Symbolic w = overdamped_w(zeta);
    return (1 - exp(-(2 * w * x))) / (2 * w);
}
Symbolic sinhc_less_sinhc_over_square(const Symbolic& q, const Symbolic& zeta) {
    const Symbolic delta = q * zeta;
    return (sinh(delta) / delta - overdamped_sinc(zeta, q)) / (q * q);
}
Symbolic product_over(const Symbolic& p, const Symbolic& K, const Symbolic& R) { return p * K / R; }
SineCosine<Symbolic> sine_cosine_of_half_period(const Symbolic& R, const Symbolic& y) {
    const Symbolic angle = pi<Symbolic>() * (1 / (2 * R) - y);
    return {sin(angle), cos(angle)};
}

} // namespace denhartog::derivation
