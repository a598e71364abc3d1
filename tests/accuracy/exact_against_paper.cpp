// The exact solver against the paper's algorithm at tolerance 1e-12 in stick-slip, and against the proved motion.
//
// Two comparisons, neither of which needs a motion to be steady. From rest both follow the same motion over ten periods. On the
// periodic orbit that the exact solver found, the paper's algorithm must stay. An amplitude can be tiny where the contact
// nearly rests for ever; as tolerances are, its error is gated over 1 plus the amplitude.
#include "tests/speed_accuracy/stick_slip_survey.hpp"

#include "tests/catch.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

void print(const std::string& what, const StickSlipSurvey& s) {
    std::printf("%s: %d amplitudes within %.1e, over 1 + X %.1e; %d stops, at most %d a period, times within %.1e; states %.1e\n",
                what.c_str(), s.amplitude.count, s.amplitude.error, s.mixed.error, s.stops, s.most_stops, s.event.error,
                s.state.error);
}

std::string list(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

} // namespace

TEST_CASE("in stick-slip the exact solver and the paper's algorithm at 1e-12 go through the same motion from rest",
          "[eq:6][eq:74][eq:75][exact-solver][paper-algorithm]") {
    const std::vector<StickSlipScene> scenes = stick_slip_scenes(200, 21);
    const StickSlipSurvey loose = from_rest(scenes, 10, 1e-10), tight = from_rest(scenes, 10, 1e-12);
    print("from rest, 1e-10", loose);
    print("from rest, 1e-12", tight);
    INFO(list(tight.differently) << tight.mixed.where << "\n" << tight.event.where);
    CHECK(tight.differently.empty());
    CHECK(tight.stops >= 300);
    CHECK(tight.most_stops >= 6);
    CHECK(tight.mixed.error <= 1e-9);
    CHECK(tight.event.error <= 1e-8);
    // What is left is the tolerance: a hundred times smaller, it leaves at least thirty times less.
    CHECK(tight.mixed.error <= loose.mixed.error / 30);
    CHECK(tight.event.error <= loose.event.error / 30);
}

TEST_CASE("in stick-slip the paper's algorithm at 1e-12 stays on the orbits of the exact solver",
          "[eq:6][eq:74][eq:75][exact-solver][paper-algorithm]") {
    const std::vector<StickSlipScene> scenes = stick_slip_scenes(200, 22);
    const StickSlipSurvey loose = on_orbits(scenes, 1e-10), tight = on_orbits(scenes, 1e-12);
    print("on orbits, 1e-10", loose);
    print("on orbits, 1e-12", tight);
    INFO(list(tight.differently) << tight.mixed.where << "\n" << tight.event.where);
    CHECK(tight.differently.empty());
    CHECK(tight.stops >= 300);
    CHECK(tight.mixed.error <= 1e-10);
    CHECK(tight.event.error <= 1e-8);
    CHECK(tight.mixed.error <= loose.mixed.error / 30);
    CHECK(tight.event.error <= loose.event.error / 30);
}

TEST_CASE("in stick-slip the exact solver in double agrees with the proved motion, within its error bound",
          "[exact-solver][error_bound]") {
    const StickSlipSurvey survey = against_proved(stick_slip_scenes(60, 23));
    print("against 50 digits", survey);
    std::printf("  error over error bound: %.2g\n", survey.over_bound.error);
    INFO(list(survey.differently) << survey.amplitude.where << "\n" << survey.over_bound.where);
    CHECK(survey.differently.empty());
    CHECK(survey.mixed.error <= 1e-13);
    CHECK(survey.event.error <= 1e-11);
    CHECK(survey.over_bound.error <= 1);
}
