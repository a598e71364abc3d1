// The record of the derivation as the program prints it: the steps of each claim and the point that refutes it, as text or as
// LaTeX. Read `derivation_as_text` and `derivation_as_latex`.
#include "denhartog/ledger/ledger.hpp"

#include <algorithm>
#include <filesystem>

#include "denhartog/number/errors.hpp"

namespace denhartog::ledger {

namespace {

void check_record(const Json& record, const std::string& file) {
    for (const Json& claim : record) {
        const auto fail = [&](const std::string& key) {
            throw InputError("the derivation's claim " + (claim.contains("claim") ? claim.at("claim").dump() : "without name"),
                             "must have the key", key, file);
        };
        for (const char* key : {"claim", "equation", "title", "verdict"})
            if (!claim.contains(key) || !claim.at(key).is_string()) fail(key);
        for (const char* key : {"assumptions", "steps"})
            if (!claim.contains(key) || !claim.at(key).is_array()) fail(key);
        for (const Json& step : claim.at("steps"))
            if (!step.is_object() || !step.contains("text") || !step.contains("latex")) fail("steps with text and latex");
        for (const Json& value : claim.value("witness", Json::array()))
            if (!value.is_object() || !value.contains("name") || !value.contains("value")) fail("witness with name and value");
    }
}

/// Text with the characters that LaTeX reads as commands made plain.
std::string plain_in_latex(const std::string& text) {
    std::string plain;
    for (const char c : text) {
        const bool is_command = std::string("{}_&%$#").find(c) != std::string::npos;
        plain += is_command ? "\\" : "";
        plain += c == '\\'  ? "\\textbackslash{}"
                 : c == '^' ? "\\textasciicircum{}"
                 : c == '~' ? "\\textasciitilde{}"
                            : std::string(1, c);
    }
    return plain;
}

/// A step in words: the words plain, the formulas between dollar signs as they are.
std::string typeset_text(const Json& step) {
    const std::string text = step.value("text_latex", "");
    if (text.empty()) return plain_in_latex(step.at("text").get<std::string>());
    std::string typeset;
    bool formula = false;
    for (std::size_t at = 0; at < text.size(); formula = !formula) {
        const std::size_t end = std::min(text.find('$', at), text.size());
        const std::string part = text.substr(at, end - at);
        typeset += formula ? "$" + part + "$" : plain_in_latex(part);
        at = end + 1;
    }
    return typeset;
}

/// The point that refutes a claim, or what a search has found, in a sentence.
std::string witness_in_latex(const Json& witness) {
    std::string text;
    for (const Json& value : witness) {
        const std::string latex = value.value("name_latex", ""), name = value.at("name");
        text += (text.empty() ? "Witness: " : ", ") + (latex.empty() ? plain_in_latex(name) : "$" + latex + "$") + " = " +
                plain_in_latex(value.at("value").get<std::string>());
    }
    return text.empty() ? "" : text + ".\n";
}

} // namespace

Json read_derivation(const std::string& option, const std::string& environment, const std::string& built) {
    const std::string file = !option.empty() ? option : !environment.empty() ? environment : built;
    if (option.empty() && environment.empty() && !std::filesystem::exists(built))
        throw InputError("the derivation's record", "must be there: ./verify paper writes it", "", built);
    const Json record = read_array(file, "the derivation's record");
    check_record(record, file);
    return record;
}

std::string derivation_as_text(const Json& claims, const std::string& equation) {
    if (claims.empty()) return "The derivation has no step on equation (" + equation + ").\n";
    std::string text;
    for (const Json& claim : claims) {
        text += (text.empty() ? "(" : "\n(") + claim.at("equation").get<std::string>() + ")  " +
                claim.at("title").get<std::string>() + "\n    claim " + claim.at("claim").get<std::string>() + ": " +
                claim.at("verdict").get<std::string>() + with_kind(claim) + "\n";
        for (const Json& assumption : claim.at("assumptions")) text += "    where " + assumption.get<std::string>() + "\n";
        int count = 0;
        for (const Json& step : claim.at("steps")) {
            text += "  " + std::to_string(++count) + ". " + step.at("text").get<std::string>() + "\n";
            if (step.at("latex") != "") text += "       " + step.at("latex").get<std::string>() + "\n";
        }
        for (const Json& value : claim.value("witness", Json::array()))
            text += "    witness: " + value.at("name").get<std::string>() + " = " + value.at("value").get<std::string>() + "\n";
    }
    return text;
}

std::string derivation_as_latex(const Json& claims) {
    std::string text;
    for (const Json& claim : claims) {
        text += "\\paragraph{Eq.~(" + claim.at("equation").get<std::string>() +
                "): " + plain_in_latex(claim.at("title").get<std::string>()) + "} " +
                plain_in_latex(claim.at("verdict").get<std::string>()) + ".\n";
        for (const Json& assumption : claim.at("assumptions"))
            text += "Where " + plain_in_latex(assumption.get<std::string>()) + ".\n";
        if (!claim.at("steps").empty()) {
            text += "\\begin{enumerate}\n";
            for (const Json& step : claim.at("steps")) {
                text += "\\item " + typeset_text(step) + "\n";
                if (step.at("latex") != "") text += "\\[ " + step.at("latex").get<std::string>() + " \\]\n";
            }
            text += "\\end{enumerate}\n";
        }
        text += witness_in_latex(claim.value("witness", Json::array()));
    }
    return text;
}

} // namespace denhartog::ledger
