#include <algorithm>
#include <cstdlib>
#include <functional>
#include <stdexcept>

#include "derivation/kernel/lemma.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;

std::string Lemma::meant(const ex& e) const {
    CoqNames named;
    for (const auto& [generator, meaning] : meaning_) named.names[generator] = "(" + coq_text(meaning) + ")";
    return coq_text(e, named);
}

ex Lemma::replaced(const ex& e) const {
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

ex Lemma::in_roots(const ex& argument) const {
    if (GiNaC::is_a<GiNaC::power>(argument) && !argument.op(1).info(GiNaC::info_flags::integer))
        for (const auto& [generator, meaning] : identity_.generators)
            if (meaning.is_equal(GiNaC::sqrt(argument.op(0)))) return GiNaC::pow(generator, 2 * argument.op(1));
    if (!GiNaC::is_a<GiNaC::mul>(argument)) return argument;
    ex result = 1;
    for (const ex& part : argument) result *= in_roots(part);
    return result;
}

std::string Lemma::sum_of_units(const ex& argument, const std::vector<ex>& units) const {
    std::string sum;
    const ex expanded = rationalised(replaced(argument), identity_.relations).expand();
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

std::string Lemma::why_function(const ex& function, const ex& value, const std::string& inner,
                                const std::string& by_squares) const {
    if (coq_text(function) == meant(value)) return {}; // the root of a number
    std::vector<ex> angles{GiNaC::Pi / 2}, exponents;
    for (const auto& [generator, meaning] : identity_.generators) {
        if (value.is_equal(generator) && coq_text(function) == coq_text(meaning)) return {};
        if (GiNaC::is_the_function<GiNaC::cos_SERIAL>(meaning)) angles.push_back(meaning.op(0));
        if (GiNaC::is_the_function<GiNaC::exp_SERIAL>(meaning)) exponents.push_back(meaning.op(0));
    }
    if (GiNaC::is_a<GiNaC::power>(function))
        return "apply root_is; [not_negative | " + inner + by_squares + "]";
    const bool circular =
        GiNaC::is_the_function<GiNaC::sin_SERIAL>(function) || GiNaC::is_the_function<GiNaC::cos_SERIAL>(function);
    return "transitivity (" + GiNaC::ex_to<GiNaC::function>(function).get_name() + " (" +
           sum_of_units(function.op(0), circular ? angles : exponents) + ")); [f_equal; " + inner + by_squares + " | " +
           (circular ? "addition]" : "unfold sinh, cosh; exponents]");
}

void Lemma::collect_divided(const ex& e, std::map<std::string, ex>& found) {
    if (GiNaC::is_a<GiNaC::power>(e) && GiNaC::is_a<numeric>(e.op(1)) && GiNaC::ex_to<numeric>(e.op(1)).is_negative()) {
        const ex base = e.op(1).info(GiNaC::info_flags::integer) ? e.op(0) : ex(GiNaC::sqrt(e.op(0)));
        found.emplace(coq_text(base), base);
    }
    for (const ex& part : e) collect_divided(part, found);
}

bool Lemma::follows(const Divisor& divisor, const std::map<std::string, ex>& divided) const {
    for (const auto& [shown, base] : divided) {
        Divisors own;
        const ex polynomial = own.with_polynomials(own.cleared(own.without_quotients(replaced(base)).expand()).first);
        if (GiNaC::is_a<numeric>((polynomial / divisor.polynomial).normal())) return true;
    }
    return false;
}

bool Lemma::occurs(const ex& function) const {
    const std::function<bool(const ex&)> stands_in = [&](const ex& e) {
        if (e.is_equal(function)) return true;
        const bool root = GiNaC::is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::integer);
        if (root && GiNaC::sqrt(e.op(0)).is_equal(function)) return true;
        return std::any_of(e.begin(), e.end(), stands_in);
    };
    return stands_in(identity_.left) || stands_in(identity_.right);
}

std::string Lemma::assert_squares(std::string& out) const {
    std::string known;
    int number = 0;
    for (const auto& [generator, meaning] : identity_.generators) {
        if (!GiNaC::is_a<GiNaC::power>(meaning)) continue;
        const std::string square = "square_" + std::to_string(++number), under = coq_text(meaning.op(0));
        out += "  assert (" + square + " : sqrt (" + under + ") ^ 2 = " + under + ") by (apply root_squared; assumption).\n";
        known += (known.empty() ? "" : " ") + square;
        const auto divides = [&g = generator](const auto& function) { return function.second.normal().denom().has(g); };
        if (std::any_of(identity_.functions.begin(), identity_.functions.end(), divides)) // not zero, where the ranges say so
            out += "  try (assert (sqrt (" + under + ") <> 0) by (apply Rgt_not_eq, sqrt_lt_R0; lra)).\n";
    }
    return known.empty() ? "field; nonzero" : "field [" + known + "]; nonzero";
}

std::string Lemma::in_functions(const std::string& name) const {
    for (const auto& [generator, meaning] : identity_.generators)
        if (GiNaC::is_the_function<GiNaC::atan2_SERIAL>(meaning)) throw std::domain_error("the angle of a point");
    GiNaC::exset symbols_there;
    for (const ex& side : {identity_.left, identity_.right}) symbols_in(side, symbols_there);
    for (const auto& [generator, meaning] : identity_.generators) symbols_in(meaning, symbols_there);
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
    for (const Divisor& d : divisors_.all) symbols_in(d.polynomial.subs(meaning_), symbols_there);
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
    const std::string by_squares = assert_squares(out);
    for (const auto& [function, value] : identity_.functions) {
        if (!occurs(function)) continue;
        const std::string why = why_function(function, value, inner, by_squares);
        if (why.empty()) continue;
        if (GiNaC::is_a<GiNaC::power>(function)) inner += "rewrite ?function_" + std::to_string(rewritten.size() + 1) + " in *; ";
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
            out += "  assert (" + (r.scale.is_equal(1) ? "" : text(r.scale) + " * ") + coq_text(meaning) +
                   " ^ 2 = " + meant((r.scale * r.square).expand()) + ") by (rewrite (root_squared (" + coq_text(meaning.op(0)) +
                   ")) by assumption; ring).\n";
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
        const auto divisor = std::find_if(divisors_.all.begin(), divisors_.all.end(),
                                          [&variable](const Divisor& d) { return !d.plain && d.name == variable; });
        out += " " + (divisor == divisors_.all.end() ? variable : "(" + divisor->text + ")");
    }
    return out + "); first [reflexivity | assumption | lra | not_zero].\n  - same_side.\n  - same_side.\nQed.\n";
}

} // namespace denhartog::derivation
