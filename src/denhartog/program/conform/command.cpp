// The subcommands and options of `denhartog conform`, and those of its subcommands that only look at the vectors: list and show.
// `run.cpp` has those that judge a program.
#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>

#include "conformance/grade.hpp"
#include "conformance/mistakes/mistake.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/conform/conform.hpp"
#include "denhartog/program/json/number_json.hpp"
#include "denhartog/program/output/files.hpp"

namespace denhartog::program {
namespace {

using conformance::Vector;

constexpr double longest_wait = 3600;
constexpr double longest_run = 7 * 24 * 3600.0;
constexpr int most_jobs = 256;

std::regex filter_of(const std::string& text) {
    try {
        return std::regex(text, std::regex::ECMAScript);
    } catch (const std::regex_error&) {
        throw InputError("filter", "must be a regular expression", legible(text));
    }
}

bool matches(const std::string& id, const std::regex& filter, const std::string& text) {
    try {
        return std::regex_search(id, filter);
    } catch (const std::regex_error&) {
        throw InputError("filter", "must be a regular expression that can be tried in reasonable time", text);
    }
}

bool is_wanted(const std::vector<std::string>& wanted, const std::string& name) {
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

bool is_named(const std::string& group, const Vector& v) { return group == v.group || (group == "systems" && is_of_systems(v)); }

// Systems beyond the paper are asked about where they are chosen: an implementation of the paper need not know them.
bool is_wanted(const SelectionOptions& options, const Vector& v) {
    if (options.systems && is_of_systems(v)) return true;
    if (options.groups.empty()) return !is_of_systems(v);
    return std::any_of(options.groups.begin(), options.groups.end(), [&](const std::string& each) { return is_named(each, v); });
}

void require_quantities(const std::string& option, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (std::ranges::find(conformance::quantities(), name, &conformance::Quantity::name) == conformance::quantities().end())
            throw InputError(option, "must name quantities of the protocol", legible(name));
}

void add_selection_options(CLI::App& command, SelectionOptions& options) {
    options.vectors = vectors_folder();
    command.add_option("--vectors", options.vectors, "folder with the vectors, files *.jsonl")->capture_default_str();
    command.add_option("--filter", options.filter, "regular expression that must match a part of the id");
    command
        .add_option("--group", options.groups,
                    "groups, separated by commas; `systems` stands for all that start with systems-; by default all others")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_flag(
        "--systems", options.systems,
        "also ask about systems beyond the paper: contacts between two masses, several loads, moving bases, matrices");
    command.add_option("--tier", options.tiers, "tiers, separated by commas: must, should, stress; by default all")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--quantity", options.asked, "quantities of the protocol, separated by commas; by default all")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_flag("--skip-must-fail", options.skip_must_fail, "leave out the questions that have to be rejected");
}

void add_program_options(CLI::App& command, ConformOptions& options) {
    command.add_option("PROGRAM", options.command, "the program under test and its arguments, after --")->required();
    command.add_option("--timeout", options.seconds, "seconds for an answer; the handshake may take three times as long")
        ->capture_default_str();
}

void add_report_options(CLI::App& command, ConformOptions& options) {
    options.method = conformance::methods().front().name;
    command
        .add_option("--method", options.method,
                    "method by which the program answers; it decides the tolerances, see `denhartog conform list --methods`")
        ->capture_default_str();
    command.add_option("--need", options.needed, "quantities, separated by commas, that must not be skipped")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--track", options.track,
                       "file with the verdicts of earlier runs: this run is compared with them, then written into it");
    command.add_option("--format", options.format, "format of the report")
        ->check(CLI::IsMember({"text", "json", "junit", "markdown"}))
        ->capture_default_str();
    command.add_option("--output", options.output, "file of the report, instead of standard output");
    command.add_flag("--verbose", options.verbose, "list every answer");
    command.add_flag("--strict", options.strict,
                     "end with status 4 where the program conforms, but answers of other tiers than must are wrong");
}

void list(const SelectionOptions& options) {
    const std::vector<Vector> all = conformance::read_vectors(options.vectors);
    Rows rows{{"id", "tier", "group", "quantity", "flags"}};
    for (const Vector* v : selected(options, all))
        rows.push_back({v->question.id, v->tier, v->group, v->question.quantity, conformance::joined(v->flags)});
    write_standard_output(aligned(rows));
}

// Numbers of vectors by group and tier.
void list_summary(const SelectionOptions& options) {
    const std::vector<Vector> all = conformance::read_vectors(options.vectors);
    std::map<std::string, std::map<std::string, int>> groups;
    std::map<std::string, int> total;
    for (const Vector* v : selected(options, all)) {
        ++groups[v->group][v->tier];
        ++total[v->tier];
    }
    Rows rows{{"group", "must", "should", "stress"}};
    const auto add = [&](const std::string& name, std::map<std::string, int>& of) {
        rows.push_back({name, std::to_string(of["must"]), std::to_string(of["should"]), std::to_string(of["stress"])});
    };
    for (auto& [group, tiers] : groups) add(group, tiers);
    add("all", total);
    write_standard_output(aligned(rows));
}

// As docs/vectors.md says it, for those who read no JSON.
void list_csv(const SelectionOptions& options) {
    const std::vector<Vector> all = conformance::read_vectors(options.vectors);
    const std::vector<const Vector*> chosen = selected(options, all);
    const bool systems = std::any_of(chosen.begin(), chosen.end(), [](const Vector* v) { return is_of_systems(*v); });
    std::string csv = conformance::vector_csv_heading(systems) + "\n";
    for (const Vector* v : chosen) csv += conformance::vector_csv(*v, systems) + "\n";
    write_standard_output(csv);
}

void list_mistakes() {
    Rows rows{{"mistake", "equation", "what it is; what to look at"}};
    for (const conformance::Mistake& mistake : conformance::mistakes())
        rows.push_back(
            {mistake.name, mistake.equation.empty() ? "." : mistake.equation, mistake.told + " Look at: " + mistake.look_at});
    write_standard_output(aligned(rows));
}

void list_methods() {
    const auto three = [](const conformance::Tolerance& t) {
        return t.loose > 0
                   ? number_in_digits(t.pass, 2) + " " + number_in_digits(t.loose, 2) + " " + number_in_digits(t.inaccurate, 2)
                   : "the vector's";
    };
    Rows rows{{"method", "displacement", "phase", "duration", "margin", "undamped", "what it is"}};
    for (const conformance::SolverMethod& m : conformance::methods())
        rows.push_back({std::string(m.name), three(m.displacement), three(m.phase), three(m.duration),
                        number_in_digits(m.margin, 2), m.settles ? "not judged wrong" : "judged", std::string(m.told)});
    write_standard_output(aligned(rows) +
                          "\nLargest errors that are pass, pass-loose, inaccurate, over the scale and the condition number where "
                          "that is above 1.\n");
}

void show(const SelectionOptions& options, const std::string& id) {
    const std::vector<Vector> all = conformance::read_vectors(options.vectors);
    const Vector& v = vector_named(id, all);
    write_standard_output("json   " + conformance::question_json(v.question).dump() + "\nplain  " +
                          conformance::question_plain(v.question) + "\n" + conformance::vector_json(v).dump(1) + "\n");
}

void add_list(CLI::App& conform) {
    CLI::App* command = conform.add_subcommand("list", "The vectors, the known mistakes, or the methods");
    const auto options = std::make_shared<SelectionOptions>();
    add_selection_options(*command, *options);
    command->add_flag("--summary")->description("the number of vectors in each group and tier");
    command->add_flag("--csv")
        ->description("all that is known about each vector, as comma-separated values, with a heading")
        ->excludes("--summary");
    command->add_flag("--mistakes")->description("the known mistakes, with their equations and what to look at");
    command->add_flag("--methods")->description("the methods of --method, with their tolerances")->excludes("--mistakes");
    command->callback([=] {
        if (command->count("--mistakes") > 0) return list_mistakes();
        if (command->count("--methods") > 0) return list_methods();
        if (command->count("--summary") > 0) return list_summary(*options);
        command->count("--csv") > 0 ? list_csv(*options) : list(*options);
    });
}

void add_show(CLI::App& conform) {
    CLI::App* command =
        conform.add_subcommand("show", "One vector: its question in both dialects, and all that is known about it");
    const auto options = std::make_shared<SelectionOptions>();
    const auto id = std::make_shared<std::string>();
    command->add_option("ID", *id, "id of the vector")->required();
    options->vectors = vectors_folder();
    command->add_option("--vectors", options->vectors, "folder with the vectors, files *.jsonl")->capture_default_str();
    command->callback([options, id] { show(*options, *id); });
}

// The words behind `--` are the program under test, whatever they look like.
void take_program(ConformOptions& options, const std::vector<std::string>& arguments) {
    const auto mark = std::find(arguments.begin(), arguments.end(), "--");
    if (mark == arguments.end()) throw InputError("PROGRAM", "must follow after --", options.command.front());
    options.command.assign(mark + 1, arguments.end());
    if (options.command.empty()) throw InputError("PROGRAM", "must follow after --", "");
}

// A program that broke before a report could be made.
void running(const std::function<void()>& run, ExitStatus& status) {
    try {
        run();
    } catch (const conformance::BrokenProgram& e) {
        status.broken = true;
        report(e.what());
    }
}

void add_smoke(CLI::App& conform, ExitStatus& status, const std::vector<std::string>& arguments) {
    CLI::App* command = conform.add_subcommand("smoke", "Whether a program keeps to the protocol; no number is checked");
    const auto options = std::make_shared<ConformOptions>();
    add_program_options(*command, *options);
    command->callback([options, &status, arguments] {
        take_program(*options, arguments);
        running([&] { conform_smoke(*options, status); }, status);
    });
}

void add_run(CLI::App& conform, ExitStatus& status, const std::vector<std::string>& arguments) {
    CLI::App* command = conform.add_subcommand("run", "Ask a program the questions of the vectors, and judge its answers");
    const auto options = std::make_shared<ConformOptions>();
    add_selection_options(*command, *options);
    add_program_options(*command, *options);
    command->add_option("--jobs", options->jobs, "how many processes of the program run at the same time")->capture_default_str();
    command
        ->add_option("--total-timeout", options->total_seconds,
                     "seconds for all answers together; the report then covers the answers given so far; 0 means no limit")
        ->capture_default_str();
    command->add_option("--repro", options->repro, "id of one question: print the command that asks it, and ask it");
    add_report_options(*command, *options);
    command->footer("The protocol is docs/protocol.md, the formats of the report are docs/conformance-output.md.");
    command->callback([options, &status, arguments] {
        take_program(*options, arguments);
        running([&] { options->repro.empty() ? conform_run(*options, status) : conform_repro(*options, status); }, status);
    });
}

void add_grade(CLI::App& conform, ExitStatus& status) {
    CLI::App* command = conform.add_subcommand("grade", "Judge answers in a file");
    const auto options = std::make_shared<ConformOptions>();
    add_selection_options(*command, *options);
    command->add_option("FILE", options->answers, "CSV with the heading id,value, numbers separated by spaces; or JSON Lines")
        ->required();
    add_report_options(*command, *options);
    command->callback([options, &status] { conform_grade(*options, status); });
}

} // namespace

conformance::RunSettings run_settings(const ConformOptions& options) {
    if (!(options.seconds > 0 && options.seconds <= longest_wait))
        throw InputError("timeout", "must be positive and at most " + number_to_text(longest_wait) + " seconds",
                         number_to_text(options.seconds));
    if (options.jobs < 1 || options.jobs > most_jobs)
        throw InputError("jobs", "must be from 1 to " + std::to_string(most_jobs), std::to_string(options.jobs));
    if (!(options.total_seconds >= 0 && options.total_seconds <= longest_run))
        throw InputError("total-timeout", "must be from 0, which means no limit, to " + number_to_text(longest_run) + " seconds",
                         number_to_text(options.total_seconds));
    return {options.command, options.seconds, static_cast<unsigned>(options.jobs), options.total_seconds};
}

std::set<std::string> needed_quantities(const ConformOptions& options) {
    require_quantities("need", options.needed);
    return {options.needed.begin(), options.needed.end()};
}

std::vector<const conformance::Vector*> selected(const SelectionOptions& options, const std::vector<conformance::Vector>& all) {
    const std::regex filter = filter_of(options.filter);
    require_quantities("quantity", options.asked);
    for (const std::string& tier : options.tiers)
        if (tier != "must" && tier != "should" && tier != "stress")
            throw InputError("tier", "must be must, should or stress", tier);
    for (const std::string& group : options.groups)
        if (std::none_of(all.begin(), all.end(), [&](const Vector& v) { return is_named(group, v); }))
            throw InputError("group", "must be one of the vectors' (`denhartog conform list --summary --systems` has them)",
                             group);
    std::vector<const Vector*> chosen;
    for (const Vector& v : all)
        if (is_wanted(options.tiers, v.tier) && is_wanted(options.asked, v.question.quantity) && is_wanted(options, v) &&
            !(options.skip_must_fail && !v.reject.empty()) && matches(v.question.id, filter, options.filter))
            chosen.push_back(&v);
    if (chosen.empty()) {
        const bool more = std::any_of(all.begin(), all.end(), [](const Vector& v) { return is_named("systems", v); });
        const std::string hint = more ? " (--systems or --group systems choose those of systems beyond the paper)" : "";
        throw InputError("the selection", "must leave at least one vector" + hint, "0 of " + std::to_string(all.size()));
    }
    return chosen;
}

const conformance::Vector& vector_named(const std::string& id, const std::vector<conformance::Vector>& all) {
    for (const Vector& v : all)
        if (v.question.id == id) return v;
    throw InputError("id", "must be a vector's", legible(id));
}

void add_conform_command(CLI::App& app, ExitStatus& status, const std::vector<std::string>& arguments) {
    CLI::App* conform = app.add_subcommand("conform", "Test another implementation against certified vectors");
    conform->require_subcommand(1);
    conform->footer(
        "Exit status: 0 if every answered question of the tier `must` is right and none of --need was skipped; 1 if not, or if\n"
        "something got worse since --track; 2 for bad input or usage; 3 if the program under test broke; 4 if it conforms, but\n"
        "answers of other tiers are wrong, with --strict.");
    add_list(*conform);
    add_show(*conform);
    add_smoke(*conform, status, arguments);
    add_run(*conform, status, arguments);
    add_grade(*conform, status);
}

} // namespace denhartog::program
