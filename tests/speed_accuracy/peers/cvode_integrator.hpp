/// @file
/// @brief CVODE with the events of sliding and sticking, its headers kept away.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "denhartog/paper_algorithm/contact_equations.hpp"
#include "tests/speed_accuracy/peers/peer.hpp"

namespace denhartog::tests {

/// @brief CVODE, Adams' methods, with its root finding at the ends of sliding and sticking, at rest at tau = 0. While the contact
/// sticks, the extrema of the load on it are roots too.
///
/// A step is at most a sixteenth of a period long: while the contact of a single mass sticks no error bounds it, and whole
/// periods would be skipped. Ends of phases restart the integrator.
class CvodeIntegrator {
public:
    /// @brief The tolerance is absolute and relative.
    CvodeIntegrator(const ContactProblem& problem, double tolerance);
    ~CvodeIntegrator();
    CvodeIntegrator(const CvodeIntegrator&) = delete;
    CvodeIntegrator& operator=(const CvodeIntegrator&) = delete;

    /// @brief Goes back to tau = 0. @param y displacements and velocities there
    void restart(const std::vector<double>& y);

    /// @brief Sees an instant: tau, the state, and the sign of the contact's velocity from there on, 0 where it sticks.
    using Seen = std::function<void(double tau, std::span<const double> y, int direction)>;

    /// @brief One period of the force. At the start, and at the ends of so many equal parts and of phases, `seen` is called. It
    /// ends as answered, stalled, did_not_finish or not_a_number.
    Ending period(int parts, const Seen& seen);

    /// @brief The state. @return displacements, then velocities
    [[nodiscard]] std::span<const double> state() const;

    /// @brief Work so far. @return right-hand sides evaluated, those for roots among them
    [[nodiscard]] long evaluations() const;

private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

} // namespace denhartog::tests
