// The system of a question in the units of the paper, r^2 M x'' + r C x' + K x = p cos(tau) - p_i sin(tau) - beta w sgn(w x'),
// and its motions without any modes: the steady response to friction that changes its sign every half-period, and the motion of a
// contact that slides and rests, from event to event.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include "conformance/question.hpp"

namespace denhartog::conformance {

using Eigen::Index;
using PlainVector = Eigen::VectorXd;
using PlainMatrix = Eigen::MatrixXd;
// An amplitude: the real part of a exp(i tau). It is multiplied by real numbers only, and `modulus` and `argument` give its size
// and angle: products and functions of std::complex have other digits on other machines.
using Phasor = std::complex<double>;
using Phasors = Eigen::VectorXcd;

[[nodiscard]] double modulus(const Phasor& a);
[[nodiscard]] double argument(const Phasor& a);
[[nodiscard]] double times_cosine(const Phasor& a, double tau); // real part of a exp(i tau)

// The solution of a system of equations, by elimination with pivots. Not finite where the matrix is singular.
[[nodiscard]] PlainVector solved(const PlainMatrix& A, const PlainVector& b);

// The amplitudes X of (A + i B) X = b + i b_i.
[[nodiscard]] Phasors solved(const PlainMatrix& A, const PlainMatrix& B, const PlainVector& b, const PlainVector& b_i);

// Natural frequencies, ascending, and the columns phi with phi^T M phi = 1.
struct PlainShapes {
    PlainVector r_n;
    PlainMatrix phi;
};

// Modes of the stiffness matrix B^T B: singular values and vectors of B L^-T with L L^T = M, by Jacobi's rotations. Frequencies
// down to 1e-15 of the highest keep their digits.
[[nodiscard]] PlainShapes shapes_of(const PlainMatrix& B, const PlainMatrix& M);

// Where a function changes its sign between two places; `to` where it does not.
[[nodiscard]] double zero_between(const std::function<double(double)>& f, double from, double to);

// A question has no answer here: there is no such mass, or no steady motion of one period was found.
struct NoPlainAnswer {};

struct PlainSystem : PlainShapes {
    PlainMatrix M, K, C;     // (8), (73), (19)
    PlainVector w, p, p_i;   // rows of the contact and the load; p_i leads by a quarter of a period, zeros if all is in phase
    double base = 0;         // amplitude of the base or wall that moves, units of P / k_1
    bool base_stays = false; // whether the wall alone moves
    double frame = 0;        // how far the frame of the displacements moves with it: x + frame cos(tau) are absolute
    double r = 0, beta = 0, mu = 1;
    PlainVector zeta;     // modal damping ratios; the diagonal where damping couples the modes
    bool coupled = false; // whether it does

    [[nodiscard]] Index size() const { return M.rows(); }
    [[nodiscard]] PlainMatrix dynamic_stiffness() const { return K - r * r * M; }
};

// A list of numbers as a row, and a row as a list.
[[nodiscard]] PlainVector row_of_list(const std::vector<double>& list);
[[nodiscard]] inline std::vector<double> list_of(const PlainVector& row) { return {row.begin(), row.end()}; }

// The row of one mass, counted from 1. Throws NoPlainAnswer if there is no such mass.
[[nodiscard]] PlainVector place_of(int mass, Index N);

// Throws NoPlainAnswer.
[[nodiscard]] PlainSystem plain_system(const ProtocolQuestion& q);

// The damping matrix that has this diagonal in the modes, and nothing beside it; the momenta are M phi.
[[nodiscard]] PlainMatrix damping_in_modes(const PlainMatrix& momenta, const PlainVector& of_modes);

// The response at the frequency of the question to the forces b cos(tau) - b_i sin(tau); to the load it is V_dk without friction.
[[nodiscard]] Phasors plain_response(const PlainSystem& s, const PlainVector& b, const PlainVector& b_i);

// V_dk and the motion of the frame, without their difference: what springs and dampers hand on of a base that moves. A wall moves
// no mass but by friction.
[[nodiscard]] Phasors plain_response_from_ground(const PlainSystem& s);

// The response with the contact held at zero; behind the masses the force that holds it.
[[nodiscard]] Phasors held_response(const PlainSystem& s);

// The springs of a chain between two of its masses, counted from 0, the second left out, the masses beyond held: each as
// sqrt(kappa) times its elongation, a row of B, where B^T B is their stiffness matrix.
[[nodiscard]] PlainMatrix springs_of(const std::vector<double>& kappa, Index from, Index to);

// A displacement and its rate.
struct PlainMotion {
    double x = 0; // displacement, units of P / k_1
    double v = 0; // its derivative in tau
};

// The motion F that a unit of friction adds in (46), and the functions (34), (35) and (64), between 0 and pi.
class FrictionResponse {
public:
    explicit FrictionResponse(const PlainSystem& s);

    // A row of weights of the masses: its displacement, and its rate less what that is at the start.
    [[nodiscard]] PlainMotion at(const PlainVector& row, double tau) const;
    [[nodiscard]] double rate_gained(const PlainVector& row, double tau) const;
    [[nodiscard]] double acceleration_at_start(const PlainVector& row) const;

private:
    PlainMatrix A;
    double step;
    std::vector<PlainVector> nodes; // states at equal steps from 0 to pi
};

// A stretch between two events. Its states stand at equal steps from its start on, and one at its end.
struct PlainStretch {
    int direction = 0;                                  // sign of the velocity of the contact; 0 where it rests
    std::vector<std::pair<double, PlainVector>> states; // instants and states

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
    [[nodiscard]] std::vector<double> samples(const PlainVector& row, int count) const;
    [[nodiscard]] std::pair<double, double> largest(const PlainVector& row, double frame = 0) const;
    [[nodiscard]] std::vector<double> stops() const;

    PlainSystem system;

private:
    PlainMatrix slipping, resting, of_slipping, of_resting; // equations, and what a step makes of a state
    PlainVector pull, load;                                 // acceleration by a force on the contact; the force to hold it
    double step;
    PlainVector now;   // the state at the end of the last period
    int direction = 0; // of the contact there
    std::vector<PlainStretch> period;

    void start_again(PlainVector& z, bool may_rest);
    [[nodiscard]] PlainStretch stretch(double from, PlainVector z) const;
    [[nodiscard]] std::optional<PlainVector> by_newton() const;
    [[nodiscard]] const PlainMatrix& equations(int of) const { return of == 0 ? resting : slipping; }
};

} // namespace denhartog::conformance
