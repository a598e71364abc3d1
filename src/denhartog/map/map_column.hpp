/// @file
/// @brief One column of a regime map: all friction ratios at one frequency ratio.
#pragma once

#include <atomic>
#include <optional>
#include <span>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/map/regime_map.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief What the columns of a map share.
struct MapSystem {
    const ContactSystem<double>& system; ///< modes, sliding and stuck
    double mu;                           ///< static over kinetic friction
    MapStart start;                      ///< which motion, where there are several
    const std::vector<double>& beta;     ///< friction ratios
    const std::vector<Mass>& masses;     ///< masses whose amplitudes are wanted
    std::optional<long> effort{};        ///< operations allowed a point
};

/// @brief Whether the contact alone is asked for, and no point but one of stick-slip needs a motion to be followed.
/// @param map  what the columns share
/// @return     true where the closed form and the rest answer many points of a column together
[[nodiscard]] bool answers_together(const MapSystem& map);

/// @brief What a column has of its frequency ratio.
struct ContactColumn {
    Complex<double> V_dj; ///< complex response function of the mass in contact, Eq. (33)
    double U_dj;          ///< first damping function, Eq. (34)
    double G_j;           ///< second damping function, Eq. (35)
    double exact;         ///< beta_lim, Eq. (69)
    double sticking;      ///< the contact rests from here on; infinite where no friction can hold it
};

/// @brief Computes a column.
/// @param map         what the columns share
/// @param r           frequency ratio
/// @param arrays      what the arrays tell of it, where its limits part the friction ratios for certain; else it is evaluated here
/// @param stop        leaves the rest of the column undone once it is set
/// @param points      where the points go
/// @param amplitudes  where the amplitudes go, filled with NaN before
void compute_column(const MapSystem& map, double r, const std::optional<ContactColumn>& arrays, const std::atomic<bool>& stop,
                    std::span<MapPoint> points, std::span<double> amplitudes);

} // namespace denhartog
