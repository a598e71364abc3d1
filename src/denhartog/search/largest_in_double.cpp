#include "denhartog/search/largest_in_double.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "denhartog/number/errors.hpp"
#include "denhartog/search/zeros.hpp"
#include "denhartog/search/largest.hpp"

namespace denhartog {
namespace {

constexpr int first_intervals = 4; // each is looked at in its middle too
constexpr int second_looks = 256;  // at halves of intervals that hold no larger value, but perhaps one as large

template <class T>
struct Node {
    T tau;
    Sample<T> at;
};

// No value in it exceeds `upper`; where it is monotone, w has one zero at most. The higher one is looked into first.
template <class T>
struct Interval {
    Node<T> left, middle, right;
    T upper;
    bool monotone;

    friend bool operator<(const Interval& x, const Interval& y) {
        return x.upper != y.upper ? x.upper < y.upper : x.left.tau < y.left.tau;
    }
};

template <class T>
T absolute(const T& x) {
    return x < 0 ? T(-x) : x;
}

template <class T>
bool opposite_signs(const T& a, const T& b) {
    return (a < 0 && b > 0) || (a > 0 && b < 0);
}

template <class T>
class MaximumSearch {
public:
    MaximumSearch(const Curve<T>& curve, const T& a, const T& b, const T& noise, Effort& effort, const T& least, const T& error)
        : curve_(curve), noise_(noise), error_(std::max(noise, error)), effort_(effort), best_{least, a, least, true, {}} {
        Node<T> left = node(a);
        for (int n = 1; n <= first_intervals; ++n) {
            const Node<T> right = node(n == first_intervals ? b : T(a + (b - a) * n / first_intervals));
            add(left, right);
            left = right;
        }
    }

    Maximum<T> largest() {
        const auto may_be_larger = [this](const Interval<T>& in) { return in.upper > best_.value + noise_ + rounding(); };
        look([&](const Interval<T>& next) { return effort_.exhausted() || !may_be_larger(next); });
        best_.settled = open_.empty() || !may_be_larger(open_.front());
        // What is left holds no larger value, but perhaps one as large: where that is taken is narrowed down as the effort goes.
        int looks = 0;
        look([&](const Interval<T>& next) { return effort_.exhausted() || next.upper < level() || looks++ == second_looks; });
        for (const Interval<T>& each : open_) dismiss_unseen(each);
        best_.upper = std::max(best_.upper, best_.value) + noise_;
        gather_places();
        return std::move(best_);
    }

private:
    T rounding() const { return std::numeric_limits<T>::epsilon() * absolute(best_.value); }

    template <class Ends>
    void look(const Ends& ends) {
        branch_and_bound(open_, ends, [this](const Interval<T>& in) {
            if (in.monotone) {
                dismiss_monotone(in);
            } else if (!(in.left.tau < in.middle.tau && in.middle.tau < in.right.tau)) {
                dismiss_unseen(in);
            } else {
                add(in.left, in.middle);
                add(in.middle, in.right);
            }
        });
    }

    Node<T> node(const T& tau) {
        effort_.spend(curve_.cost);
        const Node<T> made{tau, curve_.sample(tau)};
        if (made.at.f > best_.value) {
            best_.value = made.at.f;
            best_.instant = tau;
        }
        return made;
    }

    void add(const Node<T>& left, const Node<T>& right) {
        const T &from = left.tau, &to = right.tau;
        const Node<T> middle = node(T(from + (to - from) / 2));
        const T spread = curve_.rate(from, to) * (to - from) / 2, size = absolute(middle.at.z);
        const T upper = std::max(left.at.f, right.at.f) + curve_.rise(from, to, T(size + spread));
        open_.push_back({left, middle, right, upper, size > spread});
    }

    // Near the maximum f is flat: it is looked at in the root alone, else rounding would choose the instant.
    Node<T> at_root(const Interval<T>& in) {
        const auto w = [](const Node<T>& n) { return ValueAt<T>{n.tau, n.at.w, n.at.slope}; };
        const auto w_at = [&](const T& tau) {
            effort_.spend(curve_.cost);
            return w({tau, curve_.sample(tau)});
        };
        const Node<T>& other = opposite_signs(in.left.at.w, in.middle.at.w) ? in.left : in.right;
        return node(bracketed_zero(w_at, w(in.middle), w(other)));
    }

    // Below it no value can be the largest.
    T level() const { return best_.value - 2 * error_ - rounding(); }

    // It rises or falls from one end to the other, or up to a root and down again.
    void dismiss_monotone(const Interval<T>& in) {
        const bool turns = opposite_signs(in.left.at.w, in.right.at.w);
        const Node<T> top = turns ? at_root(in) : in.left.at.f > in.right.at.f ? in.left : in.right;
        dismiss(in, top, top.at.f, T(0));
    }

    void dismiss_unseen(const Interval<T>& in) { dismiss(in, in.middle, in.upper, T(in.right.tau - in.left.tau)); }

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

} // namespace denhartog
