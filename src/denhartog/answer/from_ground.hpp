/// @file
/// @brief The motion of the masses as it is seen from the ground, where base and wall, or the wall alone, move by
/// \f$ b\cos\tau \f$: absolute displacements are the relative ones and that.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/sliding/mode_sums.hpp"

namespace denhartog {

/// @brief b in units of P / k_1: \f$ 1/r^2 \f$ of base and wall with \f$ P = m_1\omega^2X \f$, 1 of one of them with
/// \f$ P = k_1X \f$; none where neither moves.
template <class T>
[[nodiscard]] std::optional<T> amplitude_of_base(BaseMotion motion, const T& r) {
    if (motion == BaseMotion::none) return std::nullopt;
    return motion == BaseMotion::with_wall ? T(T(1) / (r * r)) : T(1);
}

/// @brief How far the frame of the displacements moves, b; zero where they are absolute.
[[nodiscard]] inline Bounded<double> amplitude_of_frame(const Scene<double>& scene) {
    const BaseMotion motion = scene.system.base_motion;
    if (motion == BaseMotion::none || motion == BaseMotion::alone) return Bounded<double>(0);
    return *amplitude_of_base(motion, as_input(*scene.r));
}

/// @brief A mass in its absolute motion, whose amplitude and phase have the bounds of the relative one's.
[[nodiscard]] inline MassFromGround from_ground(const SolvedMass& absolute, const Bounded<double>& base) {
    const Bounded<double> X(absolute.amplitude.value, absolute.amplitude.error);
    return {absolute.amplitude, certified(X / base), absolute.phase};
}

/// @brief (33) of an absolute displacement: a harmonic motion of the frame adds to it. A wall that moves alone acts by friction
/// alone: without friction no mass moves, and \f$ V_{dk} = -b \f$ in its frame.
template <class T>
[[nodiscard]] Complex<T> response_from_ground(const Complex<T>& V_dk, BaseMotion motion, const T& b) {
    return motion == BaseMotion::wall ? Complex<T>{T(0), T(0)} : Complex<T>{V_dk.re + b, V_dk.im};
}

/// @brief Sums whose displacements are absolute; friction knows the relative displacement of the contact alone, which is the row
/// behind those of the masses.
[[nodiscard]] inline ModeSums<Bounded<double>> sums_from_ground(const ModeSums<Bounded<double>>& s, std::size_t N,
                                                                BaseMotion motion, const Bounded<double>& b) {
    ModeSums<Bounded<double>> seen = s;
    const std::size_t j = s.contact.index;
    seen.V.assign(s.V.begin(), s.V.begin() + static_cast<std::ptrdiff_t>(N));
    for (Complex<Bounded<double>>& V_k : seen.V) V_k = response_from_ground(V_k, motion, b);
    seen.U.resize(N);
    seen.G.resize(N);
    seen.V.push_back(s.V[j]);
    seen.U.push_back(s.U[j]);
    seen.G.push_back(s.G[j]);
    const auto psi_j = mode_shapes_at(s, s.contact);
    seen.psi.resize(N * s.R.size());
    seen.psi.insert(seen.psi.end(), psi_j.begin(), psi_j.end());
    seen.contact = seen.load = Mass{N};
    seen.load_im.reset();
    return seen;
}

} // namespace denhartog
