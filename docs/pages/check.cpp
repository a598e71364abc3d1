#include "check.hpp"

#include <cctype>
#include <map>
#include <set>

#include "text.hpp"

namespace denhartog::pages {

namespace {

/// The word after a command, up to a blank.
std::string word_at(const std::string& text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && !std::isspace(static_cast<unsigned char>(text[end])) && text[end] != '}') ++end;
    return text.substr(at, end - at);
}

std::vector<std::string> words_after(const std::string& text, const std::string& command) {
    std::vector<std::string> words;
    for (std::size_t at = text.find(command); at != std::string::npos; at = text.find(command, at + 1))
        words.push_back(word_at(text, at + command.size()));
    return words;
}

void check_braces(const std::string& latex, const std::string& page, std::vector<std::string>& faults) {
    int depth = 0;
    for (std::size_t i = 0; i < latex.size() && depth >= 0; ++i) {
        if (latex[i] == '\\')
            ++i;
        else if (latex[i] == '{')
            ++depth;
        else if (latex[i] == '}')
            --depth;
    }
    if (depth != 0) faults.push_back("page " + page + " has a formula whose braces do not match: " + latex.substr(0, 60));
}

/// The text without formulas and raw blocks; faults where one is not closed.
std::string outside(const Page& page, std::vector<std::string>& faults) {
    static const std::vector<std::pair<std::string, std::string>> pairs = {
        {"\\f$", "\\f$"}, {"\\f[", "\\f]"}, {"\\htmlonly", "\\endhtmlonly"}};
    std::string out;
    for (std::size_t at = 0; at < page.text.size();) {
        bool skipped = false;
        for (const auto& [open, close] : pairs) {
            if (page.text.compare(at, open.size(), open) != 0) continue;
            const std::size_t end = page.text.find(close, at + open.size());
            if (end == std::string::npos) {
                faults.push_back("page " + page.name + " has a formula that is not closed: " + page.text.substr(at, 60));
                return out;
            }
            const std::string inner = page.text.substr(at + open.size(), end - at - open.size());
            if (open != "\\htmlonly") {
                check_braces(inner, page.name, faults);
                if (inner.find("\\f") != std::string::npos && inner.find("\\f[") != std::string::npos)
                    faults.push_back("page " + page.name + " has a formula within a formula");
            }
            at = end + close.size();
            skipped = true;
            break;
        }
        if (!skipped) out += page.text[at++];
    }
    return out;
}

void check_raw(const std::string& text, const std::string& page, std::vector<std::string>& faults) {
    static const std::vector<std::string> commands = {"\\frac", "\\bar{",   "\\overline", "\\sqrt", "\\beta", "\\tau", "\\zeta",
                                                      "\\psi",  "\\begin{", "\\f[",       "\\f]",   "\\left", "\\cos", "\\sin"};
    for (const std::string& command : commands)
        if (const std::size_t at = text.find(command); at != std::string::npos)
            faults.push_back("page " + page + " has LaTeX outside of a formula: " + text.substr(at, 40));
    for (std::size_t at = text.find('$'); at != std::string::npos; at = text.find('$', at + 1))
        if (at == 0 || text[at - 1] != '\\') {
            faults.push_back("page " + page + " has a dollar outside of a formula: " + text.substr(at, 40));
            break;
        }
    if (text.find("{{") != std::string::npos) faults.push_back("page " + page + " has a place-holder that nothing replaced");
}

} // namespace

std::vector<std::string> faults_of(const std::vector<Page>& pages) {
    std::vector<std::string> faults;
    std::map<std::string, std::string> labels;
    std::vector<std::string> texts;
    for (const Page& page : pages) {
        texts.push_back(outside(page, faults));
        for (const char* command : {"{#", "\\section ", "\\subsection ", "\\anchor "})
            for (const std::string& word : words_after(texts.back(), command))
                if (!labels.emplace(word, page.name).second)
                    faults.push_back("label " + word + " is there twice, on page " + page.name);
    }
    for (std::size_t i = 0; i < pages.size(); ++i) {
        check_raw(texts[i], pages[i].name, faults);
        for (const char* command : {"\\ref ", "\\subpage "})
            for (const std::string& word : words_after(texts[i], command))
                if (word.find("::") == std::string::npos && !labels.contains(word))
                    faults.push_back("page " + pages[i].name + " links to " + word + ", a label that is not there");
    }
    for (const std::string& equation : ledger::equation_numbers())
        if (!labels.contains(equation_label(equation))) faults.push_back("equation (" + equation + ") has no page");
    return faults;
}

} // namespace denhartog::pages
