/// @file
/// @brief One column of a regime map: all friction ratios at one frequency ratio.
#pragma once

#include <atomic>
#include <optional>
#include <span>

#include "denhartog/map/regime_map.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/solve/solve.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief True if the contact alone is asked for, and no point but one of stick-slip needs a motion to be followed. The closed
/// form and rest then answer many points of a column together.
[[nodiscard]] bool answers_together(const PreparedSystem& system, const MapRequest& request);

/// @brief Sums and boundary at the frequency ratio of a column, with bounds if it was evaluated; those of `contact_sums`, which
/// are computed for many columns at once, have none.
struct ContactColumn {
    Complex<Bounded<double>> V_dj;            ///< complex response function of the mass in contact, Eq. (33)
    Bounded<double> U_dj;                     ///< first damping function, Eq. (34)
    Bounded<double> G_j;                      ///< second damping function, Eq. (35)
    RegimeBoundary<Bounded<double>> boundary; ///< where the regimes part
};

/// @brief Computes column m of a map of a system that is prepared for every regime, at friction ratios that need not be those of
/// the request. `arrays` has the sums of `contact_sums` at its frequency ratio, if their boundaries separate the friction ratios
/// for certain; else the sums are evaluated here. Once `stop` is set, the rest of the column is left undone. Amplitudes and
/// phases were filled with NaN before.
void compute_column(const PreparedSystem& system, const MapRequest& request, std::size_t m, std::span<const double> beta,
                    const std::optional<ContactColumn>& arrays, const std::atomic<bool>& stop, RegimeMap& map);

/// @brief The point of a map that an answer makes; one without numbers where there is none.
[[nodiscard]] MapPoint map_point(const Tried<Solution>& answer);

} // namespace denhartog
