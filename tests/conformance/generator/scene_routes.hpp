/// @file
/// @brief The two routes of one scene, in both numbers of digits, and those of the scenes next to it.
#pragma once

#include <optional>

#include "tests/conformance/generator/route.hpp"

namespace denhartog::conformance::generator {

/// @brief The boundaries that part the regimes at a scene, by the closed form in 50 digits.
struct Regimes {
    Real50 sliding;                 ///< beta_lim, Eq. (69)
    std::optional<Real50> sticking; ///< the boundary of permanent sticking
};

/// @brief Boundaries of a scene. @param scene a question about it @return the boundaries; none at a pole of a mode
[[nodiscard]] std::optional<Regimes> regimes_of(const ProtocolQuestion& scene);

/// @brief Whether a quantity depends on the friction ratio. @param quantity its name @return true if so
[[nodiscard]] bool depends_on_friction(const std::string& quantity);

/// @brief A scene with one input changed a little.
struct Neighbour {
    std::string input;      ///< which, as the vectors name it
    double relative_change; ///< of the input; exact
    ProtocolQuestion scene; ///< the scene
};

/// @brief Scenes next to one: every input that may change and is not zero, by 2^-36 of itself. They come in the order of the
/// inputs.
[[nodiscard]] std::vector<Neighbour> neighbours_of(const ProtocolQuestion& scene);

/// @brief All routes to the numbers of a scene, each made when first asked for.
class SceneRoutes {
public:
    /// @brief Of a question about the scene, and its regime.
    SceneRoutes(const ProtocolQuestion& scene, Regime regime);

    /// @brief The first route. @param q a question @return its numbers
    template <class T>
    [[nodiscard]] std::vector<T> first(const ProtocolQuestion& q);
    /// @brief The second route. @param q a question @return its numbers
    template <class T>
    [[nodiscard]] std::vector<T> second(const ProtocolQuestion& q);
    /// @brief What the two are called. @param q a question @return their names
    [[nodiscard]] std::array<std::string, 2> names(const ProtocolQuestion& q) const;

    /// @brief Condition numbers of a quantity, in the order of the inputs; those of no influence left out. `values` are its
    /// numbers in 50 digits, from `first`; changes are divided by the scale.
    [[nodiscard]] std::vector<std::pair<std::string, Real50>> condition(const ProtocolQuestion& q,
                                                                        const std::vector<Real50>& values, const Real50& scale);

    /// @brief The motion with stops of the scene, seen in double. @return the motion @throws DomainError as `orbit_seen`
    [[nodiscard]] const OrbitSeen& seen();

private:
    template <class T>
    struct Pair {
        std::unique_ptr<Route<T>> first, second, orbit, phases;
    };
    ProtocolQuestion scene_;
    Regime regime_;
    std::optional<OrbitSeen> seen_;
    Pair<Real50> in_50_;
    Pair<Real100> in_100_;
    std::vector<Neighbour> neighbours_;
    std::vector<std::unique_ptr<Route<Real50>>> near_, near_orbits_;

    [[nodiscard]] bool is_orbit(const ProtocolQuestion& q) const;
    template <class T>
    Pair<T>& pair();
    std::vector<Real50> at_neighbour(std::size_t n, const ProtocolQuestion& q);
};

} // namespace denhartog::conformance::generator
