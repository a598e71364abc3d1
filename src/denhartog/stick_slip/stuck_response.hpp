/// @file
/// @brief The response while the contact is held, the boundary of permanent sticking, (88), and whether a contact at rest rests
/// for ever.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/model/stuck_configuration.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief Harmonic motion of a mass while the contact is held at zero.
struct StuckMass {
    Complex<double> X;           ///< complex amplitude, x_k = Re{X exp(i tau)} with the force cos tau, in units of P / k_1
    double amplitude;            ///< its modulus
    std::optional<double> phase; ///< lag behind the force, radians, in (-pi, pi]; none if the mass does not move
};

/// @brief The response while the contact is held at zero.
struct StuckResponse {
    double r;                      ///< frequency ratio, Eq. (10)
    Mass contact;                  ///< the mass in contact, j
    Mass load;                     ///< the loaded mass, l
    std::vector<StuckMass> masses; ///< every mass, N; that of a contact with the wall has amplitude zero
    Complex<double> contact_load;  ///< complex amplitude of all that acts on the contact but friction, in units of P
    Complex<double> elastic_load;  ///< the same without the damping forces of the moving masses
};

/// @brief The response while the contact is held at zero; the contact at x_j moves every mass and its load by a constant.
///
/// If the stuck modes diagonalise their damping, (88)'s modal superposition; else a linear system over all of them. `load` is
/// the loaded mass, l; none of them if the load acts on several, which the stuck configuration then has. InputError if r or
/// l breaks its rule; DomainError if the load excites the resonance of an undamped stuck mode. @eq{88}
[[nodiscard]] StuckResponse stuck_response(const StuckConfiguration& stuck, Mass load, double r);

/// @brief The row of (6) that belongs to a held contact: the forces of the other masses and of the load on it.
template <class Number>
struct HeldRow {
    std::vector<Number> k;  ///< stiffness between the contact and each other mass
    std::vector<Number> c;  ///< damping between them
    std::vector<Number> m;  ///< entries of the mass matrix between them
    Complex<Number> direct; ///< part of the force that acts on the contact itself, in units of P

    /// @brief Complex amplitude of the load on the contact, if the others move by X. @eq{88}
    [[nodiscard]] Complex<Number> load(const Number& r, const std::vector<Complex<Number>>& X) const {
        std::vector<Number> C_j, K_j;
        for (std::size_t i = 0; i < k.size(); ++i) {
            C_j.push_back(r * c[i]);
            K_j.push_back(k[i] - r * r * m[i]);
        }
        return paper::load_on_held_contact<Number>(C_j, K_j, X, direct);
    }
};

/// @brief The response with the contact held at zero, with bounds.
struct HeldResponse {
    std::vector<Complex<Bounded<double>>> X; ///< complex amplitudes of all masses
    Bounded<double> load;                    ///< on the contact, in size
};

/// @brief Section 4.3 for any contact: (6) without the row of the contact moves the other masses, and that row gives the load
/// on the contact. The entries of the damping matrix may be off by `error_of_C`. DomainError where the load excites the resonance
/// of an undamped stuck mode.
[[nodiscard]] HeldResponse held_response(const Scene<double>& scene, const StuckConfiguration& stuck, Matrix<double> error_of_C);

/// @brief Bounds of what errors of the modes make of the damping matrix (19), zero where the matrix was given.
[[nodiscard]] Matrix<double> errors_of_C(const System<double>& s, const ModalBasis<Bounded<double>>& basis);

/// @brief The static compliance of the contact, (K^-1)_jj, with its bound.
[[nodiscard]] Bounded<double> compliance_of(const StuckConfiguration& stuck);

/// @brief The masses of a chain that move by (88) while the contact is held: those on the load's side of it.
struct StuckChain {
    std::vector<Mass> masses;    ///< ascending, without the contact; none if the load acts on it
    std::vector<double> r_n;     ///< natural frequency ratios, ascending
    std::vector<double> zeta;    ///< damping ratios read from the diagonal by (18), whether or not the modes are uncoupled
    Matrix<double> phi;          ///< mode shapes, mass by mode, phi^T M phi = 1
    std::optional<double> kappa; ///< stiffness ratio of the spring to the contact; none if the load acts on the contact
};

/// @brief Modes of the masses that move by (88); one more eigenproblem (15) for two masses or more. None if the system is not
/// given as a chain. @eq{88}
[[nodiscard]] std::optional<StuckChain> stuck_chain(const System<double>& s, const StuckConfiguration& stuck);

/// @brief Complex amplitude of a mode under a force p cos tau: \f$ p / (a + \mathrm{i}b) \f$ with its stiffness less inertia,
/// \f$ a = r_n^2 - r^2 \f$, and its damping, \f$ b = 2\zeta r_n r \f$. @eq{88}
template <class Number>
[[nodiscard]] Complex<Number> amplitude_of_mode(const Number& p, const Number& a, const Number& b) {
    const Number size = a * a + b * b;
    return {p * a / size, -p * b / size};
}

/// @brief The friction ratio from which the contact can stay at rest for ever, as it is and as (88) has it.
struct StickingBoundary {
    double exact;                ///< with all forces on the contact; equal to `Boundary::sticking`
    double without_damping_load; ///< the damping forces of the moving masses on the contact left out, all else exact
    std::optional<double> paper; ///< by (88); none for a system that is no chain
};

/// @brief The boundary of permanent sticking, without bounds; `chain` is the masses that move by (88), if there are such.
/// InputError if mu is below 1 or not finite; DomainError if the load excites the resonance of an undamped stuck mode. @eq{88}
[[nodiscard]] StickingBoundary sticking_boundary(const StuckResponse& response, const std::optional<StuckChain>& chain,
                                                 double mu);

/// @brief Rest for ever at one system, frequency and friction.
///
/// While the contact is held the load on it is that of the steady stuck motion, (88) with all forces, a constant
/// \f$ -k\bar{x}_j \f$, and what the free motion of the others adds: at most its energy norm, which never grows, times a weight.
class LastingRest {
public:
    LastingRest(const ContactSystem& system, const Excitation& excitation); ///< the system must outlive this

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
    double weight_ = 0;                     // largest load on the contact of a free motion of unit energy norm
    double terms_;                          // of the load on the held contact, in size: what rounding is of
};

} // namespace denhartog
