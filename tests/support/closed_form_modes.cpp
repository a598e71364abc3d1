// The modes of the closed form in 50 and 100 digits.
#include <Eigen/Cholesky>
#include <limits>

#include "tests/support/closed_form.hpp"
#include "tests/support/rotations.hpp"

namespace denhartog {
namespace {

using Index = Eigen::Index;

// Twice the digits.
template <class T>
using Doubled = Multiprecision<2 * static_cast<unsigned>(std::numeric_limits<T>::digits10 / 50 * 50)>;

// Size of an entry of D between two modes that the roundings of a system's own numbers may cause.
template <class W>
W rounding_between(const std::vector<W>& r_n, const Matrix<W>& phi, const Matrix<W>& C, const Matrix<W>& D, Index i, Index k,
                   const W& unit) {
    const W &r_i = r_n[static_cast<std::size_t>(i)], &r_k = r_n[static_cast<std::size_t>(k)];
    const W size = phi.col(i).cwiseAbs().dot(C.cwiseAbs() * phi.col(k).cwiseAbs());
    const W apart = abs(W(r_i * r_i - r_k * r_k)), of_squares = unit * r_n.back() * r_n.back();
    const W angle = of_squares < apart ? W(of_squares / apart) : W(1);
    return unit * size + angle * abs(W(D(i, i) - D(k, k)));
}

// Turns modes whose frequencies coincide to those that diagonalise C among themselves.
template <class W>
void turn_where_equal(const std::vector<W>& r_n, const Matrix<W>& C, const W& unit, Matrix<W>& phi) {
    const Index N = static_cast<Index>(r_n.size());
    for (Index first = 0, last = 0; first < N; first = last + 1) {
        last = first;
        while (last + 1 < N && r_n[static_cast<std::size_t>(last + 1)] - r_n[static_cast<std::size_t>(last)] <= unit * r_n.back())
            ++last;
        if (last == first) continue;
        const Matrix<W> shapes = phi.middleCols(first, last - first + 1);
        Matrix<W> within = shapes.transpose() * C * shapes, turned;
        within = ((within + within.transpose()) / W(2)).eval();
        diagonalise(within, turned);
        phi.middleCols(first, last - first + 1) = shapes * turned;
    }
}

// Positive is the first component of a shape that has more than three eighths of the size of the largest.
template <class W>
void fix_signs_of(Matrix<W>& phi) {
    for (Index i = 0; i < phi.cols(); ++i) {
        const W size = W(3) / 8 * phi.col(i).cwiseAbs().maxCoeff();
        Index k = 0;
        while (k + 1 < phi.rows() && abs(phi(k, i)) <= size) ++k;
        if (phi(k, i) < 0) phi.col(i) = -phi.col(i);
    }
}

// D, and whether it couples modes; unless the ratios on its diagonal count alone.
template <class W, class T>
void set_damping(const System<T>& s, const Matrix<W>& M, const Matrix<W>& K, const std::vector<W>& r_n, Matrix<W>& phi,
                 ModalBasis<T>& basis) {
    const Matrix<W> C = widened<W>(s.damping_matrix);
    const Index N = C.rows();
    const W unit = 8 * static_cast<int>(N) * static_cast<W>(std::numeric_limits<T>::epsilon());
    const Matrix<W> L = M.llt().matrixL();
    const auto lower = L.template triangularView<Eigen::Lower>();
    const auto divided = [&](const Matrix<W>& X) { return Matrix<W>(lower.solve(Matrix<W>(lower.solve(X).transpose()))); };
    const Matrix<W> A = divided(K), B = divided(C);
    const W sizes = A.norm() * B.norm(), distance = sizes > 0 ? W(Matrix<W>(A * B - B * A).norm() / sizes) : W(0);
    const bool commutes = distance <= unit;
    const bool modal = N == 1 || sizes == 0 || (s.damping_tolerance > 0 && distance <= s.damping_tolerance);
    if (commutes || modal) turn_where_equal(r_n, C, unit, phi);
    fix_signs_of(phi); // D goes with them
    const Matrix<W> D = phi.transpose() * C * phi;
    basis.distance_from_classical = static_cast<T>(distance);
    for (Index i = 0; i < N; ++i) basis.zeta.push_back(static_cast<T>(W(D(i, i) / (2 * r_n[static_cast<std::size_t>(i)]))));
    if (modal) return;
    basis.D = widened<T>(D);
    basis.couples = !commutes;
    for (Index i = 0; i < N; ++i)
        for (Index k = 0; k < i; ++k)
            basis.couples = basis.couples || abs(D(i, k)) > rounding_between(r_n, phi, C, D, i, k, unit);
}

} // namespace

template <ManyDigits T>
ModalBasis<T> modal_basis(const System<T>& s) {
    using W = Doubled<T>;
    check(s);
    const Matrix<W> M = mass_of<W>(s), K = stiffness_of<W>(s);
    auto [r_n, phi] = modes_by_rotations(M, K);
    ModalBasis<T> basis;
    for (const W& each : r_n) basis.r_n.push_back(static_cast<T>(each));
    if (s.damping_matrix.size() > 0)
        set_damping(s, M, K, r_n, phi, basis);
    else
        basis.zeta = s.damping_ratios;
    fix_signs_of(phi);
    const Matrix<W> further = widened<W>(further_rows(s));
    basis.phi.resize(phi.rows() + further.rows(), phi.cols());
    basis.phi << widened<T>(phi), widened<T>(Matrix<W>(further * phi));
    return basis;
}

template ModalBasis<Real50> modal_basis(const System<Real50>&);
template ModalBasis<Real100> modal_basis(const System<Real100>&);

} // namespace denhartog
