#include "denhartog/model/coordinates.hpp"

#include <cstdint>
#include <span>

#include "denhartog/formulas/system.hpp"
#include "denhartog/number/multiprecision.hpp"
#include "denhartog/scene/converted.hpp"

namespace denhartog {
namespace {

template <class T>
using Wide = std::conditional_t<std::same_as<T, double>, Real50, Real100>;

template <class T>
using RowMajor = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Two coordinates and what they are: y_a = w^T x, y_b = p^T x.
template <class T>
struct TwoCoordinates {
    std::vector<T> w;
    std::vector<T> p;
    std::size_t a = 0;
    std::size_t b = 0;
    T determinant = T(0); // of the two equations for x_a and x_b
};

template <class T>
T size_of(const T& x) {
    return x < 0 ? T(-x) : x;
}

// The masses whose places contact and load take: those for which x is best told from y.
template <class T>
TwoCoordinates<T> two_coordinates(const System<T>& s) {
    const std::size_t N = number_of_masses(s);
    TwoCoordinates<T> two{std::vector<T>(N, T(0)), s.load_vector, 0, 0, T(0)};
    two.w[s.contact.index] = T(1);
    if (s.contact_with) two.w[s.contact_with->index] = T(-1);
    if (two.p.empty()) {
        two.p.assign(N, T(0));
        two.p[s.load.index] = T(1);
    }
    for (std::size_t a = 0; a < N; ++a)
        for (std::size_t b = 0; b < N; ++b) {
            if (a == b || two.w[a] == 0 || two.p[b] == 0) continue;
            const T determinant = two.w[a] * two.p[b] - two.w[b] * two.p[a];
            if (size_of(determinant) <= size_of(two.determinant)) continue;
            two.a = a;
            two.b = b;
            two.determinant = determinant;
        }
    if (two.determinant == 0) two.a = two.b = s.contact.index; // the load acts on the contact
    return two;
}

// Rows a and b of O; of one coordinate for both, row a.
template <class T>
Matrix<T> two_rows(const TwoCoordinates<T>& two) {
    const auto N = static_cast<Eigen::Index>(two.w.size());
    const bool one = two.a == two.b;
    Matrix<T> rows(one ? 1 : 2, N);
    for (Eigen::Index n = 0; n < N; ++n) {
        const auto k = static_cast<std::size_t>(n);
        const T &w_a = two.w[two.a], &p_a = two.p[two.a], &w_b = two.w[two.b], &p_b = two.p[two.b];
        if (one) {
            rows(0, n) = (k == two.a ? T(1) : T(-two.w[k])) / w_a;
        } else if (k == two.a) {
            rows(0, n) = p_b / two.determinant;
            rows(1, n) = -p_a / two.determinant;
        } else if (k == two.b) {
            rows(0, n) = -w_b / two.determinant;
            rows(1, n) = w_a / two.determinant;
        } else {
            rows(0, n) = (w_b * two.p[k] - p_b * two.w[k]) / two.determinant;
            rows(1, n) = (p_a * two.w[k] - w_a * two.p[k]) / two.determinant;
        }
    }
    return rows;
}

// A O, where O has ones on its diagonal and nothing else, but for rows a and b.
template <class T>
Matrix<T> times_coordinates(const Matrix<T>& A, const TwoCoordinates<T>& two, const Matrix<T>& rows) {
    Matrix<T> product = A;
    const std::size_t places[] = {two.a, two.b};
    for (Eigen::Index n = 0; n < rows.rows(); ++n) product.col(static_cast<Eigen::Index>(places[n])).setZero();
    for (Eigen::Index n = 0; n < rows.rows(); ++n) {
        const auto from = static_cast<Eigen::Index>(places[n]);
        for (Eigen::Index k = 0; k < A.cols(); ++k)
            if (rows(n, k) != 0)
                for (Eigen::Index i = 0; i < A.rows(); ++i) product(i, k) += A(i, from) * rows(n, k);
    }
    return product;
}

// O^T A O, symmetric to the last bit.
template <class T, class W>
Matrix<T> in_two_coordinates(const Matrix<W>& A, const TwoCoordinates<W>& two, const Matrix<W>& rows) {
    const Matrix<W> half = times_coordinates(A, two, rows).transpose();
    Matrix<T> all = in_type<T>(times_coordinates(half, two, rows));
    for (Eigen::Index i = 0; i < all.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k) all(i, k) = all(k, i);
    return all;
}

} // namespace

template <class T>
Matrix<T> mass_matrix(const System<T>& s) {
    if (s.mass_matrix.size() > 0) return s.mass_matrix;
    const auto N = static_cast<Eigen::Index>(s.mass_ratios.size());
    Matrix<T> M = Matrix<T>::Zero(N, N);
    for (Eigen::Index k = 0; k < N; ++k) M(k, k) = s.mass_ratios[static_cast<std::size_t>(k)];
    return M;
}

template <class T>
Matrix<T> stiffness_matrix(const System<T>& s) {
    if (s.stiffness_matrix.size() > 0) return s.stiffness_matrix;
    const auto N = static_cast<Eigen::Index>(s.stiffness_ratios.size());
    const std::vector<T> entries = paper::chain_stiffness_matrix(std::span<const T>(s.stiffness_ratios));
    return Eigen::Map<const RowMajor<T>>(entries.data(), N, N);
}

template <class T>
Scene<T> in_own_coordinates(const Scene<T>& scene) {
    if (is_of_papers_form(scene.system)) return scene;
    check(scene);
    using W = Wide<T>;
    const System<W> s = in_type<W>(scene.system);
    const TwoCoordinates<W> two = two_coordinates(s);
    const Matrix<W> rows = two_rows(two);
    Scene<T> out = scene;
    System<T>& t = out.system;
    t.contact = Mass{two.a};
    t.load = Mass{two.b};
    t.contact_with.reset();
    t.load_vector.clear();
    const std::size_t places[] = {two.a, two.b};
    std::vector<Eigen::Index> kept;
    for (const std::size_t n : two.a < two.b ? std::vector<std::size_t>{0, 1} : std::vector<std::size_t>{1, 0}) {
        if (static_cast<Eigen::Index>(n) >= rows.rows()) continue;
        const auto row = static_cast<Eigen::Index>(n);
        bool is_itself = true;
        for (Eigen::Index k = 0; k < rows.cols(); ++k)
            is_itself = is_itself && rows(row, k) == W(static_cast<std::size_t>(k) == places[n] ? 1 : 0);
        if (is_itself) continue;
        t.coordinates.replaced.push_back(Mass{places[n]});
        kept.push_back(row);
    }
    if (kept.empty()) return out;
    if (scene.system.contact_with) t.coordinates.between = {scene.system.contact, *scene.system.contact_with};
    t.coordinates.displacements = in_type<T>(Matrix<W>(rows(kept, Eigen::all)));
    t.coordinates.of_masses.resize(static_cast<Eigen::Index>(kept.size()), rows.cols());
    for (std::size_t n = 0; n < kept.size(); ++n)
        for (Eigen::Index k = 0; k < rows.cols(); ++k)
            t.coordinates.of_masses(static_cast<Eigen::Index>(n), k) =
                static_cast<T>((kept[n] == 0 ? two.w : two.p)[static_cast<std::size_t>(k)]);
    t.mass_matrix = in_two_coordinates<T>(mass_matrix(s), two, rows);
    t.stiffness_matrix = in_two_coordinates<T>(stiffness_matrix(s), two, rows);
    if (s.damping_matrix.size() > 0) t.damping_matrix = in_two_coordinates<T>(s.damping_matrix, two, rows);
    t.mass_ratios.clear();
    t.stiffness_ratios.clear();
    return out;
}

template Matrix<double> mass_matrix(const System<double>&);
template Matrix<double> stiffness_matrix(const System<double>&);
template Matrix<Real50> stiffness_matrix(const System<Real50>&);
template Matrix<Real100> stiffness_matrix(const System<Real100>&);
template Scene<double> in_own_coordinates(const Scene<double>&);
template Scene<Real50> in_own_coordinates(const Scene<Real50>&);
template Scene<Real100> in_own_coordinates(const Scene<Real100>&);

} // namespace denhartog
