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

} // namespace

TEST_CASE("a program that is right conforms, status 0", "[conformance][program]") {
    const Run r = run("", table_program("right", right_answers));
    INFO(r.output << r.error);
    CHECK(r.status == 0);
    CHECK(r.error.empty());
    CHECK(contains(r.output, "Table of answers (plain): 6 questions"));
    CHECK(contains(r.output, "\nConforms.\n"));
    CHECK_FALSE(contains(r.output, "Notes:"));
}

TEST_CASE("the json dialect is spoken as well", "[conformance][program]") {
    const std::string program =
        script("json.sh", "read -r greeting\necho 'denhartog-conform 1 json In JSON'\n"
                          "while read -r line; do id=${line#*\\\"id\\\":\\\"}; id=${id%%\\\"*}\n"
                          "case $id in amplitude-1) echo \"{\\\"id\\\":\\\"$id\\\",\\\"value\\\":0.25}\";;\n"
                          "*) echo \"{\\\"id\\\":\\\"$id\\\",\\\"skip\\\":\\\"no\\\"}\";; esac; done\n");
    const Run r = run("--verbose", program);
    INFO(r.output << r.error);
    CHECK(r.status == 0);
    CHECK(contains(r.output, "In JSON (json)"));
    CHECK(contains(r.output, "amplitude-1  pass"));
}

TEST_CASE("a wrong must is status 1 and told with answer, truth and error", "[conformance][program]") {
    const std::string program =
        table_program("wrong", replaced(right_answers, "amplitude-1 value 0.25", "amplitude-1 value 0.5"));
    const Run r = run("", program);
    INFO(r.output);
    CHECK(r.status == 1);
    CHECK(contains(r.output, "amplitude-1  wrong"));
    CHECK(contains(r.output, "answer 0.5 (0x1p-1)"));
    CHECK(contains(r.output, "true   0.25 (0x1p-2)"));
    CHECK(contains(r.output, "over tolerance 1e+12; condition r 2"));
    CHECK(contains(r.output, "\nDoes not conform.\n"));
}

TEST_CASE("a wrong should or stress is told and no failure; a needed quantity must not be skipped", "[conformance][program]") {
    const std::string program = table_program("lax", replaced(right_answers, "amplitude-2 value 0x1p-1", "amplitude-2 value 1"));
    const Run lax = run("", program);
    CHECK(lax.status == 0);
    CHECK(contains(lax.output, "\nConforms in must; 1 answer is wrong in stress.\n"));
    CHECK(run("--strict", program).status == 4);
    CHECK(run("--strict", table_program("right", right_answers)).status == 0);
    const std::string wrong = table_program("strict", replaced(right_answers, "amplitude-1 value 0.25", "amplitude-1 value 1"));
    CHECK(run("--strict", wrong).status == 1);
    const std::string skipping = table_program("skipping", replaced(right_answers, "phase-1 value 3", "phase-1 skip later"));
    CHECK(run("", skipping).status == 0);
    CHECK(run("--need amplitude,phase", skipping).status == 1);
    CHECK(run("--need amplitude,regime", skipping).status == 0);
    const Run nothing = run("", table_program("nothing", ""));
    CHECK(nothing.status == 1);
    CHECK(contains(nothing.output, "\nDoes not conform, because no question was answered.\n"));
}

TEST_CASE("quantities are chosen by their names", "[conformance][program]") {
    const Run r = run("--quantity amplitude,phase", table_program("right", right_answers));
    CHECK(r.status == 0);
    CHECK(contains(r.output, "Table of answers (plain): 3 questions"));
    const Run none = run("--quantity amplitudes", table_program("right", right_answers));
    CHECK(none.status == 2);
    CHECK(contains(none.error, "quantity must name quantities of the protocol"));
}

TEST_CASE("a program that keeps something from question to question is told of", "[conformance][program]") {
    const std::string keeping = script("keeping.sh", "read -r greeting\necho 'denhartog-conform 1 plain Keeps'\nn=0\n"
                                                     "while read -r id rest; do n=$((n + 1)); echo \"$id value $n\"; done\n");
    CHECK(contains(run("--quantity amplitude,phase", keeping).output,
                   "\n  The program keeps something from question to question: "));
    const std::string wrong = table_program("wrong", replaced(right_answers, "amplitude-1 value 0.25", "amplitude-1 value 0.5"));
    CHECK_FALSE(contains(run("", wrong).output, "The program keeps something"));
}

TEST_CASE("the diagnosis is in the XML as well", "[conformance][program]") {
    const std::string wrong = table_program("wrong", replaced(right_answers, "amplitude-1 value 0.25", "amplitude-1 value 0.5"));
    const std::string xml = run("--format junit", wrong).output;
    CHECK(contains(xml, "<system-out>&#10;Diagnosis (1 answer is wrong or inaccurate):"));
    CHECK(contains(xml, "Does not conform.&#10;</system-out>"));
    CHECK_FALSE(contains(run("--format junit", table_program("right", right_answers)).output, "system-out"));
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
    const std::string program = table_program("json", replaced(right_answers, "modes-1 value 1.5 0.75", "modes-1 value 1.5 0.5"));
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
    const std::string page =
        content_of(std::filesystem::path(std::getenv("DENHARTOG_SOURCE_DIR")) / "docs/conformance-output.md");
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

TEST_CASE("the report as Markdown has tables whose cells nobody's text can end", "[conformance][program]") {
    const std::string program =
        table_program("markdown", replaced(right_answers, "amplitude-1 value 0.25", "amplitude-1 value a|b"));
    const Run r = run("--format markdown", program);
    INFO(r.output);
    CHECK(r.status == 1);
    CHECK(contains(r.output, "## Table of answers"));
    CHECK(contains(r.output, "a\\|b"));
    CHECK(contains(r.output, "| tier | group | asked |"));
}

TEST_CASE("verdicts are tracked: what got better and worse is told, and worse fails until it is mended",
          "[conformance][program]") {
    const std::string file = (scratch() / "track.json").string();
    const std::string good = table_program("tracked", right_answers);
    const std::string bad = table_program("tracked-bad", replaced(right_answers, "phase-1 value 3", "phase-1 value 2"));
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
    const auto shell = [](const std::string& command) {
        const std::string out = (scratch() / "shell").string();
        const int status = std::system((command + " >'" + out + "' 2>&1").c_str());
        return std::pair{WEXITSTATUS(status), content_of(out)};
    };
    const auto [status, output] = shell(lines[1]);
    CHECK(status == 0);
    CHECK(contains(output, "amplitude-1  pass"));
    CHECK(shell(lines[4]) == std::pair{0, std::string("denhartog-conform 1 plain Table of answers\namplitude-1 value 0.25\n")});
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

TEST_CASE("what follows -- is the program's, brackets and options too", "[conformance][program]") {
    const std::string program = script("odd.sh", "[ \"$1\" = '[1,2]' ] && [ \"$2\" = --jobs ] && [ \"$3\" = -- ] || exit 9\n"
                                                 "read -r greeting; echo 'denhartog-conform 1 plain Odd'\n"
                                                 "while read -r id rest; do echo \"$id skip\"; done\n");
    const Run r = run("", program + " '[1,2]' --jobs --");
    INFO(r.output << r.error);
    CHECK(contains(r.output, "Odd (plain): 6 questions"));
}

TEST_CASE("smoke looks at the protocol and at no number", "[conformance][program]") {
    const std::string right = script("smoke.sh", "read -r greeting; echo 'denhartog-conform 1 plain Smoke'\n"
                                                 "while read -r id q rest; do case $id in\n"
                                                 "smoke-H-j|smoke-amplitude) echo \"$id value 17\";;\n"
                                                 "smoke-rejected) echo \"$id reject negative mass\";;\n"
                                                 "*) echo \"$id skip\";; esac; done\n");
    const Run good = conform("smoke -- " + right);
    INFO(good.output << good.error);
    CHECK(good.status == 0);
    CHECK(contains(good.output, "The protocol is kept. No number was checked."));
    CHECK(lines_of(good.output).size() == 1 + 25 + 3 + 2);
    const std::string lax = script("lax-smoke.sh", "read -r greeting; echo 'denhartog-conform 1 plain Smoke'\n"
                                                   "while read -r id q rest; do case $id in\n"
                                                   "smoke-rejected) echo \"$id value 17\";; *) echo \"$id skip\";; esac; done\n");
    const Run answered = conform("smoke -- " + lax);
    CHECK(answered.status == 1);
    CHECK(contains(answered.output, "The protocol is kept, but a question that breaks a rule was answered."));
    const std::string wrong = script("no-smoke.sh", "read -r greeting; echo 'denhartog-conform 1 plain Smoke'\n"
                                                    "while read -r id q rest; do echo \"$id value 1 2 3\"; done; exit 4\n");
    const Run bad = conform("smoke -- " + wrong);
    CHECK(bad.status == 1);
    CHECK(contains(bad.output, "must be as many numbers as the protocol has, 1, but is 3"));
    CHECK(contains(bad.output, "must be rejected"));
    CHECK(contains(bad.output, "must be skipped"));
    CHECK(contains(bad.output, "it ended with status 4"));
    CHECK(conform("smoke -- /no/such/program").status == 3);
}
