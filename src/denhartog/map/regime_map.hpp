/// @file
/// @brief The regime, the amplitudes and the stops per period over a grid of (r, beta), in double as far as that is certain; in
/// ratios, or in the units of a scene.
///
/// A column of the map belongs to one frequency ratio: one evaluation of the modes and one boundary serve all its friction
/// ratios. If the contact slides throughout, the closed form answers; if it rests, the response with the contact held does. If it
/// sticks and slips, the periodic motion is found from that of the friction ratio before it, or from rest if mu > 1 and the map
/// starts at rest. `solve` answers a point if the error bounds in double do not decide its regime, or give an amplitude fewer
/// than 6 digits. If it has no answer, and beta lies within the error of a boundary, the point has the numbers of double and the
/// status `on_boundary`. Columns do not depend on each other, so that the map is the same for any number of threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "denhartog/scene/scene.hpp"
#include "denhartog/sliding/regime_at_point.hpp"

namespace denhartog {

/// @brief The motion that a map shows if there can be more than one, which is so at mu > 1.
enum class MapStart : std::uint8_t {
    rest,   ///< the motion that the start from rest leads to, as in `solve`
    sliding ///< the sliding motion as long as it exists, and beyond it the motion that is met as beta rises
};

/// @brief The answer that a point of a map has, or why it has none.
enum class PointStatus : std::int8_t {
    answered = 0,      ///< the point has all numbers
    on_boundary = 1,   ///< it has all numbers; beta equals a boundary to rounding, and the neighbouring regime is possible
    not_converged = 2, ///< no steady motion is known to follow from the start of the map; the point has no regime and no numbers
    at_a_pole = 3,     ///< a mode without damping resonates; the point has no numbers
    failed = 4         ///< `solve` has no answer either: digits or work are missing
};

/// @brief Name of a status, as files write it. @param status a status @return e.g. `not_converged`
[[nodiscard]] std::string name(PointStatus status);

/// @brief Tells if a point has a regime and amplitudes. @param status of the point @return true if so
[[nodiscard]] inline bool has_numbers(PointStatus status) {
    return status == PointStatus::answered || status == PointStatus::on_boundary;
}

/// @brief A point of a map, without its amplitudes.
struct MapPoint {
    PointStatus status = PointStatus::failed; ///< whether the point has numbers
    Regime regime = Regime::continuous;       ///< the regime; meaningless if the point has no numbers
    std::int32_t stops = 0;                   ///< number of stops of the contact in a period of the motion
    std::int32_t periods = 1;                 ///< period of the motion, in periods of the force
};

/// @brief The question to a map.
struct MapRequest {
    std::vector<double> r;           ///< frequency ratios, Eq. (10), positive; one column each
    std::vector<double> beta;        ///< friction ratios, Eq. (11), zero or positive; ascending values are faster
    std::vector<Mass> masses;        ///< masses whose amplitudes are wanted, at least one
    MapStart start = MapStart::rest; ///< which motion, if there are several
    unsigned threads = 1;            ///< number of threads, at least 1
    std::optional<long> effort{};    ///< operations allowed for a point; by default those of `default_effort`
    bool from_ground = false;        ///< whether amplitudes are those of absolute displacements, where base or wall move
    bool phases = false;             ///< whether phases are wanted too
};

/// @brief A map.
struct RegimeMap {
    std::vector<MapPoint> points;   ///< point n of column m is at m times the number of friction ratios plus n
    std::vector<double> amplitudes; ///< of the masses asked for, point after point; units of P / k_1; NaN without numbers
    std::vector<double>
        phases{};          ///< lags of the same masses behind the force, or of absolute displacements behind base or wall, if
                           ///< they were asked for; NaN without numbers, and of a mass at rest
    bool complete = false; ///< whether all points were computed; false if the map was stopped
};

/// @brief Computes a map.
/// @param scene    system and mu; its r and beta are not used
/// @param request  grid, masses, threads
/// @param stop     the caller or a signal handler may set it, to stop the computation early
/// @param done     called after each column with the number of columns done, by one thread at a time; may be empty
/// @return         the map; a point without an answer has a status, not an exception
/// @throws         InputError if the scene, the grid or a mass breaks a rule; or if absolute amplitudes are asked for, and neither
///                 base nor wall moves; or if these or phases are, and not the motion from rest is meant
[[nodiscard]] RegimeMap regime_map(const Scene<double>& scene, const MapRequest& request, const std::atomic<bool>& stop,
                                   const std::function<void(std::size_t done)>& done = {});

/// @brief The four boundaries at one frequency ratio, for curves over r. They are those of `Limits`, in double.
struct BoundaryPoint {
    PointStatus status = PointStatus::failed; ///< whether the boundaries are known
    double exact = 0;                         ///< (69) with the maximum over tau of the sum over modes
    double paper = 0;                         ///< (69) with (56), the sum of the maxima of the modes
    double approximate = 0;                   ///< (67)
    std::optional<double> sticking;           ///< the smallest beta at which the contact never moves; empty if there is none
};

/// @brief Computes the four boundaries over r.
/// @param scene  system and mu; its r and beta are not used
/// @param r      frequency ratios, Eq. (10), positive
/// @return       one point for each frequency ratio
/// @throws       InputError if the scene or a frequency ratio breaks a rule
[[nodiscard]] std::vector<BoundaryPoint> boundary_curves(const Scene<double>& scene, const std::vector<double>& r);

/// @brief Frequencies of a map in the units of its scene, with the force at each.
struct FrequenciesInUnits {
    std::vector<double> r;     ///< frequency ratios, Eq. (10)
    std::vector<double> force; ///< P; it grows with the frequency if the base moves with the wall, or if an unbalance loads
};

/// @brief The quantity that varies in the rows of a map in units.
enum class RowsOf : std::uint8_t {
    friction, ///< the friction force
    force,    ///< the amplitude of the load, with the friction of the scene
    unbalance ///< the unbalance that makes the load, with the friction of the scene
};

/// @brief Finds the frequency ratios and the forces at frequencies.
/// @param scene     a scene of masses, stiffnesses and a force
/// @param quantity  `frequency`, in radians a unit of time, or `frequency_hz`, in periods
/// @param values    the frequencies
/// @return          one ratio and one force for each
/// @throws          InputError if the scene lacks units or force, or a frequency is not positive
[[nodiscard]] FrequenciesInUnits frequencies_in_units(const Scene<double>& scene, const std::string& quantity,
                                                      const std::vector<double>& values);

/// @brief Computes a map with amplitudes in the scene's unit of length; a point with one beyond the range of a double has `failed`.
/// @param scene        the scene, in units
/// @param frequencies  those of `frequencies_in_units`
/// @param of           the quantity that varies in its rows
/// @param rows         the values of that, in the units of the scene
/// @param request      masses, start, threads; its r and beta are not used
/// @param stop         as of `regime_map`
/// @param done         as of `regime_map`
/// @return             the map
/// @throws             InputError if a friction force is negative, a level of the load is not positive, or the scene has no such
///                     load or no friction; or what `regime_map` throws
[[nodiscard]] RegimeMap map_in_units(const Scene<double>& scene, const FrequenciesInUnits& frequencies, RowsOf of,
                                     const std::vector<double>& rows, MapRequest request, const std::atomic<bool>& stop,
                                     const std::function<void(std::size_t done)>& done);

/// @brief Computes boundary curves as friction forces.
/// @param scene        the scene, in units
/// @param frequencies  those of `frequencies_in_units`
/// @return             one point for each frequency
/// @throws             InputError if the scene breaks a rule
[[nodiscard]] std::vector<BoundaryPoint> curves_in_units(const Scene<double>& scene, const FrequenciesInUnits& frequencies);

} // namespace denhartog
