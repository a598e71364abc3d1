#include "derivation/algebra/signs.hpp"

#include <algorithm>

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

constexpr std::size_t longest_factored = 80; // terms of a polynomial that is factored

bool is_not_negative(const Bounds& b) { return b.lower && !b.lower->is_negative(); }
bool is_not_positive(const Bounds& b) { return b.upper && !b.upper->is_positive(); }

Bounds opposite(const Bounds& b) {
    Bounds result;
    if (b.upper) result.lower = -*b.upper;
    if (b.lower) result.upper = -*b.lower;
    return result;
}

Bounds sum(const Bounds& a, const Bounds& b) {
    Bounds result;
    if (a.lower && b.lower) result.lower = *a.lower + *b.lower;
    if (a.upper && b.upper) result.upper = *a.upper + *b.upper;
    return result;
}

Bounds product(const Bounds& a, const Bounds& b) {
    if (is_not_positive(a) && !is_not_negative(a)) return opposite(product(opposite(a), b));
    if (is_not_positive(b) && !is_not_negative(b)) return opposite(product(a, opposite(b)));
    if (is_not_negative(a) && is_not_negative(b)) {
        Bounds result{*a.lower * *b.lower, {}};
        if (a.upper && b.upper) result.upper = *a.upper * *b.upper;
        return result;
    }
    if (!a.lower || !a.upper || !b.lower || !b.upper) return {};
    const numeric ends[] = {*a.lower * *b.lower, *a.lower * *b.upper, *a.upper * *b.lower, *a.upper * *b.upper};
    const auto less = [](const numeric& x, const numeric& y) { return x < y; };
    return {*std::min_element(std::begin(ends), std::end(ends), less), *std::max_element(std::begin(ends), std::end(ends), less)};
}

Bounds power(const Bounds& base, int exponent) {
    if (exponent % 2 != 0) {
        Bounds result = base;
        for (int k = 1; k < exponent; ++k) result = product(result, base);
        return result;
    }
    Bounds size = is_not_positive(base) ? opposite(base) : base;
    if (!is_not_negative(size)) {
        if (size.lower && size.upper)
            size.upper = std::max(numeric(-*size.lower), *size.upper, [](const numeric& x, const numeric& y) { return x < y; });
        else
            size.upper.reset();
        size.lower = 0;
    }
    Bounds result = size;
    for (int k = 1; k < exponent; ++k) result = product(result, size);
    return result;
}

bool is_whole_power(const ex& e) {
    return GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::posint) && e.op(1) <= 16;
}

std::string why_not_negative(const ex& polynomial, const KnownBounds& known, int depth);

/// As a product: the signs of its factors, squares aside.
std::string why_by_factors(const ex& polynomial, const KnownBounds& known, int depth) {
    const GiNaC::possymbol circle("pi");
    const ex factored = GiNaC::factor(polynomial.subs(GiNaC::Pi == circle)).subs(circle == GiNaC::Pi);
    if (!GiNaC::is_a<GiNaC::mul>(factored) && !is_whole_power(factored)) return "";
    bool negative = false;
    const auto certain = [&](const ex& factor) {
        if (is_whole_power(factor) && factor.op(1).info(GiNaC::info_flags::even)) return true;
        const ex base = is_whole_power(factor) ? factor.op(0) : factor;
        if (!why_not_negative(base, known, depth - 1).empty()) return true;
        if (why_not_negative((-base).expand(), known, depth - 1).empty()) return false;
        negative = !negative;
        return true;
    };
    if (GiNaC::is_a<GiNaC::mul>(factored)) {
        for (const ex& factor : factored)
            if (!certain(factor)) return "";
    } else if (!certain(factored)) {
        return "";
    }
    return negative ? "" : "a product of factors that are not negative";
}

/// As a quadratic in a symbol or in its square: A, C and 4 A C - B^2 are not negative.
std::string why_by_discriminant(const ex& polynomial, const KnownBounds& known, int depth) {
    for (const auto& [symbol, bounds] : known) {
        const int degree = polynomial.degree(symbol), step = degree / 2;
        if (degree != 2 && degree != 4) continue;
        if (step == 2 && (!polynomial.coeff(symbol, 1).is_zero() || !polynomial.coeff(symbol, 3).is_zero())) continue;
        const ex A = polynomial.coeff(symbol, 2 * step), B = polynomial.coeff(symbol, step), C = polynomial.coeff(symbol, 0);
        const auto certain = [&](const ex& e) { return !why_not_negative(e.expand(), known, depth - 1).empty(); };
        if (certain(A) && certain(C) && certain(4 * A * C - B * B)) return "a quadratic without two real zeros";
    }
    return "";
}

std::string why_not_negative(const ex& polynomial, const KnownBounds& known, int depth) {
    if (is_not_negative(bounds_of(polynomial, known))) return "the bounds of its terms";
    if (depth == 0 || polynomial.nops() > longest_factored) return "";
    const std::string by_factors = why_by_factors(polynomial, known, depth);
    return by_factors.empty() ? why_by_discriminant(polynomial, known, depth) : by_factors;
}

} // namespace

Bounds bounds_of(const ex& polynomial, const KnownBounds& known) {
    if (GiNaC::is_a<numeric>(polynomial)) {
        const numeric& n = GiNaC::ex_to<numeric>(polynomial);
        return n.is_real() ? Bounds{n, n} : Bounds{};
    }
    if (polynomial.is_equal(GiNaC::Pi)) return {numeric(3), numeric(4)};
    if (const auto place = known.find(polynomial); place != known.end()) return place->second;
    if (is_whole_power(polynomial))
        return power(bounds_of(polynomial.op(0), known), GiNaC::ex_to<numeric>(polynomial.op(1)).to_int());
    const bool is_sum = GiNaC::is_a<GiNaC::add>(polynomial);
    if (!is_sum && !GiNaC::is_a<GiNaC::mul>(polynomial)) return {};
    Bounds result{numeric(is_sum ? 0 : 1), numeric(is_sum ? 0 : 1)};
    for (const ex& part : polynomial)
        result = is_sum ? sum(result, bounds_of(part, known)) : product(result, bounds_of(part, known));
    return result;
}

std::string why_not_negative(const ex& polynomial, const KnownBounds& known) {
    return why_not_negative(polynomial.expand(), known, 4);
}

} // namespace denhartog::derivation
