// A branch on a value: one side of it would escape the proof.
#include "denhartog/number/number.hpp"

template <class T>
T kernel(const T& zeta) {
    if (zeta < 1) return sqrt(1 - zeta * zeta);
    return sqrt(zeta * zeta - 1);
}
