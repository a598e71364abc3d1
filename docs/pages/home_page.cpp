#include "home_page.hpp"

#include <algorithm>
#include <cmath>

#include "conformance/plain/closed_form.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace {

/// The example of the program's page: three masses, the second in contact, the first driven.
conformance::ProtocolQuestion example(const std::string& quantity, int mass) {
    conformance::ProtocolQuestion q;
    q.quantity = quantity;
    q.mass_ratios = {1, 2.5, 0.75};
    q.stiffness_ratios = {1, 0.625, 1.875};
    q.damping_ratios = {0.03, 0.06, 0.09};
    q.contact = 2;
    q.load = 1;
    q.mu = 1.375;
    q.r = 1.125;
    q.beta = 0.15625;
    q.mass = mass;
    return q;
}

std::vector<double> motion_of(int mass, int samples) {
    std::vector<double> motion;
    for (int i = 0; i < samples; ++i) {
        conformance::ProtocolQuestion q = example("displacement", mass);
        q.tau = 2 * std::acos(-1.0) * i / samples;
        const bool second_half = q.tau > std::acos(-1.0);
        if (second_half) q.tau -= std::acos(-1.0);
        const auto x = conformance::plain_answer(q);
        motion.push_back(x ? (second_half ? -1 : 1) * x->numbers.front() : 0);
    }
    return motion;
}

std::string keyframes(const std::string& name, const std::vector<std::string>& transforms) {
    std::string out = "@keyframes " + name + " {";
    for (std::size_t i = 0; i <= transforms.size(); ++i)
        out += digits(100.0 * static_cast<double>(i) / static_cast<double>(transforms.size()), "%.2f") +
               "% { transform: " + transforms[i % transforms.size()] + "; } ";
    return out + "}\n";
}

/// The chain as the paper draws it, in the steady motion that the library computes; at rest where motion is not wanted.
std::string picture() {
    constexpr int samples = 36;
    constexpr double pixels = 17, length = 90;
    std::vector<std::vector<double>> x{std::vector<double>(samples, 0.0)};
    for (int mass = 1; mass <= 3; ++mass) x.push_back(motion_of(mass, samples));
    std::string style = "<style>@media (prefers-reduced-motion: no-preference) {\n", drawn;
    for (int mass = 1; mass <= 3; ++mass) {
        std::vector<std::string> moves, stretches;
        for (std::size_t i = 0; i < samples; ++i) {
            const double here = pixels * x[static_cast<std::size_t>(mass)][i],
                         before = pixels * x[static_cast<std::size_t>(mass) - 1][i];
            moves.push_back("translateX(" + digits(here, "%.2f") + "px)");
            stretches.push_back("translateX(" + digits(before, "%.2f") + "px) scaleX(" +
                                digits((length + here - before) / length, "%.4f") + ")");
        }
        const std::string n = std::to_string(mass);
        style += keyframes("move" + n, moves) + keyframes("stretch" + n, stretches) + ".moves" + n + " { animation: move" + n +
                 " 3s linear infinite; }\n.stretches" + n + " { animation: stretch" + n +
                 " 3s linear infinite; transform-origin: " + std::to_string(40 + 190 * (mass - 1)) + "px 0; }\n";
        const int left = 40 + 190 * (mass - 1), at = left + 90;
        drawn +=
            "<g class=\"stretches" + n +
            "\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.6\"><path vector-effect=\"non-scaling-stroke\" d=\"M" +
            std::to_string(left) + " 98h14l6-12 12 24 12-24 12 24 12-24 6 12h16\"/></g>\n<g class=\"moves" + n + "\"><rect x=\"" +
            std::to_string(at) + "\" y=\"55\" width=\"100\" height=\"85\" fill=\"" + (mass == 2 ? "#f0c9a4" : "#c9dcef") +
            "\" stroke=\"currentColor\" stroke-width=\"1.6\"/><text x=\"" + std::to_string(at + 50) +
            "\" y=\"104\" text-anchor=\"middle\" font-style=\"italic\" fill=\"#111\">m<tspan dy=\"4\" font-size=\"12\">" + n +
            "</tspan></text>" +
            (mass == 1   ? "<path d=\"M180 55V28h52M224 22l10 6-10 6\" fill=\"none\" stroke=\"currentColor\" "
                           "stroke-width=\"1.6\"/><text x=\"240\" y=\"34\" fill=\"currentColor\"><tspan "
                           "font-style=\"italic\">P</tspan> cos <tspan font-style=\"italic\">ωt</tspan></text>"
             : mass == 2 ? "<path d=\"M355 140v14h30v-14\" fill=\"#c96\" stroke=\"currentColor\"/>"
                         : "") +
            "</g>\n";
    }
    return style +
           "}</style>\n<svg class=\"home-picture\" role=\"img\" aria-label=\"A chain of three masses between springs: the first "
           "is driven by a harmonic "
           "force, the second rubs on a wall\" viewBox=\"0 0 660 200\" font-family=\"serif\" font-size=\"17\">\n"
           "<path d=\"M40 40v110M28 52l12-12M28 72l12-12M28 92l12-12M28 112l12-12M28 132l12-12M28 152l12-12M290 154h160M298 "
           "166l12-12M338 "
           "166l12-12M378 166l12-12M418 166l12-12\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.6\"/>\n" +
           drawn + "<text x=\"370\" y=\"190\" text-anchor=\"middle\" fill=\"currentColor\">Coulomb friction</text>\n</svg>\n";
}

std::size_t count_of(const Json& ledger, const char* key, const std::string& word) {
    return static_cast<std::size_t>(
        std::count_if(ledger.begin(), ledger.end(), [&](const Json& e) { return e.at(key) == word; }));
}

/// What coding an equation as printed costs on the scene of its refutation; negative where there is no such scene.
double loss_of(const Json& entry) {
    const Json scene = entry.value("scene", Json::object());
    return entry.at("printed") == "refuted" && scene.contains("loss") ? scene.at("loss").get<double>() : -1;
}

std::string costliest(const Book& book) {
    std::vector<const Json*> refuted;
    for (const Json& entry : book.run.ledger)
        if (loss_of(entry) >= 0) refuted.push_back(&entry);
    std::stable_sort(refuted.begin(), refuted.end(), [](const Json* a, const Json* b) { return loss_of(*a) > loss_of(*b); });
    std::string out;
    for (std::size_t i = 0; i < std::min<std::size_t>(5, refuted.size()); ++i) {
        const std::string equation = refuted[i]->at("equation");
        const auto said = book.run.departures.find(equation);
        out += "<li>" + equation_link(equation) + ", off by " + digits(100 * loss_of(*refuted[i]), "%.0f") + " % on its scene" +
               (said == book.run.departures.end() ? "" : ": " + typeset(said->second.said, "departures.json")) + "</li>\n";
    }
    return "<ol class=\"costly\">\n" + out + "</ol>\n";
}

std::string one_line(const Json& entry, const Departures& departures) {
    const auto found = departures.find(entry.at("equation").get<std::string>());
    const std::string verdict = verdict_text(entry.at("printed"));
    return found == departures.end() ? "as printed: " + verdict : "as printed: " + verdict + ". " + found->second.said;
}

} // namespace

Page home_page(const Book& book) {
    const Json& ledger = book.run.ledger;
    std::size_t departing = 0;
    for (const Json& entry : ledger) departing += entry.at("departure") != "none" ? 1 : 0;
    std::string out = page_head("mainpage", "The annotated reference");
    out += "<p>The paper: L. Marino and A. Cicirello, <em>Coulomb friction effect on the forced vibration of damped mass-spring "
           "systems</em>, Journal of Sound and Vibration 535 (2022) 117085, "
           "<a href=\"https://doi.org/10.1016/j.jsv.2022.117085\">doi:10.1016/j.jsv.2022.117085</a>. A chain of masses is driven "
           "at one mass and "
           "rubs at another; the paper gives its steady motion in closed form for as long as the contact never stops.</p>\n\n";
    out += "\\htmlonly[block]\n" + picture() +
           "<form class=\"go\" action=\"search_page.html\" method=\"get\"><label for=\"go\">Equation, figure or section "
           "number</label>"
           "<input id=\"go\" name=\"q\" autocomplete=\"off\" placeholder=\"57, A.12, Fig. 8, 2.6\"> <button "
           "type=\"submit\">Go</button></form>\n"
           "\\endhtmlonly\n\n";
    out += "<ul>\n<li>" + std::to_string(count_of(ledger, "printed", "refuted")) + " of the " + std::to_string(ledger.size()) +
           " numbered equations do not hold as printed, and the scan at hand spoils " +
           std::to_string(count_of(ledger, "printed", "illegible")) + " more. Each has its correction here.</li>\n<li>" +
           counted(count_of(ledger, "shipped", "proved"), "equation is", "equations are") +
           " proved by machine in the form that the library computes, and " +
           std::to_string(count_of(ledger, "shipped", "approximation")) +
           " are approximations with a proved order of their error.</li>\n<li>\\ref errata \"The errata\" list all " +
           std::to_string(departing) +
           " departures from the printed text, and the page of an equation shows the difference in colour.</li>\n</ul>\n\n";
    out += "\n\\section home_costly The five costliest misprints\n\n" + costliest(book);
    out += "\n\\section home_doors What you can do here\n\n\\htmlonly[block]\n<ul class=\"doors\">\n"
           "<li><strong><a href=\"equations.html\">Read with the paper</a></strong> The page of an equation has the printed "
           "form, the form that holds, its proof, its function, its figures and its tests.</li>\n"
           "<li><strong><a href=\"derivation_chapter.html\">Follow the derivation</a></strong> It leads from the equation of "
           "motion to the boundary of sliding, and a machine checks each step.</li>\n"
           "<li><strong><a href=\"test_your_implementation.html\">Test your own code</a></strong> The kit asks your program "
           "certified questions and names the mistake behind a wrong answer.</li>\n"
           "<li><strong><a href=\"explore/index.html\">Explore</a></strong> Change the friction and see how the motion "
           "changes.</li>"
           "</ul>\n\\endhtmlonly\n\n";
    out += "<p><a href=\"about.html\">About this reference</a> says what \"proved\" means, lists all pages, and explains how "
           "to make everything again.</p>\n";
    return {"home", out};
}

Page errata_sheet(const Book& book) {
    std::string rows;
    for (const Json& entry : book.run.ledger) {
        const std::string equation = entry.at("equation"), printed = entry.at("printed");
        const auto said = book.run.departures.find(equation);
        if (!fails(printed) && printed != "illegible") continue;
        rows += "<tr><td>(" + equation + ")</td><td>" +
                (printed == "illegible"
                     ? "scan"
                     : departure_text(entry.at("departure")).substr(0, departure_text(entry.at("departure")).find(':'))) +
                "</td><td>" + (said == book.run.departures.end() ? "" : typeset(said->second.said, "departures.json")) +
                "</td></tr>\n";
    }
    std::string out = page_head("errata_sheet", "Errata on one sheet");
    out +=
        "<div class=\"sheet\">\n<p><strong>Errata</strong> to L. Marino and A. Cicirello, <em>Coulomb friction effect on the "
        "forced vibration of damped mass-spring "
        "systems</em>, Journal of Sound and Vibration 535 (2022) 117085, doi:10.1016/j.jsv.2022.117085. Every entry is "
        "decided by machine; "
        "the annotated reference <em>denhartog</em> has a proof and a witness for each. \"Scan\" marks a glyph that is wrong in "
        "the text at hand; it "
        "says nothing about the journal's page.</p>\n<table class=\"doxtable\">\n<tr><th>equation</th><th>kind</th><th>what is "
        "wrong</th></tr>\n" +
        rows + "</table>\n</div>\n";
    return {"errata_sheet", out};
}

std::vector<ScriptFile> script_files(const Book& book) {
    Json statements = Json::object(), places = Json::object();
    for (const Json& entry : book.run.ledger) {
        std::string said = html(one_line(entry, book.run.departures));
        for (bool open = true; said.find('$') != std::string::npos; open = !open)
            said.replace(said.find('$'), 1, open ? "\\(" : "\\)");
        const auto found = book.run.departures.find(entry.at("equation").get<std::string>());
        const bool marked = found != book.run.departures.end() && !found->second.holds.empty();
        statements[entry.at("equation").get<std::string>()] = {
            {"said", said}, {"latex", marked ? without_marks(found->second.holds) : statement_that_holds(entry)}};
        const std::string section = entry.at("section");
        if (!places.contains("section " + section))
            places["section " + section] = "equations.html#" + label("equations", section);
    }
    for (const FigureRecord& figure : book.run.figures)
        if (const std::string number = figure_number(figure); !number.empty())
            places["figure " + number.substr(5)] = label("figure", figure.name) + ".html";
    std::string accuracy = "function,type,zone,points,printed,shipped,shipped_at\n";
    for (const Json& record : book.run.accuracy)
        for (const Json& row : record.at("functions"))
            accuracy += row.at("function").dump() + "," + record.at("type").dump() + "," + row.at("zone").dump() + "," +
                        row.at("points").dump() + "," + row.at("printed").dump() + "," + row.at("shipped").dump() + "," +
                        row.at("shipped_at").dump() + "\n";
    return {{"accuracy.csv", accuracy},
            {"symbols.json", symbols_as_json(book.run.notation)},
            {"statements.json", statements.dump(0) + "\n"},
            {"sections.js", "window.siteSections = " + places.dump(0) + ";\n"}};
}

std::map<std::string, std::string> computed_remarks() {
    conformance::ProtocolQuestion q; // the two masses of Fig. 10 with the least damping
    q.mass_ratios = q.stiffness_ratios = {1, 1};
    const double r_1 = (std::sqrt(5.0) - 1) / 2, r_2 = (std::sqrt(5.0) + 1) / 2;
    q.damping_ratios = {0.001 / r_1, 0.001 / r_2};
    q.contact = 2;
    q.r = 0.55;
    const auto limit = [&q](const char* name) {
        q.quantity = name;
        return conformance::plain_answer(q).value().numbers.front();
    };
    const double excess = 100 * (limit("beta_lim_approximate") / limit("beta_lim_exact") - 1);
    return {
        {"67", "(67) requires only that the contact does not stick where its motion turns. It does not require that the contact "
               "slides in between. "
               "Where (67) and the boundary (69) differ, (67) errs on the unsafe side: " +
                   digits(excess, "%.0f") +
                   " % above (69) at $r = 0.55$ for the two masses of Fig. 10 with $\\zeta_i = 0.001/r_{n,i}$."}};
}

} // namespace denhartog::pages
