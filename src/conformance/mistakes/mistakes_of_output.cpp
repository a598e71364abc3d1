#include <numeric>

#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/number.hpp"

namespace denhartog::conformance {
namespace {

using Names = std::vector<std::string_view>;
using Change = std::function<void(double& x, const ProtocolQuestion& q)>;

bool among(const Names& names, const ProtocolQuestion& q) {
    return std::find(names.begin(), names.end(), q.quantity) != names.end();
}

// The right answer, each of its numbers changed.
MistakeDefinition told_otherwise(std::string name, std::string equation, std::string told, std::string look_at, Names touched,
                                 Change change) {
    return {{std::move(name), std::move(equation), false, std::move(told), std::move(look_at)},
            [touched = std::move(touched), change = std::move(change)](const ProtocolQuestion& q) {
                if (!among(touched, q)) return std::optional<Value>();
                std::optional<Value> value = plain_answer(q);
                if (value)
                    for (double& x : value->numbers) change(x, q);
                return value;
            }};
}

// The right answer to another quantity.
MistakeDefinition other_quantity(std::string name, std::string equation, std::string told, std::string look_at,
                                 std::vector<std::pair<std::string_view, std::string>> others) {
    return {{std::move(name), std::move(equation), false, std::move(told), std::move(look_at)},
            [others = std::move(others)](const ProtocolQuestion& q) {
                for (const auto& [asked, answered] : others) {
                    if (q.quantity != asked) continue;
                    ProtocolQuestion other = q;
                    other.quantity = answered;
                    return plain_answer(other);
                }
                return std::optional<Value>();
            }};
}

MistakeDefinition elsewhere(std::string name, std::string equation, std::string told, std::string look_at,
                            std::function<std::optional<Value>(const ProtocolQuestion&)> answer,
                            std::vector<std::string> core = {}) {
    Mistake mistake{std::move(name), std::move(equation), false, std::move(told), std::move(look_at)};
    mistake.core = std::move(core);
    return {std::move(mistake), std::move(answer)};
}

const Names angles{"phase", "phase_monoharmonic"};

double phase_of_contact(const ProtocolQuestion& q) {
    Choices c;
    c.beyond_the_boundary = true;
    return plain_phase(plain_modes(q, c), c);
}

bool slides(ProtocolQuestion q) {
    q.quantity = "regime";
    const std::optional<Value> regime = plain_answer(q);
    return regime && regime->word == "continuous";
}

// Displacement of the loaded mass under the amplitude of the load at rest, without friction, in units of P / k_1.
double static_deflection(const ProtocolQuestion& q) {
    check_of_the_paper(q);
    double sum = 0;
    for (int i = 0; i < q.load; ++i) sum += 1 / q.stiffness_ratios[static_cast<std::size_t>(i)];
    return sum;
}

std::vector<MistakeDefinition> of_angles() {
    return {
        told_otherwise("degrees", "39", "Angles are given in degrees; the protocol has radians.", "the unit of every phase",
                       angles, [](double& x, const ProtocolQuestion&) { x *= 180 / pi<double>(); }),
        told_otherwise("phase-sign", "39", "Phases are given as lead; the protocol has the lag behind the force.",
                       "the sign of every phase: positive where the mass is late", angles,
                       [](double& x, const ProtocolQuestion&) { x = wrapped_angle(-x); }),
        told_otherwise("phase-wrap", "39", "Phases are wrapped to [0, 2 pi); the protocol has (-pi, pi].",
                       "the interval to which phases are wrapped", angles,
                       [](double& x, const ProtocolQuestion&) { x = x < 0 ? x + 2 * pi<double>() : x; }),
        told_otherwise("phase-behind-contact", "47",
                       "Phases are given behind the mass in contact; the protocol has the lag behind the force.",
                       "whether phi_j is added in (47) and (53)", angles,
                       [](double& x, const ProtocolQuestion& q) { x = slides(q) ? wrapped_angle(x - phase_of_contact(q)) : x; }),
    };
}

std::vector<MistakeDefinition> of_displacements() {
    return {
        told_otherwise("peak-to-peak", "38", "Amplitudes are given peak to peak; the protocol has the largest displacement.",
                       "a factor of 2 in the amplitude", {"amplitude", "amplitude_monoharmonic"},
                       [](double& x, const ProtocolQuestion&) { x *= 2; }),
        told_otherwise("amplitude-halved", "38", "Amplitudes are halved, as if the motion had been taken peak to peak before.",
                       "a factor of 1/2 in the amplitude", {"amplitude", "amplitude_monoharmonic"},
                       [](double& x, const ProtocolQuestion&) { x /= 2; }),
        told_otherwise("root-mean-square", "38", "Amplitudes are those of a harmonic motion over sqrt(2): its root mean square.",
                       "how the amplitude is read off the motion", {"amplitude", "amplitude_monoharmonic"},
                       [](double& x, const ProtocolQuestion&) { x /= std::sqrt(2.0); }),
        told_otherwise("static-deflection-of-loaded-mass", "5",
                       "Displacements are in units of the static deflection of the loaded mass; (5) has P / k_1.",
                       "the unit of displacements: the stiffness of the first spring",
                       {"amplitude", "amplitude_monoharmonic", "initial_displacement", "initial_velocity", "displacement",
                        "complex_response", "motion_under_force", "rest_interval"},
                       [](double& x, const ProtocolQuestion& q) { x /= static_deflection(q); }),
        elsewhere("tau-from-force", "46",
                  "tau = 0 is taken at the maximum of the force; the closed form has it at that of the contact.",
                  "the origin of tau: the force is cos(tau + phi_j)",
                  [](const ProtocolQuestion& q) -> std::optional<Value> {
                      if (!asks_for(q, {"displacement", "initial_displacement"})) return std::nullopt;
                      ProtocolQuestion other = q;
                      other.tau = (q.quantity == "displacement" ? q.tau : 0) - phase_of_contact(q);
                      other.quantity = "displacement";
                      return plain_answer(other);
                  },
                  {"displacement"}),
        elsewhere("motion-from-contact", "46",
                  "The motion is sampled from the maximum of the contact on; motion_under_force starts at that of the force.",
                  "the origin of tau: the contact is at its maximum at tau = phi_j",
                  [](const ProtocolQuestion& q) -> std::optional<Value> {
                      if (q.quantity != "motion_under_force" || !slides(q)) return std::nullopt;
                      Value value;
                      for (int n = 0; n < q.samples; ++n) {
                          ProtocolQuestion other = q;
                          other.quantity = "displacement";
                          other.tau = 2 * pi<double>() * n / q.samples;
                          const std::optional<Value> x = plain_answer(other);
                          if (!x) return std::nullopt;
                          value.numbers.push_back(x->numbers.front());
                      }
                      return value;
                  }),
    };
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
    if (!value || !asks_for(q, {"phase", "phase_monoharmonic", "motion_under_force"})) return std::nullopt;
    if (q.quantity != "motion_under_force") return Value{{wrapped_angle(value->numbers.front() + pi<double>() / 2)}, ""};
    if (q.samples % 4 != 0) return std::nullopt;
    std::rotate(value->numbers.begin(), value->numbers.end() - q.samples / 4, value->numbers.end());
    return value;
}

std::vector<MistakeDefinition> of_quantities() {
    return {
        other_quantity("monoharmonic-taken-for-exact", "52",
                       "(52) and (53) are given for amplitude and phase; (46) has more than one harmonic.",
                       "how the maximum of (46) over tau is found",
                       {{"amplitude", "amplitude_monoharmonic"}, {"phase", "phase_monoharmonic"}}),
        elsewhere("elongation-for-displacement", "5",
                  "The elongation of the spring before a mass is given for the displacement of the mass.",
                  "the coordinates: x_k is measured from the place of rest of mass k", elongation),
        elsewhere("force-as-sine", "1",
                  "The load is taken as a sine of tau; the protocol has a cosine: the load is largest at tau = 0.",
                  "the origin of tau, and a phase of pi / 2", under_a_sine),
        elsewhere("amplitude-at-contact-maximum", "44",
                  "The amplitude of a mass is taken as its displacement at the maximum of the contact.",
                  "how the maximum of (46) over tau is found",
                  [](const ProtocolQuestion& q) -> std::optional<Value> {
                      if (q.quantity != "amplitude") return std::nullopt;
                      ProtocolQuestion other = q;
                      other.quantity = "initial_displacement";
                      std::optional<Value> value = plain_answer(other);
                      if (value) value->numbers.front() = std::abs(value->numbers.front());
                      return value;
                  }),
    };
}

} // namespace

std::vector<MistakeDefinition> mistakes_of_output() {
    std::vector<MistakeDefinition> all = of_angles();
    for (const auto& part : {of_displacements(), of_quantities()}) all.insert(all.end(), part.begin(), part.end());
    return all;
}

} // namespace denhartog::conformance
