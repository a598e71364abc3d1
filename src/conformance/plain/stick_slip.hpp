// The motion of a contact that slides and rests, from event to event: between two events the equations are linear.
#pragma once

#include "conformance/plain/friction_response.hpp"

namespace denhartog::conformance {

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
