#include "conformance/mistakes/mistake_definition.hpp"
#include "conformance/plain/closed_form.hpp"

namespace denhartog::conformance {
namespace {

constexpr double of_collocation = 1e-2;

bool of_motion(const ProtocolQuestion& q) { return asks_for(q, {"amplitude", "phase", "motion_under_force"}); }

MistakeDefinition transient() {
    constexpr int period = 10; // where the answers do not show another
    return {
        {"transient", "", false, "The motion is read off before the transient has decayed.",
         "how many periods are integrated from rest; go on until two in a row agree", of_steps_in_time},
        [](const ProtocolQuestion& q) { return of_motion(q) ? answers_of_transient(q, period, period).front() : std::nullopt; }};
}

MistakeDefinition few_harmonics(int highest) {
    const std::string number = std::to_string(highest);
    return {{"harmonics-up-to-" + number, "", false, "Friction is cut off after harmonic " + number + ".",
             "the number of harmonics; those of a square wave fall like one over their order", of_collocation},
            [highest](const ProtocolQuestion& q) {
                if (!of_motion(q) && !asks_for(q, {"displacement", "initial_displacement", "initial_velocity"}))
                    return std::optional<Value>();
                Choices c;
                c.harmonics = highest;
                return plain_answer(q, c);
            }};
}

MistakeDefinition sliding_beyond_the_boundary() {
    return {{"sliding-beyond-the-boundary", "69", false, "The closed form is used where the contact stops: (69) is not asked.",
             "whether beta < beta_lim is tested before (38) is used"},
            [](const ProtocolQuestion& q) {
                if (!of_motion(q)) return std::optional<Value>();
                Choices c;
                c.beyond_the_boundary = true;
                return plain_answer(q, c);
            }};
}

// A contact that never rests: what both laws without sticking answer to questions about stops.
std::optional<Value> without_stops(const ProtocolQuestion& q) {
    if (!asks_for(q, {"regime", "stops_per_period", "stop_durations"})) return std::nullopt;
    const std::optional<Value> right = plain_answer(q);
    if (!right || q.quantity == "stop_durations") return right ? std::optional(Value{}) : std::nullopt;
    return q.quantity == "regime" ? Value{{}, "continuous"} : Value{{0}, ""};
}

MistakeDefinition no_stiction() {
    return {{"sgn-of-0-is-0", "3", false,
             "The contact never rests: friction at rest is taken as sgn(0) = 0; (3) has any value up to mu beta there.",
             "the friction law at zero velocity: while the load is at most mu beta the contact sticks, (74)", of_steps_in_time},
            without_stops};
}

MistakeDefinition hyperbolic_tangent(std::string name, const std::string& number, double width) {
    return {
        {std::move(name), "3", false,
         "The contact creeps where it should rest: sgn is replaced by a hyperbolic tangent of the velocity d x / d tau over " +
             number + ".",
         "the friction law at zero velocity: friction that needs a velocity holds nothing", of_steps_in_time},
        [width](const ProtocolQuestion& q) { return of_motion(q) ? answer_of_creep(q, width) : without_stops(q); }};
}

} // namespace

std::vector<MistakeDefinition> mistakes_of_integrators() {
    std::vector<MistakeDefinition> all{transient(),
                                       sliding_beyond_the_boundary(),
                                       no_stiction(),
                                       hyperbolic_tangent("tanh-1e-1", "0.1", 1e-1),
                                       hyperbolic_tangent("tanh-1e-2", "0.01", 1e-2),
                                       hyperbolic_tangent("tanh-1e-3", "0.001", 1e-3),
                                       hyperbolic_tangent("tanh-1e-4", "0.0001", 1e-4)};
    for (const int highest : {1, 3, 5, 7, 9}) all.push_back(few_harmonics(highest));
    return all;
}

} // namespace denhartog::conformance
