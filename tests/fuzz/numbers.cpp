// Numbers as text: what is read agrees with the C library, and what is written is read again as the same number.
#include <cmath>
#include <cstring>
#include <limits>

#include "denhartog/number/number_text.hpp"
#include "tests/fuzz/claims.hpp"

using namespace denhartog;

namespace {

NumberFault read_and_written(std::string_view text, double& value) {
    constexpr int untouched = -12345;
    value = untouched;
    const NumberFault fault = number_from_text(text, value);
    fuzz::claim_message(number_rule(fault));
    if (fault != NumberFault::none) {
        fuzz::claim(value == untouched, "a fault leaves the value as it was", text);
        return fault;
    }
    fuzz::claim(std::isfinite(value), "a number is finite", text);
    const std::string written = number_to_text(value);
    double again = untouched;
    fuzz::claim(number_from_text(written, again) == NumberFault::none && again == value, "a number is the same again", written);
    return fault;
}

// The C library reads every text that the library reads, and reads the same.
void check_against_c(std::string_view text, NumberFault fault, double x) {
    if (fault == NumberFault::no_number || fault == NumberFault::too_long) return;
    const std::string copy(text);
    char* end = nullptr;
    const double of_c = std::strtod(copy.c_str(), &end);
    fuzz::claim(end == copy.c_str() + copy.size(), "a number is one to C", text);
    if (fault == NumberFault::none) fuzz::claim(of_c == x && std::signbit(of_c) == std::signbit(x), "C reads the same", text);
    if (fault == NumberFault::too_large) fuzz::claim(std::isinf(of_c), "what is too large is infinite to C", text);
    if (fault == NumberFault::too_small) fuzz::claim(of_c == 0, "what is too small is zero to C", text);
}

void check_bits(double x) {
    const std::string text = number_to_text(x);
    fuzz::claim_message(text);
    double again = 0;
    const NumberFault fault = number_from_text(text, again);
    fuzz::claim((fault == NumberFault::none) == std::isfinite(x), "a number is read where it is finite", text);
    if (!std::isfinite(x)) return;
    fuzz::claim(again == x && std::signbit(again) == std::signbit(x), "a double is the same again", text);
    fuzz::claim(std::strtod(text.c_str(), nullptr) == x, "C reads what is written", text);
}

void check_legible(std::string_view text) {
    for (const std::size_t most : {std::size_t(8), std::size_t(43), most_shown}) {
        const std::string shown = legible(text, most);
        fuzz::claim(shown.size() <= most, "what is shown is no longer than allowed", shown);
        fuzz::claim(legible(shown, most) == shown, "a legible text stays as it is", shown);
        for (const char c : shown)
            fuzz::claim(static_cast<unsigned char>(c) >= ' ' && c != '\x7F', "no control character", shown);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    double x = 0;
    const NumberFault fault = read_and_written(text, x);
    check_against_c(text, fault, x);
    check_legible(text);
    if (size >= sizeof x) {
        std::memcpy(&x, data, sizeof x);
        check_bits(x);
    }
    return 0;
}
