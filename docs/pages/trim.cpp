#include "trim.hpp"

#include <algorithm>
#include <vector>

#include "class_page.hpp"
#include "finish.hpp"
#include "html.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace {

constexpr const char* contents = "<div class=\"contents\">";
constexpr const char* contents_end = "</div><!-- contents -->";

/// The name of a header in the name of its page: `formulas_2mode_8hpp` is formulas/mode.hpp.
std::string header_name(const std::string& stem) {
    std::string out;
    for (std::size_t at = 0; at < stem.size(); ++at) {
        const char next = stem[at] == '_' && at + 1 < stem.size() ? stem[++at] : '\0';
        out += next == '\0' ? stem[at] : next == '2' ? '/' : next == '8' ? '.' : '_';
    }
    return out;
}

/// Whether a page is that of a type.
bool of_type(const std::string& name) {
    return name.starts_with("struct") || name.starts_with("class") || name.starts_with("union");
}

/// Whether a reader of the site has no use for a page.
bool left_out(const std::string& name, const std::string& text) {
    for (const char* start : {"dir_", "functions", "globals", "namespacemembers", "classes.html", "hierarchy.html"})
        if (name.starts_with(start)) return true;
    if (name.ends_with("-members.html")) return true;
    if (of_type(name)) {
        const std::string from = "was generated from the following file";
        const std::string file = between(text, "<li>", "<", std::min(text.find(from), text.size()));
        const bool of_library = file.starts_with("src/denhartog/") && !file.starts_with("src/denhartog/program/");
        return text.find(from) != std::string::npos && !of_library && !file.starts_with("src/conformance/");
    }
    if (name.ends_with("_8cpp.html")) return true;
    const bool of_header = name.ends_with("_8hpp.html") || name.ends_with("_8h.html");
    return of_header && between(between(text, "<li class=\"navelem\">", "</li>"), ">", "<") != "src";
}

/// A page without its links to what is left out.
std::string relinked(const std::string& page, const std::string& own, const std::map<std::string, std::string>& kept,
                     const std::map<std::string, std::string>& out_of_site) {
    std::string out;
    std::size_t done = 0;
    for (std::size_t at = page.find("<a "); at != std::string::npos; at = page.find("<a ", at + 1)) {
        const std::size_t end = page.find('>', at), href = page.find("href=\"", at);
        if (href == std::string::npos || end == std::string::npos || href > end) continue;
        const std::size_t from = href + 6, to = page.find('"', from);
        const std::string file = page.substr(from, std::min(page.find('#', from), to) - from);
        if (!out_of_site.contains(file)) continue;
        const std::string source = file.substr(0, file.size() - 5) + "_source.html";
        out += page.substr(done, at - done);
        if (kept.contains(source) && source != own) {
            out += page.substr(at, from - at) + source;
            done = to;
        } else {
            const std::size_t close = page.find("</a>", end);
            if (source != own) out += page.substr(end + 1, close - end - 1); // to itself: "Go to the documentation of this file."
            done = close + 4;
        }
    }
    return out + page.substr(done);
}

/// A documented name on the page of a namespace.
struct Item {
    std::string anchor, name, text;
};

/// The items of a page by the stem of their header's page.
std::map<std::string, std::vector<Item>> items_of(const std::string& body) {
    std::map<std::string, std::vector<Item>> items;
    const std::string title = "<h2 class=\"memtitle\">", mark = "<a id=\"";
    for (std::size_t at = body.find(title); at != std::string::npos;) {
        const std::size_t from = body.rfind(mark, at), next = body.find(title, at + 1);
        std::size_t to = next == std::string::npos ? body.size() : body.rfind(mark, next);
        to = std::min(to, body.find("<h2 class=\"groupheader\">", at));
        const std::string text = body.substr(from, to - from), heading = between(text, title, "</h2>");
        const std::string file = between(text, "of file <a class=\"el\" href=\"", "_source.html");
        items[file].push_back({between(text, mark, "\""), text_of_html(heading.substr(heading.find("</span>"))), text});
        at = next;
    }
    return items;
}

/// The page of a namespace in a header.
std::string page_of_header(const std::string& page, const std::string& title, const std::string& back, const std::string& file,
                           const std::vector<Item>& items) {
    const std::string name = title + " in " + header_name(file);
    std::string head = page.substr(0, page.find(contents)), body;
    const std::string heading = "<h1 class=\"title\">";
    const std::size_t from = head.find(heading) + heading.size();
    head.replace(from, head.find("</h1>", from) - from, name);
    const std::size_t tab = head.find("<title>") + 7;
    head.replace(tab, head.find("</title>", tab) - tab, name + " - denhartog");
    for (const Item& item : items) body += item.text;
    return head + contents + "\n<p>The source: <a class=\"el\" href=\"" + file + "_source.html\">" + header_name(file) +
           "</a>. All of the namespace: <a class=\"el\" href=\"" + back + "\">" + title + "</a>.</p>\n" + body +
           page.substr(page.find(contents_end));
}

/// Parts the page of a namespace. @return the places that moved, `page#anchor` before and after
std::map<std::string, std::string> part(const std::string& name, std::map<std::string, std::string>& texts) {
    const std::string page = texts.at(name);
    const std::size_t start = page.find(contents), end = page.find(contents_end);
    if (start == std::string::npos || end == std::string::npos) return {};
    std::string body = page.substr(start, end - start), list;
    const auto items = items_of(body);
    if (items.size() < 2 || items.contains("")) return {};
    const std::string heading = between(page, "<h1 class=\"title\">", "</h1>");
    const std::string title = heading.substr(0, heading.find(" Namespace"));
    std::map<std::string, std::string> moved;
    for (const auto& [file, of_file] : items) {
        const std::string part_name = name.substr(0, name.size() - 5) + "_in_" + file + ".html";
        list += "<dt><a class=\"el\" href=\"" + part_name + "\">" + header_name(file) + "</a></dt>\n<dd>";
        for (const Item& item : of_file) {
            list += (&item == &of_file.front() ? "" : ", ") + ("<a class=\"el\" href=\"" + part_name) + "#" + item.anchor +
                    "\">" + html(item.name) + "</a>";
            for (const std::string& anchor : values_of(item.text, "id")) moved[name + "#" + anchor] = part_name + "#" + anchor;
        }
        list += "</dd>\n";
        texts[part_name] = page_of_header(page, title, name, file, of_file);
    }
    for (const char* kind : {"func", "enum", "var", "typedef"}) { // the tables of declarations
        const std::size_t mark = body.find("<a id=\"" + std::string(kind) + "-members\"");
        if (mark == std::string::npos) continue;
        const std::size_t from = body.rfind("<table class=\"memberdecls\">", mark), to = body.find("</table>", mark);
        body.erase(from, to + 8 - from);
    }
    const std::size_t details = body.find(" Documentation</h2>");
    body.resize(body.rfind("<h2 class=\"groupheader\">", details));
    texts[name] = page.substr(0, start) + body + "<h2 class=\"groupheader\">By header</h2>\n<dl class=\"by-header\">\n" + list +
                  "</dl>\n" + page.substr(end);
    return moved;
}

/// A page whose links follow what has moved.
std::string followed(const std::string& page, const std::map<std::string, std::string>& moved) {
    std::string out;
    std::size_t done = 0;
    const std::string open = "href=\"namespace";
    for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at + 1)) {
        const std::size_t from = at + 6, to = page.find('"', from);
        const auto found = moved.find(page.substr(from, to - from));
        if (found == moved.end()) continue;
        out += page.substr(done, from - done) + found->second;
        done = to;
    }
    return out + page.substr(done);
}

/// The lists of types and files: what is left out has no row, and all rows are shown, as no script opens them.
std::string whole_list(std::string page, const std::map<std::string, std::string>& out_of_site) {
    const std::string row = "<tr id=\"row_", levels = "<div class=\"levels\">",
                      icon = "<span class=\"icondoc\"></span></a>"; // of a link that has no name
    for (std::size_t at = page.find(row); at != std::string::npos;) {
        const std::size_t end = page.find("</tr>", at) + 5;
        std::string text = page.substr(at, end - at);
        const bool lists_type = text.find("<span class=\"icon\">C</span>") != std::string::npos;
        const bool out = lists_type && out_of_site.contains(between(text, "href=\"", "\""));
        const std::size_t hidden = text.find(" style=\"display:none;\"");
        if (hidden != std::string::npos) text.erase(hidden, 22);
        const std::size_t mark = text.find(icon);
        if (mark != std::string::npos) text.erase(text.rfind("<a ", mark), mark + icon.size() - text.rfind("<a ", mark));
        page.replace(at, end - at, out ? "" : text);
        at = page.find(row, at + (out ? 0 : text.size()));
    }
    const std::size_t at = page.find(levels);
    if (at != std::string::npos) page.erase(at, page.find("</div>", at) + 6 - at);
    return page;
}

} // namespace

void trim(std::map<std::string, std::string>& texts) {
    std::map<std::string, std::string> out_of_site;
    for (const auto& [name, text] : texts)
        if (left_out(name, text)) out_of_site.emplace(name, "");
    for (const auto& [name, nothing] : out_of_site) texts.erase(name);
    for (const char* list : {"annotated.html", "files.html", "namespaces.html"})
        if (const auto found = texts.find(list); found != texts.end()) found->second = whole_list(found->second, out_of_site);
    for (auto& [name, text] : texts)
        if (of_type(name)) text = class_page(text, name);
    std::vector<std::string> namespaces;
    for (const auto& [name, text] : texts)
        if (name.starts_with("namespacedenhartog")) namespaces.push_back(name);
    std::map<std::string, std::string> moved;
    for (const std::string& name : namespaces) moved.merge(part(name, texts));
    for (auto& [name, text] : texts) text = followed(relinked(text, name, texts, out_of_site), moved);
}

} // namespace denhartog::pages
