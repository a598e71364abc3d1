// What the pages make of plain text, and what they refuse.
#include "pages/check.hpp"
#include "pages/link.hpp"
#include "pages/measured_pages.hpp"
#include "pages/text.hpp"
#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::pages;
using denhartog::tests::tells;

namespace {

/// One page for each equation, with nothing on it.
std::vector<Page> empty_pages() {
    std::vector<Page> all;
    for (const std::string& equation : ledger::equation_numbers())
        all.push_back({equation_label(equation), page_head(equation_label(equation), "Equation (" + equation + ")")});
    return all;
}

} // namespace

TEST_CASE("what is special to Doxygen and HTML is escaped", "[pages]") {
    CHECK(escaped("a < b & c @ d # 5 % \\ _x_ *y* \"z\"") ==
          "a &lt; b &amp; c \\@ d \\# 5 \\% \\\\ \\_x\\_ \\*y\\* &quot;z&quot;");
    CHECK(html("<a href=\"b\">&") == "&lt;a href=&quot;b&quot;&gt;&amp;");
}

TEST_CASE("symbols in plain text become the paper's", "[pages]") {
    CHECK(symbol("zeta_i", false) == "\\zeta_{i}");
    CHECK(symbol("V_dj", false) == "V_{dj}");
    CHECK(symbol("U_j", true) == "U_{dj}");
    CHECK(symbol("V_jr", true) == "\\mathrm{Re}\\,V_{dj}");
    CHECK(symbol("v_i1", true) == "\\mathrm{Im}\\,v_{d1}");
    CHECK(symbol("eta_prime_0", true) == "\\eta_{0}'");
    CHECK(symbol("X_j", false) == "\\overline{X}_{j}");
    CHECK(symbol("R1", true) == "R_{1}");
    CHECK(symbol("psi_k_abs", true) == "|\\psi_{k}|");
    CHECK(symbol("PA", true) == "\\mathcal{A}");
    CHECK(symbol("beta_lim", false) == "\\beta_{\\lim}");
    CHECK(symbol("mode_functions", false).empty());
    CHECK(symbol("S", false).empty());
}

TEST_CASE("a sentence of the run gets its links and symbols, and paths stay as they are", "[pages]") {
    CHECK(prose("by (46) and (A.7)") == "by \\ref eq_46 \"(46)\" and \\ref eq_A_7 \"(A.7)\"");
    CHECK(prose("sin(2) is no equation, nor (2022), (0)") == "sin(2) is no equation, nor (2022), (0)");
    CHECK(prose("zeta_i <= 1 -> R_i") == "\\f$\\zeta_{i}\\f$ ≤ 1 → \\f$R_{i}\\f$");
    CHECK(prose("mode_functions.hpp, beta.hpp") == "mode\\_functions.hpp, beta.hpp");
    CHECK(prose("SDOF zeta=0.001 r=0.95.") == "SDOF \\f$\\zeta=0.001\\f$ \\f$r=0.95\\f$.");
    CHECK(prose("x_j'/sin(tau)") == "\\f$\\bar{x}_{j}'\\f$/\\f$\\sin(\\tau)\\f$");
    CHECK(prose("zeta_i > 0 or 1/R_i not odd") == "\\f$\\zeta_{i}\\f$ &gt; 0 or 1/\\f$R_{i}\\f$ not odd");
    CHECK(prose("tests/limits/R_i") == "tests/limits/R\\_i");
    CHECK(prose("zeta/r_n,i") == "\\f$\\zeta\\f$/\\f$r_{n,i}\\f$");
    CHECK(witness_value("-329/333") == "\\f$-\\tfrac{329}{333}\\f$");
    CHECK(witness_value("0.105313493022638536325369615526715714") == "0.10531349302263853632…");
    CHECK(witness_value("0.25") == "0.25");
}

TEST_CASE("pages of all equations with labels that are there have no fault", "[pages]") {
    std::vector<Page> all = empty_pages();
    all[3].text += "see " + equation_link("A.8") + ", " + formula("\\frac{a}{b}") + displayed("|x|");
    CHECK(faults_of(all).empty());
}

TEST_CASE("an equation without page, an unknown label and a label that is there twice are faults", "[pages]") {
    std::vector<Page> all = empty_pages();
    all.erase(all.begin() + 45);
    all[0].text += "\\ref figure_nowhere \"a figure\"";
    all[1].text += "\\anchor eq_1\n";
    const std::vector<std::string> faults = faults_of(all);
    CHECK(tells(faults, "equation (46) has no page"));
    CHECK(tells(faults, "links to figure_nowhere"));
    CHECK(tells(faults, "eq_1 is there twice"));
}

TEST_CASE("raw LaTeX, an open formula, unmatched braces and a place-holder are faults", "[pages]") {
    const auto faults_with = [](const std::string& text) {
        std::vector<Page> all = empty_pages();
        all[0].text += text;
        return faults_of(all);
    };
    CHECK(tells(faults_with("the \\frac{a}{b} of"), "LaTeX outside of a formula"));
    CHECK(tells(faults_with("price 5 $ x"), "dollar outside of a formula"));
    CHECK(tells(faults_with("\\f$ a + b"), "not closed"));
    CHECK(tells(faults_with(formula("\\frac{a}{b")), "braces do not match"));
    CHECK(tells(faults_with("{{equation 26}}"), "place-holder"));
    CHECK(faults_with("\\htmlonly[block]\n$ \\frac \\endhtmlonly").empty());
}

TEST_CASE("tables of the surveys become HTML, and a ragged row is refused", "[pages]") {
    const std::string out = tables_as_html("## Head\n\n| a | b |\n| --- | --- |\n| (38) | x \\| y |\n\nA note.\n", "speed");
    CHECK(out.find("\\section speed_1 Head") != std::string::npos);
    CHECK(out.find("<tr><th>a</th><th>b</th></tr>") != std::string::npos);
    CHECK(out.find("<td>\\ref eq_38 \"(38)\"</td><td>x | y</td>") != std::string::npos);
    CHECK(out.find("<p>A note.</p>") != std::string::npos);
    CHECK(out.find("---") == std::string::npos);
    CHECK_THROWS_WITH(tables_as_html("| a | b |\n|---|---|\n| 1 |\n", "x"), Catch::Contains("as many cells"));
}

TEST_CASE("links to lines of sources are resolved through the tag file, or reported", "[pages]") {
    const tests::Folder folder;
    const std::string root = (folder.path() / "root").string();
    const std::string tags =
        folder.write("tags.xml", "<tagfile>\n<compound kind=\"file\">\n<name>mode.hpp</name>\n<path>" + root +
                                     "/src/a/</path>\n<filename>a_2mode_8hpp</filename>\n<member kind=\"function\">"
                                     "<name>d</name></member>\n</compound>\n<compound kind=\"page\">\n"
                                     "<name>eq_46</name>\n<filename>eq_46</filename>\n</compound>\n</tagfile>\n");
    folder.write("site/a_2mode_8hpp_source.html", "<a id=\"l00042\"></a>");
    folder.write("site/eq_46.html", "<a href=\"source:src/a/mode.hpp:42\">x</a><a href=\"page:eq_46\">y</a>");
    std::size_t resolved = 0;
    CHECK(link_site(folder.path() / "site", tags, root, resolved).empty());
    CHECK(resolved == 2);
    std::ifstream in(folder.path() / "site/eq_46.html");
    CHECK(std::string(std::istreambuf_iterator<char>(in), {}) ==
          "<a href=\"a_2mode_8hpp_source.html#l00042\">x</a><a href=\"eq_46.html\">y</a>");

    folder.write("site/bad.html", "<a href=\"source:src/a/mode.hpp:43\"><a href=\"source:src/b.hpp:1\"><a href=\"page:eq_99\">"
                                  "<a href=\"source:src/a/mode.hpp:x\"><a href=\"source:\">");
    const std::vector<std::string> faults = link_site(folder.path() / "site", tags, root, resolved);
    CHECK(tells(faults, "mode.hpp:43 leads to a line that"));
    CHECK(tells(faults, "source:src/b.hpp:1, which"));
    CHECK(tells(faults, "page:eq_99, which"));
    CHECK(tells(faults, "mode.hpp:x, which"));
}
