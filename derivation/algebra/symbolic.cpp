#include "derivation/algebra/symbolic.hpp"

#include <stdexcept>

namespace denhartog::derivation::scalar {

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
    if (Mutation::here("+ -> -")) return Symbolic(a.value_ - b.value_);
    return Symbolic(Mutation::here("a + b -> a") ? a.value_ : a.value_ + b.value_);
}
Symbolic operator-(const Symbolic& a, const Symbolic& b) {
    if (Mutation::here("- -> +")) return Symbolic(a.value_ + b.value_);
    return Symbolic(Mutation::here("a - b -> a") ? a.value_ : a.value_ - b.value_);
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
Symbolic expm1(const Symbolic& x) { return exp(x) - 1; }
Symbolic fma(const Symbolic& x, const Symbolic& y, const Symbolic& z) { return x * y + z; }

} // namespace denhartog::derivation::scalar
