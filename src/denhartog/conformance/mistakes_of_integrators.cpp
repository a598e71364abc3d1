#include "denhartog/conformance/mistake_definition.hpp"
#include "denhartog/conformance/plain_integration.hpp"
#include "denhartog/errors.hpp"

namespace denhartog::conformance {
namespace {

bool of_motion(const Question& q) { return asks_for(q, {"amplitude", "phase", "motion_under_force"}); }

MistakeDefinition transient() {
    return {{"transient", "", false,
             "The motion is read off before the transient has decayed: the answer is that after a few periods from rest.",
             "how many periods are integrated; go on until two periods in a row agree"},
            [](const Question& q) {
                std::vector<Value> all;
                if (!of_motion(q)) return all;
                for (const int periods : {1, 2, 3, 5, 10, 20, 30, 50, 100})
                    if (const std::optional<Value> value = answer_of_transient(q, periods)) all.push_back(*value);
                return all;
            }};
}

MistakeDefinition few_harmonics() {
    return {{"few-harmonics", "", false, "Friction is cut off after a few harmonics: 1, 3, 5, 7 or 9.",
             "the number of harmonics; a square wave has all odd ones, falling like one over their order"},
            [](const Question& q) {
                std::vector<Value> all;
                if (!of_motion(q) && !asks_for(q, {"displacement", "initial_displacement", "initial_velocity"})) return all;
                for (const int highest : {1, 3, 5, 7, 9}) {
                    Choices c;
                    c.harmonics = highest;
                    if (const std::optional<Value> value = plain_answer(q, c)) all.push_back(*value);
                }
                return all;
            }};
}

MistakeDefinition closed_form_beyond() {
    return {{"sliding-beyond-the-boundary", "69", false, "The closed form is used where the contact stops: (69) is not asked.",
             "whether beta < beta_lim is tested before (38) is used"},
            [](const Question& q) {
                if (!of_motion(q) && !asks_for(q, {"regime", "stops_per_period", "stop_durations"})) return std::vector<Value>{};
                Choices c;
                c.beyond_the_boundary = true;
                return listed(plain_answer(q, c));
            }};
}

} // namespace

std::vector<MistakeDefinition> mistakes_of_integrators() { return {transient(), few_harmonics(), closed_form_beyond()}; }

} // namespace denhartog::conformance
