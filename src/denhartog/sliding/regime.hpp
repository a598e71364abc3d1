/// @file
/// @brief The regime of the steady state at one point (r, beta), with the reason in a sentence.
#pragma once

#include <string>
#include <vector>

#include "denhartog/number/bounded.hpp"
#include "denhartog/sliding/boundary.hpp"

namespace denhartog {

/// @brief How the contact moves in the steady state.
enum class Regime {
    continuous,        ///< it slides throughout, but for its two turning points a period
    stick_slip,        ///< it moves, and rests for a part of every period
    permanent_sticking ///< it rests
};

/// @brief Name of a regime as answers have it. @param regime a regime @return `continuous`, `stick_slip` or `permanent_sticking`
[[nodiscard]] std::string name(Regime regime);

/// @brief The regime at a point.
struct RegimeAtPoint {
    Regime regime;             ///< the regime; `continuous` wherever the closed form holds
    std::vector<Regime> other; ///< regimes that exist at the same point, from other initial values
    bool on_boundary = false;  ///< beta equals a boundary to the accuracy of the boundary: the regime could be the neighbour
    std::string reason;        ///< why, in a sentence
};

/// @brief Accuracy of the two friction ratios that part the regimes; zero where one is known exactly.
template <class T>
struct BoundaryError {
    T exact;    ///< absolute error of `Boundary::exact`
    T sticking; ///< absolute error of `Boundary::sticking`
};

/// @brief The regime at a friction ratio and nothing else: what a map asks for at every point.
/// @eq{54,69}
/// @param boundary  the boundary at the frequency ratio
/// @param beta      friction ratio, Eq. (11); zero or positive
/// @return          the regime
template <class T>
[[nodiscard]] Regime regime_of(const RegimeBoundary<T>& boundary, const T& beta);

/// @brief Whether a friction ratio is a boundary between two regimes, to the accuracy of the boundary.
/// @param boundary  the boundary at the frequency ratio
/// @param beta      friction ratio, Eq. (11); zero or positive
/// @param error     accuracy of the boundary
/// @return          true where the regime could be the neighbour
template <class T>
[[nodiscard]] bool on_boundary(const RegimeBoundary<T>& boundary, const T& beta, const BoundaryError<T>& error);

/// @brief What rounding alone does to a boundary, where nothing better was measured.
/// @param boundary  the boundary
/// @return          16 units in the last place
template <class T>
[[nodiscard]] BoundaryError<T> rounding_of(const RegimeBoundary<T>& boundary);

/// @brief The regime at a friction ratio: sliding below (69), permanent sticking from `sticking` on, stick-slip between.
///
/// With mu > 1 the sliding regime can reach beyond `sticking`: the contact then slides if it is moving, and rests if it rests.
/// @eq{54,69}
/// @param boundary  the boundary at the frequency ratio
/// @param beta      friction ratio, Eq. (11); zero or positive
/// @param error     accuracy of the boundary
/// @return          the regime
template <class T>
[[nodiscard]] RegimeAtPoint regime_at(const Boundary<T>& boundary, const T& beta, const BoundaryError<T>& error);

/// @brief The same from a boundary with bounds of its errors. @eq{54,69}
/// @param boundary  the boundary at the frequency ratio
/// @param beta      friction ratio, Eq. (11); zero or positive
/// @return          the regime
template <class T>
[[nodiscard]] RegimeAtPoint regime_at(const Boundary<Bounded<T>>& boundary, const T& beta);

} // namespace denhartog
