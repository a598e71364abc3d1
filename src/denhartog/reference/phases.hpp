// The motion of a scene with one contact, phase by phase. The mechanics (6) are three matrices: for sliding forward, for sliding
// back and for sticking. A phase is followed by the exponential of its matrix; by its modes (20) while it slides, if damping
// leaves these by themselves; or by its free motions, if it is long beside the fastest of them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "denhartog/reference/modes.hpp"
#include "denhartog/reference/series.hpp"

namespace denhartog::reference {

// The binary logarithm of a positive number, to a few units in its last place.
[[nodiscard]] inline double binary_logarithm(double x) { return elementary::log(x) / elementary::log(2); }

// The free motions of z' = B z, if its eigenvalues are proved simple: e^(B tau) is the sum of r_i e^(lambda_i tau) l_i^T.
class FreeMotions {
public:
    explicit FreeMotions(const BallMatrix& B, Effort* effort = nullptr);

    // Whether every eigenvalue is proved simple.
    [[nodiscard]] bool are_simple() const { return simple_; }
    [[nodiscard]] const ComplexBall& lambda(std::size_t i) const { return lambda_[i]; }
    // The share of each free motion in a state, l_i^T z.
    [[nodiscard]] std::vector<ComplexBall> shares_of(const BallMatrix& z) const;
    // Weights of the free motions in a number, a row over states: of the real and the imaginary part of each in turn.
    [[nodiscard]] std::vector<Ball> weights(const BallMatrix& row, const std::vector<ComplexBall>& shares) const;
    // The state that shares of the free motions have come to at a time.
    [[nodiscard]] BallMatrix state(std::vector<ComplexBall> shares, const Ball& t) const;
    // The free motions in time: real and imaginary part of each in turn.
    [[nodiscard]] std::shared_ptr<Remembered<std::vector<Series>>> in_time() const;

private:
    std::vector<ComplexBall> lambda_{}, L_{}, R_{}; // eigenvalues, left and right vectors, row by row
    bool simple_ = false;
    Effort* effort_;
};

// A number that changes in time, counted from the start of a phase.
using NumberInTime = std::function<Series(const Ball& t)>;

struct ContactMechanics;

// All phases of one kind by their free motions: the contact slides in one direction, or sticks.
//
// The coordinates y are those of the state that move freely: all while the contact slides; while it sticks all but those of the
// mass on which w is largest, which follow from the others. They obey y' = B y + G u, where u is (cos tau, sin tau, 1, w^T x).
class PhasesByFreeMotions {
public:
    // Throws Unproved if free motions are not proved distinct, or the force may be in resonance with one without damping.
    PhasesByFreeMotions(const ContactMechanics& s, int direction);

    // The state at the end of a phase.
    [[nodiscard]] BallMatrix state(const BallMatrix& Z, const Ball& length) const;
    // The matrix that takes any state to the end of a phase.
    [[nodiscard]] BallMatrix propagator(const Ball& length) const;
    // A number, a row over Z, in a phase that starts from Z.
    [[nodiscard]] NumberInTime number(const BallMatrix& row, const BallMatrix& Z) const;
    // Whether every free motion is certainly damped.
    [[nodiscard]] bool die_out() const;

private:
    struct OverCoordinates {
        BallMatrix y, u; // a row over Z as rows over y and u
    };
    [[nodiscard]] OverCoordinates taken_apart(const BallMatrix& row) const;
    [[nodiscard]] BallMatrix inputs(const BallMatrix& Z) const;
    [[nodiscard]] std::vector<ComplexBall> shares_at(const BallMatrix& Z, const BallMatrix& u) const;

    slong N_, lead_;
    bool slides_;
    BallMatrix w_;
    std::vector<slong> place_{};                                 // of the coordinates in Z
    BallMatrix forced_{};                                        // what y is without free motions, over u
    std::unique_ptr<FreeMotions> free_{};                        // of B
    std::shared_ptr<Remembered<std::vector<Series>>> in_time_{}; // the free motions
};

// The mechanics of a scene. The state Z = (x, x'/sigma, cos tau, sin tau, 1) obeys Z' = A Z in every phase; the unit sigma brings
// the entries of A to one size.
struct ContactMechanics {
    explicit ContactMechanics(const SceneInBalls& scene);

    slong N;
    Ball sigma{};
    BallMatrix w;     // w^T x is the displacement of the contact, N x 1
    BallMatrix free;  // A without friction, n x n
    BallMatrix load;  // minus the sum in (75): all forces on a contact at rest but friction, as a row over Z
    BallMatrix stuck; // A while the contact sticks
    BallMatrix push;  // what a unit force on the contact adds to x'' / sigma, N x 1
    Ball beta{};      // friction while the contact slides
    Ball holds{};     // friction up to which it sticks, mu beta
    bool equal;       // mu = 1
    bool on_a_wall;   // whether the contact is of one mass, on a wall: its row vanishes while it sticks, to the last bit
    slong lead;       // the mass on which w is largest
    std::optional<ModesInBalls> sliding{}; // none unless modes below critical damping move by themselves, proved distinct
    BallMatrix shapes{}, from_state{};     // of these: psi_ki, and its inverse, by (17)
    Effort* effort;
    slong bits = ball_bits; // of the scene
    // For each direction, found when first needed.
    mutable std::optional<std::shared_ptr<PhasesByFreeMotions>> free_motions[3] = {};

    // The length of a state.
    [[nodiscard]] slong n() const { return 2 * N + 3; }
    // The matrix A of a phase: direction 1 or -1 while the contact slides, against a constant friction, 0 while it sticks.
    [[nodiscard]] BallMatrix phase(int direction) const;
    // The matrix that takes any state through a part of a phase, e^(A h).
    [[nodiscard]] BallMatrix propagator(int direction, const Ball& h) const;
    // States at the end of a phase of sliding by the modes, a column each, from those at its start.
    [[nodiscard]] BallMatrix after_sliding(const BallMatrix& Z, const Ball& length, int direction) const;
    // Phases of a kind by their free motions; null if these are not proved distinct, or the force may excite an undamped one.
    [[nodiscard]] const std::shared_ptr<PhasesByFreeMotions>& by_free_motions(int direction) const;
    // Displacement and velocity of the contact, w^T x and w^T x' / sigma, as rows over Z.
    [[nodiscard]] BallMatrix place() const;
    [[nodiscard]] BallMatrix speed() const;
    // The number that is zero at the end of a phase, as a row over Z: the velocity of a contact that slides, or the load on one
    // that sticks less static friction, (74). The directions are those of the phases before and after.
    [[nodiscard]] BallMatrix ending(int before, int after) const;

private:
    void find_sliding(const SceneInBalls& scene);
};

} // namespace denhartog::reference
