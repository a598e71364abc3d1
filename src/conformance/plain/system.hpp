// The system of a question in the units of the paper, r^2 M x'' + r C x' + K x = p cos(tau) - p_i sin(tau) - beta w sgn(w x'),
// with the linear algebra for it by loops over lists of doubles; and its motions without any modes: the steady response to
// friction that changes its sign every half-period, and the motion of a contact that slides and rests, from event to event.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "conformance/question.hpp"

namespace denhartog::conformance {

using PlainRow = std::vector<double>;
using PlainMatrix = std::vector<PlainRow>; // by rows

// An amplitude: the real part of (re + i im) exp(i tau).
struct Phasor {
    double re = 0, im = 0;
};

[[nodiscard]] double modulus(const Phasor& a);
[[nodiscard]] double argument(const Phasor& a);
[[nodiscard]] double times_cosine(const Phasor& a, double tau); // real part of a exp(i tau)
[[nodiscard]] double dot(const PlainRow& a, const PlainRow& b); // over the length of a
[[nodiscard]] Phasor dot(const PlainRow& a, const std::vector<Phasor>& b);
[[nodiscard]] PlainRow times(const PlainMatrix& A, const PlainRow& x);
[[nodiscard]] PlainMatrix times(const PlainMatrix& A, const PlainMatrix& B);
[[nodiscard]] PlainMatrix transposed(const PlainMatrix& A);
[[nodiscard]] PlainMatrix square(std::size_t n); // of zeros

// The solution of a system of equations, by elimination with pivots. Not finite where the matrix is singular.
[[nodiscard]] PlainRow solved(PlainMatrix A, PlainRow b);

// The amplitudes X of (A + i B) X = b + i b_i.
[[nodiscard]] std::vector<Phasor> solved(const PlainMatrix& A, const PlainMatrix& B, const PlainRow& b, const PlainRow& b_i);

// The lower triangle L with L L^T = A.
[[nodiscard]] PlainMatrix triangle_of(const PlainMatrix& A);

// Natural frequencies, ascending, and the columns phi with phi^T M phi = 1.
struct PlainShapes {
    PlainRow r_n;
    PlainMatrix phi;
};

// Modes of the stiffness matrix B^T B, by rotations of the columns of B L^-T until they are orthogonal (Jacobi); L L^T = M.
[[nodiscard]] PlainShapes shapes_of(const PlainMatrix& B, const PlainMatrix& M);

// Of z' = A z: z(dt) - z(0), by the series of the exponential; z(dt); and the matrix that makes it of z(0).
[[nodiscard]] PlainRow increment(const PlainMatrix& A, const PlainRow& z, double dt);
[[nodiscard]] PlainRow moved(const PlainMatrix& A, const PlainRow& z, double dt);
[[nodiscard]] PlainMatrix propagator(const PlainMatrix& A, double dt);

// Where a function changes its sign between two places; the second where it does not.
[[nodiscard]] double zero_between(const std::function<double(double)>& f, double from, double to);

// A question has no answer here: there is no such mass, or no steady motion of one period was found.
struct NoPlainAnswer {};

struct PlainSystem : PlainShapes {
    PlainMatrix M, K, C;     // (8), (73), (19)
    PlainRow w, p, p_i;      // rows of the contact and the load; p_i leads by a quarter of a period, zeros if all is in phase
    double base = 0;         // amplitude of the base or wall that moves, units of P / k_1
    bool base_stays = false; // whether the wall alone moves
    double frame = 0;        // how far the frame of the displacements moves with it: x + frame cos(tau) are absolute
    double r = 0, beta = 0, mu = 1;
    PlainRow zeta;        // modal damping ratios; the diagonal where damping couples the modes
    bool coupled = false; // whether it does

    [[nodiscard]] std::size_t size() const { return M.size(); }
};

// The row of one mass, counted from 1. Throws NoPlainAnswer if there is no such mass.
[[nodiscard]] PlainRow place_of(int mass, std::size_t N);

// Throws NoPlainAnswer.
[[nodiscard]] PlainSystem plain_system(const ProtocolQuestion& q);

// The response at the frequency of the question to the forces b cos(tau) - b_i sin(tau); to the load it is V_dk without friction.
[[nodiscard]] std::vector<Phasor> plain_response(const PlainSystem& s, const PlainRow& b, const PlainRow& b_i);

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

// A displacement and its rate.
struct PlainMotion {
    double x = 0; // displacement, units of P / k_1
    double v = 0; // its derivative in tau
};

// A of z' = A z, where z has the displacements, their rates, cos(tau), sin(tau) and the friction force beta sgn(w x'). With the
// contact held the last entry is beta, and no other entry of z depends on it.
[[nodiscard]] PlainMatrix equations_of(const PlainSystem& s, bool held);

// The weights of a row as weights of a state: of its displacements, from 0 on, or of its rates, from N on.
[[nodiscard]] PlainRow in_state(const PlainRow& row, std::size_t from);

// Steps in a period that show every oscillation and decay of the modes.
[[nodiscard]] int steps_of(const PlainSystem& s);

// The motion F that a unit of friction adds in (46), and the functions (34), (35) and (64), between 0 and pi.
class FrictionResponse {
public:
    explicit FrictionResponse(const PlainSystem& s);

    // A row of weights of the masses: its displacement, and its rate less what that is at the start.
    [[nodiscard]] PlainMotion at(const PlainRow& row, double tau) const;
    [[nodiscard]] double rate_gained(const PlainRow& row, double tau) const;
    [[nodiscard]] double acceleration_at_start(const PlainRow& row) const;

private:
    PlainMatrix A;
    double step;
    std::vector<PlainRow> nodes; // states at equal steps from 0 to pi
};

// A stretch between two events. Its states stand at equal steps from its start on, and one at its end.
struct PlainStretch {
    int direction = 0;                               // sign of the velocity of the contact; 0 where it rests
    std::vector<std::pair<double, PlainRow>> states; // instants and states, see `equations_of`

    [[nodiscard]] double start() const { return states.front().first; }
    [[nodiscard]] double end() const { return states.back().first; }
};

// Motions of one system, a period of the force at a time.
class PlainContact {
public:
    // Throws NoPlainAnswer.
    explicit PlainContact(const ProtocolQuestion& q);

    // Goes on for a period, from rest at first.
    void run();

    // Goes on until a motion of one period is reached, and runs that period, or until the contact rests in many periods. Throws
    // NoPlainAnswer if none is found.
    void settle();

    // Whether the contact rests throughout the last period.
    [[nodiscard]] bool rests() const { return period.size() == 1 && period.front().direction == 0; }

    // Of the last period: displacements at equal steps from the maximum of the force on; where the row of weights is at its
    // largest, with the value, in a frame that moves by frame cos(tau); lengths of the stops, ascending.
    [[nodiscard]] PlainRow samples(const PlainRow& row, int count) const;
    [[nodiscard]] std::pair<double, double> largest(const PlainRow& row, double frame = 0) const;
    [[nodiscard]] PlainRow stops() const;

    PlainSystem system;

private:
    PlainMatrix slipping, resting, of_slipping, of_resting; // equations, and what a step makes of a state
    PlainRow pull, load;                                    // acceleration by a force on the contact; the force to hold it
    double step;
    PlainRow now;      // the state at the end of the last period
    int direction = 0; // of the contact there
    std::vector<PlainStretch> period;

    void start_again(PlainRow& z, bool may_rest);
    [[nodiscard]] PlainStretch stretch(double from, PlainRow z) const;
    [[nodiscard]] std::optional<PlainRow> by_newton() const;
    [[nodiscard]] const PlainMatrix& equations(int of) const { return of == 0 ? resting : slipping; }
};

} // namespace denhartog::conformance
