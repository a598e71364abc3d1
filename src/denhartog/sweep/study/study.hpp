/// @file
/// @brief A study: a scene, what of it varies, what is asked of every point, and what the workers reduce.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "denhartog/map/regime_map.hpp"
#include "denhartog/sweep/sample.hpp"

namespace denhartog::sweep {

/// @brief What of a scene can vary.
enum class VariedQuantity : std::uint8_t {
    r,            ///< frequency ratio, Eq. (10)
    frequency_hz, ///< frequency of a scene of masses and stiffnesses, in periods a unit of time
    beta,         ///< friction ratio, Eq. (11)
    friction,     ///< friction force of a scene of masses and stiffnesses
    mu,           ///< static over kinetic friction, Eq. (3)
    zeta,         ///< damping ratios of the modes, Eq. (18)
    mass,         ///< masses, or mass ratios
    stiffness,    ///< stiffnesses, or stiffness ratios
    contact,      ///< the mass in contact
    load          ///< the loaded mass
};

/// @brief The quantity that a study varies.
struct Target {
    VariedQuantity quantity = VariedQuantity::r; ///< the quantity
    std::optional<std::size_t> entry{}; ///< which of a list, from 0; none for all
    bool factor = false;                ///< whether the value multiplies what the scene has

    /// @brief Its name in results. @return e.g. `zeta_2`, `mass_factor`
    [[nodiscard]] std::string name() const;
    /// @brief Whether two are the same. @param other another @return whether they are
    bool operator==(const Target& other) const = default;
};

/// @brief A quantity and the values that it takes.
struct Axis {
    Target target;              ///< the quantity
    std::vector<double> values; ///< its values in the order of the results; masses count from 1
};

/// @brief A quantity that is drawn.
struct Variable {
    Target target;     ///< the quantity
    Marginal marginal; ///< its distribution
};

/// @brief Samples of several quantities at once.
struct Samples {
    Sampling sampling = Sampling::sobol; ///< how they are drawn
    std::uint64_t count = 0;             ///< how many
    std::uint64_t seed = 0;              ///< which
    std::vector<Variable> variables;     ///< what is drawn
};

/// @brief Parts of a range in which values are counted.
struct Bins {
    double from = 0;          ///< lower end of the range
    double to = 1;            ///< upper end of the range
    std::size_t count = 1;    ///< number of parts
    bool logarithmic = false; ///< whether they are equally wide in the logarithm

    /// @brief Their ends. @return count + 1 ascending values
    [[nodiscard]] std::vector<double> edges() const;
};

/// @brief What a reduction makes of the values over its axes.
enum class Statistic : std::uint8_t {
    share,     ///< the share of the points in each regime, and of those without numbers
    maximum,   ///< the largest value and its place
    minimum,   ///< the smallest value and its place
    quantiles, ///< values below which given parts of the points lie
    histogram  ///< numbers of points in bins, with those below and above
};

/// @brief A reduction over some axes.
struct Reduction {
    std::string name;                       ///< its name in the results
    Statistic statistic = Statistic::share; ///< what it makes
    std::string of;                         ///< of which field, or of which maximum or minimum before it; none for a share
    std::vector<std::string> over;          ///< axes that it takes together
    std::vector<double> probabilities;      ///< of quantiles
    std::optional<Bins> bins;               ///< of a histogram; of quantiles that are taken from one
};

/// @brief What is written of every point.
struct Answers {
    bool regime = false;     ///< the regime
    bool amplitudes = false; ///< amplitudes of the masses asked for
    bool phases = false;     ///< their phases
    bool stops = false;      ///< stops in a period of the motion, and that period
    /// @brief Whether anything is. @return whether it is
    [[nodiscard]] bool any() const { return regime || amplitudes || phases || stops; }
};

/// @brief A study.
struct Study {
    nlohmann::json scene;              ///< the scene, as it was written
    std::vector<Axis> axes;            ///< in the order of the file
    std::optional<Samples> samples;    ///< what is drawn
    Answers answers;                   ///< what is written of every point
    std::vector<Mass> masses;          ///< masses asked for
    MapStart start = MapStart::rest;   ///< which motion, where there are several
    std::optional<long> effort;        ///< operations allowed a point
    std::vector<Reduction> reductions; ///< what the workers reduce
    std::size_t points_of_a_chunk = 0; ///< how many points a chunk may have, as far as columns allow

    /// @brief The axis of a quantity. @param q a quantity @return the axis; null where it has none
    [[nodiscard]] const Axis* axis(VariedQuantity q) const;
    /// @brief The variable of a quantity. @param q a quantity @return the variable; null where it is not drawn
    [[nodiscard]] const Variable* variable(VariedQuantity q) const;
    /// @brief Whether the grid is in the units of the scene. @return whether frequencies are in hertz and friction is a force
    [[nodiscard]] bool in_units() const;
    /// @brief Whether anything needs phases. @return whether it does
    [[nodiscard]] bool needs_phases() const;
};

/// @brief Reads a study.
/// @param text  its JSON text, as docs/study.schema.json has it
/// @return      the study; what depends on several of its parts is checked by `plan_of`
/// @throws      InputError with quantity, rule, value and JSON pointer
[[nodiscard]] Study read_study(std::string_view text);

} // namespace denhartog::sweep
