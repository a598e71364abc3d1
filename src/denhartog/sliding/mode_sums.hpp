/// @file
/// @brief The functions of the modes at one frequency ratio, and their sums for every mass: (22), (23), (28), (29), (33)-(35),
/// (64), (65).
///
/// None of it depends on the friction ratio: one evaluation serves every beta at that r.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "denhartog/evaluation/mode.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/work_counted.hpp"

namespace denhartog {

class CoupledFriction;

/// @brief Modes and sums over modes at one frequency ratio.
///
/// If damping couples the modes there are none: their lists are empty, and friction's share of the motion is in `coupled`.
template <class T>
struct ModeSums {
    T r;                       ///< frequency ratio, Eq. (10)
    Mass contact;              ///< the mass in contact, j
    Mass load;                 ///< the loaded mass, l
    std::vector<T> R;          ///< modal frequency ratios, Eq. (22), N values
    std::vector<T> zeta;       ///< modal damping ratios, Eq. (18), N values
    std::vector<T> w;          ///< \f$ \sqrt{1-\zeta^2} \f$, or 0 from 1 on, N values
    std::vector<T> psi;        ///< mode shapes normalised by (17), mass by mode, row-major, N x N
    std::vector<Complex<T>> v; ///< complex response functions of the modes, Eq. (23)
    std::vector<T> u;          ///< first damping functions of the modes, Eq. (28)
    std::vector<T> g;          ///< second damping functions of the modes, Eq. (29)
    std::vector<Complex<T>> V; ///< complex response functions of the masses, Eq. (33)
    std::vector<T> U;          ///< first damping functions of the masses, Eq. (34)
    std::vector<T> G;          ///< second damping functions of the masses, Eq. (35)
    Complex<T> Y_jj;           ///< (33) with the load on the contact: its response to a unit force there, without friction
    T H_j;                     ///< Eq. (64)
    T sum_of_squares;          ///< sum of psi_ji^2, Eq. (65); 1 / (gamma_j r^2) if the mass matrix is diagonal
    std::shared_ptr<const CoupledFriction> coupled{}; ///< if damping couples the modes; else null
    std::optional<Mass> load_im{};                    ///< the row of the load's imaginary part; none if forces are in phase
};

/// @brief Checks that each mode moves by itself; InputError if damping couples the modes.
template <class T>
void check_uncoupled(const ModalBasis<T>& basis) {
    if (basis.couples)
        throw InputError("damping_matrix", "must not couple the modes: (23), (28), (29) are those of a mode that moves by itself",
                         "K M^-1 C is not C M^-1 K");
}

/// @brief Evaluates the modes at a frequency ratio and sums them, for a load that may be out of phase. Of a basis with the shapes
/// at a few masses alone, masses are counted among these; a load on several masses, which is none of them, has its row behind all
/// others. InputError if r, j or l breaks its rule, or D of the basis couples the modes; DomainError if an undamped mode is at a
/// pole of (23), (28). @eq{22,23,28,29,33,34,35,64,65}
template <class T>
[[nodiscard]] ModeSums<T> mode_sums(const ModalBasis<T>& basis, Mass contact, const LoadRows& load, const T& r);

/// @brief Sums over modes whose (23), (28), (29) at r were evaluated before.
template <class T>
[[nodiscard]] ModeSums<T> mode_sums(const ModalBasis<T>& basis, Mass contact, const LoadRows& load, const T& r,
                                    const std::vector<evaluation::ModeFunctions<T>>& functions);

/// @brief (23), (28), (29) of every mode; counted. DomainError if an undamped mode is at a pole.
template <class T>
[[nodiscard]] std::vector<evaluation::ModeFunctions<T>> mode_functions_at(const ModalBasis<T>& basis, const T& r);

/// @brief A row of the modal matrix, psi_k1 .. psi_kN.
template <class T>
[[nodiscard]] std::span<const T> mode_shapes_at(const ModeSums<T>& sums, Mass k) {
    return {sums.psi.data() + k.index * sums.R.size(), sums.R.size()};
}

/// @brief Number of modes evaluated since the program started; tests gate on it.
[[nodiscard]] inline long mode_evaluations() { return work_counted.mode_evaluations; }

} // namespace denhartog
