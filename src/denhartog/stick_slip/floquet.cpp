#include "denhartog/stick_slip/floquet.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/elementary.hpp"

namespace denhartog {
namespace {

double row_norm(const Matrix<double>& A) { return A.cwiseAbs().rowwise().sum().maxCoeff(); }

void sort_by_size(std::vector<std::complex<double>>& values) {
    std::sort(values.begin(), values.end(), [](const std::complex<double>& a, const std::complex<double>& b) {
        const double size_a = size_of(a), size_b = size_of(b);
        return size_a != size_b ? size_a > size_b : a.imag() > b.imag();
    });
}

// The eigenvalues of a matrix of one or two rows, block by block, below whose diagonal all else is zero.
std::vector<std::complex<double>> eigenvalues_of(const Matrix<double>& T) {
    std::vector<std::complex<double>> values;
    for (Eigen::Index i = 0; i < T.rows();) {
        if (i + 1 == T.rows() || T(i + 1, i) == 0) {
            values.emplace_back(T(i, i));
            ++i;
            continue;
        }
        const double p = 0.5 * (T(i, i) - T(i + 1, i + 1)), real = T(i + 1, i + 1) + p;
        const double largest = std::max({std::abs(p), std::abs(T(i + 1, i)), std::abs(T(i, i + 1))}); // scales the square
        const double p_1 = p / largest, below = T(i + 1, i) / largest, above = T(i, i + 1) / largest;
        const double imaginary = largest * std::sqrt(std::abs(p_1 * p_1 + below * above));
        values.emplace_back(real, imaginary);
        values.emplace_back(real, -imaginary);
        i += 2;
    }
    return values;
}

} // namespace

double size_of(const std::complex<double>& multiplier) { return elementary::hypot(multiplier.real(), multiplier.imag()); }

std::vector<std::complex<double>> multipliers_of(const Matrix<double>& jacobian) {
    if (jacobian.rows() == 0 || !jacobian.allFinite()) return {};
    const Eigen::RealSchur<Matrix<double>> schur(jacobian, false);
    if (schur.info() != Eigen::Success) return {};
    std::vector<std::complex<double>> values = eigenvalues_of(schur.matrixT());
    sort_by_size(values);
    return values;
}

std::vector<std::complex<double>> squared(std::vector<std::complex<double>> multipliers) {
    for (std::complex<double>& each : multipliers) {
        const double re = each.real(), im = each.imag();
        each = {re * re - im * im, 2 * re * im};
    }
    sort_by_size(multipliers);
    return multipliers;
}

bool contracts(const Matrix<double>& jacobian, double error) {
    constexpr int most_squarings = 50; // beyond, rounding has grown past every decay
    Matrix<double> power = jacobian;
    for (int n = 0; n < most_squarings; ++n) {
        const double norm = row_norm(power);
        if (!(norm < 1e100) || !(error < 1)) return false;
        if (norm + error < 1) return true;
        const double rounding = static_cast<double>(power.rows()) * std::numeric_limits<double>::epsilon();
        error = 2 * norm * error + error * error + rounding * norm * norm;
        power = product(power, power);
    }
    return false;
}

} // namespace denhartog
