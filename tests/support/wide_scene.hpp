/// @file
/// @brief Scenes in 50 and in 100 digits, in the paper's form.
#pragma once

#include <string_view>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::tests {

/// @brief A scene from its JSON text: one tenth written as text is one tenth to all digits.
template <class T>
[[nodiscard]] Scene<T> scene_in(std::string_view text) {
    return read_scene<T>(text);
}

/// @brief A scene of the same binary fractions.
template <class T>
[[nodiscard]] Scene<T> scene_in(const Scene<double>& scene) {
    return converted<T>(scene);
}

} // namespace denhartog::tests
