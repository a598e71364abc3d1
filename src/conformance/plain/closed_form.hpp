// The plain closed form: modes, sums over modes, motions, and the answers to every quantity of the protocol, with the points at
// which it may be varied. It shares no code with the library but the elementary functions; matrices are Eigen's, as there.
//
// This is the closed form as a reader of the corrected paper would code it: in double, without error bounds, and with samples in
// the search for a maximum. Implementations are known to differ at every point of variation. Without variation the numbers have
// the accuracy of double.
#pragma once

#include <memory>

#include "conformance/plain/system.hpp"

namespace denhartog::conformance {

// Equally spaced instants in the half-period.
struct Instants {
    double first = 0;       // the first
    double before_end = 0;  // time from the last one to pi
    std::size_t count = 14; // number of instants
};

struct PlainModes;

// The points of variation of the plain closed form.
struct Choices {
    bool motion_as_printed = false;               // the bracket of (46) as printed
    bool initial_displacement_as_printed = false; // (44) as printed, and all that follows from it
    bool initial_velocity_as_printed = false;     // (45) as printed, and all that follows from it
    bool cosine_as_printed = false;               // (50) as printed
    bool monoharmonic_as_printed = false;         // (52) as printed
    bool maximum_of_each_mode = false;            // (56) in place of the maximum of the sum over modes
    bool demand_at_start = false;                 // (72) in place of the maximum of the sum over modes, and of (56)
    bool load_of_each_mode = false;               // (67) from (63), required of every mode by itself
    bool sliding_beyond_68 = false;               // the condition of sliding is (58) and "(67) or (68)", with (68) as printed
    bool argument_in_half_plane = false;          // the argument of V_dj is the arctangent of a quotient
    bool no_half_period_for_minima = false;       // (47) leaves out the half-period if the mass is at a minimum
    bool beyond_the_boundary = false;             // the closed form answers in every regime
    bool closed_form_alone = false;               // there is no answer for the motion beyond the sliding regime
    bool demand_as_printed = false;               // (57) as printed, which needs `instants`
    std::optional<Instants> instants = {};        // where to look for the maximum of (57); none: everywhere
    bool without_load_condition = false;          // (69) from the maximum alone, without the load condition (67)
    int harmonics = 0;                            // the highest harmonic of friction that is kept; 0: all
    std::function<void(PlainModes&)> change_modes = {}; // changes the modes before the sums; empty: no change
    std::function<void(PlainModes&)> change_sums = {};  // changes the sums over the modes; empty: no change
    // Another boundary of permanent sticking, (88); empty: the right one.
    std::function<double(const ProtocolQuestion&)> sticking = {};
};

// A question's system with its modes and sums over modes. Rows are those of the masses, and behind them that of a contact between
// two masses (the kit asks about no other direction) and that of a load which is not one force on one mass.
struct PlainModes : PlainSystem {
    Index j = 0, l = 0, l_i = 0;        // rows of contact, load, and what of it leads by a quarter of a period, else l
    PlainVector R;                      // modal frequency ratios, (22)
    PlainMatrix psi;                    // mode shapes, by rows
    PlainVector u, g;                   // damping functions of the modes, (28) and (29)
    Phasors v;                          // complex response functions of the modes, (23)
    Phasors V;                          // complex response functions of the rows, (33)
    PlainVector U, G;                   // damping functions of the rows, (34) and (35)
    Phasor Y_jj;                        // (33) with the load on the contact
    double H_j = 0, sum_of_squares = 0; // (64), (65)
    std::shared_ptr<const FrictionResponse> friction; // the response to friction where damping couples the modes
};

// Modes and sums of a question. Not finite next to a pole of a mode without damping. Throws NoPlainAnswer if there is no such
// mass.
[[nodiscard]] PlainModes plain_modes(const ProtocolQuestion& q, const Choices& c);

// (23) of the n-th harmonic.
[[nodiscard]] Phasor response_of_mode(double R, double zeta, int n = 1);

// The expression of (57) between 0 and pi, of a mode and of the sum over modes; as printed it has no maximum.
[[nodiscard]] double demand_of_mode(const PlainModes& m, Index i, double tau, bool as_printed);
[[nodiscard]] double plain_demand_at(const PlainModes& m, double tau, bool as_printed);

// Motion of a row in the sliding regime at any instant, (46), or (41) from (44) and (45). After the half-period it is mirrored.
[[nodiscard]] PlainMotion plain_motion(const PlainModes& m, const Choices& c, Index k, double tau);

// Phase of the mass in contact, (39), not wrapped.
[[nodiscard]] double plain_phase(const PlainModes& m, const Choices& c);

// Terms of (44) and (45) for a row: V_dk / V_dj as cosine and sine, the root of (38), and beta U_dj.
struct PlainTurn {
    double cosine, sine, root, drag;
};
[[nodiscard]] PlainTurn turn_of(const PlainModes& m, Index k);

// Displacement and velocity of a row at the maximum of the contact, (44), (45).
[[nodiscard]] PlainMotion plain_start(const PlainModes& m, const Choices& c, Index k);

// Number of equal steps of the half-period that shows every oscillation of the modes.
[[nodiscard]] int plain_steps(const PlainModes& m);

// The largest demand in (69): the maximum over tau of the sum over modes, or (56), the sum of the maxima of the modes.
[[nodiscard]] double plain_demand(const PlainModes& m, const Choices& c, bool of_paper);

// (69) with a demand and the load condition (67).
[[nodiscard]] double plain_limit(const PlainModes& m, const Choices& c, double S);

// The smallest beta at which the contact never moves by (88): as printed, by modes, no number where that has none, or from
// sub-matrices of M, C and K, as its text has it; and without the damping forces on the contact.
[[nodiscard]] double plain_sticking_limit_by_88(const ProtocolQuestion& q, bool by_modes);
[[nodiscard]] double plain_sticking_limit_without_damping(const ProtocolQuestion& q);

// The answer to a question; beyond the sliding regime it is that of the motion from event to event. With choices it is that of
// the varied formulas, for scenes of the paper. The formulas are used as they stand even if the scene breaks a rule of friction.
// None if the answer is not finite, or if the question has none.
[[nodiscard]] std::optional<Value> plain_answer(const ProtocolQuestion& q);
[[nodiscard]] std::optional<Value> plain_answer(const ProtocolQuestion& q, const Choices& c);

// The answer to a question of an absolute motion, with `times_frame` times the motion of the frame: 1 is right, 0 gives the
// relative motion, and -1 subtracts that of the frame.
[[nodiscard]] std::optional<Value> plain_answer_in_frame(const ProtocolQuestion& q, double times_frame);

// An answer; none where it has a number that is not finite, or where NoPlainAnswer is thrown.
[[nodiscard]] std::optional<Value> where_finite(const std::function<std::optional<Value>()>& answer);

// The values of a function at the instants of a question, equally spaced over a period from 0 on.
[[nodiscard]] Value sampled(const ProtocolQuestion& q, const std::function<double(double tau)>& f);

// An angle as the protocol gives it, in (-pi, pi].
[[nodiscard]] double wrapped_angle(double angle);

// The answers that are read off some of the periods between rest and the steady motion, one for each period of the force from
// the first, at least 1, to the last. Throws NoPlainAnswer.
[[nodiscard]] std::vector<std::optional<Value>> answers_of_transient(const ProtocolQuestion& q, int first, int last);

// The answer of a solver that replaces sgn by a hyperbolic tangent, to a question of amplitude or motion: a contact that should
// rest permanently creeps with x_j' = -width artanh(|load| cos(tau + arg load) / beta), with the load of (88) on the held
// contact; this is of first order in the width, a velocity in the unit of d x / d tau. None if another mass is asked about, the
// contact moves, or only static friction holds it.
[[nodiscard]] std::optional<Value> answer_of_creep(const ProtocolQuestion& q, double width);

} // namespace denhartog::conformance
