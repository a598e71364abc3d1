// Frame of every function of the C interface, in which exceptions become codes, and contents of its handles.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "denhartog/c/denhartog.h"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/solve/solve.hpp"

// A system prepared for every regime at mu = 1, with its modes. Nothing in it changes.
struct dh_system {
    denhartog::PreparedSystem prepared;                                               // for `solve`
    std::shared_ptr<const denhartog::ModalBasis<denhartog::Bounded<double>>> modes{}; // its modes, their digits certain
};

// An answer with the scene it answers. Nothing in it changes.
struct dh_solution {
    denhartog::SceneSource source; // the scene, with r, beta and mu
    denhartog::Solution solution;  // the answer, the motion asked for
};

namespace denhartog::c_interface {

// A pointer that is needed is null, or a size is not what it must be.
struct CallError : std::invalid_argument {
    CallError(dh_status status_, const std::string& text) : std::invalid_argument(text), status(status_) {}
    dh_status status; // what the function returns
};

// The longest message, with its ending zero; longer ones are cut.
inline constexpr std::size_t message_size = 1300;

// Where the text of the calling thread's last fault stands.
inline char* message() noexcept {
    static thread_local char text[message_size] = "";
    return text;
}

// Keeps the text of a fault, and gives the status.
inline int fault(dh_status status, const char* text) noexcept {
    std::snprintf(message(), message_size, "%s", text);
    return status;
}

// Work that the questions of a thread may cost, set by dh_set_effort().
struct Allowance {
    std::optional<long> operations;   // none for the default
    dh_cancelled cancelled = nullptr; // null where nobody cancels
    void* context = nullptr;          // what it is called with
    Effort* effort = nullptr;         // of the call that runs, where one of the above says something
};

// That of the calling thread, to be read or set.
inline Allowance& allowance() noexcept {
    static thread_local Allowance kept;
    return kept;
}

// Runs the body of a function that asks many questions, each with an effort of its own. Gives DH_OK, or
// the code of what was thrown, whose text is kept.
template <class Body>
int guarded_without_effort(Body&& body) noexcept {
    try {
        body();
        return DH_OK;
    } catch (const CallError& e) {
        return fault(e.status, e.what());
    } catch (const InputError& e) {
        return fault(DH_ERROR_INPUT, e.what());
    } catch (const DomainError& e) {
        return fault(DH_ERROR_DOMAIN, e.what());
    } catch (const PrecisionError& e) {
        return fault(DH_ERROR_PRECISION, e.what());
    } catch (const std::length_error& e) {
        return fault(DH_ERROR_SIZE, in_own_words(e));
    } catch (const std::bad_alloc& e) {
        return fault(DH_ERROR_MEMORY, in_own_words(e));
    } catch (const std::exception& e) {
        return fault(is_beyond_range(e) ? DH_ERROR_PRECISION : DH_ERROR_INTERNAL, in_own_words(e));
    } catch (...) {
        return fault(DH_ERROR_INTERNAL, in_own_words(std::exception()));
    }
}

// Sets the budget of a call while it runs.
class DuringCall {
public:
    DuringCall(Allowance& allowed, Effort* effort) : allowed_(allowed), before_(std::exchange(allowed.effort, effort)) {}
    ~DuringCall() { allowed_.effort = before_; }
    DuringCall(const DuringCall&) = delete;
    DuringCall& operator=(const DuringCall&) = delete;

private:
    Allowance& allowed_;
    Effort* before_;
};

// A scene with the budget of the call that runs; it must not outlive that.
[[nodiscard]] inline SceneSource paid(const SceneSource& source) { return with_effort(source, allowance().effort); }

// Runs the body of a function, within the effort that the calling thread allows.
template <class Body>
int guarded(Body&& body) noexcept {
    return guarded_without_effort([&body] {
        Allowance& allowed = allowance();
        std::optional<QuestionEffort> effort;
        if (allowed.cancelled != nullptr)
            effort.emplace(0, allowed.operations, [&allowed] { return allowed.cancelled(allowed.context) != 0; });
        else if (allowed.operations)
            effort.emplace(0, allowed.operations);
        const DuringCall during(allowed, effort ? &*effort : nullptr);
        body();
    });
}

// Checks of arguments, each with its name in the header: a pointer, the length of an array, a length against a limit.
inline void need(const void* pointer, const char* name) {
    if (pointer == nullptr) throw CallError(DH_ERROR_NULL, std::string(name) + " must not be null");
}

inline void need_count(std::size_t count, std::size_t right) {
    if (count == right) return;
    throw CallError(DH_ERROR_SIZE, "count must be " + std::to_string(right) + ", but is " + std::to_string(count));
}

inline void need_length(std::size_t length, std::size_t most, const std::string& name) {
    if (length >= 1 && length <= most) return;
    throw CallError(DH_ERROR_SIZE, name + " must be from 1 to " + std::to_string(most) + ", but is " + std::to_string(length));
}

// Checks that numbers are fit to be handed out. Throws PrecisionError where one is not finite.
inline void need_finite(std::span<const double> numbers) {
    for (const double x : numbers)
        if (!std::isfinite(x)) throw PrecisionError("a result is beyond the range of double", Outcome::out_of_range);
}

static_assert(DH_MOST_MASSES == most_masses && DH_MOST_SAMPLES == most_samples && DH_MOST_DISPLACEMENTS == most_displacements);

// Digits from C; none for 0. Throws InputError for more than a double has.
[[nodiscard]] inline std::optional<int> digits_from(int digits) {
    if (digits < 0 || digits > most_digits_of_a_double)
        throw InputError("digits", "must be from 0 to " + std::to_string(most_digits_of_a_double), std::to_string(digits));
    return digits > 0 ? std::optional(digits) : std::nullopt;
}

// Significant digits of the sums over modes and of the closed form.
inline constexpr int digits_of_formulas = 10;

[[nodiscard]] inline std::size_t masses_of(const dh_system* system) {
    need(system, "system");
    return number_of_masses(system->prepared.scene().system);
}

// A system at a point, in every number type.
[[nodiscard]] inline SceneSource point_of(const dh_system* system, double r, double beta, double mu) {
    check_frequency_ratio(r);
    check_friction_ratio(beta);
    check_static_friction(mu);
    return at_point(with_static_friction(system->prepared.source, mu), r, beta);
}

// Which part of a number is handed out.
enum class ValueOrError : std::uint8_t { value, error };

// An array that holds numbers, or the bounds of their errors.
inline void need(const void* pointer, ValueOrError part, const std::string& name) {
    need(pointer, (part == ValueOrError::value ? name : name + "_error").c_str());
}

// A number with its bound, which C gets: where there is none, the largest double.
[[nodiscard]] inline Bounded<double> bounded(double x, double error) {
    return {x, std::min(error, std::numeric_limits<double>::max())};
}
[[nodiscard]] inline Bounded<double> bounded(const Certified& x) { return bounded(x.value, x.error); }

[[nodiscard]] inline double part_of(const Bounded<double>& x, ValueOrError part) {
    return part == ValueOrError::value ? x.x : bounded(x.x, x.e).e;
}
[[nodiscard]] inline double part_of(const Certified& x, ValueOrError part) { return part_of(bounded(x), part); }

// Numbers with their bounds, and where the ones or the others go: null for nowhere.
using Numbers = std::vector<Bounded<double>>;
struct Output {
    Numbers numbers;
    double* to;
};

// Hands out that part of all numbers, once each of them is known to be finite.
inline void hand_out(ValueOrError part, const std::vector<Output>& all) {
    std::vector<double> parts;
    for (const Output& each : all)
        for (const Bounded<double>& x : each.numbers) parts.push_back(part_of(x, part));
    need_finite(parts);
    auto from = parts.begin();
    for (const Output& each : all) {
        const auto end = from + std::ssize(each.numbers);
        if (each.to != nullptr) std::copy(from, end, each.to);
        from = end;
    }
}

// Checks the size that a caller has set. Throws CallError where it is too small.
template <class Struct>
void need_struct(const Struct* result, const char* name) {
    need(result, name);
    if (result->size < sizeof(Struct))
        throw CallError(DH_ERROR_SIZE, std::string(name) + "->size must be at least " + std::to_string(sizeof(Struct)) +
                                           ", but is " + std::to_string(result->size));
}

// A struct from a caller that may know of fewer members than it has now: `oldest` bytes at least, and zeros for the rest.
template <class Struct>
[[nodiscard]] Struct grown(const Struct* given, std::size_t oldest, const char* name) {
    need(given, name);
    if (given->size < oldest)
        throw CallError(DH_ERROR_SIZE, std::string(name) + "->size must be at least " + std::to_string(oldest) + ", but is " +
                                           std::to_string(given->size));
    Struct all{};
    std::memcpy(&all, given, std::min(given->size, sizeof(Struct)));
    return all;
}

// Hands out a struct, its size as the caller had it.
template <class Struct>
void hand_out(Struct from, Struct* to) noexcept {
    from.size = to->size;
    *to = from;
}

// Records of which the functions hand out a part. Each throws if the function has the status of a fault.
[[nodiscard]] Numbers shapes_at(const dh_system* system, double r); // psi_ki, mass after mass
[[nodiscard]] Numbers frequency_ratios_at(const dh_system* system, double r);
[[nodiscard]] Quantities<Bounded<double>> sums_at(const dh_system* system, double r);
[[nodiscard]] Limits limits_at(const dh_system* system, double r, double mu);
[[nodiscard]] Bounded<double> limit_at_high_frequency(const dh_system* system, double mu);
[[nodiscard]] SolvedMass sliding_at(const dh_system* system, double r, double beta, double mu, Mass k);
[[nodiscard]] Numbers displacements_at(const dh_system* system, double r, double beta, double mu, Mass k,
                                       std::span<const double> tau);
[[nodiscard]] dh_solution solution_at(const dh_system* system, double r, double beta, double mu, int digits, bool proved);

} // namespace denhartog::c_interface
