// Where is a curve largest, with no maximum between two samples missed? Branch and bound on intervals, by values, slopes and a
// bound of the rate of the curvature. Read `largest` first; `add` bounds an interval, and `dismiss` gathers the places that stay
// open.
#include "denhartog/search/largest.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "denhartog/number/why.hpp"
#include "denhartog/search/zeros.hpp"

namespace denhartog {
namespace {

constexpr int first_intervals = 4; // each is looked at in its middle too
constexpr int second_looks = 256;  // at halves of intervals that hold no larger value, but perhaps one as large

struct Node {
    double tau;
    Sample at;
};

// No value in it exceeds `upper`; if it is monotone, w has one zero at most. The higher one is looked into first.
struct Interval {
    Node left, middle, right;
    double upper;
    bool monotone;

    friend bool operator<(const Interval& x, const Interval& y) {
        return x.upper != y.upper ? x.upper < y.upper : x.left.tau < y.left.tau;
    }
};

bool opposite_signs(double a, double b) { return (a < 0 && b > 0) || (a > 0 && b < 0); }

class MaximumSearch {
public:
    MaximumSearch(const Curve& curve, double a, double b, double noise, Effort& effort, double least, double error)
        : curve_(curve), noise_(noise), error_(std::max(noise, error)), effort_(effort), best_{least, a, least, true, {}} {
        Node left = node(a);
        for (int n = 1; n <= first_intervals; ++n) {
            const Node right = node(n == first_intervals ? b : a + (b - a) * n / first_intervals);
            add(left, right);
            left = right;
        }
    }

    Maximum largest() {
        const auto may_be_larger = [this](const Interval& in) { return in.upper > best_.value + noise_ + rounding(); };
        look([&](const Interval& next) { return effort_.exhausted() || !may_be_larger(next); });
        best_.settled = open_.empty() || !may_be_larger(open_.front());
        // The rest holds no larger value, but perhaps one as large: its place is narrowed down as the effort goes.
        int looks = 0;
        look([&](const Interval& next) { return effort_.exhausted() || next.upper < level() || looks++ == second_looks; });
        for (const Interval& each : open_) dismiss_unseen(each);
        best_.upper = std::max(best_.upper, best_.value) + noise_;
        std::erase_if(best_.places, [this](const Place& each) { return each.upper < level(); });
        best_.places = joined(std::move(best_.places));
        return std::move(best_);
    }

private:
    double rounding() const { return std::numeric_limits<double>::epsilon() * std::abs(best_.value); }

    template <class Ends>
    void look(const Ends& ends) {
        branch_and_bound(open_, ends, [this](const Interval& in) {
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

    Node node(double tau) {
        effort_.spend(curve_.cost);
        const Node made{tau, curve_.sample(tau)};
        if (made.at.f > best_.value) {
            best_.value = made.at.f;
            best_.instant = tau;
        }
        return made;
    }

    void add(const Node& left, const Node& right) {
        const double &from = left.tau, &to = right.tau;
        const Node middle = node(from + (to - from) / 2);
        const double spread = curve_.rate(from, to) * (to - from) / 2, size = std::abs(middle.at.z);
        const double upper = std::max(left.at.f, right.at.f) + curve_.rise(from, to, size + spread);
        open_.push_back({left, middle, right, upper, size > spread});
    }

    // Near the maximum f is flat: it is looked at in the root alone, else rounding would choose the instant.
    Node at_root(const Interval& in) {
        const auto w = [](const Node& n) { return ValueAt{n.tau, n.at.w, n.at.slope}; };
        const auto w_at = [&](double tau) {
            effort_.spend(curve_.cost);
            return w({tau, curve_.sample(tau)});
        };
        const Node& other = opposite_signs(in.left.at.w, in.middle.at.w) ? in.left : in.right;
        return node(bracketed_zero(w_at, w(in.middle), w(other)));
    }

    // Below it no value can be the largest.
    double level() const { return best_.value - 2 * error_ - rounding(); }

    // It rises or falls from one end to the other, or up to a root and down again.
    void dismiss_monotone(const Interval& in) {
        const bool turns = opposite_signs(in.left.at.w, in.right.at.w);
        const Node top = turns ? at_root(in) : in.left.at.f > in.right.at.f ? in.left : in.right;
        dismiss(in, top, top.at.f, 0.0);
    }

    void dismiss_unseen(const Interval& in) { dismiss(in, in.middle, in.upper, in.right.tau - in.left.tau); }

    void dismiss(const Interval& in, const Node& top, double highest, double reach) {
        best_.upper = std::max(best_.upper, highest);
        if (highest < level()) return;
        best_.places.push_back({in.left.tau, in.right.tau, top.tau, top.at.f, highest, reach});
    }

    const Curve& curve_;
    double noise_, error_;
    Effort& effort_;
    Maximum best_;
    boost::container::small_vector<Interval, 2 * first_intervals> open_;
};

} // namespace

std::vector<Place> joined(std::vector<Place> places) {
    std::sort(places.begin(), places.end(), [](const Place& x, const Place& y) { return x.from < y.from; });
    std::vector<Place> kept;
    for (Place& each : places) {
        if (kept.empty() || kept.back().to < each.from) {
            kept.push_back(std::move(each));
            continue;
        }
        // A function that rises up to the border goes on rising beyond it: that is no maximum of its own.
        Place& last = kept.back();
        const bool last_goes_on = last.reach == 0 && last.instant == last.to;
        const bool each_goes_on = each.reach == 0 && each.instant == each.from;
        const bool takes_each = !each_goes_on && (last_goes_on || each.value > last.value);
        const Place& taken = takes_each ? each : last;
        const Place& other = takes_each ? last : each;
        const double reach = last_goes_on || each_goes_on
                                 ? taken.reach
                                 : std::max(taken.reach, std::abs(other.instant - taken.instant) + other.reach);
        last = {last.from,
                std::max(last.to, each.to),
                taken.instant,
                std::max(last.value, each.value),
                std::max(last.upper, each.upper),
                reach};
    }
    return kept;
}

std::vector<Place> rivals(const std::vector<Place>& places, double a, double b, double instant) {
    const auto from_instant = [&](const Place& place) { return std::max({place.from - instant, instant - place.to, 0.0}); };
    const auto own = std::min_element(places.begin(), places.end(),
                                      [&](const Place& x, const Place& y) { return from_instant(x) < from_instant(y); });
    const auto goes_on = [&](auto place) { // beyond the end of the stretch, if that is the end of another place
        const bool at_end =
            (place == places.begin() && place->instant == a) || (place + 1 == places.end() && place->instant == b);
        return at_end && place->reach == 0;
    };
    const auto is_end = [&](auto place) { return place == places.begin() || place + 1 == places.end(); };
    const bool across = !places.empty() && !(a < places.front().from) && !(places.back().to < b);
    std::vector<Place> others;
    for (auto each = places.begin(); each != places.end(); ++each) {
        const bool is_same = across && is_end(each) && is_end(own) && (goes_on(each) || goes_on(own));
        if (each == own ? each->reach > 0 : !is_same) others.push_back(*each);
    }
    return others;
}

Maximum global_maximum(const Curve& curve, double a, double b, double noise, Effort* effort, double least, double error) {
    SearchEffort own(curve.share, curve.question);
    const Maximum found = MaximumSearch(curve, a, b, noise, effort != nullptr ? *effort : own, least, error).largest();
    if (effort == nullptr && !found.settled)
        throw PrecisionError(Reasons(Why::largest_not_settled) + (own.exhausted() ? own.ending() : Reasons()) +
                                 Why::too_many_oscillations,
                             own.outcome());
    return found;
}

} // namespace denhartog
