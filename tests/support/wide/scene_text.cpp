// Numbers and scenes as text in 50 and 100 digits.
#include <nlohmann/json.hpp>

#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog {
namespace {

template <class T>
NumberFault read(std::string_view text, T& value) {
    double narrow = 0;
    const NumberFault fault = number_from_text(text, narrow);
    if (fault == NumberFault::no_number || fault == NumberFault::too_long) return fault;
    value = T(std::string(text));
    return NumberFault::none;
}

} // namespace

template <>
std::string number_to_text(const Real50& x) {
    return x.str(std::numeric_limits<Real50>::max_digits10);
}
template <>
std::string number_to_text(const Real100& x) {
    return x.str(std::numeric_limits<Real100>::max_digits10);
}
template <>
NumberFault number_from_text(std::string_view text, Real50& value) {
    return read(text, value);
}
template <>
NumberFault number_from_text(std::string_view text, Real100& value) {
    return read(text, value);
}
template <>
Scene<Real50> read_scene(std::string_view text) {
    return scene_from_json<Real50>(read_json(text));
}
template <>
Scene<Real100> read_scene(std::string_view text) {
    return scene_from_json<Real100>(read_json(text));
}

} // namespace denhartog
