#include "text.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>
#include <set>

#include "denhartog/ledger/ledger_entry.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog::pages {

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

const std::set<std::string> greek = {"alpha", "beta", "gamma", "delta", "zeta",  "eta",   "theta", "kappa", "mu",
                                     "pi",    "phi",  "psi",   "tau",   "omega", "Omega", "Sigma", "Psi"};

/// How a base letter with a subscript is written in the paper.
const std::map<std::string, std::string> bases = {
    {"X", "\\overline{X}"}, {"x", "\\bar{x}"}, {"K", "\\overline{K}"}, {"C", "\\overline{C}"}, {"M", "\\overline{M}"}};

/// Letters whose subscript has a d before it in the paper: V_dj, U_dj, S_dj, v_di, u_di, s_di.
const std::string with_d = "VUSvus";

std::string subscripted(const std::string& base, std::string below) {
    std::string part;
    const bool parted = (base == "V" || base == "v") && below.size() == 2 && (below.back() == 'r' || below.back() == 'i');
    if (parted && below.front() != 'd') { // V_jr, V_ji: real and imaginary part
        part = below.back() == 'r' ? "\\mathrm{Re}\\," : "\\mathrm{Im}\\,";
        below.pop_back();
    } else if (base == "v" && below.size() > 1 && (below.front() == 'r' || below.front() == 'i')) { // v_r1, v_i1
        part = below.front() == 'r' ? "\\mathrm{Re}\\," : "\\mathrm{Im}\\,";
        below.erase(0, 1);
    }
    if (base.size() == 1 && with_d.find(base) != std::string::npos && !below.starts_with("d")) below = "d" + below;
    const auto found = bases.find(base);
    const std::string letter = found != bases.end() ? found->second : greek.contains(base) ? "\\" + base : base;
    return part + letter + "_{" + (below == "lim" ? "\\lim" : below) + "}";
}

bool known_base(const std::string& base) { return greek.contains(base) || base.size() == 1; }

/// Whether a bracketed number at a place is that of an equation: its end, or npos.
std::size_t end_of_number(const std::string& text, std::size_t open, std::string& equation) {
    if (open > 0 && (is_word(text[open - 1]) || text[open - 1] == '\\')) return std::string::npos;
    const std::size_t close = text.find(')', open);
    if (close == std::string::npos || close > open + 5) return std::string::npos;
    const auto number = ledger::equation_number(text.substr(open + 1, close - open - 1));
    if (!number || *number != text.substr(open + 1, close - open - 1)) return std::string::npos;
    equation = *number;
    return close + 1;
}

/// The word that starts at a place, with dots, slashes and colons within it: a path or a qualified name is no symbol.
std::string chunk_at(const std::string& text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && is_word(text[end])) ++end;
    return text.substr(at, end - at);
}

/// Where a number that follows an equals sign ends; `at` where there is none.
std::size_t end_of_value(const std::string& text, std::size_t at) {
    if (at + 1 >= text.size() || text[at] != '=' || !std::isdigit(static_cast<unsigned char>(text[at + 1]))) return at;
    std::size_t end = at + 1;
    while (end < text.size() && (std::isdigit(static_cast<unsigned char>(text[end])) || text[end] == '.')) ++end;
    return text[end - 1] == '.' ? end - 1 : end; // a full stop
}

/// The formula that starts at a word: a symbol, with its primes and its value, or a function of a symbol. Empty where the word is
/// no symbol.
/// @param end  becomes the end of the formula, or of the word
std::string formula_at(const std::string& text, std::size_t at, std::size_t& end) {
    static const std::set<std::string> functions = {"sin", "cos", "sinh", "cosh", "exp"};
    const std::string word = chunk_at(text, at);
    end = at + word.size();
    if (functions.contains(word) && end < text.size() && text[end] == '(') {
        const std::string argument = chunk_at(text, end + 1);
        const std::size_t close = end + 1 + argument.size();
        const std::string inner = symbol(argument, false);
        if (inner.empty() || close >= text.size() || text[close] != ')') return {};
        end = close + 1;
        return "\\" + word + "(" + inner + ")";
    }
    const bool over_one = at > 1 && text.compare(at - 2, 2, "1/") == 0 && (at == 2 || !is_word(text[at - 3]));
    const bool path = (at > 0 && std::string("./:`#").find(text[at - 1]) != std::string::npos &&
                       text.compare(at, 5, "r_n,i") != 0 && !over_one) ||
                      (end < text.size() && std::string("(:*`").find(text[end]) != std::string::npos) ||
                      (end + 1 < text.size() && text[end] == '.' && is_word(text[end + 1]));
    if (path) return {};
    std::string latex = symbol(word, false);
    if (word == "r_n" && text.compare(end, 2, ",i") == 0) {
        end += 2;
        return "r_{n,i}";
    }
    const std::size_t value = end_of_value(text, end);
    if (latex.empty() && !(word.size() == 1 && value > end && std::isalpha(static_cast<unsigned char>(word[0])))) return {};
    if (latex.empty()) latex = word;
    while (end < text.size() && text[end] == '\'' && word.find('_') != std::string::npos) {
        latex += "'";
        ++end;
    }
    if (value > end) {
        latex += text.substr(end, value - end);
        end = value;
    }
    return latex;
}

} // namespace

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (std::string("\\@$#%\"<>&").find(c) != std::string::npos)
            out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string("\\") + c;
        else if (std::string("*_`[]").find(c) != std::string::npos)
            out += std::string("\\") + c;
        else
            out += c;
    }
    return out;
}

std::string html(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    return out;
}

std::string formula(const std::string& latex) { return "\\f$" + latex + "\\f$"; }

std::string displayed(const std::string& latex) { return "\n\\f[ " + latex + " \\f]\n"; }

std::string label(const std::string& kind, const std::string& name) {
    std::string text = kind + "_" + name;
    for (char& c : text)
        if (!is_word(c)) c = '_';
    return text;
}

std::string equation_label(const std::string& equation) { return label("eq", equation); }

std::string equation_link(const std::string& equation) { return "\\ref " + equation_label(equation) + " \"(" + equation + ")\""; }

std::string source_link(const std::string& file, int line, const std::string& shown) {
    return "<a href=\"source:" + file + ":" + std::to_string(line) + "\">" + escaped(shown) + "</a>";
}

std::string symbol(const std::string& name, bool alone) {
    if (greek.contains(name)) return "\\" + name;
    if (alone && name.size() == 1) return bases.contains(name) && name != "N" ? bases.at(name) : name;
    if (alone && name.size() == 2 && name[0] == 'P' && std::isupper(static_cast<unsigned char>(name[1])))
        return std::string("\\mathcal{") + name[1] + "}"; // PA to PR: the coefficients of (A.10)
    const std::size_t bar = name.find('_');
    if (bar == std::string::npos) { // R1, zeta1
        std::size_t end = name.size();
        while (end > 0 && std::isdigit(static_cast<unsigned char>(name[end - 1]))) --end;
        if (end == 0 || end == name.size() || !(alone || greek.contains(name.substr(0, end)))) return {};
        return known_base(name.substr(0, end)) ? subscripted(name.substr(0, end), name.substr(end)) : "";
    }
    const std::string base = name.substr(0, bar);
    std::string below = name.substr(bar + 1);
    if (base.empty() || below.empty() || !known_base(base)) return {};
    if (below.starts_with("prime_")) return subscripted(base, below.substr(6)) + "'";
    if (below.ends_with("_abs")) return "|" + subscripted(base, below.substr(0, below.size() - 4)) + "|";
    if (base == "cos" || below.find('_') != std::string::npos || below.size() > 3) return {};
    return subscripted(base, below);
}

std::string prose(const std::string& text) {
    std::string out, plain;
    const auto flush = [&] {
        out += escaped(plain);
        plain.clear();
    };
    for (std::size_t at = 0; at < text.size();) {
        std::string equation;
        if (text[at] == '(') {
            const std::size_t end = end_of_number(text, at, equation);
            if (end != std::string::npos) {
                flush();
                out += equation_link(equation);
                at = end;
                continue;
            }
        }
        if (text.compare(at, 2, "<=") == 0 || text.compare(at, 2, ">=") == 0 || text.compare(at, 2, "->") == 0) {
            plain += text[at] == '<' ? "≤" : text[at] == '>' ? "≥" : "→";
            at += 2;
            continue;
        }
        if (!is_word(text[at])) {
            plain += text[at++];
            continue;
        }
        std::size_t end = at;
        const std::string latex = formula_at(text, at, end);
        if (latex.empty()) {
            plain += text.substr(at, end - at);
        } else {
            flush();
            out += formula(latex);
        }
        at = end;
    }
    flush();
    return out;
}

std::string typeset(const std::string& text, const std::string& place) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t next = text.find_first_of("$`", at);
        out += prose(text.substr(at, next - at));
        if (next == std::string::npos) break;
        const std::size_t close = text.find(text[next], next + 1);
        if (close == std::string::npos) throw InputError("a formula or code", "must be closed", text.substr(next, 40), place);
        const std::string inner = text.substr(next + 1, close - next - 1);
        out += text[next] == '$' ? formula(inner) : "<code>" + escaped(inner) + "</code>";
        at = close + 1;
    }
    return out;
}

std::string sentence(std::string note) {
    if (note.size() > 1 && std::islower(static_cast<unsigned char>(note[0])) && symbol(chunk_at(note, 0), true).empty())
        note.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(note.front())));
    return prose(note) + (note.ends_with('.') ? "" : ".");
}

std::string witness_name(const std::string& name) {
    const std::string latex = symbol(name, true);
    return latex.empty() ? prose(name) : formula(latex);
}

std::string witness_value(const std::string& value) {
    const std::size_t slash = value.find('/');
    const auto is_integer = [](const std::string& text, bool sign) {
        const std::size_t from = sign && text.starts_with("-") ? 1 : 0;
        return text.size() > from && std::all_of(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(),
                                                 [](unsigned char c) { return std::isdigit(c) != 0; });
    };
    if (slash != std::string::npos && is_integer(value.substr(0, slash), true) && is_integer(value.substr(slash + 1), false)) {
        const bool minus = value.front() == '-';
        return formula((minus ? "-" : "") + ("\\tfrac{" + value.substr(minus, slash - minus) + "}{" + value.substr(slash + 1)) +
                       "}");
    }
    const bool decimal = value.find_first_not_of("0123456789.-") == std::string::npos;
    if (decimal && value.size() > 24) return escaped(value.substr(0, 22)) + "…";
    return prose(value);
}

std::string digits(double x, const char* format) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, format, x);
    return buffer;
}

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

} // namespace denhartog::pages
