// The subcommands of `denhartog conform` that judge a program: run, grade, smoke, and repro, which prints the commands that
// repeat one question. Read `conform_run`, then `finish`, which diagnoses, compares and reports.
#include "denhartog/program/conform/conform.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "conformance/grade.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/program/json/number_json.hpp"
#include "denhartog/program/output/files.hpp"

namespace denhartog::program {
namespace {

using conformance::Judged;
using conformance::Vector;

std::string time_text(double seconds) {
    const long whole = std::lround(seconds);
    return whole < 120 ? std::to_string(whole) + " s" : std::to_string((whole + 30) / 60) + " min";
}

// Progress on a terminal, at every percent: questions done, and time left.
void show_answered(std::size_t done, std::size_t all) {
    static const auto start = std::chrono::steady_clock::now();
    static const bool on_terminal = ::isatty(STDERR_FILENO) != 0;
    if (!on_terminal) return;
    const std::size_t percent = 100 * done / all;
    if (done != all && percent == 100 * (done - 1) / all) return;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    const std::string left =
        time_text(passed.count() * static_cast<double>(all - done) / static_cast<double>(done > 1 ? done - 1 : 1));
    std::fprintf(stderr, "\r%3zu %% of %zu questions, %s left   %s", percent, all, left.c_str(), done == all ? "\n" : "");
}

std::string text_in_format(const ConformReport& report, const std::string& format) {
    if (format == "json") return report_json(report);
    if (format == "junit") return report_junit(report);
    if (format == "markdown") return report_markdown(report);
    return report_text(report);
}

// Check before a long run that its results can be kept.
std::optional<Verdicts> earlier_verdicts(const ConformOptions& options) {
    if (!options.output.empty()) check_writable(options.output);
    if (options.track.empty()) return std::nullopt;
    std::optional<Verdicts> earlier = tracked_verdicts(options.track);
    check_writable(options.track);
    return earlier;
}

// All vectors, with the tolerances of the method.
std::vector<Vector> vectors_for(const ConformOptions& options) {
    const conformance::SolverMethod& method = conformance::method_named(options.method);
    std::vector<Vector> all = conformance::read_vectors(options.vectors);
    for (Vector& v : all) conformance::widen(v, method);
    return all;
}

// Diagnosis, comparison, and the report where it belongs. Where something got worse the file of verdicts is left as it was.
void finish(ConformReport& report, const std::optional<Verdicts>& earlier, ExitStatus& status) {
    const ConformOptions& options = report.options;
    const conformance::SolverMethod& method = conformance::method_named(options.method);
    for (Judged& one : report.judged) conformance::excuse(one, method);
    conformance::Thresholds least;
    least.agreement = method.displacement.loose;
    report.diagnosis = conformance::diagnose(report.judged, conformance::fitted_to(report.judged), least);
    report.conforms = report.cut_short.empty() && conformance::conforms(report.judged, needed_quantities(options));
    if (earlier) report.changes = compare(*earlier, report.judged);
    write_output(options.output, text_in_format(report, options.format));
    const std::string not_kept = !report.cut_short.empty()                          ? "not every question was asked"
                                 : report.changes && !report.changes->worse.empty() ? "something got worse"
                                                                                    : "";
    if (!options.track.empty() && not_kept.empty())
        write_file(options.track, tracked_text(earlier.value_or(Verdicts{}), report.judged));
    if (!options.track.empty() && !not_kept.empty())
        denhartog::program::report(legible(options.track) + " was left as it was, because " + not_kept);
    status.broken = report.broken;
    status.failed = report.status() == 1;
    status.beyond_must = report.status() == 4;
}

// Asks some wrong questions again, each in a process of its own: what is answered otherwise then depends on the questions before.
void note_what_is_kept(ConformReport& report, conformance::RunSettings settings) {
    constexpr std::size_t most = 4;
    std::vector<const Judged*> wrong;
    for (const Judged& one : report.judged)
        if (conformance::is_wrong_value(one.verdict) && one.answered) wrong.push_back(&one);
    settings.jobs = 1;
    const std::size_t count = std::min(most, wrong.size());
    for (std::size_t n = 0; n < count; ++n) {
        const Judged& one = *wrong[n * wrong.size() / count + wrong.size() / (2 * count)];
        const std::string& id = one.vector->question.id;
        try {
            const Judged alone = conformance::converse(settings, {&one.vector, 1}, [](std::size_t) {}).judged.at(0);
            if (!alone.answered || (alone.given.numbers == one.given.numbers && alone.given.word == one.given.word)) continue;
            report.notes.push_back(
                "The program keeps something from question to question: asked alone, as --repro asks, it answers " + id +
                " otherwise.");
            return;
        } catch (const conformance::BrokenProgram&) { // it is asked no more
            return;
        }
    }
}

std::string runner_command(const ConformOptions& options, const Vector& v) {
    std::vector<std::string> words{this_program(), "conform", "run"};
    if (options.vectors != vectors_folder()) words.insert(words.end(), {"--vectors", options.vectors});
    if (options.method != conformance::methods().front().name) words.insert(words.end(), {"--method", options.method});
    if (is_of_systems(v)) words.emplace_back("--systems");
    words.insert(words.end(), {"--filter", "^" + options.repro + "$", "--verbose", "--"});
    words.insert(words.end(), options.command.begin(), options.command.end());
    return shell_text(words);
}

std::string pipe_command(const ConformOptions& options, const std::string& line) {
    return "printf '%s\\n' " + shell_text({"denhartog-conform 1", line}) + " | " + shell_text(options.command);
}

std::string in_escapes(const std::string& word) {
    std::string quoted = "$'";
    for (const char c : word) {
        char escaped[5] = {c, 0, 0, 0, 0};
        if (c < ' ' || c > '~' || c == '\'' || c == '\\')
            std::snprintf(escaped, sizeof escaped, "\\x%02X", static_cast<unsigned char>(c));
        quoted += escaped;
    }
    return quoted + "'";
}

} // namespace

std::string shell_text(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        if (word != legible(word, word.size() + 8)) { // bytes that a terminal would obey
            text += (text.empty() ? "" : " ") + in_escapes(word);
            continue;
        }
        const bool plain = !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                                   "0123456789_-+=./:,@%") == std::string::npos;
        std::string quoted;
        for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
        text += (text.empty() ? "" : " ") + (plain ? word : "'" + quoted + "'");
    }
    return text;
}

void conform_repro(const ConformOptions& options, ExitStatus& status) {
    const conformance::RunSettings settings = run_settings(options);
    const conformance::SolverMethod& method = conformance::method_named(options.method);
    const std::vector<Vector> all = conformance::read_vectors(options.vectors);
    Vector v = vector_named(options.repro, all);
    conformance::widen(v, method);
    const conformance::WithoutBrokenPipeSignal guard;
    const conformance::Partner partner = conformance::shake_hands(settings);
    const std::string line = conformance::line_for(partner, v.question);
    write_standard_output("# with the runner\n" + runner_command(options, v) + "\n\n# as a bare pipe\n" +
                          pipe_command(options, line) + "\n\n# what came of it\n");
    const conformance::Reply reply = partner.process->ask(line, settings.seconds);
    const bool answered = !reply.trouble;
    conformance::Judged judged;
    std::string told = reply.told + "\n";
    if (answered) {
        judged = conformance::judge(v, partner, reply);
        conformance::excuse(judged, method);
        const conformance::Diagnosis d = conformance::diagnose({&judged, 1}, conformance::mistakes());
        told = legible(reply.line) + "\n" + answer_text(judged, "");
        for (const conformance::Finding& finding : d.findings)
            told += "  it is the answer of the mistake " + finding.mistake.name + ": " + finding.mistake.told + "\n";
    }
    write_standard_output(told);
    status.broken = !answered;
    status.failed = answered && !conformance::is_right(judged.verdict) && judged.verdict != conformance::Verdict::skipped;
}

void conform_run(const ConformOptions& options, ExitStatus& status) {
    const conformance::RunSettings settings = run_settings(options);
    static_cast<void>(needed_quantities(options));
    const std::vector<Vector> all = vectors_for(options);
    const std::vector<const Vector*> chosen = selected(options, all);
    const std::optional<Verdicts> earlier = earlier_verdicts(options);
    const Interruptible interruptible(conformance::interruption());
    ConformReport report{conformance::converse(settings, chosen, [&](std::size_t done) { show_answered(done, chosen.size()); }),
                         options};
    if (interruptible.caught() != 0) {
        status.signal = interruptible.caught();
        denhartog::program::report("interrupted: the report tells what was answered until then");
    }
    if (report.name.empty()) report.name = legible(options.command.front());
    if (!report.broken && report.cut_short.empty()) note_what_is_kept(report, settings);
    finish(report, earlier, status);
}

void conform_grade(const ConformOptions& options, ExitStatus& status) {
    static_cast<void>(needed_quantities(options));
    const std::vector<Vector> all = vectors_for(options);
    std::set<std::string> ids;
    for (const Vector& v : all) ids.insert(v.question.id);
    const std::map<std::string, conformance::Answer> answers = conformance::answers_in(read_input(options.answers), ids);
    SelectionOptions choice = options;
    if (choice.groups.empty()) // who answers about systems beyond the paper asks for the verdict
        choice.systems = choice.systems || std::any_of(all.begin(), all.end(), [&](const Vector& v) {
                             return is_of_systems(v) && answers.contains(v.question.id);
                         });
    const std::vector<const Vector*> chosen = selected(choice, all);
    const std::optional<Verdicts> earlier = earlier_verdicts(options);
    ConformReport report{{}, options};
    report.name = legible(options.answers);
    for (const Vector* v : chosen) {
        const auto answer = answers.find(v->question.id);
        report.judged.push_back(
            conformance::grade(*v, answer != answers.end() ? answer->second : conformance::Skipped{"no answer in the file"}));
    }
    finish(report, earlier, status);
}

void conform_smoke(const ConformOptions& options, ExitStatus& status) {
    const conformance::RunSettings settings = run_settings(options);
    const Interruptible interruptible(conformance::interruption());
    const conformance::Smoke found = conformance::smoke(settings);
    if (interruptible.caught() != 0) {
        status.signal = interruptible.caught();
        return;
    }
    Rows rows;
    bool good = true, kept = true;
    for (const conformance::SmokeCheck& check : found.checks) {
        rows.push_back({check.good ? "good" : "BAD", check.what, check.found});
        good = good && check.good;
        kept = kept && (check.good || check.of_input);
    }
    write_standard_output(aligned(rows) + (good   ? "\nThe protocol is kept. No number was checked.\n"
                                           : kept ? "\nThe protocol is kept, but a question that breaks a rule was answered.\n"
                                                  : "\nThe protocol is not kept.\n"));
    status.broken = found.broken;
    status.failed = !good;
}

} // namespace denhartog::program
