#include "zero_test.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <stdexcept>

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::symbol;

std::string to_string(Verdict v) {
    switch (v) {
    case Verdict::proved: return "proved";
    case Verdict::refuted: return "refuted";
    default: return "unknown";
    }
}

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

/// Replaces functions and roots by generators. Two passes over one expression: the first finds by which fraction each
/// monomial occurs in angles and exponents, the second replaces.
class Generators {
public:
    explicit Generators(Point inside) : inside_(std::move(inside)) {}

    ex replace(const ex& e) {
        collect(e);
        return rewrite(e);
    }

    /// Remainder of the numerator of a rational function of the generators; the denominators met are kept.
    ex reduced_numerator(const ex& rational) {
        const ex fraction = rational.normal();
        ex numerator = reduced(fraction.numer(), relations_);
        note_denominator(fraction.denom());
        return numerator;
    }

    /// Keeps what one side of a comparison divides by; it may cancel in the difference.
    void note_divisions(const ex& rational) { note_denominator(rational.normal().denom()); }

    std::vector<ex> denominators;
    std::vector<std::pair<ex, ex>> names; // generator, what it stands for

private:
    struct Root {
        symbol generator;
        ex square;
    };
    struct Angle {
        symbol cosine, sine;
    };

    Point inside_;                                                        // a point of the domain; tells signs of radicands
    GiNaC::exmap meaning_;                                                // generator -> what it stands for
    std::map<ex, numeric, GiNaC::ex_is_less> angle_unit_, exponent_unit_; // monomial -> common denominator
    std::map<ex, std::pair<ex, ex>, GiNaC::ex_is_less> angles_;           // monomial -> cosine, sine of the unit angle
    std::map<ex, ex, GiNaC::ex_is_less> exponentials_, arcs_;             // monomial -> generator; atan2 -> angle symbol
    std::vector<SquareRelation> relations_;                               // newest last

    static bool is_circular(const ex& e) {
        return GiNaC::is_the_function<GiNaC::sin_SERIAL>(e) || GiNaC::is_the_function<GiNaC::cos_SERIAL>(e);
    }
    static bool is_exponential(const ex& e) {
        return GiNaC::is_the_function<GiNaC::exp_SERIAL>(e) || GiNaC::is_the_function<GiNaC::sinh_SERIAL>(e) ||
               GiNaC::is_the_function<GiNaC::cosh_SERIAL>(e);
    }

    void collect(const ex& e) {
        for (const ex& part : e) collect(part);
        if (is_circular(e) || is_exponential(e)) {
            auto& units = is_circular(e) ? angle_unit_ : exponent_unit_;
            for (const auto& [monomial, coefficient] : linear_terms(rewrite(e.op(0)))) {
                auto [place, fresh] = units.emplace(monomial, numeric(1));
                place->second = lcm(place->second, coefficient.denom());
            }
        }
    }

    ex new_generator(const std::string& name, const ex& stands_for) {
        const std::string number = std::to_string(names.size() + 1);
        const symbol g(name + number, name + "_{" + number + "}");
        meaning_[g] = stands_for.subs(meaning_);
        names.emplace_back(g, meaning_[g]);
        return g;
    }

    /// Whether a polynomial in generators is negative inside the domain.
    bool is_negative(const ex& polynomial) const {
        const numeric value = evaluate(polynomial.subs(meaning_), inside_);
        return value.real().is_negative();
    }

    /// The positive root of a polynomial: squares of positive symbols come out, the rest is one generator.
    ex root(const ex& polynomial) {
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
        for (const auto& [generator, square] : relations_)
            if ((square - a).expand().is_zero()) return outside * generator;
        const ex y = new_generator("y", GiNaC::sqrt(a));
        relations_.emplace_back(y, a);
        return outside * y;
    }

    static void collect_symbols(const ex& e, std::map<ex, bool, GiNaC::ex_is_less>& seen) {
        if (GiNaC::is_a<symbol>(e)) seen.emplace(e, e.info(GiNaC::info_flags::positive));
        for (const ex& part : e) collect_symbols(part, seen);
    }

    ex root_of_fraction(const ex& radicand) {
        const ex fraction = radicand.normal();
        const ex denominator = fraction.denom();
        note_denominator(denominator);
        const int sign = is_negative(denominator) ? -1 : 1;
        return root(sign * fraction.numer()) / root(sign * denominator);
    }

    /// Cosine and sine of the unit angle of a monomial.
    std::pair<ex, ex> unit_angle(const ex& monomial) {
        const auto known = angles_.find(monomial);
        if (known != angles_.end()) return known->second;
        for (const auto& [arc, angle] : arcs_)
            if (angle.is_equal(monomial)) {
                const ex y = rewrite(arc.op(0)), x = rewrite(arc.op(1));
                const ex rho = root_of_fraction(x * x + y * y);
                return angles_.emplace(monomial, std::pair(ex(x / rho), ex(y / rho))).first->second;
            }
        const ex unit = monomial / angle_unit_.at(monomial);
        const ex c = new_generator("c", GiNaC::cos(unit)), s = new_generator("s", GiNaC::sin(unit));
        relations_.emplace_back(s, 1 - c * c);
        return angles_.emplace(monomial, std::pair(c, s)).first->second;
    }

    /// Cosine and sine of a sum of multiples of unit angles.
    std::pair<ex, ex> angle(const ex& argument) {
        ex c = 1, s = 0;
        for (const auto& [monomial, coefficient] : linear_terms(argument)) {
            if (monomial.is_equal(GiNaC::Pi)) { // a fixed angle: the quarter turns are exact
                const ex c1 = GiNaC::cos(coefficient * GiNaC::Pi), s1 = GiNaC::sin(coefficient * GiNaC::Pi);
                const ex next = c * c1 - s * s1;
                s = s * c1 + c * s1;
                c = next;
                continue;
            }
            const auto [c1, s1] = unit_angle(monomial);
            const int n = coefficient.mul(angle_unit_.at(monomial)).to_int();
            for (int k = 0; k < std::abs(n); ++k) {
                const ex next = c * c1 - (n > 0 ? s * s1 : ex(-s * s1));
                s = s * c1 + (n > 0 ? c * s1 : ex(-c * s1));
                c = next;
            }
        }
        return {c, s};
    }

    ex exponential(const ex& argument) {
        ex product = 1;
        for (const auto& [monomial, coefficient] : linear_terms(argument)) {
            const numeric unit = exponent_unit_.at(monomial);
            auto known = exponentials_.find(monomial);
            if (known == exponentials_.end())
                known = exponentials_.emplace(monomial, new_generator("e", GiNaC::exp(monomial / unit))).first;
            product = product * GiNaC::pow(known->second, coefficient.mul(unit));
        }
        return product;
    }

    ex rewrite(const ex& e) {
        if (is_circular(e)) {
            const auto [c, s] = angle(rewrite(e.op(0)));
            return GiNaC::is_the_function<GiNaC::cos_SERIAL>(e) ? c : s;
        }
        if (is_exponential(e)) {
            const ex grown = exponential(rewrite(e.op(0)));
            if (GiNaC::is_the_function<GiNaC::exp_SERIAL>(e)) return grown;
            return GiNaC::is_the_function<GiNaC::sinh_SERIAL>(e) ? (grown - 1 / grown) / 2 : (grown + 1 / grown) / 2;
        }
        if (GiNaC::is_the_function<GiNaC::atan2_SERIAL>(e)) {
            const auto known = arcs_.find(e);
            if (known != arcs_.end()) return known->second;
            const ex arc = new_generator("a", e);
            angle_unit_.emplace(arc, numeric(1));
            return arcs_.emplace(e, arc).first->second;
        }
        if (GiNaC::is_a<GiNaC::function>(e)) throw std::domain_error("a function that the zero test does not know");
        if (GiNaC::is_a<GiNaC::power>(e)) {
            if (!GiNaC::is_a<numeric>(e.op(1))) throw std::domain_error("a power with a symbolic exponent");
            const numeric exponent = GiNaC::ex_to<numeric>(e.op(1));
            const ex base = rewrite(e.op(0));
            if (exponent.is_integer()) return GiNaC::pow(base, exponent);
            if (!exponent.mul(2).is_integer()) throw std::domain_error("a root that is not square");
            return GiNaC::pow(root_of_fraction(base), exponent.mul(2));
        }
        if (GiNaC::is_a<numeric>(e) && !GiNaC::ex_to<numeric>(e).is_rational())
            throw std::domain_error("a number that is not rational");
        if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
            ex result = GiNaC::is_a<GiNaC::add>(e) ? 0 : 1;
            for (const ex& part : e) result = GiNaC::is_a<GiNaC::add>(e) ? result + rewrite(part) : result * rewrite(part);
            return result;
        }
        return e;
    }

    void note_denominator(const ex& d) {
        if (GiNaC::is_a<numeric>(d)) return;
        if (reduced(d, relations_).is_zero()) throw std::domain_error("a denominator that is zero everywhere");
        for (const ex& known : denominators)
            if ((known - d).expand().is_zero() || (known + d).expand().is_zero()) return;
        denominators.push_back(d);
    }
};

/// splitmix64: the same sample points on every machine.
std::uint64_t next_random(std::uint64_t& state) {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

bool is_real_value(const numeric& n) { return abs(n.imag()) <= abs(n.real()) * numeric("1e-50"); }

std::string text(const numeric& n) {
    std::ostringstream out;
    out << n;
    return out.str();
}

} // namespace

ex remainder(const ex& e, const std::vector<Range>& domain) {
    Generators generators(sample_points(domain, 1).front());
    return generators.reduced_numerator(generators.replace(e));
}

numeric evaluate(const ex& e, const Point& point) {
    GiNaC::Digits = 60;
    GiNaC::exmap values;
    for (const auto& [symbol, value] : point) values[symbol] = value;
    const ex value = e.subs(values).evalf();
    if (!GiNaC::is_a<numeric>(value)) throw std::domain_error("a symbol without a value");
    return GiNaC::ex_to<numeric>(value);
}

std::vector<Point> sample_points(const std::vector<Range>& domain, int count) {
    std::uint64_t state = 20220117;
    std::vector<Point> points;
    for (int k = 0; k < count; ++k) {
        Point point;
        for (const Range& range : domain) {
            const numeric fraction = numeric(static_cast<long>(next_random(state) % 997 + 1)) / 999;
            point.emplace_back(range.symbol, range.low + (range.high - range.low) * fraction);
        }
        points.push_back(std::move(point));
    }
    return points;
}

Decision decide_equal(const ex& left, const ex& right, const std::vector<Range>& domain) {
    Decision decision;
    bool zero = false;
    try {
        Generators generators(sample_points(domain, 1).front());
        zero = generators.reduced_numerator(generators.replace(left - right)).is_zero();
        generators.note_divisions(generators.replace(left));
        generators.note_divisions(generators.replace(right));
        decision.denominators = generators.denominators;
        decision.generators = generators.names;
    } catch (const std::exception& e) {
        decision.reason = e.what();
    }
    int evaluated = 0;
    for (const Point& point : sample_points(domain, 24)) {
        numeric l, r;
        try {
            r = evaluate(right, point);
            if (!is_real_value(r)) throw std::domain_error("no real value at a point of the domain");
            l = evaluate(left, point);
        } catch (const std::exception& e) {
            decision.reason = e.what();
            continue;
        }
        ++evaluated;
        if (abs(l - r) > (abs(l) + abs(r) + 1) * numeric("1e-35")) {
            if (zero) throw std::logic_error("reduced to zero, yet not zero: " + text(l) + " against " + text(r));
            decision.verdict = Verdict::refuted;
            decision.witness = point;
            decision.left = text(l);
            decision.right = text(r);
            return decision;
        }
    }
    if (zero && evaluated > 0)
        decision.verdict = Verdict::proved;
    else if (zero)
        decision.reason = "no point of the domain could be evaluated";
    return decision;
}

} // namespace denhartog::derivation
