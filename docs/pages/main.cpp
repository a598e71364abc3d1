/// @file
/// @brief The program that writes the generated pages of the site, and links them to the sources when Doxygen has run.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "denhartog/number/errors.hpp"
#include "finish.hpp"
#include "link.hpp"
#include "site.hpp"

namespace {

using namespace denhartog::pages;

/// Prints faults. @return the exit status
int judged(const std::vector<std::string>& faults) {
    for (const std::string& fault : faults) std::fprintf(stderr, "pages: %s\n", fault.c_str());
    return faults.empty() ? 0 : 1;
}

int write(const std::string& verify, const std::string& source, const std::string& output) {
    RunRecord run = read_run(verify, source);
    run.remarks = computed_remarks();
    const Sources sources(source);
    const Site site = make_site(run, sources, std::filesystem::path(source) / "docs/chapter");
    if (!site.faults.empty()) return judged(site.faults);
    const std::size_t written = write_pages(site.pages, output);
    write_scripts(site.scripts, output);
    std::printf("%zu pages, %zu of them new or changed\n", site.pages.size(), written);
    return 0;
}

int link(const std::string& site, const std::string& tags, const std::string& source) {
    std::size_t resolved = 0;
    const std::vector<std::string> faults = link_site(site, tags, source, resolved);
    if (faults.empty()) std::printf("links to %zu places in the sources and pages\n", resolved);
    return judged(faults);
}

int finish(const std::string& site) {
    const FinishedSite done = finish_site(site);
    std::printf("%zu pages, %zu links followed, %zu entries for the search\n", done.pages, done.links, done.documents);
    return judged(done.faults);
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"The generated pages of the annotated reference", "pages"};
    app.require_subcommand(1);
    app.footer("Exit status: 0 done; 1 something is wrong, a sentence each on standard error; 2 usage.");
    std::string verify, source, output, site, tags;
    CLI::App* writing = app.add_subcommand("write", "Write the pages from what a run wrote");
    writing->add_option("--run", verify, "Folder of the run, with paper, figures, chart and test-results")->required();
    writing->add_option("--source", source, "Root of the sources")->required();
    writing->add_option("--output", output, "Folder for the pages")->required();
    CLI::App* linking = app.add_subcommand("link", "Resolve links to sources and pages in the finished site");
    linking->add_option("--site", site, "Folder with the HTML")->required();
    linking->add_option("--tagfile", tags, "Doxygen's tag file")->required();
    linking->add_option("--source", source, "Root of the sources")->required();
    CLI::App* finishing =
        app.add_subcommand("finish", "Finish the linked site: headings, the list for the search; follow every link");
    finishing->add_option("--site", site, "Folder with the HTML")->required();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    try {
        if (finishing->parsed()) return finish(site);
        return writing->parsed() ? write(verify, source, output) : link(site, tags, source);
    } catch (const std::exception& e) {
        return judged({e.what()});
    }
}
