#include "denhartog/solve/solve_task.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/number/errors.hpp"
#include "denhartog/solve/held_solution.hpp"

namespace denhartog {
namespace {

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

template <>
PointIn<double> point_in(const SolvePoint& at) {
    return {at.r, at.beta};
}

template <>
PointIn<long double> point_in(const SolvePoint& at) {
    if (!at.source) return {at.r, at.beta};
    const Scene<long double> scene = at.source->in_long_double();
    return {*scene.r, *scene.beta};
}

template <>
PointIn<Real50> point_in(const SolvePoint& at) {
    if (!at.source) return {Real50(at.r), Real50(at.beta)};
    const Scene<Real50> scene = at.source->in_50_digits();
    return {*scene.r, *scene.beta};
}

template <>
PointIn<Real100> point_in(const SolvePoint& at) {
    if (!at.source) return {Real100(at.r), Real100(at.beta)};
    const Scene<Real100> scene = at.source->in_100_digits();
    return {*scene.r, *scene.beta};
}

template <>
System<long double> system_in(const PreparedSystem& p) {
    return p.source.in_long_double().system;
}

template <>
System<Real50> system_in(const PreparedSystem& p) {
    return p.source.in_50_digits().system;
}

template <>
System<Real100> system_in(const PreparedSystem& p) {
    return p.source.in_100_digits().system;
}

SolveTask solve_task(const PreparedSystem& p, const SolvePoint& at, const Question& question) {
    const Aim aim = aim_of(question);
    Scene<double> scene = p.scene;
    scene.r = at.r;
    scene.beta = at.beta;
    SolveTask task{at.source ? *at.source : at_point(p.source, at.r, at.beta),
                   question,
                   std::move(scene),
                   p.basis ? *p.basis : modal_basis(p.scene.system),
                   aim.digits,
                   in_words(aim),
                   aim.tolerance};
    task.moving = p.moving;
    task.contact_tried = p.contact && !p.contact->modes.empty() && asks_for_contact(question, p.scene.system.contact);
    if (p.bounded)
        task.modes.emplace(p.bounded, as_input(at.r));
    else if (!p.scene.system.damping_ratios.empty())
        task.modes.emplace(task.scene, task.basis);
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
