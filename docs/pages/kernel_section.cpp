#include "kernel_section.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "derivation/ledger/source_text.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace {

/// Longer statements are left to the file: nobody reads them.
constexpr std::size_t longest_statement = 4000;
constexpr std::size_t most_statements = 3; // of a claim with many components

std::string mark_of(const std::string& status) {
    const std::string verdict = status == "checked" ? "proved" : status == "failed" ? "refuted" : "unknown";
    const std::string word = status == "not_exported" ? "not exported" : status == "not_run" ? "not run" : status;
    return "<span class=\"verdict " + (status == "not_exported" ? "not-applicable" : verdict) + "\">" + word + "</span>";
}

/// Why, or what is wrong; empty where there is nothing to say.
std::string why(const Json& kernel) {
    const std::string text = kernel.value("reason", kernel.value("message", ""));
    return text.empty() ? "" : ": " + escaped(text);
}

/// The certificate of a claim by its name in the ledger, null where none was exported.
const Json* certificate_of(const RunRecord& run, const std::string& claim) {
    auto found = run.certificates.find(claim);
    if (found == run.certificates.end()) found = run.certificates.find(claim.substr(0, claim.rfind('/')));
    return found == run.certificates.end() || found->second.at("lemmas").empty() ? nullptr : &found->second;
}

std::string lemmas_text(const Json& certificate) {
    std::string out;
    std::size_t shown = 0;
    for (const Json& lemma : certificate.at("lemmas")) {
        if (shown++ == most_statements) break;
        const std::string in_functions = lemma.value("in_functions", "");
        std::string legend;
        if (in_functions.empty())
            for (const Json& generator : lemma.at("generators"))
                legend += (legend.empty() ? "" : ", ") + ("<code>" + escaped(generator.at("name").get<std::string>()) +
                                                      "</code> stands for <code>") +
                      escaped(generator.at("stands_for").get<std::string>()) + "</code>";
        if (!legend.empty()) out += "<p>" + legend + ".</p>\n";
        const std::string statement = in_functions.empty() ? lemma.at("statement").get<std::string>() : in_functions;
        out += statement.size() > longest_statement
                   ? "<p class=\"left-out\">A statement of " + std::to_string(statement.size()) + " characters, in " +
                         escaped(certificate.at("file").get<std::string>()) + ".</p>\n"
                   : coq_block(statement);
    }
    if (certificate.at("lemmas").size() > most_statements)
        out += "<p>The other " + std::to_string(certificate.at("lemmas").size() - most_statements) + " are in " +
               escaped(certificate.at("file").get<std::string>()) + ".</p>\n";
    return out;
}

std::string claim_line(const Book& book, const Json& claim) {
    const Json kernel = claim.value("kernel", Json{{"status", "not_run"}});
    const std::string id = claim.at("id"), status = kernel.value("status", "not_run");
    std::string out = "<p>" + mark_of(status) + " Claim <code>" + escaped(id) + "</code>" + why(kernel) + ".</p>\n";
    const Json* certificate = status == "not_run" ? nullptr : certificate_of(book.run, id);
    if (certificate == nullptr) return out;
    const std::string of_it = status == "not_exported" ? " that it uses" : "";
    if (const std::string reasons = kernel.value("why_not_in_functions", ""); !reasons.empty())
        out += "<p>Not stated of the functions themselves, only of their names: " + escaped(reasons) + ".</p>\n";
    return out + "<details>\n<summary>" + counted(certificate->at("lemmas").size(), "identity", "identities") + of_it +
           "</summary>\n" + lemmas_text(*certificate) + "</details>\n";
}

/// The statement of a theorem, from the file that has them all; empty where it is not there.
std::string statement_of(const Book& book, const std::string& name) {
    const std::filesystem::path file = book.sources.root() / "derivation/kernel/Statements.v";
    if (!std::filesystem::exists(file)) return {};
    const std::string text = derivation::text_of(file);
    const std::size_t from = text.find("Definition " + name + " : Prop :=");
    return from == std::string::npos ? "" : text.substr(from, text.find(".\n", from) + 1 - from);
}

std::string theorems_text(const Book& book, const Json& kernel, const char* list, const std::string& title) {
    const Json theorems = kernel.value(list, Json::array());
    std::string out;
    for (const Json& theorem : theorems) {
        out += "<p>" + mark_of(theorem.value("status", "not_run")) + " <strong>" + title + " " +
               escaped(theorem.at("name").get<std::string>()) + "</strong>";
        if (theorem.contains("says")) out += ": " + prose(theorem.at("says").get<std::string>());
        out += "</p>\n";
        if (const std::string statement = statement_of(book, theorem.at("name")); !statement.empty()) out += coq_block(statement);
    }
    return out;
}

std::string marked_line(const std::string& line, bool& in_comment) {
    static const std::set<std::string> keywords{"Lemma",   "Theorem", "Definition", "forall", "exists", "Proof", "Qed",  "Section", "End",
                                                "Variables", "Hypothesis", "Fixpoint", "fun", "match",  "with",  "end",  "if",      "then",
                                                "else",    "let",     "in",         "Require", "Import", "Open", "Scope"};
    std::string out;
    for (std::size_t at = 0; at < line.size();) {
        if (line.compare(at, 2, "(*") == 0 || in_comment) {
            const std::size_t close = line.find("*)", at);
            const std::size_t to = close == std::string::npos ? line.size() : close + 2;
            in_comment = close == std::string::npos;
            out += "<span class=\"comment\">" + html(line.substr(at, to - at)) + "</span>";
            at = to;
        } else if (std::isalpha(static_cast<unsigned char>(line[at])) != 0) {
            std::size_t to = at;
            while (to < line.size() && (std::isalnum(static_cast<unsigned char>(line[to])) != 0 || line[to] == '_')) ++to;
            const std::string word = line.substr(at, to - at);
            out += keywords.contains(word) ? "<span class=\"keyword\">" + word + "</span>" : word;
            at = to;
        } else {
            out += html(line.substr(at, 1));
            ++at;
        }
    }
    return out;
}

} // namespace

std::string coq_block(const std::string& text) {
    std::string out = "\\htmlonly[block]\n<div class=\"fragment\" tabindex=\"0\">";
    bool in_comment = false;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t to = std::min(text.find('\n', from), text.size());
        out += "<div class=\"line\">" + marked_line(text.substr(from, to - from), in_comment) + "</div>\n";
        from = to + 1;
    }
    return out + "</div>\n\\endhtmlonly\n";
}

std::string kernel_section(const Book& book, const Json& entry, const std::string& equation) {
    const Json kernel = entry.value("kernel", Json{{"status", "not_run"}});
    const std::string status = kernel.value("status", "not_run");
    std::string out = "\n\\section " + equation_label(equation) + "_kernel The verdict of the kernel\n\n<p>" + mark_of(status) +
                      why(kernel) +
                      ". <a href=\"kernel.html\">What the kernel of Coq checks, and what nobody can prove</a></p>\n";
    out += theorems_text(book, kernel, "theorems", "Theorem") + theorems_text(book, kernel, "negations", "Negation");
    if (status != "not_run")
        for (const Json& claim : entry.at("claims")) out += claim_line(book, claim);
    return out;
}

} // namespace denhartog::pages
