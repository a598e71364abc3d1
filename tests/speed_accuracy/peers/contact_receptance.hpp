/// @file
/// @brief The linear system as the contact sees it at a harmonic of the force: all that the harmonic methods know of it.
#pragma once

#include <complex>

#include "denhartog/model/modal_basis.hpp"

namespace denhartog::tests {

/// @brief Displacement of the mass in contact by a unit harmonic force on a mass, as a sum over modes, any harmonic.
class ContactReceptance {
public:
    /// @brief Solves the eigenproblem, once a system. @param s the system
    explicit ContactReceptance(const System<double>& s) : basis_(modal_basis(s)), contact_(s.contact), load_(s.load) {}

    /// @brief By a force on the contact. @param n harmonic @param r frequency ratio @return amplitude in units of y_0
    [[nodiscard]] std::complex<double> of_friction(int n, double r) const { return sum(contact_, n * r); }

    /// @brief By the load, which is the first harmonic. @param r frequency ratio @return amplitude in units of y_0
    [[nodiscard]] std::complex<double> of_load(double r) const { return sum(load_, r); }

    /// @brief Acceleration of the contact by a sudden unit force on it. @param r frequency ratio @return x'' in units of y_0
    [[nodiscard]] double compliance(double r) const {
        return basis_.phi.row(static_cast<Eigen::Index>(contact_.index)).squaredNorm() / (r * r);
    }

private:
    [[nodiscard]] std::complex<double> sum(Mass forced, double r) const {
        std::complex<double> total = 0;
        for (std::size_t i = 0; i < basis_.r_n.size(); ++i) {
            const auto mode = static_cast<Eigen::Index>(i);
            const double shapes = basis_.phi(static_cast<Eigen::Index>(contact_.index), mode) *
                                  basis_.phi(static_cast<Eigen::Index>(forced.index), mode);
            const double r_n = basis_.r_n[i];
            total += shapes / std::complex<double>((r_n - r) * (r_n + r), 2 * basis_.zeta[i] * r_n * r);
        }
        return total;
    }

    ModalBasis<double> basis_;
    Mass contact_, load_;
};

} // namespace denhartog::tests
