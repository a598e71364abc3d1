#include "site.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "chapter.hpp"
#include "check.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/program/output/files.hpp"
#include "derivation/ledger/source_text.hpp"
#include "measured_pages.hpp"
#include "overview_pages.hpp"

namespace denhartog::pages {

namespace fs = std::filesystem;

Site make_site(const RunRecord& run, const Sources& sources, const fs::path& chapter) {
    Site site;
    const Book book{run, sources};
    const auto add = [&](const std::function<Page()>& page) {
        try {
            site.pages.push_back(page());
        } catch (const InputError& e) {
            site.faults.emplace_back(e.what());
        }
    };
    for (const std::string& equation : ledger::equation_numbers()) {
        try {
            for (Page& page : equation_pages(book, equation)) site.pages.push_back(std::move(page));
        } catch (const InputError& e) {
            site.faults.emplace_back(e.what());
        }
    }
    for (Page (*page)(const Book&) : {home_page, index_page, errata_page, errata_sheet, audit_page, stand_ins_page, graph_page,
                                      figures_page, accuracy_page, speed_page, conformance_page})
        add([&] { return page(book); });
    for (const FigureRecord& figure : run.figures) add([&] { return figure_page(book, figure); });
    site.scripts = script_files(book);
    for (Page& page : chapter_pages(book, read_chapter(chapter), site.faults)) site.pages.push_back(std::move(page));
    if (site.faults.empty()) site.faults = faults_of(run.departures, run.ledger);
    if (site.faults.empty())
        site.faults = faults_of(site.pages); // a page that could not be made is missed by all that link to it
    std::sort(site.faults.begin(), site.faults.end());
    site.faults.erase(std::unique(site.faults.begin(), site.faults.end()), site.faults.end());
    return site;
}

std::size_t write_pages(const std::vector<Page>& pages, const fs::path& folder) {
    fs::create_directories(folder);
    std::set<std::string> names;
    std::size_t written = 0;
    for (const Page& page : pages) {
        const fs::path file = folder / (page.name + ".md");
        names.insert(file.filename().string());
        if (fs::exists(file) && derivation::text_of(file) == page.text) continue;
        program::write_file(file.string(), page.text);
        ++written;
    }
    for (const fs::path& file : derivation::files_in(folder, ".md"))
        if (!names.contains(file.filename().string())) fs::remove(file);
    return written;
}

void write_scripts(const std::vector<ScriptFile>& scripts, const fs::path& folder) {
    for (const ScriptFile& file : scripts) program::write_file((folder / file.name).string(), file.text);
}

} // namespace denhartog::pages
