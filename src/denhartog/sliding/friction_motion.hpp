/// @file
/// @brief The braces of (40) of all modes at one instant, bounds of their derivatives, and the motion (46) that they make.
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
#include "denhartog/evaluation/mass.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/mode_sums.hpp"

namespace denhartog {

/// @brief A mass at instants of the half-period.
template <class T>
struct MassInMotion {
    evaluation::HarmonicPart<T> h; ///< what the load does
    T beta;                        ///< friction ratio, Eq. (11)
    std::vector<T> weights;        ///< factors of the braces in (41), without beta

    /// @brief Mass k of the modes at a friction ratio. @eq{41}
    MassInMotion(const ModeSums<T>& s, std::size_t k, const T& beta_)
        : h(evaluation::harmonic_part(s.V[k], s.V[s.contact.index], s.U[s.contact.index], beta_)), beta(beta_) {
        const std::span<const T> psi_k = mode_shapes_at(s, Mass{k}), psi_j = mode_shapes_at(s, s.contact);
        weights.reserve(s.R.size());
        for (std::size_t i = 0; i < s.R.size(); ++i) weights.push_back(psi_k[i] * psi_j[i] * s.R[i] * s.R[i]);
    }
    /// @brief The motion x, x', x'' at an instant in [0, pi], of which the cosine and the sine are given; `so_far` is friction's
    /// share that is no mode's. @eq{46}
    [[nodiscard]] evaluation::MotionOfMass<T> at(const T& C, const T& S, std::span<const evaluation::FrictionMotion<T>> y,
                                                 const evaluation::FrictionMotion<T>& so_far = {T(0), T(0), T(0)}) const {
        return evaluation::motion_of_mass(C, S, h, beta, std::span<const T>(weights), y, so_far);
    }
};

/// @brief Friction's share of the motion at an instant: of every mode, or of a mass if damping couples them.
template <class T>
struct FrictionShare {
    T cosine;                                         ///< of the instant
    T sine;                                           ///< of the instant
    std::vector<evaluation::FrictionMotion<T>> modes; ///< N; none if damping couples the modes
    evaluation::FrictionMotion<T> mass;               ///< then that of the mass, else zero
};

/// @brief Friction's share of the motion of a mass, at an instant in [0, pi], if damping couples the modes; else zero.
template <class T>
[[nodiscard]] evaluation::FrictionMotion<T> share_of_no_mode(const ModeSums<T>& s, std::size_t k, const T& tau) {
    return s.coupled ? s.coupled->motion(k, tau) : evaluation::FrictionMotion<T>{T(0), T(0), T(0)};
}

/// @brief Friction's share of the motion of a mass at an instant in [0, pi]. @eq{40}
template <class T>
[[nodiscard]] FrictionShare<T> friction_share(const ModeSums<T>& s, std::size_t k, const T& tau) {
    const SineCosine<T> at = sine_cosine(tau);
    FrictionShare<T> share{at.c, at.s, {}, share_of_no_mode(s, k, tau)};
    share.modes.reserve(s.R.size());
    for (std::size_t i = 0; i < s.R.size(); ++i)
        share.modes.push_back(evaluation::friction_motion(tau, s.R[i], s.zeta[i], s.w[i], s.u[i], s.g[i]));
    return share;
}

/// @brief Motion (46) of a mass with friction's share at an instant. @eq{46}
template <class T>
[[nodiscard]] evaluation::MotionOfMass<T> motion_with(const MassInMotion<T>& mass, const FrictionShare<T>& y) {
    return mass.at(y.cosine, y.sine, y.modes, y.mass);
}

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

} // namespace denhartog
