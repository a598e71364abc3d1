// The modes, sums over modes and motions of the plain closed form, with the points at which it may be varied.
//
// This is the closed form as a reader of the corrected paper would code it: in double, without error bounds, and with samples in
// the search for a maximum. Implementations are known to differ at every point of variation. Without variation the numbers have
// the accuracy of double.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "conformance/plain/friction_response.hpp"

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
    bool initial_displacement_as_printed = false; // (44) as printed
    bool initial_velocity_as_printed = false;     // (45) as printed
    bool motion_from_start = false;               // (41) and (49) in place of (46) and (50) to (52)
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

// Modes and sums over modes of a question's system. Rows are those of the masses, and behind them that of a contact between two
// masses (the kit asks about no other direction) and that of a load which is not one force on one mass.
struct PlainModes {
    std::size_t masses = 0;                          // their number
    std::size_t j = 0;                               // the row of the contact, counted from 0
    std::size_t l = 0;                               // the row of the load, counted from 0
    std::size_t l_i = 0;                             // the row of the load that leads by a quarter of a period; l if none does
    double r = 0;                                    // frequency ratio
    double beta = 0;                                 // friction ratio
    double mu = 1;                                   // static over kinetic friction
    PlainRow r_n;                                    // natural frequency ratios, ascending
    PlainRow R;                                      // modal frequency ratios, Eq. (22)
    PlainRow zeta;                                   // modal damping ratios
    PlainMatrix psi;                                 // mode shapes, by rows
    PlainRow u;                                      // first damping functions of the modes, Eq. (28)
    PlainRow g;                                      // second damping functions of the modes, Eq. (29)
    std::vector<Phasor> v;                           // complex response functions of the modes, Eq. (23)
    std::vector<Phasor> V;                           // complex response functions of the rows, Eq. (33)
    PlainRow U;                                      // first damping functions of the rows, Eq. (34)
    PlainRow G;                                      // second damping functions of the rows, Eq. (35)
    Phasor Y_jj;                                     // (33) with the load on the contact
    double H_j = 0;                                  // Eq. (64)
    double sum_of_squares = 0;                       // Eq. (65)
    std::shared_ptr<const FrictionResponse> coupled; // the response to friction where damping couples the modes
};

// Modes and sums of a question. Not finite at a pole of a mode without damping. Throws NoPlainAnswer if there is no such mass.
[[nodiscard]] PlainModes plain_modes(const ProtocolQuestion& q, const Choices& c);

// Adds a row: that of a mass in another frame, where its complex response function is V. The row, counted from 0.
std::size_t add_row_in_frame(PlainModes& m, std::size_t k, const Phasor& V);

// (23).
[[nodiscard]] Phasor response_of_mode(double R, double zeta);

// The expression of (57) between 0 and pi, of a mode and of the sum over modes; and of a mode as printed, which has no maximum.
[[nodiscard]] double demand_of_mode(const PlainModes& m, std::size_t i, double tau);
[[nodiscard]] double plain_demand_at(const PlainModes& m, double tau);
[[nodiscard]] double printed_demand_of_mode(const PlainModes& m, std::size_t i, double tau);

// Motion of a mass in the sliding regime at any instant, (46), or (41) from (44) and (45). The mass counts
// from 0; after the half-period the motion is mirrored.
[[nodiscard]] PlainMotion plain_motion(const PlainModes& m, const Choices& c, std::size_t k, double tau);

// Phase of the mass in contact, (39), not wrapped.
[[nodiscard]] double plain_phase(const PlainModes& m, const Choices& c);

// Terms of (44) and (45) for a mass: V_dk / V_dj as cosine and sine, the root of (38), and beta U_dj.
struct PlainTurn {
    double cosine, sine, root, drag;
};
[[nodiscard]] PlainTurn turn_of(const PlainModes& m, std::size_t k);

// Displacement and velocity of a mass at the maximum of the contact, (44), (45). The mass counts from 0.
[[nodiscard]] PlainMotion plain_start(const PlainModes& m, const Choices& c, std::size_t k);

// Number of equal steps of the half-period that shows every oscillation of the modes.
[[nodiscard]] int plain_steps(const PlainModes& m);

} // namespace denhartog::conformance
