/// @file
/// @brief Where an amplitude that depends on one number has a value, or is largest or least, from amplitudes with bounds.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "denhartog/number/tried.hpp"
#include "denhartog/solve/find.hpp"

namespace denhartog {

/// @brief The amplitude at a value of the number; none if no steady motion is certain there.
using AmplitudeAt = std::function<Tried<Certified>(double)>;

/// @brief The sign of an amplitude less a value; 0 if the digits do not tell.
[[nodiscard]] inline int sign_of(const Certified& a, double value) {
    if (a.value - a.error > value) return 1;
    return a.value + a.error < value ? -1 : 0;
}

/// @brief A search over one number, which remembers what it has seen.
class AmplitudeSearch {
public:
    /// @brief Asks for the amplitude at the first places, which ascend.
    AmplitudeSearch(std::vector<double> first, AmplitudeAt amplitude) : at_(std::move(first)), amplitude_(std::move(amplitude)) {
        for (const double x : at_) (void)look(x);
    }

    /// @brief Where it has a value.
    FoundPlaces value(double target) {
        struct Known {
            double x;
            int sign;
        };
        std::optional<Known> last; // the last place with a certain sign
        bool gap = false;          // whether there is a place without an answer behind it
        double open = 0;           // the first place behind it whose sign the digits do not tell, if there is one
        bool is_open = false;
        for (std::size_t n = 0; n < at_.size(); ++n) {
            const Tried<Certified>& seen = look(at_[n]);
            if (!seen.value) {
                gap = true;
                is_open = false;
                continue;
            }
            const int sign = sign_of(*seen.value, target);
            if (sign == 0) {
                if (!is_open) open = at_[n];
                is_open = true;
                continue;
            }
            if (last && sign != last->sign && gap)
                add(PlaceIs::undecided, last->x, at_[n], at_[n]);
            else if (last && sign != last->sign)
                cross(last->x, at_[n], target);
            else if (is_open)
                add(PlaceIs::undecided, last ? last->x : open, at_[n], open);
            else if (last && !gap)
                look_between(n, sign, target);
            last = Known{at_[n], sign};
            gap = is_open = false;
        }
        if (is_open) add(PlaceIs::undecided, last ? last->x : open, at_.back(), open);
        return finish();
    }

    /// @brief The amplitude where it is largest, or least, of all that were seen.
    Tried<Certified> amplitude_of_extreme(bool largest) {
        const std::optional<double> x = place_of_extreme(largest);
        return x ? look(*x) : Tried<Certified>{found_.outcome, found_.why};
    }

    /// @brief Where it is largest, or least.
    FoundPlaces extreme(bool largest) {
        if (const std::optional<double> best = place_of_extreme(largest)) {
            const double x = *best;
            const std::optional<double> below = certainly_worse(x, -1, largest), above = certainly_worse(x, 1, largest);
            const double from = below.value_or(at_.front()), to = above.value_or(at_.back());
            const bool at_end = (x == at_.front() && above) || (x == at_.back() && below);
            add(has_gap(from, to) ? PlaceIs::undecided
                : below && above  ? PlaceIs::extreme
                : at_end          ? PlaceIs::end_of_range
                                  : PlaceIs::undecided,
                from, to, x);
        }
        return finish();
    }

private:
    static constexpr double eps = std::numeric_limits<double>::epsilon();
    static constexpr int bits_of_extreme = 24;                     // to which its place is followed: the amplitude is flat there
    static constexpr std::uintmax_t most_steps = 60;               // of narrowing an extreme
    static constexpr std::uintmax_t most_steps_of_crossing = 1200; // also from an interval over all doubles

    static bool is_certainly_less(const Certified& a, const Certified& b) { return a.value + a.error < b.value - b.error; }

    const Tried<Certified>& look(double x) {
        const auto known = seen_.find(x);
        if (known != seen_.end()) return known->second;
        const Tried<Certified>& now = seen_.emplace(x, amplitude_(x)).first->second;
        if (!now.value) {
            found_.unanswered.push_back(x);
            if (found_.unanswered.size() == 1) {
                found_.outcome = now.outcome;
                found_.why = now.why;
            }
        }
        return now;
    }

    void add(PlaceIs is, double from, double to, double at) { found_.places.push_back({is, from, to, at, *look(at).value}); }

    static bool is_better(bool largest, const Certified& a, const Certified& b) {
        return largest ? a.value > b.value : a.value < b.value;
    }

    // The place at which it is largest, or least, of all that were seen; none if it is known at none.
    std::optional<double> place_of_extreme(bool largest) {
        std::optional<double> best;
        const auto take = [&](double x) {
            const Tried<Certified>& seen = look(x);
            if (seen.value && (!best || is_better(largest, *seen.value, *look(*best).value))) best = x;
        };
        for (const double x : at_) take(x);
        for (std::size_t n = 1; n + 1 < at_.size(); ++n) {
            const auto &before = look(at_[n - 1]).value, &here = look(at_[n]).value, &after = look(at_[n + 1]).value;
            if (!before || !here || !after || is_better(largest, *before, *here) || is_better(largest, *after, *here)) continue;
            take(place_of_least(at_[n - 1], at_[n + 1], [&](const Certified& a) { return largest ? -a.value : a.value; }));
        }
        return best;
    }

    // A place between two where a function of the amplitude is least.
    template <class Function>
    double place_of_least(double from, double to, const Function& f) {
        std::uintmax_t steps = most_steps;
        const auto at = [&](double x) {
            const Tried<Certified>& seen = look(x);
            return seen.value ? f(*seen.value) : std::numeric_limits<double>::max();
        };
        return boost::math::tools::brent_find_minima(at, from, to, bits_of_extreme, steps).first;
    }

    // Between the neighbours of a place that is nearer to the value than both, the amplitude may cross it twice.
    void look_between(std::size_t n, int sign, double target) {
        if (n < 2) return;
        const auto &first = look(at_[n - 2]).value, &middle = look(at_[n - 1]).value, &last = look(at_[n]).value;
        if (!first || !middle || !last || sign_of(*first, target) != sign || sign_of(*middle, target) != sign) return;
        const auto away = [&](const Certified& a) { return sign * (a.value - target); };
        if (away(*middle) > away(*first) || away(*middle) > away(*last)) return;
        const double x = place_of_least(at_[n - 2], at_[n], away);
        if (!look(x).value) return;
        const int there = sign_of(*look(x).value, target);
        if (there == -sign) {
            cross(at_[n - 2], x, target);
            cross(x, at_[n], target);
        } else if (there == 0) {
            add(PlaceIs::undecided, at_[n - 2], at_[n], x);
        }
    }

    // Narrows an interval with certain and different signs at its ends.
    void cross(double from, double to, double target) {
        double low = from, high = to;
        const int sign = sign_of(*look(from).value, target);
        const auto g = [&](double x) {
            const Tried<Certified>& seen = look(x);
            if (!seen.value) return 0.0; // ends the narrowing
            const int there = sign_of(*seen.value, target);
            if (there == sign) low = std::max(low, x);
            if (there == -sign) high = std::min(high, x);
            return seen.value->value - target;
        };
        std::uintmax_t steps = most_steps_of_crossing;
        const auto done = [](double a, double b) { return std::abs(b - a) <= 2 * eps * std::max(std::abs(a), std::abs(b)); };
        const auto [a, b] = boost::math::tools::toms748_solve(g, from, to, g(from), g(to), done, steps);
        double at = a + (b - a) / 2;
        // From there outwards to where the sign is certain.
        for (const bool up : {false, true})
            for (double width = std::max({4 * eps * std::abs(at), b - a, 0x1p-60 * (to - from)});
                 (up ? high - at : at - low) > width; width *= 4)
                (void)g(up ? at + width : at - width);
        if (at < low || at > high) at = low + (high - low) / 2; // where it crosses more than once
        if (!look(at).value) at = low;
        const Certified &below = *look(low).value, &above = *look(high).value;
        const double step = std::abs(above.value - below.value), unsure = below.error + above.error;
        const bool narrow = high - low <= 64 * eps * std::max(std::abs(low), std::abs(high));
        const bool near = std::abs(look(at).value->value - target) <= 8 * unsure;
        const bool jumps = narrow && !near && step > 64 * unsure;
        const bool wide = steps >= most_steps_of_crossing; // the steps were not enough
        add(has_gap(low, high) || wide ? PlaceIs::undecided : jumps ? PlaceIs::jump : PlaceIs::crossing, low, high, at);
    }

    bool has_gap(double from, double to) const {
        return std::ranges::any_of(found_.unanswered, [&](double at) { return from <= at && at <= to; });
    }

    // From a place on, by steps in one direction, the first one at which the amplitude is certainly worse or not known; none if
    // there is none.
    std::optional<double> certainly_worse(double x, int direction, bool largest) {
        const double end = direction < 0 ? at_.front() : at_.back();
        const Certified here = *look(x).value;
        for (double width = (at_.back() - at_.front()) * 0x1p-40; std::abs(end - x) > width; width *= 2) {
            const double next = x + direction * width;
            const std::optional<Certified> there = look(next).value;
            if (!there) return next;
            if (largest ? is_certainly_less(*there, here) : is_certainly_less(here, *there)) return next;
        }
        return std::nullopt;
    }

    FoundPlaces finish() {
        std::ranges::sort(found_.unanswered);
        std::ranges::sort(found_.places, {}, &FoundPlace::at);
        return std::move(found_);
    }

    std::vector<double> at_;
    AmplitudeAt amplitude_;
    std::map<double, Tried<Certified>> seen_;
    FoundPlaces found_;
};

} // namespace denhartog
