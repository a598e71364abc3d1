// The bounds of rounding errors against 50 digits; the full survey is `speed-accuracy bounds`.
#include "tests/speed_accuracy/bounds_survey.hpp"

#include "tests/catch.hpp"

using namespace denhartog::tests;

TEST_CASE("every bound of V, U, G, H, S, beta_lim, X_j, phi_j, x_k and its velocity holds on seeded scenes and none is silly",
          "[eq:33][eq:34][eq:35][eq:38][eq:39][eq:41][eq:56][eq:64][eq:69][accuracy]") {
    const BoundsSurvey survey = survey_bounds(10000, 1);
    for (const Table& table : tables_of(survey)) std::fputs(markdown(table).c_str(), stdout);
    CHECK(survey.quantities.size() == 11);
    for (const auto& [name, of] : survey.quantities) {
        INFO(name << ", " << of.most_used << " of the bound used at " << of.worst);
        CHECK(of.violations == 0);
        CHECK(of.over_estimate(0.5) <
              (name[0] == 'x' ? 40 : 30)); // a displacement sums the terms of all modes, each with its bound
        CHECK(of.count > 1000);
        CHECK(of.most_used > 0.05);
    }
    CHECK(survey.wrong_regimes == 0);
    CHECK(survey.regimes > 2000);
    CHECK(survey.open_regimes > 0);
    CHECK(survey.full_searches > 10);
    CHECK(survey.steps.at(12) > 0);
    CHECK(survey.steps.at(6) < survey.steps.at(12));
}

TEST_CASE("a bound that is too small is caught by the survey", "[accuracy]") {
    const BoundsSurvey tenth = survey_bounds(500, 1, 0.1);
    for (const auto& [name, of] : tenth.quantities) {
        INFO(name << ", " << of.most_used << " of a tenth of the bound used");
        CHECK(of.violations > 0);
    }
}
