/// @file
/// @brief Exceptions become codes: what every function of the C interface runs in.
#pragma once

#include <cmath>
#include <cstdio>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "denhartog/c/denhartog.h"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog::c_interface {

/// @brief A pointer that is needed is null, or a size is not what it must be.
struct CallError : std::invalid_argument {
    /// @param status_  DH_ERROR_NULL or DH_ERROR_SIZE
    /// @param text     what is wrong
    CallError(dh_status status_, const std::string& text) : std::invalid_argument(text), status(status_) {}
    dh_status status; ///< what the function returns
};

/// @brief The longest message, with its ending zero; longer ones are cut.
inline constexpr std::size_t message_size = 1300;

/// @brief Where the text of the calling thread's last fault stands. @return its bytes
inline char* message() noexcept {
    static thread_local char text[message_size] = "";
    return text;
}

/// @brief Keeps the text of a fault. @param status what is returned @param text what is wrong @return the status
inline int fault(dh_status status, const char* text) noexcept {
    std::snprintf(message(), message_size, "%s", text);
    return status;
}

/// @brief What the questions of a thread may cost, as dh_set_effort() was told.
struct Allowance {
    std::optional<long> operations;   ///< none for the default
    dh_cancelled cancelled = nullptr; ///< null where nobody cancels
    void* context = nullptr;          ///< what it is called with
};

/// @brief That of the calling thread. @return it, to be read or set
inline Allowance& allowance() noexcept {
    static thread_local Allowance of_thread;
    return of_thread;
}

/// @brief Runs the body of a function that asks many questions, each with an effort of its own.
/// @param body  called once
/// @return      DH_OK, or the code of what it threw, whose text is kept
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

/// @brief Runs the body of a function, within the effort that the calling thread allows.
/// @param body  called once
/// @return      DH_OK, or the code of what it threw, whose text is kept
template <class Body>
int guarded(Body&& body) noexcept {
    return guarded_without_effort([&body] {
        const Allowance& allowed = allowance();
        std::optional<QuestionEffort> effort;
        if (allowed.cancelled != nullptr)
            effort.emplace(0, allowed.operations, [&allowed] { return allowed.cancelled(allowed.context) != 0; });
        else if (allowed.operations)
            effort.emplace(0, allowed.operations);
        body();
    });
}

/// @brief Checks a pointer. @param pointer it @param name its name in the header @throws CallError where it is null
inline void need(const void* pointer, const char* name) {
    if (pointer == nullptr) throw CallError(DH_ERROR_NULL, std::string(name) + " must not be null");
}

/// @brief Checks the length of an array. @param count as given @param right as it must be @throws CallError where they differ
inline void need_count(std::size_t count, std::size_t right) {
    if (count == right) return;
    throw CallError(DH_ERROR_SIZE, "count must be " + std::to_string(right) + ", but is " + std::to_string(count));
}

/// @brief Checks a length against a limit. @param length as given @param most the limit @param name what the header calls it
/// @throws CallError where it is 0 or beyond the limit
inline void need_length(std::size_t length, std::size_t most, const std::string& name) {
    if (length >= 1 && length <= most) return;
    throw CallError(DH_ERROR_SIZE, name + " must be from 1 to " + std::to_string(most) + ", but is " + std::to_string(length));
}

/// @brief Checks that numbers are fit to be handed out. @param numbers they @throws PrecisionError where one is not finite
inline void need_finite(std::span<const double> numbers) {
    for (const double x : numbers)
        if (!std::isfinite(x)) throw PrecisionError("a result is beyond the range of double");
}

/// @brief An array of the caller.
struct Output {
    double* numbers;  ///< where it is
    const char* name; ///< what the header calls it
};

/// @brief Hands out numbers, all of them finite. @param numbers they @param output an array as long, or null
inline void hand_out(std::span<const double> numbers, double* output) noexcept {
    for (std::size_t i = 0; output != nullptr && i < numbers.size(); ++i) output[i] = numbers[i];
}

} // namespace denhartog::c_interface
