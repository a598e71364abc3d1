#include "denhartog/program/conform/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <regex>

#include "conformance/method.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/output/files.hpp"

namespace denhartog::program {
namespace {

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

bool is_named(const std::string& group, const conformance::Vector& v) {
    return group == v.group || (group == "systems" && is_of_systems(v));
}

// Systems beyond the paper are asked about where they are chosen: an implementation of the paper need not know them.
bool is_wanted(const SelectionOptions& options, const conformance::Vector& v) {
    if (options.systems && is_of_systems(v)) return true;
    if (options.groups.empty()) return !is_of_systems(v);
    return std::any_of(options.groups.begin(), options.groups.end(), [&](const std::string& each) { return is_named(each, v); });
}

void require_quantities(const std::string& option, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (std::ranges::find(conformance::quantities(), name, &conformance::Quantity::name) == conformance::quantities().end())
            throw InputError(option, "must name quantities of the protocol", legible(name));
}

} // namespace

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
        if (std::none_of(all.begin(), all.end(), [&](const conformance::Vector& v) { return is_named(group, v); }))
            throw InputError("group", "must be one of the vectors' (`denhartog conform list --summary` has them)", group);
    std::vector<const conformance::Vector*> chosen;
    for (const conformance::Vector& v : all)
        if (is_wanted(options.tiers, v.tier) && is_wanted(options.asked, v.question.quantity) && is_wanted(options, v) &&
            !(options.skip_must_fail && !v.reject.empty()) && matches(v.question.id, filter, options.filter))
            chosen.push_back(&v);
    if (chosen.empty()) {
        const bool more =
            std::any_of(all.begin(), all.end(), [](const conformance::Vector& v) { return is_named("systems", v); });
        const std::string hint = more ? " (--systems or --group systems choose those of systems beyond the paper)" : "";
        throw InputError("the selection", "must leave at least one vector" + hint, "0 of " + std::to_string(all.size()));
    }
    return chosen;
}

const conformance::Vector& vector_named(const std::string& id, const std::vector<conformance::Vector>& all) {
    for (const conformance::Vector& v : all)
        if (v.question.id == id) return v;
    throw InputError("id", "must be a vector's", legible(id));
}

} // namespace denhartog::program
