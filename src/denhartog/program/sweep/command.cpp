#include "denhartog/program/sweep/command.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numeric>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/program/sweep/estimate.hpp"
#include "denhartog/program/sweep/merge.hpp"
#include "denhartog/program/sweep/netcdf.hpp"
#include "denhartog/program/sweep/progress.hpp"
#include "denhartog/program/sweep/run.hpp"
#include "denhartog/program/sweep/store.hpp"

namespace denhartog::program {
namespace {

struct SweepOptions {
    std::string study, folder, to, commit;
    std::vector<std::string> chunks;
    bool all = false, json = false, without_estimate = false;
    unsigned jobs = 1;
    std::optional<std::size_t> workers;
};

void plan(const SweepOptions& options) {
    const std::string text = read_input(options.study);
    nlohmann::ordered_json estimate;
    if (!options.without_estimate) estimate = estimate_of(sweep::plan_of(sweep::read_study(text)));
    const StudyFolder study = write_folder(text, options.folder, options.commit, estimate);
    std::string said = std::to_string(study.plan.points) + " points in " + std::to_string(study.plan.chunks) +
                       " chunks of at most " + std::to_string(study.plan.box(0).points()) + " points\n";
    if (!options.without_estimate) {
        said += "about " + number_in_digits(estimate.at("hours_of_one_core"), 3) + " hours of one core, from " +
                std::to_string(estimate.at("points_measured").get<std::size_t>()) +
                " points: " + number_in_digits(estimate.at("seconds_a_point"), 3) + " seconds a point, from " +
                number_in_digits(estimate.at("least_seconds_a_point"), 2) + " to " +
                number_in_digits(estimate.at("most_seconds_a_point"), 2) + " by place\n" + "about " +
                number_in_digits(estimate.at("bytes"), 3) + " bytes of results\n";
    }
    write_standard_output(said + "next: denhartog sweep run " + options.folder +
                          " --all, or a script in it: slurm.sh, parallel.sh, with_dask.py\n");
}

std::size_t number_of(const std::string& text, std::size_t chunks) {
    const bool digits = !text.empty() && text.size() < 10 && text.find_first_not_of("0123456789") == std::string::npos;
    const std::size_t K = digits ? std::stoul(text) : chunks;
    if (K >= chunks)
        throw InputError("CHUNK", "must be a number from 0 to " + std::to_string(chunks - 1) + ", or two with a hyphen", text);
    return K;
}

std::vector<std::size_t> chunks_of(const SweepOptions& options, std::size_t chunks) {
    std::vector<std::size_t> all;
    if (options.all == !options.chunks.empty())
        throw InputError("CHUNK", "must be given, or --all in its place", options.all ? "both" : "neither");
    if (options.all) {
        all.resize(chunks);
        std::iota(all.begin(), all.end(), std::size_t(0));
    }
    for (const std::string& text : options.chunks) {
        const std::size_t hyphen = text.find('-');
        const std::size_t first = number_of(text.substr(0, hyphen), chunks);
        const std::size_t last = hyphen == std::string::npos ? first : number_of(text.substr(hyphen + 1), chunks);
        if (last < first) throw InputError("CHUNK", "must not end below its start", text);
        for (std::size_t K = first; K <= last; ++K) all.push_back(K);
    }
    return all;
}

void run(const SweepOptions& options, ExitStatus& status) {
    const StudyFolder study = open_study(options.folder, options.commit);
    const std::vector<std::size_t> chunks = chunks_of(options, study.plan.chunks);
    if (options.jobs < 1) throw InputError("jobs", "must be at least 1", "0");
    const bool on_terminal = ::isatty(STDERR_FILENO) != 0;
    const ChunksRun ran = run_chunks(study, chunks, options.jobs, [&](std::size_t done) {
        if (on_terminal) std::fprintf(stderr, "\r%s%s", bar_of(done, chunks.size()).c_str(), done == chunks.size() ? "\n" : "");
    });
    const std::string said = std::to_string(ran.computed) + " computed, " + std::to_string(ran.found_done) + " done before";
    if (ran.signal) {
        status.signal = *ran.signal;
        report("interrupted: " + said + "; unfinished chunks have left no files");
        return;
    }
    write_standard_output("chunks: " + said + "\n");
}

void show_status(const SweepOptions& options) {
    if (options.workers == std::size_t(0)) throw InputError("workers", "must be at least 1", "0");
    const nlohmann::ordered_json all = status_of(open_study(options.folder, options.commit), options.workers);
    write_standard_output(options.json ? all.dump() + "\n" : status_text(all));
}

void merge_chunks(const SweepOptions& options, ExitStatus& status) {
    const StudyFolder study = open_study(options.folder, options.commit);
    if (!options.to.empty() && !options.to.ends_with(".nc")) throw InputError("to", "must end in .nc, for NetCDF", options.to);
    const MergeFaults found = faults_of(study);
    if (!found.missing.empty()) report("chunks that are not done: " + ranges_of(found.missing));
    for (const std::string& each : found.faults) report(each);
    if (!found.none()) {
        status.failed = true;
        report("nothing is merged: `sweep run` computes the chunks that are missing or damaged");
        return;
    }
    merge(study);
    if (!options.to.empty()) write_netcdf(study, options.to);
    write_standard_output("all " + std::to_string(study.plan.chunks) + " chunks are present, each once: " +
                          study.file(sweep::result_folder) + (options.to.empty() ? "" : ", " + options.to) + "\n");
}

CLI::App* add(CLI::App& sweep, const char* name, const char* what, SweepOptions& options) {
    CLI::App* command = sweep.add_subcommand(name, what);
    command->add_option("DIR", options.folder, "the folder of the study")->required();
    return command;
}

} // namespace

void add_sweep_command(CLI::App& app, ExitStatus& status, const std::string& commit) {
    CLI::App* sweep = app.add_subcommand("sweep", "Studies beyond one machine: chunks of a parametric study, for any engine");
    sweep->require_subcommand(1);
    const auto options = std::make_shared<SweepOptions>();
    options->commit = commit;
    CLI::App* command = sweep->add_subcommand("plan", "Divide a study into chunks and write its folder");
    command->add_option("STUDY", options->study, "the study as JSON, see docs/study.schema.json; - for standard input")
        ->required();
    command->add_option("DIR", options->folder, "the folder to write")->required();
    command->add_flag("--without-estimate", options->without_estimate, "do not measure what the study will cost");
    command->callback([options] { plan(*options); });
    command = add(*sweep, "run", "Compute chunks that are not done", *options);
    command->add_option("CHUNK", options->chunks, "numbers of chunks, or ranges such as 20-29");
    command->add_flag("--all", options->all, "all chunks");
    command->add_option("--jobs", options->jobs, "chunks at once")->capture_default_str();
    command->callback([options, &status] { run(*options, status); });
    command = add(*sweep, "status", "How much of a study is done", *options);
    command->add_flag("--json", options->json, "JSON instead of text");
    command->add_option("--workers", options->workers,
                        "simulate how long this many workers would take, from the times of the chunks that are done");
    command->callback([options] { show_status(*options); });
    command = add(*sweep, "merge", "Check that every chunk is there once, and complete the results", *options);
    command->add_option("--to", options->to, "also write them into this NetCDF file, .nc");
    command->callback([options, &status] { merge_chunks(*options, status); });
    sweep->footer(
        "The files of a chunk are written under other names, flushed to the disk and renamed; a record with checksums comes\n"
        "last. A chunk that is done is not computed again. The results are an uncompressed Zarr store of format 2,\n"
        "DIR/result.zarr; its bytes do not depend on workers, engine or the order of chunks. The status of merge is 1 if a\n"
        "chunk is missing, damaged, or of another program or study.");
}

} // namespace denhartog::program
