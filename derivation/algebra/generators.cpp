#include "derivation/algebra/generators.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "derivation/kernel/coq_text.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::symbol;

ex reduced(const ex& polynomial, const std::vector<SquareRelation>& relations) {
    ex p = polynomial.expand();
    for (auto relation = relations.rbegin(); relation != relations.rend(); ++relation) {
        const auto& [y, square] = *relation;
        while (p.degree(y) >= 2) {
            ex next = 0;
            for (int k = p.ldegree(y); k <= p.degree(y); ++k)
                next += p.coeff(y, k) * GiNaC::pow(square, k / 2) * GiNaC::pow(y, k % 2);
            p = next.expand();
        }
    }
    return p;
}

ex rationalised(const ex& rational, const std::vector<SquareRelation>& relations) {
    const auto stands_in = [](const ex& e) { return [&e](const SquareRelation& relation) { return e.has(relation.first); }; };
    if (std::none_of(relations.begin(), relations.end(), stands_in(rational))) return rational;
    const ex fraction = rational.normal();
    ex n = fraction.numer(), d = reduced(fraction.denom(), relations);
    if (std::none_of(relations.begin(), relations.end(), stands_in(d))) return rational;
    for (auto relation = relations.rbegin(); relation != relations.rend(); ++relation) {
        const ex& y = relation->first;
        if (!d.has(y)) continue;
        const ex conjugate = d.coeff(y, 0) - d.coeff(y, 1) * y;
        n = reduced(n * conjugate, relations);
        d = reduced(d * conjugate, relations);
        if (d.is_zero()) throw std::domain_error("a denominator that has no conjugate");
    }
    return (n / d).normal();
}

namespace {

using Terms = std::vector<std::pair<ex, numeric>>; // monomial, rational coefficient

/// An angle or exponent as a sum of rational multiples of monomials.
Terms linear_terms(const ex& argument) {
    Terms terms;
    const ex expanded = argument.expand();
    const auto add = [&terms](const ex& term) {
        numeric coefficient(1);
        ex monomial(1);
        if (GiNaC::is_a<numeric>(term)) {
            coefficient = GiNaC::ex_to<numeric>(term);
        } else if (GiNaC::is_a<GiNaC::mul>(term)) {
            for (const ex& factor : term)
                if (GiNaC::is_a<numeric>(factor))
                    coefficient = coefficient.mul(GiNaC::ex_to<numeric>(factor));
                else
                    monomial = monomial * factor;
        } else {
            monomial = term;
        }
        if (!coefficient.is_rational()) throw std::domain_error("an angle with a coefficient that is not rational");
        terms.emplace_back(monomial, coefficient);
    };
    if (GiNaC::is_a<GiNaC::add>(expanded))
        for (const ex& term : expanded) add(term);
    else if (!expanded.is_zero())
        add(expanded);
    return terms;
}

bool is_circular(const ex& e) {
    return GiNaC::is_the_function<GiNaC::sin_SERIAL>(e) || GiNaC::is_the_function<GiNaC::cos_SERIAL>(e);
}
bool is_exponential(const ex& e) {
    return GiNaC::is_the_function<GiNaC::exp_SERIAL>(e) || GiNaC::is_the_function<GiNaC::sinh_SERIAL>(e) ||
           GiNaC::is_the_function<GiNaC::cosh_SERIAL>(e);
}

/// Whether a function or a root stands in it.
bool makes_generators(const ex& e) {
    const bool root = GiNaC::is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::integer);
    if (root || GiNaC::is_a<GiNaC::function>(e)) return true;
    return std::any_of(e.begin(), e.end(), makes_generators);
}

/// The operands of a sum or a product, those that make generators by their text: GiNaC's own order changes from run to run.
std::vector<ex> in_order(const ex& e) {
    std::vector<ex> parts(e.begin(), e.end());
    const auto first = std::stable_partition(parts.begin(), parts.end(), [](const ex& part) { return !makes_generators(part); });
    if (parts.end() - first > 1) sort_by_text(first, parts.end());
    return parts;
}

void collect_symbols(const ex& e, std::map<ex, bool, GiNaC::ex_is_less>& seen) {
    if (GiNaC::is_a<symbol>(e) || e.is_equal(GiNaC::Pi)) seen.emplace(e, e.info(GiNaC::info_flags::positive));
    for (const ex& part : e) collect_symbols(part, seen);
}

} // namespace

void Generators::collect(const ex& e, bool real_there) {
    real_there_ = real_there;
    collect(e);
}

void Generators::collect(const ex& e) {
    const bool commutes = GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e);
    for (const ex& part : commutes ? in_order(e) : std::vector<ex>(e.begin(), e.end())) collect(part);
    if (is_circular(e) || is_exponential(e)) {
        auto& units = is_circular(e) ? angle_unit_ : exponent_unit_;
        for (const auto& [monomial, coefficient] : linear_terms(rationalised(replace(e.op(0)), relations_))) {
            auto [place, fresh] = units.emplace(monomial, numeric(1));
            place->second = lcm(place->second, coefficient.denom());
        }
    }
}

ex Generators::rewrite(const ex& e, bool real_there) {
    real_there_ = real_there;
    return replace(e);
}

ex Generators::reduced_numerator(const ex& rational) {
    const ex fraction = rational.normal();
    ex numerator = reduced(fraction.numer(), relations_);
    note_denominator(fraction.denom());
    return numerator;
}

ex Generators::new_generator(const std::string& name, const ex& stands_for, const Bounds& bounds) {
    const std::string number = std::to_string(names.size() + 1);
    const symbol g(name + number, name + "_{" + number + "}");
    meaning_[g] = stands_for.subs(meaning_);
    names.emplace_back(g, meaning_[g]);
    known_.emplace(g, bounds);
    return g;
}

/// The root of the same polynomial, whatever its sign; 0 where there is none.
ex Generators::same_root(const ex& a) const {
    for (const Root& root : roots_)
        if ((root.square - a).expand().is_zero()) return root.generator;
    return 0;
}

/// A product or a quotient of roots that are known, all signs being certain; 0 where there is none.
ex Generators::composed_root(const ex& a) const {
    for (const Root& one : roots_)
        for (const Root& other : roots_) {
            if (!one.certain || !other.certain) continue;
            if ((one.square * other.square - a).expand().is_zero()) return one.generator * other.generator;
            if ((one.square - a * other.square).expand().is_zero()) return one.generator / other.generator;
        }
    return 0;
}

/// The principal root of a polynomial: squares of positive symbols come out, the rest is one generator.
ex Generators::root(const ex& polynomial, const std::string& reason) {
    ex a = reduced(polynomial, relations_);
    ex outside = 1;
    std::map<ex, bool, GiNaC::ex_is_less> seen;
    collect_symbols(a, seen);
    for (const auto& [symbol, positive] : seen)
        while (positive && a.ldegree(symbol) >= 2) {
            outside *= symbol;
            a = (a / (symbol * symbol)).expand();
        }
    if (!a.is_zero()) {
        const numeric content = a.integer_content();
        const numeric whole = GiNaC::isqrt(content.numer()) / GiNaC::isqrt(content.denom());
        if (whole * whole == content) {
            outside *= whole;
            a = (a / content).expand();
        }
    }
    if (GiNaC::is_a<numeric>(a)) return outside * GiNaC::sqrt(a);
    if (const ex same = same_root(a); !same.is_zero()) return outside * same;
    const std::string why = reason.empty() ? why_not_negative(a, known_) : reason;
    const ex composed = why.empty() ? ex(0) : composed_root(a);
    if (!composed.is_zero()) return outside * composed;
    if (why.empty() && !real_there_) throw std::domain_error("a root of what may be negative");
    const ex y = new_generator("y", GiNaC::sqrt(a), {numeric(0), {}});
    roots.push_back({names.back().second.op(0), why.empty() ? "the statement is made where the root is real" : why});
    roots_.push_back({y, a, !why.empty()});
    relations_.emplace_back(y, a);
    return outside * y;
}

ex Generators::root_of_fraction(const ex& radicand, const std::string& reason) {
    const ex fraction = radicand.normal();
    const ex denominator = fraction.denom();
    note_denominator(denominator);
    if (!why_not_negative(denominator, known_).empty()) return root(fraction.numer(), reason) / root(denominator);
    if (!why_not_negative((-denominator).expand(), known_).empty()) return root(-fraction.numer(), reason) / root(-denominator);
    throw std::domain_error("a root of a fraction whose denominator may have either sign");
}

/// An arc of atan2, in (-pi, pi], or half of it, of which the cosine is not negative.
Generators::Circular Generators::unit_angle_of_arc(const ex& arc, const numeric& unit) {
    const ex y = replace(arc.op(0)), x = replace(arc.op(1));
    const ex rho = root_of_fraction(x * x + y * y);
    if (unit == 1) return {x / rho, y / rho, unit};
    if (unit != 2) throw std::domain_error("a fraction of an arc other than its half");
    const ex c = root_of_fraction((1 + x / rho) / 2, "a coordinate is not larger than the modulus");
    return {c, y / (2 * rho * c), unit};
}

/// Cosine and sine of the unit angle of a monomial.
Generators::Circular Generators::unit_angle(const ex& monomial) {
    const numeric unit = angle_unit_.at(monomial);
    if (const auto known = angles_.find(monomial); known != angles_.end()) {
        if (known->second.unit != unit) throw std::domain_error("an angle within an angle and again outside it, finer");
        return known->second;
    }
    for (const auto& [arc, angle] : arcs_)
        if (angle.is_equal(monomial)) return angles_.emplace(monomial, unit_angle_of_arc(arc, unit)).first->second;
    const ex fraction = monomial / unit;
    const Bounds bounds{numeric(-1), numeric(1)};
    const ex c = new_generator("c", GiNaC::cos(fraction), bounds), s = new_generator("s", GiNaC::sin(fraction), bounds);
    relations_.emplace_back(s, 1 - c * c);
    return angles_.emplace(monomial, Circular{c, s, unit}).first->second;
}

/// Cosine and sine of a sum of multiples of unit angles.
Generators::Pair Generators::angle(const ex& argument) {
    ex c = 1, s = 0;
    for (const auto& [monomial, coefficient] : linear_terms(argument)) {
        if (monomial.is_equal(GiNaC::Pi)) { // a fixed angle: the quarter turns are exact
            const ex c1 = GiNaC::cos(coefficient * GiNaC::Pi), s1 = GiNaC::sin(coefficient * GiNaC::Pi);
            const ex next = c * c1 - s * s1;
            s = s * c1 + c * s1;
            c = next;
            continue;
        }
        const auto [c1, s1, unit] = unit_angle(monomial);
        const int n = coefficient.mul(unit).to_int();
        for (int k = 0; k < std::abs(n); ++k) {
            const ex next = c * c1 - (n > 0 ? s * s1 : ex(-s * s1));
            s = s * c1 + (n > 0 ? c * s1 : ex(-c * s1));
            c = next;
        }
    }
    return {c, s};
}

ex Generators::exponential(const ex& argument) {
    ex product = 1;
    for (const auto& [monomial, coefficient] : linear_terms(argument)) {
        const numeric unit = exponent_unit_.at(monomial);
        auto known = exponentials_.find(monomial);
        if (known == exponentials_.end()) {
            const ex e = new_generator("e", GiNaC::exp(monomial / unit), {numeric(0), {}});
            known = exponentials_.emplace(monomial, Exponential{e, unit}).first;
        }
        if (known->second.unit != unit) throw std::domain_error("an exponent within an exponent and again outside it, finer");
        product = product * GiNaC::pow(known->second.generator, coefficient.mul(unit));
    }
    return product;
}

/// A function or a root in generators.
ex Generators::replaced_function(const ex& e) {
    if (is_circular(e)) {
        const auto [c, s] = angle(rationalised(replace(e.op(0)), relations_));
        return GiNaC::is_the_function<GiNaC::cos_SERIAL>(e) ? c : s;
    }
    if (is_exponential(e)) {
        const ex grown = exponential(rationalised(replace(e.op(0)), relations_));
        if (GiNaC::is_the_function<GiNaC::exp_SERIAL>(e)) return grown;
        return GiNaC::is_the_function<GiNaC::sinh_SERIAL>(e) ? (grown - 1 / grown) / 2 : (grown + 1 / grown) / 2;
    }
    if (GiNaC::is_the_function<GiNaC::atan2_SERIAL>(e)) {
        const auto known = arcs_.find(e);
        if (known != arcs_.end()) return known->second;
        const ex arc = new_generator("a", e, {numeric(-4), numeric(4)});
        angle_unit_.emplace(arc, numeric(1));
        return arcs_.emplace(e, arc).first->second;
    }
    if (GiNaC::is_a<GiNaC::function>(e)) throw std::domain_error("a function that the zero test does not know");
    return root_of_fraction(replace(e.op(0)));
}

ex Generators::replace(const ex& e) {
    const auto kept = [this](const ex& function) {
        const ex value = replaced_function(function);
        const auto same = [&function](const auto& known) { return known.first.is_equal(function); };
        if (std::none_of(functions.begin(), functions.end(), same)) functions.emplace_back(function, value);
        return value;
    };
    if (GiNaC::is_a<GiNaC::function>(e)) return kept(e);
    if (GiNaC::is_a<GiNaC::power>(e)) {
        if (!GiNaC::is_a<numeric>(e.op(1))) throw std::domain_error("a power with a symbolic exponent");
        const numeric exponent = GiNaC::ex_to<numeric>(e.op(1));
        if (exponent.is_integer()) return GiNaC::pow(replace(e.op(0)), exponent);
        if (!exponent.mul(2).is_integer()) throw std::domain_error("a root that is not square");
        const ex root = GiNaC::sqrt(e.op(0));
        return GiNaC::pow(GiNaC::is_a<GiNaC::power>(root) ? kept(root) : replace(root), exponent.mul(2));
    }
    if (GiNaC::is_a<numeric>(e) && !GiNaC::ex_to<numeric>(e).is_rational())
        throw std::domain_error("a number that is not rational");
    if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
        ex result = GiNaC::is_a<GiNaC::add>(e) ? 0 : 1;
        for (const ex& part : in_order(e)) result = GiNaC::is_a<GiNaC::add>(e) ? result + replace(part) : result * replace(part);
        return result;
    }
    return e;
}

void Generators::note_divisions(const ex& rational) {
    if (GiNaC::is_a<GiNaC::power>(rational) && rational.op(1).info(GiNaC::info_flags::negative))
        note_denominator(rational.op(0).normal().numer());
    for (const ex& part : rational) note_divisions(part);
}

void Generators::note_denominator(const ex& d) {
    if (GiNaC::is_a<numeric>(d)) return;
    if (reduced(d, relations_).is_zero()) throw std::domain_error("a denominator that is zero everywhere");
    for (const ex& known : denominators)
        if ((known - d).expand().is_zero() || (known + d).expand().is_zero()) return;
    denominators.push_back(d);
}

} // namespace denhartog::derivation
