// Known mistakes in an answer that was computed rightly: another unit, sign or origin of a phase or displacement, (39) and (47);
// and the errors of solvers that step in time, such as a smoothed sign of the velocity or a transient that has not decayed.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "conformance/mistakes/mistake_definition.hpp"

namespace denhartog::conformance {
namespace {

using std::numbers::pi;

const Names angles_of_paper{"phase", "phase_monoharmonic"}, angles{"phase", "phase_monoharmonic", "absolute_phase"};
const Names amplitudes{"amplitude", "amplitude_monoharmonic", "absolute_amplitude", "transmissibility"};

double phase_of_contact(const ProtocolQuestion& q) {
    const Choices c{.beyond_the_boundary = true};
    return plain_phase(plain_modes(q, c), c);
}

bool slides(ProtocolQuestion q) {
    q.quantity = "regime";
    const std::optional<Value> regime = plain_answer(q);
    return regime && regime->word == "continuous";
}

// Displacement of the loaded mass under the amplitude of the load at rest, without friction, in units of P / k_1.
double static_deflection(const ProtocolQuestion& q) {
    if (!is_of_the_paper(q)) throw NoPlainAnswer();
    double sum = 0;
    for (int i = 0; i < q.load; ++i) sum += 1 / q.stiffness_ratios[static_cast<std::size_t>(i)];
    return sum;
}

// Displacement of a mass behind the mass before it, the ground before the first.
std::optional<Value> elongation(const ProtocolQuestion& q) {
    if (!asks_for(q, {"displacement", "initial_displacement", "initial_velocity", "motion_under_force"})) return std::nullopt;
    std::optional<Value> value = plain_answer(q);
    if (!value || q.mass < 2) return value;
    ProtocolQuestion before = q;
    --before.mass;
    const std::optional<Value> of_neighbour = plain_answer(before);
    if (!of_neighbour) return std::nullopt;
    for (std::size_t n = 0; n < value->numbers.size(); ++n) value->numbers[n] -= of_neighbour->numbers[n];
    return value;
}

// The response to sin(tau) is a quarter of a period late.
std::optional<Value> under_a_sine(const ProtocolQuestion& q) {
    std::optional<Value> value = plain_answer(q);
    if (!value || !asks_for(q, {"phase", "phase_monoharmonic", "absolute_phase", "motion_under_force"})) return std::nullopt;
    if (q.quantity != "motion_under_force") return Value{{wrapped_angle(value->numbers.front() + pi / 2)}, ""};
    if (q.samples % 4 != 0) return std::nullopt;
    std::rotate(value->numbers.begin(), value->numbers.end() - q.samples / 4, value->numbers.end());
    return value;
}

bool of_motion(const ProtocolQuestion& q) { return asks_for(q, {"amplitude", "phase", "motion_under_force"}); }

// A contact that never rests: what both laws without sticking answer to questions about stops.
std::optional<Value> without_stops(const ProtocolQuestion& q) {
    if (!asks_for(q, {"regime", "stops_per_period", "stop_durations"})) return std::nullopt;
    const std::optional<Value> right = plain_answer(q);
    if (!right || q.quantity == "stop_durations") return right ? std::optional(Value{}) : std::nullopt;
    return q.quantity == "regime" ? Value{{}, "continuous"} : Value{{0}, ""};
}

} // namespace

std::vector<Mistake> mistakes_of_output() {
    constexpr double of_collocation = 1e-2;
    constexpr int period = 10; // where the answers do not show another
    std::vector<Mistake> all{
        {"degrees", "39", "Angles are given in degrees; the protocol has radians.", "the unit of every phase",
         each_changed(angles, [](double x, const ProtocolQuestion&) { return x * (180 / pi); })},
        {"phase-sign", "39", "Phases are given as lead; the protocol has the lag behind the force.",
         "the sign of every phase: positive where the mass is late",
         each_changed(angles, [](double x, const ProtocolQuestion&) { return wrapped_angle(-x); })},
        {"phase-wrap", "39", "Phases are wrapped to [0, 2 pi); the protocol has (-pi, pi].",
         "the interval to which phases are wrapped",
         each_changed(angles, [](double x, const ProtocolQuestion&) { return x < 0 ? x + 2 * pi : x; })},
        {"phase-behind-contact", "47", "Phases are given behind the mass in contact; the protocol has the lag behind the force.",
         "whether phi_j is added in (47) and (53)",
         each_changed(
             angles_of_paper,
             [](double x, const ProtocolQuestion& q) { return slides(q) ? wrapped_angle(x - phase_of_contact(q)) : x; })},
        {"peak-to-peak", "38", "Amplitudes are given peak to peak; the protocol has the largest displacement.",
         "a factor of 2 in the amplitude", each_changed(amplitudes, [](double x, const ProtocolQuestion&) { return x * 2; })},
        {"amplitude-halved", "38", "Amplitudes are halved, as if the motion had been taken peak to peak before.",
         "a factor of 1/2 in the amplitude", each_changed(amplitudes, [](double x, const ProtocolQuestion&) { return x / 2; })},
        {"root-mean-square", "38", "Amplitudes are those of a harmonic motion over sqrt(2): its root mean square.",
         "how the amplitude is read off the motion",
         each_changed(amplitudes, [](double x, const ProtocolQuestion&) { return x / std::sqrt(2.0); })},
        {"static-deflection-of-loaded-mass", "5",
         "Displacements are in units of the static deflection of the loaded mass; (5) has P / k_1.",
         "the unit of displacements: the stiffness of the first spring",
         each_changed({"amplitude", "amplitude_monoharmonic", "initial_displacement", "initial_velocity", "displacement",
                       "complex_response", "motion_under_force", "rest_interval"},
                      [](double x, const ProtocolQuestion& q) { return x / static_deflection(q); })},
        {"tau-from-force",
         "46",
         "tau = 0 is taken at the maximum of the force; the closed form has it at that of the contact.",
         "the origin of tau: the force is cos(tau + phi_j)",
         reading([](ProtocolQuestion& q) {
             if (!asks_for(q, {"displacement", "initial_displacement"})) return;
             q.tau = (q.quantity == "displacement" ? q.tau : 0) - phase_of_contact(q);
             q.quantity = "displacement";
         }),
         1e-6,
         {"displacement"}},
        {"motion-from-contact", "46",
         "The motion is sampled from the maximum of the contact on; motion_under_force starts at that of the force.",
         "the origin of tau: the contact is at its maximum at tau = phi_j",
         [](const ProtocolQuestion& q) -> std::optional<Value> {
             if (q.quantity != "motion_under_force" || !slides(q)) return std::nullopt;
             ProtocolQuestion other = q;
             other.quantity = "displacement";
             return sampled(q, [&](double tau) {
                 other.tau = tau;
                 const std::optional<Value> x = plain_answer(other);
                 return x ? x->numbers.front() : std::nan("");
             });
         }},
        {"monoharmonic-taken-for-exact", "52",
         "(52) and (53) are given for amplitude and phase; (46) has more than one harmonic.",
         "how the maximum of (46) over tau is found", reading([](ProtocolQuestion& q) {
             if (asks_for(q, {"amplitude", "phase"})) q.quantity += "_monoharmonic";
         })},
        {"elongation-for-displacement", "5",
         "The elongation of the spring before a mass is given for the displacement of the mass.",
         "the coordinates: x_k is measured from the place of rest of mass k", elongation},
        {"force-as-sine", "1", "The load is taken as a sine of tau; the protocol has a cosine: the load is largest at tau = 0.",
         "the origin of tau, and a phase of pi / 2", under_a_sine},
        {"amplitude-at-contact-maximum", "44",
         "The amplitude of a mass is taken as its displacement at the maximum of the contact.",
         "how the maximum of (46) over tau is found",
         [](const ProtocolQuestion& q) -> std::optional<Value> {
             if (q.quantity != "amplitude") return std::nullopt;
             ProtocolQuestion other = q;
             other.quantity = "initial_displacement";
             std::optional<Value> value = plain_answer(other);
             if (value) value->numbers.front() = std::abs(value->numbers.front());
             return value;
         }},
        // Solvers of the motion.
        {"transient", "", "The motion is read off before the transient has decayed.",
         "how many periods are integrated from rest; go on until two in a row agree",
         [](const ProtocolQuestion& q) { return of_motion(q) ? answers_of_transient(q, period, period).front() : std::nullopt; },
         of_steps_in_time},
        {"sliding-beyond-the-boundary", "69", "The closed form is used where the contact stops: (69) is not asked.",
         "whether beta < beta_lim is tested before (38) is used",
         by_formulas({"amplitude", "phase", "motion_under_force"}, &Choices::beyond_the_boundary)},
        {"sgn-of-0-is-0", "3",
         "The contact never rests: friction at rest is taken as sgn(0) = 0; (3) has any value up to mu beta there.",
         "the friction law at zero velocity: while the load is at most mu beta the contact sticks, (74)", without_stops,
         of_steps_in_time}};
    for (const auto& [name, number, width] : {std::tuple("tanh-1e-1", "0.1", 1e-1),
                                              {"tanh-1e-2", "0.01", 1e-2},
                                              {"tanh-1e-3", "0.001", 1e-3},
                                              {"tanh-1e-4", "0.0001", 1e-4}})
        all.push_back(
            {name, "3",
             std::string("The contact creeps where it should rest: sgn is replaced by a hyperbolic tangent of the velocity d x / "
                         "d tau over ") +
                 number + ".",
             "the friction law at zero velocity: friction that needs a velocity holds nothing",
             [width = width](const ProtocolQuestion& q) { return of_motion(q) ? answer_of_creep(q, width) : without_stops(q); },
             of_steps_in_time});
    for (const int highest : {1, 3, 5, 7, 9}) {
        const std::string number = std::to_string(highest);
        all.push_back(
            {"harmonics-up-to-" + number, "", "Friction is cut off after harmonic " + number + ".",
             "the number of harmonics; those of a square wave fall like one over their order",
             by_formulas({"amplitude", "phase", "motion_under_force", "displacement", "initial_displacement", "initial_velocity"},
                         [highest](Choices& c) { c.harmonics = highest; }),
             of_collocation});
    }
    return all;
}

} // namespace denhartog::conformance
