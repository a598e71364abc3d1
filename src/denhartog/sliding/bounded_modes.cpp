// Bounds of the errors of modes. The eigensolver is assumed to be right to a few units in the last place, and the numbers of a
// scene to one; `with_errors` turns this into bounds of frequencies and shapes, (15). `bounded_mode_functions` carries them to
// (23), (28) and (29). `with_load_at` is the load of a base that moves alone, (K + i r C) 1, or of a wall, r^2 M 1 less that.
#include "denhartog/sliding/bounded_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/mode.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

using std::abs;
using std::min;
using std::sqrt;

using Number = Bounded<double>;

constexpr int trust = 8;         // units in the last place by which a mode of the eigensolver may be off
constexpr int units_of_mode = 8; // twice the error of the forms of v, u, g, in units, if they are well conditioned
constexpr int units_of_form = 4; // else they are off by no more than a change of R and zeta by so many units makes

Eigen::Map<const Column> column_of(const std::vector<double>& x) { return {x.data(), static_cast<Eigen::Index>(x.size())}; }

// Change of an entry of a mode if the mode turns by a unit angle: the root of the entry of the inverse mass matrix,
// which is that of a sum over all modes. A light mass moves far.
std::vector<double> reach_of_masses(const System<double>& system, const ModalBasis<double>& basis,
                                    const std::vector<Mass>* masses) {
    std::vector<double> reach;
    reach.reserve(static_cast<std::size_t>(basis.phi.rows()));
    for (Eigen::Index row = 0; row < basis.phi.rows(); ++row) {
        const std::size_t k = masses ? (*masses)[static_cast<std::size_t>(row)].index : static_cast<std::size_t>(row);
        reach.push_back(k < system.mass_ratios.size() ? 1 / sqrt(system.mass_ratios[k]) : basis.phi.row(row).norm());
    }
    return reach;
}

// The factor by which a full mass matrix multiplies errors: the largest diagonal entry of the inverse of the matrix scaled to a diagonal of
// ones. Its factor, and what is divided by it, have errors in proportion to the masses: how different these are does not matter.
double condition_of_masses(const System<double>& system, const std::vector<double>& reach) {
    double largest = 1;
    for (Eigen::Index k = 0; k < system.mass_matrix.rows(); ++k) {
        const double& reach_of_mass = reach[static_cast<std::size_t>(k)];
        largest = std::max(largest, system.mass_matrix(k, k) * reach_of_mass * reach_of_mass);
    }
    return largest;
}

// The factor by which springs multiply errors on the way to the squared frequencies of each mode; 0 if they are errors of the highest.
double factor_of_springs(const System<double>& system) {
    if (is_chain(system)) return 1;
    if (number_of_masses(system) == 1) return 0;
    return condition_of_graded(mass_factor(system), stiffness_matrix(system)).value_or(0);
}

// Errors that the solver is trusted with, and those of inputs.
ModalBasis<Bounded<double>> bounded(const System<double>& system, const ModalBasis<double>& basis,
                                    const std::vector<Mass>* masses) {
    const std::size_t N = basis.r_n.size();
    const double error_of_input = unit_of<double>(), unit = (trust * static_cast<int>(N) + 4) * error_of_input;
    const double growth_by_springs = factor_of_springs(system); // of errors of each frequency; of the highest where it is none
    const bool chain = growth_by_springs > 0;
    const double highest = basis.r_n.back();
    const Matrix<double> further = further_rows(system).cwiseAbs();
    const std::vector<double> errors_of_load = error_of_load(system);
    const auto first_of_load = static_cast<Eigen::Index>(load_row(system).index);
    ModalBasis<Bounded<double>> bounded;
    bounded.phi.resize(basis.phi.rows(), static_cast<Eigen::Index>(N));
    bounded.r_n.reserve(N);
    bounded.zeta.reserve(N);
    const std::vector<double> reach = reach_of_masses(system, basis, masses);
    const double error_of_matrix = unit * highest * highest * condition_of_masses(system, reach);
    Column sizes, errors(basis.phi.rows());
    for (std::size_t i = 0; i < N; ++i) {
        const double r_n = basis.r_n[i];
        const double error_of_square =
            chain ? 2 * unit * growth_by_springs * r_n * r_n : error_of_matrix; // error of the squared frequency
        bounded.r_n.push_back({r_n, error_of_square / (2 * r_n)});
        double nearest = std::numeric_limits<double>::infinity(); // difference of the squares, of the chain's relative to both
        for (const std::size_t n : {i - 1, i + 1}) {
            if (n >= N) continue;
            const double apart = abs(basis.r_n[n] - r_n) * (basis.r_n[n] + r_n);
            nearest = min(nearest, chain ? apart * r_n / std::max(basis.r_n[n], r_n) : apart);
        }
        const double turn = min(1.0, N == 1 ? unit : error_of_square / nearest + unit);
        const auto column = static_cast<Eigen::Index>(i);
        sizes = basis.phi.col(column).cwiseAbs();
        for (Eigen::Index row = 0; row < errors.size(); ++row) {
            errors(row) = turn * reach[static_cast<std::size_t>(row)];
            if (const Eigen::Index n = row - static_cast<Eigen::Index>(N); n >= 0) // a sum over the masses, which may cancel
                errors(row) += unit * further.row(n).dot(sizes.head(further.cols()));
            if (row >= first_of_load && !errors_of_load.empty())
                errors(row) += sizes.head(further.cols()).dot(column_of(errors_of_load));
            bounded.phi(row, column) = {basis.phi(row, column), errors(row)};
        }
        double error_of_zeta = error_of_input * basis.zeta[i];
        if (system.damping_matrix.size() > 0) { // the ratios are computed from it, whether it counts itself or not
            const auto n = static_cast<Eigen::Index>(N);
            const Column damping = product_of_sizes(system.damping_matrix, Column((sizes + errors).head(n)));
            error_of_zeta = (errors.head(n).dot(damping) + unit * sizes.head(n).dot(damping)) / r_n +
                            (turn + unit) * basis.zeta[i] * (1 + error_of_square / (r_n * r_n));
        }
        bounded.zeta.push_back({basis.zeta[i], error_of_zeta});
    }
    bounded.D = basis.D.unaryExpr([](const double& entry) { return Bounded<double>(entry); });
    bounded.distance_from_classical = Bounded<double>(basis.distance_from_classical);
    bounded.couples = basis.couples;
    return bounded;
}

// True if a sum over modes is smaller than the rounding errors of its terms.
template <class T>
bool without_a_digit(const ModeSums<T>& s, const Complex<T>& sum, const LoadRows& force) {
    const auto psi_j = mode_shapes_at(s, s.contact);
    T size(0);
    const auto add = [&](Mass row) {
        const auto psi_force = mode_shapes_at(s, row);
        for (std::size_t i = 0; i < s.R.size(); ++i) {
            const T factor = psi_j[i] * psi_force[i] * s.R[i] * s.R[i];
            size += (factor < 0 ? T(-factor) : factor) * modulus(s.v[i]);
        }
    };
    add(force.re);
    if (force.im) add(*force.im);
    return modulus(sum) <= static_cast<int>(s.R.size()) * std::numeric_limits<T>::epsilon() * size;
}

// Sums of the rows of a matrix, which may add up to next to nothing.
std::vector<Number> sums_of_rows(const Matrix<double>& A) {
    std::vector<Number> sums;
    for (Eigen::Index k = 0; k < A.rows(); ++k) {
        const double sum = evaluation::sum_with_rests<double>(A.row(k));
        sums.emplace_back(sum, 2 * unit_of<double>() * A.row(k).cwiseAbs().sum());
    }
    return sums;
}

// K 1: a chain is held by its first spring alone.
std::vector<Number> springs(const System<double>& s) {
    if (s.stiffness_matrix.size() > 0) return sums_of_rows(s.stiffness_matrix);
    std::vector<Number> k(s.stiffness_ratios.size(), Number(0));
    k.front() = as_input(s.stiffness_ratios.front());
    return k;
}

// C 1, by (19) if damping is given by ratios: M Phi diag(2 zeta_i r_ni) Phi^T M 1.
std::vector<Number> dampers(const System<double>& s, const std::vector<Number>& masses) {
    if (s.damping_matrix.size() > 0 && s.damping_tolerance == 0) return sums_of_rows(s.damping_matrix); // whatever the modes are
    const std::size_t N = masses.size();
    const ModalBasis<double> basis = modal_basis(s);
    if (damping_matrix_counts(s, basis)) return sums_of_rows(s.damping_matrix);
    const ModalBasis<Number> modes = with_errors(s, basis);
    const Matrix<double> M = mass_matrix(s);
    std::vector<Number> c(N, Number(0));
    for (std::size_t i = 0; i < N; ++i) {
        const auto shape = modes.phi.col(static_cast<Eigen::Index>(i));
        Number share(0);
        for (std::size_t k = 0; k < N; ++k) share = share + masses[k] * shape(static_cast<Eigen::Index>(k));
        share = share * (2 * modes.zeta[i] * modes.r_n[i]);
        for (std::size_t k = 0; k < N; ++k)
            for (std::size_t n = 0; n < N; ++n) {
                const double m = M(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(n));
                if (m != 0) c[k] = c[k] + as_input(m) * shape(static_cast<Eigen::Index>(n)) * share;
            }
    }
    return c;
}

double value(const Bounded<double>& number) { return number.x; }
Complex<double> value(const Complex<Bounded<double>>& z) { return {z.re.x, z.im.x}; }

template <class T>
auto values(const std::vector<T>& numbers) {
    std::vector<decltype(value(T{}))> out;
    out.reserve(numbers.size());
    for (const T& number : numbers) out.push_back(value(number));
    return out;
}

} // namespace

ModalBasis<Bounded<double>> with_errors(const System<double>& system, const ModalBasis<double>& basis) {
    return bounded(system, basis, nullptr);
}

ModalBasis<Bounded<double>> bounded_basis_at(const System<double>& system, const std::vector<Mass>& masses, Effort* effort) {
    const std::size_t N = number_of_masses(system);
    const bool masses_alone = std::ranges::all_of(masses, [N](Mass k) { return k.index < N; });
    if (N > 1 && is_chain(system) && system.damping_matrix.size() == 0 && masses_alone)
        return bounded(system, modal_basis_at(system, masses, effort), &masses);
    ModalBasis<Bounded<double>> all = with_errors(system, modal_basis(system, effort));
    Matrix<Bounded<double>> rows(static_cast<Eigen::Index>(masses.size()), all.phi.cols());
    for (std::size_t n = 0; n < masses.size(); ++n)
        rows.row(static_cast<Eigen::Index>(n)) = all.phi.row(static_cast<Eigen::Index>(masses[n].index));
    all.phi = std::move(rows);
    return all;
}

System<double> with_load_at(const System<double>& system, double r) {
    if (!load_depends_on_frequency(system)) return system;
    check_frequency_ratio(r);
    System<double> s = system;
    s.load_vector.assign(number_of_masses(s), 1); // any, until it is known
    s.load_phases.clear();
    s.load_error.clear();
    check(s);
    const bool wall = s.base_motion == BaseMotion::wall;
    const Number ratio = as_input(r);
    const std::vector<Number> m = sums_of_rows(mass_matrix(s)), k = springs(s), c = dampers(s, m);
    bool loads = false, ahead = false;
    for (std::size_t n = 0; n < m.size(); ++n) {
        const Number re = wall ? ratio * ratio * m[n] - k[n] : k[n], im = wall ? -(ratio * c[n]) : ratio * c[n];
        const bool out_of_phase = im.x != 0;
        s.load_vector[n] = out_of_phase ? elementary::hypot(re.x, im.x) : re.x;
        s.load_phases.push_back(out_of_phase ? elementary::atan2(im.x, re.x) : 0.0);
        s.load_error.push_back(re.e + im.e);
        loads = loads || s.load_vector[n] != 0;
        ahead = ahead || out_of_phase;
    }
    if (!ahead) s.load_phases.clear();
    if (!loads)
        throw DomainError("at r = " + number_to_text(r) +
                          " the motion of the wall loads no mass in its frame: the response is "
                          "that of a resonance without a load");
    return s;
}

ModeSums<double> values_of(const ModeSums<Bounded<double>>& s) {
    return {s.r.x,         s.contact,     s.load,      values(s.R),        values(s.zeta), values(s.w),
            values(s.psi), values(s.v),   values(s.u), values(s.g),        values(s.V),    values(s.U),
            values(s.G),   value(s.Y_jj), s.H_j.x,     s.sum_of_squares.x, s.coupled,      s.load_im};
}

ModalBasis<double> values_of(const ModalBasis<Bounded<double>>& basis) {
    const auto x = [](const Bounded<double>& a) { return a.x; };
    return {values(basis.r_n),    basis.phi.unaryExpr(x),          values(basis.zeta),
            basis.D.unaryExpr(x), basis.distance_from_classical.x, basis.couples};
}

evaluation::ModeFunctions<Bounded<double>> bounded_mode_functions(const Bounded<double>& R_i, const Bounded<double>& zeta_i) {
    const double &R = R_i.x, &zeta = zeta_i.x, unit = unit_of<double>();
    const double dzeta = zeta_i.e + units_of_form * unit * zeta;
    const double most_change = 1.0 / 64,
                 higher_orders = 17.0 / 16; // of what an error may change, relative, and what that leaves out
    if (zeta + dzeta < 1 && R_i.e < R) {
        const evaluation::ModeFunctions<double> f = evaluation::mode_functions(R, zeta);
        const double w = evaluation::oscillating_w(zeta), dR = (R_i.e / R + units_of_form * unit) * higher_orders;
        const double v = modulus(f.v), change_of_v = 2 * R * v * ((R + zeta) * dR + dzeta);
        const double real = R * w * f.u, imaginary = f.g + zeta * R * f.u, size_2 = real * real + imaginary * imaginary;
        const double change_of_w = dzeta / (w * w), dz = pi<double>() / R * (dR + dzeta / w) * higher_orders;
        if (change_of_v <= most_change && dz * (1 + size_2) <= most_change && change_of_w <= most_change) {
            const double u = abs(f.u), change_of_tangent = higher_orders * dz * (1 + size_2) / 2, own = units_of_mode * unit;
            const double error_of_v = v * (higher_orders * change_of_v + own);
            const double error_of_u = higher_orders * (change_of_tangent / (R * w) + u * (dR + zeta * change_of_w + own));
            const double error_of_g =
                higher_orders * (change_of_tangent * (1 + zeta / w) + abs(real) * change_of_w / w + abs(f.g) * own);
            return {{{f.v.re, error_of_v}, {f.v.im, error_of_v}}, {f.u, error_of_u}, {f.g, error_of_g}};
        }
    }
    return evaluation::mode_functions(R_i, zeta_i);
}

bool contact_is_unmoved(const ModeSums<double>& s) { return without_a_digit(s, s.V[s.contact.index], {s.load, s.load_im}); }
bool contact_is_unmoved(const ModeSums<Bounded<double>>& s) {
    const Bounded<double> size = modulus(s.V[s.contact.index]);
    return !(size.x > size.e);
}

template <class T>
bool stuck_system_resonates(const ModeSums<T>& s) {
    return without_a_digit(s, s.Y_jj, s.contact);
}

template bool stuck_system_resonates(const ModeSums<double>&);
template bool stuck_system_resonates(const ModeSums<Bounded<double>>&);

} // namespace denhartog
