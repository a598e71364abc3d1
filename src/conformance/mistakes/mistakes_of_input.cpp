// Known mistakes in reading a question: ratios that are ignored or inverted, damping by (18) or (19) misread, masses counted from
// 0, and the motion of a base or wall that is left out or subtracted.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "conformance/mistakes/mistake_definition.hpp"

namespace denhartog::conformance {
namespace {

using std::numbers::pi;

void invert(std::vector<double>& ratios) {
    for (double& x : ratios) x = 1 / x;
}

void multiply(std::vector<double>& list, double by) {
    for (double& x : list) x *= by;
}

void set_all(std::vector<double>& list, double x) { std::ranges::fill(list, x); }

// Viscous damping times a number.
Answering damping_times(double factor) {
    return reading([factor](ProtocolQuestion& q) {
        for (auto* list : {&q.damping_ratios, &q.damping_matrix}) multiply(*list, factor);
    });
}

// Another load of a base or wall that moves: a change of the question, made from its system, if what moves is this.
template <class Change>
Answering of_base(const char* motion, Change change) {
    return reading([=](ProtocolQuestion& q) {
        if (q.base_motion == motion) change(q, plain_system(q));
    });
}

// The same where a base or wall moves alone and dampers are a part of the load.
template <class Change>
Answering of_damped_base(Change change) {
    return reading([=](ProtocolQuestion& q) {
        if (q.base_motion != "alone" && q.base_motion != "wall") return;
        if (const PlainSystem s = plain_system(q); !s.p_i.isZero(0)) change(q, s);
    });
}

// Absolute motions with `times` times the motion of the frame: 1 is right, 0 gives the relative motion, -1 subtracts it.
Answering adding_frame(double times) {
    return {[times](const ProtocolQuestion& q) {
        const bool moves = quantity(q.quantity).absolute && (q.base_motion == "with_wall" || q.base_motion == "wall");
        return moves ? plain_answer_in_frame(q, times) : std::nullopt;
    }};
}

const std::vector<std::string> of_limits{"beta_lim_approximate", "beta_lim_exact", "beta_lim_paper",
                                         "beta_lim_sticking"}; // a core

} // namespace

std::vector<Mistake> mistakes_of_input() {
    return {
        {"mass-ratios-ignored", "9", "The mass ratios of (9) are taken as 1: all masses are the first one.",
         "where mass_ratios enter the mass matrix; test with masses that differ",
         reading([](ProtocolQuestion& q) { set_all(q.mass_ratios, 1); })},
        {"mass-ratios-inverted", "9", "The mass ratios are taken as m_1 / m_i; (9) has m_i / m_1.",
         "where mass_ratios enter the mass matrix: a ratio above 1 is a heavier mass",
         reading([](ProtocolQuestion& q) { invert(q.mass_ratios); })},
        {"stiffness-ratios-ignored", "73", "The stiffness ratios of (73) are taken as 1: all springs are the first one.",
         "where stiffness_ratios enter the stiffness matrix; test with springs that differ",
         reading([](ProtocolQuestion& q) { set_all(q.stiffness_ratios, 1); })},
        {"stiffness-ratios-inverted", "73", "The stiffness ratios are taken as k_1 / k_i; (73) has k_i / k_1.",
         "where stiffness_ratios enter the stiffness matrix: a ratio above 1 is a stiffer spring",
         reading([](ProtocolQuestion& q) { invert(q.stiffness_ratios); })},
        {"damping-of-first-mode", "18", "The damping ratio of the first mode is used for every mode; (18) has one a mode.",
         "the index of the damping ratio in the loops over modes", reading([](ProtocolQuestion& q) {
             if (!q.damping_ratios.empty()) set_all(q.damping_ratios, q.damping_ratios.front());
         })},
        {"damping-ignored", "18", "Viscous damping is left out: every zeta_i of (18) is taken as 0.",
         "whether the damping ratios reach (23), (28) and (29)", damping_times(0)},
        {"damping-halved", "19", "Viscous damping is half of what it should be: the 2 of 2 zeta_i Omega_i in (19) is missing.",
         "the factor 2 where modal damping is made from damping ratios; a loss factor is twice a damping ratio",
         damping_times(0.5)},
        {"damping-as-logarithmic-decrement", "18",
         "The damping ratios are taken for logarithmic decrements: zeta_i of (18) is divided by 2 pi.",
         "what is made of damping_ratios: they are zeta_i, not delta_i = 2 pi zeta_i / sqrt(1 - zeta_i^2)",
         reading([](ProtocolQuestion& q) { multiply(q.damping_ratios, 1 / (2 * pi)); })},
        {"damping-ratios-reversed", "18",
         "The damping ratios are given to the modes by descending natural frequency; the list goes by ascending.",
         "the order in which the eigenvalue routine returns the modes; sort them before damping ratios are attached",
         reading([](ProtocolQuestion& q) { std::ranges::reverse(q.damping_ratios); })},
        {"contact-and-load-swapped", "4", "The mass in contact j and the loaded mass l are exchanged.",
         "which row of the modal matrix multiplies the friction force and which one the load",
         reading([](ProtocolQuestion& q) { std::swap(q.contact, q.load); })},
        {"4-as-printed", "4",
         "Load and friction act on one mass, as (4) and (16) print it: the load stands on the mass in contact.",
         "the unit vectors of (4) or the rows of the modal matrix in (16): friction has e_j, the load e_l",
         reading([](ProtocolQuestion& q) { q.load = q.contact; })},
        {"friction-on-loaded-mass", "4", "Friction acts on the loaded mass l in place of the mass in contact j.",
         "the row of the modal matrix that multiplies the friction force",
         reading([](ProtocolQuestion& q) { q.contact = q.load; })},
        {"contact-counted-from-0", "4", "The mass in contact is counted from 0: contact is taken as one mass further.",
         "the index made from contact: the protocol counts masses from 1", reading([](ProtocolQuestion& q) {
             ++q.contact;
             if (q.contact_with != 0) ++q.contact_with;
         })},
        {"load-counted-from-0", "4", "The loaded mass is counted from 0: load is taken as one mass further.",
         "the index made from load: the protocol counts masses from 1", reading([](ProtocolQuestion& q) { ++q.load; })},
        {"mass-counted-from-0", "", "The mass asked about is counted from 0: mass is taken as one mass further.",
         "the index made from mass: the protocol counts masses from 1", reading([](ProtocolQuestion& q) { ++q.mass; })},
        {"mu-ignored", "3", "Static friction is taken equal to kinetic friction: mu of (3) is taken as 1.",
         "the conditions (54)b, (67) and (74), which have mu beta where the sliding motion has beta",
         reading([](ProtocolQuestion& q) { q.mu = 1; }), of_limits},
        {"mu-squared", "3", "mu is squared where (3), (67) and (74) have mu.", "every place where mu is multiplied by beta",
         reading([](ProtocolQuestion& q) { q.mu *= q.mu; })},
        {"static-friction-while-sliding", "3",
         "The contact slides under static friction mu beta; it slides under kinetic friction beta.",
         "the friction force while the contact moves: beta without mu", reading([](ProtocolQuestion& q) { q.beta *= q.mu; })},
        {"beta-as-static-friction", "11",
         "beta is taken as static friction over the load, so that kinetic friction is beta / mu.",
         "the meaning of beta: (11) has kinetic friction F; static friction is mu times that",
         reading([](ProtocolQuestion& q) { q.beta /= q.mu; })},
        {"friction-by-effective-value", "11", "beta is taken for an effective value: friction is sqrt(2) times as large.",
         "the meaning of beta: (11) has the friction force itself over the amplitude of the load",
         reading([](ProtocolQuestion& q) { q.beta *= std::sqrt(2.0); })},
        {"friction-by-first-harmonic", "11",
         "Friction is 4 / pi times as large: the first harmonic of a square wave is taken for its height.",
         "the meaning of beta: (11) has the friction force itself over the amplitude of the load",
         reading([](ProtocolQuestion& q) { q.beta *= 4 / pi; })},
        {"r-over-first-natural-frequency", "10",
         "r is taken as omega over the first natural frequency; (10) has omega sqrt(m_1 / k_1).",
         "the definition of r: no eigenvalue is in it", reading([](ProtocolQuestion& q) { q.r *= plain_system(q).r_n[0]; })},
        {"r-not-squared", "8", "The mass matrix has gamma_i r where (8) has gamma_i r^2.",
         "the power of r in the non-dimensional mass matrix", reading([](ProtocolQuestion& q) { q.r = std::sqrt(q.r); })},
        {"r-inverted", "10", "r is taken as the natural frequency over that of the load; (10) has it the other way.",
         "the definition of r, and of R_i in (22)", reading([](ProtocolQuestion& q) { q.r = 1 / q.r; })},
        {"friction-sign", "2", "Friction drives the contact: the sign of (2) is the other one.",
         "the sign of the friction force: against the velocity", reading([](ProtocolQuestion& q) { q.beta = -q.beta; })},
        // Mistakes in the parts of a question that only systems beyond the paper have.
        {"second-contact-mass-ignored", "4", "Of a contact between two masses the first alone is taken: it rubs against a wall.",
         "how contact is read where it is a list: friction acts on both masses, with opposite signs",
         reading([](ProtocolQuestion& q) {
             if (q.contact_with == 0) return;
             q.contact_with = 0;
             if (q.mass == 0) q.mass = q.contact;
         })},
        {"relative-displacement-reversed", "5",
         "Of a contact between two masses the displacement of the second less that of the first is taken.",
         "the sign of the contact's displacement: contact [a, b] slides by x_a - x_b, whose maximum is at tau = 0",
         reading([](ProtocolQuestion& q) {
             if (q.contact_with != 0) std::swap(q.contact, q.contact_with);
         })},
        {"loads-normalised", "4", "The forces on the masses are scaled to a vector of unit length.",
         "how load is read where it is a list: its entries are forces in units of P",
         reading([](ProtocolQuestion& q) { multiply(q.loads, 1 / row_of_list(q.loads).norm()); })},
        {"largest-load-only", "4", "Of the forces on the masses the largest alone is taken.",
         "how load is read where it is a list: every entry is the force on its mass", reading([](ProtocolQuestion& q) {
             const auto largest = std::ranges::max_element(q.loads, {}, [](double p) { return std::abs(p); });
             std::fill(q.loads.begin(), largest, 0);
             if (largest != q.loads.end()) std::fill(largest + 1, q.loads.end(), 0);
         })},
        {"base-taken-with-wall", "4",
         "A base that moves alone is taken to move together with the wall: the load is M 1 in place of K 1.",
         "which load base_motion makes: \"alone\" moves the ends of the springs, in absolute displacements",
         of_base("alone", [](ProtocolQuestion& q, const PlainSystem&) { q.base_motion = "with_wall"; })},
        {"base-taken-alone", "4",
         "A base that moves together with the wall is taken to move alone: the load is K 1 in place of M 1.",
         "which load base_motion makes: \"with_wall\" loads every mass by its inertia, in displacements relative to the wall",
         of_base("with_wall", [](ProtocolQuestion& q, const PlainSystem& s) { q.loads = list_of(s.K.rowwise().sum()); })},
        {"base-load-without-masses", "4",
         "A base that moves together with the wall loads every mass by the same force: 1 in place of M 1.",
         "the load of a base that moves: masses times its acceleration",
         of_base("with_wall", [](ProtocolQuestion& q, const PlainSystem&) { q.loads.assign(masses_of(q), 1); })},
        {"load-phases-reversed", "1", "The phases of the forces are taken as lags; a force leads cos(tau) by its phase.",
         "the sign of load_phases: force k is load_k cos(tau + load_phases_k)",
         reading([](ProtocolQuestion& q) { multiply(q.load_phases, -1); })},
        {"load-phases-ignored", "1", "The forces are taken as if they were all in phase.",
         "how load_phases enter the load: each force is a complex amplitude",
         reading([](ProtocolQuestion& q) { q.load_phases.clear(); })},
        {"load-phases-in-degrees", "1", "The phases of the forces are taken for degrees; the protocol has radians.",
         "the unit of load_phases", reading([](ProtocolQuestion& q) { multiply(q.load_phases, pi / 180); })},
        {"base-damper-ignored", "4",
         "A base or wall that moves alone loads the masses by springs without their dampers: r C 1 is missing.",
         "the load of base_motion \"alone\": (K + i r C) 1, and of \"wall\": r^2 M 1 less that",
         of_damped_base([](ProtocolQuestion& q, const PlainSystem& s) { q.loads = list_of(s.p); })},
        {"base-load-taken-real", "4", "The load of a base or wall that moves alone has its size, but not its phase.",
         "where the complex load (K + i r C) 1 becomes real: its parts are for cos(tau) and -sin(tau)",
         of_damped_base([](ProtocolQuestion& q, const PlainSystem& s) {
             for (Index k = 0; k < s.size(); ++k) q.loads.push_back(modulus({s.p[k], s.p_i[k]}));
         })},
        {"wall-taken-with-base", "4",
         "A wall that moves alone loads every mass by its inertia alone: the base, which stays, moves in the frame of the wall.",
         "the load of base_motion \"wall\": r^2 M 1 - (K + i r C) 1",
         of_base("wall", [](ProtocolQuestion& q, const PlainSystem& s) { q.loads = list_of(s.r * s.r * s.M.rowwise().sum()); })},
        {"relative-for-absolute", "4", "Displacements relative to the wall are given for absolute ones.",
         "what is added to the displacements where the wall moves: its own motion, in phase with the cosine of tau",
         adding_frame(0)},
        {"frame-subtracted", "4", "Absolute displacements are the relative ones less the motion of the wall.",
         "the sign with which the motion of the wall is added to the displacements relative to it", adding_frame(-1)},
        {"base-amplitude-of-one", "5",
         "With the wall, the base is taken to move by P / k_1; as P is m_1 omega^2 X there, it moves by 1 / r^2 of that.",
         "what the transmissibility is divided by: the amplitude of the base in the units of the displacements",
         each_changed({"transmissibility"}, [](double x, const ProtocolQuestion& q) { return x * plain_system(q).base; })},
        {"coupling-neglected", "18",
         "Of the damping matrix the diagonal in the modes alone is taken, as (18) has it where the modes are not coupled.",
         "whether psi^T C psi is taken to be diagonal: it is where K M^-1 C = C M^-1 K", reading([](ProtocolQuestion& q) {
             if (q.damping_matrix.empty()) return;
             q.damping_ratios = list_of(plain_system(q).zeta);
             q.damping_matrix.clear();
         })},
        {"dashpots-between-masses-ignored", "19", "Of the damping matrix the diagonal alone is taken.",
         "the entries of the damping matrix off its diagonal: a dashpot between two masses couples them",
         reading([](ProtocolQuestion& q) {
             const std::size_t N = masses_of(q);
             for (std::size_t n = 0; n < q.damping_matrix.size(); ++n)
                 if (n % (N + 1) != 0) q.damping_matrix[n] = 0;
         })}};
}

} // namespace denhartog::conformance
