// The graph of what rests on what.
#include <algorithm>
#include <map>
#include <set>

#include "denhartog/number/errors.hpp"
#include "overview_pages.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace {

constexpr int node_width = 46, node_height = 24, column_pitch = 62, row_pitch = 64, margin = 16;

using Grounds = std::map<std::string, std::vector<std::string>>;

int depth_of(const std::string& equation, const Grounds& grounds, std::map<std::string, int>& depth,
             std::set<std::string>& above) {
    if (const auto known = depth.find(equation); known != depth.end()) return known->second;
    if (!above.insert(equation).second)
        throw InputError("equation (" + equation + ")", "must not rest on itself by any way round", "");
    const auto found = grounds.find(equation);
    if (found == grounds.end()) throw InputError("equation (" + equation + ")", "is rested on and must have an entry", "");
    int deepest = -1;
    for (const std::string& ground : found->second) deepest = std::max(deepest, depth_of(ground, grounds, depth, above));
    above.erase(equation);
    return depth[equation] = deepest + 1;
}

/// Mean column of the neighbours above or below; the own one where there are none.
double middle(const std::vector<std::string>& neighbours, const std::map<std::string, double>& x, double own) {
    double sum = 0;
    for (const std::string& n : neighbours) sum += x.at(n);
    return neighbours.empty() ? own : sum / static_cast<double>(neighbours.size());
}

void spread(const std::vector<std::vector<std::string>>& rows, std::map<std::string, double>& x) {
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) x[row[i]] = static_cast<double>(i) - static_cast<double>(row.size() - 1) / 2;
}

/// The fill of a box where no style sheet says another: the text in it is dark.
const char* fill_of(const std::string& verdict) {
    if (verdict == "proved") return "#cfe8d5";
    if (verdict == "refuted") return "#f6cfcf";
    if (verdict == "approximation") return "#fbe6b8";
    return "#dde3ec";
}

std::string point(double x, double y) { return digits(x, "%.1f") + " " + digits(y, "%.1f"); }

std::string picture(const Json& ledger, const std::vector<Node>& nodes) {
    std::map<std::string, const Node*> at;
    int columns = 0, rows = 0;
    for (const Node& node : nodes) {
        at[node.equation] = &node;
        columns = std::max(columns, node.column + 1);
        rows = std::max(rows, node.row + 1);
    }
    const auto x = [](const Node& n) { return margin + n.column * column_pitch + node_width / 2.0; };
    const auto y = [](const Node& n) { return margin + n.row * row_pitch + node_height / 2.0; };
    const int width = 2 * margin + (columns - 1) * column_pitch + node_width;
    const int height = 2 * margin + (rows - 1) * row_pitch + node_height;
    std::string edges, boxes;
    for (const Json& entry : ledger) {
        const Node& below = *at.at(entry.at("equation"));
        for (const Json& ground : entry.at("rests_on")) {
            const Node& above = *at.at(ground);
            const double from = y(above) + node_height / 2.0, to = y(below) - node_height / 2.0, bend = (to - from) / 2;
            edges += "<path d=\"M " + point(x(above), from) + " C " + point(x(above), from + bend) + " " +
                     point(x(below), to - bend) + " " + point(x(below), to) + "\"/>\n";
        }
        const std::string number = entry.at("equation"), verdict = entry.at("printed");
        boxes += "<a href=\"page:" + equation_label(number) + "\" class=\"node " + verdict + "\" aria-label=\"Equation (" +
                 number + "), " + verdict_text(verdict) + " as printed\"><rect x=\"" +
                 digits(x(below) - node_width / 2.0, "%.1f") + "\" y=\"" + digits(y(below) - node_height / 2.0, "%.1f") +
                 "\" width=\"" + std::to_string(node_width) + "\" height=\"" + std::to_string(node_height) +
                 "\" rx=\"4\" stroke=\"#555\" fill=\"" + fill_of(verdict) + "\"/><text fill=\"#111\" font-size=\"13\" x=\"" +
                 digits(x(below), "%.1f") + "\" y=\"" + digits(y(below) + 4, "%.1f") + "\" text-anchor=\"middle\">(" + number +
                 ")</text></a>\n";
    }
    const std::string size = "width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) + "\"";
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"equation-graph\" " + size + " viewBox=\"0 0 " +
           std::to_string(width) + " " + std::to_string(height) +
           "\" role=\"group\" aria-label=\"Graph of the equations: lines lead down from an equation to those "
           "that rest on it\">\n<g class=\"edges\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.35\">\n" +
           edges + "</g>\n" + boxes + "</svg>\n";
}

} // namespace

std::vector<Node> layout(const Json& ledger, int longest) {
    Grounds grounds, users;
    for (const Json& entry : ledger) grounds[entry.at("equation")] = entry.at("rests_on").get<std::vector<std::string>>();
    std::map<std::string, int> depth;
    std::set<std::string> above;
    int deepest = 0;
    for (const auto& [equation, on] : grounds) {
        deepest = std::max(deepest, depth_of(equation, grounds, depth, above));
        for (const std::string& ground : on) users[ground].push_back(equation);
    }
    std::vector<std::vector<std::string>> rows(static_cast<std::size_t>(deepest) + 1);
    for (const Json& entry : ledger)
        rows[static_cast<std::size_t>(depth.at(entry.at("equation")))].push_back(entry.at("equation"));
    std::map<std::string, double> x;
    spread(rows, x);
    for (int sweep = 0; sweep < 12; ++sweep) {
        for (auto& row : rows) {
            std::map<std::string, double> wish;
            for (const std::string& e : row) wish[e] = middle(sweep % 2 == 0 ? grounds[e] : users[e], x, x.at(e));
            std::stable_sort(row.begin(), row.end(),
                             [&](const std::string& a, const std::string& b) { return wish[a] < wish[b]; });
        }
        spread(rows, x);
    }
    std::map<std::string, Node> placed;
    int line = 0;
    for (const auto& row : rows) {
        const int parts = (static_cast<int>(row.size()) + longest - 1) / longest;
        const int each = parts == 0 ? 1 : (static_cast<int>(row.size()) + parts - 1) / parts;
        for (int i = 0; i < static_cast<int>(row.size()); ++i) {
            const int part = i % parts, place = i / parts; // neighbours go to lines in turn, so that each stays near its place
            placed[row[static_cast<std::size_t>(i)]] = {row[static_cast<std::size_t>(i)], line + part,
                                                        (longest - each) / 2 + place};
        }
        line += parts;
    }
    std::vector<Node> nodes;
    for (const Json& entry : ledger) nodes.push_back(placed.at(entry.at("equation")));
    int left = longest;
    for (const Node& node : nodes) left = std::min(left, node.column);
    for (Node& node : nodes) node.column -= left;
    return nodes;
}

Page graph_page(const Book& book) {
    std::string out = page_head("equation_graph", "What rests on what");
    std::size_t lines = 0;
    for (const Json& entry : book.run.ledger) lines += entry.at("rests_on").size();
    out +=
        "<p>An equation stands below everything that it rests on; a line leads from an equation down to each that rests on it. " +
        counted(book.run.ledger.size(), "equation", "equations") + ", " + counted(lines, "line", "lines") +
        ". The colour is the verdict on the printed form: " + verdict_mark("proved") + " " + verdict_mark("approximation") + " " +
        verdict_mark("definition") + " " + verdict_mark("assumption") + " " + verdict_mark("illegible") + " " +
        verdict_mark("refuted") + ". The table below says the same in words.</p>\n";
    out += "\\htmlonly[block]\n<div class=\"graph-box\" tabindex=\"0\" style=\"overflow-x:auto\">\n" +
           picture(book.run.ledger, layout(book.run.ledger, 20)) + "</div>\n\\endhtmlonly\n";
    out += "\n<div class=\"table-box\" tabindex=\"0\">\n<table class=\"doxtable rests-on\">\n<tr><th>equation</th><th>as "
           "printed</th><th>rests on</th><th>on it rest</th></tr>\n";
    for (const Json& entry : book.run.ledger)
        out += "<tr><td>" + equation_link(entry.at("equation")) + "</td><td>" + verdict_mark(entry.at("printed")) + "</td><td>" +
               equation_links(entry.at("rests_on")) + "</td><td>" + equation_links(entry.at("used_by")) + "</td></tr>\n";
    return {"equation_graph", out + "</table>\n</div>\n"};
}

} // namespace denhartog::pages
