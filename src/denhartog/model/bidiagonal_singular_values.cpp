#include "denhartog/model/bidiagonal_singular_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog {
namespace {

using std::abs;
using std::sqrt;

/// The plane rotation that takes (f, g) to (r, 0): c f + s g = r, c g - s f = 0.
template <class T>
struct Rotation {
    T c, s, r;
};

template <class T>
Rotation<T> rotation(const T& f, const T& g) {
    if (g == 0) return {T(1), T(0), f};
    if (f == 0) return {T(0), T(1), g};
    const bool f_leads = abs(f) > abs(g);
    const T t = f_leads ? T(g / f) : T(f / g);
    const T length = sqrt(T(1 + t * t));
    const T larger = 1 / length;
    if (f_leads) return {larger, t * larger, f * length};
    return {t * larger, larger, g * length};
}

/// Smaller singular value of the triangle [f g; 0 h], without overflow.
template <class T>
T smaller_singular_value(const T& f, const T& g, const T& h) {
    const T small = std::min<T>(abs(f), abs(h));
    const T large = std::max<T>(abs(f), abs(h));
    if (small == 0) return T(0);
    const T a = 1 + small / large;
    const T b = (large - small) / large;
    if (abs(g) < large) {
        const T q = abs(g) / large;
        return small * (2 / (sqrt(T(a * a + q * q)) + sqrt(T(b * b + q * q))));
    }
    const T q = large / abs(g);
    return 2 * small * q / (sqrt(T(1 + (a * q) * (a * q))) + sqrt(T(1 + (b * q) * (b * q))));
}

/// A diagonal block first..last without zeros beside its diagonal. Seen from the bottom it is transposed and reversed: the view
/// is upper bidiagonal again, and its left singular vectors are the right ones of the block.
template <class T>
struct DiagonalBlock {
    std::vector<T>& d;
    std::vector<T>& e;
    Matrix<T>& V;
    std::size_t first, last;
    bool from_bottom;

    std::size_t size() const { return last - first + 1; }
    T& diagonal(std::size_t i) { return from_bottom ? d[last - i] : d[first + i]; }
    T& beside(std::size_t i) { return from_bottom ? e[last - 1 - i] : e[first + i]; }

    /// Turns the singular vectors i and i + 1 of the view by its right or left rotation, whichever acts on ours.
    void turn(std::size_t i, const Rotation<T>& right, const Rotation<T>& left) {
        const Rotation<T>& by = from_bottom ? left : right;
        const Eigen::Index N = V.rows();
        T* x = V.data() + N * static_cast<Eigen::Index>(from_bottom ? last - i : first + i);
        T* y = V.data() + N * static_cast<Eigen::Index>(from_bottom ? last - i - 1 : first + i + 1);
        const T c = by.c;
        const T s = by.s;
        for (Eigen::Index k = 0; k < N; ++k) {
            const T x_k = x[k];
            x[k] = c * x_k + s * y[k];
            y[k] = c * y[k] - s * x_k;
        }
    }
};

/// What the tests for convergence find in a block.
template <class T>
struct Estimate {
    bool split = false; ///< an entry was negligible and is zero now
    T smallest = T(0);  ///< lower estimate of the smallest singular value
    T largest = T(0);   ///< largest entry
};

/// Sets entries beside the diagonal to zero that change no singular value by more than a relative `tolerance`.
template <class T>
Estimate<T> test(DiagonalBlock<T>& block, const T& tolerance) {
    const std::size_t n = block.size();
    Estimate<T> found;
    if (abs(block.beside(n - 2)) <= tolerance * abs(block.diagonal(n - 1))) {
        block.beside(n - 2) = T(0);
        found.split = true;
        return found;
    }
    T distance = abs(block.diagonal(0));
    found.smallest = distance;
    found.largest = distance;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const T e = abs(block.beside(i));
        if (e <= tolerance * distance) {
            block.beside(i) = T(0);
            found.split = true;
            return found;
        }
        const T d = abs(block.diagonal(i + 1));
        distance = d * (distance / (distance + e));
        found.smallest = std::min(found.smallest, distance);
        found.largest = std::max({found.largest, d, e});
    }
    return found;
}

/// One sweep without shift: every entry keeps its relative accuracy, for there are no subtractions.
template <class T>
void sweep_without_shift(DiagonalBlock<T>& block) {
    const std::size_t n = block.size();
    Rotation<T> left{T(1), T(0), T(0)};
    T c = T(1);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const Rotation<T> right = rotation(T(block.diagonal(i) * c), block.beside(i));
        if (i > 0) block.beside(i - 1) = left.s * right.r;
        left = rotation(T(left.c * right.r), T(block.diagonal(i + 1) * right.s));
        block.diagonal(i) = left.r;
        c = right.c;
        block.turn(i, right, left);
    }
    const T rest = block.diagonal(n - 1) * c;
    block.diagonal(n - 1) = rest * left.c;
    block.beside(n - 2) = rest * left.s;
}

/// One sweep of the QR iteration with a shift.
template <class T>
void sweep_with_shift(DiagonalBlock<T>& block, const T& shift) {
    const std::size_t n = block.size();
    const T d_0 = block.diagonal(0);
    T f = (abs(d_0) - shift) * ((d_0 > 0 ? T(1) : T(-1)) + shift / d_0);
    T g = block.beside(0);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        T& d = block.diagonal(i);
        T& e = block.beside(i);
        T& d_next = block.diagonal(i + 1);
        const Rotation<T> right = rotation(f, g);
        if (i > 0) block.beside(i - 1) = right.r;
        f = right.c * d + right.s * e;
        e = right.c * e - right.s * d;
        g = right.s * d_next;
        d_next = right.c * d_next;
        const Rotation<T> left = rotation(f, g);
        d = left.r;
        f = left.c * e + left.s * d_next;
        d_next = left.c * d_next - left.s * e;
        if (i + 2 < n) {
            g = left.s * block.beside(i + 1);
            block.beside(i + 1) = left.c * block.beside(i + 1);
        }
        block.turn(i, right, left);
    }
    block.beside(n - 2) = f;
}

/// The shift for the next sweep: the smaller singular value of the last two rows of the view, or zero where it would cost digits.
template <class T>
T shift_for(DiagonalBlock<T>& block, const Estimate<T>& found, int N) {
    if (found.largest > 4 * N * found.smallest) return T(0);
    const std::size_t n = block.size();
    const T shift = smaller_singular_value(block.diagonal(n - 2), block.beside(n - 2), block.diagonal(n - 1));
    const T ratio = shift / block.diagonal(0);
    return ratio * ratio < std::numeric_limits<T>::epsilon() ? T(0) : shift;
}

/// Values positive and ascending, vectors with them.
template <class T>
SingularValues<T> in_order(const std::vector<T>& d, const Matrix<T>& V, long sweeps) {
    const std::size_t N = d.size();
    std::vector<std::size_t> order(N);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return abs(d[a]) < abs(d[b]); });
    SingularValues<T> result{std::vector<T>(N), Matrix<T>(V.rows(), V.cols()), sweeps};
    for (std::size_t i = 0; i < N; ++i) {
        result.sigma[i] = abs(d[order[i]]);
        result.V.col(i) = V.col(order[i]);
    }
    return result;
}

/// The iteration; V starts as rows of the identity.
template <class T>
SingularValues<T> iterate(std::vector<T> d, std::vector<T> e, Matrix<T> V) {
    const std::size_t N = d.size();
    const T tolerance = 8 * std::numeric_limits<T>::epsilon();
    const double rotations_allowed =
        2.0 * std::numeric_limits<T>::digits * static_cast<double>(N) * static_cast<double>(N) + 1000;
    double rotations = 0;
    long sweeps = 0;
    DiagonalBlock<T> block{d, e, V, N, 0, false};
    std::size_t end = N;
    while (true) {
        while (end > 1 && e[end - 2] == 0) --end;
        if (end <= 1) break;
        std::size_t begin = end - 1;
        while (begin > 0 && e[begin - 1] != 0) --begin;
        const bool is_new = begin > block.last || end - 1 < block.first;
        block.first = begin;
        block.last = end - 1;
        if (is_new) block.from_bottom = abs(d[begin]) < abs(d[end - 1]);
        const Estimate<T> found = test(block, tolerance);
        if (found.split) continue;
        rotations += static_cast<double>(block.size());
        if (!(rotations <= rotations_allowed))
            throw PrecisionError("the natural frequencies of " + std::to_string(N) + " masses did not converge");
        QuestionEffort::pay_for_products(4 * static_cast<long>(block.size()) * V.rows());
        const T shift = shift_for(block, found, static_cast<int>(N));
        if (shift == 0)
            sweep_without_shift(block);
        else
            sweep_with_shift(block, shift);
        ++sweeps;
    }
    return in_order(d, V, sweeps);
}

} // namespace

template <class T>
SingularValues<T> bidiagonal_singular_values(std::vector<T> d, std::vector<T> e) {
    const auto N = static_cast<Eigen::Index>(d.size());
    return iterate(std::move(d), std::move(e), Matrix<T>(Matrix<T>::Identity(N, N)));
}

template <class T>
SingularValues<T> bidiagonal_singular_values(std::vector<T> d, std::vector<T> e, const std::vector<std::size_t>& rows) {
    Matrix<T> V = Matrix<T>::Zero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(d.size()));
    for (std::size_t n = 0; n < rows.size(); ++n) V(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(rows[n])) = T(1);
    return iterate(std::move(d), std::move(e), std::move(V));
}

template SingularValues<double> bidiagonal_singular_values(std::vector<double>, std::vector<double>);
template SingularValues<double> bidiagonal_singular_values(std::vector<double>, std::vector<double>,
                                                           const std::vector<std::size_t>&);

} // namespace denhartog
