#include <algorithm>

#include "derivation/kernel/lemma.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

std::size_t number_of_terms(const ex& e) { return GiNaC::is_a<GiNaC::add>(e) ? e.nops() : e.is_zero() ? 0 : 1; }

} // namespace

Certificate Lemma::written(const std::string& name) const {
    Certificate c;
    c.generators = meanings_;
    c.holds = true;
    for (const Combination& part : parts_) {
        c.terms += number_of_terms(part.numerator);
        for (const auto& [place, cofactor] : part.cofactors) c.terms += number_of_terms(cofactor);
        c.holds = c.holds && part.rest.is_zero();
    }
    c.lacks =
        (left_out_.relation && std::ranges::any_of(parts_, [](const Combination& part) { return !part.cofactors.empty(); })) ||
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

std::vector<std::string> Lemma::variables() const {
    GiNaC::exset found;
    for (const ex& side : {left_, right_}) symbols_in(side, found);
    for (const Divisor& d : divisors_.all) {
        symbols_in(d.polynomial, found);
        found.erase(d.inverse);
        found.erase(d.named);
    }
    for (const Relation& r : relations_) symbols_in(r.generator + r.square, found);
    std::vector<std::string> list;
    for (const ex& x : found) list.push_back(text(x));
    std::sort(list.begin(), list.end());
    if (std::adjacent_find(list.begin(), list.end()) != list.end()) throw std::domain_error("two symbols of one name");
    for (const Divisor& d : divisors_.all)
        if (!d.plain) list.push_back(d.name);
    return list;
}

std::vector<std::string> Lemma::ranges(const std::vector<std::string>& variables) const {
    std::vector<std::string> list = ranges_of_symbols(variables);
    const auto occurs = [&](const std::string& name) { return std::ranges::find(variables, name) != variables.end(); };
    for (const std::string& name : roots_)
        if (occurs(name)) list.push_back("0 <= " + name);
    for (const std::string& name : exponentials_)
        if (occurs(name)) list.push_back("0 < " + name);
    return list;
}

std::vector<std::string> Lemma::ranges_of_symbols(const std::vector<std::string>& variables) const {
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

bool Lemma::is_left_out(const Relation& relation) const {
    if (!left_out_.relation) return false;
    std::string last;
    for (const Combination& part : parts_)
        if (!part.cofactors.empty()) last = relations_[part.cofactors.back().first].name;
    return relation.name == last;
}

std::string Lemma::statement(const std::string& name, const std::string& left, const std::string& right) const {
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

std::string Lemma::proof() const {
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
            if (!is_left_out(relations_[place]))
                out += "apply (by_relation _ _ _ (" + text(cofactor) + ") " + relations_[place].name + ").\n      ";
        out += "ring. }\n    ";
    }
    return out + "reflexivity.\nQed.\n";
}

} // namespace denhartog::derivation
