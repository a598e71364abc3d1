/// @file
/// @brief Siconos behind plain numbers: its headers are older than C++20.
#pragma once

#include <memory>
#include <vector>

namespace denhartog::tests {

/// @brief A system under cos(tau) with dry friction on one mass, advanced by steps of one length.
class SiconosSteps {
public:
    /// @brief Of matrices row by row, masses counted from 0, the length of a step in tau, and the most steps that there will be.
    /// The start has displacements and velocities at tau = 0; where it is empty it is rest at zero.
    SiconosSteps(const std::vector<double>& M, const std::vector<double>& C, const std::vector<double>& K, unsigned contact,
                 unsigned load, double beta, double step, long steps, const std::vector<double>& start = {});
    ~SiconosSteps();

    /// @brief One step. @param state gets displacements, then velocities
    void advance(std::vector<double>& state);

private:
    struct Simulation;
    std::unique_ptr<Simulation> simulation_;
};

} // namespace denhartog::tests
