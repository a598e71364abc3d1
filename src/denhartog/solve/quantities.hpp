/// @file
/// @brief The numbers of one point, each with a bound of its error: V, U, G, H, S, beta_lim, X_j, phi_j, and x_k at instants.
///
/// They are computed in double, on numbers that carry a bound of their error, and by the reference where that exceeds what is
/// asked for. The values handed out are doubles in every case; the bound then holds their rounding.
#pragma once

#include <optional>
#include <span>

#include "denhartog/answer/models_in_double.hpp"
#include "denhartog/evaluation/even_samples.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/solve/sampled_solution.hpp"
#include "denhartog/solve/solve.hpp"

namespace denhartog {

/// @brief The numbers of one point.
template <class T>
struct Quantities {
    std::vector<Complex<T>> V; ///< complex response functions of the masses, Eq. (33)
    std::vector<T> U;          ///< first damping functions of the masses, Eq. (34)
    std::vector<T> G;          ///< second damping functions of the masses, Eq. (35)
    T H_j{};                   ///< Eq. (64)
    T S{};                     ///< the maximum over tau of the sum over modes of (57)'s expression
    T beta_lim{};              ///< the boundary of the sliding regime, Eq. (69)
    std::optional<T> X_j;      ///< amplitude of the mass in contact, Eq. (38); none outside the sliding regime
    std::optional<T> phi_j;    ///< its phase, Eq. (39); radians in (-pi, pi]
    std::vector<T> x;          ///< displacements (41), N values an instant asked for; empty outside the sliding regime
    std::vector<T> x_prime;    ///< velocities with respect to tau, as many
    std::vector<T> x_size;     ///< amplitudes of the monoharmonic motions, Eq. (52): what errors of x and x' are relative to
};

/// @brief Lists all numbers of a point: name, mass, value, and the size that its error is relative to, which is |V| for the parts
/// of V, 1 for a phase, (52) for x_k.
template <class T, class Read>
void list(const Quantities<T>& q, const Read& read) {
    for (std::size_t k = 0; k < q.V.size(); ++k) {
        const T size = modulus(q.V[k]);
        read("Re V", k + 1, q.V[k].re, size);
        read("Im V", k + 1, q.V[k].im, size);
        read("U", k + 1, q.U[k], q.U[k]);
        read("G", k + 1, q.G[k], q.G[k]);
    }
    read("H", 0, q.H_j, q.H_j);
    read("S", 0, q.S, q.S);
    read("beta_lim", 0, q.beta_lim, q.beta_lim);
    if (!q.X_j) return;
    read("X_j", 0, *q.X_j, *q.X_j);
    read("phi_j", 0, *q.phi_j, T(1));
    const std::size_t N = q.x_size.size();
    for (std::size_t n = 0; n < q.x.size(); ++n) {
        read("x", n % N + 1, q.x[n], q.x_size[n % N]);
        read("x'", n % N + 1, q.x_prime[n], q.x_size[n % N]);
    }
}

/// @brief Which numbers of a point are asked for.
enum class PointNumbers : std::uint8_t {
    sums,   ///< V, U, G, H, S and beta_lim: what friction does not change
    motion, ///< x and x': the sums need not have the digits
    all     ///< both
};

/// @brief The numbers of a point with the digits asked for.
struct QuantitiesAnswer {
    Quantities<Bounded<double>> numbers; ///< values in double with their bounds
    Method method;                       ///< the method, and why it
    double relative = 0;                 ///< the largest bound of those asked for over its size, see `list`
};

/// @brief The numbers of a point to 1 to 15 digits, in double if its bounds have them, else by the reference. Instants may be
/// any; zero is at a maximum of x_j.
///
/// A number that the reference finds below 1e-25 of the largest of its kind, and to which its bound does not leave the digits,
/// comes out as zero with its bound: it is zero without being so by its formula, as at an antiresonance, or lies too low to tell.
/// InputError, at a pole of a mode without damping DomainError, PrecisionError where the digits are not reached.
/// @eq{33,34,35,38,39,41,56,64,69}
[[nodiscard]] QuantitiesAnswer quantities(const SceneSource& source, std::span<const double> tau, int digits,
                                          PointNumbers asked = PointNumbers::all,
                                          std::shared_ptr<const ModalBasis<Bounded<double>>> basis = nullptr);

/// @brief The quantities without friction: V, U, G, H, and S with the boundary. The sum over modes of (57)'s expression is
/// largest at `instant`, where 0 stands for the limit. @eq{33,34,35,56,64,69}
template <class T>
[[nodiscard]] Quantities<T> quantities_without_motion(const ModeSums<T>& s, const T& mu, const T& instant) {
    const std::size_t j = s.contact.index;
    Quantities<T> q;
    q.V = s.V;
    q.U = s.U;
    q.G = s.G;
    q.H_j = s.H_j;
    q.S = found_by_search(sliding_demand(s, instant));
    q.beta_lim =
        paper::friction_ratio_limit(s.V[j], s.U[j], larger(q.S, paper::static_friction_demand(s.H_j, mu, s.sum_of_squares)));
    return q;
}

/// @brief Adds the motion, where the friction ratio is below the boundary: X_j, phi_j, and x, x' at any instants, of which zero
/// is at a maximum of x_j. @eq{38,39,41,52}
template <class T>
void add_motion(Quantities<T>& q, const ModeSums<T>& s, const T& beta, const std::vector<T>& tau) {
    if (!(beta < q.beta_lim)) return;
    const SteadyState<T> state = steady_state_without_maxima(s, beta);
    q.X_j = state.X_j;
    q.phi_j = state.phi_j;
    for (const Motion<T>& at : motions(s, state, std::span<const T>(tau))) {
        q.x.insert(q.x.end(), at.x.begin(), at.x.end());
        q.x_prime.insert(q.x_prime.end(), at.x_prime.begin(), at.x_prime.end());
    }
    for (const MassResponse<T>& m : state.masses) q.x_size.push_back(m.amplitude_monoharmonic);
}

/// @brief All numbers of a point in double, of a contact between two masses too, which comes last. A search has its share of
/// `effort`.
[[nodiscard]] Quantities<Bounded<double>> quantities_in_double(const Scene<double>& scene, const ModeSums<Bounded<double>>& sums,
                                                               std::span<const double> tau, Effort* effort = nullptr);

/// @brief The closed form over a period.
struct SampledClosedForm {
    SampledSolution motion;                         ///< none outside the sliding regime
    std::vector<evaluation::ErrorOfSamples> errors; ///< bounds for each mass, of a motion that is in double
    QuantitiesAnswer found; ///< the numbers of the point, as far as they were needed, and how they were computed
};

/// @brief Samples the closed form, of which x_j has its maximum at tau = phi_j, to digits as `quantities` has them.
///
/// In double the instants are a recurrence over the half-period, mirrored in the other, with one bound for all of a mass. Where
/// that does not have the digits, and where damping couples the modes, each instant is one of `quantities`. The boundary is not
/// asked for where beta is known to be below.
/// @eq{38,39,41,46}
[[nodiscard]] SampledClosedForm sampled_closed_form(const SceneSource& source, double phi_j, std::size_t samples, int digits,
                                                    bool known_to_slide);

} // namespace denhartog
