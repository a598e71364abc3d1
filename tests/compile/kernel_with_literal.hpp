// A rounded number in a formula; here one half, but the type cannot tell it from 0.1.
#include "denhartog/number/number.hpp"

template <class T>
T kernel(const T& zeta) {
    return 0.5 * zeta;
}
