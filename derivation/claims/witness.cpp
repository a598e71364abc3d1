#include "derivation/claims/witness.hpp"

#include <iomanip>
#include <limits>
#include <sstream>

namespace denhartog::derivation {

std::string text(double x) {
    std::ostringstream out;
    out << std::setprecision(std::numeric_limits<double>::max_digits10) << x;
    return out.str();
}

Witness with(Witness w, std::initializer_list<std::pair<std::string, std::string>> more) {
    w.insert(w.end(), more.begin(), more.end());
    return w;
}

} // namespace denhartog::derivation
