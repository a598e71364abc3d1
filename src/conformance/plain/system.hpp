// The system of a question in the units of the paper: r^2 M x'' + r C x' + K x = p cos(tau) - p_i sin(tau) - beta w sgn(w x').
#pragma once

#include "conformance/plain/linear.hpp"
#include "conformance/question.hpp"

namespace denhartog::conformance {

// A question has no answer here: there is no such mass, or no steady motion of one period was found.
struct NoPlainAnswer {};

struct PlainSystem {
    PlainMatrix M, K, C;     // (8), (73), (19)
    PlainRow w, p, p_i;      // rows of the contact and the load; p_i leads by a quarter of a period, zeros if all is in phase
    double base = 0;         // amplitude of the base or wall that moves, units of P / k_1
    bool base_stays = false; // whether the wall alone moves
    double frame = 0;        // how far the frame of the displacements moves with it: x + frame cos(tau) are absolute
    double r = 0, beta = 0, mu = 1;
    PlainShapes shapes;   // with natural frequency ratios
    PlainRow zeta;        // modal damping ratios; the diagonal where damping couples the modes
    bool coupled = false; // whether it does

    [[nodiscard]] std::size_t size() const { return M.size(); }
};

// The row of one mass, counted from 1. Throws NoPlainAnswer if there is no such mass.
[[nodiscard]] PlainRow place_of(int mass, std::size_t N);

// Throws NoPlainAnswer.
[[nodiscard]] PlainSystem plain_system(const ProtocolQuestion& q);

// The response to the load at the frequency of the question, V_dk without friction; or to a force on the contact.
[[nodiscard]] std::vector<Phasor> plain_response(const PlainSystem& s);
[[nodiscard]] std::vector<Phasor> plain_response_to_contact(const PlainSystem& s);

// V_dk and the motion of the frame, without their difference: what springs and dampers hand on of a base that moves. A wall moves
// no mass but by friction.
[[nodiscard]] std::vector<Phasor> plain_response_from_ground(const PlainSystem& s);

// The response with the contact held at zero; behind the masses the force that holds it.
[[nodiscard]] std::vector<Phasor> held_response(const PlainSystem& s);

// A chain cut out of a chain between two of its masses, counted from 0, the second left out; the masses beyond are held.
struct PlainPart {
    PlainMatrix M, K, C;
    PlainMatrix springs; // the square root of K, a row for each spring
};
[[nodiscard]] PlainPart part_of(const ProtocolQuestion& q, const PlainSystem& s, std::size_t from, std::size_t to);

} // namespace denhartog::conformance
