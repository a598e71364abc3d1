// The form of the equation ledger: the numbers of the equations and the keys of an entry.
//
// The derivation writes entries of this form and the program shows them. The hand-written half is `docs/ledger/equations.json`.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "denhartog/number/number_text.hpp"

namespace denhartog::ledger {

// JSON that keeps the order of its keys.
using Json = nlohmann::ordered_json;

// The numbered equations in the paper's order: "1" to "88", then "A.1" to "A.15".
[[nodiscard]] inline const std::vector<std::string>& equation_numbers() {
    static const std::vector<std::string> numbers = [] {
        std::vector<std::string> all;
        for (int n = 1; n <= 88; ++n) all.push_back(std::to_string(n));
        for (int n = 1; n <= 15; ++n) all.push_back("A." + std::to_string(n));
        return all;
    }();
    return numbers;
}

// The number of an equation as the ledger writes it, from what people write: `46`, `(46)`, `eq:46`, `A.7`, `a.7`, `A7`, `a7`;
// `54a`, `(54)a` and the like mean (54). Nothing where the paper has no such equation.
[[nodiscard]] inline std::optional<std::string> equation_number(std::string text) {
    if (text.starts_with("eq:")) text.erase(0, 3);
    if (text.starts_with('(')) {
        const std::size_t close = text.find(')');
        if (close == std::string::npos) return std::nullopt;
        const std::string rest = text.substr(close + 1);
        if (!rest.empty() && rest != "a" && rest != "b") return std::nullopt;
        text = text.substr(1, close - 1) + rest;
    }
    if (text == "54a" || text == "54b") text = "54";
    if (text.starts_with('a')) text.front() = 'A';
    if (text.size() > 1 && text[0] == 'A' && text[1] != '.') text.insert(1, ".");
    const std::vector<std::string>& all = equation_numbers();
    if (std::find(all.begin(), all.end(), text) == all.end()) return std::nullopt;
    return text;
}

// An entry of the ledger before anything is computed: verdicts unknown, nothing found. A slip of the scan is a fact about the
// text, not something a computation finds; it is the one departure that a row states.
[[nodiscard]] inline Json entry_without_run(const Json& row) {
    Json entry;
    for (const char* key : {"equation", "section", "kind", "statement"}) entry[key] = row.at(key);
    entry["printed"] = "unknown";
    entry["departure"] = row.contains("read_as") ? "scan" : "none";
    entry["correction"] = row.value("read_as", "");
    entry["correction_by"] = row.contains("read_as") ? "hand" : "";
    entry["shipped"] = "unknown";
    entry["witness"] = Json::object();
    entry["loss"] = nullptr;
    for (const char* key : {"functions", "claims", "tests", "figures"}) entry[key] = Json::array();
    entry["rests_on"] = row.at("rests_on");
    entry["used_by"] = Json::array();
    for (const char* key : {"printed_note", "in_print", "remark"}) entry[key] = row.value(key, "");
    entry["consequence"] = "";
    entry["kernel"] = {{"status", "not_run"}};
    entry["no_function"] = row.value("no_function", "");
    return entry;
}

// Bearing of a claim on its equations, to stand after its verdict. Empty where its kind is not known.
[[nodiscard]] inline std::string with_kind(const Json& claim) {
    const std::string kind = claim.value("kind", "");
    return kind.empty() ? "" : ", " + kind;
}

// Verdict of the proof assistant's kernel on a claim or an equation, by its key `kernel`.
[[nodiscard]] inline std::string kernel_words(const Json& kernel) {
    const std::string status = kernel.is_object() ? kernel.value("status", "not_run") : "not_run";
    const std::string why = kernel.is_object() ? kernel.value("reason", kernel.value("message", "")) : "";
    const std::string words = status == "not_exported" ? "not exported" : status == "not_run" ? "not run" : status;
    return words + (why.empty() ? "" : ": " + why);
}

// Fills `used_by`, where each equation is used: `rests_on` turned round.
inline void fill_used_by(Json& entries) {
    for (Json& entry : entries) {
        entry["used_by"] = Json::array();
        for (const Json& other : entries) {
            const Json& grounds = other.at("rests_on");
            if (std::find(grounds.begin(), grounds.end(), entry.at("equation")) != grounds.end())
                entry["used_by"].push_back(other.at("equation"));
        }
    }
}

// Evidence of a scene against a printed equation: system, point, quantity, both values and the loss, in a sentence without a full
// stop.
template <class Object>
[[nodiscard]] std::string scene_sentence(const Object& scene) {
    const auto text = [&scene](const char* key) { return scene.at(key).template get<std::string>(); };
    const auto number = [&scene](const char* key) { return number_in_digits(scene.at(key).template get<double>(), 4); };
    std::string regime = text("regime");
    for (char& c : regime) c = c == '_' ? ' ' : c;
    return text("where") + " (" + regime + " motion): " + text("quantity") + ", " + number("printed") + " as printed, " +
           number("holds") + " as it is, a loss of " + number("loss");
}

} // namespace denhartog::ledger
