/// @file
/// @brief The systems on which statements of Sections 3.2 and 4 are measured, their amplitudes and resonant peaks.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "denhartog/sliding/steady_state.hpp"
#include "derivation/observations/observation.hpp"

namespace denhartog::derivation {

/// @brief A system with its modal basis.
struct ObservedSystem {
    std::string name;         ///< its name, with the damping ratio
    double zeta;              ///< the damping ratio it is named by
    System<double> system;    ///< the system
    ModalBasis<double> basis; ///< its modes
};

/// @brief A system with its modes. @param name its name @param zeta its damping ratio @param system the system @return both
[[nodiscard]] ObservedSystem observed_system(const std::string& name, double zeta, const System<double>& system);

/// @brief The damping ratios of Figs. 6 to 10. @return 0.001, 0.01, 0.1
[[nodiscard]] const std::vector<double>& damping_ratios_of_figures();

/// @brief The paper's four systems at one of its damping ratios. @param zeta damping ratio @return SDOF, 2DOF, 5DOF j = 1, j = 3
[[nodiscard]] std::vector<ObservedSystem> systems_of_the_paper(double zeta);

/// @brief The paper's four systems at its three damping ratios, made once. @return twelve systems
[[nodiscard]] const std::vector<ObservedSystem>& systems_of_the_paper();

/// @brief The damping ratio up to which a statement on lightly damped systems holds, from 1e-6 to 0.1, by halving.
/// @param largest  what the statement bounds, at a damping ratio; taken to grow with it
/// @param bound    the bound
/// @return         the damping ratio; 0 where the statement fails at 1e-6 already
[[nodiscard]] double damping_ratio_up_to(const std::function<double(double zeta)>& largest, double bound);

/// @brief Modes and sums at a frequency ratio. @param s a system @param r frequency ratio @return the sums
[[nodiscard]] ModeSums<double> sums_at(const ObservedSystem& s, double r);

/// @brief (52), which for the mass in contact is (38). @param m sums over modes @param k a mass @param beta friction ratio
/// @return  the amplitude; not a number where (38) has no root
[[nodiscard]] double monoharmonic_amplitude(const ModeSums<double>& m, std::size_t k, double beta);

/// @brief A resonance as witness. @param s a system @param k a mass @param i a mode @return system, mass, mode, r_n,i
[[nodiscard]] Witness place(const ObservedSystem& s, std::size_t k, std::size_t i);

/// @brief A maximum over the frequency ratio.
struct Peak {
    double r; ///< where
    double X; ///< its height
};

/// @brief The local maximum of (52) next to a natural frequency ratio, by a scan and Brent's method.
///
/// Looked for within three tenths of the resonance, but no farther than nearly half the way to the next one.
/// @param s     a system
/// @param k     a mass
/// @param i     a mode
/// @param beta  friction ratio
/// @return      the peak; none where there is no maximum or the contact does not slide there, mu = 1
[[nodiscard]] std::optional<Peak> peak_near(const ObservedSystem& s, std::size_t k, std::size_t i, double beta);

/// @brief \f$ |\psi_{li}/\psi_{ji}| \f$ of a mode. @param s a system @param i a mode @return the ratio
[[nodiscard]] double ratio_of_shapes(const ObservedSystem& s, std::size_t i);

/// @brief The friction ratio from which the contact stops at a natural frequency ratio, (69), mu = 1. @param s a system
/// @param i a mode @return beta_lim
[[nodiscard]] double limit_at(const ObservedSystem& s, std::size_t i);

} // namespace denhartog::derivation
