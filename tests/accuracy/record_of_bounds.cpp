// The bounds that leave with the numbers are those of the record, tests/accuracy/bounds.tsv.
//
// That the bounds hold is for the surveys, which compare numbers with the reference. A bound of rounding is far larger than the
// errors of single scenes: a bound ten times too small would still pass every comparison, and not that with the record. The
// record has a line for a scene and a question: how many bounds there are, how many of them are zero or infinite, and the sum of
// the binary logarithms of the others; or the outcome, where there is no answer. A change of the product of the bounds by 3 % is
// a difference. With DENHARTOG_WRITE_BOUNDS in the environment the record is written anew; the test then fails once.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/denhartog.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/answer_numbers.hpp"
#include "tests/support/adversarial_scenes.hpp"
#include "tests/support/named_scenes.hpp"

namespace denhartog::tests {
namespace {

std::vector<NamedNumber> all_numbers_of(const Solution& s) {
    std::vector<NamedNumber> all = numbers_of(s);
    all.push_back({"largest relative error", 0, {0, s.relative_error, {}}});
    if (s.between) all.push_back({"between", 0, s.between->amplitude});
    if (s.slides_below) all.push_back({"slides below", 0, *s.slides_below});
    if (s.kept_mode) all.push_back({"kept mode", s.kept_mode->mode, s.kept_mode->contact_at_most});
    for (const OtherMotion& other : s.motions)
        for (NamedNumber& n : numbers_of(other)) all.push_back(std::move(n));
    return all;
}

using Numbers = std::function<std::vector<NamedNumber>(const SceneSource&)>;

const std::vector<std::pair<std::string, Numbers>>& questions() {
    const auto solved = [](Asked asked, std::optional<int> digits = {}, bool all = false) {
        return [question = Question{asked, digits, all}](const SceneSource& s) { return all_numbers_of(solve(s, question)); };
    };
    static const std::vector<std::pair<std::string, Numbers>> all{
        {"regime", solved(Asked::regime)},
        {"motion", solved(Asked::motion)},
        {"12 digits", solved(Asked::motion, 12)},
        {"all motions", solved(Asked::motion, {}, true)},
        {"contact",
         [](const SceneSource& s) {
             return all_numbers_of(solve(s, {Asked::phase, {}, false, s->in_double().system.contact}));
         }},
        {"quantities", [](const SceneSource& s) {
             return numbers_of(quantities(s, std::vector{0.5, 2.0}, 6).numbers);
         }}};
    return all;
}

// The record of a question: the outcome instead where there is no answer.
std::string bounds_in_words(const Numbers& question, const SceneSource& scene) {
    Effort effort(200'000);
    try {
        long zero = 0, infinite = 0, others = 0;
        double sum = 0;
        for (const NamedNumber& n : question(with_effort(scene, &effort))) {
            const double bound = n.number.error;
            if (bound == 0) {
                ++zero;
            } else if (!std::isfinite(bound)) {
                ++infinite;
            } else {
                ++others;
                sum += std::log2(bound);
            }
        }
        char text[80];
        std::snprintf(text, sizeof text, "%ld\t%ld\t%ld\t%.2f", others, zero, infinite, sum);
        return text;
    } catch (const InputError&) {
        return "0\t0\t0\tno scene";
    } catch (const DomainError&) {
        return "0\t0\t0\tno answer";
    } catch (const PrecisionError&) {
        return "0\t0\t0\tno digits";
    }
}

// Whether two records have the same outcome, as many bounds of each kind, and nearly one product of the bounds, to 3 %.
bool are_alike(const std::string& a, const std::string& b) {
    if (a == b) return true;
    const auto is_outcome = [](const std::string& record) { return record.find("no ") != std::string::npos; };
    if (is_outcome(a) || is_outcome(b)) return false;
    const std::size_t sum_of_a = a.rfind('\t') + 1, sum_of_b = b.rfind('\t') + 1;
    return a.substr(0, sum_of_a) == b.substr(0, sum_of_b) &&
           std::abs(std::atof(a.c_str() + sum_of_a) - std::atof(b.c_str() + sum_of_b)) < 0.03;
}

// Whether a scene has a frequency and a friction ratio; free motions have none.
bool has_point(const SceneSource& scene) {
    try {
        return scene->in_double().r && scene->in_double().beta;
    } catch (const InputError&) {
        return false;
    }
}

std::vector<std::pair<std::string, SceneSource>> scenes() {
    std::vector<std::pair<std::string, SceneSource>> all;
    std::ifstream named(source_file("tests/named_scenes.jsonl"));
    for (std::string line; std::getline(named, line);) {
        const std::string name = nlohmann::json::parse(line).at("name");
        const SceneSource scene = named_source(name);
        if (has_point(scene)) all.emplace_back(name, scene);
    }
    const auto draw = [&all](const std::string& range, const AdversarialRange& from, int count) {
        AdversarialScenes drawn(2026, from);
        for (int n = 1; n <= count; ++n) {
            try {
                all.emplace_back(range + " " + std::to_string(n), scene_source(placed(drawn.next())));
            } catch (const std::runtime_error&) { // it breaks a rule of scenes, or has no boundary to stand at
            }
        }
    };
    draw("mild", mild, 60);
    draw("contrasts", contrasts, 16);
    draw("units", units, 20);
    return all;
}

} // namespace

TEST_CASE("the bounds that leave with an answer have the product that is in the record", "[accuracy][bounds]") {
    const std::string file = source_file("tests/accuracy/bounds.tsv");
    std::map<std::string, std::string> record;
    std::ifstream lines(file);
    std::string text, heading = "scene\tquestion\tbounds\tzero\tinfinite\tsum of binary logarithms";
    std::getline(lines, text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t end = line.find('\t', line.find('\t') + 1);
        record[line.substr(0, end)] = line.substr(end + 1);
    }
    std::string written = heading + "\n";
    std::size_t compared = 0;
    for (const auto& [name, scene] : scenes())
        for (const auto& [asked, question] : questions()) {
            const std::string key = name + "\t" + asked;
            const std::string now = bounds_in_words(question, scene);
            const std::string then = record[key]; // empty where the record has no such line
            written += key + "\t" + now + "\n";
            ++compared;
            INFO(key << ": " << now << ", in the record " << then);
            CHECK(are_alike(now, then));
        }
    CHECK(compared == record.size());
    if (std::getenv("DENHARTOG_WRITE_BOUNDS") != nullptr) std::ofstream(file) << written;
}

TEST_CASE("a tenth of one bound, one bound more and an answer that is none are differences to the record", "[accuracy][bounds]") {
    CHECK(are_alike("5\t3\t0\t-220.71", "5\t3\t0\t-220.72"));
    CHECK_FALSE(are_alike("5\t3\t0\t-220.71", "5\t3\t0\t-224.03")); // log2 of ten below
    CHECK_FALSE(are_alike("5\t3\t0\t-220.71", "6\t3\t0\t-220.71"));
    CHECK_FALSE(are_alike("5\t3\t0\t-220.71", "0\t0\t0\tno digits"));
    CHECK_FALSE(are_alike("0\t0\t0\tno scene", "0\t0\t0\tno digits"));
    CHECK_FALSE(are_alike("0\t0\t0\t0.00", "0\t0\t0\tno digits"));
    CHECK_FALSE(are_alike("0\t0\t0\t0.00", ""));
}

} // namespace denhartog::tests
