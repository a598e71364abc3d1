/// @file
/// @brief What the paper reads off the last period of an integration, step by step: amplitudes, phases, samples.
#pragma once

#include <functional>
#include <vector>

#include "denhartog/paper_algorithm/dense_step.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"

namespace denhartog {

/// @brief A displacement over a stretch of time.
struct DisplacementRange {
    double amplitude = 0; ///< largest size
    double smallest = 0;  ///< smallest value, with its sign
    double largest = 0;   ///< largest value, with its sign
    double instant = 0;   ///< where it is largest
    bool empty = true;    ///< nothing was seen yet

    /// @brief Takes a value into account. @param x the value @param tau its instant
    void take(double x, double tau);
};

/// @brief A displacement of those of the masses, or a velocity of theirs.
using DisplacementOf = std::function<double(const double*)>;

/// @brief Takes the extrema of a displacement over a part of a step into account.
///
/// They are at the ends or where the velocity changes sign.
/// @param step   the step
/// @param of     the displacement
/// @param tau    time at the start of the step
/// @param from   theta where the part starts
/// @param to     theta where it ends
/// @param zeros  working space
/// @param range  gets the extrema
void take_extrema(DenseStep& step, const DisplacementOf& of, double tau, double from, double to, std::vector<double>& zeros,
                  DisplacementRange& range);

/// @brief Gathers the last period.
class LastPeriod {
public:
    /// @param N        number of masses
    /// @param start    its start
    /// @param samples  number of instants to sample
    /// @param contact  the contact; between two masses it has a place behind the masses. It must outlive this
    LastPeriod(std::size_t N, double start, int samples, const Contact& contact);

    /// @brief Takes a step, or the part of one before an event, into account.
    /// @param step  the step
    /// @param tau   time at its start
    /// @param to    theta up to which it counts
    void take(DenseStep& step, double tau, double to);

    /// @brief Takes a rest of the contact into account.
    /// @param from  time at its start
    /// @param to    time at its end
    /// @param x     where it rests
    /// @param last  whether it was ended by the final time
    void take_rest(double from, double to, double x, bool last);

    /// @brief Writes what was gathered. @param motion gets masses, stops and samples
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
