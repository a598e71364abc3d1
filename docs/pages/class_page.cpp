#include "class_page.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "html.hpp"

namespace denhartog::pages {

namespace {

constexpr const char *heading = "<h2 class=\"groupheader\">", *title = "<h2 class=\"memtitle\">", *anchor = "<a id=\"",
                     *details = "<a name=\"details\" id=\"details\"></a>", *origin = "<hr/>The documentation for this ";

constexpr std::pair<const char*, const char*> words[] = {
    {"\nPublic Types</h2>", "\nTypes</h2>"},
    {"\nPublic Member Functions</h2>", "\nFunctions</h2>"},
    {"\nStatic Public Member Functions</h2>", "\nStatic functions</h2>"},
    {"\nPublic Attributes</h2>", "\nMembers</h2>"},
    {"\nStatic Public Attributes</h2>", "\nStatic members</h2>"},
    {">Constructor &amp; Destructor Documentation</h2>", ">The constructors in detail</h2>"},
    {">Member Function Documentation</h2>", ">The functions in detail</h2>"},
    {">Member Data Documentation</h2>", ">The members in detail</h2>"},
    {">Member Typedef Documentation</h2>", ">The types in detail</h2>"},
    {">Member Enumeration Documentation</h2>", ">The enumerations in detail</h2>"},
    {">Friends And Related Function Documentation</h2>", ">The friends in detail</h2>"}};

/// Where the part ends that begins before a place: at the next heading, or where the page says what it was made from.
std::size_t end_of_part(const std::string& page, std::size_t from, std::initializer_list<const char*> ends) {
    std::size_t end = page.size();
    for (const char* each : ends) end = std::min(end, page.find(each, from));
    return end;
}

/// The line of the source that a box leads to, if the box says nothing but a sentence and this line; else empty.
std::string line_of_source(const std::string& box) {
    const std::size_t from = box.find("<div class=\"memdoc\">");
    if (from == std::string::npos) return "";
    const std::string said = box.substr(from + 20);
    for (const char* more : {"<dl", "<div", "<pre", "<table", "<ul", "<ol"})
        if (said.find(more) != std::string::npos) return "";
    std::size_t paragraphs = 0;
    for (std::size_t at = said.find("<p"); at != std::string::npos; at = said.find("<p", at + 1)) ++paragraphs;
    return paragraphs > 2 ? "" : between(said, "<p class=\"definition\">Definition at line <a class=\"el\" href=\"", "\"");
}

/// Whether a box could be left out: its place and its line of the source are then in the table of declarations.
bool moved_to_declaration(std::string& page, std::size_t boxes, const std::string& box, const std::string& name) {
    const std::string source = line_of_source(box), id = between(box, anchor, "\"");
    const std::string link = "<a class=\"el\" href=\"" + name + "#" + id + "\">";
    const std::string more = "<a href=\"" + name + "#" + id + "\">More...</a>";
    const std::size_t row = page.find("<tr class=\"memitem:" + id + "\">"), at = page.find(link, row);
    if (source.empty() || row == std::string::npos || at > boxes || at > page.find("</tr>", row)) return false;
    const std::size_t said = page.find(more, at);
    if (said < boxes) page.erase(said, more.size());
    page.replace(at, link.size(), "<a class=\"el\" id=\"" + id + "\" href=\"" + source + "\">");
    return true;
}

void leave_out_boxes(std::string& page, const std::string& name) {
    for (std::size_t at = page.find(title); at != std::string::npos;) {
        const std::size_t from = page.rfind(anchor, at), next = page.find(title, at + 1);
        std::size_t to = end_of_part(page, at, {heading, origin});
        if (next < to) to = page.rfind(anchor, next);
        const std::string box = page.substr(from, to - from);
        const std::size_t rest = page.size() - to;
        if (moved_to_declaration(page, from, box, name)) page.erase(page.size() - rest - box.size(), box.size());
        at = page.find(title, page.size() - rest);
    }
    for (std::size_t at = page.find(heading); at != std::string::npos;) { // headings that have nothing below them
        const std::size_t end = page.find("</h2>", at) + 5, after = page.find_first_not_of('\n', end);
        const std::string_view below = std::string_view(page).substr(std::min(after, page.size()));
        const bool empty = below.starts_with(heading) || below.starts_with(origin);
        if (empty) page.erase(at, after - at);
        at = page.find(heading, empty ? at : end);
    }
}

/// The description in place of its first sentence.
void put_description_first(std::string& page, const std::string& name) {
    const std::string more = "<a href=\"" + name + "#details\">More...</a></p>";
    const std::size_t link = page.find(more), at = page.find(details);
    if (link == std::string::npos || at == std::string::npos) return;
    const std::size_t text = page.find("</h2>", at) + 5, end = end_of_part(page, text, {heading, origin});
    const std::string description = details + page.substr(text, end - text);
    page.erase(at, end - at);
    const std::size_t first = page.rfind("<p>", link);
    page.replace(first, link + more.size() - first, description);
}

} // namespace

std::string class_page(std::string page, const std::string& name) {
    leave_out_boxes(page, name);
    put_description_first(page, name);
    for (const auto& [doxygens, ours] : words)
        if (const std::size_t at = page.find(doxygens); at != std::string::npos)
            page.replace(at, std::string(doxygens).size(), ours);
    for (const char* kind : {" Struct", " Class", " Union"}) {
        const std::size_t end = page.find("</h1>"), at = page.rfind(kind, end);
        if (end != std::string::npos && at != std::string::npos && page.substr(at, end - at).ends_with(" Reference"))
            page.erase(at, end - at);
    }
    const std::size_t at = page.find(origin);
    if (at != std::string::npos) page.replace(at, page.find(':', at) - at, "<hr/>Declared in");
    return page;
}

} // namespace denhartog::pages
