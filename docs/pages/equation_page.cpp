#include "equation_page.hpp"

#include <algorithm>

#include "denhartog/number/errors.hpp"
#include "kernel_section.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace {

std::string navigation(const std::string& equation) {
    const std::vector<std::string>& all = ledger::equation_numbers();
    const auto at = std::find(all.begin(), all.end(), equation);
    std::string out = "<div class=\"eq-nav\">\n";
    if (at != all.begin()) out += "<span class=\"previous\">previous: " + equation_link(*(at - 1)) + "</span>\n";
    out += "<span class=\"index\">\\ref equations \"all equations\"</span>\n";
    if (at + 1 != all.end()) out += "<span class=\"next\">next: " + equation_link(*(at + 1)) + "</span>\n";
    return out + "</div>\n\n";
}

std::string section(const std::string& equation, const std::string& key, const std::string& title) {
    return "\n\\section " + equation_label(equation) + "_" + key + " " + title + "\n\n";
}

std::string part(const std::string& equation, const std::string& key, const std::string& title) {
    return "\n\\subsection " + equation_label(equation) + "_" + key + " " + title + "\n\n";
}

std::string in_section(const Json& entry) {
    const std::string section = entry.at("section");
    return section == "Appendix" ? "the Appendix" : "Section " + section;
}

std::string facts(const Json& entry) {
    const std::string departure = entry.at("departure");
    return "<dl class=\"eq-facts\">\n<dt>Stands in</dt><dd>" + in_section(entry) + "</dd>\n<dt>Is</dt><dd>" +
           escaped(entry.at("kind").get<std::string>() == "quoted" ? "quoted from another work"
                                                                   : entry.at("kind").get<std::string>()) +
           "</dd>\n<dt>As printed</dt><dd>" + verdict_mark(entry.at("printed")) + "</dd>\n<dt>As shipped</dt><dd>" +
           verdict_mark(entry.at("shipped")) + "</dd>\n" +
           (departure == "none" ? "" : "<dt>Departure</dt><dd>" + departure_text(departure) + "</dd>\n") +
           "<dt>Rests on</dt><dd>" + equation_links(entry.at("rests_on")) + "</dd>\n<dt>On it rest</dt><dd>" +
           equation_links(entry.at("used_by")) + "</dd>\n</dl>\n\n";
}

/// Links to the sections that the page has.
std::string contents(const std::string& body, const std::string& equation) {
    const std::vector<std::pair<std::string, std::string>> sections = {{"functions", "function"},    {"proof", "derivation"},
                                                                       {"observations", "the text"}, {"kernel", "kernel"},
                                                                       {"tests", "tests"},           {"accuracy", "accuracy"},
                                                                       {"figures", "figures"}};
    std::string out;
    for (const auto& [key, title] : sections) {
        const std::string name = equation_label(equation) + "_" + key;
        if (body.find("\\section " + name + " ") != std::string::npos)
            out += (out.empty() ? "" : ", ") + ("\\ref " + name) + " \"" + title + "\"";
    }
    return "<p class=\"eq-contents\">On this page: " + out + "</p>\n\n";
}

/// A div around the statement, coloured by the verdict.
std::string boxed(const std::string& verdict, const std::string& head, const std::string& latex) {
    const std::string name = verdict == "not_applicable" ? "not-applicable" : verdict;
    return "<div class=\"verdict " + name + "\">\n<p>" + head + "</p>\n" + displayed(latex) + "</div>\n\n";
}

std::string statement(const Book& book, const Json& entry) {
    const std::string correction = entry.at("correction"), note = entry.at("printed_note");
    const std::string printed = entry.at("printed");
    std::string out =
        boxed(printed, (printed == "illegible" ? "" : "As printed: ") + verdict_text(printed), entry.at("statement"));
    if (!note.empty()) out += "<p>The text at hand is a scan. " + sentence(note) + "</p>\n";
    const std::string remark = entry.at("remark"), in_print = entry.at("in_print");
    if (!remark.empty()) out += "<p>" + sentence(remark) + "</p>\n";
    if (!in_print.empty()) out += "<p>The printed paper has:</p>\n" + displayed(in_print);
    if (!correction.empty()) {
        const bool refuted = fails(printed);
        if (entry.value("correction_by", "") == "hand")
            out += "<p>A person wrote the formula that follows, and not the run.</p>\n";
        out += boxed(entry.at("shipped"),
                     std::string(refuted ? "What holds: " : "As it is read: ") + verdict_text(entry.at("shipped")), correction);
    }
    const std::string consequence = entry.at("consequence");
    if (!consequence.empty())
        out += "<p>Coded as printed: " + prose(consequence) + ".</p>\n";
    else if (fails(printed))
        out += "<p>Coded as printed: no loss to measure.</p>\n";
    out += scene_text(entry);
    if (!entry.at("witness").empty())
        out += "<p>A point where " + std::string(fails(printed) ? "what stands there fails:" : "it was evaluated:") + "</p>\n" +
               witness_text(book.run, entry.at("witness"));
    return out;
}

bool in_namespace(const Json& function, const std::string& name) {
    return function.at("name").get<std::string>().find("::" + name + "::") != std::string::npos;
}

std::string with_source(const Book& book, const Json& function) {
    const Place place{function.at("file"), function.at("line")};
    const Snippet snippet = book.sources.snippet(function.at("name"), place);
    return "<p>" + function_link(function) + ", " +
           source_link(place.file, place.line, place.file + ", line " + std::to_string(place.line)) + "</p>\n" +
           code_block(snippet);
}

/// A function whose source is folded up: a page can have a dozen of them.
std::string folded(const Book& book, const Json& function) {
    const Place place{function.at("file"), function.at("line")};
    const Snippet snippet = book.sources.snippet(function.at("name"), place);
    return "<p>" + function_link(function) + ", " +
           source_link(place.file, place.line, place.file + ", line " + std::to_string(place.line)) +
           "</p>\n<details>\n<summary>" + counted(snippet.lines.size(), "line", "lines") + " of source</summary>\n" +
           code_block(snippet) + "</details>\n";
}

std::string with_signature(const Book& book, const Json& function) {
    const Place place{function.at("file"), function.at("line")};
    Snippet snippet = book.sources.snippet(function.at("name"), place);
    snippet.lines.resize(snippet.signature);
    return "<p>" + function_link(function) + ", " +
           source_link(place.file, place.line, place.file + ", line " + std::to_string(place.line)) + "</p>\n" +
           code_block(snippet);
}

std::string functions(const Book& book, const Json& entry, const std::string& equation) {
    std::string paper, forms, callers, refuted;
    for (const Json& function : entry.at("functions")) {
        if (in_namespace(function, "paper"))
            paper += with_source(book, function);
        else if (in_namespace(function, "evaluation"))
            forms += folded(book, function);
        else
            callers += with_signature(book, function);
    }
    for (const Json& function : entry.at("as_printed")) refuted += with_source(book, function);
    std::string out = section(equation, "functions", "The function");
    if (paper.empty() && forms.empty()) {
        const std::string why = entry.at("no_function");
        out += "<p>No function computes it" + (why.empty() ? "" : ": " + prose(why)) + ".</p>\n";
    }
    out += paper;
    if (!forms.empty()) out += part(equation, "forms", "Forms that keep their digits, which callers get") + forms;
    if (!refuted.empty()) out += part(equation, "as_printed", "The printed form, for comparison") + refuted;
    if (!callers.empty()) out += part(equation, "callers", "Made use of by") + callers;
    return out;
}

std::string proofs(const Book& book, const Json& entry, const std::string& equation) {
    std::string claims, observations;
    for (const Json& claim : entry.at("claims"))
        (claim.at("role") == "observation" ? observations : claims) += claim_text(book, claim, equation);
    std::string out = section(equation, "proof", "The derivation");
    out += claims.empty() ? "<p>No claim is made on it: there is nothing to derive.</p>\n" : claims;
    if (!observations.empty()) out += section(equation, "observations", "What the text says of it") + observations;
    return out;
}

std::string tests(const Book& book, const Json& entry, const std::string& equation) {
    std::string out = section(equation, "tests", "Tests");
    const auto list = [&](const char* key, const char* verdict) {
        std::string items;
        for (const Json& name : entry.at(key)) {
            const Place place = book.sources.test(name);
            if (place.line == 0)
                throw InputError("test '" + name.get<std::string>() + "'", "must stand in a source under tests", "");
            items += "<li>" + escaped(name.get<std::string>()) + ": " + verdict + ", " +
                     source_link(place.file, place.line, place.file + ", line " + std::to_string(place.line)) + "</li>\n";
        }
        return items;
    };
    const std::string items = list("tests_failed", "failed") + list("tests", "passed");
    return out + (items.empty() ? "<p>No test that ran is tagged with it.</p>\n" : "<ul class=\"tests\">\n" + items + "</ul>\n");
}

std::string pictures(const Book& book, const Json& entry, const std::string& equation) {
    if (entry.at("figures").empty()) return {};
    std::string out = section(equation, "figures", "Figures") + "<div class=\"thumbnails\">\n";
    for (const Json& name : entry.at("figures")) {
        const auto figure =
            std::find_if(book.run.figures.begin(), book.run.figures.end(), [&](const FigureRecord& f) { return f.name == name; });
        if (figure == book.run.figures.end())
            throw InputError("figure " + name.get<std::string>(), "must be drawn; run ./verify figures", "");
        out += "<div class=\"thumbnail\">\n<img src=\"figures/" + figure->name + ".svg\" alt=\"" + html(figure->title) +
               "\">\n<p>\\ref " + label("figure", figure->name) + " \"" + figure->title + "\"</p>\n</div>\n";
    }
    return out + "</div>\n";
}

} // namespace

std::string page_head(const std::string& name, const std::string& title) { return "# " + title + " {#" + name + "}\n\n"; }

std::string equation_links(const Json& equations) {
    std::string out;
    for (const Json& equation : equations) out += (out.empty() ? "" : ", ") + equation_link(equation.get<std::string>());
    return out.empty() ? "nothing" : out;
}

std::string function_link(const Json& function) {
    std::string name = function.at("name"), shown = name.starts_with("denhartog::") ? name.substr(11) : name;
    if (name.ends_with("::operator")) { // the index of functions cuts its name here; Doxygen knows the class
        name.erase(name.size() - 10);
        shown += "()";
    }
    return "\\ref " + name + " \"" + shown + "\"";
}

std::string accuracy_table(const RunRecord& run, const std::string& equation) {
    std::string rows;
    for (const Json& record : run.accuracy)
        for (const Json& row : record.at("functions")) {
            const Json& equations = row.at("equations");
            if (!equation.empty() && std::find(equations.begin(), equations.end(), equation) == equations.end()) continue;
            const auto error = [](const Json& worst) {
                return worst.is_null() ? std::string("no number") : digits(worst.get<double>());
            };
            rows += "<tr><td>" + prose(row.at("function")) + "</td><td>" + escaped(record.at("type").get<std::string>()) +
                    "</td><td>" + prose(row.at("zone")) + "</td><td>" + std::to_string(row.at("points").get<long>()) +
                    "</td><td>" + error(row.at("printed")) + "</td><td>" + error(row.at("shipped")) + "</td><td>" +
                    escaped(row.at("shipped_at").get<std::string>()) + "</td></tr>\n";
        }
    if (rows.empty()) return {};
    return "<div class=\"table-box\" tabindex=\"0\">\n<table class=\"doxtable accuracy\">\n<tr><th>function</th><th>number "
           "type</th><th>zone</th><th>points</th><th>paper's "
           "form</th>"
           "<th>shipped form</th><th>worst point of the shipped form</th></tr>\n" +
           rows + "</table>\n</div>\n";
}

Page equation_page(const Book& book, const std::string& equation) {
    const Json& entry = entry_of(book.run, equation);
    std::string text = page_head(equation_label(equation), "Equation (" + equation + ")");
    const std::string accuracy = accuracy_table(book.run, equation);
    std::string body = functions(book, entry, equation) + proofs(book, entry, equation) + kernel_section(book, entry, equation) +
                       tests(book, entry, equation);
    if (!accuracy.empty())
        body += section(equation, "accuracy", "Accuracy") +
                "<p>Worst errors that the tests measured, in units of eps over the condition number.</p>\n" + accuracy;
    body += pictures(book, entry, equation);
    text += navigation(equation) + contents(body, equation) + statement(book, entry) + facts(entry) + body + "\n" +
            navigation(equation);
    return {equation_label(equation), text};
}

} // namespace denhartog::pages
