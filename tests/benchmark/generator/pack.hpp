/// @file
/// @brief The benchmark's pack as files: scenes with their certified motions as JSON and CSV, and a manifest.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/benchmark/generator/designs.hpp"
#include "tests/benchmark/generator/motion.hpp"

namespace denhartog::benchmark {

/// @brief Rises when a member or a column is added, dropped or means something else.
inline constexpr int format_version = 2;
/// @brief Rises with every scene that is added, dropped or changed.
inline constexpr int content_version = 2;
/// @brief Least digits on which the two routes have to agree.
inline constexpr int least_digits = 25;

/// @brief A scene with its certified motion, and what follows from both.
struct CertifiedScene {
    Design design;                    ///< the scene
    double F = 0;                     ///< kinetic friction, N
    Onsets onsets;                    ///< the friction that parts the regimes
    Motion motion;                    ///< the settled motion
    int digits = 0;                   ///< on which the two routes agree, counted to 40
    std::vector<int> settles;         ///< periods from rest, for each of `settling_tolerances`; 0 where not reached
    std::string regime;               ///< continuous, stick_slip, permanent_sticking
    std::string difficulty;           ///< easy, medium, hard
    std::vector<std::string> exposes; ///< what a solver with a fault of this kind gets wrong
};

/// @brief Tolerances to which the periods from rest are counted. @return 1e-3, 1e-6, 1e-9, 1e-12
[[nodiscard]] const std::vector<double>& settling_tolerances();

/// @brief Computes a scene by both routes.
/// @param d  the scene
/// @return   the certified scene
/// @throws   DomainError where the routes do not agree
[[nodiscard]] CertifiedScene certified(const Design& d);

/// @brief All scenes, certified. @param progress whether to say on standard error which one is done @return the scenes
[[nodiscard]] std::vector<CertifiedScene> certify_all(bool progress);

/// @brief A scene as an object of `scenes.json`. @param s the scene @return its text
[[nodiscard]] std::string json_of(const CertifiedScene& s);

/// @brief The files of the pack. @param scenes all scenes @return name and bytes
[[nodiscard]] std::map<std::string, std::string> files_of(const std::vector<CertifiedScene>& scenes);

} // namespace denhartog::benchmark
