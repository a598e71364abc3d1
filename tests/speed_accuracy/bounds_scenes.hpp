/// @file
/// @brief Seeded scenes of the survey of bounds.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "denhartog/sliding/bounded_modes.hpp"

namespace denhartog::tests {

/// @brief A frequency ratio and what it was chosen for.
struct SurveyedFrequency {
    double r;         ///< frequency ratio
    std::string kind; ///< e.g. `near a resonance`
};

/// @brief Seeded systems and points, the same on every machine up to its library's power function.
class BoundsScenes {
public:
    /// @param seed  any number
    explicit BoundsScenes(std::uint64_t seed) : bits_(seed) {}

    /// @brief A chain or, one time in four, a system of any topology, of 1 to 12 masses. @return the system
    System<double> system();
    /// @brief A frequency ratio: any, near a resonance, or near a pole that a mode without damping would have.
    /// @param basis  the system's modes
    /// @return       r, and which of these
    SurveyedFrequency frequency(const ModalBasis<Bounded<double>>& basis);
    /// @brief A friction ratio. @param beta_lim the boundary @return a part of it, a neighbour of it, or any
    double friction(double beta_lim);
    /// @brief An instant. @return from 0 to 4 pi, at times a multiple of pi
    double instant();
    /// @brief A chance. @param n how rare @return true one time in n
    bool one_in(int n) { return whole(0, n - 1) == 0; }

private:
    double uniform(double low, double high) { return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53; }
    int whole(int low, int high) { return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1)); }
    double spread(double low, double high);
    double near_one(double low, double high);
    std::vector<double> damping(std::size_t N);

    std::mt19937_64 bits_;
};

/// @brief A scene in numbers from which it can be had again. @param scene the scene @param tau the instant @return its text
[[nodiscard]] std::string text_of(const Scene<double>& scene, double tau);

} // namespace denhartog::tests
