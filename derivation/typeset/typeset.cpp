#include "derivation/typeset/typeset.hpp"

#include <algorithm>
#include <cctype>
#include <set>

namespace denhartog::derivation {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// A control word or the one character after the backslash, from its backslash on.
std::string control_at(const std::string& latex, std::size_t at) {
    std::size_t end = at + 1;
    while (end < latex.size() && is_letter(latex[end])) ++end;
    return latex.substr(at, std::max<std::size_t>(end - at, 2));
}

/// The argument that starts at a place: a group without its braces, a control word or a character. The place moves behind it.
std::string argument_at(const std::string& latex, std::size_t& at) {
    while (at < latex.size() && latex[at] == ' ') ++at;
    if (at >= latex.size()) return "";
    if (latex[at] == '\\') {
        const std::string word = control_at(latex, at);
        at += word.size();
        return word;
    }
    if (latex[at] != '{') return std::string(1, latex[at++]);
    const std::size_t from = ++at;
    for (int depth = 1; at < latex.size(); ++at) {
        depth += latex[at] == '{' ? 1 : latex[at] == '}' ? -1 : 0;
        if (depth == 0) break;
    }
    const std::string group = latex.substr(from, at - from);
    at = std::min(at + 1, latex.size());
    return group;
}

const std::set<std::string>& names_of_functions() {
    static const std::set<std::string> names{"\\cos", "\\sin", "\\tan", "\\cosh", "\\sinh", "\\max", "\\lim", "\\arg", "\\angle"};
    return names;
}

const std::set<std::string>& wrappers() {
    static const std::set<std::string> names{"\\mathrm", "\\mathbf", "\\mathcal",    "\\operatorname", "\\overline", "\\bar",
                                             "\\hat",    "\\text",   "\\boldsymbol", "\\ddot",         "\\dot"};
    return names;
}

/// One formula in plain characters.
std::string plain_formula(const std::string& latex) {
    std::string plain;
    const auto word = [&plain](const std::string& text) {
        if (!plain.empty() &&
            (std::isalnum(static_cast<unsigned char>(plain.back())) || plain.back() == ')' || plain.back() == '\'') &&
            std::isalnum(static_cast<unsigned char>(text.front())))
            plain += ' ';
        plain += text;
    };
    for (std::size_t at = 0; at < latex.size();) {
        const char c = latex[at];
        if (c == '\\') {
            const std::string name = control_at(latex, at);
            at += name.size();
            if (name == "\\frac") {
                const std::string over = plain_formula(argument_at(latex, at)), under = plain_formula(argument_at(latex, at));
                const auto enclosed = [](const std::string& part) {
                    return part.find_first_of(" +-") == std::string::npos ? part : "(" + part + ")";
                };
                word(enclosed(over) + "/" + enclosed(under));
            } else if (name == "\\sqrt") {
                word("sqrt(" + plain_formula(argument_at(latex, at)) + ")");
            } else if (wrappers().contains(name)) {
                word(plain_formula(argument_at(latex, at)));
            } else if (name == "\\ne" || name == "\\neq") {
                plain += " not ";
            } else if (name == "\\le") {
                plain += " <= ";
            } else if (name == "\\ge") {
                plain += " >= ";
            } else if (name == "\\to") {
                plain += " -> ";
            } else if (name == "\\{" || name == "\\}") {
                plain += name[1];
            } else if (name == "\\sum" || names_of_functions().contains(name)) {
                word(name.substr(1));
                if (name != "\\sum" && (at >= latex.size() || (latex[at] != '(' && latex[at] != '^' && latex[at] != '\\')))
                    plain += ' ';
            } else if (name.size() > 2 && name != "\\left" && name != "\\right" && name != "\\quad" && name != "\\qquad") {
                word(name.substr(1));
            } else if (name == "\\quad" || name == "\\qquad" || name == "\\ ") {
                plain += ' ';
            }
        } else if (c == '^' || c == '_') {
            ++at;
            std::string index = plain_formula(argument_at(latex, at));
            std::erase(index, ' ');
            plain += c;
            plain += c == '^' && index.size() > 1 ? "(" + index + ")" : index;
        } else if (c == '{') {
            plain += plain_formula(argument_at(latex, at));
        } else if (is_letter(c)) {
            word(std::string(1, c));
            ++at;
        } else {
            if (c != '}') plain += c;
            ++at;
        }
    }
    return plain;
}

} // namespace

double visible_width(const std::string& latex) {
    double width = 0;
    for (std::size_t at = 0; at < latex.size();) {
        const char c = latex[at];
        if (c == '\\') {
            const std::string name = control_at(latex, at);
            at += name.size();
            if (name == "\\frac" || name == "\\tfrac") {
                const double over = visible_width(argument_at(latex, at)), under = visible_width(argument_at(latex, at));
                width += std::max(over, under);
            } else if (name == "\\quad" || name == "\\qquad") {
                width += 3;
            } else if (names_of_functions().contains(name)) {
                width += static_cast<double>(name.size()) - 1;
            } else if (!wrappers().contains(name) && name.size() > 2 && name != "\\left" && name != "\\right") {
                width += 1;
            }
        } else if (c == '^' || c == '_') {
            ++at;
            width += 0.6 * visible_width(argument_at(latex, at));
        } else {
            const bool unseen = c == '{' || c == '}' || c == ' ' || c == '&';
            width += unseen ? 0 : c == '+' || c == '-' || c == '=' ? 2 : 1;
            ++at;
        }
    }
    return width;
}

std::pair<std::string, std::string> parts_of_fraction(const std::string& latex) {
    if (!latex.starts_with("\\frac{")) return {};
    std::size_t at = 5;
    const std::string over = argument_at(latex, at), under = argument_at(latex, at);
    return at == latex.size() ? std::pair(over, under) : std::pair<std::string, std::string>();
}

std::string plain_sentence(const std::string& text) {
    std::string plain;
    bool formula = false;
    for (std::size_t at = 0; at < text.size(); formula = !formula) {
        const std::size_t end = std::min(text.find('$', at), text.size());
        const std::string part = text.substr(at, end - at);
        plain += formula ? plain_formula(part) : part;
        at = end + 1;
    }
    return plain;
}

} // namespace denhartog::derivation
