#include "denhartog/evaluation/wide_range.hpp"

#include "denhartog/evaluation/demand.hpp"
#include "denhartog/evaluation/mode.hpp"
#include "denhartog/number/multiprecision.hpp"

namespace denhartog::evaluation {

DampingFunctions<double> damping_functions_in_50_digits(double R, double zeta) {
    const DampingFunctions<Real50> f = selected_damping_functions(Real50(R), Real50(zeta));
    return {static_cast<double>(f.u), static_cast<double>(f.g)};
}

double s_d_integrand_in_50_digits(double tau, double R, double zeta) {
    const Real50 wide_R(R), wide_zeta(zeta);
    return static_cast<double>(s_d_integrand_of(Real50(tau), wide_R, wide_zeta, selected_damping_functions(wide_R, wide_zeta)));
}

} // namespace denhartog::evaluation
