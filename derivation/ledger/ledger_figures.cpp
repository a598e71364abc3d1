#include "derivation/ledger/ledger_figures.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace denhartog::derivation {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

bool of_the_paper(const json& record) { return record.at("name").get<std::string>().starts_with("fig"); }

std::string digits(double x) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.2g", x);
    return buffer;
}

/// Text in a cell of a table, where a bar would end the cell.
std::string cell(const json& value) {
    std::string text;
    for (const char c : value.get<std::string>()) text += c == '|' ? std::string("\\|") : std::string(1, c);
    return text;
}

/// The largest of a figure's differences of a kind; empty where nothing was compared.
std::string largest(const json& record, const char* kind) {
    const json& agreements = record.at("agreements");
    if (agreements.empty()) return {};
    return digits(std::ranges::max(agreements, {}, [kind](const json& a) { return a.at(kind).get<double>(); }).at(kind));
}

/// Whether the figure contradicts a statement only at the threshold that was chosen for a vague word of the text.
bool not_to_measure(const json& statement) {
    return !statement.at("borne_out").get<bool>() && !statement.value("measure", "").empty();
}

std::string borne_out(const json& record) {
    const json& statements = record.at("statements");
    if (statements.empty()) return {};
    const auto holds = std::ranges::count_if(statements, [](const json& s) { return s.at("borne_out").get<bool>(); });
    const auto measured = std::ranges::count_if(statements, not_to_measure);
    return std::to_string(holds) + " of " + std::to_string(statements.size()) +
           (measured > 0 ? ", " + std::to_string(measured) + " beyond the threshold that was chosen" : "");
}

/// Yes, no, or `not to 1 percent` if a chosen threshold decides.
std::string answer(const json& statement) {
    if (not_to_measure(statement)) return "not " + statement.at("measure").get<std::string>();
    return statement.at("borne_out").get<bool>() ? "yes" : "no";
}

std::string list(const std::string& head, const json& lines) {
    if (lines.empty()) return {};
    std::string text = head + "\n";
    for (const json& line : lines) text += "- " + line.get<std::string>() + "\n";
    return text + "\n";
}

std::string equations(const json& record) {
    std::string text;
    for (const json& equation : record.at("equations")) text += (text.empty() ? "(" : ", (") + equation.get<std::string>() + ")";
    return text;
}

} // namespace

std::vector<json> figure_records(const fs::path& folder) {
    std::vector<json> records;
    if (!fs::is_directory(folder)) return records;
    for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
        if (file.path().extension() != ".json") continue;
        std::ifstream in(file.path());
        try {
            records.push_back(json::parse(in));
        } catch (const json::exception& e) {
            throw std::runtime_error("cannot read " + file.path().string() + ": " + e.what());
        }
    }
    const auto place = [](const json& record) { return std::pair(!of_the_paper(record), record.at("name").get<std::string>()); };
    std::ranges::sort(records, {}, place);
    return records;
}

std::vector<std::string> add_figures(json& entries, const std::vector<json>& records) {
    std::vector<std::string> faults;
    for (const json& record : records)
        for (const json& equation : record.at("equations")) {
            const auto entry = std::ranges::find_if(entries, [&](const json& e) { return e.at("equation") == equation; });
            if (entry == entries.end())
                faults.push_back("the figure " + record.at("name").get<std::string>() + " shows (" + equation.get<std::string>() +
                                 "), which the paper does not have");
            else
                entry->at("figures").push_back(record.at("name"));
        }
    return faults;
}

std::string figures_table(const std::vector<json>& records) {
    std::string paper =
        "| figure | shows | markers off the lines: largest median | worst | statements borne out |\n|---|---|---|---|---|\n";
    std::string beyond = "| beyond the paper | shows | statements that hold |\n|---|---|---|\n";
    for (const json& record : records) {
        const std::string begin = "| " + record.at("name").get<std::string>() + " | " + cell(record.at("title")) + " | ";
        if (of_the_paper(record))
            paper += begin + largest(record, "median") + " | " + largest(record, "worst") + " | " + borne_out(record) + " |\n";
        else
            beyond += begin + borne_out(record) + " |\n";
    }
    return paper + "\n" + beyond;
}

std::string figures_markdown(const std::vector<json>& records) {
    std::string text;
    for (const json& record : records) {
        const std::string name = record.at("name");
        text += "## " + name + "\n\n" + record.at("title").get<std::string>() + ". Equations: " + equations(record) + ".\n\n";
        text += list("From caption and text:\n", record.at("given")) + list("Chosen:\n", record.at("chosen"));
        if (!record.at("agreements").empty()) {
            text += "| markers against lines | points | median | worst | where |\n|---|---|---|---|---|\n";
            for (const json& a : record.at("agreements"))
                text += "| " + cell(a.at("what")) + " | " + std::to_string(a.at("points").get<int>()) + " | " +
                        digits(a.at("median")) + " | " + digits(a.at("worst")) + " | " + a.at("where").get<std::string>() +
                        " |\n";
            text += "\n";
        }
        if (!record.at("statements").empty()) {
            text += of_the_paper(record) ? "| the text says | the data say | borne out |\n"
                                         : "| statement | the data say | holds |\n";
            text += "|---|---|---|\n";
            for (const json& s : record.at("statements"))
                text += "| " + cell(s.at("text")) + " | " + cell(s.at("found")) + " | " + answer(s) + " |\n";
            text += "\n";
        }
        text += list("Besides:\n", record.at("remarks"));
    }
    return text;
}

} // namespace denhartog::derivation
