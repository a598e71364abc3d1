#include "derivation/observations/boundary_maxima.hpp"

#include <cmath>

#include "denhartog/number/errors.hpp"

namespace denhartog::derivation {

double departure_of_67(const Boundary<double>& b) { return b.approximate / b.exact - 1; }

double loss_by_56(const Boundary<double>& b) { return 1 - b.paper / b.exact; }

LargestOverRange largest_over_frequency(const ObservedSystem& s, double low, double high,
                                        const std::function<double(const Boundary<double>&)>& of) {
    const auto at = [&](double r) {
        try {
            return of(boundary(sums_at(s, r), 1.0));
        } catch (const DomainError&) { // a pole of (28) without damping
            return std::nan("");
        } catch (const PrecisionError&) { // next to one
            return std::nan("");
        }
    };
    return largest_over_range(at, low, high, 1000);
}

} // namespace denhartog::derivation
