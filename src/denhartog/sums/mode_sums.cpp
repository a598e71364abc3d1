#include "denhartog/sums/mode_sums.hpp"

#include <boost/container/small_vector.hpp>
#include <boost/math/special_functions/fpclassify.hpp>
#include <utility>

#include "denhartog/formulas/superposition.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

template <class T>
void check_arguments(const ModalBasis<T>& basis, Mass contact, Mass load, const T& r) {
    const auto N = static_cast<std::size_t>(basis.phi.rows());
    check_frequency_ratio(r);
    for (const auto& [name, mass] : {std::pair("contact", contact), std::pair("load", load)}) check_mass(mass, N, name);
    check_uncoupled(basis);
}

template <class T>
void check_pole(const evaluation::ModeFunctions<T>& f, std::size_t i, const T& R, const T& zeta) {
    const bool v_finite = boost::math::isfinite(f.v.re) && boost::math::isfinite(f.v.im);
    if (v_finite && boost::math::isfinite(f.u) && boost::math::isfinite(f.g)) return;
    if (zeta > 0)
        throw PrecisionError("the functions (23), (28), (29) of mode " + std::to_string(i + 1) + " at R = " + number_to_text(R) +
                             " are beyond the range of the number type");
    throw DomainError("mode " + std::to_string(i + 1) + " has no damping and R = " + number_to_text(R) + ": its " +
                      (v_finite
                           ? "first damping function (28) is infinite there, and the boundary (69) falls to zero in the limit"
                           : "complex response function (23) is infinite there, and so is the amplitude in the limit"));
}

// What sums over modes may be off by because a damping matrix couples the modes by less than rounding tells.
//
// With \f$ Q_i \f$ the share of mode i in the motion, \f$ x_k = \sum_i \psi_{ki}Q_i \f$, what is left out of (20) is a force
// \f$ -\sum_m (E_{im}/r)\,Q_m' \f$ on it, of which bounds of E are known. The response of a mode to any force that changes its
// sign after half a period is at most \f$ \int_0^\pi|\Gamma_i| \f$ times the largest force, with the kernel
// \f[ \Gamma_i(\tau) = \frac{R_i}{w_i}\,\mathrm{Im}\frac{e^{\rho_i\tau}}{1+e^{\rho_i\pi}}, \qquad
//     \rho_i = \frac{-\zeta_i+\mathrm{i}w_i}{R_i}, \qquad \frac{1}{|1+e^{\rho_i\pi}|} = \frac{w_i}{2}\,|c_i|, \f]
// where the brace of (40) is \f$ 1 - \mathrm{Re}\{c_ie^{\rho_i\tau}\} \f$. It is therefore at most \f$ \pi|c_i|R_i/2 \f$ times
// that force, its derivative \f$ \pi|c_i|/2 \f$ times. From \f$ \zeta_i = 1/2 \f$ on the response to an impulse dies away within
// a swing: \f$ 2R_i^2 \f$ and \f$ 2R_i \f$ bound both, and the brace has \f$ R_i|y_i'| \le 2 \f$,
// \f$ R_i^2|y_i''| \le 3+4\zeta_i \f$.
//
// What is left out exerts such forces in its turn. Where these are below half of it, which is asked for, they at most double the
// largest of all modes.

// A mode as it answers to the forces of others and exerts forces on them: bounds.
struct ModeUnderCoupling {
    double gain;         // amplitude under a unit harmonic force
    double kernel;       // largest response to a unit force that changes its sign
    double kernel_prime; // its largest derivative
    double of_load;      // amplitude under the load
    double of_contact;   // amplitude under a unit harmonic force on the contact
    double speed;        // largest derivative under the friction force
    double acceleration; // largest second derivative
};

// The bounds of a mode.
ModeUnderCoupling mode_under_coupling(const ModeSums<Bounded<double>>& s, std::size_t i) {
    const double R = s.R[i].most(), gain = R * R * modulus(s.v[i]).most();
    const double psi_j = mode_shapes_at(s, s.contact)[i].most(), psi_l = mode_shapes_at(s, s.load)[i].most();
    if (s.zeta[i].least() >= 0.5)
        return {gain, 2 * R * R, 2 * R, gain * psi_l, gain * psi_j, 2 * R * psi_j, (3 + 4 * s.zeta[i].most()) * psi_j};
    const double c = amplitude_of_brace(s, i).most(), half_turn = 11.0 / 7; // more than pi / 2
    return {gain, half_turn * c * R, half_turn * c, gain * psi_l, gain * psi_j, c * R * psi_j, c * psi_j};
}

// Nothing is left out where numbers have no bounds.
template <class T>
std::vector<LeftOut<T>> left_out_coupling(const ModalBasis<T>&, const ModeSums<T>&) {
    return {};
}

// Bounds of what the coupling left out makes of the motion of each row of the shapes. There are none where nothing is
// left out, and infinite ones where the forces of what is left out are not small. The sums of `s` are not used. (33), (40)
std::vector<LeftOut<double>> left_out_coupling(const ModalBasis<Bounded<double>>& basis, const ModeSums<Bounded<double>>& s) {
    if (basis.left_out.size() == 0) return {};
    const std::size_t N = basis.r_n.size();
    std::vector<ModeUnderCoupling> modes;
    for (std::size_t i = 0; i < N; ++i) modes.push_back(mode_under_coupling(s, i));
    // Forces on each mode: of the motion without coupling, then of what is left out as well.
    struct Forces {
        double load{}, contact{}, friction{}, friction_prime{}, of_unit{};
    };
    std::vector<Forces> forces(N);
    double V = 0, Y = 0, x_prime = 0, x_double_prime = 0, largest = 0;
    const auto acceleration_of = [&](std::size_t i) { // of what the force of friction's share makes
        const double rate = 1 / s.R[i].least(), force = forces[i].friction;
        return (2 * s.zeta[i].most() * rate * modes[i].kernel_prime + rate * rate * modes[i].kernel + 1) * force;
    };
    for (std::size_t i = 0; i < N; ++i) {
        Forces& on = forces[i];
        for (std::size_t m = 0; m < N; ++m) {
            const double E = basis.left_out(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(m)).x / s.r.least();
            on.load += E * modes[m].of_load;
            on.contact += E * modes[m].of_contact;
            on.friction += E * modes[m].speed;
            on.friction_prime += E * modes[m].acceleration;
            on.of_unit += E;
        }
        V = std::max(V, modes[i].gain * on.load);
        Y = std::max(Y, modes[i].gain * on.contact);
        x_prime = std::max(x_prime, modes[i].kernel_prime * on.friction);
        largest = std::max(largest, std::max(modes[i].gain, modes[i].kernel_prime) * on.of_unit);
    }
    const double slack = 2 * largest < 1 ? 17.0 / 16 : std::numeric_limits<double>::infinity(); // roundings, or there is no bound
    for (std::size_t i = 0; i < N; ++i) {
        forces[i].load += 2 * forces[i].of_unit * V;
        forces[i].contact += 2 * forces[i].of_unit * Y;
        forces[i].friction += 2 * forces[i].of_unit * x_prime;
        x_double_prime = std::max(x_double_prime, acceleration_of(i));
    }
    std::vector<LeftOut<double>> rows(s.psi.size() / N);
    for (std::size_t i = 0; i < N; ++i) {
        const Forces& on = forces[i];
        const double rate = 1 / s.R[i].least(), acceleration = acceleration_of(i);
        const double jerk = 2 * s.zeta[i].most() * rate * acceleration + rate * rate * modes[i].kernel_prime * on.friction +
                            on.friction_prime + on.of_unit * x_double_prime;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const double psi = slack * mode_shapes_at(s, Mass{k})[i].most();
            rows[k].V += psi * modes[i].gain * on.load;
            rows[k].Y += psi * modes[i].gain * on.contact;
            rows[k].x += psi * modes[i].kernel * on.friction;
            rows[k].x_prime += psi * modes[i].kernel_prime * on.friction;
            rows[k].x_double_prime += psi * acceleration;
            rows[k].x_triple_prime += psi * jerk;
        }
    }
    return rows;
}

// Whether a sum over modes is smaller than the rounding errors of its terms.
template <class T>
bool without_a_digit(const ModeSums<T>& s, const Complex<T>& sum, Mass force) {
    const auto psi_j = mode_shapes_at(s, s.contact);
    const auto psi_force = mode_shapes_at(s, force);
    T size(0);
    for (std::size_t i = 0; i < s.R.size(); ++i) {
        const T factor = psi_j[i] * psi_force[i] * s.R[i] * s.R[i];
        size += (factor < 0 ? T(-factor) : factor) * modulus(s.v[i]);
    }
    return modulus(sum) <= static_cast<int>(s.R.size()) * std::numeric_limits<T>::epsilon() * size;
}

} // namespace

template <class T>
std::vector<evaluation::ModeFunctions<T>> mode_functions_at(const ModalBasis<T>& basis, const T& r) {
    std::vector<evaluation::ModeFunctions<T>> functions;
    functions.reserve(basis.r_n.size());
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const T R = r / basis.r_n[i];
        functions.push_back(evaluation::mode_functions(R, basis.zeta[i]));
        check_pole(functions.back(), i, R, basis.zeta[i]);
        ++work_counted.mode_evaluations;
    }
    return functions;
}

template <class T>
ModeSums<T> mode_sums(const ModalBasis<T>& basis, Mass contact, Mass load, const T& r) {
    check_arguments(basis, contact, load, r);
    return mode_sums(basis, contact, load, r, mode_functions_at(basis, r));
}

template <class T>
ModeSums<T> mode_sums(const ModalBasis<T>& basis, Mass contact, Mass load, const T& r,
                      const std::vector<evaluation::ModeFunctions<T>>& functions) {
    check_arguments(basis, contact, load, r);
    const std::size_t N = basis.r_n.size();
    ModeSums<T> s;
    s.r = r;
    s.contact = contact;
    s.load = load;
    s.zeta = basis.zeta;
    const auto rows = static_cast<std::size_t>(basis.phi.rows());
    // The row of a load on several masses, behind all others, is that of a displacement where it is the contact's alone.
    const std::size_t masses = load.index < N || load == contact ? rows : load.index;
    s.psi.reserve(rows * N);
    for (std::size_t k = 0; k < rows; ++k)
        for (std::size_t i = 0; i < N; ++i) s.psi.push_back(basis.phi(k, i) / r);
    for (std::vector<T>* of_modes : {&s.R, &s.w, &s.u, &s.g}) of_modes->reserve(N);
    for (std::vector<T>* of_masses : {&s.U, &s.G}) of_masses->reserve(masses);
    s.v.reserve(N);
    s.V.reserve(masses);
    for (std::size_t i = 0; i < N; ++i) {
        s.R.push_back(r / basis.r_n[i]);
        s.w.push_back(evaluation::w_if_oscillating(s.zeta[i]));
        s.v.push_back(functions[i].v);
        s.u.push_back(functions[i].u);
        s.g.push_back(functions[i].g);
    }
    s.left_out = left_out_coupling(basis, s);
    const auto zero_pair = [](const auto& bound) { return Complex<T>{zero_within<T>(bound), zero_within<T>(bound)}; };
    const auto psi_j = mode_shapes_at(s, contact);
    const auto psi_l = mode_shapes_at(s, load);
    const std::span<const T> R(s.R), zeta(s.zeta), u(s.u), g(s.g);
    const std::span<const Complex<T>> v(s.v);
    for (std::size_t k = 0; k < masses; ++k) {
        const auto psi_k = mode_shapes_at(s, Mass{k});
        const auto left_out = left_out_of(s, Mass{k});
        s.V.push_back(paper::complex_response_of_mass(psi_k, psi_l, R, v, zero_pair(left_out.V)));
        s.U.push_back(paper::damping_function_of_mass(psi_k, psi_j, R, u, zero_within<T>(left_out.x_prime)));
        s.G.push_back(paper::damping_function_of_mass(psi_k, psi_j, R, g, zero_within<T>(left_out.x)));
    }
    const auto left_out = left_out_of(s, contact);
    s.Y_jj = paper::complex_response_of_mass(psi_j, psi_j, R, v, zero_pair(left_out.Y));
    s.H_j = paper::H(psi_j, R, zeta, u, g, zero_within<T>(left_out.x_double_prime));
    const boost::container::small_vector<T, 8> ones(N, T(1));
    s.sum_of_squares = paper::sum_over_contact(psi_j, std::span<const T>(ones.data(), N));
    return s;
}

template <class T>
bool contact_is_unmoved(const ModeSums<T>& sums) {
    return without_a_digit(sums, sums.V[sums.contact.index], sums.load);
}

template <class T>
bool stuck_system_resonates(const ModeSums<T>& sums) {
    return without_a_digit(sums, sums.Y_jj, sums.contact);
}

template ModeSums<double> mode_sums(const ModalBasis<double>&, Mass, Mass, const double&);
template ModeSums<Bounded<double>> mode_sums(const ModalBasis<Bounded<double>>&, Mass, Mass, const Bounded<double>&);
template ModeSums<Bounded<double>> mode_sums(const ModalBasis<Bounded<double>>&, Mass, Mass, const Bounded<double>&,
                                             const std::vector<evaluation::ModeFunctions<Bounded<double>>>&);
template std::vector<evaluation::ModeFunctions<Bounded<double>>> mode_functions_at(const ModalBasis<Bounded<double>>&,
                                                                                   const Bounded<double>&);
template bool contact_is_unmoved(const ModeSums<double>&);
template bool contact_is_unmoved(const ModeSums<Bounded<double>>&);
template bool stuck_system_resonates(const ModeSums<double>&);
template bool stuck_system_resonates(const ModeSums<Bounded<double>>&);

} // namespace denhartog
