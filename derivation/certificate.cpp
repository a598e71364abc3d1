#include "certificate.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>

#include "coq_text.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::symbol;

namespace {

using Less = GiNaC::ex_is_less;

/// What a side divides by, with a symbol for it and one for its inverse. A symbol that is divided by stands for itself.
struct Divisor {
    ex polynomial; // in symbols and generators
    symbol inverse;
    symbol named;
    bool plain = false; // a symbol, a generator or pi
    std::string name, text;
    std::vector<ex> seen; // how it was written, of either sign
};

/// Both sides as polynomials in symbols, generators and inverses of divisors.
class Divisors {
public:
    std::vector<Divisor> all;

    /// An expression with the inverses in place of what is divided by.
    ex without_quotients(const ex& e) {
        if (GiNaC::is_a<GiNaC::power>(e)) {
            if (!e.op(1).info(GiNaC::info_flags::integer)) throw std::domain_error("the root of a number");
            const numeric n = GiNaC::ex_to<numeric>(e.op(1));
            const ex base = without_quotients(e.op(0));
            return n.is_negative() ? ex(GiNaC::pow(inverse(base), -n)) : ex(GiNaC::pow(base, n));
        }
        if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
            ex result = GiNaC::is_a<GiNaC::add>(e) ? 0 : 1;
            for (const ex& part : e)
                result = GiNaC::is_a<GiNaC::add>(e) ? result + without_quotients(part) : result * without_quotients(part);
            return result;
        }
        return e;
    }

    /// An expanded polynomial times the least product of divisors that leaves no inverse in it, and that product; divisors by symbols.
    std::pair<ex, ex> cleared(const ex& polynomial) const {
        ex numerator = polynomial, factor = 1;
        for (const Divisor& d : all) {
            const int most = numerator.degree(d.inverse);
            if (most <= 0) continue;
            ex next = 0;
            for (int k = 0; k <= most; ++k) next += numerator.coeff(d.inverse, k) * GiNaC::pow(shown(d), most - k);
            numerator = next.expand();
            factor *= GiNaC::pow(shown(d), most);
        }
        return {numerator, factor};
    }

    /// An expression with the polynomials in place of the divisors' symbols.
    ex with_polynomials(const ex& e) const {
        GiNaC::exmap meaning;
        for (const Divisor& d : all)
            if (!d.plain) meaning[d.named] = d.polynomial;
        return e.subs(meaning);
    }

    void add(const ex& polynomial) {
        const bool plain = GiNaC::is_a<symbol>(polynomial) || polynomial.is_equal(GiNaC::Pi);
        all.push_back({polynomial, symbol("inverse"), symbol("divisor"), plain, {}, {}, {polynomial}});
    }

    static ex shown(const Divisor& d) { return d.plain ? d.polynomial : ex(d.named); }

private:
    ex inverse(const ex& base) {
        if (GiNaC::is_a<numeric>(base)) return 1 / base;
        if (GiNaC::is_a<GiNaC::mul>(base)) {
            ex product = 1;
            for (const ex& factor : base) product *= inverse(factor);
            return product;
        }
        if (GiNaC::is_a<GiNaC::power>(base)) return GiNaC::pow(inverse(base.op(0)), base.op(1));
        for (const Divisor& d : all)
            if (base.is_equal(d.inverse)) return shown(d);
        const auto [polynomial, factor] = cleared(base.expand());
        if (!factor.is_equal(1)) return with_polynomials(factor) * inverse(factored_content(with_polynomials(polynomial)));
        for (Divisor& d : all)
            for (const int sign : {1, -1})
                if ((d.polynomial - sign * base).expand().is_zero()) {
                    d.seen.push_back(base);
                    return sign * d.inverse;
                }
        add(base);
        return all.back().inverse;
    }

    /// A polynomial, with what divides all its terms as factors.
    static ex factored_content(const ex& polynomial) { return GiNaC::collect_common_factors(polynomial.expand()); }
};

std::size_t terms_of(const ex& e) { return GiNaC::is_a<GiNaC::add>(e) ? e.nops() : e.is_zero() ? 0 : 1; }

void collect_symbols(const ex& e, GiNaC::exset& found) {
    if (GiNaC::is_a<symbol>(e)) found.insert(e);
    for (const ex& part : e) collect_symbols(part, found);
}

/// The least common multiple of the denominators in an expanded polynomial.
numeric common_denominator(const ex& polynomial) {
    numeric result(1);
    const std::function<void(const ex&)> visit = [&](const ex& e) {
        if (GiNaC::is_a<numeric>(e)) result = lcm(result, GiNaC::ex_to<numeric>(e).denom());
        for (const ex& part : e)
            if (!GiNaC::is_a<GiNaC::power>(e)) visit(part);
    };
    visit(polynomial);
    return result;
}

/// A relation with whole coefficients: scale * y^2 = scale * square.
struct Relation {
    ex generator, square;
    numeric scale;
    std::string name, text; // text: the equation
    [[nodiscard]] ex left_less_right() const { return (scale * (generator * generator - square)).expand(); }
};

/// Makes the parts of a lemma, one after the other.
class Lemma {
public:
    Lemma(const Identity& identity, const LeftOut& left_out) : identity_(identity), left_out_(left_out) {
        name_generators();
        find_divisors();
        left_ = divisors_.without_quotients(identity.left_in_generators);
        right_ = divisors_.without_quotients(identity.right_in_generators);
        name_divisors();
        order_relations();
        find_parts();
    }

    Certificate written(const std::string& name) const {
        Certificate c;
        c.generators = meanings_;
        c.holds = true;
        for (const Combination& part : parts_) {
            c.terms += terms_of(part.numerator);
            for (const auto& [place, cofactor] : part.cofactors) c.terms += terms_of(cofactor);
            c.holds = c.holds && part.rest.is_zero();
        }
        c.lacks = (left_out_.relation && std::ranges::any_of(parts_, [](const Combination& part) { return !part.cofactors.empty(); })) ||
                  (left_out_.divisor && std::ranges::any_of(divisors_.all, [](const Divisor& d) { return d.name != "PI"; }));
        const std::string left = text(left_), right = text(right_);
        c.statement = statement(name, left, right);
        c.proof = proof();
        if (c.holds && !identity_.functions.empty()) {
            try {
                c.in_functions = in_functions(name);
            } catch (const std::domain_error& e) {
                c.why_no_functions = e.what();
            }
        }
        return c;
    }

private:
    const Identity& identity_;
    LeftOut left_out_;
    CoqNames names_;
    std::vector<std::pair<std::string, std::string>> meanings_;
    std::set<std::string> exponentials_, roots_;
    Divisors divisors_;
    std::vector<Relation> relations_; // in the order of the reduction: newest first
    std::vector<Combination> parts_;
    ex left_, right_;
    GiNaC::exmap meaning_; // generator -> what it stands for

    std::string text(const ex& e) const { return coq_text(e, names_); }

    /// Generators by what they stand for, so that a lemma reads the same on every run.
    void name_generators() {
        std::map<std::string, std::vector<std::pair<std::string, ex>>> found; // family -> text of the argument, generator
        for (const auto& [generator, meaning] : identity_.generators) {
            meaning_[generator] = meaning;
            const bool root = GiNaC::is_a<GiNaC::power>(meaning);
            const std::string function = root ? "root" : GiNaC::ex_to<GiNaC::function>(meaning).get_name();
            std::string argument;
            for (const ex& part : meaning) {
                if (root && !argument.empty()) continue;
                argument += (argument.empty() ? "" : ", ") + coq_text(part);
            }
            found[function].emplace_back(argument, generator);
        }
        std::set<std::string> angles;
        for (const char* function : {"cos", "sin"})
            for (const auto& [argument, generator] : found[function]) angles.insert(argument);
        for (auto& [function, list] : found) {
            std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
            const bool circular = function == "cos" || function == "sin";
            for (std::size_t k = 0; k < list.size(); ++k) {
                const std::size_t number =
                    circular ? static_cast<std::size_t>(std::distance(angles.begin(), angles.find(list[k].first))) : k;
                const std::string name = (function == "atan2" ? "angle" : function) + "_" + std::to_string(number + 1);
                names_.names[list[k].second] = name;
                meanings_.emplace_back(name, (function == "root" ? "sqrt" : function) + " (" + list[k].first + ")");
                if (function == "exp") exponentials_.insert(name);
                if (function == "root") roots_.insert(name);
            }
        }
    }

    /// Each divisor in that of the ways in which it is written that comes first by its text.
    void find_divisors() {
        Divisors met;
        for (const ex& side : {identity_.left_in_generators, identity_.right_in_generators}) (void)met.without_quotients(side);
        std::map<std::string, ex> chosen;
        for (const Divisor& d : met.all) {
            std::map<std::string, ex> ways;
            for (const ex& way : d.seen) ways.emplace(text(way), way);
            chosen.insert(*ways.begin());
        }
        for (const auto& [shown, polynomial] : chosen) divisors_.add(polynomial);
    }

    void name_divisors() {
        int number = 0;
        for (Divisor& d : divisors_.all) {
            d.text = text(d.polynomial);
            d.name = d.plain ? d.text : "divisor_" + std::to_string(++number);
            names_.names[d.named] = d.name;
            names_.inverses[d.inverse] = d.name;
        }
    }

    /// The relations of generators that occur, each before those of the generators in its square; ties by name.
    void order_relations() {
        GiNaC::exset needed;
        for (const ex& side : {left_, right_}) collect_symbols(side, needed);
        for (const Divisor& d : divisors_.all) collect_symbols(d.polynomial, needed);
        std::vector<Relation> open;
        for (auto place = identity_.relations.rbegin(); place != identity_.relations.rend(); ++place) {
            const auto& [generator, square] = *place;
            if (!needed.contains(generator)) continue;
            collect_symbols(square, needed);
            const numeric scale = common_denominator(square.expand());
            const std::string name = names_.names.at(generator), g = name + " ^ 2";
            const std::string of = name.starts_with("sin_") ? "circle_" + name.substr(4) : name + "_squared";
            const std::string factor = scale.is_equal(1) ? "" : text(scale) + " * ";
            const std::string equation = name.starts_with("sin_")
                                             ? g + " + " + "cos_" + name.substr(4) + " ^ 2 = 1"
                                             : factor + g + " = " + text((scale * square).expand());
            open.push_back({generator, square, scale, of, equation});
        }
        std::sort(open.begin(), open.end(), [](const Relation& a, const Relation& b) { return a.name < b.name; });
        while (!open.empty()) {
            const auto next = std::find_if(open.begin(), open.end(), [&open](const Relation& r) {
                return std::none_of(open.begin(), open.end(), [&r](const Relation& other) { return other.square.has(r.generator); });
            });
            if (next == open.end()) throw std::logic_error("relations that go round in a circle");
            relations_.push_back(*next);
            open.erase(next);
        }
    }

    /// The difference of the sides by powers of the symbols that stand in no relation and no divisor; each coefficient reduced.
    void find_parts() {
        GiNaC::exset bound;
        for (const Relation& r : relations_) {
            bound.insert(r.generator);
            collect_symbols(r.square, bound);
        }
        for (const Divisor& d : divisors_.all) {
            bound.insert(d.inverse);
            collect_symbols(d.polynomial, bound);
        }
        GiNaC::exset free;
        for (const ex& side : {left_, right_}) collect_symbols(side, free);
        std::vector<ex> variables;
        for (const ex& x : free)
            if (!bound.contains(x)) variables.push_back(x);
        std::vector<std::pair<ex, ex>> coefficients{{1, (left_ - right_).expand()}};
        for (const ex& x : variables) {
            std::vector<std::pair<ex, ex>> finer;
            for (const auto& [monomial, coefficient] : coefficients)
                for (int n = coefficient.ldegree(x); n <= coefficient.degree(x); ++n)
                    if (const ex c = coefficient.coeff(x, n).expand(); !c.is_zero())
                        finer.emplace_back(monomial * GiNaC::pow(x, n), c);
            coefficients = std::move(finer);
        }
        std::map<std::string, Combination> sorted;
        for (const auto& [monomial, coefficient] : coefficients) {
            if (coefficient.is_zero()) continue;
            sorted.emplace(text(monomial), combination(monomial, coefficient));
        }
        for (auto& [monomial, part] : sorted) parts_.push_back(std::move(part));
    }

    Combination combination(const ex& monomial, const ex& coefficient) const {
        const auto [numerator, denominator] = divisors_.cleared(coefficient);
        Combination part{numerator, monomial / denominator, {}, divisors_.with_polynomials(numerator).expand()};
        numeric scale = common_denominator(numerator);
        for (std::size_t k = 0; k < relations_.size(); ++k) {
            const auto& [y, square, whole, name, equation] = relations_[k];
            ex cofactor = 0, next = 0;
            const int degree = part.rest.degree(y);
            if (degree < 2) continue;
            for (int n = part.rest.ldegree(y); n <= degree; ++n) {
                const ex c = part.rest.coeff(y, n);
                next += c * GiNaC::pow(square, n / 2) * GiNaC::pow(y, n % 2);
                for (int j = 0; j < n / 2; ++j) // y^2m - s^m = (y^2 - s)(y^(2m-2) + ... + s^(m-1))
                    cofactor += c * GiNaC::pow(y, n % 2 + 2 * j) * GiNaC::pow(square, n / 2 - 1 - j);
            }
            part.rest = next.expand();
            part.cofactors.emplace_back(k, (cofactor / whole).expand());
            scale = lcm(scale, common_denominator(part.cofactors.back().second));
        }
        part.factor = part.factor / scale;
        part.numerator = (part.numerator * scale).expand();
        part.rest = (part.rest * scale).expand();
        for (auto& [k, cofactor] : part.cofactors) cofactor = (cofactor * scale).expand();
        return part;
    }

    std::vector<std::string> variables() const {
        GiNaC::exset found;
        for (const ex& side : {left_, right_}) collect_symbols(side, found);
        for (const Divisor& d : divisors_.all) {
            collect_symbols(d.polynomial, found);
            found.erase(d.inverse);
            found.erase(d.named);
        }
        for (const Relation& r : relations_) collect_symbols(r.generator + r.square, found);
        std::vector<std::string> list;
        for (const ex& x : found) list.push_back(text(x));
        std::sort(list.begin(), list.end());
        if (std::adjacent_find(list.begin(), list.end()) != list.end()) throw std::domain_error("two symbols of one name");
        for (const Divisor& d : divisors_.all)
            if (!d.plain) list.push_back(d.name);
        return list;
    }

    /// Ranges of the symbols, as far as these are known, and the signs that generators have.
    std::vector<std::string> ranges(const std::vector<std::string>& variables) const {
        std::vector<std::string> list = ranges_of_symbols(variables);
        const auto occurs = [&](const std::string& name) { return std::ranges::find(variables, name) != variables.end(); };
        for (const std::string& name : roots_)
            if (occurs(name)) list.push_back("0 <= " + name);
        for (const std::string& name : exponentials_)
            if (occurs(name)) list.push_back("0 < " + name);
        return list;
    }

    std::vector<std::string> ranges_of_symbols(const std::vector<std::string>& variables) const {
        std::vector<std::string> list;
        const auto occurs = [&](const std::string& name) { return std::ranges::find(variables, name) != variables.end(); };
        for (const Range& range : identity_.domain) {
            const std::string name = text(range.symbol);
            if (!occurs(name)) continue;
            if (range.bounds.lower && range.bounds.upper)
                list.push_back(text(*range.bounds.lower) + " <= " + name + " <= " + text(*range.bounds.upper));
            else if (range.bounds.lower)
                list.push_back(text(*range.bounds.lower) + " <= " + name);
        }
        std::sort(list.begin(), list.end());
        return list;
    }

    bool is_left_out(const Relation& relation) const {
        if (!left_out_.relation) return false;
        std::string last;
        for (const Combination& part : parts_)
            if (!part.cofactors.empty()) last = relations_[part.cofactors.back().first].name;
        return relation.name == last;
    }

    std::string statement(const std::string& name, const std::string& left, const std::string& right) const {
        std::string out = "Lemma " + name + " :\n";
        const std::vector<std::string> all = variables();
        if (!all.empty()) {
            out += "  forall";
            for (const std::string& variable : all) out += " " + variable;
            out += " : R,\n";
        }
        for (const std::string& range : ranges(all)) out += "  " + range + " ->\n";
        const auto hypothesis = [&out](const std::string& label, const std::string& what) {
            out += "  forall " + label + " : " + what + ",\n";
        };
        for (auto r = relations_.rbegin(); r != relations_.rend(); ++r)
            if (!is_left_out(*r)) hypothesis(r->name, r->text);
        bool first = true;
        for (const Divisor& d : divisors_.all) {
            if (!d.plain) hypothesis(d.name + "_is", d.name + " = " + d.text);
            if (d.name != "PI" && !(first && left_out_.divisor)) hypothesis(d.name + "_not_zero", d.name + " <> 0");
            first = first && d.name == "PI";
        }
        return out + "  " + left + "\n  = " + right + ".\n";
    }

    /// An expression in generators with what these stand for, as text: nothing is simplified.
    std::string meant(const ex& e) const {
        CoqNames named;
        for (const auto& [generator, meaning] : meaning_) named.names[generator] = "(" + coq_text(meaning) + ")";
        return coq_text(e, named);
    }

    /// An expression with generators in place of functions and roots.
    ex replaced(const ex& e) const {
        const auto known = [this](const ex& function) {
            const auto place = std::find_if(identity_.functions.begin(), identity_.functions.end(),
                                            [&function](const auto& f) { return f.first.is_equal(function); });
            if (place == identity_.functions.end()) throw std::domain_error("a function that no generator stands for");
            return place->second;
        };
        if (GiNaC::is_a<GiNaC::function>(e)) return known(e);
        if (GiNaC::is_a<GiNaC::power>(e)) {
            const ex exponent = e.op(1);
            if (exponent.info(GiNaC::info_flags::integer)) return GiNaC::pow(replaced(e.op(0)), exponent);
            return GiNaC::pow(known(GiNaC::sqrt(e.op(0))), 2 * exponent);
        }
        if (!GiNaC::is_a<GiNaC::add>(e) && !GiNaC::is_a<GiNaC::mul>(e)) return e;
        ex result = GiNaC::is_a<GiNaC::add>(e) ? 0 : 1;
        for (const ex& part : e) result = GiNaC::is_a<GiNaC::add>(e) ? result + replaced(part) : result * replaced(part);
        return result;
    }

    /// The argument of a generator with generators in place of its roots.
    ex in_roots(const ex& argument) const {
        if (GiNaC::is_a<GiNaC::power>(argument) && !argument.op(1).info(GiNaC::info_flags::integer))
            for (const auto& [generator, meaning] : identity_.generators)
                if (meaning.is_equal(GiNaC::sqrt(argument.op(0)))) return GiNaC::pow(generator, 2 * argument.op(1));
        if (!GiNaC::is_a<GiNaC::mul>(argument)) return argument;
        ex result = 1;
        for (const ex& part : argument) result *= in_roots(part);
        return result;
    }

    /// An angle or an exponent as a sum of whole multiples of those of the generators, as text.
    std::string sum_of_units(const ex& argument, const std::vector<ex>& units) const {
        std::string sum;
        const ex expanded = replaced(argument).expand();
        const auto take = [&](const ex& term) {
            for (const ex& unit : units) {
                const ex n = (term / in_roots(unit)).normal();
                if (!GiNaC::is_a<numeric>(n) || !GiNaC::ex_to<numeric>(n).is_integer()) continue;
                const int count = GiNaC::ex_to<numeric>(n).to_int();
                const std::string one = (count < 0 ? "- (" : "(") + coq_text(unit) + ")";
                for (int k = 0; k < std::abs(count); ++k) sum += (sum.empty() ? "" : " + ") + ("(" + one + ")");
                return;
            }
            throw std::domain_error("an angle or exponent that is a sum of those of the generators only by their relations");
        };
        if (GiNaC::is_a<GiNaC::add>(expanded))
            for (const ex& term : expanded) take(term);
        else
            take(expanded);
        return sum;
    }

    /// Why a function is what the generators say, as a tactic; empty where it is a generator itself.
    std::string why_function(const ex& function, const ex& value, const std::string& inner) const {
        std::vector<ex> angles{GiNaC::Pi / 2}, exponents;
        for (const auto& [generator, meaning] : identity_.generators) {
            if (value.is_equal(generator) && coq_text(function) == coq_text(meaning)) return {};
            if (GiNaC::is_the_function<GiNaC::cos_SERIAL>(meaning)) angles.push_back(meaning.op(0));
            if (GiNaC::is_the_function<GiNaC::exp_SERIAL>(meaning)) exponents.push_back(meaning.op(0));
        }
        if (GiNaC::is_a<GiNaC::power>(function)) { // a root: a factor that is not negative times a generator
            for (const auto& [generator, meaning] : identity_.generators) {
                if (!GiNaC::is_a<GiNaC::power>(meaning) || !value.has(generator)) continue;
                const ex factor = (value / generator).normal();
                if (factor.has(generator)) break;
                return "transitivity ((" + meant(factor) + ") * sqrt (" + coq_text(meaning.op(0)) +
                       ")); [apply root_of_product; [not_negative | assumption | field; nonzero] | field; nonzero]";
            }
            throw std::domain_error("a root that is taken apart");
        }
        const bool circular =
            GiNaC::is_the_function<GiNaC::sin_SERIAL>(function) || GiNaC::is_the_function<GiNaC::cos_SERIAL>(function);
        return "transitivity (" + GiNaC::ex_to<GiNaC::function>(function).get_name() + " (" +
               sum_of_units(function.op(0), circular ? angles : exponents) + ")); [f_equal; " + inner + "field; nonzero | " +
               (circular ? "addition]" : "unfold sinh, cosh; exponents]");
    }

    /// What is divided by, by its text: in the sides, in arguments and under roots.
    static void collect_divided(const ex& e, std::map<std::string, ex>& found) {
        if (GiNaC::is_a<GiNaC::power>(e) && GiNaC::is_a<numeric>(e.op(1)) && GiNaC::ex_to<numeric>(e.op(1)).is_negative()) {
            const ex base = e.op(1).info(GiNaC::info_flags::integer) ? e.op(0) : ex(GiNaC::sqrt(e.op(0)));
            found.emplace(coq_text(base), base);
        }
        for (const ex& part : e) collect_divided(part, found);
    }

    /// Whether a divisor of the first lemma is, but for a number, the numerator of something that is divided by.
    bool follows(const Divisor& divisor, const std::map<std::string, ex>& divided) const {
        for (const auto& [shown, base] : divided) {
            Divisors own;
            const ex polynomial = own.with_polynomials(own.cleared(own.without_quotients(replaced(base)).expand()).first);
            if (GiNaC::is_a<numeric>((polynomial / divisor.polynomial).normal())) return true;
        }
        return false;
    }

    /// Whether a function or a root stands in one of the sides.
    bool occurs(const ex& function) const {
        const std::function<bool(const ex&)> stands_in = [&](const ex& e) {
            if (e.is_equal(function)) return true;
            const bool root = GiNaC::is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::integer);
            if (root && GiNaC::sqrt(e.op(0)).is_equal(function)) return true;
            return std::any_of(e.begin(), e.end(), stands_in);
        };
        return stands_in(identity_.left) || stands_in(identity_.right);
    }

    /// The same of the functions themselves: each is what the generators say, these have their relations, and the first lemma applies.
    std::string in_functions(const std::string& name) const {
        for (const auto& [generator, meaning] : identity_.generators)
            if (GiNaC::is_the_function<GiNaC::atan2_SERIAL>(meaning)) throw std::domain_error("the angle of a point");
        GiNaC::exset symbols_there;
        for (const ex& side : {identity_.left, identity_.right}) collect_symbols(side, symbols_there);
        for (const auto& [generator, meaning] : identity_.generators) collect_symbols(meaning, symbols_there);
        std::map<std::string, ex> divided;
        std::set<std::string> radicands;
        for (const ex& side : {identity_.left, identity_.right}) collect_divided(side, divided);
        const std::vector<std::string> of_lemma = variables();
        for (const auto& [generator, meaning] : identity_.generators) {
            collect_divided(meaning, divided);
            if (GiNaC::is_a<GiNaC::power>(meaning)) radicands.insert(coq_text(meaning.op(0)));
        }
        for (const auto& [function, value] : identity_.functions)
            if (occurs(function)) collect_divided(function, divided);
        for (const Divisor& d : divisors_.all) collect_symbols(d.polynomial.subs(meaning_), symbols_there);
        std::vector<std::string> not_zero;
        for (const auto& [shown, base] : divided)
            if (!base.is_equal(GiNaC::Pi) && !GiNaC::is_the_function<GiNaC::exp_SERIAL>(base)) not_zero.push_back(shown);
        for (const Divisor& d : divisors_.all)
            if (d.name != "PI" && !d.name.starts_with("exp_") && !follows(d, divided)) not_zero.push_back(meant(d.polynomial));
        std::vector<std::string> symbol_names;
        for (const ex& x : symbols_there) symbol_names.push_back(coq_text(x));
        std::sort(symbol_names.begin(), symbol_names.end());
        std::string out = "Lemma " + name + "_in_functions :\n";
        if (!symbol_names.empty()) {
            out += "  forall";
            for (const std::string& x : symbol_names) out += " " + x;
            out += " : R,\n";
        }
        for (const std::string& range : ranges_of_symbols(symbol_names)) out += "  " + range + " ->\n";
        for (const std::string& radicand : radicands) out += "  0 <= " + radicand + " ->\n";
        for (const std::string& divisor : not_zero) out += "  " + divisor + " <> 0 ->\n";
        out += "  " + coq_text(identity_.left) + "\n  = " + coq_text(identity_.right) + ".\nProof.\n  intros.\n";
        std::vector<std::string> rewritten;
        std::string inner; // roots stand in arguments
        for (const auto& [function, value] : identity_.functions) {
            if (!occurs(function)) continue;
            const std::string why = why_function(function, value, inner);
            if (why.empty()) continue;
            if (GiNaC::is_a<GiNaC::power>(function)) inner += "rewrite ?function_" + std::to_string(rewritten.size() + 1) + "; ";
            rewritten.push_back("function_" + std::to_string(rewritten.size() + 1));
            out += "  assert (" + rewritten.back() + " : " + coq_text(function) + " = " + meant(value) + ") by (" + why + ").\n";
        }
        for (auto f = rewritten.rbegin(); f != rewritten.rend(); ++f) out += "  rewrite ?" + *f + " in *; clear " + *f + ".\n";
        std::set<std::string> circles;
        for (const auto& [generator, meaning] : identity_.generators) {
            const std::string g = names_.names.at(generator), m = coq_text(meaning);
            if (GiNaC::is_a<GiNaC::power>(meaning)) {
                out += "  assert (0 <= " + m + ") by apply sqrt_pos.\n";
            } else if (GiNaC::is_the_function<GiNaC::exp_SERIAL>(meaning)) {
                out += "  assert (0 < " + m + ") by apply exp_pos.\n  assert (" + m + " <> 0) by apply exp_not_zero.\n";
            } else if (const std::string argument = coq_text(meaning.op(0)); circles.insert(argument).second) {
                out += "  assert (sin (" + argument + ") ^ 2 + cos (" + argument + ") ^ 2 = 1) by apply circle.\n";
            }
        }
        for (const Relation& r : relations_)
            if (const ex& meaning = meaning_.at(r.generator); GiNaC::is_a<GiNaC::power>(meaning))
                out += "  assert (" + (r.scale.is_equal(1) ? "" : text(r.scale) + " * ") + coq_text(meaning) + " ^ 2 = " + meant((r.scale * r.square).expand()) +
                       ") by (rewrite (root_squared (" + coq_text(meaning.op(0)) + ")) by assumption; ring).\n";
        std::vector<std::pair<std::size_t, std::string>> by_length; // outer functions first
        for (const auto& [generator, meaning] : identity_.generators) {
            const std::string m = coq_text(meaning);
            by_length.emplace_back(m.size(), "  set (" + names_.names.at(generator) + " := " + m + ") in *; clearbody " +
                                                 names_.names.at(generator) + ".\n");
        }
        std::sort(by_length.rbegin(), by_length.rend());
        for (const auto& [length, step] : by_length) out += step;
        out += "  eapply through.\n  - apply (" + name;
        for (const std::string& variable : of_lemma) {
            const auto divisor = std::find_if(divisors_.all.begin(), divisors_.all.end(), [&variable](const Divisor& d) {
                return !d.plain && d.name == variable;
            });
            out += " " + (divisor == divisors_.all.end() ? variable : "(" + divisor->text + ")");
        }
        return out + "); first [reflexivity | assumption | lra | not_zero].\n  - field; nonzero.\n  - field; nonzero.\nQed.\n";
    }

    std::string proof() const {
        std::string sum = "0", steps, named;
        for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) {
            const std::string shown = "(" + text(part->factor) + ") * (" + text(part->numerator) + ")";
            sum = sum == "0" ? shown + " + 0" : shown + " + (" + sum + ")";
        }
        for (const Divisor& d : divisors_.all)
            if (!d.plain) named += " " + d.name;
        std::string out = "Proof.\n  intros. apply Rminus_diag_uniq.\n  transitivity (" + sum + ").\n";
        out += "  - field; nonzero.\n  - ";
        if (!named.empty() && !parts_.empty()) out += "subst" + named + ". ";
        for (const Combination& part : parts_) {
            out += "apply part_is_zero.\n    { ";
            for (const auto& [place, cofactor] : part.cofactors)
                if (!is_left_out(relations_[place])) out += "apply (by_relation _ _ _ (" + text(cofactor) + ") " + relations_[place].name + ").\n      ";
            out += "ring. }\n    ";
        }
        return out + "reflexivity.\nQed.\n";
    }
};

} // namespace

std::string certificate_prelude() {
    return "Require Import Reals Lra.\nOpen Scope R_scope.\n\n"
           "Lemma by_relation : forall n a b cofactor : R, a = b -> n - cofactor * (a - b) = 0 -> n = 0.\n"
           "Proof. intros n a b cofactor same rest. rewrite same in rest. rewrite <- rest. ring. Qed.\n\n"
           "Lemma part_is_zero : forall factor n rest : R, n = 0 -> rest = 0 -> factor * n + rest = 0.\n"
           "Proof. intros factor n rest zero zero_rest. rewrite zero, zero_rest. ring. Qed.\n\n"
           "Ltac not_zero := let zero := fresh in intro zero;\n"
           "  match goal with H : ?d <> 0 |- False =>\n"
           "    apply H; first [lra | field_simplify_eq; [lra | repeat split; first [assumption | exact PI_neq0]]] end.\n"
           "Ltac nonzero := repeat split; first [assumption | exact PI_neq0 | not_zero].\n";
}

std::string functions_prelude() {
    return "Lemma through : forall a b c d : R, c = d -> a = c -> d = b -> a = b.\n"
           "Proof. intros a b c d same left right. rewrite left, same. exact right. Qed.\n\n"
           "Lemma circle : forall x : R, sin x ^ 2 + cos x ^ 2 = 1.\n"
           "Proof. intro x. rewrite <- (sin2_cos2 x). unfold Rsqr. ring. Qed.\n\n"
           "Lemma exp_not_zero : forall x : R, exp x <> 0.\n"
           "Proof. intros x zero. apply (Rlt_irrefl 0). rewrite <- zero at 2. apply exp_pos. Qed.\n\n"
           "Lemma root_squared : forall a : R, 0 <= a -> sqrt a ^ 2 = a.\n"
           "Proof. intros a real. simpl. rewrite Rmult_1_r. apply sqrt_sqrt. exact real. Qed.\n\n"
           "Lemma root_of_product : forall b factor a : R, 0 <= factor -> 0 <= a -> b = factor * factor * a -> sqrt b = factor * sqrt a.\n"
           "Proof.\n  intros b factor a sign real product. rewrite product, sqrt_mult_alt, sqrt_square.\n"
           "  - reflexivity.\n  - exact sign.\n  - apply Rmult_le_pos; exact sign.\nQed.\n\n"
           "Ltac addition :=\n"
           "  repeat first [rewrite cos_plus | rewrite sin_plus | rewrite cos_neg | rewrite sin_neg | rewrite cos_PI2 | rewrite sin_PI2];\n"
           "  field; nonzero.\n"
           "Ltac exponents :=\n"
           "  repeat first [rewrite exp_plus | rewrite Ropp_plus_distr | rewrite Ropp_involutive | rewrite exp_Ropp];\n"
           "  field; repeat split; apply exp_not_zero.\n"
           "Lemma quotient_not_negative : forall a b : R, 0 <= a -> 0 <= b -> b <> 0 -> 0 <= a / b.\n"
           "Proof.\n  intros a b above below not_zero. apply Rmult_le_pos; [exact above |].\n"
           "  left. apply Rinv_0_lt_compat. lra.\nQed.\n\n"
           "Ltac not_negative :=\n  repeat first [assumption | lra | apply Rmult_le_pos | apply pow_le | apply sqrt_pos |\n"
           "                apply quotient_not_negative | solve [nonzero]].\n";
}

Identity in_generators(const ex& left, const ex& right, const std::vector<Range>& domain, const std::vector<ex>& real) {
    KnownBounds known;
    for (const Range& range : domain) known[range.symbol] = range.bounds;
    Generators generators(known);
    for (const ex& e : real) generators.collect(e, true);
    generators.collect(right, true);
    generators.collect(left, false);
    for (const ex& e : real) (void)generators.rewrite(e, true);
    const ex r = generators.rewrite(right, true), l = generators.rewrite(left, false);
    return {left, right, domain, l, r, generators.names, generators.relations(), generators.functions};
}

Certificate certificate_of(const Identity& identity, const std::string& name, const LeftOut& left_out) {
    return Lemma(identity, left_out).written(name);
}

} // namespace denhartog::derivation
