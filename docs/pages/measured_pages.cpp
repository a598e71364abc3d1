#include "measured_pages.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "denhartog/number/errors.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace {

std::string sentences(const Json& record, const char* key, const std::string& head) {
    if (record.at(key).empty()) return {};
    std::string out = "<p>" + head + "</p>\n<ul>\n";
    for (const Json& line : record.at(key)) out += "<li>" + prose(line.get<std::string>()) + "</li>\n";
    return out + "</ul>\n";
}

std::string statements(const Json& record) {
    if (record.at("statements").empty()) return {};
    std::string out = "<div class=\"table-box\" tabindex=\"0\">\n<table class=\"doxtable statements\">\n<tr><th>what the text "
                      "says</th><th>the data</th><th>found</th></tr>\n";
    for (const Json& statement : record.at("statements"))
        out += "<tr><td>" + prose(statement.at("text")) + "</td><td>" +
               (statement.at("borne_out").get<bool>()    ? "bear it out"
                : statement.value("measure", "").empty() ? std::string("do not bear it out")
                                                         : "do not bear it out " + prose(statement.at("measure"))) +
               "</td><td>" + prose(statement.at("found")) + "</td></tr>\n";
    return out + "</table>\n</div>\n";
}

/// How the statements of figures came out.
struct StatementCounts {
    std::size_t said = 0, borne_out = 0, not_to_measure = 0;
};

void count_statements(const FigureRecord& figure, StatementCounts& counts) {
    for (const Json& statement : figure.record.at("statements")) {
        const bool borne_out = statement.at("borne_out");
        ++counts.said;
        counts.borne_out += borne_out ? 1 : 0;
        counts.not_to_measure += !borne_out && !statement.value("measure", "").empty() ? 1 : 0;
    }
}

std::string agreements(const Json& record) {
    if (record.at("agreements").empty()) return {};
    std::string out = "<div class=\"table-box\" tabindex=\"0\">\n<table class=\"doxtable agreements\">\n<tr><th>markers against "
                      "lines</th><th>points</th><th>median</th><th>worst</th>"
                      "<th>where</th></tr>\n";
    for (const Json& a : record.at("agreements"))
        out += "<tr><td>" + prose(a.at("what")) + "</td><td>" + std::to_string(a.at("points").get<long>()) + "</td><td>" +
               digits(a.at("median"), "%.2g") + "</td><td>" + digits(a.at("worst"), "%.2g") + "</td><td>" + prose(a.at("where")) +
               "</td></tr>\n";
    return out + "</table>\n</div>\n";
}

/// What somebody hears who cannot see the picture: the title, and the caption without its marks of formulas.
std::string alternative_text(const FigureRecord& figure) {
    std::string out = figure_title(figure) + ". " + figure.caption;
    for (const char mark : {'$', '\\'}) std::erase(out, mark);
    return out;
}

std::string picture_of(const FigureRecord& figure) { return "figures/" + figure.name + ".svg"; }

/// A figure with its caption, as a link.
std::string with_caption(const FigureRecord& figure, const std::string& link) {
    return "<p class=\"figure\"><a href=\"" + link + "\"><img src=\"" + picture_of(figure) + "\" alt=\"" +
           html(alternative_text(figure)) + "\"></a></p>\n<p class=\"said\">" +
           typeset(figure.caption, "docs/ledger/figures.json") + "</p>\n";
}

/// A figure of a name with its caption, and a link to its page; empty if the run has not drawn it.
std::string with_caption(const Book& book, const std::string& name) {
    for (const FigureRecord& figure : book.run.figures)
        if (figure.name == name) return with_caption(figure, label("figure", name) + ".html");
    return "";
}

/// The statements of the text that the data bear out, as what there is to see.
std::string to_see(const Json& record, const std::string& name) {
    std::string items;
    for (const Json& statement : record.at("statements"))
        if (statement.at("borne_out").get<bool>())
            items += "<li>" + prose(statement.at("text")) + ": " + prose(statement.at("found")) + "</li>\n";
    for (const Json& remark : record.at("remarks")) items += "<li>" + prose(remark.get<std::string>()) + "</li>\n";
    return items.empty() ? "" : "\n\\section see_" + name + " What the run found in it\n\n<ul>\n" + items + "</ul>\n";
}

/// The worst zone of a function in double, as the paper has it and as it is shipped.
struct Worst {
    double printed = 0, shipped = 0;
    bool printed_fails = false;
    long points = 0;
    Json equations;
};

std::map<std::string, Worst> worst_of_functions(const RunRecord& run) {
    std::map<std::string, Worst> functions;
    for (const Json& record : run.accuracy) {
        if (record.at("type") != "double") continue;
        for (const Json& row : record.at("functions")) {
            Worst& worst = functions[row.at("function").get<std::string>()];
            worst.points += row.at("points").get<long>();
            worst.equations = row.at("equations");
            if (row.at("printed").is_null())
                worst.printed_fails = true;
            else
                worst.printed = std::max(worst.printed, row.at("printed").get<double>());
            if (!row.at("shipped").is_null()) worst.shipped = std::max(worst.shipped, row.at("shipped").get<double>());
        }
    }
    return functions;
}

std::string accuracy_summary(const RunRecord& run) {
    std::string rows;
    for (const auto& [name, worst] : worst_of_functions(run))
        rows += "<tr><td>" + prose(name) + "</td><td>" + equation_links(worst.equations) + "</td><td>" +
                std::to_string(worst.points) + "</td><td>" +
                (worst.printed_fails ? "not finite somewhere" : digits(worst.printed, "%.2g")) + "</td><td>" +
                digits(worst.shipped, "%.2g") + "</td></tr>\n";
    return "<div class=\"table-box\" tabindex=\"0\">\n<table "
           "class=\"doxtable\">\n<tr><th>function</th><th>equations</th><th>points</th>"
           "<th>paper's form, worst</th><th>shipped form, worst</th></tr>\n" +
           rows + "</table>\n</div>\n";
}

/// The page on accuracy in a few sentences.
std::string accuracy_in_short(const RunRecord& run) {
    double in_double = 0, in_50 = 0;
    long scenes = 0;
    for (const Json& group : run.run.at("agreement")) {
        scenes += group.at("scenes").get<long>();
        in_double = std::max(in_double, group.at("double").at("worst").get<double>());
        in_50 = std::max(in_50, group.at("50 digits").at("worst").get<double>());
    }
    std::string out = "On " + std::to_string(scenes) + " scenes of the paper the closed form differs from a second, unrelated " +
                      "computation by " + digits(in_double, "%.2g") + " at most in double, and by " + digits(in_50, "%.2g") +
                      " in 50 digits.";
    double shipped = 0;
    std::size_t failing = 0;
    const auto functions = worst_of_functions(run);
    for (const auto& [name, worst] : functions) {
        shipped = std::max(shipped, worst.shipped);
        failing += worst.printed_fails ? 1 : 0;
    }
    if (functions.empty()) return out;
    return out + " Each of " + counted(functions.size(), "function", "functions") + " was measured against more digits. " +
           std::to_string(failing) + " of them give no finite number somewhere if they are coded as the paper has them; " +
           "the shipped forms err by " + digits(shipped, "%.2g") + " units at most.";
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::string cell;
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') {
            cell += line[++i];
        } else if (line[i] == '|') {
            const std::size_t first = cell.find_first_not_of(' ');
            cells.push_back(first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
            cell.clear();
        } else {
            cell += line[i];
        }
    }
    return cells;
}

std::string row(const std::vector<std::string>& cells, const std::string& element) {
    std::string out = "<tr>";
    for (const std::string& cell : cells) out += "<" + element + ">" + typeset(cell, "a table") + "</" + element + ">";
    return out + "</tr>\n";
}

} // namespace

std::string tables_as_html(const std::string& markdown, const std::string& prefix) {
    std::istringstream in(markdown);
    std::string out;
    std::size_t columns = 0, sections = 0;
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("|")) {
            if (columns > 0) out += "</table>\n</div>\n";
            columns = 0;
        }
        if (line.starts_with("#")) {
            const std::string title = line.substr(line.find_first_not_of("# "));
            out += "\n\\section " + prefix + "_" + std::to_string(++sections) + " " + title + "\n\n";
        } else if (line.starts_with("|")) {
            const std::vector<std::string> cells = cells_of(line);
            if (columns == 0) {
                columns = cells.size();
                out += "<div class=\"table-box\" tabindex=\"0\">\n<table class=\"doxtable measured\">\n" + row(cells, "th");
            } else if (cells.size() != columns) {
                throw InputError("a row of a table", "must have as many cells as its head", line);
            } else if (line.find_first_not_of("|-: ") != std::string::npos) {
                out += row(cells, "td");
            }
        } else if (!line.empty()) {
            out += "<p>" + typeset(line, "a sentence of a table of measurements") + "</p>\n";
        }
    }
    return out + (columns > 0 ? "</table>\n</div>\n" : "");
}

Page figures_page(const Book& book) {
    std::string out = page_head("figures_page", "Figures");
    StatementCounts of_the_text, of_ours;
    for (const FigureRecord& figure : book.run.figures)
        if (!figure.record.is_null()) count_statements(figure, figure.name.starts_with("fig") ? of_the_text : of_ours);
    const std::size_t refuted = of_the_text.said - of_the_text.borne_out - of_the_text.not_to_measure;
    out += "<p>The page of each figure says what to see in it, and has its data. The paper's text makes " +
           counted(of_the_text.said, "statement", "statements") + " about its figures. The data confirm " +
           std::to_string(of_the_text.borne_out) + " of them and contradict " + std::to_string(refuted) + "; the other " +
           std::to_string(of_the_text.not_to_measure) +
           " use a vague word, and the data do not meet the number that we put in its place. Of the figures beyond the paper we "
           "expected " +
           counted(of_ours.said, "thing", "things") + ", and " + std::to_string(of_ours.borne_out) + " came true.</p>\n";
    for (const bool of_the_paper : {true, false}) {
        out += std::string("\n\\section figures_") + (of_the_paper ? "paper Figures of the paper" : "beyond Beyond the paper") +
               "\n\n<ul class=\"thumbnails\">\n";
        for (const FigureRecord& figure : book.run.figures)
            if (figure_number(figure).empty() != of_the_paper)
                out += "<li><img loading=\"lazy\" src=\"" + picture_of(figure) + "\" alt=\"\"> \\subpage " +
                       label("figure", figure.name) + " \"" + figure_title(figure) + "\"</li>\n";
        out += "</ul>\n";
    }
    return {"figures_page", out};
}

Page figure_page(const Book& book, const FigureRecord& figure) {
    const std::string name = label("figure", figure.name), picture = picture_of(figure);
    const bool chart = figure.script.find("/chart/") != std::string::npos;
    std::string out = page_head(name, figure_title(figure)) +
                      "<div class=\"eq-nav\">\n<span class=\"index\">\\ref figures_page \"all figures\"</span>\n</div>\n\n";
    out += with_caption(figure, picture);
    if (!figure.record.is_null()) {
        if (!figure.record.at("equations").empty())
            out += "<p>Draws " + equation_links(figure.record.at("equations")) + ".</p>\n";
        out += to_see(figure.record, name);
        if (!figure.record.at("given").empty() || !figure.record.at("chosen").empty())
            out += "\n\\section given_" + name + " What is drawn\n\n" +
                   sentences(figure.record, "given", "Given by caption and text:") +
                   sentences(figure.record, "chosen", "Chosen here:");
        const std::string checked = agreements(figure.record) + statements(figure.record);
        if (!checked.empty()) out += "\n\\section checked_" + name + " What was checked\n\n" + checked;
    }
    out += "\n\\section made_" + name + " Data and how it is made\n\n<p>";
    for (const std::string& data : figure.data) out += "<a href=\"figures/" + data + "\">" + escaped(data) + "</a>, ";
    out += "<a href=\"" + picture + "\">" + escaped(figure.name) + ".svg</a>. Made by <code>" +
           (chart ? std::string("./verify chart")
                  : "paper-figures/draw build/verify/bin/paper-figures build/verify/figures " + escaped(figure.name)) +
           "</code>, by ";
    out += chart ? "" : "<code>./verify figures</code> with all others, by ";
    out += "the script " + escaped(figure.script);
    if (!figure.record.is_null()) {
        const std::string program = figure.script.substr(0, figure.script.size() - 2) + "cpp";
        out += " and the program " + source_link(program, 1, program);
    }
    (void)book;
    return {name, out + ".</p>\n"};
}

Page accuracy_page(const Book& book) {
    std::string out = page_head("accuracy_page", "Accuracy");
    out += "<p>" + accuracy_in_short(book.run) +
           "</p>\n\n\\section accuracy_closed_form The closed form against a second witness\n\n<p>The second witness solves the "
           "half-period boundary-value problem in physical coordinates, by a matrix "
           "exponential in multiprecision, and shares nothing with the closed form. The errors are relative to the largest "
           "amplitude.</p>\n<div class=\"table-box\" tabindex=\"0\">\n<table class=\"doxtable accuracy\">\n"
           "<tr><th>scenes</th><th>how "
           "many</th><th>worst in double</th><th>where</th><th>worst in 50 "
           "digits</th><th>where</th></tr>\n";
    for (const Json& group : book.run.run.at("agreement")) {
        const Json &in_double = group.at("double"), &in_50 = group.at("50 digits");
        out += "<tr><td>" + prose(group.at("group")) + "</td><td>" + std::to_string(group.at("scenes").get<long>()) +
               "</td><td>" + digits(in_double.at("worst"), "%.2g") + "</td><td>" + prose(in_double.at("scene")) + "</td><td>" +
               digits(in_50.at("worst"), "%.2g") + "</td><td>" + prose(in_50.at("scene")) + "</td></tr>\n";
    }
    out += "</table>\n</div>\n\n\\section accuracy_functions Functions against more digits\n\n";
    if (book.run.accuracy.empty())
        return {"accuracy_page", out + "<p>Not measured in this run: <code>./verify tests</code> measures it.</p>\n"};
    out += "<p>Worst errors in units of eps over the condition number: 1 is as good as the number type allows. The table has the "
           "worst "
           "zone of each function in double; <a href=\"accuracy.csv\">accuracy.csv</a> has every zone in every number type, with "
           "the worst "
           "point as a hexadecimal float. The page behind an equation has its own rows.</p>\n" +
           accuracy_summary(book.run);
    return {"accuracy_page", out};
}

Page speed_page(const Book& book) {
    std::string out = page_head("speed_page", "Speed");
    if (book.run.chart.empty() && book.run.batch.empty())
        return {"speed_page",
                out +
                    "<p>This run did not measure speed. <code>./verify chart</code> measures every method on your machine; "
                    "this page then shows speed against accuracy, and the menu leads to it.</p>\n"
                    "\n\\section speed_benchmark The stored measurement\n\n"
                    "<p>The sources contain a measurement that was made on one machine: the time that the library and "
                    "other solvers take for the scenes of <a href=\"benchmark.html\">the benchmark</a>, which has a table of "
                    "the numbers. <a href=\"sweep.html\">Studies beyond one machine</a> has the cost of a point of a "
                    "map.</p>\n" +
                    with_caption(book, "benchmark_work_precision")};
    out += "<p><code>./verify chart</code> measured these times on one machine; chart.csv names its processor and compiler. "
           "Times are processor time, and the digits are those at the worst point of a scene.</p>\n";
    for (const char* name : {"speed_against_accuracy", "tolerance_against_error", "batch_cost", "benchmark_work_precision"})
        out += with_caption(book, name);
    return {"speed_page", out + tables_as_html(book.run.chart, "speed_chart") + tables_as_html(book.run.batch, "speed_batch")};
}

Page conformance_page(const Book& book) {
    struct Part {
        const char *name, *title, *made_by;
    };
    constexpr Part parts[] = {{"kill_matrix", "Known mistakes", "./verify tests"},
                              {"adapters", "Implementations to start from", "./verify tests"},
                              {"hostile", "Hostile programs", "./verify tests"},
                              {"solvers", "Solvers of others", "./verify chart"},
                              {"methods", "What methods can do", "./verify chart"}};
    std::string out = page_head("conformance_page", "Conformance");
    out +=
        "<p><code>denhartog conform</code> asks other people's implementations certified questions. This page shows how it does "
        "on programs whose mistakes are known. A run wrote all numbers on this page.</p>\n\n"
        "<ul>\n<li><a href=\"test_your_implementation.html\">Test your implementation in ten minutes</a>, and "
        "<a href=\"protocol.html\">the protocol</a> that a program has to keep</li>\n"
        "<li><a href=\"vectors.html\">the certified vectors</a>: the questions and their values</li>\n"
        "<li><a href=\"conformance_output.html\">what a run writes</a></li>\n"
        "<li><a href=\"solvers.html\">time integrators</a>: how the solvers below are set up</li>\n</ul>\n";
    for (const Part& part : parts) {
        out += "\n\\section conformance_" + std::string(part.name) + " " + part.title + "\n\n";
        const auto found = book.run.conformance.find(part.name);
        out += found != book.run.conformance.end()
                   ? tables_as_html(found->second, "conformance_" + std::string(part.name))
                   : "<p>Not measured in this run: <code>" + std::string(part.made_by) + "</code> measures it.</p>\n";
    }
    return {"conformance_page", out};
}

} // namespace denhartog::pages
