/// @file
/// @brief Resonant peaks in the sliding regime. Header only.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <optional>

#include "denhartog/evaluation/resonance.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "figure.hpp"

namespace denhartog::figures {

/// @brief A system with its modes.
struct WithModes {
    /// @brief Solves its eigenproblem. @param s the system
    explicit WithModes(System<double> s) : system(std::move(s)), basis(modal_basis(system)) {}

    System<double> system;    ///< the system
    ModalBasis<double> basis; ///< its modes

    /// @brief Modes and sums at a frequency ratio. @param r frequency ratio @return the sums
    [[nodiscard]] ModeSums<double> at(double r) const { return mode_sums(basis, system.contact, system.load, r); }

    /// @brief (52) where the contact slides, mu = 1. @param k a mass @param r frequency ratio @param beta friction ratio
    /// @return the amplitude; not a number where the contact does not slide
    [[nodiscard]] double sliding_amplitude(Mass k, double r, double beta) const {
        const ModeSums<double> sums = at(r);
        const Boundary<double> limits = boundary(sums, 1.0);
        return beta < limits.exact ? steady_state(sums, limits, beta).masses[k.index].amplitude_monoharmonic : std::nan("");
    }

    /// @brief Mode shape at the natural frequency ratio, normalised by (17). @param k a mass @param i a mode @return psi_ki
    [[nodiscard]] double psi(Mass k, std::size_t i) const {
        return basis.phi(static_cast<Eigen::Index>(k.index), static_cast<Eigen::Index>(i)) / basis.r_n[i];
    }

    /// @brief (83). @param k a mass @param i a mode @param beta friction ratio @return the estimate
    [[nodiscard]] double estimated_peak(Mass k, std::size_t i, double beta) const {
        return evaluation::resonant_peak(psi(k, i), psi(system.load, i), psi(system.contact, i), basis.zeta[i], beta);
    }

    /// @brief (85). @param i a mode @return the estimate
    [[nodiscard]] double estimated_limit(std::size_t i) const {
        return evaluation::friction_ratio_limit_at_resonance(psi(system.load, i), psi(system.contact, i), basis.zeta[i]);
    }
};

/// @brief A maximum over the frequency ratio.
struct Peak {
    double r; ///< where
    double X; ///< its height
};

/// @brief The highest maximum of (52) next to a natural frequency ratio while the contact slides, mu = 1.
///
/// Looked for within three tenths of the resonance, but no farther than nearly half the way to the next one: distances in
/// geometric progression, then Brent's method.
/// @param s     a system
/// @param k     a mass
/// @param i     a mode
/// @param beta  friction ratio
/// @return      the peak; none where there is no maximum within the sliding regime
[[nodiscard]] inline std::optional<Peak> sliding_peak(const WithModes& s, Mass k, std::size_t i, double beta) {
    const std::vector<double>& r_n = s.basis.r_n;
    double width = 0.3 * r_n[i];
    if (i > 0) width = std::min(width, 0.45 * (r_n[i] - r_n[i - 1]));
    if (i + 1 < r_n.size()) width = std::min(width, 0.45 * (r_n[i + 1] - r_n[i]));
    const double least = std::min(s.basis.zeta[i] / 64 * r_n[i], width / 2);
    std::vector<double> distances = spaced_in_octaves(least, width, 60), r{r_n[i]};
    for (const double d : distances) {
        r.push_back(r_n[i] - d);
        r.push_back(r_n[i] + d);
    }
    std::ranges::sort(r);
    std::vector<double> X;
    for (const double each : r) X.push_back(s.sliding_amplitude(k, each, beta));
    const auto not_below = [&](std::size_t n, std::size_t neighbour) { return std::isnan(X[neighbour]) || X[n] >= X[neighbour]; };
    std::optional<std::size_t> best;
    for (std::size_t n = 1; n + 1 < r.size(); ++n)
        if (not_below(n, n - 1) && not_below(n, n + 1) && !std::isnan(X[n]) && (!best || X[n] > X[*best])) best = n;
    if (!best) return std::nullopt;
    // where the contact does not slide at a neighbour, the maximum is looked for up to where it still slides
    const auto end_next_to = [&](std::size_t neighbour) {
        double slides = r[*best], end = r[neighbour];
        if (!std::isnan(X[neighbour])) return end;
        for (int n = 0; n < 30; ++n) {
            const double middle = (slides + end) / 2;
            (std::isnan(s.sliding_amplitude(k, middle, beta)) ? end : slides) = middle;
        }
        return slides;
    };
    const double from = end_next_to(*best - 1), to = end_next_to(*best + 1);
    const int bits = 30; // no more of the place of a maximum is to be had in a double
    const auto minus_X = [&](double at) { return -s.sliding_amplitude(k, at, beta); };
    const auto [at, minus] = boost::math::tools::brent_find_minima(minus_X, from, to, bits);
    if (-minus <= s.sliding_amplitude(k, from, beta) || -minus <= s.sliding_amplitude(k, to, beta)) return std::nullopt;
    return Peak{at, -minus};
}

} // namespace denhartog::figures
