/// @file
/// @brief The modes, sums over modes and motions of the plain closed form, with the points at which it may be varied.
///
/// The closed form as somebody codes it who follows the paper as corrected: in double, by sampling where a maximum is sought,
/// without bounds of errors. Every point of variation is a place where implementations are known to differ; without any the
/// numbers are right to the accuracy of double.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "conformance/question.hpp"
#include "denhartog/formulas/complex.hpp"

namespace denhartog::conformance {

/// @brief How mode shapes are normalised.
enum class Normalisation {
    mass_matrix,   ///< with r^2 diag(m_i / m_1), Eq. (17)
    without_r,     ///< with diag(m_i / m_1): r is left out
    largest_entry, ///< the largest entry of each is 1
    unit_length    ///< the squares of the entries of each add up to 1
};

/// @brief What is taken for the boundary of permanent sticking, (88).
enum class StickingForm {
    exact,               ///< all forces on the contact
    as_printed,          ///< the spring between the contact and its neighbour alone, with modal superposition
    without_damping_load ///< the damping forces of the moving masses on the contact left out, all else exact
};

/// @brief Equally spaced instants in the half-period.
struct Instants {
    double first = 0;       ///< the first
    double before_end = 0;  ///< how long before pi the last is
    std::size_t count = 14; ///< number of instants
};

struct PlainModes;

/// @brief The points of variation of the plain closed form.
struct Choices {
    Normalisation normalisation = Normalisation::mass_matrix; ///< of the mode shapes
    bool descending = false;                                  ///< modes are listed by descending natural frequency
    bool motion_as_printed = false;                           ///< the bracket of (46) as printed
    bool initial_displacement_as_printed = false;             ///< (44) as printed
    bool initial_velocity_as_printed = false;                 ///< (45) as printed
    bool motion_from_start = false;                           ///< (41) and (49) in place of (46) and (50) to (52)
    bool cosine_as_printed = false;                           ///< (50) as printed
    bool amplitude_from_parts = false;                        ///< the monoharmonic amplitude from (50) and (51) in place of (52)
    bool monoharmonic_as_printed = false;                     ///< (52) as printed
    bool maximum_of_each_mode = false;                        ///< (56) in place of the maximum of the sum over modes
    bool demand_at_start = false;                             ///< (72) in place of the maximum of the sum over modes, and of (56)
    bool load_of_each_mode = false;                           ///< (67) from (63) asked of every mode on its own
    bool sliding_beyond_68 = false;                           ///< sliding by (58) and "(67) or (68)", (68) as printed
    bool mu_at_high_frequency = false;                        ///< (86) as printed
    StickingForm sticking = StickingForm::exact;              ///< the boundary of permanent sticking
    bool argument_in_half_plane = false;                      ///< the argument of V_dj by the arcus tangent of a quotient
    bool no_half_period_for_minima = false;                   ///< (47) without the half-period where the mass is at a minimum
    bool beyond_the_boundary = false;                         ///< the closed form in every regime
    bool closed_form_alone = false;                           ///< no answer to the motion beyond the sliding regime
    double factor_in_23 = 2;                                  ///< of zeta R in (23)
    double sign_of_mu = 1;                                    ///< of mu / (gamma_j r^2) in (67)
    double power_of_r_in_65 = 2;                              ///< of r in (65)
    bool demand_as_printed = false;                           ///< (57) as printed, which needs `instants`
    std::optional<Instants> instants;                         ///< where the maximum of (57) is sought; none: everywhere
    bool without_load_condition = false;                      ///< (69) from the maximum alone, without the load condition (67)
    bool hysteretic = false;                                  ///< 2 zeta in place of 2 zeta R in (23)
    int harmonics = 0;                                        ///< highest harmonic of friction kept; 0: all
    std::function<void(PlainModes&)> change_modes;            ///< changes the modes before they are summed; empty: leaves them
    std::function<void(PlainModes&)> change_sums;             ///< changes the sums over the modes; empty: leaves them
};

/// @brief Modes and sums over modes of a question's scene.
struct PlainModes {
    std::size_t j = 0;                    ///< the mass in contact, from 0
    std::size_t l = 0;                    ///< the loaded mass, from 0
    double r = 0;                         ///< frequency ratio
    double beta = 0;                      ///< friction ratio
    double mu = 1;                        ///< static over kinetic friction
    std::vector<double> r_n;              ///< natural frequency ratios, ascending
    std::vector<double> R;                ///< modal frequency ratios, Eq. (22)
    std::vector<double> zeta;             ///< modal damping ratios
    std::vector<std::vector<double>> psi; ///< mode shapes, a row a mass
    std::vector<double> u;                ///< first damping functions of the modes, Eq. (28)
    std::vector<double> g;                ///< second damping functions of the modes, Eq. (29)
    std::vector<Complex<double>> v;       ///< complex response functions of the modes, Eq. (23)
    std::vector<Complex<double>> V;       ///< complex response functions of the masses, Eq. (33)
    std::vector<double> U;                ///< first damping functions of the masses, Eq. (34)
    std::vector<double> G;                ///< second damping functions of the masses, Eq. (35)
    Complex<double> Y_jj{0, 0};           ///< (33) with the load on the contact
    double H_j = 0;                       ///< Eq. (64)
    double sum_of_squares = 0;            ///< Eq. (65)
};

/// @brief Modes and sums of a question.
/// @param q  the question; places from 1 to N, positive ratios
/// @param c  the points of variation
/// @return   modes and sums; not finite at a pole of a mode without damping
/// @throws   InputError where a place is not there or the modes are none
[[nodiscard]] PlainModes plain_modes(const Question& q, const Choices& c);

/// @brief A displacement and its rate.
struct PlainMotion {
    double x = 0; ///< displacement, units of P / k_1
    double v = 0; ///< its derivative in tau
};

/// @brief Motion of a mass in the sliding regime at any instant, (46), or (41) from (44) and (45).
/// @param m    modes
/// @param c    the points of variation
/// @param k    the mass, from 0
/// @param tau  non-dimensional time, zero at the maximum of the contact
/// @return     the motion; beyond the half-period mirrored
[[nodiscard]] PlainMotion plain_motion(const PlainModes& m, const Choices& c, std::size_t k, double tau);

/// @brief Phase of the mass in contact, (39). @param m modes @param c the points of variation @return phi_j, not wrapped
[[nodiscard]] double plain_phase(const PlainModes& m, const Choices& c);

/// @brief Displacement and velocity of a mass at the maximum of the contact, (44), (45).
/// @param m  modes
/// @param c  the points of variation
/// @param k  the mass, from 0
/// @return   x_k0 and x'_k0
[[nodiscard]] PlainMotion plain_start(const PlainModes& m, const Choices& c, std::size_t k);

/// @brief Number of equal steps of the half-period that shows every oscillation of the modes.
/// @param m  modes
/// @return   the number
[[nodiscard]] int plain_steps(const PlainModes& m);

} // namespace denhartog::conformance
