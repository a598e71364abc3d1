/// @file
/// @brief The second witness: the steady sliding motion as a boundary-value problem on the physical coordinates.
///
/// Between a maximum of \f$ \bar{x}_j \f$ and the minimum after it, Eq. (12) is linear. With the load and the constant one taken
/// into the state, \f$ z = (\bar{x}, \bar{x}', \cos(\tau+\phi_j), \sin(\tau+\phi_j), 1) \f$, it is \f$ z' = Az \f$, whose exact
/// propagator is \f$ e^{A\tau} \f$. The steady state mirrors itself after half a period, Eq. (25), and starts where
/// \f$ \bar{x}_j' = 0 \f$, Eq. (30). Nothing here knows of modes, nor includes anything of `formulas/` or `evaluation/`.
#pragma once

#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A column over the masses.
template <class T>
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;

/// @brief What the boundary-value problem is made of.
template <class T>
struct HalfPeriodProblem {
    Matrix<T> M;     ///< non-dimensional mass matrix, Eq. (7), N x N, any topology
    Matrix<T> C;     ///< non-dimensional damping matrix, Eq. (7), N x N, any damping
    Matrix<T> K;     ///< non-dimensional stiffness matrix, Eq. (7), N x N
    Mass contact;    ///< the mass in contact, j
    Mass load;       ///< the loaded mass, l
    T beta = T(0);   ///< friction ratio, Eq. (11)
    Vector<T> w{};   ///< displacement of the contact over the masses, in place of `contact`; N values or none
    Vector<T> p{};   ///< force on each mass in units of P, in place of `load`; N values or none
    Vector<T> p_i{}; ///< what of it leads by a quarter of a period: the force is p cos - p_i sin; N values or none
};

/// @brief Displacement of the contact over the masses. @param p the problem @return w, or the unit vector of `contact`
template <class T>
[[nodiscard]] Vector<T> contact_vector(const HalfPeriodProblem<T>& p) {
    return p.w.size() > 0 ? p.w : Vector<T>::Unit(p.M.rows(), static_cast<Eigen::Index>(p.contact.index));
}

/// @brief Force on each mass. @param p the problem @return p, or the unit vector of `load`
template <class T>
[[nodiscard]] Vector<T> load_vector(const HalfPeriodProblem<T>& p) {
    return p.p.size() > 0 ? p.p : Vector<T>::Unit(p.M.rows(), static_cast<Eigen::Index>(p.load.index));
}

/// @brief What of the forces leads by a quarter of a period. @param p the problem @return p_i, or zeros
template <class T>
[[nodiscard]] Vector<T> leading_load(const HalfPeriodProblem<T>& p) {
    return p.p_i.size() > 0 ? p.p_i : Vector<T>::Zero(p.M.rows());
}

/// @brief The motion over the half-period, in units of P / k_1.
template <class T>
struct HalfPeriodMotion {
    Vector<T> x_0;              ///< displacements at tau = 0, N values
    Vector<T> x_prime_0;        ///< velocities with respect to tau at tau = 0, N values
    T phi_j;                    ///< phase of the mass in contact behind the load, radians, in (-pi, pi]
    Matrix<T> x;                ///< displacements, mass by instant, N x (steps + 1), at tau = pi n / steps
    Matrix<T> x_prime;          ///< velocities with respect to tau, mass by instant, N x (steps + 1)
    Vector<T> amplitude;        ///< largest displacement of each mass: a root of x_k', found from the largest sample, N values
    Vector<T> phase;            ///< lag of each mass behind the load there, Eq. (47), radians, in (-pi, pi], N values
    T contact_load;             ///< load on the contact at tau = 0, units of P: the contact leaves rest downwards above mu beta
    T largest_contact_velocity; ///< largest velocity of the contact at the instants strictly between 0 and pi
    T mirror_defect;            ///< largest |z(pi) + z(0)| over x and x', over the largest |x| and |x'|: the error left over
};

/// @brief Exponential of a square matrix, by scaling, Taylor's series and squaring.
/// @domain{finite entries}
/// @throws   DomainError where the result is not finite
template <class T>
[[nodiscard]] Matrix<T> matrix_exponential(const Matrix<T>& A);

/// @brief Matrix A of \f$ z' = Az \f$ with \f$ z = (\bar{x}, \bar{x}', \cos(\tau+\phi_j), \sin(\tau+\phi_j), 1) \f$.
/// @eq{12}  @domain{M regular}
template <class T>
[[nodiscard]] Matrix<T> augmented_system(const HalfPeriodProblem<T>& p);

/// @brief Solves (12) with \f$ \bar{x}(\pi)=-\bar{x}(0) \f$, \f$ \bar{x}'(\pi)=-\bar{x}'(0) \f$, \f$ \bar{x}_j'(0)=0 \f$.
///
/// The mirrored end gives \f$ (\bar{x}(0), \bar{x}'(0)) \f$ as a linear function of \f$ (\cos\phi_j, \sin\phi_j) \f$; rest of the
/// contact at \f$ \tau=0 \f$ is then a line in the plane of that pair, which meets the unit circle twice. Taken is the point
/// where \f$ \bar{x}_j(0) \f$ is larger: from there the contact moves down. Whether it does so all the way, `slides` tells.
/// The amplitudes are exact where the sample is fine enough to show which maximum is the largest.
/// @eq{12,25,30}  @domain{sliding motion that mirrors itself after half a period}
/// @throws       InputError for matrices of other sizes, indices out of range, numbers not finite;
///               DomainError where no phase fulfils the conditions or x_j(0) is not positive
template <class T>
[[nodiscard]] HalfPeriodMotion<T> half_period_motion(const HalfPeriodProblem<T>& p, int steps);

/// @brief Whether the motion keeps sliding: (54) on the sample, with the sign that a start downwards has.
/// @eq{54}
template <class T>
[[nodiscard]] bool slides(const HalfPeriodMotion<T>& motion, const T& mu, const T& beta);

} // namespace denhartog
