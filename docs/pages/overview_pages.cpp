#include "overview_pages.hpp"

#include <map>

#include "derivation/ledger/ledger_audit.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace {

std::string section_heading(const std::string& section) {
    static const std::map<std::string, std::string> titles = {{"2.1", "2.1 Formulation"},
                                                              {"2.2", "2.2 Modal superposition"},
                                                              {"2.3", "2.3 The mass in contact"},
                                                              {"2.4", "2.4 Time response"},
                                                              {"2.5", "2.5 The other masses"},
                                                              {"2.6", "2.6 Domain of validity"},
                                                              {"3.1", "3.1 Numerical approach"},
                                                              {"4.1", "4.1 Resonances"},
                                                              {"4.2", "4.2 Low and high frequency ratios"},
                                                              {"4.3", "4.3 Invariant points and the stuck contact"},
                                                              {"Appendix", "Appendix"}};
    const auto found = titles.find(section);
    return found == titles.end() ? section : found->second;
}

std::string functions_of(const Json& entry) {
    std::string out;
    for (const Json& function : entry.at("functions"))
        if (function.at("name").get<std::string>().find("::paper::") != std::string::npos)
            out += (out.empty() ? "" : "<br>") + function_link(function);
    return out.empty() ? "none" : out;
}

std::string counts(const Json& ledger, const char* key) {
    std::map<std::string, std::size_t> count;
    for (const Json& entry : ledger) ++count[entry.at(key).get<std::string>()];
    std::string out;
    for (const auto& [word, n] : count) out += (out.empty() ? "" : ", ") + std::to_string(n) + " " + verdict_text(word);
    return out;
}

/// What the departures of a kind are, for somebody who has not seen the others.
std::string fair_words(const std::string& kind) {
    if (kind == "scan")
        return "The scanned text at hand has a wrong glyph, and the sentences around it show which glyph is meant. This says "
               "nothing "
               "about "
               "the journal's own page, and none of these equations counts as refuted. If you have the printed paper, you can "
               "settle "
               "a case: docs/ledger/README.md says how.";
    if (kind == "misprint")
        return "A sign, a function or a factor is wrong in a formula that can be read, and other equations of the paper "
               "contradict it. "
               "The paper's own figures may have been computed with the right one.";
    if (kind == "substance")
        return "The equation does not hold as it is meant, or it holds only under a condition that is not stated. The witness "
               "shows where.";
    return "The equation holds under a convention that the paper does not state. Without this convention it can be misread.";
}

/// The formulas of a departure, with the difference marked where a person has marked it.
std::string both_formulas(const Book& book, const Json& entry) {
    const std::string equation = entry.at("equation"), correction = entry.at("correction");
    const auto found = book.run.departures.find(equation);
    const bool marked = found != book.run.departures.end() && !found->second.printed.empty();
    std::string out = "<p>" + equation_link(equation) + " as printed: " + verdict_mark(entry.at("printed")) + "</p>\n" +
                      displayed(marked ? found->second.printed : entry.at("statement").get<std::string>());
    if (correction.empty()) return out;
    return out + "<p>" + std::string(fails(entry.at("printed")) ? "What holds: " : "As it is read: ") +
           verdict_mark(entry.at("shipped")) + "</p>\n" + displayed(marked ? found->second.holds : correction);
}

std::string said_of(const Book& book, const std::string& equation) {
    const auto found = book.run.departures.find(equation);
    return found == book.run.departures.end() ? "" : typeset(found->second.said, "docs/ledger/departures.json");
}

std::string departure_of(const Book& book, const Json& entry) {
    const std::string equation = entry.at("equation");
    std::string out = "\n\\subsection errata_" + equation_label(equation) + " Equation (" + equation + ")\n\n<p>" +
                      said_of(book, equation) + "</p>\n\n<div class=\"erratum\">\n" + both_formulas(book, entry);
    std::string decided;
    for (const Json& claim : entry.at("claims")) {
        const std::string role = claim.at("role");
        if (role == "printed" || role == "shipped" || role == "both")
            decided += (decided.empty() ? "" : ", ") + claim_link(record_of(book.run, claim.at("id")));
    }
    const std::string consequence = entry.at("consequence");
    if (!decided.empty()) out += "<p>Decided by " + decided + ".</p>\n";
    if (!consequence.empty()) out += "<p>Coded as printed: " + prose(consequence) + ".</p>\n";
    for (const Json& figure : entry.at("figures"))
        if (figure.get<std::string>().starts_with("printed_against"))
            for (const FigureRecord& record : book.run.figures)
                if (record.name == figure)
                    out += "<p>Figure: \\ref " + label("figure", record.name) + " \"" + record.title + "\"</p>\n";
    return out + "</div>\n\n";
}

} // namespace

Page index_page(const Book& book) {
    std::string out = page_head("equations", "The numbered equations");
    out += "<p>" + counted(book.run.ledger.size(), "equation", "equations") +
           " in the paper's order. As printed: " + counts(book.run.ledger, "printed") +
           ". As shipped: " + counts(book.run.ledger, "shipped") +
           ". Where the scan is wrong or the printed form is refuted, the table shows the form that holds; the page of the "
           "equation has both.</p>\n";
    std::string section;
    for (const Json& entry : book.run.ledger) {
        if (entry.at("section") != section) {
            if (!section.empty()) out += "</table>\n</div>\n";
            section = entry.at("section");
            out += "\n\\section " + label("equations", section) + " " + section_heading(section) +
                   "\n\n<div class=\"table-box\" tabindex=\"0\">\n<table class=\"doxtable "
                   "equations\">\n<tr><th>number</th><th>what it says</th><th>as printed</th><th>as shipped</th>"
                   "<th>function</th></tr>\n";
        }
        out += "<tr><td>\\subpage " + equation_label(entry.at("equation")) + " \"(" + entry.at("equation").get<std::string>() +
               ")\"</td><td>" + formula(statement_that_holds(entry)) + "</td><td>" + verdict_mark(entry.at("printed")) +
               "</td><td>" + verdict_mark(entry.at("shipped")) + "</td><td>" + functions_of(entry) + "</td></tr>\n";
    }
    return {"equations", out + "</table>\n</div>\n"};
}

Page errata_page(const Book& book) {
    std::map<std::string, std::vector<const Json*>> kinds;
    for (const Json& entry : book.run.ledger) kinds[entry.at("departure").get<std::string>()].push_back(&entry);
    const std::size_t departures = book.run.ledger.size() - kinds["none"].size();
    std::string out = page_head("errata", "Departures from the printed text");
    out += "<p>" + std::to_string(departures) + " of the " + counted(book.run.ledger.size(), "equation", "equations") +
           " depart from the printed text in some way. The text at hand is a scan of the article, so some of the departures are "
           "the scanner's and not the "
           "authors'. Every verdict is computed. A refuted form comes with a point where it fails, and the form that replaces "
           "it comes with a proof.</p>\n";
    const std::vector<std::pair<std::string, std::string>> order = {{"misprint", "Misprints"},
                                                                    {"substance", "What does not hold as it is meant"},
                                                                    {"scan", "Slips of the scan"},
                                                                    {"convention", "Conventions that the paper does not state"}};
    out +=
        "<p>\\ref errata_sheet \"The errata on one sheet\", to print<span class=\"pdf\"></span>.</p>\n<div class=\"table-box\" "
        "tabindex=\"0\">\n<table "
        "class=\"doxtable errata\">\n<tr><th>equation</th><th>as printed</th><th>what is wrong</th></tr>\n";
    for (const auto& [kind, title] : order) {
        out += "<tr><th colspan=\"3\">\\ref errata_" + kind + " \"" + title + "\": " + std::to_string(kinds[kind].size()) +
               "</th></tr>\n";
        for (const Json* entry : kinds[kind])
            out += "<tr><td>" + equation_link(entry->at("equation")) + "</td><td>" + verdict_mark(entry->at("printed")) +
                   "</td><td>" + said_of(book, entry->at("equation")) + "</td></tr>\n";
    }
    out += "</table>\n</div>\n";
    for (const auto& [kind, title] : order) {
        out += "\n\\section errata_" + kind + " " + title + "\n\n<p>" + fair_words(kind) + "</p>\n\n";
        for (const Json* entry : kinds[kind]) out += departure_of(book, *entry);
    }
    return {"errata", out};
}

Page stand_ins_page(const Book& book) {
    std::string out = page_head("stand_ins", "Functions that the proofs replace");
    out += "<p>The proofs instantiate the shipped functions with symbols. The functions below compare numbers, sum a series or "
           "reduce "
           "an argument, which symbols cannot do. The proofs use in their place what they compute without rounding. This is the "
           "whole list: any other function that compares numbers does not compile for the proofs. The tests measure how accurate "
           "the "
           "listed functions are in double.</p>\n"
           "<div class=\"table-box\" tabindex=\"0\">\n<table class=\"doxtable\">\n<tr><th>function</th><th>header</th><th>stands "
           "for</th></tr>\n";
    for (const Json& s : book.run.run.at("stand_ins"))
        out += "<tr><td><code>" + s.at("name").get<std::string>() + "</code></td><td><code>" + s.at("header").get<std::string>() +
               "</code></td><td>\\f$" + s.at("theorem").get<std::string>() + "\\f$</td></tr>\n";
    return {"stand_ins", out + "</table>\n</div>\n"};
}

Page audit_page(const Book& book) {
    const std::vector<derivation::AuditRow> rows = derivation::audit_of(nlohmann::json(book.run.ledger));
    std::string out = page_head("audit", "What remains assumed");
    out +=
        "<p>" + prose(derivation::audit_summary(rows)) +
        "</p>\n<p>A claim is derived if one of its sides was built from the equation of motion or from a condition on it, and a "
        "refinement if its other side is a shipped formula. If a claim is restated, one of its sides was typed by hand. The "
        "premises "
        "are the paper's own assumptions on which an equation rests, directly or through others. The proofs do not cover "
        "rounding "
        "errors: \\ref accuracy_page \"the page on accuracy\" has their measurements.</p>\n"
        "<div class=\"table-box\" tabindex=\"0\">\n<table class=\"doxtable\">\n<tr><th>equation</th><th>claims by "
        "kind</th><th>as "
        "printed</th><th>as shipped</th><th>what remains assumed</th></tr>\n";
    for (const derivation::AuditRow& row : rows)
        out += "<tr><td>" + equation_link(row.equation) + "</td><td>" + escaped(row.kinds) + "</td><td>" +
               verdict_mark(row.printed) + "</td><td>" + verdict_mark(row.shipped) + "</td><td>" +
               prose(derivation::remaining(row)) + "</td></tr>\n";
    return {"audit", out + "</table>\n</div>\n"};
}

} // namespace denhartog::pages
