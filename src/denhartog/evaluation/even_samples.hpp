/// @file
/// @brief A linear motion at evenly spaced instants: a recurrence over arrays, and what it loses.
///
/// A coordinate s that moves freely about its rest goes on by the same step whatever its state: with the free motions (A.8),
/// (A.9) over the step h
/// \f[ s(\tau+h) = d\,s + Rq\,s' + (1-d)\,\mathrm{rest}, \qquad s'(\tau+h) = d'\,s + Rq'\,s' - d'\,\mathrm{rest}. \f]
/// Every 64 steps at most it starts anew, from the same formula over the whole time from its start. In \f$ (s, Rs') \f$ no step
/// moves two states apart, so that what each step is off by adds up: in both numbers at most 5 eps (1 + h/R) of
/// \f$ |s| + R|s'| + |\mathrm{rest}| \f$, 4 for the entries and 1 for the sum. The rounding of time and a new start take 16 eps
/// (1 + T/R) of it by the time T.
#pragma once

#include <cstddef>
#include <vector>

namespace denhartog::evaluation {

/// @brief A coordinate that moves freely about its rest, from its state at the start. @eq{A.8}
struct FreeCoordinate {
    double R;       ///< modal frequency ratio, Eq. (22)
    double zeta;    ///< modal damping ratio
    double w;       ///< as `w_if_oscillating` has it
    double rest;    ///< where it would come to rest
    double s_0;     ///< its value at the start
    double s_prime; ///< its derivative in tau at the start
};

/// @brief A motion of masses: \f$ x_k = \mathrm{constant}_k + A_k\cos\tau + B_k\sin\tau + \sum_i \mathrm{shape}_{ki}s_i \f$.
struct LinearSum {
    double start;                            ///< tau at which the coordinates start
    std::vector<FreeCoordinate> coordinates; ///< s_i
    std::vector<double> shapes;              ///< of the coordinates, mass by coordinate
    std::vector<double> constant;            ///< of each mass
    std::vector<double> A;                   ///< of each mass
    std::vector<double> B;                   ///< of each mass
    std::vector<double> harmonic;            ///< of each mass, the size of the terms that A and B are sums of
};

/// @brief Evenly spaced instants.
struct EvenInstants {
    double first;      ///< tau of the first
    double step;       ///< from one to the next
    std::size_t count; ///< how many
};

/// @brief Bounds of errors of a displacement and of its velocity.
struct ErrorOfSamples {
    double x;       ///< of the displacement
    double x_prime; ///< of the velocity
};

/// @brief A bound of \f$ |s| + R|s'| \f$, and of what a step rounds relative to, over a time from the start: by the energy of
/// \f$ s-\mathrm{rest} \f$, which never grows, or where R is large by its acceleration.
[[nodiscard]] double largest_size(const FreeCoordinate& c, double time);

/// @brief Loss of the samples of each mass to rounding, from the numbers of the motion.
[[nodiscard]] std::vector<ErrorOfSamples> loss_of_samples(const LinearSum& motion, const EvenInstants& instants);

/// @brief Displacements and velocities at the instants, none before the start: all masses at the first, then at the next.
void even_samples(const LinearSum& motion, const EvenInstants& instants, double* x, double* x_prime);

} // namespace denhartog::evaluation
