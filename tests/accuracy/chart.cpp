// The chart of speed against accuracy on a small sample: digits, failures by name, counters. Its times are measured, not tested.
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "denhartog/solve/solve.hpp"
#include "tests/speed_accuracy/chart_survey.hpp"
#include "tests/speed_accuracy/peers/peers.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

constexpr double budget = 20;
constexpr std::size_t scenes_of_few_masses = 4;

// Truth in 40 digits takes a second a point at N = 50: the sample does without.
const std::vector<ChartGround>& sample() {
    static const std::vector<ChartGround> grounds = [] {
        std::vector<ChartGround> all;
        const std::vector<ChartScene> scenes = chart_scenes(29, 2);
        for (std::size_t s = 0; s < scenes_of_few_masses; ++s) all.push_back(ground_of(scenes[s]));
        return all;
    }();
    return grounds;
}

std::string text(const ChartRow& row) {
    std::ostringstream out;
    out << row.scene << ", " << row.method << ", " << row.setting << ": right at " << row.right << " of " << row.points
        << ", worst error " << std::hexfloat << row.worst;
    return out.str();
}

/// A method that gives the truth, changed.
Peer changed_truth(const ChartGround& ground, const std::function<void(PeerAnswer&)>& change) {
    return {"changed truth", "test", 0, [=](const System<double>&) {
                return [=](const ChartPoint& point) {
                    const auto at = std::ranges::find_if(
                        ground.scene.points, [&](const ChartPoint& p) { return p.r == point.r && p.beta == point.beta; });
                    PeerAnswer answer = ground.truth[static_cast<std::size_t>(at - ground.scene.points.begin())].answer;
                    change(answer);
                    return answer;
                };
            }};
}

std::size_t columns(const std::string& line) {
    bool quoted = false;
    std::size_t count = 1;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        if (c == ',' && !quoted) ++count;
    }
    return count;
}

Work work_of_solve(const ChartScene& scene, int digits) {
    const Question question = question_of_chart(scene.system, digits);
    const long before = eigen_solves();
    const PreparedSystem prepared = prepare(scene_source(Scene<double>{scene.system, 1, {}, {}, {}, {}}), question);
    Work sum{eigen_solves() - before, 0, 0};
    for (const ChartPoint& point : scene.points) {
        const Work work = solve(prepared, point.r, point.beta, question).work;
        sum.eigen_solves += work.eigen_solves;
        sum.mode_evaluations += work.mode_evaluations;
        sum.phases_propagated += work.phases_propagated;
    }
    return sum;
}

} // namespace

TEST_CASE("the chart's sample has points of every regime", "[chart]") {
    std::array<int, 3> seen{};
    for (const ChartGround& ground : sample())
        for (const ChartTruth& truth : ground.truth) ++seen[static_cast<std::size_t>(truth.regime)];
    for (const Regime regime : {Regime::continuous, Regime::stick_slip, Regime::permanent_sticking}) {
        INFO(name(regime));
        CHECK(seen[static_cast<std::size_t>(regime)] > 0);
    }
}

TEST_CASE("`solve` has on the chart the digits that it is asked for, in the right regime everywhere", "[chart][eq:38]") {
    for (const ChartGround& ground : sample())
        for (const Peer& peer : solve_peers()) {
            const ChartRow row = measure(peer, ground, budget);
            INFO(text(row));
            CHECK(right_everywhere(row));
            const double of_decimals =
                row.asked < 1e-15 ? 5 * row.asked : 0; // half a unit of the last one, where they are decimals
            CHECK(row.worst <= row.asked + of_decimals);
        }
}

TEST_CASE("the exact solver and the closed form have on the chart the digits of their number type", "[chart][eq:38]") {
    for (const ChartGround& ground : sample()) {
        const double condition = 1 + ground.condition_worst;
        const ChartRow exact = measure(exact_solver_peer(), ground, budget);
        INFO(text(exact));
        CHECK(right_everywhere(exact));
        CHECK(exact.worst <= 64 * condition * 0x1p-52);
        for (const Peer& peer : shipped_form_peers()) {
            const ChartRow row = measure(peer, ground, budget);
            const double eps = peer.setting == "float"         ? 0x1p-23
                               : peer.setting == "double"      ? 0x1p-52
                               : peer.setting == "long double" ? 0x1p-63
                                                               : 1e-38;
            INFO(text(row));
            CHECK(row.worst <= std::max(64 * condition * eps, 1e-36));
            const auto sliding = std::ranges::count(ground.truth, Regime::continuous, &ChartTruth::regime);
            CHECK(row.right == sliding);
            const bool has_boundaries = peer.setting == "double" || peer.setting == "50 digits";
            CHECK(row.failures[4] == (has_boundaries ? row.points - sliding : 0));
        }
    }
}

TEST_CASE("the printed form in 50 digits and the truth by `solve` are one", "[chart][eq:38]") {
    for (const std::size_t s : {std::size_t{0}, std::size_t{3}}) {
        const ChartRow row = measure(printed_form_peers().back(), sample()[s], budget);
        INFO(text(row));
        CHECK(right_everywhere(row));
        CHECK(row.worst <= 1e-36);
    }
}

TEST_CASE("the paper's algorithm gains digits on the chart as its tolerance falls", "[chart][eq:6]") {
    for (const ChartGround& ground : sample()) {
        double before = 1;
        for (const Peer& peer : paper_algorithm_peers()) {
            if (peer.method.find("200") != std::string::npos || (peer.asked != 1e-3 && peer.asked != 1e-6 && peer.asked != 1e-9))
                continue;
            const ChartRow row = measure(peer, ground, budget);
            INFO(text(row));
            CHECK(right_everywhere(row));
            CHECK(row.worst <= before / 10);
            before = row.worst;
        }
    }
}

TEST_CASE("`solve` never works more on the chart for fewer digits", "[chart][solve]") {
    const std::vector<ChartScene> scenes = chart_scenes(29, 2);
    for (std::size_t s = 0; s < scenes.size(); ++s) {
        const Work little = work_of_solve(scenes[s], 2), much = work_of_solve(scenes[s], 10);
        INFO(scenes[s].name);
        CHECK(little.mode_evaluations <= much.mode_evaluations);
        CHECK(little.eigen_solves <= much.eigen_solves);
        CHECK(little.phases_propagated <= much.phases_propagated);
    }
}

TEST_CASE("the chart sees an amplitude that is wrong in the seventh digit, and calls failures by their names", "[chart]") {
    const ChartGround& ground = sample()[0];
    const auto measured = [&](const std::function<void(PeerAnswer&)>& change) {
        return measure(changed_truth(ground, change), ground, budget);
    };
    CHECK(measured([](PeerAnswer&) {}).worst <= 1e-36);
    const ChartRow wrong = measured([](PeerAnswer& a) { a.amplitude *= 1 + 1e-7; });
    CHECK(std::abs(wrong.worst / 1e-7 - 1) < 1e-6);
    CHECK(right_everywhere(wrong));
    const auto fails_as = [&](std::size_t kind, const std::function<void(PeerAnswer&)>& change) {
        const ChartRow row = measured(change);
        INFO(failure_names()[kind]);
        CHECK(row.failures[kind] == row.points);
        CHECK(row.right == 0);
        CHECK_FALSE(right_everywhere(row));
    };
    fails_as(0, [](PeerAnswer& a) { a.ending = Ending::did_not_finish; });
    fails_as(0, [](PeerAnswer&) { throw PrecisionError("out of reach"); });
    fails_as(1, [](PeerAnswer& a) { a.ending = Ending::stalled; });
    fails_as(2, [](PeerAnswer& a) { a.sticks = !a.sticks; });
    fails_as(3, [](PeerAnswer& a) { a.ending = Ending::not_a_number; });
    fails_as(3, [](PeerAnswer& a) { a.amplitude = NAN; });
    fails_as(4, [](PeerAnswer&) { throw DomainError("a pole"); });
    const ChartRow late = measure(changed_truth(ground, [](PeerAnswer&) {}), ground, 0);
    CHECK(late.failures[0] == late.points);
}

TEST_CASE("a method that is not there is skipped by name, and every line of the CSV has all its columns", "[chart]") {
    const ChartGround& ground = sample()[0];
    const Peer absent{"absent method", "not installed: some-package", 0, {}};
    std::vector<ChartRow> rows{measure(absent, ground, budget), measure(solve_peers()[0], ground, budget)};
    CHECK_FALSE(rows[0].present);
    const ChartRun run{29, "a, \"quoted\" version", "compiler", "processor"};
    for (const std::string& file : {csv(rows, run), csv({ground}, run)}) {
        std::istringstream lines(file);
        std::string head, line;
        std::getline(lines, head);
        int count = 0;
        for (; std::getline(lines, line); ++count) {
            INFO(line);
            CHECK(columns(line) == columns(head));
        }
        CHECK(count == 2);
    }
    CHECK(csv(rows, run).find("\"absent method\",\"not installed: some-package\",0,no") != std::string::npos);
    CHECK(markdown(failure_table(rows)).find("| absent method | not installed: some-package | 0 of 2 | skipped |") !=
          std::string::npos);
    CHECK(fastest(rows, ground.scene.name, 2, false, [](const ChartRow&) { return true; }) == &rows[1]);
    CHECK(fastest(rows, ground.scene.name, 40, false, [](const ChartRow&) { return true; }) == nullptr);
}
