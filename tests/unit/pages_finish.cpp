// The last pass over the site: what it changes, what the search gets, and what it will not let through.
#include <filesystem>
#include <fstream>

#include "pages/finish.hpp"
#include "tests/catch.hpp"

using namespace denhartog::pages;

namespace {

/// A site in a folder of its own.
struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / "denhartog-pages-finish";
    Folder() {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    void write(const std::string& name, const std::string& text) const { std::ofstream(path / name) << text; }
};

} // namespace

TEST_CASE("a page gets its title as a heading, and a table a box to scroll in", "[pages]") {
    const std::string title = "<div class=\"headertitle\"><div class=\"title\">Equation (46)</div></div>";
    CHECK(finished_page(title).find("<h1 class=\"title\">Equation (46)</h1>") != std::string::npos);
    CHECK(finished_page("<div class=\"title\">T</div><h1>S</h1><h2>U</h2>") ==
          "<div><h1 class=\"title\">T</h1></div><h2>S</h2><h3>U</h3>");
    CHECK(finished_page("<table class=\"markdownTable\">x</table>y") ==
          "<div class=\"table-box\" tabindex=\"0\"><table class=\"markdownTable\">x</table></div>y");
    CHECK(finished_page(
              "<div class=\"claim\">a</div><div class=\"claim\">b</div> <div class=\"claim\">c</div><div class=\"x\">d</div>") ==
          "<div class=\"claim\">ab</div> <div class=\"claim\">c</div><div class=\"x\">d</div>");
    const std::string groups = finished_page("<div class=\"title\">f<div class=\"ingroups\">g</div></div>");
    CHECK(groups == "<div><h1 class=\"title\">f</h1><div class=\"ingroups\">g</div></div>");
}

TEST_CASE("the search knows a page and each documented name on it", "[pages]") {
    const std::string page =
        "<h1 class=\"title\">paper</h1><div class=\"contents\"><p>The formulas, R &lt; 1.</p>"
        "<h2 class=\"memtitle\"><span class=\"permalink\"><a href=\"#a1\">&#9670;&#160;</a></span>d()</h2>"
        "<div class=\"memproto\">d(tau)</div><div class=\"memdoc\"><p>Free <b>motion</b> \\(d_i\\).</p></div>"
        "</div><footer></footer>";
    const auto found = search_documents(page, "paper.html");
    REQUIRE(found.size() == 2);
    CHECK(found[0]["title"] == "paper");
    CHECK(found[0]["text"] == "The formulas, R < 1.");
    CHECK(found[1]["title"] == "d()");
    CHECK(found[1]["url"] == "paper.html#a1");
    CHECK(found[1]["text"] == "Free motion d_i.");
    CHECK(search_documents("<p>no heading</p>", "x.html").empty());
    CHECK(kind_of_page("eq_57.html") < kind_of_page("figure_fig07.html"));
    CHECK(kind_of_page("errata.html") < kind_of_page("eq_57_more.html"));
    CHECK(kind_of_page("notation.html") < kind_of_page("structdenhartog_1_1Boundary.html"));
    CHECK(text_of_html("<script>x</script> a\n <i>b</i>&amp;lt; ") == "a b &lt;");
}

TEST_CASE("a broken link, a missing place and an address elsewhere are faults of the site", "[pages]") {
    const Folder site;
    site.write("a.html", "<h1 class=\"title\">A</h1><a href=\"b.html#there\">b</a> <a href=\"#own\" id=\"own\">o</a>"
                         " <a href=\"b.html?q=1\">q</a> <script src=\"search-documents.js\"></script>");
    site.write("b.html", "<p id=\"there\">b</p>");
    const FinishedSite sound = finish_site(site.path);
    CHECK(sound.faults.empty());
    CHECK(sound.pages == 2);
    CHECK(sound.links == 4);
    CHECK(sound.documents == 1);
    CHECK(std::filesystem::exists(site.path / "search-documents.js"));
    CHECK(std::filesystem::exists(site.path / "sitemap.txt"));
    site.write("paper.html", "<a href=\"https://doi.org/10.1016/j.jsv.2022.117085\">the paper</a>");
    CHECK(finish_site(site.path).faults.empty());

    for (const char* wrong : {"<a href=\"none.html\">x</a>", "<a href=\"b.html#nowhere\">x</a>", "<a href=\"#nowhere\">x</a>",
                              "<img src=\"none.svg\">", "<a href=\"https://example.org\">x</a>"}) {
        site.write("c.html", wrong);
        INFO(wrong);
        CHECK(finish_site(site.path).faults.size() == 1);
    }
}
