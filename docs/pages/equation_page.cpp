#include "equation_page.hpp"

#include <algorithm>
#include <fstream>

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

std::string in_section(const Json& entry) {
    const std::string section = entry.at("section");
    return section == "Appendix" ? "the Appendix" : "Section " + section;
}

std::string facts(const Json& entry) {
    const std::string departure = entry.at("departure"), kind = entry.at("kind");
    return "<dl class=\"eq-facts\">\n<dt>Place</dt><dd>" + in_section(entry) + "; " +
           escaped(kind == "quoted" ? "quoted from another work"
                                    : (kind == "assumption" || kind == "approximation" ? "an " : "a ") + kind) +
           "</dd>\n" + (departure == "none" ? "" : "<dt>Departure</dt><dd>" + departure_text(departure) + "</dd>\n") +
           "<dt>Rests on</dt><dd>" + equation_links(entry.at("rests_on")) + "</dd>\n<dt>Used by</dt><dd>" +
           equation_links(entry.at("used_by")) + "</dd>\n</dl>\n\n";
}

/// Links to the sections that the page has.
std::string contents(const std::string& body, const std::string& equation) {
    const std::vector<std::pair<std::string, std::string>> sections = {
        {"proof", "proof"},    {"functions", "function"}, {"check", "check your number"},
        {"figures", "figure"}, {"tests", "tests"},        {"observations", "what the text says"},
        {"kernel", "kernel"},  {"more_link", "more"}};
    std::string out;
    for (const auto& [key, title] : sections) {
        const std::string name = equation_label(equation) + "_" + key;
        if (body.find("\\section " + name + " ") != std::string::npos)
            out += (out.empty() ? "" : ", ") + ("\\ref " + name) + " \"" + title + "\"";
    }
    return "<p class=\"eq-contents\">On this page: " + out + "</p>\n\n";
}

/// A link to the state of the explorable pages in which the equation can be seen.
std::string explore_link(const Book& book, const std::string& equation) {
    std::ifstream file(book.sources.root() / "docs/explore/places.json");
    if (!file) return "";
    const Json places = Json::parse(file);
    if (!places.contains(equation)) return "";
    std::string place; // Doxygen takes it as it is
    for (const char c : places.at(equation).get<std::string>()) place += c == '&' ? "&amp;" : std::string(1, c);
    return "\\htmlonly[block]\n<p class=\"eq-contents\"><a href=\"explore/" + place + "\">See it move: explore (" + equation +
           ")</a></p>\n\\endhtmlonly\n\n";
}

/// A div around a statement, coloured by the verdict.
std::string boxed(const std::string& verdict, const std::string& head, const std::string& latex) {
    const std::string name = verdict == "not_applicable" ? "not-applicable" : verdict;
    return "<div class=\"verdict " + name + "\">\n<p>" + head + "</p>\n" + displayed(latex) + "</div>\n\n";
}

/// The symbols of the formulas, in words.
std::string meanings(const RunRecord& run, const std::string& latex) {
    std::string out;
    for (const Symbol* symbol : symbols_in(run.notation, latex)) {
        std::string numbers;
        for (const std::string& number : symbol->equations) numbers += (numbers.empty() ? "" : ", ") + equation_link(number);
        std::string name = symbol->latex.front();
        for (const std::string& other : symbol->latex)
            if (latex.find(other) != std::string::npos) {
                name = other;
                break;
            }
        out += "<dt>" + formula(name) + "</dt><dd>" + typeset(symbol->meaning, "docs/notation.md") +
               (symbol->units.empty() ? "" : "; " + escaped(symbol->units)) + (numbers.empty() ? "" : "; " + numbers) + "</dd>\n";
    }
    return out.empty() ? "" : "<dl class=\"symbols\">\n" + out + "</dl>\n\n";
}

/// The printed formula and the one that holds, with the difference marked where a person has marked it.
std::string statement(const Book& book, const Json& entry) {
    const std::string equation = entry.at("equation"), note = entry.at("printed_note"), printed = entry.at("printed");
    const auto departure = book.run.departures.find(equation);
    const bool departs = departure != book.run.departures.end(), marked = departs && !departure->second.printed.empty();
    std::string correction = entry.at("correction");
    std::string out, read = entry.at("statement");
    if (departs) out += "<p class=\"said\">" + typeset(departure->second.said, "docs/ledger/departures.json") + "</p>\n\n";
    if (const auto remark = book.run.remarks.find(equation); remark != book.run.remarks.end())
        out += "<p class=\"said\">" + typeset(remark->second, "a remark on (" + equation + ")") + "</p>\n\n";
    const bool two = !correction.empty();
    const std::string held = marked ? departure->second.holds : correction;
    const bool beside = two && read.size() < 110 && without_marks(held).size() < 110;
    // Raw, as Doxygen takes a div within a div to pieces.
    out += std::string("\\htmlonly[block]\n<div class=\"statements") + (beside ? " short" : "") + "\">\n\\endhtmlonly\n\n" +
           boxed(printed, (printed == "illegible" ? "As the scan has it: " : "As printed: ") + verdict_text(printed),
                 marked ? departure->second.printed : read);
    if (two) {
        const std::string head = fails(printed) ? "What holds: " : "As it is read: ";
        out += boxed(entry.at("shipped"), head + verdict_text(entry.at("shipped")), held);
    }
    out += "\\htmlonly[block]\n</div>\n\\endhtmlonly\n\n";
    out += meanings(book.run, read + " " + (marked ? without_marks(departure->second.holds) : correction));
    if (!note.empty() && !departs) out += "<p>The text at hand is a scan. " + sentence(note) + "</p>\n";
    const std::string remark = entry.at("remark"), in_print = entry.at("in_print");
    if (!remark.empty()) out += "<p>" + sentence(remark) + "</p>\n";
    if (!in_print.empty()) out += "<p>The printed paper has:</p>\n" + displayed(in_print);
    return out;
}

/// Whether a name of a witness is one of the formula's.
bool is_of_formula(const RunRecord& run, const std::string& name, const std::string& latex) {
    const auto known = run.symbols.find(name);
    std::string shown = known == run.symbols.end() ? symbol(name, true) : known->second;
    if (shown.empty()) return true;
    if (latex.find(shown) != std::string::npos) return true;
    for (std::string& other : std::vector<std::string>{shown}) {
        for (const char mass : {'1', '2', '3'}) { // R_1 stands for R_i
            const std::size_t at = other.rfind(mass);
            if (at != std::string::npos) other[at] = 'i';
        }
        const std::size_t open = other.find("_{i}");
        if (open != std::string::npos) other.replace(open, 4, "_i");
        if (latex.find(other) != std::string::npos) return true;
    }
    return false;
}

/// A witness without the symbols that the formula does not have; as it is where none would be left.
Json of_formula(const RunRecord& run, const Json& witness, const std::string& latex) {
    Json kept = Json::object();
    for (const auto& [name, value] : witness.items())
        if (is_of_formula(run, name, latex)) kept[name] = value;
    return kept.empty() ? witness : kept;
}

/// A part that opens. Raw, as Doxygen takes a fold with paragraphs in it to pieces.
std::string folded_part(const std::string& summary, const std::string& body) {
    return "\n\\htmlonly[block]\n<details>\n<summary>" + summary + "</summary>\n\\endhtmlonly\n\n" + body +
           "\n\\htmlonly[block]\n</details>\n\\endhtmlonly\n\n";
}

/// What the print costs, the point where it fails, the scene that shows it, the run's own spelling of what holds.
std::string evidence(const Book& book, const Json& entry) {
    const std::string consequence = entry.at("consequence"), correction = entry.at("correction");
    const bool fails_here = fails(entry.at("printed"));
    std::string out;
    if (!consequence.empty())
        out += "<p>Coded as printed: " + prose(consequence) + ".</p>\n";
    else if (fails_here)
        out += "<p>No loss can be measured if it is coded as printed.</p>\n";
    if (!entry.at("witness").empty())
        out += "<p>A point where " + std::string(fails_here ? "the print fails:" : "it was evaluated:") + "</p>\n" +
               witness_text(book.run, of_formula(book.run, entry.at("witness"),
                                                 entry.at("statement").get<std::string>() + " " + correction));
    const auto departure = book.run.departures.find(entry.at("equation").get<std::string>());
    if (!correction.empty() && departure != book.run.departures.end() && !departure->second.printed.empty())
        out += folded_part(
            "What holds, as the derivation writes it",
            std::string(entry.value("correction_by", "") == "hand" ? "<p>A person wrote this form, not the run.</p>\n" : "") +
                displayed(correction));
    else if (entry.value("correction_by", "") == "hand")
        out += "<p>A person wrote the formula above, not the run.</p>\n";
    const std::string scene = scene_text(entry);
    if (!scene.empty()) out += folded_part("A scene that shows it", scene);
    return out;
}

bool in_namespace(const Json& function, const std::string& name) {
    return function.at("name").get<std::string>().find("::" + name + "::") != std::string::npos;
}

std::string head_of(const Json& function) {
    const Place place{function.at("file"), function.at("line")};
    return "<p>" + function_link(function) + ", " +
           source_link(place.file, place.line, place.file + ", line " + std::to_string(place.line)) + "</p>\n";
}

Snippet snippet_of(const Book& book, const Json& function) {
    return book.sources.snippet(function.at("name"), {function.at("file"), function.at("line")});
}

std::string with_source(const Book& book, const Json& function) {
    return head_of(function) + code_block(snippet_of(book, function));
}

/// A function whose source is folded up: a page can have a dozen of them.
std::string folded(const Book& book, const Json& function) {
    const Snippet snippet = snippet_of(book, function);
    return head_of(function) + "<details>\n<summary>" + counted(snippet.lines.size(), "line", "lines") +
           " of source</summary>\n" + code_block(snippet) + "</details>\n";
}

std::string with_signature(const Book& book, const Json& function) {
    Snippet snippet = snippet_of(book, function);
    snippet.lines.resize(snippet.signature);
    return head_of(function) + code_block(snippet);
}

/// The paper's functions with their sources, the printed one folded.
std::string functions(const Book& book, const Json& entry, const std::string& equation) {
    std::string paper, forms, refuted;
    for (const Json& function : entry.at("functions")) {
        if (in_namespace(function, "paper"))
            paper += with_source(book, function);
        else if (in_namespace(function, "evaluation"))
            forms += "<li>" + function_link(function) + "</li>\n";
    }
    for (const Json& function : entry.at("as_printed")) refuted += folded(book, function);
    std::string out = section(equation, "functions", "The function");
    if (paper.empty() && forms.empty()) {
        const std::string why = entry.at("no_function");
        out += "<p>No function computes it" + (why.empty() ? "" : ": " + prose(why)) + ".</p>\n";
    }
    out += paper;
    if (!refuted.empty()) out += "<p>The printed form, kept for comparison:</p>\n" + refuted;
    const std::string correction = entry.at("correction");
    return out + copy_text(
                     equation, correction.empty() ? entry.at("statement").get<std::string>() : [&] {
                         const auto found = book.run.departures.find(equation);
                         return found == book.run.departures.end() || found->second.holds.empty()
                                    ? correction
                                    : without_marks(found->second.holds);
                     }());
}

std::string number_check(const Book& book, const std::string& equation) {
    const auto scenes = book.run.checks.find(equation);
    const std::string form = check_text(equation, scenes == book.run.checks.end() ? std::vector<CheckScene>{} : scenes->second);
    return form.empty()
               ? ""
               : section(equation, "check", "Check your number") +
                     "<p>Paste what your code returns. The page says whether it is right, which known mistake gives it, or "
                     "neither.</p>\n" +
                     form;
}

/// Whether a claim is the equation's own: about the paper's formula, and not about a form of it.
bool is_own(const Json& claim, const std::string& equation) {
    const std::string role = claim.at("role"), kind = claim.value("kind", "derived"), id = claim.at("id");
    const bool decides = role == "printed" || role == "shipped" || role == "both";
    return decides && kind != "refinement" && claim.value("same_as", "").empty() && id.starts_with(equation + "/");
}

struct SortedClaims {
    std::vector<const Json*> own, others, observations;
};

SortedClaims sorted_claims(const Json& entry, const std::string& equation) {
    SortedClaims sorted;
    std::vector<const Json*> decisive;
    for (const Json& claim : entry.at("claims")) {
        const std::string role = claim.at("role"), kind = claim.value("kind", "derived");
        if (role == "observation")
            sorted.observations.push_back(&claim);
        else if (is_own(claim, equation))
            sorted.own.push_back(&claim);
        else if (role != "step" && kind != "refinement" && claim.value("same_as", "").empty())
            decisive.push_back(&claim);
        else
            sorted.others.push_back(&claim);
    }
    // (A.12) is decided by how a shipped formula follows from others.
    if (std::none_of(sorted.own.begin(), sorted.own.end(), [](const Json* claim) { return claim->at("role") != "printed"; }))
        for (auto at = sorted.others.begin(); at != sorted.others.end();) {
            const Json& claim = **at;
            const bool decides = claim.at("role") != "step" && claim.value("same_as", "").empty();
            const bool its = decides && claim.at("id").get<std::string>().starts_with(equation + "/");
            if (its) sorted.own.push_back(&claim);
            at = its ? sorted.others.erase(at) : at + 1;
        }
    auto& rest = sorted.own.empty() ? sorted.own : sorted.others; // (26) is decided by the claims on (A.13)
    rest.insert(rest.begin(), decisive.begin(), decisive.end());
    if (sorted.own.empty() && !sorted.others.empty()) {
        sorted.own.push_back(sorted.others.front());
        sorted.others.erase(sorted.others.begin());
    }
    // What holds comes before what is refuted.
    std::stable_partition(sorted.own.begin(), sorted.own.end(), [](const Json* claim) { return claim->at("role") != "printed"; });
    return sorted;
}

std::string claims_text(const Book& book, const std::vector<const Json*>& claims, const std::string& equation) {
    std::string out;
    for (const Json* claim : claims) out += claim_text(book, *claim, equation);
    return out;
}

std::string proofs(const Book& book, const Json& entry, const SortedClaims& claims, const std::string& equation) {
    std::string out = section(equation, "proof", "The proof");
    out += claims.own.empty() ? "<p>There is no claim about it, because there is nothing to derive.</p>\n"
                              : claims_text(book, claims.own, equation);
    return out + evidence(book, entry);
}

std::string tests(const Book& book, const Json& entry, const std::string& equation) {
    std::string out = section(equation, "tests", "Tests");
    std::size_t count = 0;
    const auto list = [&](const char* key, const char* verdict) {
        std::string items;
        for (const Json& name : entry.at(key)) {
            const Place place = book.sources.test(name);
            if (place.line == 0)
                throw InputError("test '" + name.get<std::string>() + "'", "must stand in a source under tests", "");
            items += "<li>" + escaped(name.get<std::string>()) + ": " + verdict + ", " +
                     source_link(place.file, place.line, place.file + ", line " + std::to_string(place.line)) + "</li>\n";
            ++count;
        }
        return items;
    };
    const std::string failed = list("tests_failed", "failed");
    const std::string items = failed + list("tests", "passed");
    if (items.empty()) return out + "<p>No test of this run has its tag.</p>\n";
    const std::string listed = "<ul class=\"tests\">\n" + items + "</ul>\n";
    return out + (count > 8 ? "<details>\n<summary>" + counted(count, "test", "tests") + "</summary>\n" + listed + "</details>\n"
                            : listed);
}

std::string pictures(const Book& book, const Json& entry, const std::string& equation) {
    if (entry.at("figures").empty()) return {};
    std::string out = section(equation, "figures", "Figures") + "<ul class=\"thumbnails\">\n";
    for (const Json& name : entry.at("figures")) {
        const auto figure =
            std::find_if(book.run.figures.begin(), book.run.figures.end(), [&](const FigureRecord& f) { return f.name == name; });
        if (figure == book.run.figures.end())
            throw InputError("figure " + name.get<std::string>(), "must be drawn; run ./verify figures", "");
        out += "<li><img loading=\"lazy\" src=\"figures/" + figure->name + ".svg\" alt=\"\"> \\ref " +
               label("figure", figure->name) + " \"" + figure_title(*figure) + "\"</li>\n";
    }
    return out + "</ul>\n";
}

std::string observations(const Book& book, const SortedClaims& claims, const std::string& equation) {
    if (claims.observations.empty()) return {};
    return section(equation, "observations", "What the text says about it") + claims_text(book, claims.observations, equation);
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
                return worst.is_null() ? std::string("not finite") : digits(worst.get<double>());
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

std::vector<Page> equation_pages(const Book& book, const std::string& equation) {
    const Json& entry = entry_of(book.run, equation);
    const SortedClaims claims = sorted_claims(entry, equation);
    const std::string name = equation_label(equation), more = name + "_more", accuracy = accuracy_table(book.run, equation);
    std::string forms, callers;
    for (const Json& function : entry.at("functions")) {
        if (in_namespace(function, "evaluation"))
            forms += folded(book, function);
        else if (!in_namespace(function, "paper"))
            callers += with_signature(book, function);
    }
    const bool has_more = !forms.empty() || !callers.empty() || !claims.others.empty() || !accuracy.empty();
    std::string body = proofs(book, entry, claims, equation) + functions(book, entry, equation) + number_check(book, equation) +
                       pictures(book, entry, equation) + tests(book, entry, equation) + observations(book, claims, equation) +
                       kernel_section(book, entry, equation);
    if (has_more) {
        std::string parts;
        const auto part = [&parts](bool there, const std::string& what) {
            if (there) parts += (parts.empty() ? "" : ", ") + what;
        };
        part(!forms.empty(), "the forms that keep their digits");
        part(!claims.others.empty(), counted(claims.others.size(), "further claim", "further claims"));
        part(!accuracy.empty(), "the measured accuracy");
        part(!callers.empty(), "the functions that use it");
        body += section(equation, "more_link", "More on (" + equation + ")") + "<p>\\subpage " + more + " \"" + "Behind (" +
                equation + ")\": " + parts + ".</p>\n";
    }
    std::vector<Page> pages{{name, page_head(name, "Equation (" + equation + ")") + navigation(equation) +
                                       contents(body, equation) + explore_link(book, equation) + statement(book, entry) +
                                       facts(entry) + body + "\n" + navigation(equation)}};
    if (!has_more) return pages;
    std::string text = page_head(more, "Behind equation (" + equation + ")") +
                       "<div class=\"eq-nav\">\n<span class=\"previous\">" + "back to " + equation_link(equation) +
                       "</span>\n</div>\n\n" + "<p>The library's working forms of " + equation_link(equation) +
                       ", with what is proved and measured about them.</p>\n";
    if (!forms.empty()) text += "\n\\section " + more + "_forms Forms that keep their digits\n\n" + forms;
    if (!accuracy.empty())
        text += "\n\\section " + more +
                "_accuracy Accuracy\n\n<p>Worst errors that the tests measured, in units of eps over the "
                "condition number.</p>\n" +
                accuracy;
    if (!claims.others.empty())
        text += "\n\\section " + more + "_claims Further claims\n\n" + claims_text(book, claims.others, equation);
    if (!callers.empty()) text += "\n\\section " + more + "_callers Functions that use it\n\n" + callers;
    pages.push_back({more, text});
    return pages;
}

} // namespace denhartog::pages
