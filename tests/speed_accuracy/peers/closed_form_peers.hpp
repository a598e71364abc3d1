/// @file
/// @brief The closed form on the chart in any number type.
#pragma once

#include <memory>

#include "denhartog/evaluation/mode.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "tests/speed_accuracy/peers/peer.hpp"

namespace denhartog::tests {

/// @brief A modal basis in another number type, rounded. @param basis the basis @return its numbers in T
template <class T, class S>
[[nodiscard]] ModalBasis<T> rounded(const ModalBasis<S>& basis) {
    ModalBasis<T> copy;
    for (const S& r_n : basis.r_n) copy.r_n.push_back(static_cast<T>(r_n));
    for (const S& zeta : basis.zeta) copy.zeta.push_back(static_cast<T>(zeta));
    copy.phi = basis.phi.template cast<T>();
    return copy;
}

/// @brief (38) from the modes, whatever the regime. `mode` gives (23), (28), (29) of a mode from R and zeta. Not a number where
/// the root has no value. @eq{22,33,34,35,38}
template <class T, class Mode>
[[nodiscard]] PeerAnswer closed_form_at(const ModalBasis<T>& basis, Mass contact, Mass load, const ChartPoint& point,
                                        const Mode& mode) {
    const std::size_t N = basis.r_n.size();
    const T r(point.r), beta(point.beta);
    Complex<T> V{T(0), T(0)};
    T U(0), G(0);
    for (std::size_t i = 0; i < N; ++i) {
        const T R = r / basis.r_n[i];
        const evaluation::ModeFunctions<T> f = mode(R, basis.zeta[i]);
        const T psi_j = basis.phi(contact.index, i) / r, psi_l = basis.phi(load.index, i) / r;
        V = V + T(psi_j * psi_l * R * R) * f.v;
        U = U + psi_j * psi_j * R * R * f.u;
        G = G + psi_j * psi_j * R * R * f.g;
    }
    PeerAnswer answer;
    answer.evaluations = static_cast<long>(N);
    set_amplitude(answer, paper::displacement_transmissibility_of_contact(V, U, G, beta));
    return answer;
}

/// @brief (23), (28), (29) as printed. @param R modal frequency ratio @param zeta modal damping ratio @return the three
template <class T>
[[nodiscard]] evaluation::ModeFunctions<T> printed_mode(const T& R, const T& zeta) {
    return {paper::complex_response(R, zeta), paper::first_damping_function(R, zeta), paper::second_damping_function(R, zeta)};
}

/// @brief A peer of the closed form as printed. @param setting name of the number type @param basis gives the modal basis
template <class T, class Basis>
[[nodiscard]] Peer printed_form_peer(const std::string& setting, const Basis& basis) {
    return {"closed form as printed", setting, 0, [basis](const System<double>& system) {
                const auto modes = std::make_shared<const ModalBasis<T>>(basis(system));
                return [modes, j = system.contact, l = system.load](const ChartPoint& point) {
                    return closed_form_at(*modes, j, l, point, printed_mode<T>);
                };
            }};
}

/// @brief A peer of the closed form as shipped, with its domain (69).
template <class T, class Basis>
[[nodiscard]] Peer shipped_form_peer(const std::string& setting, const Basis& basis) {
    return {"closed form as shipped", setting, 0, [basis](const System<double>& system) {
                const auto modes = std::make_shared<const ModalBasis<T>>(basis(system));
                return [modes, j = system.contact, l = system.load](const ChartPoint& point) {
                    const T beta(point.beta);
                    const ModeSums<T> sums = mode_sums(*modes, j, l, T(point.r));
                    PeerAnswer answer;
                    answer.evaluations = static_cast<long>(modes->r_n.size());
                    if (regime_of(boundary(sums, T(1)), beta) != Regime::continuous) {
                        answer.ending = Ending::outside_domain;
                        return answer;
                    }
                    const std::size_t k = j.index;
                    set_amplitude(answer, paper::displacement_transmissibility_of_contact(sums.V[k], sums.U[k], sums.G[k], beta));
                    return answer;
                };
            }};
}

/// @brief Peers in 50 digits, as printed and as shipped. @return two peers
[[nodiscard]] std::vector<Peer> closed_form_peers_in_50_digits();

} // namespace denhartog::tests
