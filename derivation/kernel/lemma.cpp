#include "derivation/kernel/lemma.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::symbol;

namespace {

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

} // namespace

void symbols_in(const ex& e, GiNaC::exset& found) {
    if (GiNaC::is_a<symbol>(e)) found.insert(e);
    for (const ex& part : e) symbols_in(part, found);
}

Lemma::Lemma(const Identity& identity, const LeftOut& left_out) : identity_(identity), left_out_(left_out) {
    name_generators();
    find_divisors();
    left_ = divisors_.without_quotients(identity.left_in_generators);
    right_ = divisors_.without_quotients(identity.right_in_generators);
    name_divisors();
    order_relations();
    find_parts();
}

void Lemma::name_generators() {
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

void Lemma::find_divisors() {
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

void Lemma::name_divisors() {
    int number = 0;
    for (Divisor& d : divisors_.all) {
        d.text = text(d.polynomial);
        d.name = d.plain ? d.text : "divisor_" + std::to_string(++number);
        names_.names[d.named] = d.name;
        names_.inverses[d.inverse] = d.name;
    }
}

void Lemma::order_relations() {
    GiNaC::exset needed;
    for (const ex& side : {left_, right_}) symbols_in(side, needed);
    for (const Divisor& d : divisors_.all) symbols_in(d.polynomial, needed);
    std::vector<Relation> open;
    for (auto place = identity_.relations.rbegin(); place != identity_.relations.rend(); ++place) {
        const auto& [generator, square] = *place;
        if (!needed.contains(generator)) continue;
        symbols_in(square, needed);
        const numeric scale = common_denominator(square.expand());
        const std::string name = names_.names.at(generator), g = name + " ^ 2";
        const std::string of = name.starts_with("sin_") ? "circle_" + name.substr(4) : name + "_squared";
        const std::string factor = scale.is_equal(1) ? "" : text(scale) + " * ";
        const std::string equation = name.starts_with("sin_") ? g + " + " + "cos_" + name.substr(4) + " ^ 2 = 1"
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

void Lemma::find_parts() {
    GiNaC::exset bound;
    for (const Relation& r : relations_) {
        bound.insert(r.generator);
        symbols_in(r.square, bound);
    }
    for (const Divisor& d : divisors_.all) {
        bound.insert(d.inverse);
        symbols_in(d.polynomial, bound);
    }
    GiNaC::exset free;
    for (const ex& side : {left_, right_}) symbols_in(side, free);
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

Combination Lemma::combination(const ex& monomial, const ex& coefficient) const {
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

} // namespace denhartog::derivation
