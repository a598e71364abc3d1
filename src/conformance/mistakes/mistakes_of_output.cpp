// Known mistakes in an answer: another unit, sign or origin of a phase or displacement, (39) and (47); the errors of solvers that
// step in time, such as a smoothed sign of the velocity or a transient that has not decayed; and, in `mistakes_of_formulas`,
// equations that are coded as printed.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "conformance/mistakes/mistake_definition.hpp"
#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

using std::numbers::pi;
using std::string_literals::operator""s;

const std::vector<std::string> no_core, of_displacement{"displacement"};
const Names angles_of_paper{"phase", "phase_monoharmonic"}, angles{"phase", "phase_monoharmonic", "absolute_phase"};
const Names amplitudes{"amplitude", "amplitude_monoharmonic", "absolute_amplitude", "transmissibility"};
const Names of_46{"displacement", "amplitude", "phase", "motion_under_force"};

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
void take_elongation(Value& value, ProtocolQuestion q) {
    if (--q.mass < 1) return;
    const std::optional<Value> before = plain_answer(q);
    if (!before) throw NoPlainAnswer();
    std::ranges::transform(value.numbers, before->numbers, value.numbers.begin(), std::minus());
}

// The response to sin(tau) is a quarter of a period late.
void take_sine(Value& value, const ProtocolQuestion& q) {
    if (q.quantity != "motion_under_force") {
        value.numbers.front() = wrapped_angle(value.numbers.front() + pi / 2);
        return;
    }
    if (q.samples % 4 != 0) throw NoPlainAnswer();
    std::rotate(value.numbers.begin(), value.numbers.end() - q.samples / 4, value.numbers.end());
}

std::optional<Value> from_contact(const ProtocolQuestion& q) {
    if (q.quantity != "motion_under_force" || !slides(q)) return std::nullopt;
    ProtocolQuestion other = q;
    other.quantity = "displacement";
    return sampled(q, [&](double tau) {
        other.tau = tau;
        const std::optional<Value> x = plain_answer(other);
        return x ? x->numbers.front() : std::nan("");
    });
}

std::optional<Value> at_contact_maximum(ProtocolQuestion q) {
    if (q.quantity != "amplitude") return std::nullopt;
    q.quantity = "initial_displacement";
    std::optional<Value> value = plain_answer(q);
    if (value) value->numbers.front() = std::abs(value->numbers.front());
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

// Cores of mistakes.
const std::vector<std::string> of_67{"beta_lim_approximate"},
    of_limits{"beta_lim_approximate", "beta_lim_exact", "beta_lim_paper"}, of_maxima{"S_j", "beta_lim_exact", "beta_lim_paper"},
    of_sticking{"beta_lim_sticking"};

// Every mode shape times a factor of its own.
Answering scaled_shapes(double (*factor)(const PlainModes& m, Index i)) {
    return by_formulas({}, [=](Choices& c) {
        c.change_modes = [=](PlainModes& m) {
            for (Index i = 0; i < m.R.size(); ++i) m.psi.col(i) *= factor(m, i);
        };
    });
}

// Another response of every mode in place of (23).
Answering other_responses(Phasor (*response)(double R, double zeta)) {
    return by_formulas({}, [=](Choices& c) {
        c.change_modes = [=](PlainModes& m) {
            for (Index i = 0; i < m.R.size(); ++i) m.v[i] = response(m.R[i], m.zeta[i]);
        };
    });
}

Answering other_sticking(double (*limit)(const ProtocolQuestion&)) {
    return by_formulas({"beta_lim_sticking", "regime"}, [=](Choices& c) { c.sticking = limit; });
}

Answering other_sums(void (*change)(PlainModes&)) {
    return by_formulas(of_load, [=](Choices& c) { c.change_sums = change; });
}

// The instants that are tried for a maximum, from the start of the half-period and from its end.
Answering tried_at(double step, std::size_t count, bool as_printed) {
    return by_formulas(of_maximum, [=](Choices& c) {
        c.demand_as_printed = as_printed;
        c.instants = Instants{step, step, count};
    });
}

// The paper prints nothing for a mode that does not vibrate. The core: what the equation is printed for.
Mistake printed(const std::string& equation, std::string told, std::string look_at, Answering answer,
                std::vector<std::string> core = {}) {
    Mistake mistake{equation + "-as-printed", equation, std::move(told), std::move(look_at),
                    where_modes_vibrate(std::move(answer))};
    mistake.core = std::move(core);
    mistake.as_printed = true;
    return mistake;
}

} // namespace

Answering read_off_in(int period) {
    return by_itself([period](const ProtocolQuestion& q) {
        return of_motion(q) ? answers_of_transient(q, period, period).front() : std::nullopt;
    });
}

std::vector<Mistake> mistakes_of_output() {
    constexpr double of_collocation = 1e-2;
    std::vector<Mistake> all{
        {"degrees", "39", "Angles are given in degrees; the protocol has radians.", "the unit of every phase",
         each_changed(angles, [](double x) { return x * (180 / pi); })},
        {"phase-sign", "39", "Phases are given as lead; the protocol has the lag behind the force.",
         "the sign of every phase: positive where the mass is late",
         each_changed(angles, [](double x) { return wrapped_angle(-x); })},
        {"phase-wrap", "39", "Phases are wrapped to [0, 2 pi); the protocol has (-pi, pi].",
         "the interval to which phases are wrapped", each_changed(angles, [](double x) { return x < 0 ? x + 2 * pi : x; })},
        {"phase-behind-contact", "47", "Phases are given behind the mass in contact; the protocol has the lag behind the force.",
         "whether phi_j is added in (47) and (53)",
         each_changed(
             angles_of_paper,
             [](double x, const ProtocolQuestion& q) { return slides(q) ? wrapped_angle(x - phase_of_contact(q)) : x; })},
        {"peak-to-peak", "38", "Amplitudes are given peak to peak; the protocol has the largest displacement.",
         "a factor of 2 in the amplitude", each_changed(amplitudes, [](double x) { return x * 2; })},
        {"amplitude-halved", "38", "Amplitudes are halved, as if the motion had been taken peak to peak before.",
         "a factor of 1/2 in the amplitude", each_changed(amplitudes, [](double x) { return x / 2; })},
        {"root-mean-square", "38", "Amplitudes are those of a harmonic motion over sqrt(2): its root mean square.",
         "how the amplitude is read off the motion", each_changed(amplitudes, [](double x) { return x / std::sqrt(2.0); })},
        {"static-deflection-of-loaded-mass", "5",
         "Displacements are in units of the static deflection of the loaded mass; (5) has P / k_1.",
         "the unit of displacements: the stiffness of the first spring",
         each_changed({"amplitude", "amplitude_monoharmonic", "initial_displacement", "initial_velocity", "displacement",
                       "complex_response", "motion_under_force", "rest_interval"},
                      [](double x, const ProtocolQuestion& q) { return x / static_deflection(q); })},
        {"tau-from-force", "46", "tau = 0 is taken at the maximum of the force; the closed form has it at that of the contact.",
         "the origin of tau: the force is cos(tau + phi_j)", reading([](ProtocolQuestion& q) {
             if (!asks_for(q, {"displacement", "initial_displacement"})) return;
             q.tau = (q.quantity == "displacement" ? q.tau : 0) - phase_of_contact(q);
             q.quantity = "displacement";
         }),
         of_displacement},
        {"motion-from-contact", "46",
         "The motion is sampled from the maximum of the contact on; motion_under_force starts at that of the force.",
         "the origin of tau: the contact is at its maximum at tau = phi_j", by_itself(from_contact)},
        {"monoharmonic-taken-for-exact", "52",
         "(52) and (53) are given for amplitude and phase; (46) has more than one harmonic.",
         "how the maximum of (46) over tau is found", reading([](ProtocolQuestion& q) {
             if (asks_for(q, {"amplitude", "phase"})) q.quantity += "_monoharmonic";
         })},
        {"elongation-for-displacement", "5",
         "The elongation of the spring before a mass is given for the displacement of the mass.",
         "the coordinates: x_k is measured from the place of rest of mass k",
         by_itself(changed({"displacement", "initial_displacement", "initial_velocity", "motion_under_force"}, take_elongation))},
        {"force-as-sine", "1", "The load is taken as a sine of tau; the protocol has a cosine: the load is largest at tau = 0.",
         "the origin of tau, and a phase of pi / 2",
         by_itself(changed({"phase", "phase_monoharmonic", "absolute_phase", "motion_under_force"}, take_sine))},
        {"amplitude-at-contact-maximum", "44",
         "The amplitude of a mass is taken as its displacement at the maximum of the contact.",
         "how the maximum of (46) over tau is found", by_itself(at_contact_maximum)},
        // Solvers of the motion.
        {"transient", "", // in the tenth period, until the answers tell `fitted_transient` which
         "The motion is read off before the transient has decayed.",
         "how many periods are integrated from rest; go on until two in a row agree", read_off_in(10), no_core, of_steps_in_time},
        {"sliding-beyond-the-boundary", "69", "The closed form is used where the contact stops: (69) is not asked.",
         "whether beta < beta_lim is tested before (38) is used",
         by_formulas({"amplitude", "phase", "motion_under_force"}, &Choices::beyond_the_boundary)},
        {"sgn-of-0-is-0", "3",
         "The contact never rests: friction at rest is taken as sgn(0) = 0; (3) has any value up to mu beta there.",
         "the friction law at zero velocity: while the load is at most mu beta the contact sticks, (74)",
         by_itself(without_stops), no_core, of_steps_in_time}};
    for (const auto& [name, number, width] : {std::tuple("tanh-1e-1", "0.1"s, 1e-1),
                                              {"tanh-1e-2", "0.01"s, 1e-2},
                                              {"tanh-1e-3", "0.001"s, 1e-3},
                                              {"tanh-1e-4", "0.0001"s, 1e-4}})
        all.push_back({name, "3",
                       "The contact creeps where it should rest: sgn is replaced by a hyperbolic tangent of the velocity d x / d "
                       "tau over " +
                           number + ".",
                       "the friction law at zero velocity: friction that needs a velocity holds nothing",
                       by_itself([width = width](const ProtocolQuestion& q) {
                           return of_motion(q) ? answer_of_creep(q, width) : without_stops(q);
                       }),
                       no_core, of_steps_in_time});
    for (const int highest : {1, 3, 5, 7, 9}) {
        const std::string number = std::to_string(highest);
        all.push_back(
            {"harmonics-up-to-" + number, "", "Friction is cut off after harmonic " + number + ".",
             "the number of harmonics; those of a square wave fall like one over their order",
             by_formulas({"amplitude", "phase", "motion_under_force", "displacement", "initial_displacement", "initial_velocity"},
                         [highest](Choices& c) { c.harmonics = highest; }),
             no_core, of_collocation});
    }
    return all;
}

std::vector<Mistake> mistakes_of_formulas() {
    return {
        printed("46",
                "Sine and cosine stand exchanged in the bracket of (46), as printed there and in (40), (41) and (A.15); it is d "
                "of (A.8).",
                "the bracket that multiplies (1 + g_i): cos + zeta / sqrt(1 - zeta^2) sin, which is 1 at tau = 0",
                by_formulas(of_46, &Choices::motion_as_printed), {"displacement"}),
        printed("44", "(44) as printed: the real part lacks beta U_dj sin(Delta).",
                "x_k0: the phase phi_j is not zero in V_dk cos(phi_j), read as Re{V_dk exp(i phi_j)}",
                by_formulas({"initial_displacement", "displacement", "amplitude", "phase", "motion_under_force",
                             "amplitude_monoharmonic", "phase_monoharmonic"},
                            &Choices::initial_displacement_as_printed),
                {"initial_displacement"}),
        printed("45", "(45) as printed: the real part lacks the root times sin(Delta).",
                "x'_k0: V_dk sin(phi_j) is read as Im{V_dk exp(i phi_j)}, whose real part alone is not enough",
                by_formulas({"initial_velocity", "displacement", "amplitude", "phase", "motion_under_force",
                             "amplitude_monoharmonic", "phase_monoharmonic"},
                            &Choices::initial_velocity_as_printed),
                {"initial_velocity"}),
        printed("50", "(50) as printed: the ratio of the moduli multiplies its first term only.",
                "X_kC: |V_dk| / |V_dj| multiplies the root and beta U_dj sin(Delta)",
                by_formulas({"phase_monoharmonic", "amplitude_monoharmonic"}, &Choices::cosine_as_printed),
                {"phase_monoharmonic"}),
        printed("52", "(52) as printed: U_dk sin(Delta) has the other sign.",
                "the first bracket of (52): G_k cos(Delta) - U_dk sin(Delta)",
                by_formulas({"amplitude_monoharmonic"}, &Choices::monoharmonic_as_printed), {"amplitude_monoharmonic"}),
        printed("56", "The sum of the maxima of the modes, (56), is taken for the maximum of their sum.",
                "where the maximum over tau is taken: after the sum over the modes",
                by_formulas({"S_j", "beta_lim_exact", "regime"}, &Choices::maximum_of_each_mode), {"S_j"}),
        printed("63", "The load condition is asked of every mode on its own, as (59) and (63) print it; it holds for the sum.",
                "(59) and (63): sum over the modes with psi_ji before comparing with mu beta",
                by_formulas(of_load, &Choices::load_of_each_mode), of_67),
        printed("68", "The contact is said to slide beyond (68) as printed, which also needs H_j > mu / (gamma_j r^2).",
                "the condition (68): drop it, since (58) and (68) never hold at once",
                by_formulas(of_boundary, &Choices::sliding_beyond_68), {"beta_lim_exact"}),
        printed("86", "(86) as printed has mu in place of its square.", "the root of (86): 4 mu^2 + pi^2",
                changed({"beta_lim_high_frequency"},
                        [](Value& value, const ProtocolQuestion& q) {
                            value.numbers = {2 / elementary::hypot(2 * std::sqrt(q.mu), pi)};
                        })),
        printed("88", "(88) as printed: the spring next to the contact alone holds it, and the modes are taken as uncoupled.",
                "(88): all forces on the held contact count, the damping forces of the moving masses among them",
                other_sticking([](const ProtocolQuestion& q) { return plain_sticking_limit_by_88(q, true); }), of_sticking),
        // It has no maximum: what is answered depends on the instants tried, which `fitted_to` finds from the answers.
        printed("57",
                "(57) as printed: another bracket multiplies u_di, and cos(tau) is missing, so that it has no maximum; its "
                "value at one of the instants tried is taken for it, in the sum over the modes or, by (56), mode by mode.",
                "the expression of (57): (1 + g_i) R_i q_i - u_di R_i^2 (R_i q_i' - cos(tau)) over sin(tau) stays finite at "
                "both ends",
                tried_at(pi / 1000, 999, true), of_maxima),
        // Mistakes that the paper does not print.
        {"88-without-damping-forces", "88", "The damping forces of the moving masses on the held contact are left out of (88).",
         "(88): row j of the damping matrix is not zero off its diagonal", other_sticking(plain_sticking_limit_without_damping),
         of_sticking},
        {"88-by-sub-matrices", "88",
         "(88) from the first or last rows and columns of M, C and K, as its text has it: of the forces on the held contact only "
         "that of one spring counts.",
         "(88): all forces on the held contact count, the damping forces of all moving masses among them",
         other_sticking([](const ProtocolQuestion& q) { return plain_sticking_limit_by_88(q, false); }), of_sticking},
        {"approximate-limit", "67", "(67) is taken for the boundary (69): (72) stands in place of the maximum over tau.",
         "whether the maximum over tau of the sum over modes is sought at all",
         by_formulas(of_maximum, &Choices::demand_at_start), of_maxima},
        {"load-condition-left-out", "67",
         "The boundary (69) is taken from the maximum over tau alone; the load condition (67) may end the sliding before.",
         "whether the larger of S_j and H_j + mu / (gamma_j r^2) stands in (69)",
         by_formulas(of_boundary, &Choices::without_load_condition), of_limits},
        {"mu-missing-in-67", "67", "mu is left out of (67): the load is compared with kinetic friction.",
         "mu in H_j + mu / (gamma_j r^2), and in the load condition of (69)",
         other_sums([](PlainModes& m) { m.sum_of_squares /= m.mu; }), of_67},
        // The number of instants is found from the answers by `fitted_to`.
        {"coarse-grid-of-tau", "57",
         "The maximum over tau is that of a few instants, 14 for example; the true one lies between two of them.",
         "how the maximum over tau is found: refine it around the largest sample", tried_at(pi / 15, 14, false), of_maxima},
        {"sign-of-mu-in-67", "67", "mu / (gamma_j r^2) has the other sign in (67) and (69), which is (68).",
         "H_j + mu / (gamma_j r^2) in (67)", other_sums([](PlainModes& m) { m.sum_of_squares = -m.sum_of_squares; }), of_67},
        {"r-not-squared-in-65", "65", "The sum of squares in (65) is taken as 1 / (gamma_j r); it is 1 / (gamma_j r^2).",
         "mu / (gamma_j r^2) in (67)", other_sums([](PlainModes& m) { m.sum_of_squares *= m.r; }), of_67},
        {"psi-not-scaled-with-r", "17", "Mode shapes are normalised with diag(m_i / m_1); (17) has r^2 diag(m_i / m_1).",
         "the normalisation of the mode shapes: they go as 1 / r", scaled_shapes([](const PlainModes& m, Index) { return m.r; })},
        {"psi-largest-entry-1", "17", "Mode shapes are normalised to a largest entry of 1; (17) uses the mass matrix.",
         "the normalisation of the mode shapes: psi^T M psi = 1 with M of (8)",
         scaled_shapes([](const PlainModes& m, Index i) { return 1 / m.psi.col(i).cwiseAbs().maxCoeff(); })},
        {"psi-of-unit-length", "17",
         "Mode shapes have unit length, as eigenvalue routines return them; (17) uses the mass matrix.",
         "the normalisation of the mode shapes: psi^T M psi = 1 with M of (8)",
         scaled_shapes([](const PlainModes& m, Index i) { return 1 / m.psi.col(i).norm(); })},
        {"modes-descending", "15", "Modes are listed by descending natural frequency; answers list them ascending.",
         "the order in which the eigenvalue routine returns the modes",
         changed({"natural_frequency_ratios", "modal_frequency_ratios", "mode_shape_products"},
                 [](Value& value, const ProtocolQuestion&) { std::ranges::reverse(value.numbers); })},
        {"no-2-in-23", "23", "The 2 of 2 zeta_i R_i is missing in (23).", "the imaginary part of (23)",
         other_responses([](double R, double zeta) { return response_of_mode(R, zeta / 2); })},
        {"hysteretic-damping", "23", "Damping is hysteretic: (23) has 2 zeta_i in place of 2 zeta_i R_i.",
         "the imaginary part of (23): a viscous force grows with the frequency", other_responses([](double R, double zeta) {
             const Phasor stiffness((1 - R) * (1 + R), 2 * zeta);
             return std::conj(stiffness) / std::norm(stiffness);
         })},
        {"argument-by-arctangent", "39",
         "The argument of V_dj is taken as the arcus tangent of a quotient, which loses the half-plane.",
         "the argument of V_dj in (39): atan2 of imaginary and real part",
         by_formulas({"phase", "phase_monoharmonic", "motion_under_force"}, &Choices::argument_in_half_plane)},
        {"minimum-taken-for-maximum", "47",
         "The phase of a mass is that of its minimum where this is what the half-period holds: (47) lacks half a period.",
         "(47): add pi where the displacement of largest size is negative",
         by_formulas({"phase"}, &Choices::no_half_period_for_minima)}};
}

} // namespace denhartog::conformance
