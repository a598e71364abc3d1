/// @file
/// @brief Whether a contact at rest rests for ever.
#pragma once

#include <optional>

#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"

namespace denhartog {

/// @brief Rest for ever at one system, frequency and friction.
///
/// While the contact is held the load on it is that of the steady stuck motion, (88) with all forces, a constant
/// \f$ -k\bar{x}_j \f$, and what the free motion of the others adds: at most its energy norm, which never grows, times a weight.
class LastingRest {
public:
    /// @brief The system must outlive this.
    LastingRest(const ContactSystem& system, const Excitation& excitation);

    /// @brief Verdict on a rest.
    enum class Verdict : std::uint8_t {
        open,       ///< it may end
        lasts,      ///< it lasts for ever
        on_boundary ///< its load reaches mu beta to rounding, and not beyond
    };

    /// @brief Whether the contact, at rest in a state at tau = 0, rests for ever.
    [[nodiscard]] Verdict verdict(const State& z) const;

    /// @brief Whether there is a steady motion with the contact held: the load excites no undamped resonance.
    [[nodiscard]] bool exists() const { return response_.has_value(); }

    /// @brief Largest distance from zero at which the contact can rest for ever; negative if it cannot rest at zero.
    [[nodiscard]] double reach() const;

    /// @brief The state at tau = 0 of the steady motion with the contact held at x_j.
    [[nodiscard]] State steady_state(double x_j) const;

    /// @brief Amplitude and phase of mass k in that motion.
    [[nodiscard]] MassMotion motion(std::size_t k, double x_j) const;

private:
    const ContactSystem* system_;
    Excitation e_;
    std::optional<StuckResponse> response_; // none at an undamped resonance: no steady motion
    std::vector<double> follows_;           // static displacement of the others for a unit displacement of the contact
    double weight_;                         // largest load on the contact of a free motion of unit energy norm
    double terms_;                          // of the load on the held contact, in size: what rounding is of
};

} // namespace denhartog
