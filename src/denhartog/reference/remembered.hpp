/// @file
/// @brief Functions of time that remember what they were, as searches for several masses look at the same stretches.
#pragma once

#include <functional>
#include <map>
#include <utility>

#include "denhartog/number/ball.hpp"
#include "denhartog/reference/series.hpp"

namespace denhartog::reference {

/// @brief A function of time with a memory of all that was asked with the few bits of a search, and of the last that was asked.
template <class Value>
class Remembered {
public:
    /// @brief The function at an instant, exact.
    using AtInstant = std::function<Value(const Ball& tau)>;
    /// @brief The function over a stretch from what it is in the middle.
    using OverStretch = std::function<Value(const Value& in_the_middle, const Ball& tau)>;

    /// @param at    the function at an instant @param over  the same over a stretch
    Remembered(AtInstant at, OverStretch over) : at_(std::move(at)), over_(std::move(over)) {}
    /// @brief The function. @param tau an instant or a stretch @return its value, which lasts until the next call
    const Value& operator()(const Ball& tau) {
        // two balls may be so near that their ends are the same in double: each has a value of its own
        const auto is = [&](const Known& k) { return k.bits == ball_bits && arb_equal(k.tau.a, tau.a) != 0; };
        if (is(last_)) return last_.value;
        if (ball_bits > bits_of_search) {
            last_ = known(tau);
            return last_.value;
        }
        const std::pair stretch{tau.low(), tau.high()};
        const auto found = all_.find(stretch);
        if (found != all_.end() && is(found->second)) return found->second.value;
        Known now = known(tau);
        if (all_.size() >= most_remembered) all_.clear(); // a search next to a resonance looks at tens of thousands
        return all_.insert_or_assign(stretch, std::move(now)).first->second.value;
    }

private:
    struct Known {
        Ball tau{};
        slong bits = 0;
        Value value{};
    };

    static constexpr std::size_t most_remembered = 4096;

    Known known(const Ball& tau) {
        if (arb_is_exact(tau.a) != 0) return {tau, ball_bits, at_(tau)};
        return {tau, ball_bits, over_((*this)(middle(tau)), tau)};
    }

    AtInstant at_;
    OverStretch over_;
    Known last_{};
    std::map<std::pair<double, double>, Known> all_{};
};

} // namespace denhartog::reference
