// The graph of what rests on what.
#include <algorithm>
#include <map>
#include <set>

#include "denhartog/number/errors.hpp"
#include "overview_pages.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace {

constexpr int node_width = 46, node_height = 24, column_pitch = 56, row_pitch = 46, margin = 16, top = 34;

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

/// The sections in the order of the entries, and how many columns the band of each has: those with crowded rows get more.
struct Bands {
    std::vector<std::string> names;
    std::map<std::string, int> width, first;
};

Bands bands_of(const std::vector<std::string>& sections, const std::map<std::string, std::size_t>& crowded, int longest) {
    Bands bands;
    for (const std::string& section : sections)
        if (bands.width.emplace(section, 1).second) bands.names.push_back(section);
    for (int left = longest - static_cast<int>(bands.names.size()); left > 0; --left) {
        const auto load = [&](const std::string& name) { return static_cast<double>(crowded.at(name)) / bands.width.at(name); };
        const auto fullest = std::max_element(bands.names.begin(), bands.names.end(),
                                              [&](const auto& a, const auto& b) { return load(a) < load(b); });
        if (load(*fullest) <= 1) break;
        ++bands.width[*fullest];
    }
    int at = 0;
    for (const std::string& name : bands.names) {
        bands.first[name] = at;
        at += bands.width[name];
    }
    return bands;
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
    const auto y = [](const Node& n) { return top + n.row * row_pitch + node_height / 2.0; };
    const int width = 2 * margin + (columns - 1) * column_pitch + node_width;
    const int height = top + margin + (rows - 1) * row_pitch + node_height;
    std::map<std::string, std::pair<int, int>> bands;
    for (const Node& node : nodes) {
        const auto [band, fresh] = bands.try_emplace(node.section, node.column, node.column);
        if (!fresh) band->second = {std::min(band->second.first, node.column), std::max(band->second.second, node.column)};
    }
    std::string shades;
    bool shaded = true;
    std::map<int, std::string> in_order;
    for (const auto& [section, ends] : bands) in_order[ends.first] = section;
    for (const auto& [first, section] : in_order) {
        const int left = margin + first * column_pitch - (column_pitch - node_width) / 2;
        const int wide = (bands.at(section).second - first + 1) * column_pitch;
        if (shaded)
            shades += "<rect class=\"band\" x=\"" + std::to_string(left) + "\" y=\"0\" width=\"" + std::to_string(wide) +
                      "\" height=\"" + std::to_string(height) + "\" fill-opacity=\"0.05\"/>\n";
        shades += "<text class=\"band-name\" font-size=\"13\" fill=\"currentColor\" x=\"" + std::to_string(left + wide / 2) +
                  "\" y=\"18\" text-anchor=\"middle\">" + (section == "Appendix" ? "App." : section) + "</text>\n";
        shaded = !shaded;
    }
    std::string edges, boxes;
    for (const Json& entry : ledger) {
        const Node& below = *at.at(entry.at("equation"));
        for (const Json& ground : entry.at("rests_on")) {
            const Node& above = *at.at(ground);
            const double from = y(above) + node_height / 2.0, to = y(below) - node_height / 2.0, bend = (to - from) / 2;
            edges += "<path data-from=\"" + ground.get<std::string>() + "\" data-to=\"" +
                     entry.at("equation").get<std::string>() + "\" d=\"M " + point(x(above), from) + " C " +
                     point(x(above), from + bend) + " " + point(x(below), to - bend) + " " + point(x(below), to) + "\"/>\n";
        }
        const std::string number = entry.at("equation"), verdict = entry.at("printed");
        boxes += "<a href=\"page:" + equation_label(number) + "\" class=\"node " + verdict + "\" data-equation=\"" + number +
                 "\" aria-label=\"Equation (" + number + "), " + verdict_text(verdict) + " as printed\"><rect x=\"" +
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
           "that rest on it\">\n" +
           shades + "<g class=\"edges\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.35\">\n" + edges + "</g>\n" +
           boxes + "</svg>\n";
}

} // namespace

std::vector<Node> layout(const Json& ledger, int longest) {
    Grounds grounds;
    std::vector<std::string> sections;
    for (const Json& entry : ledger) {
        grounds[entry.at("equation")] = entry.at("rests_on").get<std::vector<std::string>>();
        sections.push_back(entry.value("section", ""));
    }
    std::map<std::string, int> depth;
    std::set<std::string> above;
    int deepest = 0;
    for (const auto& [equation, on] : grounds) deepest = std::max(deepest, depth_of(equation, grounds, depth, above));
    std::vector<std::map<std::string, std::vector<std::string>>> rows(static_cast<std::size_t>(deepest) + 1);
    std::map<std::string, std::size_t> crowded;
    for (const Json& entry : ledger) {
        const std::string section = entry.value("section", "");
        std::vector<std::string>& cell = rows[static_cast<std::size_t>(depth.at(entry.at("equation")))][section];
        cell.push_back(entry.at("equation"));
        crowded[section] = std::max(crowded[section], cell.size());
    }
    const Bands bands = bands_of(sections, crowded, longest);
    std::map<std::string, Node> placed;
    int line = 0;
    for (const auto& row : rows) {
        int lines = 0;
        for (const auto& [section, cell] : row) {
            const int width = bands.width.at(section);
            for (int i = 0; i < static_cast<int>(cell.size()); ++i)
                placed[cell[static_cast<std::size_t>(i)]] = {cell[static_cast<std::size_t>(i)], line + i / width,
                                                             bands.first.at(section) + i % width, section};
            lines = std::max(lines, (static_cast<int>(cell.size()) + width - 1) / width);
        }
        line += lines;
    }
    std::vector<Node> nodes;
    for (const Json& entry : ledger) nodes.push_back(placed.at(entry.at("equation")));
    return nodes;
}

Page graph_page(const Book& book) {
    std::string out = page_head("equation_graph", "What rests on what");
    std::size_t lines = 0;
    for (const Json& entry : book.run.ledger) lines += entry.at("rests_on").size();
    out += "<p>An equation stands below everything that it rests on; a line leads from an equation down to each that uses it. "
           "The bands are the "
           "sections of the paper. Point at an equation, or move to it with the keyboard, to see all that it rests on; click to "
           "read it. " +
           counted(book.run.ledger.size(), "equation", "equations") + ", " + counted(lines, "line", "lines") +
           ". The colour is the verdict on the printed form: " + verdict_mark("proved") + " " + verdict_mark("approximation") +
           " " + verdict_mark("definition") + " " + verdict_mark("assumption") + " " + verdict_mark("illegible") + " " +
           verdict_mark("refuted") + ". The table below says the same in words.</p>\n";
    out += "\\htmlonly[block]\n<div class=\"graph-box\" tabindex=\"0\" style=\"overflow-x:auto\">\n" +
           picture(book.run.ledger, layout(book.run.ledger, 20)) +
           "</div>\n<div id=\"graph-statement\" aria-live=\"polite\"><p>Click an equation to read it "
           "here.</p></div>\n\\endhtmlonly\n";
    out += "\n<div class=\"table-box\" tabindex=\"0\">\n<table class=\"doxtable rests-on\">\n<tr><th>equation</th><th>as "
           "printed</th><th>rests on</th><th>used by</th></tr>\n";
    for (const Json& entry : book.run.ledger)
        out += "<tr><td>" + equation_link(entry.at("equation")) + "</td><td>" + verdict_mark(entry.at("printed")) + "</td><td>" +
               equation_links(entry.at("rests_on")) + "</td><td>" + equation_links(entry.at("used_by")) + "</td></tr>\n";
    return {"equation_graph", out + "</table>\n</div>\n"};
}

} // namespace denhartog::pages
