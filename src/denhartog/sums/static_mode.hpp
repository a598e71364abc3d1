/// @file
/// @brief A mode far above the frequency of the force, which follows it statically, with bounds of what that leaves out.
#pragma once

#include "denhartog/evaluation/mode.hpp"
#include "denhartog/number/bounded.hpp"

namespace denhartog {

/// @brief (23), (28), (29) by their limits v = 1, u = 0, g = 1 for \f$ R \to 0 \f$, within bounds that hold at any R.
///
/// From (23), (28), (29) with \f$ \delta=\pi\zeta/R \f$
/// \f[ |v-1| = R\sqrt{\frac{R^2+4\zeta^2}{(1-R^2)^2+4\zeta^2R^2}}, \qquad |u| \le \frac{1}{R\,w\,(\cosh\delta-1)}, \qquad
///     |g-1| \le \frac{e^{-\delta}+1+\zeta/w}{\cosh\delta-1}; \f]
/// where the mode does not oscillate \f$ 0 < u < 2S/R \f$ and \f$ 0 < 1-g < 2(d+e^{-2\delta}) \f$ with
/// \f$ d = e^{-a\pi/R} + aS \f$, a the slow rate. It costs no sine: the mode counts as not evaluated.
/// @eq{23,28,29}
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      the functions; without a bound where the mode is not damped
[[nodiscard]] evaluation::ModeFunctions<Bounded<double>> static_mode_functions(double R, double zeta);

} // namespace denhartog
