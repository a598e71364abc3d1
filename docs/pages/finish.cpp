#include "finish.hpp"

#include <array>
#include <map>
#include <set>
#include <utility>

#include "denhartog/program/output/files.hpp"
#include "derivation/ledger/source_text.hpp"
#include "html.hpp"
#include "trim.hpp"

namespace denhartog::pages {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_text = 1200;

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// Cuts every element from an opening to its end out of a text.
void cut(std::string& text, const std::string& open, const std::string& close) {
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
        const std::size_t end = text.find(close, at);
        if (end == std::string::npos) return;
        text.erase(at, end + close.size() - at);
    }
}

/// What the search keeps of a text: not too much, and formulas without their TeX.
std::string shortened(std::string text) {
    for (const char* mark : {"\\(", "\\)", "\\", "{", "}"}) replace_all(text, mark, "");
    if (text.size() <= longest_text) return text;
    text.resize(longest_text);
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) text.pop_back();
    if (!text.empty() && (static_cast<unsigned char>(text.back()) & 0x80U) != 0) text.pop_back();
    return text;
}

/// Puts a table of Markdown into a box that scrolls where the page is narrow.
void box_tables(std::string& page) {
    const std::string table = "<table class=\"markdownTable\">", box = "<div class=\"table-box\" tabindex=\"0\">",
                      end = "</table>";
    for (std::size_t at = page.find(table); at != std::string::npos; at = page.find(table, at)) {
        const std::size_t close = page.find(end, at);
        if (close == std::string::npos) return;
        page.insert(close + end.size(), "</div>");
        page.insert(at, box);
        at += box.size() + table.size();
    }
}

/// Joins the pieces into which Doxygen breaks an element with paragraphs in it.
void join_pieces(std::string& page) {
    const std::string open = "<div class=\"", seam = "</div>" + open;
    for (std::size_t at = page.find(seam); at != std::string::npos; at = page.find(seam, at)) {
        const std::size_t from = at + seam.size(), to = page.find('"', from), before = page.rfind(open, at - 1);
        const std::string name = page.substr(from, to - from);
        const bool own = name == "claim" || name.starts_with("verdict ") || name == "erratum";
        if (own && before != std::string::npos && page.compare(before + open.size(), name.size() + 1, name + "\"") == 0)
            page.erase(at, page.find('>', to) + 1 - at);
        else
            at = from;
    }
}

/// A page with what its links can lead to.
struct Page {
    std::string text;
    std::set<std::string> anchors;
};

void follow(const std::string& from, const std::string& target, const fs::path& site, const std::map<std::string, Page>& pages,
            FinishedSite& out) {
    if (target.empty() || target.starts_with("data:") || target.starts_with("javascript:void")) return;
    if (target == "https://doi.org/10.1016/j.jsv.2022.117085") return; // the paper
    if (target.find("//") != std::string::npos || target.starts_with("mailto:")) {
        out.faults.push_back(from + " leads elsewhere: " + target);
        return;
    }
    ++out.links;
    const std::size_t hash = target.find('#'), query = target.find('?');
    const std::string file = target.substr(0, std::min(hash, query));
    const std::string anchor = hash == std::string::npos ? "" : target.substr(hash + 1);
    const auto page = pages.find(file.empty() ? from : file);
    if (page == pages.end()) {
        if (!fs::exists(site / file)) out.faults.push_back(from + " leads to " + file + ", which is not there");
        return;
    }
    if (!anchor.empty() && !page->second.anchors.contains(anchor))
        out.faults.push_back(from + " leads to " + target + ", but there is no such place on that page");
}

} // namespace

std::string finished_page(std::string page) {
    const std::string open = "<div class=\"title\">";
    if (page.find("<h1>") != std::string::npos && page.find("class=\"memtitle\"") == std::string::npos)
        for (const char order : {'3', '2', '1'}) // sections stand below the title
            for (const char* bracket : {"<h", "</h"})
                replace_all(page, std::string(bracket) + order + ">", std::string(bracket) + static_cast<char>(order + 1) + ">");
    const std::size_t at = page.find(open);
    if (at != std::string::npos) {
        const std::size_t from = at + open.size(), end = page.find("</div>", from), inner = page.find("<div", from);
        page.insert(std::min(end, inner), "</h1>");
        page.replace(at, open.size(), "<div><h1 class=\"title\">");
    }
    join_pieces(page);
    box_tables(page);
    cut(page, "<div class=\"summary\">", "</div>"); // its links lead to headings that are left out where all is private
    replace_all(page, "<div class=\"fragment\">", "<div class=\"fragment\" tabindex=\"0\">");
    replace_all(page, "<div class=\"memproto\">", "<div class=\"memproto\" tabindex=\"0\">");
    return page;
}

std::string text_of_html(const std::string& html) {
    std::string bare = html, out;
    cut(bare, "<script", "</script>");
    cut(bare, "<style", "</style>");
    bool tag = false;
    for (const char c : bare) {
        if (c == '<') tag = true;
        const bool blank = tag || c == ' ' || c == '\n' || c == '\t';
        if (!blank)
            out += c;
        else if (!out.empty() && out.back() != ' ')
            out += ' ';
        if (c == '>') tag = false;
    }
    constexpr std::array<std::pair<const char*, const char*>, 8> entities{{{"&lt;", "<"},
                                                                           {"&gt;", ">"},
                                                                           {"&quot;", "\""},
                                                                           {"&#39;", "'"},
                                                                           {"&#160;", " "},
                                                                           {"&le;", "<="},
                                                                           {"&ge;", ">="},
                                                                           {"&amp;", "&"}}};
    for (const auto& [entity, meant] : entities) replace_all(out, entity, meant);
    return out.ends_with(' ') ? out.substr(0, out.size() - 1) : out;
}

std::vector<nlohmann::json> search_documents(const std::string& page, const std::string& name) {
    const std::string title = text_of_html(between(page, "<h1 class=\"title\">", "</h1>"));
    if (title.empty()) return {};
    std::string body = between(page, "<div class=\"contents\">", "<footer");
    cut(body, "<div class=\"eq-nav\">", "</div>");
    cut(body, "<p class=\"eq-contents\">", "</p>");
    cut(body, "<div class=\"copies\">", "</div>");
    cut(body, "<form", "</form>");
    cut(body, "\\[", "\\]");
    const std::string member = "<h2 class=\"memtitle\">";
    const std::size_t first = body.find(member);
    std::vector<nlohmann::json> out{{{"title", title}, {"url", name}, {"text", shortened(text_of_html(body.substr(0, first)))}}};
    for (std::size_t at = first; at != std::string::npos; at = body.find(member, at + 1)) {
        const std::string heading = between(body, member, "</h2>", at), anchor = between(heading, "href=\"#", "\"");
        const std::size_t named = heading.find("</span>");
        if (anchor.empty() || named == std::string::npos) continue;
        const std::string item = body.substr(at + member.size(), body.find(member, at + 1) - at - member.size());
        const std::string text = item.substr(std::min(item.find("<div class=\"memdoc\">"), item.size()));
        out.push_back({{"title", text_of_html(heading.substr(named))},
                       {"url", name + "#" + anchor},
                       {"text", shortened(text_of_html(text))}});
    }
    return out;
}

int kind_of_page(const std::string& name) {
    if (name.starts_with("eq_")) return name.find("_more") == std::string::npos ? 0 : 3;
    if (name.starts_with("figure_") || name.starts_with("derivation_")) return 1;
    const bool of_code = name.starts_with("namespace") || name.starts_with("struct") || name.starts_with("class") ||
                         name.starts_with("dir_") || name.starts_with("functions") || name.starts_with("globals") ||
                         name.starts_with("group__") || name.find("_8") != std::string::npos ||
                         name.find("-members") != std::string::npos;
    return of_code ? 4 : 2;
}

FinishedSite finish_site(const fs::path& site) {
    FinishedSite out;
    std::map<std::string, Page> pages;
    std::string map;
    nlohmann::json documents = nlohmann::json::array();
    std::map<std::string, std::string> before, texts;
    for (const fs::path& file : derivation::files_in(site, ".html"))
        if (file.parent_path() == site) before.emplace(file.filename().string(), derivation::text_of(file));
    for (const auto& [name, text] : before) texts.emplace(name, finished_page(text));
    trim(texts);
    for (const auto& [name, text] : before)
        if (!texts.contains(name)) fs::remove(site / name);
    for (auto& [name, text] : texts) {
        const auto old = before.find(name);
        if (old == before.end() || text != old->second) program::write_file((site / name).string(), text);
        Page page{std::move(text), {}};
        for (const char* attribute : {"id", "name"})
            for (const std::string& value : values_of(page.text, attribute)) page.anchors.insert(value);
        if (!name.ends_with("_source.html"))
            for (nlohmann::json& each : search_documents(page.text, name)) {
                each["kind"] = kind_of_page(name);
                documents.push_back(std::move(each));
            }
        if (kind_of_page(name) < 4) map += name + "\n";
        pages.emplace(name, std::move(page));
    }
    program::write_file((site / "sitemap.txt").string(), map);
    program::write_file((site / "search-documents.js").string(), "window.searchDocuments = " + documents.dump(0) + ";\n");
    for (const auto& [name, page] : pages)
        for (const char* attribute : {"href", "src"})
            for (const std::string& target : values_of(page.text, attribute)) follow(name, target, site, pages, out);
    out.pages = pages.size();
    out.documents = documents.size();
    return out;
}

} // namespace denhartog::pages
