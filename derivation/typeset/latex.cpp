#include "derivation/typeset/latex.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

#include "derivation/typeset/typeset.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

/// A factor of a term: where it stands, what it is a power of.
struct Factor {
    int rank = 0;
    std::string base; // LaTeX of the base, or of an argument where the factor is a function
    std::string name; // of a function: \cos, ...; e for an exponential
    numeric exponent = 1;
    bool sum = false;
    ex expression = 0; // of a sum
};

enum Rank { number_pi = 5, mode_group = 46, other_symbol = 60, root = 100, exponential = 180, sum = 200, function = 310 };

/// Where the paper puts a symbol among the factors of a term.
int rank_of_symbol(const std::string& name) {
    static const std::map<std::string, int> ranks{
        {"psi_ki", 10},     {"psi_k", 10}, {"psi_ji", 11},     {"psi_j", 11}, {"psi_li", 12}, {"psi_l", 12},
        {"mu", 14},         {"gamma", 15}, {"r", 16},          {"m_i", 17},   {"m_", 17},     {"k_i", 18},
        {"k_", 18},         {"omega", 18}, {"R", 20},          {"zeta", 19},  {"w", 24},      {"wi", 24},
        {"u", 26},          {"g", 28},     {"v_cos", 29},      {"v_sin", 29}, {"beta", 30},   {"A", 32},
        {"B", 33},          {"V_kr", 34},  {"V_ki", 35},       {"V_jr", 36},  {"V_ji", 37},   {"U_j", 38},
        {"U_k", 39},        {"G_j", 40},   {"G_k", 41},        {"eta_0", 70}, {"eta_", 70},   {"eta_prime_0", 71},
        {"eta_prime_", 71}, {"x_k0", 70},  {"x_prime_k0", 71}, {"X", 69},     {"tau", 45},    {"c_phi", 330},
        {"s_phi", 331}};
    std::string base = name;
    const auto exact = ranks.find(base);
    if (exact != ranks.end()) return exact->second;
    while (!base.empty() && std::isdigit(static_cast<unsigned char>(base.back()))) base.pop_back();
    const auto place = ranks.find(base);
    return place != ranks.end() ? place->second : other_symbol;
}

std::string printed(const ex& e) {
    std::ostringstream out;
    out << GiNaC::latex << e;
    return out.str();
}

bool is_function(const ex& e, unsigned serial) {
    return GiNaC::is_a<GiNaC::function>(e) && GiNaC::ex_to<GiNaC::function>(e).get_serial() == serial;
}

std::string bracketed(const std::string& text) { return "\\left(" + text + "\\right)"; }

/// Term of a sum with what decides its place.
struct OrderedTerm {
    LatexTerm term;
    bool negative = false; // before a difference was turned round
    std::vector<std::tuple<int, std::string, numeric>> order;
};

OrderedTerm ordered_term(const ex& e);

const std::vector<OrderedTerm>& ordered_terms(const ex& e) {
    static std::map<ex, std::vector<OrderedTerm>, GiNaC::ex_is_less> known; // what stands in a sum is asked for again and again
    if (const auto place = known.find(e); place != known.end()) return place->second;
    std::vector<OrderedTerm> terms;
    if (GiNaC::is_a<GiNaC::add>(e))
        for (const ex& part : e) terms.push_back(ordered_term(part));
    else
        terms.push_back(ordered_term(e));
    std::sort(terms.begin(), terms.end(), [](const OrderedTerm& a, const OrderedTerm& b) {
        for (std::size_t i = 0; i < std::min(a.order.size(), b.order.size()); ++i) {
            const auto& [rank_a, text_a, power_a] = a.order[i];
            const auto& [rank_b, text_b, power_b] = b.order[i];
            if (rank_a != rank_b) return rank_a < rank_b;
            if (text_a != text_b) return text_a < text_b;
            if (power_a != power_b) return power_a < power_b;
        }
        if (a.order.size() != b.order.size()) return a.order.size() < b.order.size();
        return std::tie(a.term.latex, a.negative) < std::tie(b.term.latex, b.negative);
    });
    return known.emplace(e, std::move(terms)).first->second;
}

/// A sum in which the first term is not negative, and the factor that was taken out for it.
std::pair<ex, numeric> primitive(const ex& e) {
    numeric content = e.integer_content();
    if (ordered_terms(e).front().negative) content = -content;
    ex divided = 0;
    for (const ex& term : e) divided += term / content;
    return {divided, content};
}

std::string argument(const ex& e) {
    const std::vector<LatexTerm> terms = latex_terms(e);
    const std::string text = latex_line(e);
    return terms.size() == 1 && !terms.front().negative ? text : bracketed(text);
}

/// An exponent in one line: zeta tau/R.
std::string inline_quotient(const ex& e) {
    std::string text;
    for (const LatexTerm& term : latex_terms(e)) {
        std::string line = term.latex;
        if (line.starts_with("\\frac{")) {
            const auto [over, under] = parts_of_fraction(line);
            if (!under.empty()) line = over + "/" + (visible_width(under) > 2.5 ? "(" + under + ")" : under);
        }
        text = joined(text + (term.negative ? "-" : text.empty() ? "" : "+"), line);
    }
    return text;
}

Factor factor_of(const ex& base, const numeric& exponent) {
    Factor f;
    f.exponent = exponent;
    static const std::vector<std::pair<unsigned, std::string>> named{{GiNaC::cosh_SERIAL::serial, "\\cosh"},
                                                                     {GiNaC::sinh_SERIAL::serial, "\\sinh"},
                                                                     {GiNaC::cos_SERIAL::serial, "\\cos"},
                                                                     {GiNaC::sin_SERIAL::serial, "\\sin"},
                                                                     {GiNaC::tan_SERIAL::serial, "\\tan"}};
    if (GiNaC::is_a<GiNaC::symbol>(base)) {
        f.base = printed(base);
        f.rank = rank_of_symbol(GiNaC::ex_to<GiNaC::symbol>(base).get_name());
        if (f.base.find("(\\tau)") != std::string::npos || f.base.find("(\\pi)") != std::string::npos) f.rank = mode_group;
    } else if (is_function(base, GiNaC::exp_SERIAL::serial)) {
        f.rank = exponential;
        f.name = "e";
        f.base = inline_quotient(base.op(0) * exponent);
    } else if (is_function(base, GiNaC::atan2_SERIAL::serial)) {
        f.rank = root;
        f.base = "\\operatorname{atan2}" + bracketed(latex_line(base.op(0)) + ",\\," + latex_line(base.op(1)));
    } else if (is_function(base, GiNaC::abs_SERIAL::serial)) {
        f.rank = root;
        f.base = "\\left|" + latex_line(base.op(0)) + "\\right|";
    } else if (GiNaC::is_a<GiNaC::add>(base)) {
        f.rank = exponent.is_integer() ? sum : root;
        f.base = latex_line(base);
        f.sum = true;
        f.expression = base;
    } else {
        f.rank = base.is_equal(GiNaC::Pi) ? number_pi : root;
        for (std::size_t i = 0; i < named.size(); ++i)
            if (is_function(base, named[i].first)) {
                f.rank = function + 10 * static_cast<int>(i);
                f.name = named[i].second;
                f.base = argument(base.op(0));
            }
        if (f.name.empty()) {
            f.sum = GiNaC::is_a<GiNaC::mul>(base) || GiNaC::is_a<GiNaC::power>(base);
            f.base = f.sum ? latex_line(base) : printed(base);
        }
    }
    return f;
}

/// A factor raised to a positive power.
std::string power_of(const Factor& f, const numeric& exponent, bool alone) {
    if (f.name == "e") return "e^{" + f.base + "}";
    if (exponent == numeric(1, 2)) return "\\sqrt{" + f.base + "}";
    std::ostringstream raised;
    raised << exponent;
    const std::string n = exponent == 1 ? "" : raised.str().size() == 1 ? "^" + raised.str() : "^{" + raised.str() + "}";
    if (!f.name.empty()) return joined(f.name + n, f.base);
    if (f.sum) return alone && n.empty() ? f.base : bracketed(f.base) + n;
    if (n.empty()) return f.base;
    for (const std::string name : {"\\cos", "\\sin"})
        if (f.base.starts_with(name)) return joined(name + n, f.base.substr(name.size()));
    if (f.base.starts_with("\\sqrt{") && exponent == 2) return f.base.substr(6, f.base.size() - 7);
    if (f.base.find('\'') != std::string::npos) return "{" + f.base + "}" + n;
    if (f.base.starts_with("\\mathrm{Re}") || f.base.starts_with("\\mathrm{Im}")) return bracketed(f.base) + n;
    const std::size_t of = f.base.find("(\\");
    if (f.rank == mode_group && of != std::string::npos) return f.base.substr(0, of) + n + f.base.substr(of);
    return f.base + n;
}

std::string product_of(const std::vector<Factor>& factors, const numeric& number) {
    std::string text;
    if (number != 1 || factors.empty()) {
        std::ostringstream out;
        out << number;
        text = out.str();
    }
    for (const Factor& f : factors) text = joined(text, power_of(f, abs(f.exponent), factors.size() == 1 && text.empty()));
    return text;
}

/// Turns a difference in a negative term round, so that the term is added: - (a - b) is (b - a). A number stays in front.
bool turned(std::vector<Factor>& factors) {
    for (Factor& f : factors) {
        if (f.expression.is_zero() || !f.exponent.is_odd()) continue;
        bool number = false;
        for (const ex& term : f.expression) number = number || GiNaC::is_a<numeric>(term);
        const auto negative = [](const LatexTerm& term) { return term.negative; };
        const std::vector<LatexTerm> terms = latex_terms(f.expression), other = latex_terms(-f.expression);
        if (number || (std::none_of(terms.begin(), terms.end(), negative) && std::any_of(other.begin(), other.end(), negative)))
            continue;
        f.expression = -f.expression;
        f.base = latex_line(f.expression);
        return true;
    }
    return false;
}

OrderedTerm ordered_term(const ex& e) {
    numeric coefficient(1);
    std::vector<Factor> over, under;
    const auto take = [&](ex base, numeric exponent) {
        if (GiNaC::is_a<numeric>(base) && exponent == 1) {
            coefficient *= GiNaC::ex_to<numeric>(base);
            return;
        }
        if (GiNaC::is_a<GiNaC::add>(base) && exponent.is_integer()) {
            const auto [without, content] = primitive(base);
            base = without;
            coefficient *= content.power(exponent);
        }
        const Factor f = factor_of(base, exponent);
        (exponent.is_negative() && f.name != "e" ? under : over).push_back(f);
    };
    const auto take_power = [&](const ex& part) {
        const bool plain = GiNaC::is_a<GiNaC::power>(part) && GiNaC::is_a<numeric>(part.op(1));
        take(plain ? part.op(0) : part, plain ? GiNaC::ex_to<numeric>(part.op(1)) : numeric(1));
    };
    if (GiNaC::is_a<GiNaC::mul>(e))
        for (const ex& part : e) take_power(part);
    else
        take_power(e);
    for (auto* factors : {&over, &under})
        std::sort(factors->begin(), factors->end(), [](const Factor& a, const Factor& b) {
            return std::tie(a.rank, a.name, a.base) < std::tie(b.rank, b.name, b.base);
        });
    OrderedTerm result;
    const bool is_real = coefficient.is_real();
    const bool negative = is_real && coefficient.is_negative();
    const numeric size = negative ? -coefficient : coefficient;
    int first = 100;
    for (const Factor& f : over) first = f.rank >= 69 && f.rank < 80 ? f.rank - 69 : first;
    if (!over.empty() || !under.empty()) result.order.emplace_back(first, "", numeric(0));
    for (const auto* factors : {&over, &under})
        for (const Factor& f : *factors) result.order.emplace_back(f.rank, f.name + f.base, f.exponent);
    result.negative = negative;
    result.term.negative = negative && !turned(over);
    const numeric whole_over = is_real ? size.numer() : size, whole_under = is_real ? size.denom() : numeric(1);
    const std::string numerator = product_of(over, whole_over), denominator = product_of(under, whole_under);
    result.term.latex = denominator == "1" ? numerator : "\\frac{" + numerator + "}{" + denominator + "}";
    return result;
}

/// Visible characters of a line.
constexpr double line_width = 88;

} // namespace

std::string joined(const std::string& a, const std::string& b) {
    if (a.empty() || b.empty()) return a + b;
    std::size_t word = a.size();
    while (word > 0 && std::isalpha(static_cast<unsigned char>(a[word - 1]))) --word;
    const bool control = word > 0 && word < a.size() && a[word - 1] == '\\';
    return control && std::isalpha(static_cast<unsigned char>(b.front())) ? a + " " + b : a + b;
}

std::vector<LatexTerm> latex_terms(const ex& e) {
    std::vector<LatexTerm> terms;
    for (const OrderedTerm& term : ordered_terms(e)) terms.push_back(term.term);
    const auto positive = std::find_if(terms.begin(), terms.end(), [](const LatexTerm& t) { return !t.negative; });
    if (positive != terms.end()) std::rotate(terms.begin(), positive, positive + 1);
    return terms;
}

std::string latex_line(const ex& e) {
    std::string text;
    for (const LatexTerm& term : latex_terms(e))
        text = joined(text + (term.negative ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ")), term.latex);
    return text;
}

std::string latex_equation(const std::string& left, const ex& e) {
    const std::string line = latex_line(e);
    const std::vector<LatexTerm> terms = latex_terms(e);
    if (visible_width(left) + visible_width(line) < line_width || terms.size() < 2) return left + " = " + line;
    std::string text = "\\begin{aligned} " + left + " ={}& ";
    double width = visible_width(left) + 2;
    bool first = true;
    for (const LatexTerm& term : terms) {
        const double more = visible_width(term.latex) + 2;
        if (!first && width + more > line_width) {
            text += " \\\\ &";
            width = visible_width(left) + 2;
        }
        text += term.negative ? " - " : first ? "" : " + ";
        text = joined(text, term.latex);
        width += more;
        first = false;
    }
    return text + " \\end{aligned}";
}

} // namespace denhartog::derivation
