// Linear algebra of the plain closed form: elimination with pivots, the natural frequencies and mode shapes of (14) and (15) by
// one-sided rotations, `shapes_of`, and the exponential of a matrix by its series, `increment`.
#include "conformance/plain/linear.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "elementary/elementary.hpp"

namespace denhartog::conformance {

double modulus(const Phasor& a) { return elementary::hypot(a.re, a.im); }
double argument(const Phasor& a) { return elementary::atan2(a.im, a.re); }
double times_cosine(const Phasor& a, double tau) { return a.re * elementary::cos(tau) - a.im * elementary::sin(tau); }

double dot(const PlainRow& a, const PlainRow& b) {
    double sum = 0;
    for (std::size_t n = 0; n < a.size(); ++n) sum += a[n] * b[n];
    return sum;
}

Phasor dot(const PlainRow& a, const std::vector<Phasor>& b) {
    Phasor sum;
    for (std::size_t n = 0; n < a.size(); ++n) {
        sum.re += a[n] * b[n].re;
        sum.im += a[n] * b[n].im;
    }
    return sum;
}

PlainRow times(const PlainMatrix& A, const PlainRow& x) {
    PlainRow y(A.size());
    std::size_t i = 0;
    for (; i + 4 <= A.size(); i += 4) { // four sums at a time, none of which waits for another
        const double *a = A[i].data(), *b = A[i + 1].data(), *c = A[i + 2].data(), *d = A[i + 3].data();
        double of_a = 0, of_b = 0, of_c = 0, of_d = 0;
        for (std::size_t k = 0; k < x.size(); ++k) {
            of_a += a[k] * x[k];
            of_b += b[k] * x[k];
            of_c += c[k] * x[k];
            of_d += d[k] * x[k];
        }
        y[i] = of_a;
        y[i + 1] = of_b;
        y[i + 2] = of_c;
        y[i + 3] = of_d;
    }
    for (; i < A.size(); ++i) y[i] = dot(A[i], x);
    return y;
}

PlainMatrix transposed(const PlainMatrix& A) {
    PlainMatrix B(A.front().size(), PlainRow(A.size()));
    for (std::size_t i = 0; i < A.size(); ++i)
        for (std::size_t k = 0; k < B.size(); ++k) B[k][i] = A[i][k];
    return B;
}

PlainMatrix times(const PlainMatrix& A, const PlainMatrix& B) {
    PlainMatrix product;
    const PlainMatrix columns = transposed(B);
    for (const PlainRow& row : A) product.push_back(times(columns, row));
    return product;
}

PlainMatrix square(std::size_t n) { return PlainMatrix(n, PlainRow(n)); }

PlainRow solved(PlainMatrix A, PlainRow b) {
    const std::size_t n = b.size();
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t pivot = i;
        for (std::size_t k = i + 1; k < n; ++k)
            if (std::abs(A[k][i]) > std::abs(A[pivot][i])) pivot = k;
        std::swap(A[i], A[pivot]);
        std::swap(b[i], b[pivot]);
        for (std::size_t k = i + 1; k < n; ++k) {
            const double factor = A[k][i] / A[i][i];
            for (std::size_t m = i; m < n; ++m) A[k][m] -= factor * A[i][m];
            b[k] -= factor * b[i];
        }
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) b[i] -= A[i][k] * b[k];
        b[i] /= A[i][i];
    }
    return b;
}

std::vector<Phasor> solved(const PlainMatrix& A, const PlainMatrix& B, const PlainRow& b, const PlainRow& b_i) {
    const std::size_t n = b.size();
    PlainMatrix both = square(2 * n); // of real and imaginary parts
    PlainRow right = b;
    right.insert(right.end(), b_i.begin(), b_i.end());
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < n; ++k) {
            both[i][k] = both[n + i][n + k] = A[i][k];
            both[i][n + k] = -B[i][k];
            both[n + i][k] = B[i][k];
        }
    const PlainRow parts = solved(std::move(both), std::move(right));
    std::vector<Phasor> X;
    for (std::size_t i = 0; i < n; ++i) X.push_back({parts[i], parts[n + i]});
    return X;
}

PlainMatrix triangle_of(const PlainMatrix& A) {
    PlainMatrix L = square(A.size());
    for (std::size_t i = 0; i < A.size(); ++i)
        for (std::size_t k = 0; k <= i; ++k) {
            const double rest = A[i][k] - dot(L[i], L[k]);
            L[i][k] = i == k ? std::sqrt(rest) : rest / L[k][k];
        }
    return L;
}

PlainShapes shapes_of(const PlainMatrix& B, const PlainMatrix& M) {
    const std::size_t n = M.size();
    const PlainMatrix L = triangle_of(M), upper = transposed(L);
    PlainMatrix columns, turned = square(n); // of B L^-T; the same rotations of the unit matrix
    for (std::size_t i = 0; i < n; ++i) turned[i][i] = 1;
    for (const PlainRow& row : B) columns.push_back(solved(L, row));
    columns = transposed(columns);
    constexpr int most_sweeps = 60;
    bool turns = true;
    for (int sweep = 0; turns && sweep < most_sweeps; ++sweep) {
        turns = false;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = i + 1; k < n; ++k) {
                const double a = dot(columns[i], columns[i]), b = dot(columns[k], columns[k]), c = dot(columns[i], columns[k]);
                if (std::abs(c) <= 1e-16 * std::sqrt(a) * std::sqrt(b)) continue;
                turns = true;
                const double z = (b - a) / (2 * c), t = (z < 0 ? -1 : 1) / (std::abs(z) + elementary::hypot(1, z));
                const double cosine = 1 / std::sqrt(1 + t * t), sine = t * cosine;
                for (PlainMatrix* of : {&columns, &turned})
                    for (std::size_t m = 0; m < (*of)[i].size(); ++m) {
                        const double x = (*of)[i][m], y = (*of)[k][m];
                        (*of)[i][m] = cosine * x - sine * y;
                        (*of)[k][m] = sine * x + cosine * y;
                    }
            }
    }
    std::vector<std::pair<double, PlainRow>> modes;
    for (std::size_t i = 0; i < n; ++i) modes.emplace_back(std::sqrt(dot(columns[i], columns[i])), solved(upper, turned[i]));
    std::ranges::sort(modes);
    PlainShapes shapes;
    for (auto& [r_n, shape] : modes) {
        shapes.r_n.push_back(r_n);
        shapes.phi.push_back(std::move(shape));
    }
    shapes.phi = transposed(shapes.phi);
    return shapes;
}

PlainRow increment(const PlainMatrix& A, const PlainRow& z, double dt) {
    constexpr int most_terms = 80;
    PlainRow sum(z.size()), term = z;
    double largest = 1, all = 0;
    for (int k = 1; k < most_terms && largest > 1e-18 * all; ++k) {
        term = times(A, term);
        largest = all = 0;
        for (std::size_t n = 0; n < z.size(); ++n) {
            sum[n] += term[n] *= dt / k;
            largest = std::max(largest, std::abs(term[n]));
            all = std::max(all, std::abs(sum[n]));
        }
    }
    return sum;
}

PlainRow moved(const PlainMatrix& A, const PlainRow& z, double dt) {
    PlainRow sum = increment(A, z, dt);
    for (std::size_t n = 0; n < z.size(); ++n) sum[n] += z[n];
    return sum;
}

PlainMatrix propagator(const PlainMatrix& A, double dt) {
    PlainMatrix columns;
    for (std::size_t k = 0; k < A.size(); ++k) {
        PlainRow unit(A.size());
        unit[k] = 1;
        columns.push_back(moved(A, unit, dt));
    }
    return transposed(columns);
}

double zero_between(const std::function<double(double)>& f, double from, double to) {
    const double before = f(from), after = f(to);
    if (before == 0) return from;
    if (!(before * after < 0)) return to;
    std::uintmax_t most = 200;
    const auto [a, b] =
        boost::math::tools::toms748_solve(f, from, to, before, after, boost::math::tools::eps_tolerance<double>(52), most);
    return (a + b) / 2;
}

} // namespace denhartog::conformance
