// The subcommands and options of `denhartog conform`, and those of its subcommands that only look at the vectors: list and show.
// `run.cpp` has those that judge a program.
#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>

#include "conformance/mistakes/mistake.hpp"
#include "conformance/verdict.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/conform/conform.hpp"
#include "denhartog/program/json/number_json.hpp"
#include "denhartog/program/output/files.hpp"

namespace denhartog::program {
namespace {

using namespace conformance;

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
    return wanted.empty() || std::ranges::find(wanted, name) != wanted.end();
}

bool is_named(const std::string& group, const Vector& v) { return group == v.group || (group == "systems" && is_of_systems(v)); }

// Systems beyond the paper are asked about where they are chosen: an implementation of the paper need not know them.
bool is_wanted(const SelectionOptions& options, const Vector& v) {
    if (options.systems && is_of_systems(v)) return true;
    if (options.groups.empty()) return !is_of_systems(v);
    return std::ranges::any_of(options.groups, [&](const std::string& each) { return is_named(each, v); });
}

void add_list_option(CLI::App& command, const std::string& name, std::vector<std::string>& list, const std::string& told) {
    command.add_option(name, list, told)->delimiter(',')->allow_extra_args(false);
}

void add_vectors_option(CLI::App& command, SelectionOptions& options) {
    options.vectors = vectors_folder();
    command.add_option("--vectors", options.vectors, "folder with the vectors, files *.jsonl")->capture_default_str();
}

void add_selection_options(CLI::App& command, SelectionOptions& options) {
    add_vectors_option(command, options);
    command.add_option("--filter", options.filter, "regular expression that must match a part of the id");
    add_list_option(command, "--group", options.groups,
                    "groups, separated by commas; `systems` stands for all that start with systems-; by default all others");
    command.add_flag(
        "--systems", options.systems,
        "also ask about systems beyond the paper: contacts between two masses, several loads, moving bases, matrices");
    add_list_option(command, "--tier", options.tiers, "tiers, separated by commas: must, should, stress; by default all");
    add_list_option(command, "--quantity", options.asked, "quantities of the protocol, separated by commas; by default all");
    command.add_flag("--skip-must-fail", options.skip_must_fail, "leave out the questions that have to be rejected");
}

void add_program_options(CLI::App& command, ConformOptions& options) {
    command.add_option("PROGRAM", options.command, "the program under test and its arguments, after --")->required();
    command.add_option("--timeout", options.seconds, "seconds for an answer; the handshake may take three times as long")
        ->capture_default_str();
}

void add_report_options(CLI::App& command, ConformOptions& options) {
    options.method = methods().front().name;
    command
        .add_option("--method", options.method,
                    "method by which the program answers; it decides the tolerances, see `denhartog conform list --methods`")
        ->capture_default_str();
    add_list_option(command, "--need", options.needed, "quantities, separated by commas, that must not be skipped");
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

// Numbers of vectors by group and tier.
std::string summary(const std::vector<const Vector*>& chosen) {
    std::map<std::string, std::map<std::string, int>> groups;
    std::map<std::string, int> total;
    for (const Vector* v : chosen) {
        ++groups[v->group][v->tier];
        ++total[v->tier];
    }
    Rows rows{{"group", "must", "should", "stress"}};
    const auto add = [&](const std::string& name, std::map<std::string, int>& of) {
        rows.push_back({name, std::to_string(of["must"]), std::to_string(of["should"]), std::to_string(of["stress"])});
    };
    for (auto& [group, tiers] : groups) add(group, tiers);
    add("all", total);
    return aligned(rows);
}

std::string table_of(const std::vector<const Vector*>& chosen) {
    Rows rows{{"id", "tier", "group", "quantity", "flags"}};
    for (const Vector* v : chosen) rows.push_back({v->question.id, v->tier, v->group, v->question.quantity, joined(v->flags)});
    return aligned(rows);
}

std::string table_of_mistakes() {
    Rows rows{{"mistake", "equation", "what it is; what to look at"}};
    for (const Mistake& m : mistakes())
        rows.push_back({m.name, m.equation.empty() ? "." : m.equation, m.told + " Look at: " + m.look_at});
    return aligned(rows);
}

std::string table_of_methods() {
    const auto two = [](double x) { return number_in_digits(x, 2); };
    const auto three = [&](const Tolerance& t) {
        return t.loose > 0 ? two(t.pass) + " " + two(t.loose) + " " + two(t.inaccurate) : "the vector's";
    };
    Rows rows{{"method", "displacement", "phase", "duration", "margin", "undamped", "what it is"}};
    for (const SolverMethod& m : methods())
        rows.push_back({std::string(m.name), three(m.displacement), three(m.phase), three(m.duration), two(m.margin),
                        m.settles ? "not judged wrong" : "judged", std::string(m.told)});
    return aligned(rows) + "\nLargest errors that are pass, pass-loose, inaccurate, over the scale and the condition number "
                           "where that is above 1.\n";
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
        const auto is_asked = [&](const std::string& flag) { return command->count(flag) > 0; };
        if (is_asked("--mistakes")) return write_standard_output(table_of_mistakes());
        if (is_asked("--methods")) return write_standard_output(table_of_methods());
        const auto& text = is_asked("--summary") ? summary : is_asked("--csv") ? vectors_csv : table_of;
        const std::vector<Vector> all = read_vectors(options->vectors);
        write_standard_output(text(selected(*options, all)));
    });
}

void add_show(CLI::App& conform) {
    CLI::App* command =
        conform.add_subcommand("show", "One vector: its question in both dialects, and all that is known about it");
    const auto options = std::make_shared<SelectionOptions>();
    const auto id = std::make_shared<std::string>();
    command->add_option("ID", *id, "id of the vector")->required();
    add_vectors_option(*command, *options);
    command->callback([options, id] {
        const std::vector<Vector> all = read_vectors(options->vectors);
        const Vector& v = vector_named(*id, all);
        write_standard_output("json   " + question_json(v.question).dump() + "\nplain  " + question_plain(v.question) + "\n" +
                              vector_json(v).dump(1) + "\n");
    });
}

// Runs a subcommand on the program under test, which the words behind `--` are, whatever they look like. It may break before a
// report can be made.
template <class Run>
void with_program(ConformOptions& options, const std::vector<std::string>& arguments, ExitStatus& status, const Run& run) {
    const auto mark = std::ranges::find(arguments, "--");
    if (mark == arguments.end()) throw InputError("PROGRAM", "must follow after --", options.command.front());
    options.command.assign(mark + 1, arguments.end());
    if (options.command.empty()) throw InputError("PROGRAM", "must follow after --", "");
    try {
        run(options, status);
    } catch (const BrokenProgram& e) {
        status.broken = true;
        report(e.what());
    }
}

void add_smoke(CLI::App& conform, ExitStatus& status, const std::vector<std::string>& arguments) {
    CLI::App* command = conform.add_subcommand("smoke", "Whether a program keeps to the protocol; no number is checked");
    const auto options = std::make_shared<ConformOptions>();
    add_program_options(*command, *options);
    command->callback([options, &status, arguments] { with_program(*options, arguments, status, conform_smoke); });
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
        with_program(*options, arguments, status, options->repro.empty() ? conform_run : conform_repro);
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

void require_quantities(const std::string& option, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (std::ranges::find(quantities(), name, &Quantity::name) == quantities().end())
            throw InputError(option, "must name quantities of the protocol", legible(name));
}

std::vector<const Vector*> selected(const SelectionOptions& options, const std::vector<Vector>& all) {
    const std::regex filter = filter_of(options.filter);
    require_quantities("quantity", options.asked);
    for (const std::string& tier : options.tiers)
        if (tier != "must" && tier != "should" && tier != "stress")
            throw InputError("tier", "must be must, should or stress", tier);
    for (const std::string& group : options.groups)
        if (std::ranges::none_of(all, [&](const Vector& v) { return is_named(group, v); }))
            throw InputError("group", "must be one of the vectors' (`denhartog conform list --summary --systems` has them)",
                             group);
    std::vector<const Vector*> chosen;
    for (const Vector& v : all)
        if (is_wanted(options.tiers, v.tier) && is_wanted(options.asked, v.question.quantity) && is_wanted(options, v) &&
            !(options.skip_must_fail && !v.reject.empty()) && matches(v.question.id, filter, options.filter))
            chosen.push_back(&v);
    if (chosen.empty()) {
        const bool more = std::ranges::any_of(all, is_of_systems);
        const std::string hint = more ? " (--systems or --group systems choose those of systems beyond the paper)" : "";
        throw InputError("the selection", "must leave at least one vector" + hint, "0 of " + std::to_string(all.size()));
    }
    return chosen;
}

const Vector& vector_named(const std::string& id, const std::vector<Vector>& all) {
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
