#include "denhartog/sliding/maximum.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <limits>
#include <vector>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"

namespace denhartog {
namespace {

constexpr int first_intervals = 16;
constexpr long most_intervals = 1L << 21;

template <class T>
struct Node {
    T tau;
    Sample<T> at;
};

template <class T>
struct Interval {
    Node<T> left, right;
};

template <class T>
T absolute(const T& x) {
    return x < 0 ? T(-x) : x;
}

template <class T>
void improve(Maximum<T>& best, const Node<T>& node) {
    if (node.at.f > best.value) best = {node.at.f, node.tau};
}

template <class T>
bool opposite_signs(const T& a, const T& b) {
    return (a < 0 && b > 0) || (a > 0 && b < 0);
}

} // namespace

template <class T>
T bracketed_root(const std::function<T(const T&)>& f, const T& a, const T& b, const T& f_a, const T& f_b) {
    const boost::math::tools::eps_tolerance<T> tolerance(std::numeric_limits<T>::digits - 1);
    std::uintmax_t steps = 200;
    const auto bracket = boost::math::tools::toms748_solve(f, a, b, f_a, f_b, tolerance, steps);
    return (bracket.first + bracket.second) / 2;
}

template <class T>
Maximum<T> global_maximum(const Curve<T>& curve, const T& a, const T& b) {
    std::vector<Interval<T>> open;
    Node<T> left{a, curve.sample(a)};
    Maximum<T> best{left.at.f, left.tau};
    for (int n = 1; n <= first_intervals; ++n) {
        const T tau = n == first_intervals ? b : T(a + (b - a) * n / first_intervals);
        const Node<T> right{tau, curve.sample(tau)};
        improve(best, right);
        open.push_back({left, right});
        left = right;
    }
    for (long count = 0; !open.empty(); ++count) {
        if (count == most_intervals)
            throw PrecisionError(
                "the largest value over the half-period is not settled after " + std::to_string(count) +
                " intervals: the motion has too many oscillations, or its maximum is too flat for the digits carried");
        const Interval<T> interval = open.back();
        open.pop_back();
        const T& from = interval.left.tau;
        const T& to = interval.right.tau;
        const T tau = from + (to - from) / 2;
        if (!(from < tau && tau < to)) continue;
        const Node<T> middle{tau, curve.sample(tau)};
        improve(best, middle);
        const T spread = curve.rate(from, to) * (to - from) / 2;
        const T size = absolute(middle.at.z);
        const T highest = std::max(interval.left.at.f, interval.right.at.f) + curve.rise(from, to, size + spread);
        if (highest <= best.value + std::numeric_limits<T>::epsilon() * absolute(best.value)) continue;
        if (size <= spread) {
            open.push_back({interval.left, middle});
            open.push_back({middle, interval.right});
        } else if (opposite_signs(interval.left.at.w, interval.right.at.w)) {
            const std::function<T(const T&)> w = [&](const T& t) { return curve.sample(t).w; };
            const T root = bracketed_root(w, from, to, interval.left.at.w, interval.right.at.w);
            improve(best, {root, curve.sample(root)});
        }
    }
    return best;
}

template Maximum<double> global_maximum(const Curve<double>&, const double&, const double&);
template Maximum<long double> global_maximum(const Curve<long double>&, const long double&, const long double&);
template Maximum<Real50> global_maximum(const Curve<Real50>&, const Real50&, const Real50&);
template Maximum<Real100> global_maximum(const Curve<Real100>&, const Real100&, const Real100&);
template double bracketed_root(const std::function<double(const double&)>&, const double&, const double&, const double&,
                               const double&);
template long double bracketed_root(const std::function<long double(const long double&)>&, const long double&, const long double&,
                                    const long double&, const long double&);
template Real50 bracketed_root(const std::function<Real50(const Real50&)>&, const Real50&, const Real50&, const Real50&,
                               const Real50&);
template Real100 bracketed_root(const std::function<Real100(const Real100&)>&, const Real100&, const Real100&, const Real100&,
                                const Real100&);

} // namespace denhartog
