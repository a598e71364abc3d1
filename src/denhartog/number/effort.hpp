// A budget of work, counted in operations: no search runs on without end, and none looks at a clock.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "denhartog/number/why.hpp"

namespace denhartog {

// Work allowed and spent.
//
// One operation is the evaluation of one mode at one instant in double: an exponential, a sine, a cosine and what goes with
// them, about a tenth of a microsecond. A search that finds its budget spent ends and gives what is certain until then;
// `pay` throws.
struct Effort {
    long allowed = std::numeric_limits<long>::max();  // operations allowed
    long spent = 0;                                   // operations spent
    const std::function<bool()>* cancelled = nullptr; // ends the search from outside once it gives true; null: nobody does
    bool chosen = false; // whether the user chose what is allowed: one search may then spend all of it

    void spend(long operations) { spent += operations; }
    // Operations still allowed, not negative.
    [[nodiscard]] long left() const { return std::max(0L, allowed - spent); }
    // Whether a search has to end: the budget is spent, or somebody cancelled.
    [[nodiscard]] bool exhausted() const { return spent >= allowed || is_cancelled(); }
    [[nodiscard]] bool is_cancelled() const { return cancelled != nullptr && (*cancelled)(); }
    // Why a search ended that has exhausted it.
    [[nodiscard]] Reasons ending() const { return is_cancelled() ? Reasons(Why::cancelled) : Reasons(Why::effort_spent, allowed); }
};

// Whether a budget is exhausted, if there is one.
[[nodiscard]] inline bool is_exhausted(const Effort* effort) { return effort != nullptr && effort->exhausted(); }

// Spends of a budget, if there is one. Throws PrecisionError if nothing is left of it.
inline void pay(Effort* effort, long operations) {
    if (effort == nullptr) return;
    effort->spend(operations);
    if (effort->exhausted()) throw PrecisionError(effort->ending(), Outcome::budget_spent);
}

// Operations that products of matrices cost, by the multiplications in them: many are done at a time.
[[nodiscard]] constexpr long cost_of_products(long multiplications) { return multiplications / 512; }

// Pays for products of matrices, half of that: an eigen-solver does many of them at a time.
inline void pay_for_products(Effort* effort, long multiplications) { pay(effort, cost_of_products(multiplications) / 2); }

// The budget of a question if none is asked for: 1e7 operations for twelve modes and fewer, 4.5e8 for a hundred. Up
// to there it grows as products of matrices do that a motion with stops takes.
[[nodiscard]] constexpr long default_effort(std::size_t modes) {
    const auto N = static_cast<long>(std::max<std::size_t>(modes, 12)), operations = 10'000'000 / 12 * N;
    return std::max(operations, std::min(operations * (8 + N) / 20, 450'000'000L)) + 4 * (N * N * N - 12 * 12 * 12);
}

// The budget of one question.
class QuestionEffort : public Effort {
public:
    // The budget is that of the modes if the user chose none; `asked` is called now and then, and ends the
    // question once it gives true.
    explicit QuestionEffort(std::size_t modes, std::optional<long> by_user = {}, std::function<bool()> asked = {})
        : asked_(std::move(asked)) {
        allowed = by_user.value_or(default_effort(modes));
        chosen = by_user.has_value();
        if (asked_) cancelled = &asked_;
    }
    QuestionEffort(const QuestionEffort&) = delete;
    QuestionEffort& operator=(const QuestionEffort&) = delete;

private:
    std::function<bool()> asked_;
};

// A budget that somebody gave, raised to that of the modes if the user chose none; or that of the modes.
class GivenEffort {
public:
    GivenEffort(Effort* given, std::size_t modes) : own_{default_effort(modes)}, effort_(given != nullptr ? given : &own_) {
        if (!effort_->chosen) effort_->allowed = std::max(effort_->allowed, own_.allowed);
    }
    GivenEffort(const GivenEffort&) = delete;
    GivenEffort& operator=(const GivenEffort&) = delete;

    [[nodiscard]] Effort* get() const { return effort_; }

private:
    Effort own_;
    Effort* effort_;
};

// The effort of one search: a share of the budget of its question, if there is one, from which it is taken at the end of the
// scope.
class SearchEffort : public Effort {
public:
    // share: operations. If the user has chosen the budget of the question, a search may spend all that is left of it.
    SearchEffort(long share, Effort* question) : question_(question) {
        allowed = share;
        if (question_ == nullptr) return;
        allowed = question_->chosen ? question_->left() : std::min(share, question_->left());
        cancelled = question_->cancelled;
        chosen = question_->chosen;
    }
    // Takes what was spent from the budget of the question.
    ~SearchEffort() {
        if (question_ != nullptr) question_->spend(spent);
    }
    // The outcome of a search that has not settled: the budget is spent, or the share of the search was too small.
    [[nodiscard]] Outcome outcome() const {
        const bool all = question_ == nullptr || spent >= question_->left() || is_cancelled();
        return exhausted() && all ? Outcome::budget_spent : Outcome::not_converged;
    }
    SearchEffort(const SearchEffort&) = delete;
    SearchEffort& operator=(const SearchEffort&) = delete;

private:
    Effort* question_;
};

} // namespace denhartog
