#include "denhartog/evaluation/wide_range.hpp"

#include "denhartog/evaluation/mode.hpp"
#include "denhartog/number/multiprecision.hpp"

namespace denhartog::evaluation {

DampingFunctions<double> damping_functions_in_50_digits(double R, double zeta) {
    const DampingFunctions<Real50> f = selected_damping_functions(Real50(R), Real50(zeta));
    return {static_cast<double>(f.u), static_cast<double>(f.g)};
}

} // namespace denhartog::evaluation
