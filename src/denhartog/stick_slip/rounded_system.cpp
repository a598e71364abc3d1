#include "denhartog/stick_slip/rounded_system.hpp"

#include "denhartog/number/bounded.hpp"
#include "denhartog/scene/converted.hpp"

namespace denhartog {
namespace {

ModalBasis<double> rounded(const ModalBasis<Real50>& b) {
    return {in_type<double>(b.r_n), in_type<double>(b.phi), in_type<double>(b.zeta), in_type<double>(b.D),
            static_cast<double>(b.distance_from_classical)};
}

StuckConfiguration<double> rounded(const StuckConfiguration<Real50>& s) {
    return {s.masses,
            in_type<double>(s.M),
            in_type<double>(s.C),
            in_type<double>(s.K),
            in_type<double>(s.m_j),
            in_type<double>(s.c_j),
            in_type<double>(s.k_j),
            static_cast<double>(s.k_jj),
            static_cast<double>(s.k_contact),
            in_type<double>(s.r_n),
            in_type<double>(s.phi),
            in_type<double>(s.further),
            in_type<double>(s.carried),
            in_type<double>(s.load),
            in_type<double>(s.damping),
            static_cast<double>(s.coupling),
            s.modes_diagonalise_damping};
}

// What rounding makes of the damping of the modes: of each entry, it is known to 50 digits.
Matrix<double> rounding_of_damping(const ContactSystem<Real50>& s) {
    Matrix<double> D = in_type<double>(s.damping_error);
    for (Eigen::Index i = 0; i < D.rows(); ++i) {
        const auto n = static_cast<std::size_t>(i);
        D(i, i) += 4 * unit_of<double>() * static_cast<double>(Real50(s.basis.zeta[n] * s.basis.r_n[n]));
    }
    if (s.basis.coupled()) D += unit_of<double>() * in_type<double>(s.basis.D).cwiseAbs();
    return D;
}

} // namespace

ContactSystem<double> rounded(const ContactSystem<Real50>& s, const std::string& because) {
    return {s.contact,
            s.load,
            rounded(s.basis),
            in_type<double>(s.momentum),
            rounded(s.stuck),
            in_type<double>(s.modal_load),
            in_type<double>(s.stuck_load),
            std::vector<double>(s.detuned.size(), unit_of<double>()),
            rounding_of_damping(s),
            in_type<double>(s.coordinates),
            in_type<double>(s.further),
            s.damping_fixes_modes,
            because};
}

} // namespace denhartog
