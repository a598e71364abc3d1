// Errors of the mode functions against a reference in up to 1100 digits; the full survey is `speed-accuracy mode-functions`.
#include "tests/speed_accuracy/mode_functions_survey.hpp"

#include "denhartog/evaluation/mode_arrays.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/accuracy_record.hpp"

using namespace denhartog::tests;

namespace {

void check(const std::string& what, const std::vector<ZoneErrors>& zones) {
    std::printf("%s", markdown(table_of(what, zones)).c_str());
    const Worst worst = worst_of(zones, &FunctionErrors::by_both), light = worst_of(zones, &FunctionErrors::light);
    INFO(what << ": " << worst.error << " at " << worst.where << "; R exact: " << light.error << " at " << light.where);
    CHECK(worst.error <= most_allowed);
    CHECK(light.error <= most_allowed_with_exact_R);
    CHECK(light.error > 0.25); // the rounding of a result alone leaves half a unit: the survey would not see
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
    CHECK(keep_record("mode functions " + what, accuracy_record(what.starts_with("in ") ? what.substr(3) : what, zones)));
}

} // namespace

TEST_CASE("v, u and g keep their digits in double from subnormal damping to the last number below 1 and R from 1e-300 to 1e300",
          "[eq:23][eq:28][eq:29][accuracy][form]") {
    check("in double", survey_mode_functions(Precision::in_double, 10000));
}

TEST_CASE("v, u and g keep their digits in float from R = 1e-30 to 1e30", "[eq:23][eq:28][eq:29][accuracy][form]") {
    check("in float", survey_mode_functions(Precision::in_float, 4000));
}

TEST_CASE("v, u and g keep their digits in long double", "[eq:23][eq:28][eq:29][accuracy][form]") {
    check("in long double", survey_mode_functions(Precision::in_long_double, 2000));
}

TEST_CASE("v, u and g keep their digits in 50 digits", "[eq:23][eq:28][eq:29][accuracy][form]") {
    check("in 50 digits", survey_mode_functions(Precision::in_50_digits, 500));
}

TEST_CASE("over arrays v, u and g keep the digits of the scalar forms at the same points",
          "[eq:23][eq:28][eq:29][accuracy][form]") {
    const long before = denhartog::evaluation::array_mode_evaluations();
    const long left = denhartog::evaluation::array_modes_left_to_scalar_forms();
    check("in double over arrays", survey_array_mode_functions(10000));
    const double evaluated = static_cast<double>(denhartog::evaluation::array_mode_evaluations() - before);
    const double scalar = static_cast<double>(denhartog::evaluation::array_modes_left_to_scalar_forms() - left);
    INFO(scalar << " of " << evaluated
                << " left to the scalar forms: two zones go to R = 1e-300 and 1e300, one to subnormal zeta");
    CHECK(scalar < 0.5 * evaluated);
}
