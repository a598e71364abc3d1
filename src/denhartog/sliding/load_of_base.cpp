// Which load on the masses does the motion of a base or wall make? (K + i r C) 1 for a base that moves alone, and r^2 M 1 less
// that for a wall. Read `with_load_at` first.
#include "denhartog/sliding/load_of_base.hpp"

#include <algorithm>
#include <vector>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

using Number = Bounded<double>;

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

} // namespace

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

} // namespace denhartog
