// The text of a refused input, "QUANTITY RULE, but is VALUE (at PLACE)", with text from outside made legible; and words for
// exceptions that are not the library's.
#include "denhartog/number/errors.hpp"

#include <new>
#include <system_error>

#include "denhartog/number/legible.hpp"

namespace denhartog {
namespace {

constexpr std::size_t most_of_a_rule = 600; // the reason of an answer that fails in 100 digits is long

// A key of a file may be empty.
std::string named(const std::string& quantity) { return quantity.empty() ? "\"\"" : legible(quantity); }

std::string message_of(const std::string& quantity, const std::string& rule, const std::string& value, const std::string& place) {
    return named(quantity) + " " + legible(rule, most_of_a_rule) + (value.empty() ? "" : ", but is " + legible(value)) +
           (place.empty() ? "" : " (at " + legible(place) + ")");
}

template <class... Errors>
bool is_one_of(const std::exception& fault) noexcept {
    return (... || (dynamic_cast<const Errors*>(&fault) != nullptr));
}

} // namespace

InputError::InputError(const std::string& quantity_, const std::string& rule_, const std::string& value_,
                       const std::string& place_)
    : std::invalid_argument(message_of(quantity_, rule_, value_, place_)), quantity(named(quantity_)),
      rule(legible(rule_, most_of_a_rule)), value(legible(value_)), place(legible(place_)) {}

bool is_beyond_range(const std::exception& fault) noexcept {
    return is_one_of<std::overflow_error, std::underflow_error, std::range_error>(fault);
}

const char* in_own_words(const std::exception& fault) noexcept {
    if (is_one_of<InputError, DomainError, PrecisionError>(fault)) return fault.what();
    if (is_one_of<std::bad_alloc, std::length_error>(fault))
        return "memory must hold the scene and what is asked of it, but is short: ask for fewer masses, samples or points";
    if (is_beyond_range(fault))
        return "the numbers of the computation must be within the range of their type, but are beyond it, as exp(pi zeta_i / R_i)"
               " is where r is too small or a damping ratio too large for the natural frequencies";
    if (is_one_of<std::system_error>(fault))
        return "the system must grant what the computation needs (files, threads, memory), but has refused it";
    return "the computation must end with an answer or a reason, but has met a fault of its own: this is a defect of the library";
}

} // namespace denhartog
