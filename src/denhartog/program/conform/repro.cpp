#include <cstdio>

#include "conformance/grade.hpp"
#include "conformance/method.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/program/conform/options.hpp"
#include "denhartog/program/conform/report.hpp"
#include "denhartog/program/output/files.hpp"

namespace denhartog::program {
namespace {

using conformance::Vector;

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
    const bool answered = reply.heard == conformance::Heard::line;
    conformance::Judged judged;
    std::string told = reply.told + "\n";
    if (answered) {
        judged = conformance::grade(v, conformance::answer_in(partner, reply.line, v.question.id));
        conformance::excuse(judged, method);
        const conformance::Diagnosis d = conformance::diagnose({&judged, 1}, conformance::known_signatures());
        told = legible(reply.line) + "\n" + answer_text(judged, "");
        for (const conformance::Finding& finding : d.findings)
            told += "  it is the answer of the mistake " + finding.mistake->name + ": " + finding.mistake->told + "\n";
    }
    write_standard_output(told);
    status.broken = !answered;
    status.failed = answered && !conformance::is_right(judged.verdict) && judged.verdict != conformance::Verdict::skipped;
}

} // namespace denhartog::program
