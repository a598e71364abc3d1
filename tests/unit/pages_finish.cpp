// The last pass over the site: what it changes, what the search gets, and what it will not let through.
#include <filesystem>
#include <fstream>

#include "pages/class_page.hpp"
#include "pages/finish.hpp"
#include "pages/trim.hpp"
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

TEST_CASE("the site leaves out pages that nobody reads and parts a namespace by header", "[pages]") {
    const std::string folder = "<li class=\"navelem\"><a class=\"el\" href=\"dir_1.html\">";
    const std::string struct_of = "was generated from the following file:<ul><li>";
    const auto item = [](const std::string& anchor, const std::string& name, const std::string& file) {
        return "<a id=\"" + anchor + "\" name=\"" + anchor + "\"></a>\n<h2 class=\"memtitle\"><span class=\"permalink\"></span>" +
               name + "</h2>\n<p>Says " + name + " of file <a class=\"el\" href=\"" + file + "_source.html\">x</a>.</p>\n";
    };
    std::map<std::string, std::string> texts{
        {"eq_80.html", "<a href=\"structA-members.html\">list</a> <a href=\"namespacedenhartog.html#a1\">f</a>"},
        {"structA-members.html", ""},
        {"structA.html", struct_of + "src/denhartog/scene/<a"},
        {"structB.html", struct_of + "tests/unit/<a"},
        {"x_8hpp.html", folder + "tests</a></li>"},
        {"x_8hpp_source.html", "<a href=\"x_8hpp.html\">Go to the documentation of this file.</a><a href=\"structB.html\">B</a>"},
        {"c_8h.html", folder + "src</a></li><a href=\"x_8hpp.html#there\">x</a>"},
        {"namespacedenhartog.html",
         "<title>t</title><h1 class=\"title\">denhartog Namespace Reference</h1><div class=\"contents\">\n<p>All.</p><table "
         "class=\"memberdecls\"><a id=\"func-members\" name=\"func-members\"></a></table><h2 class=\"groupheader\">Function "
         "Documentation</h2>\n" +
             item("a1", "f()", "one_8hpp") + item("a2", "g()", "two_2x__y_8hpp") + "</div><!-- contents -->"},
        {"one_8hpp_source.html", ""},
        {"two_2x__y_8hpp_source.html", ""}};
    denhartog::pages::trim(texts);
    CHECK_FALSE(texts.contains("structA-members.html"));
    CHECK_FALSE(texts.contains("structB.html"));
    CHECK_FALSE(texts.contains("x_8hpp.html"));
    CHECK(texts.contains("structA.html"));
    CHECK(texts.contains("c_8h.html"));
    CHECK(texts.at("eq_80.html") == "list <a href=\"namespacedenhartog_in_one_8hpp.html#a1\">f</a>");
    CHECK(texts.at("x_8hpp_source.html") == "B");
    CHECK(texts.at("c_8h.html").find("<a href=\"x_8hpp_source.html\">x</a>") != std::string::npos);
    const std::string& list = texts.at("namespacedenhartog.html");
    CHECK(list.find("memberdecls") == std::string::npos);
    CHECK(list.find("Says") == std::string::npos);
    CHECK(list.find("namespacedenhartog_in_two_2x__y_8hpp.html#a2\">g()</a>") != std::string::npos);
    const std::string& part = texts.at("namespacedenhartog_in_two_2x__y_8hpp.html");
    CHECK(part.find("<h1 class=\"title\">denhartog in two/x_y.hpp</h1>") != std::string::npos);
    CHECK(part.find("Says g()") != std::string::npos);
    CHECK(part.find("Says f()") == std::string::npos);
}

TEST_CASE("the page of a type begins with its description and says nothing twice", "[pages]") {
    const auto row = [](const std::string& id) {
        return "<tr class=\"memitem:" + id + "\"><td><a class=\"el\" href=\"structA.html#" + id + "\">" + id +
               "</a></td></tr>\n<tr class=\"memdesc:" + id + "\"><td>says " + id + " <a href=\"structA.html#" + id +
               "\">More...</a></td></tr>\n";
    };
    const auto box = [](const std::string& id, const std::string& more) {
        return "<a id=\"" + id + "\" name=\"" + id + "\"></a>\n<h2 class=\"memtitle\">" + id +
               "</h2>\n<div class=\"memdoc\">\n<p>says " + id +
               "</p>\n<p class=\"definition\">Definition at line <a class=\"el\" href=\"a_8hpp_source.html#l00001\">1</a>.</p>" +
               more + "</div>\n";
    };
    const std::string page = denhartog::pages::class_page(
        "<h1 class=\"title\">A Struct Reference</h1>\n<p>Brief. <a href=\"structA.html#details\">More...</a></p>\n<table>" +
            row("one") + row("two") + row("three") +
            "</table>\n<a name=\"details\" id=\"details\"></a><h2 class=\"groupheader\">Detailed Description</h2>\n"
            "<div>Brief. All of it.</div><h2 class=\"groupheader\">Member Function Documentation</h2>\n" +
            box("one", "<dl><dd>its parameters</dd></dl>") + "<h2 class=\"groupheader\">Member Data Documentation</h2>\n" +
            box("two", "") + box("three", "") +
            "<hr/>The documentation for this struct was generated from the following file:<ul></ul>",
        "structA.html");
    CHECK(page.find("<h1 class=\"title\">A</h1>\n<a name=\"details\" id=\"details\"></a>\n<div>Brief. All of it.</div>") == 0);
    CHECK(page.find("says one", page.find("in detail")) != std::string::npos);
    CHECK(page.find("structA.html#one\">More...") != std::string::npos);
    for (const std::string id : {"two", "three"}) {
        INFO(id);
        CHECK(page.find("<a class=\"el\" id=\"" + id + "\" href=\"a_8hpp_source.html#l00001\">" + id) != std::string::npos);
        CHECK(page.find("says " + id) == page.rfind("says " + id));
        CHECK(page.find("structA.html#" + id) == std::string::npos);
    }
    CHECK(page.find("Data") == std::string::npos);
    CHECK(page.ends_with("</div>\n<hr/>Declared in:<ul></ul>"));
}
