/// @file
/// @brief What the tests of the reference hold numbers against.
#pragma once

#include <cmath>
#include <string>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/number/ball.hpp"
#include "denhartog/number/certified.hpp"
#include "denhartog/reference/modes.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::tests {

/// @brief A proved number as a ball. @param x a number of an answer @return all that it may be
[[nodiscard]] inline Ball ball_of(const Certified& x) {
    return widened(x.decimal.empty() ? Ball(x.value) : Ball::of_text(x.decimal), Ball(x.error));
}

/// @brief A number of 100 digits, exact. @param x the number @return it
[[nodiscard]] inline Ball ball_of(const Real100& x) {
    Ball exact;
    arf_set_mpfr(arb_midref(exact.a), x.backend().data());
    return exact;
}

/// @brief How far apart two numbers are at least. @param x a number @param y a number @return a lower bound of the distance
[[nodiscard]] inline double apart(const Ball& x, const Ball& y) { return std::max(0.0, abs(x - y).low()); }

/// @brief The same of angles. @param x radians @param y radians @param period what makes no difference @return the same
[[nodiscard]] inline double apart(const Ball& x, const Ball& y, const Ball& period) {
    const double turns = std::round(static_cast<double>((x - y) / period));
    return apart(x, y + period * Ball(turns));
}

/// @brief Whether a ball of 320 bits agrees with 100 digits, rounding in both left aside, and is narrow.
[[nodiscard]] inline bool holds(const Ball& x, const Real100& truth, double size = 1) {
    return apart(x, ball_of(truth)) <= 1e-60 * size && x.radius() < 1e-50 * size;
}

/// @brief The matrices of a scene. @param text JSON @return them in the bits of the moment
[[nodiscard]] inline reference::SceneInBalls matrices_of_text(const std::string& text) {
    Scene<Ball> scene;
    scene_source(SceneText{text})->in_balls(scene);
    return reference::in_matrices(scene);
}

/// @brief The same of a scene in double, each number exact. @param scene with r @return its matrices
[[nodiscard]] inline reference::SceneInBalls matrices_of(const Scene<double>& scene) {
    Scene<Ball> in_balls;
    scene_source(scene)->in_balls(in_balls);
    return reference::in_matrices(in_balls);
}

/// @brief A ball as text, for messages. @param x the ball @return its digits and radius
[[nodiscard]] inline std::string in_words(const Ball& x) {
    char* text = arb_get_str(x.a, 30, 0);
    std::string all = text;
    flint_free(text);
    return all;
}

} // namespace denhartog::tests
