#include "denhartog/stick_slip/floquet.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace denhartog {
namespace {

double row_norm(const Matrix<double>& A) { return A.cwiseAbs().rowwise().sum().maxCoeff(); }

void sort_by_size(std::vector<std::complex<double>>& values) {
    std::sort(values.begin(), values.end(), [](const std::complex<double>& a, const std::complex<double>& b) {
        const double size_a = std::abs(a), size_b = std::abs(b);
        return size_a != size_b ? size_a > size_b : a.imag() > b.imag();
    });
}

} // namespace

std::vector<std::complex<double>> multipliers_of(const Matrix<double>& jacobian) {
    if (jacobian.rows() == 0 || !jacobian.allFinite()) return {};
    const Eigen::EigenSolver<Matrix<double>> solver(jacobian, false);
    if (solver.info() != Eigen::Success) return {};
    std::vector<std::complex<double>> values(solver.eigenvalues().begin(), solver.eigenvalues().end());
    sort_by_size(values);
    return values;
}

std::vector<std::complex<double>> squared(std::vector<std::complex<double>> multipliers) {
    for (std::complex<double>& each : multipliers) each *= each;
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
        power = power * power;
    }
    return false;
}

} // namespace denhartog
