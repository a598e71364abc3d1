#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "conformance/method.hpp"
#include "conformance/mistakes/mistake.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/conform/options.hpp"
#include "denhartog/program/json/number_json.hpp"
#include "denhartog/program/output/files.hpp"

namespace denhartog::program {
namespace {

using conformance::Vector;

void list(const SelectionOptions& options, bool summary) {
    const std::vector<Vector> all = conformance::read_vectors(options.vectors);
    SelectionOptions choice = options;
    choice.systems = options.systems || (summary && options.groups.empty()); // a summary tells what there is
    const std::vector<const Vector*> chosen = selected(choice, all);
    Rows rows;
    if (summary) {
        std::map<std::string, std::map<std::string, int>> groups;
        for (const Vector* v : chosen) ++groups[v->group][v->tier];
        rows.push_back({"group", "must", "should", "stress"});
        std::map<std::string, int> total;
        for (auto& [group, tiers] : groups) {
            rows.push_back({group});
            for (const char* tier : {"must", "should", "stress"}) {
                rows.back().push_back(std::to_string(tiers[tier]));
                total[tier] += tiers[tier];
            }
        }
        rows.push_back({"all", std::to_string(total["must"]), std::to_string(total["should"]), std::to_string(total["stress"])});
    } else {
        rows.push_back({"id", "tier", "group", "quantity", "flags"});
        for (const Vector* v : chosen) {
            std::string flags;
            for (const std::string& flag : v->flags) flags += (flags.empty() ? "" : " ") + flag;
            rows.push_back({v->question.id, v->tier, v->group, v->question.quantity, flags});
        }
    }
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
        command->count("--csv") > 0 ? list_csv(*options) : list(*options, command->count("--summary") > 0);
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
