#include "departures.hpp"

#include <cctype>

#include "denhartog/ledger/ledger.hpp"

namespace denhartog::pages {

namespace {

void erase_all(std::string& text, const std::string& part) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at)) text.erase(at, part.size());
}

/// What two spellings of a formula have in common: all but marks, lines, sizes of brackets and groups.
std::string bare(std::string latex) {
    for (const char* part : {"\\misprint", "\\mended", "\\begin{aligned}", "\\end{aligned}", "\\vphantom{\\frac{V}{V}}",
                             "\\vphantom{\\sqrt{V_{dj}^2}}", "\\Bigl", "\\Bigr", "\\left.", "\\right.", "\\left", "\\right"})
        erase_all(latex, part);
    std::string out;
    for (const char c : latex)
        if (c != '{' && c != '}' && c != '&' && std::isspace(static_cast<unsigned char>(c)) == 0) out += c;
    erase_all(out, "\\\\");
    return out;
}

} // namespace

Departures read_departures(const std::filesystem::path& file) {
    Departures departures;
    for (const ledger::Json& row : ledger::read_array(file.string(), "the list of departures"))
        departures[row.at("equation")] = {row.at("said"), row.value("printed", ""), row.value("holds", "")};
    return departures;
}

std::vector<std::string> faults_of(const Departures& departures, const ledger::Json& entries) {
    std::vector<std::string> faults;
    for (const ledger::Json& entry : entries) {
        const std::string equation = entry.at("equation");
        const bool departs = entry.at("departure") != "none";
        const auto found = departures.find(equation);
        if (departs != (found != departures.end()))
            faults.push_back("docs/ledger/departures.json: (" + equation + ") " +
                             (departs ? "departs from the print and has no sentence" : "has a sentence and does not depart"));
        if (found == departures.end() || found->second.printed.empty()) continue;
        std::string printed = bare(found->second.printed), statement = entry.at("statement");
        statement = bare(statement);
        for (std::string* text : {&printed, &statement}) erase_all(*text, "\\");
        if (printed != statement)
            faults.push_back("docs/ledger/departures.json: (" + equation +
                             ") without its marks is not the printed formula: " + printed + " against " + statement);
        for (const std::string& word : {std::string("\\misprint{"), std::string("\\mended{")}) {
            const bool marks = (word[2] == 'i' ? found->second.printed : found->second.holds).find(word) != std::string::npos;
            if (!marks && equation != "68")
                faults.push_back("docs/ledger/departures.json: (" + equation + ") shows no difference");
        }
    }
    return faults;
}

std::string without_marks(const std::string& latex) {
    std::string out = latex;
    for (const char* mark : {"\\misprint", "\\mended"}) erase_all(out, mark);
    return out;
}

} // namespace denhartog::pages
