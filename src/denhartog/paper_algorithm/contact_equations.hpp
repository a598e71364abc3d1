/// @file
/// @brief The equations (6) as a system of first order, sliding and sticking, and the load on the contact (75).
///
/// A state is \f$ y = (\bar{x}, \bar{x}') \f$, 2N values. Nothing here allocates memory once the equations are set up.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {

/// @brief Matrices and vectors of (6), from ratios or from matrices that a user knows.
struct ContactProblem {
    NonDimensionalMatrices matrices;         ///< M, C, K of (6); symmetric, M positive definite
    Mass contact;                            ///< the mass in contact, j
    Mass load;                               ///< the loaded mass, l
    double mu = 1;                           ///< static over kinetic friction, Eq. (3); at least 1
    double beta = 0;                         ///< friction ratio, Eq. (11); not negative
    std::optional<Mass> contact_with{};      ///< the mass that the contact rubs against, instead of a wall
    std::vector<double> contact_direction{}; ///< w, instead of both; none where empty
    std::vector<double> load_vector{};       ///< force on each mass in units of P, instead of `load`
    std::vector<double> load_phases{};       ///< by how much each of them leads, radians; none where all are in phase
    std::vector<double> static_load{};       ///< constant force on each mass in units of P; none where empty
};

/// @brief The problem at the point of a scene.
/// @eq{7,8,19,73}
/// @param scene  the scene, with r and beta
/// @return       the problem
/// @throws       InputError where the scene breaks a rule or r or beta is missing
[[nodiscard]] ContactProblem contact_problem(const Scene<double>& scene);

/// @brief A harmonic part of the load on the contact, counted from an instant; the second factor is its rate there.
struct HarmonicLoad {
    double cosine; ///< of the cosine of the time since
    double sine;   ///< of its sine
};

/// @brief (6) solved for the accelerations, in the three forms that a phase can have.
class ContactEquations {
public:
    /// @brief Sets the equations up for sliding upwards.
    /// @param p  the problem
    /// @throws   InputError where it breaks a rule
    explicit ContactEquations(const ContactProblem& p);
    ContactEquations(const ContactEquations&) = delete;
    ContactEquations& operator=(const ContactEquations&) = delete;

    /// @brief Chooses the phase: sign of the contact's velocity, 0 while it sticks.
    /// @param direction  1, -1 or 0
    void set(int direction);

    /// @brief Derivative of a state. While the contact sticks, its acceleration and what it moves are zero and friction is
    /// whatever that takes: with the contact's velocity at zero, its displacement stays to the last bit.
    /// @eq{6}
    /// @param y        the state
    /// @param y_prime  gets its derivative
    /// @param tau      non-dimensional time, zero at a maximum of the force; radians
    void operator()(const std::vector<double>& y, std::vector<double>& y_prime, double tau) {
        ++evaluations;
        const double force = elementary::cos(tau), ahead = out_of_phase_ ? -elementary::sin(tau) : 0;
        const double* row = rows_;
        for (std::size_t k = 0; k < N; ++k, row += 2 * N) {
            double sum = friction_.data()[k] + load_column_[k] * force;
            if (out_of_phase_) sum += ahead_column_[k] * ahead;
            for (std::size_t n = 0; n < 2 * N; ++n) sum += row[n] * y[n];
            y_prime[k] = y[N + k];
            y_prime[N + k] = sum;
        }
    }

    /// @brief Load on the contact at rest: all that acts on it but friction. Its size is \f$ \Sigma_j \f$ of (75).
    ///
    /// A mass matrix with entries off the diagonal lets the moving masses load the contact by inertia as well, which (75) has
    /// no term for: row j is then that of the equations with the other accelerations eliminated.
    /// @eq{75}
    /// @param y    the state, the contact at rest
    /// @param tau  non-dimensional time; radians
    /// @return     the load, positive where it pushes the contact upwards, in units of P
    [[nodiscard]] double load_on_contact(std::span<const double> y, double tau) const;

    /// @brief The force's part of the load on the contact over a stretch of time. @param tau its start @return the factors
    [[nodiscard]] HarmonicLoad harmonic_load_at(double tau) const {
        const double c = elementary::cos(tau), s = elementary::sin(tau);
        HarmonicLoad at{harmonic_load.re * c, -harmonic_load.re * s};
        if (out_of_phase_) at = {at.cosine - harmonic_load.im * s, at.sine - harmonic_load.im * c};
        return at;
    }

    /// @brief Error of the load by rounding. @param y the state @return an absolute error, in units of P
    [[nodiscard]] double load_error(std::span<const double> y) const;

    /// @brief The load's part from displacements and velocities. @param y a state or its derivative @return its linear function
    [[nodiscard]] double linear_load(std::span<const double> y) const {
        double sum = 0;
        for (std::size_t n = 0; n < 2 * N; ++n) sum -= contact_row_.data()[n] * y[n];
        return sum;
    }

    std::size_t N;                 ///< number of masses
    Contact contact;               ///< the contact
    double beta;                   ///< friction ratio
    double mu;                     ///< static over kinetic friction
    Complex<double> harmonic_load; ///< complex amplitude of the force's part of the load on the contact
    double static_load = 0;        ///< the constant forces' part of it
    double compliance;             ///< acceleration of the contact that a unit force on it makes
    long evaluations = 0;          ///< right-hand sides evaluated

private:
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> sliding_, sticking_; // N x 2N, per unit of y
    Eigen::VectorXd sliding_load_, sticking_load_, contact_column_; // accelerations per unit of force, and on the contact
    Eigen::VectorXd sliding_static_, sticking_static_;              // accelerations by constant forces, or none
    Eigen::VectorXd sliding_ahead_, sticking_ahead_; // those by the parts of the forces a quarter of a period ahead
    Eigen::VectorXd friction_;                       // acceleration by friction in this phase, and by these
    Eigen::RowVectorXd contact_row_;                 // K and C of the contact's row, 2N
    const double *rows_ = nullptr, *load_column_ = nullptr, *ahead_column_ = nullptr; // of this phase
    bool out_of_phase_ = false;
    Complex<double> direct_load_, inertial_load_; // of the force: what acts on the contact itself, and what the others pass on
};

} // namespace denhartog
