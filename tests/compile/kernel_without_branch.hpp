// As the formulas are: integers, the four operations, elementary functions.
#include "denhartog/number/number.hpp"

template <class T>
T kernel(const T& zeta) {
    const T w = sqrt(1 - zeta * zeta);
    return T(1) / 2 * exp(-zeta) * (cos(w) + zeta / w * sin(w));
}
