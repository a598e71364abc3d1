// The division of a study into chunks, and its rules.
#include "denhartog/sweep/plan.hpp"

#include <set>

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"

using namespace denhartog;
using namespace denhartog::sweep;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

json study_json() {
    return json::parse(
        R"({"scene": {"mass_ratios": [1, 2], "stiffness_ratios": [1, 0.5], "damping_ratios": [0.03, 0.06],
                   "contact": 2, "load": 1},
        "axes": [{"quantity": "beta", "from": 0, "to": 2, "count": 7},
                 {"quantity": "zeta", "entry": 2, "values": [0.01, 0.02, 0.05]},
                 {"quantity": "r", "from": 0.1, "to": 2, "count": 11, "scale": "logarithmic"}],
        "samples": {"method": "sobol", "count": 5, "seed": 1,
                    "variables": [{"quantity": "mu", "uniform": {"from": 1, "to": 1.5}}]},
        "points_of_a_chunk": 30})");
}

std::string fault_of(const json& study) {
    try {
        static_cast<void>(plan_of(read_study(study.dump())));
    } catch (const InputError& e) {
        return e.what();
    }
    return "none";
}

} // namespace

TEST_CASE("chunks have every point once, and no column of friction is split", "[sweep]") {
    for (const std::size_t most : {1, 7, 30, 100, 400, 10000}) {
        json study = study_json();
        study["points_of_a_chunk"] = most;
        const Plan plan = plan_of(read_study(study.dump()));
        CHECK(plan.points == 3 * 5 * 11 * 7);
        std::set<std::size_t> seen;
        for (std::size_t K = 0; K < plan.chunks; ++K) {
            const Box box = plan.box(K);
            CHECK(box.count.back() == 7);
            CHECK(box.points() <= std::max<std::size_t>(most, 7));
            for (std::size_t n = 0; n < box.points(); ++n) {
                std::size_t rest = n, index = 0, step = 1;
                for (std::size_t d = box.count.size(); d-- > 0;) {
                    index += (box.start[d] + rest % box.count[d]) * step;
                    step *= plan.dimensions[d].size;
                    rest /= box.count[d];
                }
                CHECK(seen.insert(index).second);
            }
        }
        CHECK(seen.size() == plan.points);
    }
}

TEST_CASE("an axis of exact quantiles is not split, one of a histogram is", "[sweep]") {
    json study = study_json();
    study["reduce"] = {
        {{"name", "band"}, {"statistic", "quantiles"}, {"of", "amplitude_2"}, {"over", {"sample"}}, {"probabilities", {0.5}}}};
    study["points_of_a_chunk"] = 1;
    Plan plan = plan_of(read_study(study.dump()));
    CHECK_FALSE(plan.splits(plan.place_of("sample")));
    study["reduce"][0]["bins"] = {{"from", 0}, {"to", 1}, {"count", 10}};
    plan = plan_of(read_study(study.dump()));
    CHECK(plan.splits(plan.place_of("sample")));
}

TEST_CASE("a key that a study has not is told the nearest", "[sweep]") {
    json study = study_json();
    study["sampels"] = study["samples"];
    CHECK_THAT(fault_of(study), Contains("sampels") && Contains("did you mean samples?"));
    study = study_json();
    study["axes"][0]["counts"] = 3;
    CHECK_THAT(fault_of(study), Contains("did you mean count?") && Contains("/axes/0/counts"));
    study = study_json();
    study["scene"]["mass_ratio"] = 3;
    CHECK_THAT(fault_of(study), Contains("did you mean mass_ratios?"));
    study = study_json();
    study["reduce"] = {{{"name", "band"}, {"statistic", "maximum"}, {"of", "amplitud_2"}, {"over", {"sample"}}}};
    CHECK_THAT(fault_of(study), Contains("did you mean amplitude_2?"));
    study["reduce"][0]["of"] = "amplitude_2";
    study["reduce"][0]["over"] = {"sampel"};
    CHECK_THAT(fault_of(study), Contains("did you mean sample?"));
}

TEST_CASE("a study that breaks a rule is refused with quantity, rule and value", "[sweep]") {
    CHECK(fault_of(study_json()) == "none");
    const auto with = [](const char* pointer, const json& value) {
        json study = study_json();
        study[json::json_pointer(pointer)] = value;
        return fault_of(study);
    };
    CHECK_THAT(with("/axes/0/from", -1), Contains("beta"));
    CHECK_THAT(with("/axes/2/from", 0), Contains("must be positive where the scale is logarithmic"));
    CHECK_THAT(with("/axes/2/quantity", "beta"), Contains("must not vary twice"));
    CHECK_THAT(with("/axes/2/quantity", "mu"), Contains("mu"));
    CHECK_THAT(with("/axes/1/values/1", -0.02), Contains("damping_ratios"));
    CHECK_THAT(with("/axes/1/entry", 3), Contains("must be one of 2 entries"));
    CHECK_THAT(with("/samples/variables/0/uniform/to", 1), Contains("must be above from"));
    CHECK_THAT(with("/samples/method", "halton"), Contains("must be one of sobol, latin_hypercube"));
    CHECK_THAT(with("/masses", {3}), Contains("from 1 to 2"));
    CHECK_THAT(with("/axes/0/quantity", "frequency_hz"), Contains("must not be given together"));
    json study = study_json();
    study["axes"].erase(2);
    CHECK_THAT(fault_of(study), Contains("r") && Contains("must be an axis or a variable"));
    study["samples"]["variables"].push_back({{"quantity", "r"}, {"uniform", {{"from", 0.5}, {"to", 1.5}}}});
    CHECK(fault_of(study) == "none");
    study["samples"]["variables"].push_back({{"quantity", "beta"}, {"uniform", {{"from", 0.5}, {"to", 1.5}}}});
    CHECK_THAT(fault_of(study), Contains("beta must not vary twice"));
    study["samples"]["variables"].back()["as"] = "factor";
    CHECK(fault_of(study) == "none");
}
