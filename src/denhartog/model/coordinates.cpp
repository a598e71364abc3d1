#include "denhartog/model/coordinates.hpp"

#include <algorithm>
#include <span>

#include "denhartog/formulas/system.hpp"
#include "denhartog/number/double_double.hpp"
#include "denhartog/scene/converted.hpp"

namespace denhartog {
namespace {

template <class T>
using RowMajor = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// The displacement of the contact between two masses, y = x_j - x_k, in the place of mass a: x_a = y + x_b, or x_b - y.
struct OfContact {
    Eigen::Index a, b;
    int sign; // of x_a in y
};

// It takes the place of the lighter mass: the other then has the inertia of both, and neither hides in the rounding of the other.
template <class T>
OfContact of_contact(const System<T>& s) {
    const auto j = static_cast<Eigen::Index>(s.contact.index), k = static_cast<Eigen::Index>(s.contact_with->index);
    const Matrix<T> M = mass_matrix(s);
    return M(j, j) <= M(k, k) ? OfContact{j, k, 1} : OfContact{k, j, -1};
}

// O^T A O, symmetric to the last bit; O has ones on its diagonal and nothing else, but for row a.
template <class T, class W>
Matrix<T> in_coordinates_of(const OfContact& y, Matrix<W> A) {
    A.col(y.b) += A.col(y.a);
    A.row(y.b) += A.row(y.a);
    A.col(y.a) *= W(y.sign);
    A.row(y.a) *= W(y.sign);
    return in_type<T>(A);
}

// The load is on one coordinate where it can be said so.
template <class T>
void set_load(const std::vector<T>& p, System<T>& s) {
    const auto one = std::ranges::find(p, T(1));
    const bool on_one = one != p.end() && std::ranges::count(p, T(0)) + 1 == std::ssize(p);
    s.load_vector.clear();
    if (on_one) {
        s.load = Mass{static_cast<std::size_t>(one - p.begin())};
    } else {
        s.coordinates.load = p;
        s.load = Mass{p.size() + s.coordinates.replaced.size()};
    }
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
    using W = typename WiderOf<T>::type;
    const System<W> s = in_type<W>(scene.system);
    std::vector<W> p = s.load_vector.empty() ? load_on_coordinates(s) : s.load_vector;
    Scene<T> out = scene;
    System<T>& t = out.system;
    if (s.contact_with) {
        const OfContact y = of_contact(s);
        const auto N = static_cast<Eigen::Index>(p.size());
        Coordinates<T>& c = t.coordinates;
        c.replaced = {Mass{static_cast<std::size_t>(y.a)}};
        c.between = {scene.system.contact, *scene.system.contact_with};
        c.displacements = c.of_masses = Matrix<T>::Zero(1, N);
        c.displacements(0, y.a) = T(y.sign);
        c.displacements(0, y.b) = T(1);
        c.of_masses(0, y.a) = T(y.sign);
        c.of_masses(0, y.b) = T(-y.sign);
        t.contact = c.replaced.front();
        t.contact_with.reset();
        t.mass_matrix = in_coordinates_of<T>(y, mass_matrix(s));
        t.stiffness_matrix = in_coordinates_of<T>(y, stiffness_matrix(s));
        if (s.damping_matrix.size() > 0) t.damping_matrix = in_coordinates_of<T>(y, s.damping_matrix);
        t.mass_ratios.clear();
        t.stiffness_ratios.clear();
        const auto a = static_cast<std::size_t>(y.a), b = static_cast<std::size_t>(y.b);
        p[b] += p[a];
        p[a] *= y.sign;
    }
    set_load(in_type<T>(p), t);
    return out;
}

template Matrix<double> mass_matrix(const System<double>&);
template Matrix<double> stiffness_matrix(const System<double>&);
template Scene<double> in_own_coordinates(const Scene<double>&);

} // namespace denhartog
