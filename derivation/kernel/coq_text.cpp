#include "derivation/kernel/coq_text.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

std::string digits(const numeric& n) {
    std::ostringstream out;
    out << n;
    return out.str();
}

std::string powered(const std::string& base, const numeric& exponent) {
    return exponent.is_equal(1) ? base : base + " ^ " + digits(exponent);
}

/// A product as numerator and denominator, each in factors.
struct Factors {
    std::vector<std::string> over, under;
    bool negative = false;
};

bool is_half(const ex& exponent) { return GiNaC::is_a<numeric>(exponent) && GiNaC::ex_to<numeric>(exponent).mul(2).is_integer(); }

class Printer {
public:
    explicit Printer(const CoqNames& names) : names_(names) {}

    std::string text(const ex& e) const {
        if (!GiNaC::is_a<GiNaC::add>(e)) return term(e);
        std::vector<std::pair<bool, std::string>> terms; // negative ones last
        for (const ex& part : e) {
            std::string shown = term(part);
            const bool negative = shown.starts_with("- ");
            terms.emplace_back(negative, negative ? shown.substr(2) : shown);
        }
        std::sort(terms.begin(), terms.end());
        std::string sum;
        for (const auto& [negative, shown] : terms)
            sum += (sum.empty() ? (negative ? "- " : "") : negative ? " - " : " + ") + shown;
        return sum;
    }

private:
    const CoqNames& names_;

    std::string name(const ex& symbol) const {
        const auto place = names_.names.find(symbol);
        return place != names_.names.end() ? place->second : coq_name(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name());
    }

    /// An expression as a factor or as the base of a power.
    std::string atom(const ex& e) const {
        if (GiNaC::is_a<GiNaC::symbol>(e) && !names_.inverses.contains(e)) return name(e);
        if (e.is_equal(GiNaC::Pi)) return "PI";
        if (GiNaC::is_a<numeric>(e) && GiNaC::ex_to<numeric>(e).is_nonneg_integer()) return digits(GiNaC::ex_to<numeric>(e));
        return "(" + text(e) + ")";
    }

    void take(const ex& factor, Factors& product) const {
        if (GiNaC::is_a<numeric>(factor)) {
            const numeric n = GiNaC::ex_to<numeric>(factor);
            if (!n.is_rational()) throw std::domain_error("a number that is not rational");
            if (n.is_negative()) product.negative = !product.negative;
            const numeric size = abs(n);
            if (!size.numer().is_equal(1)) product.over.insert(product.over.begin(), digits(size.numer()));
            if (!size.denom().is_equal(1)) product.under.insert(product.under.begin(), digits(size.denom()));
        } else if (const auto inverse = names_.inverses.find(factor); inverse != names_.inverses.end()) {
            product.under.push_back(inverse->second);
        } else if (GiNaC::is_a<GiNaC::power>(factor)) {
            if (!is_half(factor.op(1))) throw std::domain_error("a power that Coq has no name for");
            const numeric exponent = GiNaC::ex_to<numeric>(factor.op(1)), size = abs(exponent);
            const auto inverse_base = names_.inverses.find(factor.op(0));
            const bool inverse = inverse_base != names_.inverses.end();
            const std::string shown = !size.is_integer() ? powered("sqrt (" + text(factor.op(0)) + ")", size.mul(2))
                                      : inverse          ? powered(inverse_base->second, size)
                                                         : powered(atom(factor.op(0)), size);
            (exponent.is_negative() != inverse ? product.under : product.over).push_back(shown);
        } else if (GiNaC::is_a<GiNaC::function>(factor)) {
            std::string shown = GiNaC::ex_to<GiNaC::function>(factor).get_name();
            for (const ex& argument : factor) shown += " (" + text(argument) + ")";
            product.over.push_back(shown);
        } else {
            product.over.push_back(atom(factor));
        }
    }

    std::string term(const ex& e) const {
        Factors product;
        if (GiNaC::is_a<GiNaC::mul>(e))
            for (const ex& factor : e) take(factor, product);
        else
            take(e, product);
        const auto joined = [](std::vector<std::string> factors) {
            const auto number = [](const std::string& s) { return std::isdigit(static_cast<unsigned char>(s.front())) != 0; };
            std::sort(factors.begin(), factors.end(),
                      [&](const std::string& a, const std::string& b) { return number(a) != number(b) ? number(a) : a < b; });
            std::string all;
            for (const std::string& factor : factors) all += (all.empty() ? "" : " * ") + factor;
            return all;
        };
        std::string shown = product.over.empty() ? "1" : joined(product.over);
        if (product.under.size() == 1) shown += " / " + product.under.front();
        if (product.under.size() > 1) shown += " / (" + joined(product.under) + ")";
        return (product.negative ? "- " : "") + shown;
    }
};

} // namespace

std::string coq_name(const std::string& name) {
    // names with a meaning in Coq, and R1 for a frequency ratio beside the type R
    static const std::set<std::string> taken{"R", "S", "I", "O", "PI", "H", "as", "at", "in", "if", "let", "sin", "cos", "exp"};
    std::string plain;
    for (const char c : name) plain += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    if (taken.contains(plain)) return plain + "_";
    if (plain.size() == 2 && plain.front() == 'R' && std::isdigit(static_cast<unsigned char>(plain.back())) != 0)
        return "R_" + plain.substr(1);
    return plain;
}

std::string coq_text(const ex& e, const CoqNames& names) { return Printer(names).text(e); }

void sort_by_text(std::vector<ex>::iterator first, std::vector<ex>::iterator last) {
    const auto shown = [](const ex& e) {
        try {
            return coq_text(e);
        } catch (const std::domain_error&) {
            return std::string();
        }
    };
    std::vector<std::pair<std::string, ex>> sorted;
    std::transform(first, last, std::back_inserter(sorted), [&](const ex& e) { return std::pair(shown(e), e); });
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::transform(sorted.begin(), sorted.end(), first, [](const auto& pair) { return pair.second; });
}

std::string coq_comment(std::string sentence) {
    std::replace(sentence.begin(), sentence.end(), '"', '\'');
    for (std::size_t at = 0; at + 1 < sentence.size(); ++at)
        if ((sentence[at] == '(' && sentence[at + 1] == '*') || (sentence[at] == '*' && sentence[at + 1] == ')'))
            sentence.insert(at + 1, " ");
    return sentence;
}

} // namespace denhartog::derivation
