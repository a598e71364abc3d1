// Errors of the free motion, of the expression of (57) and of (79), (83)-(85) against references in up to 1100 digits; the full
// survey is `speed-accuracy mode-functions`.
#include "tests/speed_accuracy/motion_survey.hpp"

#include "tests/catch.hpp"
#include "tests/speed_accuracy/accuracy_record.hpp"

using namespace denhartog::tests;

namespace {

void check(const std::string& what, Precision precision, const std::vector<FunctionInZone>& all) {
    std::printf("%s", markdown(table_of(name(precision), all)).c_str());
    const Worst worst = worst_of(all, &FunctionInZone::shipped);
    INFO(name(precision) << ": " << worst.error << " at " << worst.where);
    CHECK(worst.error <= most_allowed);
    CHECK(worst.error > 0.25); // what is rounded once is off by up to half a unit: the survey would not see
    CHECK(worst_of(all, &FunctionInZone::printed).error > 1e6); // the printed forms fail on the same points
    CHECK(keep_record(what + " in " + name(precision), accuracy_record(name(precision), all)));
}

} // namespace

TEST_CASE("d, q, their rates and the expression of (57) keep their digits in double", "[eq:A.8][eq:A.9][eq:57][accuracy][form]") {
    check("motion", Precision::in_double, survey_motion(Precision::in_double, 10000));
}

TEST_CASE("d, q, their rates and the expression of (57) keep their digits in float, long double and 50 digits",
          "[eq:A.8][eq:A.9][eq:57][accuracy][form]") {
    check("motion", Precision::in_float, survey_motion(Precision::in_float, 4000));
    check("motion", Precision::in_long_double, survey_motion(Precision::in_long_double, 1000));
    check("motion", Precision::in_50_digits, survey_motion(Precision::in_50_digits, 200));
}

TEST_CASE("the peak and its boundary at resonance keep their digits from subnormal damping up",
          "[eq:79][eq:83][eq:84][eq:85][accuracy][form]") {
    check("resonance", Precision::in_float, survey_resonance(Precision::in_float, 4000));
    check("resonance", Precision::in_double, survey_resonance(Precision::in_double, 10000));
    check("resonance", Precision::in_long_double, survey_resonance(Precision::in_long_double, 1000));
    check("resonance", Precision::in_50_digits, survey_resonance(Precision::in_50_digits, 200));
}
