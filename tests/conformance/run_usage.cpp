// Which vectors, answers in files, and what is refused.
#include "tests/catch.hpp"
#include "tests/conformance/runner_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;

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
