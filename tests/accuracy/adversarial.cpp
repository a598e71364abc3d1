// Scenes from the corners of what a scene may be; the full surveys are `speed-accuracy adversarial` and `contradictions`.
#include "tests/speed_accuracy/adversarial_survey.hpp"

#include "denhartog/denhartog.hpp"
#include "tests/catch.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

void check_without_faults(const AdversarialSurvey& survey) {
    for (const auto& [what, of] : survey.faults) {
        INFO(what << ", " << of.second.text << ", at " << of.second.json);
        CHECK(of.first == 0);
    }
}

} // namespace

TEST_CASE("a scene at the end of a double's range is answered or refused by an error of the project's own", "[accuracy]") {
    for (const char* const r : {"5e-324", "1e-300", "1e300"})
        for (const char* const beta : {"0", "0.5", "1e300"}) {
            const Scene<double> at = scene(std::string(R"({"mass_ratios": [1, 1], "stiffness_ratios": [1, 1],
                "damping_ratios": [0.05, 0.05], "contact": 1, "load": 1, "r": )") +
                                           r + R"(, "beta": )" + beta + "}");
            INFO("r = " << r << ", beta = " << beta);
            try {
                (void)solve(at);
            } catch (const DomainError&) {
            } catch (const PrecisionError&) {
            }
        }
}
