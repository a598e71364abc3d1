#include "tests/conformance/generator/determinant.hpp"

#include <limits>

#include "tests/support/multiprecision.hpp"

namespace denhartog::conformance::generator {
namespace {

using Index = Eigen::Index;

// Number of roots below lambda: negative pivots of K - lambda M. The zeros of a chain are passed over.
template <class T>
Index roots_below(const Matrix<T>& M, const Matrix<T>& K, const T& lambda) {
    const Index N = M.rows();
    Matrix<T> S = K - lambda * M;
    Index count = 0;
    for (Index i = 0; i < N; ++i) {
        T& pivot = S(i, i);
        if (pivot == T(0)) pivot = std::numeric_limits<T>::epsilon() * std::numeric_limits<T>::epsilon() * K(i, i);
        if (pivot < T(0)) ++count;
        for (Index k = i + 1; k < N; ++k)
            for (Index l = k; l < N && S(k, i) != T(0); ++l)
                if (S(l, i) != T(0)) S(l, k) -= S(l, i) * S(k, i) / pivot;
    }
    return count;
}

template <class T>
T root(const Matrix<T>& M, const Matrix<T>& K, Index i, T below, T above) {
    for (int n = 0; n < 4 * std::numeric_limits<T>::digits; ++n) {
        const T middle = (below + above) / 2;
        if (middle <= below || middle >= above) break;
        (roots_below(M, K, middle) > i ? above : below) = middle;
    }
    return (below + above) / 2;
}

} // namespace

template <class T>
std::vector<T> determinant_roots(const Matrix<T>& M, const Matrix<T>& K, const T& bound) {
    std::vector<T> lambda;
    for (Index i = 0; i < M.rows(); ++i) lambda.push_back(root(M, K, i, T(0), bound));
    return lambda;
}

template <class T>
DeterminantModes<T> determinant_modes(const Matrix<T>& M, const Matrix<T>& K, Index j) {
    const Index N = M.rows();
    T bound(0);
    for (Index i = 0; i < N; ++i) bound = std::max(bound, T(4 * K(i, i) / M(i, i)));
    DeterminantModes<T> modes{determinant_roots(M, K, bound), Matrix<T>(N, N)};
    for (Index i = 0; i < N; ++i) {
        const T& lambda = modes.lambda[static_cast<std::size_t>(i)];
        // Leading minors with their derivative, trailing minors.
        std::vector<T> leading(static_cast<std::size_t>(N) + 1, T(1)), slope(leading.size(), T(0)),
            trailing(leading.size() + 1, T(1));
        for (Index n = 0; n < N; ++n) {
            const auto m = static_cast<std::size_t>(n);
            const T a = K(n, n) - lambda * M(n, n), b = n > 0 ? T(K(n, n - 1) * K(n, n - 1)) : T(0);
            leading[m + 1] = a * leading[m] - (n > 0 ? T(b * leading[m - 1]) : T(0));
            slope[m + 1] = a * slope[m] - M(n, n) * leading[m] - (n > 0 ? T(b * slope[m - 1]) : T(0));
        }
        for (Index n = N - 1; n >= 0; --n) {
            const auto m = static_cast<std::size_t>(n);
            const T b = n + 1 < N ? T(K(n + 1, n) * K(n + 1, n)) : T(0);
            trailing[m] = (K(n, n) - lambda * M(n, n)) * trailing[m + 1] - (n + 1 < N ? T(b * trailing[m + 2]) : T(0));
        }
        for (Index k = 0; k < N; ++k) {
            const Index first = std::min(j, k), last = std::max(j, k);
            T product = leading[static_cast<std::size_t>(first)] * trailing[static_cast<std::size_t>(last) + 1];
            for (Index n = first; n < last; ++n) product *= -K(n + 1, n);
            modes.products(k, i) = -product / slope[static_cast<std::size_t>(N)];
        }
    }
    return modes;
}

template std::vector<Real50> determinant_roots(const Matrix<Real50>&, const Matrix<Real50>&, const Real50&);
template std::vector<Real100> determinant_roots(const Matrix<Real100>&, const Matrix<Real100>&, const Real100&);
template DeterminantModes<Real50> determinant_modes(const Matrix<Real50>&, const Matrix<Real50>&, Eigen::Index);
template DeterminantModes<Real100> determinant_modes(const Matrix<Real100>&, const Matrix<Real100>&, Eigen::Index);

} // namespace denhartog::conformance::generator
