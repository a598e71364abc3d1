// Tasks in processes: nothing is lost, whatever their number and however they end.
#include "derivation/claims/workers.hpp"

#include <csignal>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "derivation/claims/run.hpp"
#include "tests/catch.hpp"

using namespace denhartog::derivation;

namespace {

std::vector<Delivery> deliveries(std::size_t count, std::size_t workers, const std::function<std::string(std::size_t)>& task) {
    std::vector<Delivery> all(count);
    std::vector<int> times(count);
    in_processes(count, workers, task, [&](std::size_t i, const Delivery& delivery) {
        all[i] = delivery;
        ++times[i];
    });
    CHECK(times == std::vector<int>(count, 1));
    return all;
}

Claim needed(const std::string& id, const std::function<Outcome()>& check) {
    return {.id = id, .equations = {"1"}, .role = Role::step, .title = id, .check = check};
}

} // namespace

TEST_CASE("every task delivers its own text, for any number of workers") {
    const auto task = [](std::size_t i) { return std::string(i * 50000, static_cast<char>('a' + i)); };
    for (const std::size_t workers : {1u, 2u, 7u, 30u}) {
        const std::vector<Delivery> all = deliveries(12, workers, task);
        for (std::size_t i = 0; i < all.size(); ++i) {
            CHECK(all[i].text == task(i));
            CHECK(all[i].fault.empty());
        }
    }
}

TEST_CASE("a task that throws or dies is at fault, and no other") {
    const auto task = [](std::size_t i) -> std::string {
        if (i == 1) throw std::runtime_error("no such root");
        if (i == 2) std::raise(SIGKILL);
        if (i == 3) std::_Exit(7);
        return "done";
    };
    const std::vector<Delivery> all = deliveries(5, 2, task);
    CHECK(all[1].fault == "no such root");
    CHECK(all[2].fault.find("Killed") != std::string::npos);
    CHECK(all[3].fault == "its process ended with status 7");
    for (const std::size_t i : {0u, 4u}) {
        CHECK(all[i].text == "done");
        CHECK(all[i].fault.empty());
    }
}

TEST_CASE("a claim whose worker is killed is unknown and makes the run fail") {
    const auto proved = [] {
        ++altered_statements_refuted();
        return Outcome{Verdict::proved, {}, {}};
    };
    const auto killed = [] {
        std::raise(SIGKILL);
        return Outcome{Verdict::proved, {}, {}};
    };
    const std::vector<Claim> claims{needed("first", proved), needed("second", killed), needed("third", proved)};
    std::ostringstream lines;
    const Run run = run_of(claims, findings_of(claims, {}, 2, lines));
    REQUIRE(run.claims.size() == 3);
    CHECK(run.claims[0].verdict == "proved");
    CHECK(run.claims[1].verdict == "unknown");
    CHECK(run.claims[2].verdict == "proved");
    REQUIRE(run.faults.size() == 2);
    CHECK(run.faults[0].find("claim second was not decided: its process was ended by a signal") == 0);
    CHECK(run.faults[1] == "claim second is needed and unknown");
    CHECK(lines.str().find("second: its process was ended") != std::string::npos);
}

TEST_CASE("a claim that is proved without a twin, and without a reason why it has none, makes the run fail") {
    const std::vector<Claim> claims{needed("bare", [] { return Outcome{Verdict::proved, {}, {}}; })};
    std::ostringstream lines;
    const Run run = run_of(claims, findings_of(claims, {}, 1, lines));
    REQUIRE(run.faults.size() == 1);
    CHECK(run.faults[0] == "claim bare is proved and has neither a mutated twin nor a reason why not");
}

TEST_CASE("what is known already is not decided again") {
    const std::vector<Claim> claims{needed("first", [] { return Outcome{Verdict::proved, {}, {}}; })};
    std::ostringstream none, line;
    const Findings found = findings_of(claims, {}, 1, line);
    CHECK(findings_of({needed("first", []() -> Outcome { throw std::logic_error("asked again"); })}, found, 1, none) == found);
    CHECK(none.str().empty());
}
