// Natural frequencies and shapes of the undamped system, (13)-(17). `chain_modes` goes by the singular values of a bidiagonal
// matrix, `general_modes` by a symmetric eigenproblem, or by `graded_modes` if the masses are very different: the first and the
// last keep the digits of each frequency, which a symmetric eigenproblem loses as soon as springs or masses differ by much.
#include "denhartog/model/natural_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/scene/cholesky.hpp"

namespace denhartog {
namespace {

using std::abs;
using std::sqrt;

/// An upper bidiagonal matrix with the singular values of F; whether its columns are those of F in reverse.
struct Bidiagonal {
    std::vector<double> d, e;
    bool reversed;
};

/// The last mass free: F is square and lower bidiagonal. Rows and columns are reversed to make it upper bidiagonal.
Bidiagonal free_chain(const std::vector<double>& gamma, const std::vector<double>& kappa) {
    const std::size_t N = gamma.size();
    std::vector<double> d(N);
    std::vector<double> e(N - 1);
    for (std::size_t i = 0; i < N; ++i) {
        d[N - 1 - i] = sqrt(kappa[i] / gamma[i]);
        if (i > 0) e[N - 1 - i] = -sqrt(kappa[i] / gamma[i - 1]);
    }
    return {std::move(d), std::move(e), true};
}

/// A spring to the ground at both ends: F has a row more than columns. Rotations of neighbouring rows, from the first on, make it
/// square and upper bidiagonal; every entry of the result is a root of a sum of squares or a product.
Bidiagonal fixed_chain(const std::vector<double>& gamma, const std::vector<double>& kappa) {
    const std::size_t N = gamma.size();
    std::vector<double> d(N);
    std::vector<double> e(N - 1);
    double left = sqrt(kappa[0] / gamma[0]);
    for (std::size_t i = 0; i < N; ++i) {
        const double below = -sqrt(kappa[i + 1] / gamma[i]);
        d[i] = sqrt(left * left + below * below);
        if (i + 1 == N) break;
        const double next = sqrt(kappa[i + 1] / gamma[i + 1]);
        e[i] = below / d[i] * next;
        left = left / d[i] * next;
    }
    return {std::move(d), std::move(e), false};
}

Bidiagonal bidiagonal_of(const std::vector<double>& gamma, const std::vector<double>& kappa) {
    return kappa.size() == gamma.size() ? free_chain(gamma, kappa) : fixed_chain(gamma, kappa);
}

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

/// Results of the tests for convergence in a block.
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
NaturalModes in_order(const std::vector<double>& d, const Matrix<double>& V) {
    const std::size_t N = d.size();
    std::vector<std::size_t> order(N);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return abs(d[a]) < abs(d[b]); });
    NaturalModes result{std::vector<double>(N), Matrix<double>(V.rows(), V.cols())};
    for (std::size_t i = 0; i < N; ++i) {
        result.r_n[i] = abs(d[order[i]]);
        result.phi.col(i) = V.col(order[i]);
    }
    return result;
}

constexpr int most_sweeps = 40;
constexpr double least_contrast_of_masses = 1024; // the largest mass over the least, from which modes are graded

double along(const Matrix<double>& A, Eigen::Index p, Eigen::Index q) {
    double sum = 0;
    for (Eigen::Index i = 0; i < A.rows(); ++i) sum += A(i, p) * A(i, q);
    return sum;
}

void rotate(Matrix<double>& A, Eigen::Index p, Eigen::Index q, double cosine, double sine) {
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        const double x = A(i, p), y = A(i, q);
        A(i, p) = cosine * x - sine * y;
        A(i, q) = sine * x + cosine * y;
    }
}

// Rotates columns until each two are orthogonal to rounding; V takes the rotations.
void orthogonalise(Matrix<double>& A, Matrix<double>& V, Effort* effort) {
    const Eigen::Index N = A.cols();
    const double rounding = static_cast<double>(N) * std::numeric_limits<double>::epsilon();
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        bool rotated = false;
        for (Eigen::Index p = 0; p < N; ++p) {
            pay(effort, static_cast<long>(N * N) / 16); // sums and rotations of up to N pairs of columns
            for (Eigen::Index q = p + 1; q < N; ++q) {
                const double a = along(A, p, p), b = along(A, q, q), c = along(A, p, q);
                if (abs(c) <= rounding * sqrt(a) * sqrt(b)) continue;
                rotated = true;
                const double zeta = (b - a) / (2 * c);
                const double tangent = (zeta >= 0 ? 1 : -1) / (abs(zeta) + sqrt(1 + zeta * zeta));
                const double cosine = 1 / sqrt(1 + tangent * tangent);
                rotate(A, p, q, cosine, cosine * tangent);
                rotate(V, p, q, cosine, cosine * tangent);
            }
        }
        if (!rotated) return;
    }
}

// Factor of a stiffness matrix whose modes are graded, and the condition that `condition_of_graded` gives.
struct GradedStiffness {
    Cholesky<double> factor;
    double condition;
};

std::optional<GradedStiffness> graded_stiffness(const Matrix<double>& L, const Matrix<double>& K) {
    if (L.rows() < 2 || !is_diagonal(L)) return std::nullopt;
    const Column masses = L.diagonal().cwiseAbs2();
    const double contrast = masses.maxCoeff() / masses.minCoeff();
    if (!(contrast >= least_contrast_of_masses)) return std::nullopt;
    Cholesky<double> factor = cholesky(K);
    if (factor.failed_order > 0) return std::nullopt;
    const Matrix<double> inverse = LinearSystem(K).inverse();
    double trace = 0;
    for (Eigen::Index i = 0; i < K.rows(); ++i) trace += inverse(i, i) * K(i, i);
    if (!(trace <= contrast)) return std::nullopt;
    return GradedStiffness{std::move(factor), std::max(trace, static_cast<double>(K.rows()))};
}

} // namespace

NaturalModes bidiagonal_singular_values(std::vector<double> d, std::vector<double> e, const std::vector<std::size_t>& rows,
                                        Effort* effort) {
    const std::size_t N = d.size();
    Matrix<double> V = Matrix<double>::Zero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(N));
    for (std::size_t n = 0; n < rows.size(); ++n) V(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(rows[n])) = 1.0;
    const double tolerance = 8 * std::numeric_limits<double>::epsilon();
    const double rotations_allowed =
        2.0 * std::numeric_limits<double>::digits * static_cast<double>(N) * static_cast<double>(N) + 1000;
    double rotations = 0;
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
        if (!(rotations <= rotations_allowed)) throw PrecisionError({Why::chain_not_converged, N}, Outcome::not_converged);
        pay_for_products(effort, 4 * static_cast<long>(block.size()) * V.rows());
        const double shift = shift_for(block, found, static_cast<int>(N));
        if (shift == 0)
            sweep_without_shift(block);
        else
            sweep_with_shift(block, shift);
    }
    return in_order(d, V);
}

NaturalModes chain_modes(const std::vector<double>& gamma, const std::vector<double>& kappa, const std::vector<Mass>& masses,
                         Effort* effort) {
    Bidiagonal F = bidiagonal_of(gamma, kappa);
    std::vector<std::size_t> rows;
    for (const Mass& mass : masses) rows.push_back(F.reversed ? gamma.size() - 1 - mass.index : mass.index);
    NaturalModes modes = bidiagonal_singular_values(std::move(F.d), std::move(F.e), rows, effort);
    for (std::size_t n = 0; n < masses.size(); ++n) modes.phi.row(static_cast<Eigen::Index>(n)) /= sqrt(gamma[masses[n].index]);
    return modes;
}

NaturalModes chain_modes(const std::vector<double>& gamma, const std::vector<double>& kappa, Effort* effort) {
    std::vector<Mass> masses;
    for (std::size_t k = 0; k < gamma.size(); ++k) masses.push_back(Mass{k});
    return chain_modes(gamma, kappa, masses, effort);
}

std::optional<double> condition_of_graded(const Matrix<double>& L, const Matrix<double>& K) {
    const std::optional<GradedStiffness> graded = graded_stiffness(L, K);
    return graded ? std::optional(graded->condition) : std::nullopt;
}

std::optional<NaturalModes> graded_modes(const Matrix<double>& L, const Matrix<double>& K, Effort* effort) {
    const std::optional<GradedStiffness> graded = graded_stiffness(L, K);
    if (!graded) return std::nullopt;
    const Eigen::Index N = K.rows();
    Matrix<double> A = graded->factor.L.transpose(), V = Matrix<double>::Identity(N, N);
    for (Eigen::Index k = 0; k < N; ++k) A.col(k) /= L(k, k);
    orthogonalise(A, V, effort);
    std::vector<double> sizes;
    for (Eigen::Index i = 0; i < N; ++i) sizes.push_back(sqrt(along(A, i, i)));
    NaturalModes modes = in_order(sizes, V);
    for (Eigen::Index k = 0; k < N; ++k) modes.phi.row(k) /= L(k, k);
    return modes;
}

NaturalModes general_modes(const Matrix<double>& L, const Matrix<double>& K, Effort* effort) {
    const Eigen::Index N = K.rows();
    if (std::optional<NaturalModes> modes = graded_modes(L, K, effort)) return *std::move(modes);
    const SymmetricEigenproblem solved = symmetric_eigenproblem(divide_out(L, K), effort);
    if (!(solved.values.front() > std::numeric_limits<double>::epsilon() * static_cast<int>(N) * solved.values.back()))
        throw PrecisionError(Why::lowest_frequency_lost);
    NaturalModes modes{std::vector<double>(static_cast<std::size_t>(N)), Matrix<double>(N, N)};
    for (std::size_t i = 0; i < modes.r_n.size(); ++i) modes.r_n[i] = sqrt(solved.values[i]);
    modes.phi = divided_by_transpose(L, solved.vectors);
    return modes;
}

void require_finite(const std::vector<double>& r_n, const Matrix<double>& phi, Why why) {
    for (std::size_t i = 0; i < r_n.size(); ++i)
        if (!(std::isfinite(r_n[i]) && r_n[i] > 0 && phi.col(static_cast<Eigen::Index>(i)).allFinite()))
            throw PrecisionError({why, i + 1}, Outcome::out_of_range);
}

void fix_signs(Matrix<double>& phi) {
    for (Eigen::Index i = 0; i < phi.cols(); ++i) {
        const double size = 3.0 / 8 * phi.col(i).cwiseAbs().maxCoeff();
        Eigen::Index k = 0;
        while (k + 1 < phi.rows() && abs(phi(k, i)) <= size) ++k;
        if (phi(k, i) < 0) phi.col(i) = -phi.col(i);
    }
}

} // namespace denhartog
