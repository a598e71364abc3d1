// Regimes of seeded points by the boundary formulas and by the exact solver; the full survey is `speed-accuracy regimes`.
#include "tests/speed_accuracy/regime_survey.hpp"

#include "tests/catch.hpp"

using namespace denhartog::tests;

TEST_CASE("boundary formulas and exact solver agree on the regime, and every disagreement is explained by a further motion",
          "[eq:54][eq:69][regime][exact-solver]") {
    const RegimeSurvey survey = survey_regimes(600, 6, 200, 7);
    std::printf("%s", markdown(table_of(survey)).c_str());
    std::string unexplained;
    for (const std::string& at : survey.unexplained) unexplained += at + "\n";
    INFO(unexplained);
    CHECK(survey.points == 600);
    CHECK(survey.unexplained.empty());
    for (const char* regime : {"continuous", "stick_slip", "permanent_sticking"}) CHECK(survey.regimes.at(regime) >= 50);
    const auto count = [&](bool unique, Comparison c) {
        const auto found = survey.count.find({unique, c});
        return found == survey.count.end() ? 0 : found->second;
    };
    // Where the steady velocities are unique there is nothing to explain.
    CHECK(count(true, Comparison::agree) >= 200);
    CHECK(count(true, Comparison::several_motions) == 0);
    CHECK(count(true, Comparison::never_settles) == 0);
    CHECK(count(false, Comparison::several_motions) > 0);
}
