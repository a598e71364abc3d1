// A detour through double: everything that follows would be rounded.
#include "denhartog/number/number.hpp"

template <class T>
T kernel(const T& zeta) {
    return T(static_cast<int>(2 * static_cast<double>(zeta)));
}
