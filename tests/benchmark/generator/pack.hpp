/// @file
/// @brief The benchmark's pack as files: scenes with their certified motions as JSON and CSV, and a manifest.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/benchmark/generator/motion.hpp"
#include "tests/benchmark/pack_scene.hpp"

namespace denhartog::benchmark {

/// @brief Rises when a member or a column is added, dropped or means something else.
inline constexpr int format_version = 2;
/// @brief Rises with every scene that is added, dropped or changed.
inline constexpr int content_version = 2;
/// @brief Least digits on which the two routes have to agree.
inline constexpr int least_digits = 25;

/// @brief The friction that part the regimes at a scene, in N.
struct Onsets {
    Real50 sliding;  ///< below it the contact slides throughout, (69)
    Real50 sticking; ///< from it on the contact may rest for ever, as corrected from (88)
};

/// @brief Both boundaries by the closed form in 50 digits. @param s a scene @return the boundaries
[[nodiscard]] Onsets onsets_of(const PackScene& s);

/// @brief The same from the physical coordinates: half a period that mirrors itself, and a dense system with the contact held.
[[nodiscard]] Onsets onsets_of_half_period(const PackScene& s);

/// @brief A scene with its certified motion, and what follows from both.
struct CertifiedScene {
    PackScene scene;                  ///< the scene
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

/// @brief Computes a scene by both routes. DomainError where the routes do not agree.
[[nodiscard]] CertifiedScene certified(const PackScene& scene);

/// @brief The scenes of a pack, certified anew. @param pack its folder @param progress whether to say on standard error which one
/// is done @return the scenes
[[nodiscard]] std::vector<CertifiedScene> certify_all(const std::filesystem::path& pack, bool progress);

/// @brief A scene as an object of `scenes.json`. @param s the scene @return its text
[[nodiscard]] std::string json_of(const CertifiedScene& s);

/// @brief The files of the pack. @param scenes all scenes @return name and bytes
[[nodiscard]] std::map<std::string, std::string> files_of(const std::vector<CertifiedScene>& scenes);

} // namespace denhartog::benchmark
