// Reductions against their definitions, and chunks put together against the whole.
#include "denhartog/sweep/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/catch.hpp"

using namespace denhartog::sweep;
using nlohmann::json;

namespace {

// Axes zeta (2), sample (60), r (3), beta (2).
Plan plan_with(const json& reduction, std::size_t points_of_a_chunk) {
    json study =
        json::parse(R"({"scene": {"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0.03, "contact": 1, "load": 1},
        "axes": [{"quantity": "zeta", "values": [0.1, 0.2]},
                 {"quantity": "r", "values": [0.5, 1, 2]}, {"quantity": "beta", "values": [0, 1]}],
        "samples": {"method": "latin_hypercube", "count": 60, "seed": 1,
                    "variables": [{"quantity": "mu", "uniform": {"from": 1, "to": 2}}]}})");
    study["reduce"] = {reduction};
    study["points_of_a_chunk"] = points_of_a_chunk;
    return plan_of(read_study(study.dump()));
}

double value_at(std::size_t zeta, std::size_t sample, std::size_t r, std::size_t beta) {
    std::mt19937 random(static_cast<unsigned>(((zeta * 60 + sample) * 3 + r) * 2 + beta));
    if (random() % 11 == 0) return std::nan("");
    return static_cast<double>(random() % 4);
}

Field field_of(const Plan& plan, const Box& box) {
    Field field{plan.dimensions_of(""), {}};
    for (std::size_t a = 0; a < box.count[0]; ++a)
        for (std::size_t b = 0; b < box.count[1]; ++b)
            for (std::size_t c = 0; c < box.count[2]; ++c)
                for (std::size_t d = 0; d < box.count[3]; ++d)
                    field.values.push_back(value_at(box.start[0] + a, box.start[1] + b, box.start[2] + c, box.start[3] + d));
    return field;
}

// The results for the one cell of a reduction over everything, chunks in a given order.
std::vector<Reduced> over_all(json reduction, std::size_t points_of_a_chunk, bool backwards) {
    reduction["over"] = {"zeta", "sample", "r", "beta"};
    const Plan plan = plan_with(reduction, points_of_a_chunk);
    const Reduction& r = plan.study.reductions[0];
    std::optional<Partial> all;
    for (std::size_t n = 0; n < plan.chunks; ++n) {
        const std::size_t K = backwards ? plan.chunks - 1 - n : n;
        const Partial part =
            from_bytes(plan, r, plan.box(K), to_bytes(reduced(plan, r, plan.box(K), field_of(plan, plan.box(K)))));
        if (all)
            put_together(r, *all, part);
        else
            all = part;
    }
    return finished(plan, r, *all);
}

std::vector<double> all_values() {
    std::vector<double> all;
    for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t b = 0; b < 60; ++b)
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t d = 0; d < 2; ++d) all.push_back(value_at(a, b, c, d));
    return all;
}

std::size_t count_of(const std::vector<double>& values, double x) {
    return static_cast<std::size_t>(std::ranges::count(values, x));
}

} // namespace

TEST_CASE("chunks in any number and order add up to the reduction of all points", "[sweep]") {
    const std::vector<double> all = all_values();
    const double n = static_cast<double>(all.size());
    const double none = static_cast<double>(std::ranges::count_if(all, [](double x) { return std::isnan(x); }));
    const json of{{"name", "x"}, {"of", "amplitude_1"}};
    json share{{"name", "x"}, {"statistic", "share"}}, most = of, least = of, histogram = of;
    most["statistic"] = "maximum";
    least["statistic"] = "minimum";
    histogram["statistic"] = "histogram";
    histogram["bins"] = {{"from", 1}, {"to", 2}, {"count", 2}};
    for (const std::size_t points : {2, 6, 35, 1000}) {
        for (const bool backwards : {false, true}) {
            const std::vector<Reduced> largest = over_all(most, points, backwards);
            REQUIRE(largest.size() == 5);
            CHECK(largest[0].values == std::vector<double>{3});
            // The first in the order of the grid among many that are equal.
            const std::size_t place = static_cast<std::size_t>(std::ranges::find(all, 3.0) - all.begin());
            CHECK(largest[1].values[0] == static_cast<double>(place % 2));           // beta 0 or 1
            CHECK(largest[2].values[0] == std::array{0.5, 1.0, 2.0}[place / 2 % 3]); // r
            CHECK(largest[3].values[0] == static_cast<double>(place / 6 % 60));      // sample
            CHECK(largest[3].name == "x_sample");
            CHECK(over_all(least, points, backwards)[0].values == std::vector<double>{0});
            const std::vector<std::int64_t> counts = over_all(histogram, points, backwards)[0].counts;
            const auto in = [&](double x) { return static_cast<std::int64_t>(count_of(all, x)); };
            CHECK(counts == std::vector<std::int64_t>{in(0), in(1), in(2), in(3)}); // the upper end is in the last bin
        }
    }
    // A share counts regimes: values 0 to 2, and none.
    const Plan plan = plan_with({{"name", "x"}, {"statistic", "share"}, {"over", {"zeta", "sample", "r", "beta"}}}, 1000);
    Field field = field_of(plan, plan.box(0));
    for (double& x : field.values)
        if (x == 3) x = 2;
    const std::vector<double> shares =
        finished(plan, plan.study.reductions[0], reduced(plan, plan.study.reductions[0], plan.box(0), field))[0].values;
    CHECK(shares[0] == static_cast<double>(count_of(all, 0)) / n);
    CHECK(shares[2] == static_cast<double>(count_of(all, 2) + count_of(all, 3)) / n);
    CHECK(shares[3] == none / n);
}

TEST_CASE("exact quantiles are those of the sorted values of each cell", "[sweep]") {
    const Plan plan = plan_with(
        {{"name", "x"}, {"statistic", "quantiles"}, {"of", "amplitude_1"}, {"over", {"sample"}}, {"probabilities", {0, 0.3, 1}}},
        1000);
    const Box box = plan.box(0);
    const Partial part = reduced(plan, plan.study.reductions[0], box, field_of(plan, box));
    REQUIRE(part.values.size() == 2 * 3 * 2 * 3);
    std::vector<double> sorted;
    for (std::size_t b = 0; b < 60; ++b)
        if (const double x = value_at(1, b, 2, 0); !std::isnan(x)) sorted.push_back(x);
    std::ranges::sort(sorted);
    const std::size_t cell = (1 * 3 + 2) * 2 + 0;
    CHECK(part.values[3 * cell] == sorted.front());
    CHECK(part.values[3 * cell + 2] == sorted.back());
    const double place = 0.3 * static_cast<double>(sorted.size() - 1);
    const std::size_t below = static_cast<std::size_t>(place);
    CHECK(part.values[3 * cell + 1] ==
          Approx(sorted[below] + (place - static_cast<double>(below)) * (sorted[below + 1] - sorted[below])));
}

TEST_CASE("quantiles from a histogram are within a bin of the exact ones", "[sweep]") {
    json reduction{{"name", "x"},
                   {"statistic", "quantiles"},
                   {"of", "amplitude_1"},
                   {"probabilities", {0.2, 0.5, 0.9}},
                   {"bins", {{"from", -0.5}, {"to", 3.5}, {"count", 4}}}};
    const std::vector<double> quantiles = over_all(reduction, 6, false)[0].values;
    std::vector<double> sorted = all_values();
    std::erase_if(sorted, [](double x) { return std::isnan(x); });
    std::ranges::sort(sorted);
    for (std::size_t n = 0; n < 3; ++n) {
        const double exact =
            sorted[static_cast<std::size_t>(std::array{0.2, 0.5, 0.9}[n] * static_cast<double>(sorted.size() - 1))];
        CHECK(std::abs(quantiles[n] - exact) <= 1);
    }
}
