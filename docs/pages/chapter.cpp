#include "chapter.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>

#include "denhartog/number/errors.hpp"
#include "derivation/ledger/source_text.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace {

bool in_chapter(const std::string& equation) {
    if (equation.starts_with("A.")) return true;
    const int number = std::stoi(equation);
    return number >= 4 && number <= 72;
}

/// Writes one page of the chapter.
class Writer {
public:
    Writer(const Book& book, const std::set<std::string>& shown) : book_(book), shown_(shown) {}

    [[nodiscard]] std::string page(const ChapterFile& file, std::vector<std::string>& faults) {
        std::istringstream in(file.text);
        std::string out, text;
        int number = 0, sections = 0;
        const auto place = [&] { return "docs/chapter, page " + file.name + ", line " + std::to_string(number); };
        const auto guarded = [&](const std::function<std::string()>& part) {
            try {
                out += part();
            } catch (const InputError& e) {
                faults.emplace_back(e.what());
            }
        };
        const auto flush = [&] {
            if (!text.empty()) guarded([&] { return "<p>" + typeset(text, place()) + "</p>\n"; });
            text.clear();
        };
        for (std::string line; std::getline(in, line);) {
            ++number;
            if (line.empty()) {
                flush();
            } else if (line.starts_with("# ")) {
                out += page_head(file.name, line.substr(2));
            } else if (line.starts_with("## ")) {
                flush();
                out += "\n\\section " + file.name + "_" + std::to_string(++sections) + " " + line.substr(3) + "\n\n";
            } else if (line.starts_with("{{")) {
                flush();
                guarded([&] { return placeholder(line, place()); });
            } else {
                text += (text.empty() ? "" : " ") + line;
            }
        }
        flush();
        return out;
    }

    [[nodiscard]] const std::set<std::string>& listed() const { return listed_; }

private:
    std::string placeholder(const std::string& line, const std::string& place) {
        const std::size_t blank = line.find(' '), close = line.find("}}");
        if (blank == std::string::npos || close == std::string::npos || close < blank || close + 2 != line.size())
            throw InputError("a place-holder", "must stand on a line of its own, as {{word name}}", line, place);
        const std::string word = line.substr(2, blank - 2), name = line.substr(blank + 1, close - blank - 1);
        if (word == "equation") return equation(name, true);
        if (word == "printed") return equation(name, false);
        if (word == "steps") return steps(name, place);
        if (word == "claims") return claims(name);
        throw InputError("a place-holder", "must be equation, printed, steps or claims", line, place);
    }

    std::string equation(const std::string& number, bool holds) const {
        const Json& entry = entry_of(book_.run, number);
        const std::string latex = holds ? statement_that_holds(entry) : entry.at("statement").get<std::string>();
        return "<div class=\"chapter-equation\">\n" + displayed(latex + "\\tag{" + number + "}") + "<p>" + equation_link(number) +
               (holds ? ": " + verdict_text(entry.at("shipped")) : " as printed: " + verdict_text(entry.at("printed"))) +
               "</p>\n</div>\n";
    }

    std::string steps(const std::string& id, const std::string& place) const {
        const auto found = book_.run.claims.find(id);
        if (found == book_.run.claims.end()) throw InputError("a place-holder", "must name a claim of the run", id, place);
        const Json& claim = found->second;
        return "<div class=\"chapter-steps\">\n<p>" + verdict_mark(claim.at("verdict")) + ": " + prose(claim.at("title")) + " (" +
               claim_link(claim) + ")</p>\n" + steps_text(claim) + "</div>\n";
    }

    std::string claims(const std::string& number) {
        std::string items;
        std::size_t count = 0;
        for (const Json& claim : entry_of(book_.run, number).at("claims")) {
            const Json& record = record_of(book_.run, claim.at("id"));
            const std::string id = record.at("claim");
            if (claim.at("role") == "observation" || shown_.contains(id) || !listed_.insert(id).second) continue;
            ++count;
            items += "<li>" + verdict_mark(claim.at("verdict")) + ": " + prose(claim.at("what")) + " (" + claim_link(record) +
                     ")</li>\n";
        }
        if (items.empty()) return {};
        return "<details class=\"claims\">\n<summary>What else is decided on (" + number +
               "): " + counted(count, "claim", "claims") + "</summary>\n<ul>\n" + items + "</ul>\n</details>\n";
    }

    const Book& book_;
    const std::set<std::string>& shown_;
    std::set<std::string> listed_;
};

/// Claims whose steps the chapter shows.
std::set<std::string> shown_in(const std::vector<ChapterFile>& files) {
    const std::string word = "{{steps ";
    std::set<std::string> shown;
    for (const ChapterFile& file : files)
        for (std::size_t at = file.text.find(word); at != std::string::npos; at = file.text.find(word, at + 1)) {
            const std::size_t from = at + word.size();
            shown.insert(file.text.substr(from, file.text.find("}}", from) - from));
        }
    return shown;
}

} // namespace

std::vector<ChapterFile> read_chapter(const std::filesystem::path& folder) {
    std::vector<ChapterFile> files;
    for (const std::filesystem::path& file : derivation::files_in(folder, ".md")) {
        const std::string stem = file.stem().string();
        files.push_back({stem == "chapter" ? "derivation_chapter" : "derivation_" + stem, derivation::text_of(file)});
    }
    const auto first =
        std::find_if(files.begin(), files.end(), [](const ChapterFile& f) { return f.name == "derivation_chapter"; });
    if (first == files.end()) throw InputError("the chapter", "must have a file chapter.md", "", folder.string());
    std::rotate(files.begin(), first, first + 1);
    return files;
}

std::vector<Page> chapter_pages(const Book& book, const std::vector<ChapterFile>& files, std::vector<std::string>& faults) {
    const std::set<std::string> shown = shown_in(files);
    Writer writer(book, shown);
    std::vector<Page> pages;
    for (const ChapterFile& file : files) {
        std::string text = writer.page(file, faults);
        if (!text.starts_with("# ")) faults.push_back("the file of " + file.name + " must begin with # and a title");
        const std::size_t index = static_cast<std::size_t>(&file - files.data());
        std::string navigation = "<div class=\"eq-nav\">\n";
        if (index > 1) navigation += "<span class=\"previous\">\\ref " + files[index - 1].name + " \"previous\"</span>\n";
        if (index > 0) navigation += "<span class=\"index\">\\ref derivation_chapter \"the chapter\"</span>\n";
        if (index + 1 < files.size()) navigation += "<span class=\"next\">\\ref " + files[index + 1].name + " \"next\"</span>\n";
        navigation += "</div>\n\n";
        if (index == 0)
            for (std::size_t i = 1; i < files.size(); ++i) text += "\n- \\subpage " + files[i].name;
        const std::size_t head = text.find("\n\n");
        if (index > 0 && head != std::string::npos) text.insert(head + 2, navigation);
        pages.push_back({file.name, text + "\n\n" + navigation});
    }
    for (const std::string& id : claims_to_mention(book.run))
        if (!shown.contains(id) && !writer.listed().contains(id))
            faults.push_back("claim " + id + " is on a result of the chapter, which does not mention it");
    return pages;
}

std::set<std::string> claims_to_mention(const RunRecord& run) {
    std::set<std::string> ids;
    for (const Json& entry : run.ledger) {
        if (entry.at("kind") != "result" || !in_chapter(entry.at("equation"))) continue;
        for (const Json& claim : entry.at("claims"))
            if (claim.at("role") != "observation") ids.insert(record_of(run, claim.at("id")).at("claim").get<std::string>());
    }
    return ids;
}

} // namespace denhartog::pages
