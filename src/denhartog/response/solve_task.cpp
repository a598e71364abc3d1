#include "denhartog/response/solve_task.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/errors.hpp"
#include "denhartog/response/held_solution.hpp"

namespace denhartog {
namespace {

std::string in_words(int digits) { return std::to_string(digits) + (digits == 1 ? " digit" : " digits"); }

template <class To, class From>
Boundary<To> converted(const Boundary<From>& b) {
    if constexpr (std::is_same_v<To, From>) {
        return b;
    } else {
        Boundary<To> out{};
        out.exact = To(b.exact);
        out.paper = To(b.paper);
        out.approximate = To(b.approximate);
        if (b.sticking) out.sticking = To(*b.sticking);
        out.binding = b.binding;
        return out;
    }
}

// Regime by (69) with (56).
template <class T>
Regime regime_by_56(Boundary<T> b, const T& beta) {
    b.exact = b.paper;
    return regime_of(b, beta);
}

} // namespace

SolveTask solve_task(const SceneSource& source, const Question& question) {
    const int wanted = question.digits.value_or(digits_by_default);
    if (wanted < 1 || wanted > most_digits)
        throw InputError("digits", "must be from 1 to " + std::to_string(most_digits), std::to_string(wanted));
    const Scene<double> scene = source.in_double();
    check(scene);
    if (!scene.r) throw InputError("r", "must be given", "nothing");
    if (!scene.beta) throw InputError("beta", "must be given", "nothing");
    SolveTask task{source,
                   question,
                   scene,
                   modal_basis(scene.system),
                   wanted,
                   in_words(wanted) + (question.digits ? " asked for" : " aimed at"),
                   std::pow(10.0, -wanted)};
    if (!scene.system.damping_ratios.empty()) task.modes.emplace(scene, task.basis);
    return task;
}

template <>
Scene<double> scene_in(const SolveTask& task) {
    return task.scene;
}

template <>
Scene<Real50> scene_in(const SolveTask& task) {
    return task.source.in_50_digits();
}

template <>
Scene<Real100> scene_in(const SolveTask& task) {
    return task.source.in_100_digits();
}

template <>
std::string precision_of<double>() {
    return "double";
}

template <>
std::string precision_of<Real50>() {
    return "50 digits";
}

template <>
std::string precision_of<Real100>() {
    return "100 digits";
}

int digits_of(double error) {
    return error > 0 ? std::clamp(static_cast<int>(std::floor(-std::log10(error))), 0, most_digits) : most_digits;
}

template <class T>
Solved<T> numbers_with_boundary(const SolveTask& task, Solution& s) {
    const Scene<T> scene = scene_in<T>(task);
    Solved<T> numbers{*scene.r, *scene.beta, scene.system.contact};
    if (task.pole) return numbers;
    std::visit(
        [&](const auto& response) {
            numbers.boundary = converted<T>(response.boundary);
            const Regime by_56 = regime_by_56(response.boundary, *response.beta);
            if (by_56 != regime_of(response.boundary, *response.beta)) s.regime_by_56 = by_56;
        },
        task.found.response);
    if (task.question.asked == Asked::regime) numbers.sticking_by_88 = sticking_by_88(scene);
    return numbers;
}

template Solved<double> numbers_with_boundary(const SolveTask&, Solution&);
template Solved<Real50> numbers_with_boundary(const SolveTask&, Solution&);
template Solved<Real100> numbers_with_boundary(const SolveTask&, Solution&);

} // namespace denhartog
