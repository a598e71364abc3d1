/// @file
/// @brief Siconos behind plain numbers: its headers are older than C++20.
#pragma once

#include <memory>
#include <vector>

namespace denhartog::tests {

/// @brief A system under cos(tau) with dry friction on one mass, advanced by steps of one length.
class SiconosSteps {
public:
    /// @param M, C, K  matrices, row by row, N x N
    /// @param contact  the mass in contact, from 0
    /// @param load     the loaded mass, from 0
    /// @param beta     friction ratio
    /// @param step     length of a step, in tau
    /// @param steps    how many steps there will be at most
    /// @param start    displacements and velocities at tau = 0; rest at zero where it is empty
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
