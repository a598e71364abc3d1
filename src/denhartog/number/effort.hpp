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
// them, about a tenth of a microsecond. A search that finds its budget spent ends and gives what is certain until then.
struct Effort {
    long allowed = std::numeric_limits<long>::max();  // operations allowed
    long spent = 0;                                   // operations spent
    const std::function<bool()>* cancelled = nullptr; // ends the search from outside once it gives true; null: nobody does

    void spend(long operations) { spent += operations; }
    // Operations still allowed, not negative.
    [[nodiscard]] long left() const { return std::max(0L, allowed - spent); }
    // Whether a search has to end: the budget is spent, or somebody cancelled.
    [[nodiscard]] bool exhausted() const { return spent >= allowed || is_cancelled(); }
    [[nodiscard]] bool is_cancelled() const { return cancelled != nullptr && (*cancelled)(); }
    // Why a search ended that has exhausted it.
    [[nodiscard]] Reasons ending() const {
        return is_cancelled() ? Reasons(Why::cancelled) : Reasons(Why::effort_spent, spent);
    }
};

// Operations that products of matrices cost, by the multiplications in them: many are done at a time.
[[nodiscard]] constexpr long cost_of_products(long multiplications) { return multiplications / 512; }

// The budget of a question if none is asked for: about two seconds for twelve modes and fewer, half a minute for a hundred. Up
// to there it grows as products of matrices do that a motion with stops takes.
[[nodiscard]] constexpr long default_effort(std::size_t modes) {
    const auto N = static_cast<long>(std::max<std::size_t>(modes, 12)), of_modes = 10'000'000 / 12 * N;
    return std::max(of_modes, std::min(of_modes * (8 + N) / 20, 450'000'000L)) + 4 * (N * N * N - 12 * 12 * 12);
}

// The budget of all that this thread does for one question, until the end of the scope. Scopes may be nested: the
// outermost one counts.
class QuestionEffort {
public:
    // The budget is that of the modes if the user chose none; `cancelled` is asked now and then, and ends the question.
    explicit QuestionEffort(std::size_t modes, std::optional<long> chosen = {}, std::function<bool()> cancelled = {})
        : cancelled_(std::move(cancelled)), chosen_(chosen.has_value()), outermost_(current() == nullptr) {
        effort_.allowed = chosen.value_or(default_effort(modes));
        if (cancelled_) effort_.cancelled = &cancelled_;
        if (outermost_)
            current() = this;
        else if (!current()->chosen_)
            current()->effort_.allowed = std::max(current()->effort_.allowed, effort_.allowed);
    }
    ~QuestionEffort() {
        if (outermost_) current() = nullptr;
    }
    QuestionEffort(const QuestionEffort&) = delete;
    QuestionEffort& operator=(const QuestionEffort&) = delete;

    // The effort spent so far, if this is the outermost scope.
    [[nodiscard]] long spent() const { return effort_.spent; }
    // Whether the question of this thread has spent its budget, or was cancelled.
    [[nodiscard]] static bool exhausted() { return current() != nullptr && current()->effort_.exhausted(); }

    // Spends of the budget of the question of this thread, if there is one. Throws PrecisionError if nothing is left of it.
    static void pay(long operations) {
        if (current() == nullptr) return;
        current()->effort_.spend(operations);
        if (current()->effort_.exhausted()) throw PrecisionError(current()->effort_.ending());
    }

    // Spends half of what products of matrices cost of that budget.
    static void pay_for_products(long multiplications) { pay(cost_of_products(multiplications) / 2); }

private:
    friend class SearchEffort;

    static QuestionEffort*& current() {
        thread_local QuestionEffort* question = nullptr;
        return question;
    }

    Effort effort_;
    std::function<bool()> cancelled_;
    bool chosen_;    // by the user
    bool outermost_; // and so the one that counts
};

// The effort that one search may spend: a share of the budget of its question, from which it is taken at the end of the scope.
class SearchEffort : public Effort {
public:
    // share: operations, if the user has not chosen the budget of the question
    explicit SearchEffort(long share) : question_(QuestionEffort::current()) {
        allowed = share;
        if (question_ == nullptr) return;
        const Effort& whole = question_->effort_;
        allowed = question_->chosen_ ? whole.left() : std::min(share, whole.left());
        cancelled = whole.cancelled;
    }
    // Takes what was spent from the budget of the question.
    ~SearchEffort() {
        if (question_ != nullptr) question_->effort_.spend(spent);
    }
    SearchEffort(const SearchEffort&) = delete;
    SearchEffort& operator=(const SearchEffort&) = delete;

private:
    QuestionEffort* question_;
};

} // namespace denhartog
