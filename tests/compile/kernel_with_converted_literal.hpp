// A rounded number, written as a conversion: it must not be cut to the integer 0 either.
#include "denhartog/number/number.hpp"

template <class T>
T kernel(const T& zeta) {
    return T(0.5) * zeta;
}
