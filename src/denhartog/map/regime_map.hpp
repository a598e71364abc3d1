/// @file
/// @brief The regime, the amplitudes and the stops per period over a grid of (r, beta), in double as far as that is certain.
///
/// A column is a frequency ratio: one evaluation of the modes and one boundary serve all its friction ratios. Where the contact
/// slides throughout the closed form answers, where it rests the stuck response; where it sticks and slips the periodic orbit is
/// found from that of the friction ratio before it. Where the bounds of double do not tell the regime, or leave an amplitude fewer
/// than 6 digits, `solve` answers. Columns know nothing of each other, so that the map is the same for any number of threads.
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

/// @brief Which motion a map shows where there can be more than one, at mu > 1.
enum class MapStart : std::uint8_t {
    rest,   ///< the one that the start from rest leads to, as `solve` has it
    sliding ///< the sliding motion as far as it exists, and from there the one met as beta rises
};

/// @brief What became of a point.
enum class PointStatus : std::int8_t {
    answered = 0,      ///< all numbers are there
    on_boundary = 1,   ///< all numbers are there; beta equals a boundary to rounding, the regime could be the neighbour
    not_converged = 2, ///< no steady motion was found: no regime, no number
    at_a_pole = 3,     ///< a mode without damping resonates: no number
    failed = 4         ///< the digits of the number types do not suffice: no number
};

/// @brief Name of a status as files have it. @param status a status @return e.g. `not_converged`
[[nodiscard]] std::string name(PointStatus status);

/// @brief Whether a point has a regime and amplitudes. @param status of the point @return true if so
[[nodiscard]] inline bool has_numbers(PointStatus status) {
    return status == PointStatus::answered || status == PointStatus::on_boundary;
}

/// @brief A point of a map, without its amplitudes.
struct MapPoint {
    PointStatus status = PointStatus::failed; ///< whether there are numbers
    Regime regime = Regime::continuous;       ///< the regime; means nothing without numbers
    std::int32_t stops = 0;                   ///< stops in a period of the motion
    std::int32_t periods = 1;                 ///< that period, in periods of the force
};

/// @brief What a map is asked for.
struct MapRequest {
    std::vector<double> r;           ///< frequency ratios, the columns
    std::vector<double> beta;        ///< friction ratios; neighbours help each other where they ascend
    std::vector<Mass> masses;        ///< masses whose amplitudes are wanted
    MapStart start = MapStart::rest; ///< which motion, where there are several
    unsigned threads = 1;            ///< threads, at least 1
    std::optional<long> effort{};    ///< operations allowed a point; without, what `QuestionEffort` has
};

/// @brief A map.
struct RegimeMap {
    std::vector<MapPoint> points;   ///< point n of column m at m times the number of friction ratios plus n
    std::vector<double> amplitudes; ///< amplitude of each mass asked for, point after point; NaN where a point has no numbers
    bool complete = false;          ///< false where it was stopped
};

/// @brief Checks the size of a map. @param columns frequencies @param amplitudes of a column @throws InputError where it is too large
void check_size_of_map(std::size_t columns, std::size_t amplitudes);

/// @brief Computes a map.
/// @param scene    system and mu; its r and beta are not used
/// @param request  grid, masses, threads
/// @param stop     set by the caller or a signal to stop the computation early
/// @param done     told the number of columns done after each, by one thread at a time; may be empty
/// @return         the map
/// @throws         InputError where the scene, the grid or a mass breaks a rule
[[nodiscard]] RegimeMap regime_map(const Scene<double>& scene, const MapRequest& request, const std::atomic<bool>& stop,
                                   const std::function<void(std::size_t done)>& done = {});

/// @brief The four boundaries at one frequency ratio, for curves over r.
struct BoundaryPoint {
    PointStatus status = PointStatus::failed; ///< whether there are numbers
    double exact = 0;                         ///< `Boundary::exact`
    double paper = 0;                         ///< `Boundary::paper`
    double approximate = 0;                   ///< `Boundary::approximate`
    std::optional<double> sticking;           ///< `Boundary::sticking`
};

/// @brief Boundary curves over r.
/// @param scene  system and mu
/// @param r      frequency ratios
/// @return       a point each
/// @throws       InputError where the scene or a frequency ratio breaks a rule
[[nodiscard]] std::vector<BoundaryPoint> boundary_curves(const Scene<double>& scene, const std::vector<double>& r);

} // namespace denhartog
