// `denhartog conform` as a user meets it.
#include "conformance/mistakes/mistake.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/runner_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;

namespace {

Run run(const std::string& options, const std::string& program) {
    return conform("run " + with_vectors(six(), options) + " -- " + program);
}

// A program whose answers are right but for one.
std::string with_answer(const std::string& right, const std::string& given) {
    static int number = 0;
    return table_program("program-" + std::to_string(++number), replaced(right_answers, right, given));
}

} // namespace

TEST_CASE("a run ends with its status, and tells what it found", "[conformance][program]") {
    const std::string right = table_program("right", right_answers);
    const std::string wrong = with_answer("amplitude-1 value 0.25", "amplitude-1 value 0.5");
    const std::string lax = with_answer("amplitude-2 value 0x1p-1", "amplitude-2 value 1"); // a stress is wrong
    const std::string skipping = with_answer("phase-1 value 3", "phase-1 skip later");      // a should is skipped
    const std::string in_json =
        script("json.sh", "read -r greeting\necho 'denhartog-conform 1 json In JSON'\n"
                          "while read -r line; do id=${line#*\\\"id\\\":\\\"}; id=${id%%\\\"*}\n"
                          "case $id in amplitude-1) echo \"{\\\"id\\\":\\\"$id\\\",\\\"value\\\":0.25}\";;\n"
                          "*) echo \"{\\\"id\\\":\\\"$id\\\",\\\"skip\\\":\\\"no\\\"}\";; esac; done\n");
    const std::string keeping = script("keeping.sh", "read -r greeting\necho 'denhartog-conform 1 plain Keeps'\nn=0\n"
                                                     "while read -r id rest; do n=$((n + 1)); echo \"$id value $n\"; done\n");
    const std::string odd = script("odd.sh", "[ \"$1\" = '[1,2]' ] && [ \"$2\" = --jobs ] && [ \"$3\" = -- ] || exit 9\n"
                                             "read -r greeting; echo 'denhartog-conform 1 plain Odd'\n"
                                             "while read -r id rest; do echo \"$id skip\"; done\n");
    const struct {
        std::string options, program;
        int status;
        std::vector<std::string> told{}, not_told{};
    } rows[] = {
        {"", right, 0, {"Table of answers (plain): 6 questions", "\nConforms.\n"}, {"Notes:"}},
        {"--verbose", in_json, 0, {"In JSON (json)", "amplitude-1  pass"}},
        {"",
         wrong,
         1,
         {"amplitude-1  wrong", "answer 0.5 (0x1p-1)", "true   0.25 (0x1p-2)", "over tolerance 1e+12; condition r 2",
          "\nDoes not conform.\n"},
         {"The program keeps something"}},
        {"", lax, 0, {"\nConforms in must; 1 answer is wrong in stress.\n"}},
        {"--strict", lax, 4},
        {"--strict", right, 0},
        {"--strict", wrong, 1},
        {"", skipping, 0},
        {"--need amplitude,phase", skipping, 1}, // what is needed must not be skipped
        {"--need amplitude,regime", skipping, 0},
        {"", table_program("nothing", ""), 1, {"\nDoes not conform, because no question was answered.\n"}},
        {"--quantity amplitude,phase", right, 0, {"Table of answers (plain): 3 questions"}},
        {"--quantity amplitudes", right, 2, {"quantity must name quantities of the protocol"}},
        {"--quantity amplitude,phase", keeping, 1, {"\n  The program keeps something from question to question: "}},
        {"--format junit",
         wrong,
         1,
         {"<system-out>&#10;Diagnosis (1 answer is wrong or inaccurate):", "Does not conform.&#10;</system-out>"}},
        {"--format junit", right, 0, {}, {"system-out"}},
        {"--format markdown", // no text of an answer can end a cell
         with_answer("amplitude-1 value 0.25", "amplitude-1 value a|b"),
         1,
         {"## Table of answers", "a\\|b", "| tier | group | asked |"}},
        {"", odd + " '[1,2]' --jobs --", 1, {"Odd (plain): 6 questions"}}, // what follows -- is the program's
    };
    for (const auto& row : rows) {
        const Run r = run(row.options, row.program);
        INFO(row.options << " -- " << row.program << "\n" << r.output << r.error);
        CHECK(r.status == row.status);
        CHECK(r.error.empty() == (r.status != 2));
        for (const std::string& text : row.told) CHECK(contains(r.output + r.error, text));
        for (const std::string& text : row.not_told) CHECK_FALSE(contains(r.output, text));
    }
}

TEST_CASE("several processes give the same verdicts as one", "[conformance][program][threads]") {
    std::vector<Vector> vectors;
    std::string answers;
    for (int n = 0; n < 60; ++n) {
        const std::string id = "many-" + std::to_string(n);
        vectors.push_back(vector_of(id, "amplitude", {n / 8.0}));
        if (n % 7 != 0) answers += id + " value " + std::to_string(n % 5 == 0 ? n + 1 : n / 8.0) + "\n";
    }
    const std::string folder = folder_of("many", vectors);
    const auto results = [&](const std::string& jobs) {
        const Run r =
            conform("run --format json --jobs " + jobs + " --vectors '" + folder + "' -- " + table_program("many", answers));
        CHECK(r.status == 1);
        return nlohmann::json::parse(r.output).at("results");
    };
    const nlohmann::json one = results("1");
    CHECK(one.size() == 60);
    CHECK(one == results("4"));
    CHECK(one == results("100"));
}

TEST_CASE("the report as JSON has the members that its page names", "[conformance][program]") {
    const std::string program = with_answer("modes-1 value 1.5 0.75", "modes-1 value 1.5 0.5");
    const auto file = scratch() / "report.json";
    const Run r = run("--format json --output '" + file.string() + "'", program);
    CHECK(r.status == 1);
    CHECK(r.output.empty());
    const nlohmann::json report = nlohmann::json::parse(content_of(file));
    CHECK(report.at("format") == 1);
    CHECK(report.at("status") == 1);
    CHECK(report.at("counts").at("wrong") == 1);
    CHECK(report.at("counts").at("rejected") == 1);
    CHECK(report.at("scores").size() == 6);
    const std::string page = content_of(source_file("docs/conformance-output.md"));
    const auto named = [&](const nlohmann::json& object) {
        for (const auto& [key, value] : object.items()) {
            INFO(key);
            CHECK(contains(page, "`" + key + "`"));
        }
    };
    named(report);
    named(report.at("scores").front());
    named(report.at("diagnosis"));
    for (const nlohmann::json& result : report.at("results")) {
        named(result);
        if (result.at("id") != "modes-1") continue;
        CHECK(result.at("verdict") == "wrong");
        CHECK(result.at("worst_number") == 1);
        CHECK(result.at("truth_hex").at(1) == "0x1.8p-1");
        CHECK(result.at("error_over_tolerance").get<double>() > 1e11);
    }
}

TEST_CASE("the report as JUnit is well formed and counts right", "[conformance][program]") {
    const std::string program = table_program(
        "junit", replaced(right_answers, "amplitude-1 value 0.25", "amplitude-1 reject <&\"'> is bad") + "phase-1 skip a < b\n");
    const Run r = run("--format junit", program);
    INFO(r.output);
    CHECK(r.status == 1);
    CHECK(contains(r.output, "tests=\"6\" failures=\"1\" errors=\"0\" skipped=\"1\""));
    CHECK(contains(r.output, "&lt;&amp;&quot;'&gt; is bad"));
    // Every element that is opened is closed, in order.
    std::vector<std::string> open;
    std::size_t cases = 0;
    for (std::size_t at = r.output.find('<', 5); at != std::string::npos; at = r.output.find('<', at + 1)) {
        const std::string tag = r.output.substr(at + 1, r.output.find('>', at) - at - 1);
        const std::string name =
            tag.substr(tag.front() == '/' ? 1 : 0, tag.find_first_of(" /", 1) - (tag.front() == '/' ? 1 : 0));
        if (tag.starts_with("testcase")) ++cases;
        if (tag.front() == '/') {
            REQUIRE_FALSE(open.empty());
            CHECK(open.back() == tag.substr(1));
            open.pop_back();
        } else if (tag.back() != '/') {
            open.push_back(name);
        }
    }
    CHECK(open.empty());
    CHECK(cases == 6);
}

TEST_CASE("verdicts are tracked: what got better and worse is told, and worse fails until it is mended",
          "[conformance][program]") {
    const std::string file = (scratch() / "track.json").string();
    const std::string good = table_program("tracked", right_answers);
    const std::string bad = with_answer("phase-1 value 3", "phase-1 value 2");
    CHECK(run("--track '" + file + "'", bad).status == 0);
    const Run better = run("--track '" + file + "'", good);
    CHECK(better.status == 0);
    CHECK(contains(better.output, "1 better, 0 worse"));
    CHECK(contains(better.output, "better phase-1: wrong -> pass"));
    const std::string kept = content_of(file);
    for (int again = 0; again < 2; ++again) {
        const Run worse = run("--track '" + file + "'", bad);
        CHECK(worse.status == 1);
        CHECK(contains(worse.output, "worse  phase-1: pass -> wrong"));
        CHECK(contains(worse.error, "was left as it was, because something got worse"));
        CHECK(content_of(file) == kept);
    }
    // A question that is not asked keeps its verdict.
    CHECK(run("--filter amplitude --track '" + file + "'", good).status == 0);
    CHECK(content_of(file) == kept);
    const Run none = run("--track '" + file_with("no-track", "{\"verdicts\": 7}").string() + "'", good);
    CHECK(none.status == 2);
    CHECK(contains(none.error, "track must be a file that --track has written"));
}

TEST_CASE("one question is repeated as commands that a shell takes", "[conformance][program]") {
    const std::string program = table_program("repeated", right_answers);
    const Run r = run("--repro amplitude-1", program);
    INFO(r.output << r.error);
    CHECK(r.status == 0);
    const std::vector<std::string> lines = lines_of(r.output);
    REQUIRE(lines.size() > 7);
    CHECK(lines[7] == "amplitude-1 value 0.25");
    const Run whole = run_shell(lines[1]), alone = run_shell(lines[4]);
    CHECK(whole.status == 0);
    CHECK(contains(whole.output + whole.error, "amplitude-1  pass"));
    CHECK(alone.status == 0);
    CHECK(alone.output == "denhartog-conform 1 plain Table of answers\namplitude-1 value 0.25\n");
    CHECK(run("--repro phase-1", table_program("repeated-wrong", "phase-1 value 1\n")).status == 1);
    CHECK(run("--repro no-such", program).status == 2);
    const ProtocolQuestion asked = six_vectors()[1].question;
    const std::optional<Value> mistaken = answer_with_mistake("46-as-printed", asked);
    REQUIRE(mistaken);
    const std::string printed = "amplitude-1 value " + hexadecimal(mistaken->numbers.front()) + "\n";
    const Run diagnosed = run("--repro amplitude-1", table_program("repeated-printed", printed));
    INFO(diagnosed.output);
    CHECK(contains(diagnosed.output, "amplitude-1  as-printed (46)"));
    CHECK(contains(diagnosed.output, "the answer of the mistake 46-as-printed: "));
}

TEST_CASE("smoke looks at the protocol and at no number", "[conformance][program]") {
    const auto smoked = [](const std::string& text, int status, const std::vector<std::string>& told) {
        const Run r =
            conform("smoke -- " + script("smoke.sh", "read -r greeting; echo 'denhartog-conform 1 plain Smoke'\n" + text));
        INFO(text << r.output << r.error);
        CHECK(r.status == status);
        for (const std::string& each : told) CHECK(contains(r.output, each));
        return r;
    };
    const Run good = smoked("while read -r id q rest; do case $id in\n"
                            "smoke-H-j|smoke-amplitude) echo \"$id value 17\";;\n"
                            "smoke-rejected) echo \"$id reject negative mass\";;\n"
                            "*) echo \"$id skip\";; esac; done\n",
                            0, {"The protocol is kept. No number was checked."});
    CHECK(lines_of(good.output).size() == 1 + 25 + 3 + 2);
    smoked("while read -r id q rest; do case $id in\n"
           "smoke-rejected) echo \"$id value 17\";; *) echo \"$id skip\";; esac; done\n",
           1, {"The protocol is kept, but a question that breaks a rule was answered."});
    smoked("while read -r id q rest; do echo \"$id value 1 2 3\"; done; exit 4\n", 1,
           {"must be as many numbers as the protocol has, 1, but is 3", "must be rejected", "must be skipped",
            "it ended with status 4"});
    CHECK(conform("smoke -- /no/such/program").status == 3);
}

// Which vectors, answers in files, and what is refused.

TEST_CASE("questions are chosen by filter, group, tier and whether they have to be rejected", "[conformance][program]") {
    const auto ids = [](const std::string& options) {
        std::string all;
        const Run r = conform("list " + with_vectors(six(), options));
        CHECK(r.status == 0);
        const std::vector<std::string> lines = lines_of(r.output);
        for (std::size_t n = 1; n < lines.size(); ++n) all += lines[n].substr(2, lines[n].find(' ', 2) - 2) + " ";
        return all;
    };
    CHECK(ids("") == "amplitude-1 amplitude-2 modes-1 phase-1 regime-1 reject-1 ");
    CHECK(ids("--filter '^(a|p).*1$'") == "amplitude-1 phase-1 ");
    CHECK(ids("--group modes,regime") == "modes-1 regime-1 ");
    CHECK(ids("--tier should,stress") == "amplitude-2 phase-1 ");
    CHECK(ids("--tier must --skip-must-fail") == "amplitude-1 modes-1 regime-1 ");
    const Run summary = conform("list --summary " + with_vectors(six(), ""));
    CHECK(contains(summary.output, "all        4     1       1"));
    const Run shown = conform("show amplitude-1 " + with_vectors(six(), ""));
    CHECK(shown.status == 0);
    CHECK(contains(shown.output, "plain  amplitude-1 amplitude 2 2 1 1 0 0 1.25 1.125 0.125 1 2.5 1 0.625 0.0625 0.125\n"));
}

TEST_CASE("answers in a file are graded; what is missing is skipped", "[conformance][program]") {
    const auto graded = [&](const std::string& text, const std::string& options) {
        return conform("grade " + with_vectors(six(), options) + " '" + file_with("answers", text).string() + "'");
    };
    const std::string csv =
        "id,value\r\n\"modes-1\",\"1.5 0.75\"\r\namplitude-1,0.25\r\nregime-1,continuous\r\nreject-1,reject\r\n";
    const Run good = graded(csv, "");
    INFO(good.output << good.error);
    CHECK(good.status == 0);
    CHECK(graded(csv, "--need phase").status == 1);
    CHECK(graded(replaced(csv, "0.25", "0.3"), "").status == 1);
    CHECK(graded("{\"id\":\"amplitude-1\",\"value\":0.25}\n", "--format json").status == 0);
    const Run unknown = graded(csv + "nobody,1\r\n", "");
    CHECK(unknown.status == 2);
    CHECK(unknown.error == "denhartog: id must be a vector's, but is nobody (at line 6)\n");
    CHECK(unknown.output.empty());
    CHECK(graded(csv + "amplitude-1,1\r\n", "").error == "denhartog: id must be given once, but is amplitude-1 (at line 6)\n");
    CHECK(conform("grade " + with_vectors(six(), "") + " /no/such/file").status == 2);
}

TEST_CASE("bad usage is one line with quantity, rule and value, status 2, and leaves nothing", "[conformance][program]") {
    const std::string program = table_program("unused", right_answers);
    const std::string output = (scratch() / "nothing").string();
    const std::vector<std::pair<std::string, std::string>> bad{
        {"--timeout 0", "timeout must be positive and at most 3600 seconds, but is 0"},
        {"--timeout nan", "timeout must be positive"},
        {"--timeout soon", "soon"},
        {"--jobs 0", "jobs must be from 1 to 256, but is 0"},
        {"--tier best", "tier must be must, should or stress, but is best"},
        {"--group none", "but is none"},
        {"--filter '('", "filter must be a regular expression, but is ("},
        {"--filter nothing", "the selection must leave at least one vector, but is 0 of 6"},
        {"--need speed", "need must name quantities of the protocol, but is speed"},
        {"--quantity amplitude --need amplitude,phase", "need must name quantities that are asked about, but is phase"},
        {"--format yaml", "format"},
        {"--no-such-option", "--no-such-option"},
        {"--vectors /no/such/folder", "vectors must be a folder with files *.jsonl, but is /no/such/folder"},
        {"--vectors '" + folder_of("twice", {vector_of("a-1", "amplitude", {1}), vector_of("a-1", "amplitude", {1})}) + "'",
         "id must be given once, but is a-1"},
        {"--output /no/such/folder/report", "/no/such/folder/report cannot be written"},
        {"--track /no/such/folder/track", "/no/such/folder/track cannot be written"},
    };
    for (const auto& [options, message] : bad) {
        const bool own_folder = options.starts_with("--vectors");
        const bool own_output = options.starts_with("--output");
        const Run r = conform("run " + (own_folder ? "" : "--vectors '" + six() + "' ") + options +
                              (own_output ? "" : " --output '" + output + "'") + " -- " + program);
        INFO(options << ": " << r.error);
        CHECK(r.status == 2);
        CHECK(contains(r.error, message));
        CHECK(lines_of(r.error).size() == 1);
        CHECK(r.output.empty());
        CHECK_FALSE(std::filesystem::exists(output));
    }
    CHECK(conform("").status == 2);
    CHECK(conform("run --vectors '" + six() + "'").status == 2);
    CHECK(conform("show nobody --vectors '" + six() + "'").status == 2);
}

TEST_CASE("a zero byte ends neither answers, vectors nor verdicts of earlier runs", "[conformance][program]") {
    using namespace std::string_literals;
    const auto refused_with = [](const Run& r, const std::string& message) {
        INFO(r.error);
        CHECK(r.status == 2);
        CHECK(r.output.empty());
        CHECK(lines_of(r.error).size() == 1);
        CHECK(contains(r.error, message));
    };
    const std::string answers = file_with("zero.csv", "id,value\namplitude-1,0.25\0junk\n"s).string();
    refused_with(conform("grade " + with_vectors(six(), "") + "'" + answers + "'"), "a zero byte (at line 2, column 17)");
    const std::string folder = folder_of("zero", {vector_of("a-1", "amplitude", {1})});
    std::ofstream(folder + "/a.jsonl", std::ios::binary | std::ios::app)
        << vector_json(vector_of("a-2", "amplitude", {1})).dump() << "\0{\n"s;
    refused_with(conform("list " + with_vectors(folder, "")), "a.jsonl, line 2");
    const std::string track = file_with("zero.track", "{\"format\":1,\"verdicts\":{}}\0{"s).string();
    refused_with(conform("run " + with_vectors(six(), "") + "--track '" + track + "' -- " + table_program("zero", right_answers)),
                 "track must be a file that --track has written");
}

TEST_CASE("the texts of vectors and the words of a command reach no terminal as they are", "[conformance][program]") {
    const std::string folder = folder_of("obeyed", {vector_of("a-1\x1b[2J", "amplitude", {1})});
    const Run bad = conform("list " + with_vectors(folder, ""));
    CHECK(bad.status == 2);
    CHECK(contains(bad.error, "id must be a short text without control characters, but is a-1\\x1B[2J"));
    Vector flagged = vector_of("a-1", "amplitude", {1});
    flagged.flags = {"\x1b[2J"};
    CHECK(contains(conform("list " + with_vectors(folder_of("flagged", {flagged}), "")).error, "flags must be a short text"));
    const std::string program = table_program("obeyed", right_answers) + " '\x1b[2J\xFF'";
    for (const std::string format : {"text", "json", "junit", "markdown"}) {
        const Run r = conform("run --format " + format + " " + with_vectors(six(), "") + "-- " + program);
        INFO(r.error);
        CHECK(r.status == 0);
        CHECK_FALSE(contains(r.output, "\x1b"));
        CHECK_FALSE(contains(r.output, "\xFF"));
    }
}

// Parts of a report besides verdicts: groups of answers, missing digits, the known mistakes.

namespace {

constexpr int asked = 12; // more than are told one by one

// A folder of amplitudes, the first few overdamped.
const std::string& amplitudes() {
    static const std::string folder = [] {
        std::vector<Vector> vectors;
        for (int n = 0; n < asked; ++n) {
            vectors.push_back(vector_of("amplitude-" + std::to_string(n), "amplitude", {1}));
            if (n < 5) vectors.back().question.damping_ratios = {0.125, 1.5};
        }
        return folder_of("amplitudes", vectors);
    }();
    return folder;
}

Run graded(const std::string& value_first, const std::string& value_after) {
    std::string answers = "id,value\n";
    for (int n = 0; n < asked; ++n)
        answers += "amplitude-" + std::to_string(n) + "," + (n < 5 ? value_first : value_after) + "\n";
    return conform("grade " + with_vectors(amplitudes(), file_with("amplitudes.csv", answers).string()));
}

} // namespace

TEST_CASE("many wrong answers are told in groups", "[conformance][program]") {
    const Run r = graded("nan", "3");
    INFO(r.output << r.error);
    CHECK(r.status == 1);
    CHECK(contains(r.output, "Wrong answers, 2 of 12:\n"));
    CHECK(contains(r.output, "  5 not finite, overdamped, continuous\n"));
    CHECK(contains(r.output, "  7 wrong, continuous\n"));
}

TEST_CASE("where digits alone are missing, that is said, with how many are left and where", "[conformance][program]") {
    const Run r = graded("1.00001", "1.0001");
    INFO(r.output << r.error);
    CHECK(r.status == 1);
    CHECK(
        contains(r.output, "Digits are missing in 12 answers, and nothing else is wrong. The worst has 4.0 digits: amplitude-"));
    CHECK(contains(r.output, ", amplitude.\n"));
    CHECK_FALSE(contains(graded("1.00001", "3").output, "Digits are missing"));
    CHECK_FALSE(contains(graded("1", "1").output, "Digits are missing"));
}

TEST_CASE("the known mistakes are listed with equation and what to look at", "[conformance][program][mistake]") {
    const Run r = conform("list --mistakes");
    CHECK(r.status == 0);
    const std::vector<std::string> lines = lines_of(r.output);
    REQUIRE(lines.size() == mistakes().size() + 1);
    for (std::size_t n = 0; n < mistakes().size(); ++n) {
        const Mistake& mistake = mistakes()[n];
        const std::string& line = lines[n + 1];
        INFO(line);
        CHECK(contains(line, " " + mistake.name + " "));
        CHECK(contains(line, mistake.told + " Look at: " + mistake.look_at));
        if (!mistake.equation.empty()) CHECK(contains(line, " " + mistake.equation + " "));
    }
}

TEST_CASE("the Python adapter says in a sentence that numpy is missing", "[conformance][program]") {
    const std::filesystem::path source = std::getenv("DENHARTOG_SOURCE_DIR");
    const auto error = file_with("numpy.error", "");
    // -S leaves out the packages of the system, and -E those of the environment.
    const std::string command = "python3 -S -E '" + (source / "tests/conformance/adapters/python/adapter.py").string() +
                                "' </dev/null >/dev/null 2>'" + error.string() + "'";
    if (std::system("python3 -S -E -c 'import numpy' 2>/dev/null") == 0) return; // numpy stands where Python itself does
    CHECK(std::system(command.c_str()) != 0);
    std::ifstream file(error);
    const std::string told{std::istreambuf_iterator<char>(file), {}};
    INFO(told);
    CHECK(told.starts_with("numpy is missing: "));
    CHECK(lines_of(told).size() == 1);
}
