// Errors of the mode functions against a reference in up to 1100 digits; the full survey is `speed-accuracy mode-functions`.
#include "tests/speed_accuracy/mode_functions_survey.hpp"

#include "tests/catch.hpp"

using namespace denhartog::tests;

namespace {

void check(Precision precision, int points) {
    const std::vector<ZoneErrors> zones = survey_mode_functions(precision, points);
    std::printf("%s", markdown(table_of(precision, zones)).c_str());
    const Worst worst = worst_of(zones, &FunctionErrors::by_both), light = worst_of(zones, &FunctionErrors::light);
    INFO(name(precision) << ": " << worst.error << " at " << worst.where << "; R exact: " << light.error << " at "
                         << light.where);
    CHECK(worst.error <= most_allowed(precision));
    CHECK(light.error <= most_allowed_with_exact_R(precision));
    CHECK(light.error > 1); // a dozen roundings leave more than this: the survey would not see
    double printed = 0;
    int poles = 0, unanswered = 0;
    for (const ZoneErrors& zone : zones) {
        for (const FunctionErrors& f : zone.functions) printed = std::max(printed, f.printed.error);
        poles += zone.poles;
        unanswered += zone.finite_at_poles;
    }
    CHECK(printed > 1e6); // the printed forms fail on the same points
    CHECK(poles > 0);
    CHECK(unanswered == 0);
}

} // namespace

TEST_CASE("v, u and g keep their digits in double from subnormal damping to the last number below 1 and R from 1e-300 to 1e300",
          "[eq:23][eq:28][eq:29][accuracy][form]") {
    check(Precision::in_double, 10000);
}

TEST_CASE("v, u and g keep their digits in long double", "[eq:23][eq:28][eq:29][accuracy][form]") {
    check(Precision::in_long_double, 2000);
}

TEST_CASE("v, u and g keep their digits in 50 digits", "[eq:23][eq:28][eq:29][accuracy][form]") {
    check(Precision::in_50_digits, 500);
}
