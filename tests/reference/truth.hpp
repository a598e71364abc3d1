/// @file
/// @brief The numbers of a point in balls, for all that the library tells of it.
#pragma once

#include <utility>
#include <vector>

#include "denhartog/answer/reference_point.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/reference/sliding.hpp"
#include "tests/reference/proofs.hpp"

namespace denhartog::tests {

/// @brief The numbers of a point in balls, by the formulas alone.
struct Truth {
    PointInBalls point{};                     ///< matrices, response functions, boundaries
    reference::ModesInBalls modes{};          ///< modes; damping ratios as well where a damping matrix gives them
    bool slides = false;                      ///< whether beta is below the boundary
    SteadyState<Ball> contact{};              ///< in that case the contact
    std::vector<MassResponse<Ball>> masses{}; ///< and the masses

    explicit Truth(const SceneSource& source)
        : point(point_of(source)), modes(reference::modes_in_balls(point.scene)), slides(beta() < point.boundary->exact) {
        if (modes.zeta.empty()) modes.zeta = ratios_of_matrix();
        if (!slides) return;
        contact = reference::contact_in_balls(*point.responses, beta());
        for (slong k = 0; k < point.scene.N(); ++k) {
            bool is_contact = true; // on a wall; of a contact between two masses each moves otherwise
            for (slong n = 0; n < point.scene.N(); ++n) is_contact = is_contact && point.scene.w(n).is_zero() == (n != k);
            masses.push_back(reference::mass_in_balls(*point.responses, contact, static_cast<std::size_t>(k), is_contact));
        }
    }

    /// @brief Friction ratio. @return beta
    [[nodiscard]] const Ball& beta() const { return *point.scene.beta; }

    /// @brief Where a mass is while the contact slides. @eq{41}
    [[nodiscard]] Ball displacement(std::size_t k, double tau) const {
        const bool mirrored = tau > 3.141592653589793;
        const Ball at = mirrored ? Ball(tau) - pi<Ball>() : Ball(tau);
        const reference::ResponsesInBalls& r = *point.responses;
        const Ball F = r.friction.of(k, (*r.friction.shared)(at)).rate(0);
        const Ball x = paper::displacement(at, masses[k].x0, masses[k].v0, r.G[k], r.U[k], beta(), F);
        return mirrored ? -x : x;
    }

private:
    // A demand that turns next to the start of the half-period is found by a search with twice the bits: the driver gives them
    // where the first do not settle it.
    [[nodiscard]] static PointInBalls point_of(const SceneSource& source) {
        const slong before = std::exchange(reference::bits_of_search, 128);
        PointInBalls point = point_in_balls(source, true);
        reference::bits_of_search = before;
        return point;
    }

    // (18): 2 zeta omega = phi^T C phi, with phi = r psi and omega = r / R.
    [[nodiscard]] std::vector<Ball> ratios_of_matrix() const {
        std::vector<Ball> zeta;
        const reference::SceneInBalls& s = point.scene;
        for (std::size_t i = 0; i < modes.R.size(); ++i) {
            Ball c(0);
            for (slong k = 0; k < s.N(); ++k)
                for (slong n = 0; n < s.N(); ++n)
                    c += modes.psi[static_cast<std::size_t>(k)][i] * s.C(k, n) * modes.psi[static_cast<std::size_t>(n)][i];
            zeta.push_back(c * s.r * modes.R[i] / 2);
        }
        return zeta;
    }
};

} // namespace denhartog::tests
