// The commands that answer scenes. The first line is a command with its options, the rest the standard input. The program
// runs in this process, and does little work: its options are refused here where a user would have to wait for the answer.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "denhartog/program/program.hpp"
#include "tests/fuzz/claims.hpp"

namespace {

using namespace denhartog;

constexpr long operations = 3000;
constexpr double most_work = 64; // samples, cycles, points of a grid
constexpr std::size_t longest_report = 1520;

// Catches the text that goes to a stream during its life.
class Caught {
public:
    explicit Caught(std::ostream& stream_) : stream(stream_), before(stream_.rdbuf(text.rdbuf())) {}
    ~Caught() { stream.rdbuf(before); }
    Caught(const Caught&) = delete;
    Caught& operator=(const Caught&) = delete;
    [[nodiscard]] std::string all() const { return text.str(); }

private:
    std::ostringstream text;
    std::ostream& stream;
    std::streambuf* before;
};

// True if a word asks for no file, and each of its numbers is small enough to be answered at once or large enough to be refused.
bool is_quickly_done(std::string word) {
    if (word.find('/') != word.npos || word.starts_with("--output") || word.starts_with("--threads")) return false;
    for (char& c : word)
        if (c == ':' || c == ',' || c == '=') c = ' ';
    std::istringstream parts(word);
    for (std::string part; parts >> part;) {
        const double x = std::abs(std::strtod(part.c_str(), nullptr));
        if (x > most_work && x < 1e30) return false;
    }
    return true;
}

std::vector<std::string> words_of(std::string_view line) {
    constexpr std::size_t most = 16;
    std::istringstream stream{std::string(line)};
    std::vector<std::string> words{"denhartog"};
    for (std::string word; words.size() < most && stream >> word;) words.push_back(word);
    return words;
}

bool can_be_run(const std::vector<std::string>& words) {
    constexpr const char* commands[] = {"solve", "response", "motion", "boundary", "map", "integrate", "functions"};
    return words.size() > 1 && std::find(std::begin(commands), std::end(commands), words[1]) != std::end(commands) &&
           std::all_of(words.begin(), words.end(), is_quickly_done);
}

int run(std::vector<std::string> words, std::string input) {
    const auto chosen = [](const std::string& word) { return word.starts_with("--effort"); };
    if (std::none_of(words.begin(), words.end(), chosen)) words.push_back("--effort=" + std::to_string(operations));
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::FILE* const before = stdin;
    stdin = fmemopen(input.data(), input.size(), "r");
    const int status = program::run_program(static_cast<int>(words.size()), arguments.data(), {});
    std::fclose(stdin);
    stdin = before;
    return status;
}

void check_report(const std::string& report, int status) {
    fuzz::claim(status == 0 || status == 2 || status == 3, "the status is one that is documented", report);
    fuzz::claim(status == 0 || !report.empty(), "a fault is reported");
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);) {
        fuzz::claim(line.starts_with("denhartog: "), "a report names the program", line);
        fuzz::claim_message(line, longest_report);
    }
}

bool holds_null(const nlohmann::json& value) {
    return value.is_null() || (value.is_structured() && std::any_of(value.begin(), value.end(), holds_null));
}

// JSON is one object a line, without a number that is none: the JSON library writes null for one.
void check_output(const std::string& output, bool json) {
    for (const char c : output)
        fuzz::claim(static_cast<unsigned char>(c) >= ' ' || c == '\n', "no control character is printed", output);
    if (!json) return;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        const nlohmann::json object = nlohmann::json::parse(line, nullptr, false);
        fuzz::claim(object.is_object(), "with --json every line is an object", line);
        fuzz::claim(!holds_null(object), "every number is finite", line);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text = fuzz::text_of(data, size);
    std::vector<std::string> words = words_of(fuzz::first_line(text));
    if (text.empty() || !can_be_run(words)) return 0;
    if (words[1] == "map") words.insert(words.end(), {"--threads", "1"});
    const auto given = [&](const char* option) { return std::find(words.begin(), words.end(), option) != words.end(); };
    if (words[1] == "integrate" && !given("--cycles")) words.insert(words.end(), {"--cycles", "5"});
    if (words[1] == "motion" && !given("--samples")) words.insert(words.end(), {"--samples", "5"});
    const bool help = std::any_of(words.begin(), words.end(),
                                  [](const std::string& word) { return word.starts_with("-h") || word.starts_with("--help"); });
    const bool json = given("--json") && !help;
    int status = 0;
    std::string output, report;
    {
        const Caught out(std::cout), error(std::cerr);
        status = run(words, std::string(text));
        output = out.all();
        report = error.all();
    }
    check_report(report, status);
    check_output(output, json);
    return 0;
}
