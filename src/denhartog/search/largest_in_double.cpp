#include "denhartog/search/largest_in_double.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <string>
#include <utility>

#include "denhartog/number/errors.hpp"

namespace denhartog {
namespace {

constexpr int first_intervals = 4; // each is looked at in its middle too
constexpr int second_looks = 256;  // at halves of intervals that hold no larger value, but perhaps one as large

template <class T>
struct Node {
    T tau;
    Sample<T> at;
};

// No value in it exceeds `highest`; where it is monotone, w has one zero at most.
template <class T>
struct Interval {
    Node<T> left, middle, right;
    T highest;
    bool monotone;
};

template <class T>
T absolute(const T& x) {
    return x < 0 ? T(-x) : x;
}

template <class T>
T rounding_of(const T& x) {
    return std::numeric_limits<T>::epsilon() * absolute(x);
}

template <class T>
bool opposite_signs(const T& a, const T& b) {
    return (a < 0 && b > 0) || (a > 0 && b < 0);
}

// Where w is zero: tau as a polynomial of third degree in w, through two samples with their slopes.
template <class T>
T zero_by_interpolation(const Node<T>& now, const Node<T>& before) {
    const T span = before.at.w - now.at.w, t = -now.at.w / span, rest = 1 - t;
    return now.tau + t * rest * rest * (span / now.at.slope) +
           t * t * ((1 + 2 * rest) * (before.tau - now.tau) - rest * (span / before.at.slope));
}

template <class T>
class MaximumSearch {
public:
    MaximumSearch(const Curve<T>& curve, const T& a, const T& b, const T& noise, Effort& effort, const T& least, const T& error)
        : curve_(curve), noise_(noise), error_(std::max(noise, error)), effort_(effort), best_{least, a, least, true, {}} {
        Node<T> left = node(a);
        for (int n = 1; n <= first_intervals; ++n) {
            const Node<T> right = node(n == first_intervals ? b : T(a + (b - a) * n / first_intervals));
            open_.push_back({left, right, right, T(0), false});
            left = right;
        }
        for (Interval<T>& each : open_) each = bounded(each.left, each.right);
        std::sort(open_.begin(), open_.end(), [](const Interval<T>& x, const Interval<T>& y) {
            return x.highest != y.highest ? x.highest < y.highest : x.left.tau < y.left.tau;
        });
    }

    Maximum<T> largest() {
        while (!open_.empty() && !effort_.exhausted()) {
            const Interval<T> now = open_.back();
            open_.pop_back();
            const bool passed_over = now.highest <= best_.value + noise_ + rounding();
            if (now.monotone && !has_root(now)) {
                dismiss_monotone(now);
            } else if (is_narrowest(now) || now.highest < level()) {
                dismiss_unseen(now);
            } else if (passed_over) {
                passed_over_.push_back(now);
            } else if (now.monotone) {
                dismiss_monotone(now);
            } else {
                halve(now);
            }
        }
        best_.settled = open_.empty();
        for (const Interval<T>& each : open_) dismiss_unseen(each);
        look_into_passed_over();
        best_.upper = std::max(best_.upper, best_.value) + noise_;
        gather_places();
        return std::move(best_);
    }

private:
    T rounding() const { return rounding_of(best_.value); }

    static bool has_root(const Interval<T>& in) { return opposite_signs(in.left.at.w, in.right.at.w); }
    static bool is_narrowest(const Interval<T>& in) { return !(in.left.tau < in.middle.tau && in.middle.tau < in.right.tau); }

    Node<T> node(const T& tau) {
        effort_.spend(curve_.cost);
        const Node<T> made{tau, curve_.sample(tau)};
        if (made.at.f > best_.value) {
            best_.value = made.at.f;
            best_.instant = tau;
        }
        return made;
    }

    Interval<T> bounded(const Node<T>& left, const Node<T>& right) {
        const T &from = left.tau, &to = right.tau;
        const Node<T> middle = node(T(from + (to - from) / 2));
        const T spread = curve_.rate(from, to) * (to - from) / 2, size = absolute(middle.at.z);
        return {left, middle, right, std::max(left.at.f, right.at.f) + curve_.rise(from, to, T(size + spread)), size > spread};
    }

    // The half that may be the higher one is looked into first.
    void halve(const Interval<T>& whole) {
        Interval<T> first = bounded(whole.left, whole.middle), second = bounded(whole.middle, whole.right);
        if (first.highest > second.highest) std::swap(first, second);
        open_.push_back(std::move(first));
        open_.push_back(std::move(second));
    }

    // By interpolation, kept between two places where w has opposite signs. Near the maximum f is flat: it is looked at in the
    // root alone, else rounding would choose the instant.
    Node<T> at_root(const Interval<T>& in) {
        constexpr int most_steps = 200;
        T a = in.left.tau, b = in.right.tau, step_before = b - a;
        Node<T> now = in.middle, before = opposite_signs(in.left.at.w, now.at.w) ? in.left : in.right;
        bool fell_off = false;
        for (int n = 0; n < most_steps && now.at.w != 0; ++n) {
            (opposite_signs(in.left.at.w, now.at.w) ? b : a) = now.tau;
            const T zero = zero_by_interpolation(now, before);
            const bool falls_off = zero > a && zero < b && 2 * absolute(T(zero - now.tau)) < step_before;
            const T next = falls_off ? zero : T(a + (b - a) / 2), step = absolute(T(next - now.tau)), tiny = rounding_of(next);
            // Steps fall off at least as those of Newton's method, each a multiple of the square of the one before. That multiple
            // is the one seen, or 1, if that is more: it is seen too small where the first step started next to the root.
            const bool falls_to_nothing = step * step <= tiny && step * step * step <= tiny * step_before * step_before;
            const bool ends = step <= tiny || (fell_off && falls_off && falls_to_nothing);
            if (ends || !(a < next && next < b)) return node(next);
            step_before = falls_off ? step : T(b - a);
            fell_off = falls_off;
            effort_.spend(curve_.cost);
            before = std::exchange(now, Node<T>{next, curve_.sample(next)});
        }
        return node(now.tau);
    }

    // Below it no value can be the largest.
    T level() const { return best_.value - 2 * error_ - rounding(); }

    // What was passed over holds no larger value, but perhaps one as large: where that is taken is narrowed down, all at the same
    // rate, as far as the effort goes.
    void look_into_passed_over() {
        std::vector<Interval<T>> now = std::move(passed_over_), next;
        for (int looks = 0; !now.empty(); now = std::move(next), next.clear())
            for (const Interval<T>& each : now) {
                if (each.highest < level()) {
                    dismiss_unseen(each);
                } else if (each.monotone) {
                    dismiss_monotone(each);
                } else if (is_narrowest(each) || looks == second_looks || effort_.exhausted()) {
                    dismiss_unseen(each);
                } else {
                    next.push_back(bounded(each.left, each.middle));
                    next.push_back(bounded(each.middle, each.right));
                    ++looks;
                }
            }
    }

    // It rises or falls from one end to the other, or up to a root and down again.
    void dismiss_monotone(const Interval<T>& in) {
        const Node<T> top = has_root(in) ? at_root(in) : in.left.at.f > in.right.at.f ? in.left : in.right;
        dismiss(in, top, top.at.f, T(0));
    }

    void dismiss_unseen(const Interval<T>& in) { dismiss(in, in.middle, in.highest, T(in.right.tau - in.left.tau)); }

    void dismiss(const Interval<T>& in, const Node<T>& top, const T& highest, const T& reach) {
        best_.upper = std::max(best_.upper, highest);
        if (highest < level()) return;
        best_.places.push_back({in.left.tau, in.right.tau, top.tau, top.at.f, highest, reach});
    }

    void gather_places() {
        std::erase_if(best_.places, [this](const Place<T>& each) { return each.upper < level(); });
        best_.places = joined(std::move(best_.places));
    }

    const Curve<T>& curve_;
    T noise_, error_;
    Effort& effort_;
    Maximum<T> best_;
    boost::container::small_vector<Interval<T>, 2 * first_intervals> open_;
    std::vector<Interval<T>> passed_over_;
};

} // namespace

template <class T>
std::vector<Place<T>> joined(std::vector<Place<T>> places) {
    std::sort(places.begin(), places.end(), [](const Place<T>& x, const Place<T>& y) { return x.from < y.from; });
    std::vector<Place<T>> kept;
    for (Place<T>& each : places) {
        if (kept.empty() || kept.back().to < each.from) {
            kept.push_back(std::move(each));
            continue;
        }
        // A function that rises up to the border goes on rising beyond it: that is no maximum of its own.
        Place<T>& last = kept.back();
        const bool last_goes_on = last.reach == 0 && last.instant == last.to;
        const bool each_goes_on = each.reach == 0 && each.instant == each.from;
        const bool takes_each = !each_goes_on && (last_goes_on || each.value > last.value);
        const Place<T>& taken = takes_each ? each : last;
        const Place<T>& other = takes_each ? last : each;
        const T reach = last_goes_on || each_goes_on
                            ? taken.reach
                            : std::max(taken.reach, T(absolute(T(other.instant - taken.instant)) + other.reach));
        last = {last.from,
                std::max(last.to, each.to),
                taken.instant,
                std::max(last.value, each.value),
                std::max(last.upper, each.upper),
                reach};
    }
    return kept;
}

template <class T>
std::vector<Place<T>> rivals(const std::vector<Place<T>>& places, const T& a, const T& b, const T& instant) {
    const auto from_instant = [&](const Place<T>& place) {
        return std::max({T(place.from - instant), T(instant - place.to), T(0)});
    };
    const auto own = std::min_element(places.begin(), places.end(),
                                      [&](const Place<T>& x, const Place<T>& y) { return from_instant(x) < from_instant(y); });
    const auto goes_on = [&](auto place) { // beyond the end of the stretch, where that is the end of another place
        const bool at_end =
            (place == places.begin() && place->instant == a) || (place + 1 == places.end() && place->instant == b);
        return at_end && place->reach == 0;
    };
    const auto is_end = [&](auto place) { return place == places.begin() || place + 1 == places.end(); };
    const bool across = !places.empty() && !(a < places.front().from) && !(places.back().to < b);
    std::vector<Place<T>> others;
    for (auto each = places.begin(); each != places.end(); ++each) {
        const bool is_same = across && is_end(each) && is_end(own) && (goes_on(each) || goes_on(own));
        if (each == own ? each->reach > 0 : !is_same) others.push_back(*each);
    }
    return others;
}

template <class T>
std::pair<T, T> root_bracket(const std::function<T(const T&)>& f, const T& a, const T& b, const T& f_a, const T& f_b) {
    const boost::math::tools::eps_tolerance<T> tolerance(std::numeric_limits<T>::digits - 1);
    std::uintmax_t steps = 200;
    return boost::math::tools::toms748_solve(f, a, b, f_a, f_b, tolerance, steps);
}

template <class T>
Maximum<T> global_maximum(const Curve<T>& curve, const T& a, const T& b, const T& noise, Effort* effort, const T& least,
                          const T& error) {
    SearchEffort own(curve.share);
    const Maximum<T> found = MaximumSearch<T>(curve, a, b, noise, effort != nullptr ? *effort : own, least, error).largest();
    if (effort == nullptr && !found.settled)
        throw PrecisionError(
            "the search does not settle the largest value over the half-period: " + (own.exhausted() ? own.ending() + "; " : "") +
            "the motion has too many oscillations, or its maximum is too flat for the digits of the number type");
    return found;
}

template Maximum<double> global_maximum(const Curve<double>&, const double&, const double&, const double&, Effort*, const double&,
                                        const double&);
template std::vector<Place<double>> joined(std::vector<Place<double>>);
template std::vector<Place<double>> rivals(const std::vector<Place<double>>&, const double&, const double&, const double&);
template std::pair<double, double> root_bracket(const std::function<double(const double&)>&, const double&, const double&,
                                                const double&, const double&);

} // namespace denhartog
