#include "claim_text.hpp"

#include <algorithm>

#include "denhartog/ledger/ledger_entry.hpp"
#include "denhartog/number/errors.hpp"
#include "derivation/claims/threshold.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace {

/// Longer formulas are left to the record: nobody reads them, and they take seconds to typeset.
constexpr std::size_t longest_formula = 1500;

/// Steps of the record that are no steps of the argument.
constexpr const char *abbreviated = "Abbreviations", *divisors = "where no divisor is zero";

std::size_t count_of_steps(const Json& record) {
    const Json& steps = record.at("steps");
    return static_cast<std::size_t>(std::count_if(steps.begin(), steps.end(), [](const Json& step) {
        return step.at("text") != abbreviated && step.at("text") != divisors;
    }));
}

std::string role_text(const std::string& role) {
    if (role == "both") return "on the formula as printed and as shipped";
    if (role == "printed") return "on the formula as printed";
    if (role == "shipped") return "on the formula as shipped";
    if (role == "observation") return "on what the text says about it";
    return "a step of the argument";
}

/// How a claim bears on its equations, as the run found.
std::string kind_text(const Json& claim) {
    const std::string kind = claim.value("kind", ""), same_as = claim.value("same_as", "");
    const std::string again = same_as.empty() ? "" : " (it says the same as " + escaped(same_as) + ")";
    if (kind == "refinement") return "a refinement of a shipped formula" + again;
    if (kind == "restated") return "a definition restated" + again;
    if (kind == "consequence") return "a consequence of shipped formulas" + again;
    if (kind == "argument") return "with an argument that a person gave";
    return (kind == "observation" ? "observed" : "derived") + again;
}

/// The numbers that stand for vague words of the text, and where the verdict turns; empty where none does.
std::string thresholds_text(const Json& claim) {
    if (!claim.contains("thresholds")) return {};
    const std::vector<derivation::Threshold> thresholds = derivation::thresholds_from_json(claim.at("thresholds"));
    std::string out = "<p>A number of ours stands for a vague word: ";
    for (std::size_t i = 0; i < thresholds.size(); ++i) out += (i > 0 ? "; " : "") + prose(sentence(thresholds[i]));
    const bool whatever = claim.at("verdict") == "refuted" && refuted_whatever_the_threshold(thresholds);
    return out + (whatever ? ". The statement is refuted whatever number is taken.</p>\n" : ".</p>\n");
}

/// The sentence of a step; the generators of the zero test, which follow "zero with", stay as the run wrote them.
std::string step_sentence(const std::string& text) {
    const std::string head = "reduces to zero with ";
    const std::size_t at = text.find(head);
    if (at == std::string::npos) return prose(text);
    const std::size_t from = at + head.size();
    return prose(text.substr(0, from)) + "<code>" + escaped(text.substr(from)) + "</code>";
}

/// The equation on whose page a claim's steps stand: the one that its id begins with, else its first.
std::string home_of(const Json& record) {
    const Json& equations = record.at("equations");
    const std::string id = record.at("claim"), first = id.substr(0, id.find('/'));
    return std::find(equations.begin(), equations.end(), first) != equations.end() ? first : equations.at(0).get<std::string>();
}

bool is_long(const Json& claim) {
    std::size_t length = 0;
    for (const Json& step : claim.at("steps")) length += step.at("latex").get<std::string>().size() + 60;
    return length > 900;
}

} // namespace

std::string claim_label(const Json& record) { return label("claim", record.at("claim")); }

std::string claim_link(const Json& record) {
    return "\\ref " + claim_label(record) + " \"" + record.at("claim").get<std::string>() + "\"";
}

std::string steps_text(const Json& claim) {
    std::string out = "<ol class=\"steps\">\n", abbreviations;
    for (const Json& step : claim.at("steps")) {
        const std::string text = step.at("text"), latex = step.at("latex");
        if (text == abbreviated) { // last, as what they stand for is looked up
            abbreviations = "<li class=\"here\">Here\n" + displayed(latex) + "</li>\n";
            continue;
        }
        if (text == divisors && out.ends_with("</li>\n")) { // a condition of the step before
            out.erase(out.size() - 6);
            out += text + "\n" + displayed(latex) + "</li>\n";
            continue;
        }
        const bool generators = latex.empty() && text.find("zero with") != std::string::npos;
        out += "<li>" + (step.contains("text_latex") ? typeset(step.at("text_latex"), claim.at("claim")) : step_sentence(text)) +
               (!latex.empty() ? ":"
                : generators   ? ""
                               : ".") +
               "\n";
        if (latex.size() > longest_formula)
            out += "<p class=\"left-out\">An expression of " + std::to_string(latex.size()) +
                   " characters, in derivation.json, the record of the run.</p>\n";
        else if (!latex.empty())
            out += displayed(latex);
        out += "</li>\n";
    }
    return out + abbreviations + "</ol>\n";
}

std::string witness_text(const RunRecord& run, const Json& witness) {
    if (witness.empty()) return {};
    std::string out;
    for (const auto& [name, value] : witness.items()) {
        const auto latex = run.symbols.find(name);
        const std::string shown = latex == run.symbols.end() ? witness_name(name) : formula(latex->second);
        out += (out.empty() ? "" : ", ") + shown + " = " + witness_value(value.get<std::string>());
    }
    return "<p class=\"witness\">" + out + "</p>\n";
}

std::string scene_text(const Json& entry) {
    const Json scene = entry.value("scene", Json::object());
    if (scene.empty()) return {};
    if (scene.contains("none")) return "<p>No scene shows it: " + prose(scene.at("none")) + ".</p>\n";
    return "<p>It can be seen on " + prose(ledger::scene_sentence(scene)) +
           ". The scene, for <code>denhartog solve</code>:</p>\n<p><code>" + escaped(scene.at("scene").get<std::string>()) +
           "</code></p>\n";
}

std::string claim_text(const Book& book, const Json& claim, const std::string& equation) {
    const std::string id = claim.at("id");
    const Json& record = record_of(book.run, id);
    const std::string home = home_of(record);
    const Place place = book.sources.claim(id);
    if (place.line == 0) throw InputError("claim " + id, "must be made in a source under derivation", "");
    const bool here = home == equation;
    std::string out = "<div class=\"claim\">\n";
    if (here) out += "\\anchor " + claim_label(record) + "\n";
    out += "<p class=\"claim-title\"><strong>" + prose(claim.at("what")) + "</strong></p>\n";
    out += "<p>" + verdict_mark(claim.at("verdict")) + ", " + kind_text(claim) + ", " + role_text(claim.at("role")) +
           "; claim <code>" + escaped(id) + "</code>, made in " + source_link(place.file, place.line, place.file) + ".</p>\n";
    if (!claim.at("assumptions").empty()) {
        out += "<p>Assumed: ";
        bool first = true;
        for (const Json& assumption : claim.at("assumptions")) {
            out += (first ? "" : "; ") + prose(assumption.get<std::string>());
            first = false;
        }
        out += ".</p>\n";
    }
    out += thresholds_text(claim);
    if (claim.contains("witness") && !claim.at("witness").empty() &&
        claim.at("witness") != entry_of(book.run, equation).at("witness")) // which stands at the head of the page
        out += "<p>" + std::string(claim.at("verdict") == "refuted" ? "Witness:" : "Found:") + "</p>\n" +
               witness_text(book.run, claim.at("witness"));
    if (!here) return out + "<p>Its steps: " + claim_link(record) + ", on the page of " + equation_link(home) + ".</p>\n</div>\n";
    const std::string steps = steps_text(record);
    const std::string count = counted(count_of_steps(record), "step", "steps");
    return out + "<details" + (is_long(record) ? "" : " open=\"open\"") + ">\n<summary>" + count +
           " of the derivation</summary>\n" + steps + "</details>\n</div>\n";
}

} // namespace denhartog::pages
