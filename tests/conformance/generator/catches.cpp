#include <algorithm>
#include <cmath>

#include "conformance/mistakes/mistake.hpp"
#include "tests/conformance/generator/certify.hpp"

namespace denhartog::conformance::generator {
namespace {

// Factor by which a mistaken answer has to exceed the bound of inaccurate ones: mistakes compute in double, whose last digits
// must not decide a verdict.
constexpr double clear_by = 4;

// Least distance of a sample to the true curve within a step on either side: no way to judge a curve is more lenient.
double distance_to_curve(double x, const std::vector<double>& curve, std::size_t n) {
    const std::size_t count = curve.size();
    const auto [low, high] = std::minmax({curve[(n + count - 1) % count], curve[n], curve[(n + 1) % count]});
    return std::max({0.0, low - x, x - high});
}

bool is_wrong(const Vector& v, const Value& given) {
    if (!v.word.empty()) return given.word != v.word;
    if (given.numbers.size() != v.nearest.size()) return true;
    const Quantity& asked = quantity(v.question.quantity);
    double largest = 0;
    for (std::size_t n = 0; n < given.numbers.size(); ++n) {
        double error = std::abs(given.numbers[n] - v.nearest[n]);
        if (asked.angle) error = std::abs(std::remainder(error, 2 * std::acos(-1.0)));
        if (asked.shape == Shape::samples) error = distance_to_curve(given.numbers[n], v.nearest, n);
        largest = std::max(largest, error);
    }
    return largest > clear_by * v.tolerance.inaccurate * v.scale;
}

} // namespace

std::vector<std::string> catches_of(const Vector& v) {
    std::vector<std::string> names;
    for (const Mistake& mistake : mistakes()) {
        const std::optional<Value> given = answer_with_mistake(mistake.name, v.question);
        if (given && is_wrong(v, *given)) names.push_back(mistake.name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace denhartog::conformance::generator
