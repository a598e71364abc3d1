// The derivation program: `run` decides every claim and writes what it found, `join` brings in the results of the tests and of
// the kernel, `status` puts the counts and the figures' numbers into README.md, docs/what-was-found.md and
// paper-figures/README.md, `kernel` writes what is proved as lemmas for Coq and has them checked.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <thread>

#include "derivation/claims/report.hpp"
#include "derivation/claims/run.hpp"
#include "derivation/kernel/kernel_check.hpp"
#include "derivation/kernel/kernel_export.hpp"
#include "derivation/ledger/ledger_audit.hpp"
#include "derivation/ledger/ledger_figures.hpp"
#include "derivation/ledger/ledger_join.hpp"
#include "derivation/ledger/ledger_kernel.hpp"
#include "derivation/ledger/ledger_rows.hpp"
#include "derivation/ledger/ledger_scenes.hpp"
#include "derivation/ledger/ledger_statements.hpp"
#include "derivation/observations/agreement.hpp"
#include "derivation/observations/refutation_scene.hpp"

using namespace denhartog::derivation;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& content) {
    const fs::path part = file.string() + ".part";
    {
        std::ofstream out(part, std::ios::binary);
        out << content << std::flush;
        if (!out) throw std::runtime_error("cannot write " + file.string());
    }
    fs::rename(part, file);
}

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream content;
    content << in.rdbuf();
    if (!in) throw std::runtime_error("cannot read " + file.string());
    return content.str();
}

/// The folder of a check by the kernel; none where sources have changed since, so that it may speak of other formulas.
fs::path of_these_sources(const fs::path& kernel, const fs::path& source) {
    const fs::path record = kernel / "kernel.json";
    if (kernel.empty() || !fs::exists(record)) return {};
    for (const char* part : {"src/denhartog", "derivation"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(source / part))
            if (entry.is_regular_file() && entry.last_write_time() > fs::last_write_time(record)) return {};
    return kernel;
}

/// Joins the ledger from what a run left in a folder, writes it with the report, prints the summary.
ReportParts join(const fs::path& folder, const fs::path& source, const fs::path& results, const fs::path& figures,
                 const fs::path& kernel) {
    const json found = json::parse(read(folder / "run.json"));
    LedgerParts parts;
    parts.rows = read_rows(source / "docs/ledger/equations.json");
    parts.functions = functions_of_sources(source / "src");
    parts.declared = tests_of_sources(source / "tests");
    parts.results = read_test_results(results);
    parts.claims = claims_from_json(found.at("claims"));
    const JoinedLedger ledger = join_ledger(parts);
    ReportParts report{ledger.entries,        ledger.summary,     found.at("mutants"),
                       found.at("agreement"), found.at("faults"), found.at("stand_ins")};
    const std::vector<json> records = figure_records(figures);
    const Statements statements = join_statements(denhartog::ledger::Json::parse(read(source / "docs/ledger/statements.json")),
                                                  parts.claims, parts.rows, records);
    report.statements = statements.rows;
    report.statement_counts = statements.counts;
    for (const std::string& fault : statements.faults) report.faults.push_back(fault);
    for (const std::string& fault : faults_of_rows(parts.rows)) report.faults.push_back(fault);
    for (const std::string& fault : ledger.faults) report.faults.push_back(fault);
    for (const std::string& fault : add_scenes(report.entries, found.at("scenes"))) report.faults.push_back(fault);
    for (const std::string& fault : add_figures(report.entries, records)) report.faults.push_back(fault);
    for (const std::string& fault :
         add_kernel(report.entries, read_kernel_record(of_these_sources(kernel, source), source / "derivation/kernel/statements.json")))
        report.faults.push_back(fault);
    write(folder / "ledger.json", report.entries.dump(1) + "\n");
    write(folder / "statements.json", report.statements.dump(1) + "\n");
    write(folder / "report.md", report_markdown(report));
    write(folder / "status.md", status_markdown(report));
    write(folder / "found.md", found_markdown(report));
    const std::vector<AuditRow> audit = audit_of(report.entries);
    write(folder / "audit.md", audit_summary(audit) + "\n\n" + audit_markdown(audit));
    std::cout << summary_text(report) << "The report is in " << (folder / "report.md").string() << "\n";
    return report;
}

/// @param proofs  what the program `proofs` left; empty where it has not run
void run(const fs::path& folder, const fs::path& proofs) {
    const std::size_t workers = std::thread::hardware_concurrency();
    fs::create_directories(folder);
    const Findings known = proofs.empty() ? Findings() : json::parse(read(proofs)).get<Findings>();
    Run found = run_of(claims(), findings_of(claims(), known, workers, std::cout));
    const json agreement = agreement_with_second_witness(workers);
    for (const json& group : agreement)
        if (!group.at("agrees").get<bool>())
            found.faults.push_back("closed form and second witness disagree on " + group.at("group").get<std::string>());
    write(folder / "derivation.json", found.record.dump(1) + "\n");
    json listed = json::array();
    for (const StandIn& s : stand_ins()) listed.push_back({{"name", s.name}, {"header", s.header}, {"theorem", s.theorem}});
    const json record{{"claims", to_json(found.claims)}, {"mutants", found.mutants}, {"agreement", agreement},
                      {"faults", found.faults},          {"stand_ins", listed},      {"scenes", scenes_of_refutations()}};
    write(folder / "run.json", record.dump(1) + "\n");
}

/// README with what the last run found first.
std::string refreshed_readme(const std::string& text, const fs::path& folder) {
    return with_block(text, "found", read(folder / "found.md"));
}

/// The page of what was found, with the counts of the last run and what the figures show.
std::string refreshed_page(const std::string& text, const fs::path& folder, const std::vector<json>& figures) {
    return with_block(with_block(text, "status", read(folder / "status.md")), "figures", figures_table(figures));
}

/// Writes a file anew, or says whether it is up to date.
bool refresh(const fs::path& file, const std::string& before, const std::string& now, bool check) {
    if (!check) {
        write(file, now);
    } else if (!same_but_for_rounding(now, before)) {
        std::cerr << file.string() << " does not show what the last run found; derivation status without --check mends it\n";
        return false;
    }
    return true;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Derives the paper's equations from its equation of motion and checks the shipped formulas against them"};
    app.require_subcommand(1);
    std::string folder, source = DENHARTOG_SOURCE, proofs, results, readme, figures, kernel, coqc = "coqc", coqchk = "coqchk";
    bool check = false, check_kernel = false;
    CLI::App* run_command =
        app.add_subcommand("run", "decide every claim, try its mutated twins, compare with the second witness");
    CLI::App* join_command = app.add_subcommand("join", "join the ledger again, with the results of the tests");
    CLI::App* status_command =
        app.add_subcommand("status", "put what the last run found and the figures' numbers into the READMEs and the page");
    CLI::App* kernel_command =
        app.add_subcommand("kernel", "write every identity that is proved as a lemma for Coq, with its cofactors, and twins that fail");
    kernel_command->add_option("--output", folder, "folder for the lemmas")->required();
    kernel_command->add_flag("--check", check_kernel, "compile them, and write the kernel's word into kernel.json");
    kernel_command->add_option("--coqc", coqc, "the compiler of Coq")->capture_default_str();
    kernel_command->add_option("--coqchk", coqchk, "its checker of compiled files")->capture_default_str();
    for (CLI::App* command : {run_command, join_command, status_command}) {
        command->add_option("--output", folder, "folder of the run")->required();
        command->add_option("--figures", figures, "folder with the records of the figures");
    }
    for (CLI::App* command : {run_command, join_command}) {
        command->add_option("--source", source, "the source tree")->capture_default_str();
        command->add_option("--test-results", results, "folder with the XML results of the tests");
        command->add_option("--kernel", kernel, "folder with what the kernel of Coq has checked");
    }
    run_command->add_option("--proofs", proofs, "what the program `proofs` has decided already");
    status_command->add_option("--readme", readme, "the file with the marks of what was found")->required();
    status_command->add_flag("--check", check, "say whether it is up to date, and change nothing");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    try {
        if (*status_command) {
            const std::vector<json> records = figure_records(figures);
            const fs::path of_figures = fs::path(source) / "paper-figures/README.md";
            const fs::path of_findings = fs::path(source) / "docs/what-was-found.md";
            const std::string text = read(readme), text_of_figures = read(of_figures), text_of_findings = read(of_findings);
            bool fresh = refresh(readme, text, refreshed_readme(text, folder), check);
            fresh = refresh(of_findings, text_of_findings, refreshed_page(text_of_findings, folder, records), check) && fresh;
            const std::string now = with_block(text_of_figures, "figures", figures_markdown(records));
            return refresh(of_figures, text_of_figures, now, check) && fresh ? 0 : 1;
        }
        if (*kernel_command) {
            const std::size_t workers = std::thread::hardware_concurrency();
            (void)export_certificates(claims(), folder, workers, std::cout);
            return !check_kernel || check_certificates(folder, workers, coqc, coqchk, std::cout) ? 0 : 1;
        }
        if (*run_command) run(folder, proofs);
        return join(folder, source, results, figures, kernel).faults.empty() ? 0 : 1;
    } catch (const std::exception& e) {
        std::cerr << "derivation: " << e.what() << "\n";
        return 1;
    }
}
