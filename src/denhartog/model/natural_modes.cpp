#include "denhartog/model/natural_modes.hpp"

#include <cmath>
#include <limits>

#include "denhartog/model/bidiagonal_singular_values.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/why.hpp"

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

} // namespace

NaturalModes chain_modes(const std::vector<double>& gamma, const std::vector<double>& kappa, Effort* effort) {
    Bidiagonal F = bidiagonal_of(gamma, kappa);
    SingularValues solved = bidiagonal_singular_values(std::move(F.d), std::move(F.e), effort);
    if (F.reversed) solved.V = solved.V.colwise().reverse().eval();
    for (std::size_t k = 0; k < gamma.size(); ++k) solved.V.row(static_cast<Eigen::Index>(k)) /= sqrt(gamma[k]);
    return {std::move(solved.sigma), std::move(solved.V)};
}

NaturalModes chain_modes(const std::vector<double>& gamma, const std::vector<double>& kappa, const std::vector<Mass>& masses,
                         Effort* effort) {
    Bidiagonal F = bidiagonal_of(gamma, kappa);
    std::vector<std::size_t> rows;
    for (const Mass& mass : masses) rows.push_back(F.reversed ? gamma.size() - 1 - mass.index : mass.index);
    SingularValues solved = bidiagonal_singular_values(std::move(F.d), std::move(F.e), rows, effort);
    for (std::size_t n = 0; n < masses.size(); ++n) solved.V.row(static_cast<Eigen::Index>(n)) /= sqrt(gamma[masses[n].index]);
    return {std::move(solved.sigma), std::move(solved.V)};
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

void fix_signs(Matrix<double>& phi) {
    for (Eigen::Index i = 0; i < phi.cols(); ++i) {
        const double size = 3.0 / 8 * phi.col(i).cwiseAbs().maxCoeff();
        Eigen::Index k = 0;
        while (k + 1 < phi.rows() && abs(phi(k, i)) <= size) ++k;
        if (phi(k, i) < 0) phi.col(i) = -phi.col(i);
    }
}

} // namespace denhartog
