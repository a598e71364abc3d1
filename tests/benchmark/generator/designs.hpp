/// @file
/// @brief The scenes of the benchmark as they were chosen: systems, and where friction lies between the regimes' boundaries.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "denhartog/scene/scene.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::benchmark {

/// @brief What the friction of a scene is measured by.
enum class Measure : std::uint8_t {
    sliding,  ///< a part of the largest friction with which the contact slides throughout
    between,  ///< a part of the way from there to the least friction that holds it for ever
    sticking, ///< a part of the least friction that holds it for ever
    given     ///< the friction itself
};

/// @brief A scene as it was chosen. The first mass is 1 kg, the first spring 1 N/m, the load 1 N, so that numbers in SI units
/// are those of the paper, and the frequency of the load in rad/s is its frequency ratio.
struct Design {
    std::string id;        ///< name of the scene
    std::vector<double> m; ///< masses, kg, N values
    std::vector<double> k; ///< springs, kg/s^2, N values
    double a;              ///< damping by the masses: dashpots a m_i to the ground, 1/s
    double b;              ///< damping by the springs: dashpots b k_i beside them, s
    int contact;           ///< the mass in contact, j, from 1
    int load;              ///< the loaded mass, l, from 1
    double mu;             ///< static over kinetic friction, Eq. (3)
    double omega;          ///< frequency of the load, rad/s
    Measure measure;       ///< what `part` is a part of
    double part;           ///< how much
};

/// @brief All scenes. @return the scenes, from one mass to five
[[nodiscard]] std::vector<Design> designs();

/// @brief The friction that part the regimes at a scene, in N.
struct Onsets {
    Real50 sliding;  ///< below it the contact slides throughout, (69)
    Real50 sticking; ///< from it on the contact may rest for ever, as corrected from (88)
};

/// @brief The library's scene. @param d a scene @param F kinetic friction, N @return the scene
[[nodiscard]] Scene<double> scene_of(const Design& d, double F);

/// @brief Both boundaries by the closed form in 50 digits. @param d a scene @return the boundaries
[[nodiscard]] Onsets onsets_of(const Design& d);

/// @brief The same from the physical coordinates: half a period that mirrors itself, and a dense system with the contact held.
/// @param d  a scene
/// @return   the boundaries
[[nodiscard]] Onsets onsets_of_half_period(const Design& d);

/// @brief Kinetic friction of a scene: rounded to 10 bits, or to a double where it lies next to a boundary.
/// @param d       the scene
/// @param onsets  the boundaries
/// @return        F, N
[[nodiscard]] double friction_of(const Design& d, const Onsets& onsets);

} // namespace denhartog::benchmark
