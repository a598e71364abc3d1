/// @file
/// @brief Seeded scenes from the corners of what a scene may be, to find what breaks there.
///
/// Frequencies that coincide to the last bits, contrasts of masses and springs, masses far from contact and load in long chains,
/// friction at the boundary of the regimes, damping from none to a million times critical, frequency ratios over all that a
/// double holds. Every number is drawn in binary, so that a seed gives the same scenes on every platform. Where a scene is to
/// stand at a natural frequency or at the boundary, that is said as a multiple, and `placed` asks the library where these are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "denhartog/scene/scene.hpp"
#include "tests/support/split_mix.hpp"

namespace denhartog {

/// @brief Ranges that scenes are drawn from: exponents of two.
struct AdversarialRange {
    int r_low;        ///< of the least frequency ratio
    int r_high;       ///< of the largest
    int beta_low;     ///< of the least friction ratio that is not zero
    int beta_high;    ///< of the largest
    int contrast;     ///< of the largest ratio of masses and springs, and of the least
    int zeta_low;     ///< of the least damping ratio that is not zero
    int zeta_high;    ///< of the largest
    int mu_high;      ///< of the largest mu
    std::size_t most; ///< masses
    bool every_kind; ///< whether contacts between two masses, loads on several, and dashpots that couple the modes are among them
    bool in_units = false; ///< whether these are systems in units, see `scene_in_units`; they have ranges of their own
};

/// @brief All that a scene may be, of every kind: r from 5e-324 to 1e300, contrasts to 1e15, damping ratios to 1e6, 200 masses.
inline constexpr AdversarialRange everything{-1074, 996, -1074, 996, 50, -60, 19, 19, 200, true};
/// @brief What nobody means, but a double can say: contrasts to 1e150, damping ratios to 1e300, mu to 1e300, 12 masses.
inline constexpr AdversarialRange any_double{-1074, 1020, -1074, 1020, 500, -1000, 1000, 1000, 12, true};
/// @brief What a user may meet: r from 1e-9 to 10, contrasts to 1e12, damping ratios to 30, up to 12 masses.
inline constexpr AdversarialRange contrasts{-30, 3, -30, 6, 40, -40, 4, 6, 12, false};
/// @brief What a user does meet: r from 0.03 to 10, contrasts to 8, damping ratios from 1e-6 to 1, up to 8 masses.
inline constexpr AdversarialRange mild{-5, 3, -8, 1, 3, -20, -1, 2, 8, false};
/// @brief Systems as users give them, in units; of the other ranges' numbers none counts.
inline constexpr AdversarialRange units{0, 0, 0, 0, 0, 0, 0, 0, 8, true, true};

/// @brief A scene, and where it is to stand.
struct AdversarialScene {
    Scene<double> scene;             ///< with r, and with beta where no part of the boundary is wanted
    std::optional<std::size_t> mode; ///< its natural frequency times r is the frequency ratio that is meant
    std::optional<double> of_limit;  ///< the multiple of the boundary (69) that beta is to be
};

/// @brief Draws scenes.
class AdversarialScenes {
public:
    AdversarialScenes(std::uint64_t seed, const AdversarialRange& range) : random_(seed), of_kinds_(~seed), range_(range) {}

    /// @brief The next scene. @return the scene; it may break a rule of scenes, which is for the library to say
    AdversarialScene next();

private:
    std::size_t masses();
    double ratio(int kind);
    void chain(System<double>& s, std::size_t N);
    void coupled(System<double>& s, std::size_t N);
    void mass_matrix(System<double>& s);
    void damping(System<double>& s, std::size_t N);
    void frequency(AdversarialScene& made, std::size_t N);
    void friction(AdversarialScene& made);
    void other_kinds(System<double>& s, std::size_t N);

    SplitMix64 random_;
    SplitMix64 of_kinds_; // a stream of its own: the other numbers of a scene do not depend on its kind
    AdversarialRange range_;
};

/// @brief The scene where it is to stand. @param drawn a scene @return the scene with r and beta
/// @throws what the library throws where natural frequency or boundary are not to be had
[[nodiscard]] Scene<double> placed(const AdversarialScene& drawn);

/// @brief The text of a scene as the program reads it. @param scene a scene @return JSON on one line
[[nodiscard]] std::string json_of(const Scene<double>& scene);

// Systems as people give them: kilograms, newtons per metre, dashpots, bases that shake, contacts between floors. One to eight
// masses in a chain, or with further springs and with inertia that couples neighbours, as matrices. In half of the systems some
// masses are light, down to 1e-10 of the others: the joints and sensors of a model that nobody thinned out.

/// @brief A system read from the text of a scene in units, and where it is to stand.
[[nodiscard]] AdversarialScene scene_in_units(SplitMix64& random);

} // namespace denhartog
