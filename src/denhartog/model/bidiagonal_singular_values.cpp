#include "denhartog/model/bidiagonal_singular_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "denhartog/number/effort.hpp"
#include "denhartog/number/why.hpp"

namespace denhartog {
namespace {

using std::abs;
using std::sqrt;

/// The plane rotation that takes (f, g) to (r, 0): c f + s g = r, c g - s f = 0.
struct Rotation {
    double c, s, r;
};

Rotation rotation(double f, double g) {
    if (g == 0) return {1.0, 0.0, f};
    if (f == 0) return {0.0, 1.0, g};
    const bool f_leads = abs(f) > abs(g);
    const double t = f_leads ? g / f : f / g;
    const double length = sqrt(1 + t * t);
    const double larger = 1 / length;
    if (f_leads) return {larger, t * larger, f * length};
    return {t * larger, larger, g * length};
}

/// Smaller singular value of the triangle [f g; 0 h], without overflow.
double smaller_singular_value(double f, double g, double h) {
    const double small = std::min<double>(abs(f), abs(h));
    const double large = std::max<double>(abs(f), abs(h));
    if (small == 0) return 0.0;
    const double a = 1 + small / large;
    const double b = (large - small) / large;
    if (abs(g) < large) {
        const double q = abs(g) / large;
        return small * (2 / (sqrt(a * a + q * q) + sqrt(b * b + q * q)));
    }
    const double q = large / abs(g);
    return 2 * small * q / (sqrt(1 + (a * q) * (a * q)) + sqrt(1 + (b * q) * (b * q)));
}

/// A diagonal block first..last without zeros beside its diagonal. Seen from the bottom it is transposed and reversed: the view
/// is upper bidiagonal again, and its left singular vectors are the right ones of the block.
struct DiagonalBlock {
    std::vector<double>& d;
    std::vector<double>& e;
    Matrix<double>& V;
    std::size_t first, last;
    bool from_bottom;

    std::size_t size() const { return last - first + 1; }
    double& diagonal(std::size_t i) { return from_bottom ? d[last - i] : d[first + i]; }
    double& beside(std::size_t i) { return from_bottom ? e[last - 1 - i] : e[first + i]; }

    /// Turns the singular vectors i and i + 1 of the view by its right or left rotation, whichever acts on ours.
    void turn(std::size_t i, const Rotation& right, const Rotation& left) {
        const Rotation& by = from_bottom ? left : right;
        const Eigen::Index N = V.rows();
        double* x = V.data() + N * static_cast<Eigen::Index>(from_bottom ? last - i : first + i);
        double* y = V.data() + N * static_cast<Eigen::Index>(from_bottom ? last - i - 1 : first + i + 1);
        const double c = by.c;
        const double s = by.s;
        for (Eigen::Index k = 0; k < N; ++k) {
            const double x_k = x[k];
            x[k] = c * x_k + s * y[k];
            y[k] = c * y[k] - s * x_k;
        }
    }
};

/// What the tests for convergence find in a block.
struct Estimate {
    bool split = false;    ///< an entry was negligible and is zero now
    double smallest = 0.0; ///< lower estimate of the smallest singular value
    double largest = 0.0;  ///< largest entry
};

/// Sets entries beside the diagonal to zero that change no singular value by more than a relative `tolerance`.
Estimate test(DiagonalBlock& block, double tolerance) {
    const std::size_t n = block.size();
    Estimate found;
    if (abs(block.beside(n - 2)) <= tolerance * abs(block.diagonal(n - 1))) {
        block.beside(n - 2) = 0.0;
        found.split = true;
        return found;
    }
    double distance = abs(block.diagonal(0));
    found.smallest = distance;
    found.largest = distance;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const double e = abs(block.beside(i));
        if (e <= tolerance * distance) {
            block.beside(i) = 0.0;
            found.split = true;
            return found;
        }
        const double d = abs(block.diagonal(i + 1));
        distance = d * (distance / (distance + e));
        found.smallest = std::min(found.smallest, distance);
        found.largest = std::max({found.largest, d, e});
    }
    return found;
}

/// One sweep without shift: every entry keeps its relative accuracy, for there are no subtractions.
void sweep_without_shift(DiagonalBlock& block) {
    const std::size_t n = block.size();
    Rotation left{1.0, 0.0, 0.0};
    double c = 1.0;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const Rotation right = rotation(block.diagonal(i) * c, block.beside(i));
        if (i > 0) block.beside(i - 1) = left.s * right.r;
        left = rotation(left.c * right.r, block.diagonal(i + 1) * right.s);
        block.diagonal(i) = left.r;
        c = right.c;
        block.turn(i, right, left);
    }
    const double rest = block.diagonal(n - 1) * c;
    block.diagonal(n - 1) = rest * left.c;
    block.beside(n - 2) = rest * left.s;
}

/// One sweep of the QR iteration with a shift.
void sweep_with_shift(DiagonalBlock& block, double shift) {
    const std::size_t n = block.size();
    const double d_0 = block.diagonal(0);
    double f = (abs(d_0) - shift) * ((d_0 > 0 ? 1.0 : -1.0) + shift / d_0);
    double g = block.beside(0);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        double& d = block.diagonal(i);
        double& e = block.beside(i);
        double& d_next = block.diagonal(i + 1);
        const Rotation right = rotation(f, g);
        if (i > 0) block.beside(i - 1) = right.r;
        f = right.c * d + right.s * e;
        e = right.c * e - right.s * d;
        g = right.s * d_next;
        d_next = right.c * d_next;
        const Rotation left = rotation(f, g);
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
double shift_for(DiagonalBlock& block, const Estimate& found, int N) {
    if (found.largest > 4 * N * found.smallest) return 0.0;
    const std::size_t n = block.size();
    const double shift = smaller_singular_value(block.diagonal(n - 2), block.beside(n - 2), block.diagonal(n - 1));
    const double ratio = shift / block.diagonal(0);
    return ratio * ratio < std::numeric_limits<double>::epsilon() ? 0.0 : shift;
}

/// Values positive and ascending, vectors with them.
SingularValues in_order(const std::vector<double>& d, const Matrix<double>& V, long sweeps) {
    const std::size_t N = d.size();
    std::vector<std::size_t> order(N);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return abs(d[a]) < abs(d[b]); });
    SingularValues result{std::vector<double>(N), Matrix<double>(V.rows(), V.cols()), sweeps};
    for (std::size_t i = 0; i < N; ++i) {
        result.sigma[i] = abs(d[order[i]]);
        result.V.col(i) = V.col(order[i]);
    }
    return result;
}

/// The iteration; V starts as rows of the identity.
SingularValues iterate(std::vector<double> d, std::vector<double> e, Matrix<double> V, Effort* effort) {
    const std::size_t N = d.size();
    const double tolerance = 8 * std::numeric_limits<double>::epsilon();
    const double rotations_allowed =
        2.0 * std::numeric_limits<double>::digits * static_cast<double>(N) * static_cast<double>(N) + 1000;
    double rotations = 0;
    long sweeps = 0;
    DiagonalBlock block{d, e, V, N, 0, false};
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
        const Estimate found = test(block, tolerance);
        if (found.split) continue;
        rotations += static_cast<double>(block.size());
        if (!(rotations <= rotations_allowed)) throw PrecisionError({Why::chain_not_converged, N});
        pay_for_products(effort, 4 * static_cast<long>(block.size()) * V.rows());
        const double shift = shift_for(block, found, static_cast<int>(N));
        if (shift == 0)
            sweep_without_shift(block);
        else
            sweep_with_shift(block, shift);
        ++sweeps;
    }
    return in_order(d, V, sweeps);
}

} // namespace

SingularValues bidiagonal_singular_values(std::vector<double> d, std::vector<double> e, Effort* effort) {
    const auto N = static_cast<Eigen::Index>(d.size());
    return iterate(std::move(d), std::move(e), Matrix<double>(Matrix<double>::Identity(N, N)), effort);
}

SingularValues bidiagonal_singular_values(std::vector<double> d, std::vector<double> e, const std::vector<std::size_t>& rows,
                                          Effort* effort) {
    Matrix<double> V = Matrix<double>::Zero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(d.size()));
    for (std::size_t n = 0; n < rows.size(); ++n) V(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(rows[n])) = 1.0;
    return iterate(std::move(d), std::move(e), std::move(V), effort);
}

} // namespace denhartog
