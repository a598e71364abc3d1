// Results that the paper reads off the last period of an integration, step by step: amplitudes, phases, samples.
#pragma once

#include <functional>
#include <vector>

#include "denhartog/paper_algorithm/detail/dense_step.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"

namespace denhartog {

// A displacement over a stretch of time.
struct DisplacementRange {
    double amplitude = 0; // largest size
    double smallest = 0;  // smallest value, with its sign
    double largest = 0;   // largest value, with its sign
    double instant = 0;   // where it is largest
    bool empty = true;    // nothing was seen yet

    void take(double x, double tau);
};

// A displacement of those of the masses, or a velocity of theirs.
using DisplacementOf = std::function<double(const double*)>;

// Takes the extrema of a displacement from theta = `from` to `to` of a step that starts at tau into account: they are at the ends
// or where the velocity changes sign. `zeros` is working space.
void take_extrema(DenseStep& step, const DisplacementOf& of, double tau, double from, double to, std::vector<double>& zeros,
                  DisplacementRange& range);

// Gathers the last period.
class LastPeriod {
public:
    // A contact between two masses has a place behind the masses. It must outlive this.
    LastPeriod(std::size_t N, double start, int samples, const Contact& contact);

    // Takes a step from tau into account, or its part before an event, up to theta = `to`.
    void take(DenseStep& step, double tau, double to);

    // Takes a rest of the contact at x into account; `last` where it was ended by the final time.
    void take_rest(double from, double to, double x, bool last);

    // Writes masses, stops and samples.
    void write(PaperMotion& motion) const;

private:
    double start_;
    const Contact* contact_;
    std::vector<DisplacementRange> ranges_; // of all displacements
    std::vector<Stop> stops_;
    bool rests_ = false;
    bool slides_throughout_ = true;
    std::vector<double> sample_times_;
    std::vector<State> samples_;
    std::vector<double> zeros_, y_;
};

} // namespace denhartog
