#include "derivation/offers/written.hpp"

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <set>

namespace denhartog::offers {

namespace {

using Node = std::shared_ptr<const Operation>;

bool is_operator(const std::string& name) { return name == "+" || name == "-" || name == "*" || name == "/" || name == "neg"; }

int strength(const Node& node) {
    if (node->on.empty()) return 9;
    if (node->name == "+" || node->name == "-") return 1;
    if (node->name == "neg") return 2;
    return node->name == "*" || node->name == "/" ? 3 : 9;
}

bool is_integer(const Node& node) {
    return node->on.empty() &&
           std::all_of(node->name.begin(), node->name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// What the paper, or the notation page, calls a computation that is needed twice.
std::string known_name(const std::string& key) {
    static const std::map<std::string, std::string> names = {{"sqrt((1-(zeta*zeta)))", "w"},
                                                             {"((pi*sqrt((1-(zeta*zeta))))/R)", "theta"},
                                                             {"((pi*zeta)/R)", "delta"},
                                                             {"(pi*zeta)", "delta"},
                                                             {"(1/R)", "Omega"}};
    const auto found = names.find(key);
    return found == names.end() ? "" : found->second;
}

/// Writes one formula in one language.
class Writer {
public:
    Writer(const WrittenFormula& formula, Language language) : formula_(formula), language_(language) {
        for (const Written& result : formula.results) count(result.operation(), "");
        for (const std::string& argument : formula.arguments) taken_.insert(argument);
    }

    [[nodiscard]] std::string function() {
        std::vector<std::string> results;
        for (const Written& result : formula_.results) results.push_back(text(result.operation()));
        return head() + body_ + tail(results);
    }

private:
    /// How often a computation is needed; what stands within a sum over the modes stays there.
    void count(const Node& node, const std::string& sum) {
        if (node->on.empty()) return;
        if (++uses_[sum + node->key] > 1) return;
        const bool loop = node->name == "sum" && writes_loops();
        for (const Node& each : node->on) count(each, loop ? "in " + node->key + ": " : sum);
    }

    [[nodiscard]] bool elementwise() const { return language_ == Language::matlab; }
    [[nodiscard]] bool writes_loops() const { return language_ == Language::cxx || language_ == Language::javascript; }

    std::string text(const Node& node) {
        if (node->on.empty()) return leaf(node);
        const auto named = names_.find(scope_ + node->key);
        if (named != names_.end()) return named->second;
        const std::string line = computed(node);
        const bool trivial = node->name == "neg" && node->on[0]->on.empty();
        if (trivial || uses_[scope_ + node->key] < 2) return line;
        std::string name = known_name(node->key);
        for (int n = 1; name.empty() || taken_.contains(name); ++n) name = "t" + std::to_string(n);
        taken_.insert(name);
        names_[scope_ + node->key] = name;
        body_ += assignment(name, line);
        return name;
    }

    std::string leaf(const Node& node) const {
        if (node->name == "pi") {
            if (language_ == Language::cxx) return "std::numbers::pi";
            return language_ == Language::python ? "np.pi" : language_ == Language::matlab ? "pi" : "Math.PI";
        }
        const bool of_modes =
            std::find(formula_.of_modes.begin(), formula_.of_modes.end(), node->name) != formula_.of_modes.end();
        return of_modes && !scope_.empty() ? node->name + "[i]" : node->name;
    }

    std::string computed(const Node& node) {
        const std::string& name = node->name;
        if (name == "sum") return sum(node);
        if (!is_operator(name)) {
            std::string out = function_name(name) + "(";
            for (std::size_t i = 0; i < node->on.size(); ++i) out += (i > 0 ? ", " : "") + text(node->on[i]);
            return out + ")";
        }
        if (name == "neg") {
            const std::string of = text(node->on[0]);
            return "-" + (shown_strength(node->on[0]) < 3 ? "(" + of + ")" : of);
        }
        const Node &a = node->on[0], &b = node->on[1];
        std::string left = text(a), right = text(b);
        const bool signed_factor = a->name == "neg" && strength(node) == 3;
        if (shown_strength(a) < strength(node) && !signed_factor) left = "(" + left + ")";
        const bool after = name == "-" || name == "/";
        if (shown_strength(b) < strength(node) || (after && shown_strength(b) == strength(node)) ||
            (name == "*" && b->name == "/" && shown_strength(b) == 3))
            right = "(" + right + ")";
        if (language_ == Language::cxx && name == "/" && is_integer(a) && is_integer(b)) left += ".0";
        const bool dotted = elementwise() && (name == "*" || name == "/");
        return left + " " + (dotted ? "." : "") + name + " " + right;
    }

    /// A computation with a name stands there as a name.
    [[nodiscard]] int shown_strength(const Node& node) const { return names_.contains(scope_ + node->key) ? 9 : strength(node); }

    std::string function_name(const std::string& name) const {
        if (language_ == Language::cxx) return "std::" + name;
        if (language_ == Language::python) return "np." + (name == "atan2" ? "arctan2" : name);
        return language_ == Language::matlab ? name : "Math." + name;
    }

    /// A sum over the modes: of an array, or in a loop with names of its own.
    std::string sum(const Node& node) {
        if (!writes_loops()) return (language_ == Language::python ? "np.sum(" : "sum(") + text(node->on[0]) + ")";
        std::string name = "sum";
        for (int n = 2; taken_.contains(name); ++n) name = "sum_" + std::to_string(n);
        taken_.insert(name);
        const std::string before = body_, outside = scope_, first = first_of_modes(node);
        body_.clear();
        scope_ = "in " + node->key + ": ";
        std::string term = text(node->on[0]), lines;
        scope_ = outside;
        for (std::size_t at = 0; at < body_.size();) {
            const std::size_t end = body_.find('\n', at) + 1;
            lines += "    " + body_.substr(at, end - at);
            at = end;
        }
        const bool cxx = language_ == Language::cxx;
        body_ = before + (cxx ? "    double " : "    let ") + name + " = 0;\n    for (" + (cxx ? "std::size_t" : "let") +
                " i = 0; i < " + first + (cxx ? ".size()" : ".length") + "; ++i) {\n" + lines + "        " + name +
                " += " + term + ";\n    }\n";
        return name;
    }

    std::string first_of_modes(const Node& node) const {
        for (const std::string& name : formula_.of_modes)
            if (node->key.find(name) != std::string::npos) return name;
        return formula_.of_modes.empty() ? "" : formula_.of_modes.front();
    }

    std::string assignment(const std::string& name, const std::string& line) const {
        if (language_ == Language::cxx) return "    const double " + name + " = " + line + ";\n";
        if (language_ == Language::javascript) return "    const " + name + " = " + line + ";\n";
        return "    " + name + " = " + line + (language_ == Language::matlab ? ";\n" : "\n");
    }

    [[nodiscard]] std::string head() const {
        std::string arguments;
        for (const std::string& argument : formula_.arguments) {
            const bool of_modes =
                std::find(formula_.of_modes.begin(), formula_.of_modes.end(), argument) != formula_.of_modes.end();
            arguments += (arguments.empty() ? "" : ", ") +
                         (language_ != Language::cxx ? "" : std::string(of_modes ? "const std::vector<double>& " : "double ")) +
                         argument;
        }
        const bool pair = formula_.results.size() > 1;
        const std::string call = formula_.name + "(" + arguments + ")";
        if (language_ == Language::cxx) return (pair ? "std::complex<double> " : "double ") + call + " {\n";
        if (language_ == Language::python) return "def " + call + ":\n";
        return language_ == Language::matlab ? "function y = " + call + "\n" : "function " + call + " {\n";
    }

    [[nodiscard]] std::string tail(const std::vector<std::string>& results) const {
        const bool pair = results.size() > 1;
        if (language_ == Language::cxx)
            return "    return " + (pair ? "{" + results[0] + ", " + results[1] + "}" : results[0]) + ";\n}\n";
        if (language_ == Language::python)
            return "    return " + (pair ? results[0] + " + 1j * (" + results[1] + ")" : results[0]) + "\n";
        if (language_ == Language::matlab)
            return "    y = " + (pair ? "complex(" + results[0] + ", " + results[1] + ")" : results[0]) + ";\nend\n";
        return "    return " + (pair ? "[" + results[0] + ", " + results[1] + "]" : results[0]) + ";\n}\n";
    }

    const WrittenFormula& formula_;
    Language language_;
    std::map<std::string, int> uses_;
    std::map<std::string, std::string> names_;
    std::set<std::string> taken_;
    std::string body_, scope_;
};

} // namespace

Written::Written(int n) {
    const std::string text = std::to_string(n < 0 ? -n : n);
    auto leaf = std::make_shared<const Operation>(Operation{text, {}, text});
    operation_ = n < 0 ? std::make_shared<const Operation>(Operation{"neg", {leaf}, "neg(" + text + ")"}) : leaf;
}

Written Written::symbol(const std::string& name) { return Written(std::make_shared<const Operation>(Operation{name, {}, name})); }

Written Written::sum_over_modes(const Written& term) { return of("sum", {term}); }

Written Written::of(const std::string& name, const std::vector<Written>& on) {
    Operation made{name};
    const bool infix = is_operator(name) && on.size() == 2;
    made.key = infix || on.empty() ? "" : name;
    if (!on.empty()) made.key += "(";
    for (std::size_t i = 0; i < on.size(); ++i) {
        made.on.push_back(on[i].operation());
        made.key += (i == 0 ? "" : infix ? name : ",") + on[i].operation()->key;
    }
    made.key += on.empty() ? name : ")";
    return Written(std::make_shared<const Operation>(std::move(made)));
}

Written operator+(const Written& a, const Written& b) {
    if (a.operation()->key == "0") return b;
    return b.operation()->key == "0" ? a : Written::of("+", {a, b});
}
Written operator-(const Written& a, const Written& b) { return Written::of("-", {a, b}); }
Written operator*(const Written& a, const Written& b) { return Written::of("*", {a, b}); }
Written operator/(const Written& a, const Written& b) { return Written::of("/", {a, b}); }
Written operator-(const Written& a) { return Written::of("neg", {a}); }
Written sqrt(const Written& x) { return Written::of("sqrt", {x}); }
Written exp(const Written& x) { return Written::of("exp", {x}); }
Written sin(const Written& x) { return Written::of("sin", {x}); }
Written cos(const Written& x) { return Written::of("cos", {x}); }
Written sinh(const Written& x) { return Written::of("sinh", {x}); }
Written cosh(const Written& x) { return Written::of("cosh", {x}); }
Written atan2(const Written& y, const Written& x) { return Written::of("atan2", {y, x}); }

std::string code_of(const WrittenFormula& formula, Language language) { return Writer(formula, language).function(); }

} // namespace denhartog::offers
