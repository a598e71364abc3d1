/// @file
/// @brief The braces of (40) of all modes at one instant, and bounds of their derivatives.
///
/// If \f$ \zeta_i < 1 \f$ the braces are \f$ 1 - \mathrm{Re}\{c_i e^{\rho_i\tau}\} \f$ with \f$ |\rho_i| = 1/R_i \f$, so that
/// from an instant a on their n-th derivative is at most \f$ |c_i|\,e^{-\zeta_i a/R_i}/R_i^n \f$. If \f$ \zeta_i \ge 1 \f$ the
/// derivatives \f$ y_n \f$ in \f$ \tau/R_i \f$ follow from one another, \f$ y_{n+2} = -2\zeta_iy_{n+1} - y_n \f$, n of 1 and
/// more, and no \f$ y_n^2 + y_{n+1}^2 \f$ ever grows: what it is at a bounds both from there on.
#pragma once

#include <array>
#include <map>
#include <memory_resource>
#include <span>
#include <vector>

#include "denhartog/evaluation/friction_motion.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/sums/mode_sums.hpp"

namespace denhartog {

/// @brief The braces of (40) at an instant, and what bounds their derivatives from there on.
struct FrictionMotionsAt {
    double cosine;                                          ///< of the instant
    double sine;                                            ///< of the instant
    std::pmr::vector<evaluation::FrictionMotion<double>> y; ///< braces and derivatives, one entry a mode of the range
    std::pmr::vector<double>
        size; ///< over R_i^n it bounds the n-th derivative from there on, n = 2, 3, 4; empty until it is asked for
};

/// @brief Braces of (40) at instants of the half-period, remembered: the masses of a system share their instants.
class FrictionMotions {
public:
    /// @brief Of all modes; the sums must outlive the object. Searches take their share of `effort`.
    explicit FrictionMotions(const ModeSums<double>& sums, Effort* effort = nullptr);

    /// @brief Of one mode, which is not evaluated again at instants that are remembered of `all`; that must outlive the object.
    FrictionMotions(const FrictionMotions& all, std::size_t mode);

    /// @brief Braces and derivatives of each mode of the range at an instant in [0, pi], valid until the next call; with `sizes`
    /// also bounds of the derivatives from there on.
    const FrictionMotionsAt& at(double tau, bool sizes = false);

    /// @brief The modes.
    [[nodiscard]] const ModeSums<double>& sums() const { return sums_; }

    /// @brief The work allowed to a question; null: nobody allows any.
    [[nodiscard]] Effort* effort() const { return effort_; }

    /// @brief Number of modes times number of instants that are remembered.
    [[nodiscard]] std::size_t remembered() const { return known.size() * c.size(); }

private:
    const ModeSums<double>& sums_;
    Effort* effort_;
    const FrictionMotions* all = nullptr; // where the range is one mode of these
    std::size_t first, last;
    std::vector<double> c;
    std::array<std::byte, 16384> first_memory; // holds what a search over a few modes asks for
    std::pmr::monotonic_buffer_resource memory{first_memory.data(), first_memory.size()};
    std::pmr::map<double, FrictionMotionsAt> known{&memory};

    [[nodiscard]] FrictionMotionsAt evaluated(double tau);
    [[nodiscard]] double size_of(const evaluation::FrictionMotion<double>& y, std::size_t i, double tau) const;
};

/// @brief Braces of (40) of every mode and their derivatives at an instant. @eq{40}
template <class T>
[[nodiscard]] std::vector<evaluation::FrictionMotion<T>> friction_motions(const ModeSums<T>& sums, const T& tau);

} // namespace denhartog
