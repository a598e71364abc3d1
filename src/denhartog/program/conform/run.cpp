// The subcommands of `denhartog conform` that judge a program: run, grade, smoke, and repro, which prints the commands that
// repeat one question. Read `conform_run`, then `finish`, which diagnoses, compares and reports.
#include "denhartog/program/conform/conform.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "conformance/verdict.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/json/number_json.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/scene/json_document.hpp"

namespace denhartog::program {
namespace {

using namespace conformance;

Json optional_number(const std::optional<double>& x) { return x && std::isfinite(*x) ? Json(*x) : Json(); }

template <class All, class Of>
Json list_of(const All& all, const Of& of) {
    Json list = Json::array();
    for (const auto& one : all) list.push_back(of(one));
    return list;
}

Json counts_json(const Counts& counts) {
    Json object = Json::object();
    for (std::size_t n = 0; n < counts.size(); ++n) object[std::string(name(static_cast<Verdict>(n)))] = counts[n];
    return object;
}

Json value_json(const Value& value) { return value.word.empty() ? Json(value.numbers) : Json(value.word); }

Json result_json(const Judged& one) {
    const Vector& v = *one.vector;
    Json object = {{"id", v.question.id},
                   {"group", v.group},
                   {"tier", v.tier},
                   {"quantity", v.question.quantity},
                   {"verdict", name(one.verdict)}};
    if (!one.equation.empty()) object["equation"] = one.equation;
    if (!one.reason.empty()) object["reason"] = one.reason;
    if (one.answered) object["answer"] = value_json(one.given);
    if (!one.given.numbers.empty()) object["answer_hex"] = list_of(one.given.numbers, hexadecimal_float);
    if (!v.reject.empty()) return object;
    const Json known = vector_json(v);
    object["truth"] = known["value"];
    if (!v.word.empty()) return object;
    object["truth_hex"] = known["hex"];
    if (!one.error) return object;
    object.update({{"error", optional_number(one.error)},
                   {"worst_number", one.worst},
                   {"digits", digits(*one.error)},
                   {"error_over_tolerance", optional_number(error_over_tolerance(one))},
                   {"condition", known["condition"]}});
    return object;
}

Json finding_json(const Finding& f) {
    return {{"mistake", f.mistake.name},
            {"equation", f.mistake.equation},
            {"as_printed", f.mistake.as_printed},
            {"told", f.mistake.told},
            {"look_at", f.mistake.look_at},
            {"explained", f.explained},
            {"contradicted", f.contradicted},
            {"weak", f.weak},
            {"number", f.mistake.number},
            {"quantities", f.quantities},
            {"example",
             {{"id", f.example->vector->question.id},
              {"answer", value_json(f.example->given)},
              {"mistaken", value_json(f.mistaken)},
              {"truth", value_json(truth_of(*f.example->vector))}}}};
}

Json in_common_json(const InCommon& one) {
    return {{"property", one.property}, {"wrong", one.wrong}, {"of_wrong", one.all_wrong}, {"answers", one.asked}};
}

Json link_json(const InCommon& link) { return {{"link", link.property}, {"answers", link.asked}, {"wrong", link.wrong}}; }

Json guess_json(const Finding& one) {
    return {{"told", one.mistake.told},
            {"explained", one.explained},
            {"contradicted", one.contradicted},
            {"quantities", one.quantities}};
}

Json diagnosis_json(const Diagnosis& d) {
    return {{"wrong", d.wrong},
            {"findings", list_of(d.findings, finding_json)},
            {"unexplained", list_of(d.unexplained, [](const Judged* one) { return one->vector->question.id; })},
            {"chain", list_of(d.chain, link_json)},
            {"simple", list_of(d.simple, guess_json)},
            {"by_quantity", list_of(d.by_quantity, in_common_json)},
            {"in_common", list_of(d.in_common, in_common_json)},
            {"accepted", d.accepted}};
}

Json change_json(const Change& c) { return {{"id", c.id}, {"before", name(c.before)}, {"now", name(c.now)}}; }

Json score_json(const Score& score) {
    return {{"tier", score.tier},
            {"group", score.group},
            {"asked", score.asked},
            {"counts", counts_json(score.counts)},
            {"median_digits", optional_number(score.median_digits)},
            {"worst_digits", optional_number(score.worst_digits)}};
}

// A word as a shell takes it, in escapes where it has bytes that a terminal would obey.
std::string shell_word(const std::string& word) {
    const bool is_obeyed = word != legible(word, word.size() + 8);
    const bool is_plain = word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                 "0123456789_-+=./:,@%") == std::string::npos;
    if (is_plain && !word.empty()) return word;
    std::string quoted = is_obeyed ? "$'" : "'";
    for (const char c : word) {
        char text[5] = {c, 0, 0, 0, 0};
        if (is_obeyed && (c < ' ' || c > '~' || c == '\'' || c == '\\'))
            std::snprintf(text, sizeof text, "\\x%02X", static_cast<unsigned char>(c));
        quoted += !is_obeyed && c == '\'' ? "'\\''" : text;
    }
    return quoted + "'";
}

std::string shell_text(std::vector<std::string> words) {
    std::ranges::transform(words, words.begin(), shell_word);
    return joined(words);
}

// The report as JSON (docs/conformance-output.md).
std::string report_json(const ConformReport& report) {
    Json object = {{"format", 1}, {"subject", report.name}};
    if (!report.options.command.empty()) object["command"] = shell_text(report.options.command);
    if (!report.dialect.empty()) object["dialect"] = report.dialect;
    object["method"] = report.options.method;
    object["status"] = report.status();
    object["conforms"] = report.conforms;
    object["broken"] = report.broken;
    if (!report.cut_short.empty()) object["cut_short"] = report.cut_short;
    object["needed"] = report.options.needed;
    object["counts"] = counts_json(counts_of(report.judged));
    object["scores"] = list_of(scores(report.judged), score_json);
    object["diagnosis"] = diagnosis_json(report.diagnosis);
    object["notes"] = report.notes;
    if (report.changes)
        object["since"] = {{"better", list_of(report.changes->better, change_json)},
                           {"worse", list_of(report.changes->worse, change_json)}};
    object["results"] = list_of(report.judged, result_json);
    return object.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void check(const RunSettings& options) {
    constexpr double longest_wait = 3600;
    constexpr double longest_run = 7 * 24 * 3600.0;
    constexpr int most_jobs = 256;
    if (!(options.seconds > 0 && options.seconds <= longest_wait))
        throw InputError("timeout", "must be positive and at most " + number_to_text(longest_wait) + " seconds",
                         number_to_text(options.seconds));
    if (options.jobs < 1 || options.jobs > most_jobs)
        throw InputError("jobs", "must be from 1 to " + std::to_string(most_jobs), std::to_string(options.jobs));
    if (!(options.total_seconds >= 0 && options.total_seconds <= longest_run))
        throw InputError("total-timeout", "must be from 0, which means no limit, to " + number_to_text(longest_run) + " seconds",
                         number_to_text(options.total_seconds));
}

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

// Verdicts by id.
using Verdicts = std::map<std::string, Verdict>;

// The verdicts of a file; none where there is no file yet.
std::optional<Verdicts> tracked_verdicts(const std::string& path) {
    std::error_code fault;
    if (!std::filesystem::exists(path, fault)) return std::nullopt;
    const nlohmann::json file = json_or_nothing(read_input(path));
    const InputError no_such_file("track", "must be a file that --track has written", path);
    if (!file.is_object() || file.value("format", nlohmann::json()) != 1 || !file.contains("verdicts") ||
        !file["verdicts"].is_object())
        throw InputError(no_such_file);
    Verdicts verdicts;
    for (const auto& [id, text] : file["verdicts"].items()) {
        const auto verdict = text.is_string() ? verdict_named(text.get<std::string>()) : std::nullopt;
        if (!verdict) throw InputError(no_such_file);
        verdicts.emplace(id, *verdict);
    }
    return verdicts;
}

// A run beside the file of earlier ones.
Comparison compare(const Verdicts& before, std::span<const Judged> judged) {
    Comparison changes;
    // Fewer digits of a right answer, and a wrong answer where there was none, are no step back.
    const auto rank = [](Verdict verdict) { return is_right(verdict) ? 0 : badness(verdict); };
    for (const Judged& one : judged) {
        const auto earlier = before.find(one.vector->question.id);
        if (earlier == before.end()) continue;
        const int change = rank(one.verdict) - rank(earlier->second);
        if (change < 0) changes.better.push_back({earlier->first, earlier->second, one.verdict});
        if (change > 0 && earlier->second != Verdict::skipped)
            changes.worse.push_back({earlier->first, earlier->second, one.verdict});
    }
    return changes;
}

// The text of a file of verdicts: those of a run, and the earlier ones of vectors that were not asked.
std::string tracked_text(Verdicts before, std::span<const Judged> judged) {
    for (const Judged& one : judged) before[one.vector->question.id] = one.verdict;
    Json file = {{"format", 1}, {"verdicts", Json::object()}};
    for (const auto& [id, verdict] : before) file["verdicts"][id] = name(verdict);
    return file.dump(1) + "\n";
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
    const SolverMethod& method = method_named(options.method);
    std::vector<Vector> all = read_vectors(options.vectors);
    for (Vector& v : all) widen(v, method);
    return all;
}

// Diagnosis, comparison, and the report where it belongs. Where something got worse the file of verdicts is left as it was.
void finish(ConformReport& report, const std::optional<Verdicts>& earlier, ExitStatus& status) {
    const ConformOptions& options = report.options;
    const SolverMethod& method = method_named(options.method);
    for (Judged& one : report.judged) excuse(one, method);
    Thresholds least;
    least.agreement = method.displacement.loose;
    report.diagnosis = diagnose(report.judged, fitted_to(report.judged), least);
    report.conforms = report.cut_short.empty() && conforms(report.judged, {options.needed.begin(), options.needed.end()});
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
void note_what_is_kept(ConformReport& report) {
    constexpr std::size_t most = 4;
    std::vector<const Judged*> wrong;
    for (const Judged& one : report.judged)
        if (is_wrong_value(one.verdict) && one.answered) wrong.push_back(&one);
    const std::size_t count = std::min(most, wrong.size());
    for (std::size_t n = 0; n < count; ++n) {
        const Judged* one = wrong[(2 * n + 1) * wrong.size() / (2 * count)]; // late ones too: what is kept may be kept late
        const std::string& id = one->vector->question.id;
        try {
            const Judged alone = converse(report.options, {&one->vector, 1}, [](std::size_t) {}).judged.at(0);
            if (!alone.answered || alone.given == one->given) continue;
            report.notes.push_back(
                "The program keeps something from question to question: asked alone, as --repro asks, it answers " + id +
                " otherwise.");
            return;
        } catch (const BrokenProgram&) { // it is asked no more
            return;
        }
    }
}

std::string runner_command(const ConformOptions& options, const Vector& v) {
    std::vector<std::string> words{this_program(), "conform", "run"};
    if (options.vectors != vectors_folder()) words.insert(words.end(), {"--vectors", options.vectors});
    if (options.method != methods().front().name) words.insert(words.end(), {"--method", options.method});
    if (is_of_systems(v)) words.emplace_back("--systems");
    words.insert(words.end(), {"--filter", "^" + options.repro + "$", "--verbose", "--"});
    words.insert(words.end(), options.command.begin(), options.command.end());
    return shell_text(words);
}

std::string pipe_command(const ConformOptions& options, const std::string& line) {
    return "printf '%s\\n' " + shell_text({"denhartog-conform 1", line}) + " | " + shell_text(options.command);
}

// A quantity that no question asks for would never be skipped.
void require_asked(const std::vector<std::string>& needed, const std::vector<const Vector*>& chosen) {
    for (const std::string& name : needed)
        if (std::ranges::none_of(chosen, [&](const Vector* v) { return v->question.quantity == name; }))
            throw InputError("need", "must name quantities that are asked about", name);
}

} // namespace

void conform_repro(const ConformOptions& options, ExitStatus& status) {
    check(options);
    const SolverMethod& method = method_named(options.method);
    const std::vector<Vector> all = read_vectors(options.vectors);
    Vector v = vector_named(options.repro, all);
    widen(v, method);
    const WithoutBrokenPipeSignal guard;
    const Partner partner = shake_hands(options);
    const std::string line = line_for(partner, v.question);
    write_standard_output("# with the runner\n" + runner_command(options, v) + "\n\n# as a bare pipe\n" +
                          pipe_command(options, line) + "\n\n# what came of it\n");
    const Reply reply = partner.process->ask(line, options.seconds);
    const bool answered = !reply.trouble;
    Judged judged;
    std::string told = reply.told + "\n";
    if (answered) {
        judged = judge(v, partner, reply);
        excuse(judged, method);
        const Diagnosis d = diagnose({&judged, 1}, mistakes());
        told = legible(reply.line) + "\n" + answer_text(judged, "");
        for (const Finding& finding : d.findings)
            told += "  it is the answer of the mistake " + finding.mistake.name + ": " + finding.mistake.told + "\n";
    }
    write_standard_output(told);
    status.broken = !answered;
    status.failed = answered && !is_right(judged.verdict) && judged.verdict != Verdict::skipped;
}

void conform_run(const ConformOptions& options, ExitStatus& status) {
    check(options);
    require_quantities("need", options.needed);
    const std::vector<Vector> all = vectors_for(options);
    const std::vector<const Vector*> chosen = selected(options, all);
    require_asked(options.needed, chosen);
    const std::optional<Verdicts> earlier = earlier_verdicts(options);
    Interruptible interruptible(interruption());
    ConformReport report{converse(options, chosen, [&](std::size_t done) { show_answered(done, chosen.size()); }), options};
    if (interruptible.caught() != 0) denhartog::program::report("interrupted: the report tells what was answered until then");
    if (report.name.empty()) report.name = legible(options.command.front());
    if (!report.broken && report.cut_short.empty()) note_what_is_kept(report);
    status.signal = interruptible.end();
    finish(report, earlier, status);
}

void conform_grade(const ConformOptions& options, ExitStatus& status) {
    require_quantities("need", options.needed);
    const std::vector<Vector> all = vectors_for(options);
    std::set<std::string> ids;
    for (const Vector& v : all) ids.insert(v.question.id);
    const std::map<std::string, Answer> answers = answers_in(read_input(options.answers), ids);
    SelectionOptions choice = options;
    if (choice.groups.empty()) // who answers about systems beyond the paper asks for the verdict
        choice.systems = choice.systems || std::any_of(all.begin(), all.end(), [&](const Vector& v) {
                             return is_of_systems(v) && answers.contains(v.question.id);
                         });
    const std::vector<const Vector*> chosen = selected(choice, all);
    require_asked(options.needed, chosen);
    const std::optional<Verdicts> earlier = earlier_verdicts(options);
    ConformReport report{{}, options};
    report.name = legible(options.answers);
    for (const Vector* v : chosen) {
        const auto answer = answers.find(v->question.id);
        report.judged.push_back(grade(*v, answer != answers.end() ? answer->second : Skipped{"no answer in the file"}));
    }
    finish(report, earlier, status);
}

void conform_smoke(const ConformOptions& options, ExitStatus& status) {
    check(options);
    Interruptible interruptible(interruption());
    const Smoke found = smoke(options);
    status.signal = interruptible.end();
    if (status.signal != 0) return;
    Rows rows;
    bool good = true, kept = true;
    for (const SmokeCheck& check : found.checks) {
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
