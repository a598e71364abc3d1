#include "derivation/algebra/function_ring.hpp"

#include <set>

#include "derivation/algebra/symbols.hpp"
#include "derivation/typeset/latex.hpp"
#include "derivation/typeset/readable.hpp"
#include "derivation/typeset/typeset.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

bool is_the(unsigned serial, const ex& e) {
    return GiNaC::is_a<GiNaC::function>(e) && GiNaC::ex_to<GiNaC::function>(e).get_serial() == serial;
}

/// Polynomials with more terms or symbols than this are not factored: that takes GiNaC minutes.
constexpr std::size_t longest = 40, most_symbols = 7;

void collect_symbols(const ex& e, std::set<ex, GiNaC::ex_is_less>& found) {
    if (GiNaC::is_a<GiNaC::symbol>(e)) found.insert(e);
    for (const ex& part : e) collect_symbols(part, found);
}

/// A factor in the shape that the paper gives it: the denominator of (23), the square of w.
ex shaped(const ex& factor) {
    for (const auto& [expanded, shape] : paper_shapes()) {
        if (factor.is_equal(expanded)) return shape;
        if (factor.is_equal((-expanded).expand())) return -shape;
    }
    return factor;
}

/// The factors of a polynomial, in the paper's shapes.
ex shaped_factors(const ex& polynomial) {
    ex rest = polynomial, quotient, result = 1;
    for (const ModeGroups& mode : groups_of_modes()) // stays one factor
        while (rest.degree(mode.R) >= 2 && GiNaC::divide(rest, 1 - mode.R * mode.R, quotient)) {
            result *= 1 - mode.R * mode.R;
            rest = quotient;
        }
    const ex product = GiNaC::factor(rest);
    const auto take = [&result](const ex& part) {
        const bool plain = GiNaC::is_a<GiNaC::power>(part) && GiNaC::is_a<numeric>(part.op(1));
        result *= plain ? GiNaC::pow(shaped(part.op(0).expand()), part.op(1)) : shaped(part.expand());
    };
    if (GiNaC::is_a<GiNaC::mul>(product))
        for (const ex& part : product) take(part);
    else
        take(product);
    return result;
}

} // namespace

ex FunctionRing::known(const ex& function) const {
    const auto place = atoms_.find(function);
    return place == atoms_.end() ? ex(0) : place->second;
}

ex FunctionRing::atom(const ex& e, const ex& shown) {
    const auto place = atoms_.find(e);
    if (place != atoms_.end()) return place->second;
    const ex symbol = GiNaC::realsymbol("f" + std::to_string(atoms_.size()));
    atoms_.emplace(e, symbol);
    meanings_[symbol] = shown;
    return symbol;
}

ex FunctionRing::exponential(const ex& argument) {
    const ex expanded = argument.expand();
    ex product = 1;
    const auto take = [&](const ex& term) {
        numeric coefficient(1);
        if (GiNaC::is_a<GiNaC::mul>(term))
            for (const ex& factor : term)
                if (GiNaC::is_a<numeric>(factor)) coefficient *= GiNaC::ex_to<numeric>(factor);
        if (!coefficient.is_integer()) coefficient = coefficient.is_negative() ? -1 : 1;
        const ex unit = GiNaC::exp(-term / coefficient);
        product *= GiNaC::pow(atom(unit, unit), -coefficient);
    };
    if (GiNaC::is_a<GiNaC::add>(expanded))
        for (const ex& term : expanded) take(term);
    else
        take(expanded);
    return product;
}

ex FunctionRing::root(const ex& radicand) {
    const ex key = GiNaC::sqrt(radicand);
    for (const Group& g : groups())
        if (g.meaning.is_equal(key)) { // a group of its own: printed as it is
            if (known(key).is_zero()) {
                atoms_.emplace(key, g.symbol);
                relations_.emplace_back(g.symbol, radicand);
            }
            return g.symbol;
        }
    if (!known(key).is_zero()) return known(key);
    const ex inside = rewrite(radicand);
    const ex symbol = atom(key, key);
    if (inside.denom().is_equal(1)) relations_.emplace_back(symbol, inside);
    return symbol;
}

ex FunctionRing::rewrite(const ex& e) {
    if (is_the(GiNaC::exp_SERIAL::serial, e)) return exponential(e.op(0));
    if (is_the(GiNaC::sin_SERIAL::serial, e) || is_the(GiNaC::cos_SERIAL::serial, e)) {
        const bool fresh = known(e).is_zero();
        const ex symbol = atom(e, e);
        if (fresh && is_the(GiNaC::sin_SERIAL::serial, e)) {
            const ex cosine = rewrite(GiNaC::cos(e.op(0)));
            relations_.emplace_back(symbol, 1 - cosine * cosine);
        }
        return symbol;
    }
    if (GiNaC::is_a<GiNaC::function>(e)) return atom(e, e);
    if (GiNaC::is_a<GiNaC::power>(e)) {
        if (!GiNaC::is_a<numeric>(e.op(1))) return atom(e, e);
        const numeric exponent = GiNaC::ex_to<numeric>(e.op(1));
        if (exponent.is_integer()) return GiNaC::pow(rewrite(e.op(0)), exponent);
        return exponent.mul(2).is_integer() ? ex(GiNaC::pow(root(e.op(0)), exponent.mul(2))) : atom(e, e);
    }
    if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
        ex result = GiNaC::is_a<GiNaC::add>(e) ? 0 : 1;
        for (const ex& part : e) result = GiNaC::is_a<GiNaC::add>(e) ? result + rewrite(part) : result * rewrite(part);
        return result;
    }
    return e;
}

std::pair<ex, ex> FunctionRing::fraction(const ex& rational) const {
    ex quotient = rational.normal();
    quotient = (reduced(quotient.numer(), relations_) / reduced(quotient.denom(), relations_)).normal();
    return {reduced(quotient.numer(), relations_), reduced(quotient.denom(), relations_)};
}

ex FunctionRing::factored(const ex& polynomial) const {
    if (!GiNaC::is_a<GiNaC::add>(polynomial)) return polynomial;
    std::set<ex, GiNaC::ex_is_less> symbols_of_polynomial;
    collect_symbols(polynomial, symbols_of_polynomial);
    if (polynomial.nops() > longest || symbols_of_polynomial.size() > most_symbols)
        return GiNaC::collect_common_factors(polynomial);
    ex best = shaped_factors(polynomial);
    for (const ModeGroups& mode : groups_of_modes()) { // the square of zeta through the square of w, which may then come out
        if (known(mode.w.meaning).is_zero() || polynomial.degree(mode.zeta) < 2) continue;
        ex by_w = 0;
        for (int k = 0; k <= polynomial.degree(mode.zeta); ++k)
            by_w += polynomial.coeff(mode.zeta, k) * GiNaC::pow(1 - mode.w.symbol * mode.w.symbol, k / 2) *
                    GiNaC::pow(mode.zeta, k % 2);
        const ex other = shaped_factors(by_w.expand());
        if (visible_width(latex_line(other)) < visible_width(latex_line(best))) best = other;
    }
    return best;
}

ex FunctionRing::simplified(const ex& rational) const {
    const auto [over, under] = fraction(rational);
    return factored(over) / factored(under);
}

ex FunctionRing::hyperbolic(const ex& rational) const {
    const auto [over, under] = fraction(rational);
    for (const auto& [function, e] : atoms_) {
        if (!is_the(GiNaC::exp_SERIAL::serial, function) || over.degree(e) > 2 || under.degree(e) != 2) continue;
        const GiNaC::realsymbol cosh("cosh"), sinh("sinh");
        const auto halves = [&, e = e](const ex& p) { // over e: e + 1/e = 2 cosh, 1/e - e = 2 sinh
            return (p.coeff(e, 1) + (p.coeff(e, 0) + p.coeff(e, 2)) * cosh + (p.coeff(e, 0) - p.coeff(e, 2)) * sinh).expand();
        };
        const ex argument = -function.op(0);
        const ex quotient = (halves(over) / halves(under)).normal();
        return named((factored(quotient.numer()) / factored(quotient.denom())))
            .subs(GiNaC::lst{ex(cosh) == GiNaC::cosh(argument), ex(sinh) == GiNaC::sinh(argument)});
    }
    return 0;
}

} // namespace denhartog::derivation
