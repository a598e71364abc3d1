// Programs that do everything but answer: each is survived, in time, with the verdict that says what it did.
#include <csignal>

#include <array>
#include <chrono>
#include <fstream>
#include <sstream>

#include "conformance/session/session.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/runner_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;

namespace {

constexpr double patience = 0.6;

/// A program by what it does after the handshake, as lines of shell, and what comes of it.
struct Hostile {
    std::string what, text, verdict, told;
    int status;
};

const std::string greet = "read -r greeting; echo 'denhartog-conform 1 plain Hostile'; ";

// Lines that have to arrive together are written by one call of `env printf`: a shell's own printf may write each by itself, and
// then it is chance whether a line comes before or after the next question, as docs/protocol.md has it.
// Verdicts are those on the first of three questions; "none" where there is no handshake.
std::vector<Hostile> hostile_programs() {
    return {
        {"silent from the start", "sleep 1000", "none", "stall, it waits and computes nothing", 3},
        {"silent after the handshake", greet + "sleep 1000", "stall", "flush its output after each line", 3},
        {"never reads its input", greet + "exec 0<&-; sleep 1000", "stall", "it waits", 3},
        {"computes for ever", greet + "while :; do :; done", "timeout", "still computing", 3},
        {"ignores SIGTERM and the like", "trap '' TERM INT HUP PIPE; " + greet + "while :; do sleep 1000; done", "stall",
         "it waits", 3},
        {"stops itself", greet + "read -r q; kill -STOP $$; echo late", "stall", "stopped by a signal", 3},
        {"ends at once", "exit 0", "none", "it ended with status 0", 3},
        {"ends with status 1 at a question", greet + "read -r q; exit 1", "crash", "it ended with status 1", 3},
        {"a segmentation fault", greet + "read -r q; kill -SEGV $$", "crash", "signal 11", 3},
        {"half a line, then nothing", greet + "read -r id q; printf \"$id val\"; sleep 1000", "stall", "half a line", 3},
        {"half a line, then the end", greet + "read -r id q; printf \"$id val\"", "crash", "in the middle of a line", 3},
        {"output without an end or a line", greet + "cat /dev/zero", "crash", "more than a megabyte", 3},
        {"one line of two megabytes", greet + "read -r q; head -c 2000000 /dev/zero | tr '\\0' x; echo; sleep 1000", "crash",
         "a line of more than a megabyte", 3},
        {"a million lines", greet + "read -r q; yes nonsense | head -n 1000000; sleep 1000", "wrong",
         "the answer is to 'nonsense'", 1},
        {"garbage and zero bytes", greet + "while read -r q; do printf '\\377\\000\\033[2J\\001\\n'; done", "wrong",
         "the answer is to", 1},
        {"answers to other ids", greet + "while read -r id q; do echo \"x$id value 1\"; done", "wrong", "the answer is to 'xa-1'",
         1},
        {"not a number", greet + "while read -r id q; do echo \"$id value nan\"; done", "wrong", "'nan' is neither", 1},
        {"infinity", greet + "while read -r id q; do echo \"$id value 1e999\"; done", "wrong", "'1e999' is neither", 1},
        {"three lines an answer", greet + "while read -r id q; do env printf \"$id value 1\\nso\\nthere\\n\"; done", "pass",
         "lines written without being asked, the first 'so'", 0},
        {"a line before each answer", greet + "while read -r id q; do env printf \"so\\n$id value 1\\n\"; done", "wrong",
         "the answer is to 'so'", 1},
        {"writes before the handshake", "echo 'GNU something 7.1'; " + greet + "sleep 1000", "none",
         "but wrote 'GNU something 7.1'", 3},
        {"another version", "echo 'denhartog-conform 2 json New'; sleep 1000", "none", "must speak version 1", 3},
        {"a child that keeps the pipe", greet + "read -r q; sleep 1000 & exit 0", "crash", "it ended with status 0", 3},
        {"closes its output and lives", greet + "exec 1>&-; sleep 1000", "crash", "closed its standard output", 3},
        {"does not end", greet + "while read -r id q; do echo \"$id value 1\"; done; sleep 1000", "pass",
         "did not end when its standard input", 0},
        {"one answer a life", greet + "read -r id q; echo \"$id value 1\"", "pass", "", 1},
    };
}

const std::string& three() {
    static const std::string folder = folder_of(
        "three", {vector_of("a-1", "amplitude", {1}), vector_of("a-2", "amplitude", {1}), vector_of("a-3", "amplitude", {1})});
    return folder;
}

// The processes that a script has left, by its name in their command lines.
std::size_t left_of(const std::string& name) {
    std::size_t count = 0;
    std::error_code gone;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", gone))
        if (content_of(entry.path() / "cmdline").find(name) != std::string::npos) ++count;
    return count;
}

std::string verdict_of_first(const Run& run) {
    if (run.output.empty()) return "none";
    return nlohmann::json::parse(run.output).at("results").at(0).at("verdict");
}

} // namespace

TEST_CASE("hostile programs are survived, each in its time and with the verdict that says what it did",
          "[conformance][hostile]") {
    std::string table = "| program | verdict on the first question | status |\n|---|---|--:|\n";
    int number = 0;
    for (const Hostile& hostile : hostile_programs()) {
        const std::string name = "hostile-" + std::to_string(::getpid()) + "-" + std::to_string(++number) + ".sh";
        const std::string program = script(name, hostile.text + "\n");
        const auto start = std::chrono::steady_clock::now();
        const Run run =
            conform("run --format json --timeout " + std::to_string(patience) + " --vectors '" + three() + "' -- " + program);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        INFO(hostile.what << ": status " << run.status << " after " << seconds << " s, " << run.output << run.error);
        CHECK(run.status == hostile.status);
        CHECK(verdict_of_first(run) == hostile.verdict);
        const bool told = (run.output + run.error).find(hostile.told) != std::string::npos;
        CHECK(told);
        // Three questions and what surrounds them; the machine may be busy.
        CHECK(seconds < 3 * (1 + patience_at_start) * patience + 10);
        CHECK(left_of(name) == 0);
        table += std::string("| ") + hostile.what + " | " + verdict_of_first(run) + " | " + std::to_string(run.status) + " |\n";
    }
    CHECK(number >= 12);
    if (const char* folder = std::getenv("DENHARTOG_CONFORMANCE")) {
        std::filesystem::create_directories(folder);
        std::ofstream(std::filesystem::path(folder) / "hostile.md") << table << '\n'
                                                                    << number << " kinds, each survived within its time.\n";
    }
}

TEST_CASE("a program that breaks again and again is started five times more, then the rest is skipped",
          "[conformance][hostile]") {
    std::vector<Vector> vectors;
    for (int n = 1; n <= 9; ++n) vectors.push_back(vector_of("b-" + std::to_string(n), "amplitude", {1}));
    const std::string folder = folder_of("nine", vectors);
    const auto started = scratch() / "started";
    const auto counts = [&](const std::string& text, const std::string& jobs) {
        std::filesystem::remove(started);
        const Run run = conform("run --format json --timeout 0.5 --jobs " + jobs + " --vectors '" + folder + "' -- " +
                                script("breaking.sh", "echo >>'" + started.string() + "'\n" + text + "\n"));
        INFO(run.output << run.error);
        return std::pair{run.status, nlohmann::json::parse(run.output).at("counts")};
    };
    const auto [status, all] = counts(greet + "read -r q; exit 1", "1");
    CHECK(status == 3);
    CHECK(all.at("crash") == 6);
    CHECK(all.at("skipped") == 3);
    CHECK(lines_of(content_of(started)).size() == 6);
    // An answer in between ends the row.
    const auto [mixed_status, mixed] = counts(greet + "read -r id q; echo \"$id value 1\"; read -r q; exit 1", "1");
    CHECK(mixed_status == 1);
    CHECK(mixed.at("pass") == 5);
    CHECK(mixed.at("crash") == 4);
    const auto [side_status, side] = counts(greet + "read -r q; exit 1", "3");
    CHECK(side_status == 3);
    CHECK(side.at("pass") == 0);
}

TEST_CASE("what cannot be started is status 3 and one line", "[conformance][hostile]") {
    for (const std::string program : {"/no/such/program", "/", "no-such-program-anywhere"}) {
        const Run run = conform("run --vectors '" + three() + "' -- " + program);
        INFO(run.error);
        CHECK(run.status == 3);
        CHECK(run.output.empty());
        CHECK(run.error.starts_with("denhartog: the program cannot be started: " + program + " ("));
        CHECK(lines_of(run.error).size() == 1);
    }
}

TEST_CASE("the children of a program are gone with it, and none is left to be waited for", "[conformance][hostile]") {
    const auto pids = scratch() / "pids";
    const std::string text = "sleep 1000 & echo $$ $! >'" + pids.string() + "'; bash -c 'sleep 1000 & echo $! >>\"" +
                             pids.string() + "\"; exec sleep 1000' & while [ $(wc -w <'" + pids.string() +
                             "') -lt 3 ]; do sleep 0.01; done; " + greet + "read -r q; ";
    const Vector v = vector_of("a-1", "amplitude", {1});
    const Vector* const asked = &v;
    for (const std::string ending : {"exit 3", "sleep 1000"}) {
        const std::string name = file_with("family.sh", text + ending + "\n").string();
        const Conversation conversation = converse({{"bash", name}, 0.5, 1}, {&asked, 1}, [](std::size_t) {});
        CHECK(conversation.broken);
        std::istringstream written(content_of(pids));
        int count = 0;
        for (long pid = 0; written >> pid; ++count) {
            INFO(ending << ", process " << pid);
            CHECK_FALSE(std::filesystem::exists("/proc/" + std::to_string(pid)));
        }
        CHECK(count == 3);
    }
}

TEST_CASE("an interruption of the runner takes the program under test with it", "[conformance][hostile][threads]") {
    const std::string name = "interrupted-" + std::to_string(::getpid()) + ".sh";
    const std::string program = script(name, greet + "sleep 1000");
    const auto report = scratch() / "interrupted-report";
    const std::string caller =
        script("interrupting.sh", quoted_program() + " conform run --timeout 60 --output '" + report.string() + "' --vectors '" +
                                      three() + "' -- " + program + " 2>/dev/null & sleep 1; kill -TERM $!; wait $!\n");
    CHECK(run_shell(caller).status == 128 + SIGTERM);
    CHECK(left_of(name) == 0);
    std::ifstream written(report);
    const std::string text{std::istreambuf_iterator<char>(written), {}};
    CHECK(contains(text, "Cut short: the runner was interrupted after"));
    CHECK_FALSE(contains(text, "Conforms."));
}

TEST_CASE("a map that nobody reads is ended by a signal", "[conformance][hostile]") {
    const char* program = std::getenv("DENHARTOG_PROGRAM");
    REQUIRE(program != nullptr);
    const std::string pipe = (scratch() / "nobody-reads").string();
    const std::string caller =
        script("ending-a-map.sh",
               "mkfifo '" + pipe + "'; sleep 30 <'" + pipe + "' & '" + std::string(program) +
                   "' map --r 0.5:2:100 --beta 0:1:100 - >'" + pipe + "' <<<'{\"mass_ratios\":1,\"stiffness_ratios\":1," +
                   "\"damping_ratios\":0.1,\"contact\":1,\"load\":1}' & map=$!; sleep 1; kill -TERM $map; " +
                   "for n in {1..50}; do kill -0 $map 2>/dev/null || break; sleep 0.1; done; kill -KILL $map 2>/dev/null; " +
                   "wait $map; ended=$?; kill %1; exit $ended\n");
    CHECK(WEXITSTATUS(std::system(caller.c_str())) == 128 + SIGTERM);
}

TEST_CASE("after the total time the report tells what was answered until then", "[conformance][hostile]") {
    const std::string slow = script("slow.sh", greet + "while read -r id q; do sleep 0.6; echo \"$id value 1\"; done\n");
    const Run run = conform("run --total-timeout 1 --format json " + with_vectors(three(), "-- " + slow));
    CHECK(run.status == 1);
    const nlohmann::json report = nlohmann::json::parse(run.output.substr(run.output.find('{')));
    CHECK(report.at("cut_short") == "the total time was over after 2 of 3 questions");
    CHECK_FALSE(report.at("conforms"));
    CHECK(report.at("results").at(2).at("verdict") == "skipped");
    CHECK(conform("run --total-timeout -1 " + with_vectors(three(), "-- " + slow)).status == 2);
}

TEST_CASE("standard error without an end costs the runner no memory, and the answers count", "[conformance][hostile]") {
    const std::vector<std::array<std::string, 2>> programs{
        {greet + "read -r q; cat /dev/zero >&2", "timeout"},
        {"cat /dev/zero >&2 & " + greet + "while read -r id q; do echo \"$id value 1\"; done; kill $!", "pass"}};
    int number = 0;
    for (const auto& [text, verdict] : programs) {
        const std::string name = "flooding-" + std::to_string(::getpid()) + "-" + std::to_string(++number) + ".sh";
        // In memory that the flood would fill at once if it were kept.
        const Run run = run_program("--version >/dev/null; ( ulimit -v 500000; exec " + quoted_program() +
                                    " conform run --format json --timeout " + std::to_string(patience) + " --vectors '" +
                                    three() + "' -- " + script(name, text + "\n") + " 2>/dev/null )");
        INFO(run.output);
        CHECK(run.status == (verdict == "pass" ? 0 : 3));
        const std::string output = run.output.substr(std::min(run.output.find('{'), run.output.size()));
        CHECK(nlohmann::json::parse(output).at("results").at(0).at("verdict") == verdict);
        CHECK(left_of(name) == 0);
    }
}

TEST_CASE("a runner that hangs up or is killed leaves no program that computes for ever", "[conformance][hostile]") {
    const auto report = scratch() / "killed-report";
    for (const int signal : {SIGHUP, SIGKILL})
        for (const std::string jobs : {"1", "3"}) {
            const std::string name = "orphan-" + std::to_string(::getpid()) + "-" + std::to_string(signal) + "-" + jobs + ".sh";
            const auto started = scratch() / (name + ".started");
            const std::string program = script(name, greet + "echo >'" + started.string() + "'; while :; do :; done\n");
            const std::string caller =
                script("killing.sh", quoted_program() + " conform run --timeout 60 --jobs " + jobs + " --output '" +
                                         report.string() + "' --vectors '" + three() + "' -- " + program +
                                         " 2>/dev/null & for n in $(seq 500); do [ -e '" + started.string() +
                                         "' ] && break; sleep 0.02; done; kill -" + std::to_string(signal) + " $!; wait $!\n");
            INFO("signal " << signal << ", " << jobs << " at a time");
            CHECK(run_shell(caller).status == 128 + signal);
            for (int n = 0; n < 200 && left_of(name) > 0; ++n) ::usleep(10'000);
            CHECK(left_of(name) == 0);
            CHECK(std::filesystem::exists(report) == (signal == SIGHUP)); // the report tells what was answered until then
            std::filesystem::remove(report);
        }
}

TEST_CASE("a hang-up that the runner was told to ignore, as nohup does, ends nothing", "[conformance][hostile]") {
    const std::string program = script("slow.sh", greet + "while read -r id q; do sleep 0.3; echo \"$id value 1\"; done\n");
    const std::string caller = script("ignoring.sh", "trap '' HUP; " + quoted_program() + " conform run --vectors '" + three() +
                                                         "' -- " + program + " >/dev/null & sleep 0.3; kill -HUP $!; wait $!\n");
    CHECK(run_shell(caller).status == 0);
}
