#include "denhartog/solve/answer.hpp"

#include <algorithm>
#include <atomic>
#include <limits>

#include "denhartog/number/errors.hpp"
#include "denhartog/solve/error_bound.hpp"

namespace denhartog {
namespace {

std::atomic<long> steps{0};

constexpr int most_digits_in_double = 15;
constexpr int most_digits_in_50 = 45;
constexpr std::size_t most_masses_to_step_up = 40;

template <class T>
struct Measured {
    Response<T> response;
    MeasuredError<T> error;
    bool in_this_type_only = false; // the scene keeps its rules in this number type, not in a wider one
};

template <class T, class Wide>
Measured<T> measured(const Scene<T>& scene, const Scene<Wide>& wide_scene, std::optional<Mass> only) {
    Measured<T> m{response(scene, only), {}};
    m.error = measured_error(m.response, response_at(wide_scene, instants_in<Wide>(m.response), only), only);
    set_error(m.response, m.error);
    return m;
}

// A damping matrix rounded to double need not decouple the modes to more digits than those.
template <class Wide>
Measured<double> measured_in_double(const Scene<double>& scene, const std::function<Scene<Wide>()>& wide,
                                    std::optional<Mass> only) {
    try {
        return measured(scene, wide(), only);
    } catch (const InputError& e) {
        if (scene.system.damping_matrix.size() == 0) throw;
    }
    Measured<double> m = measured(scene, converted<Wide>(with_damping_ratios(scene)), only);
    m.in_this_type_only = true;
    return m;
}

Measured<double> in_double(const SceneSource& source, std::optional<Mass> only) {
    const Scene<double> scene = source.in_double();
    return number_of_masses(scene.system) > most_masses_to_step_up ? measured_in_double(scene, source.in_long_double, only)
                                                                   : measured_in_double(scene, source.in_50_digits, only);
}

Measured<Real50> in_50_digits(const SceneSource& source, std::optional<Mass> only) {
    return measured(source.in_50_digits(), source.in_100_digits(), only);
}

// The errors of 50 digits, scaled to those of 100.
MeasuredError<Real100> scaled(const MeasuredError<Real50>& narrow) {
    const Real100 ratio = 16 * std::numeric_limits<Real100>::epsilon() / Real100(std::numeric_limits<Real50>::epsilon());
    const Real100 factor = narrow.comparable ? ratio : Real100(1);
    MeasuredError<Real100> error;
    error.comparable = narrow.comparable;
    error.relative = factor * Real100(narrow.relative);
    error.boundary = {Real100(factor * Real100(narrow.boundary.exact)), Real100(factor * Real100(narrow.boundary.sticking))};
    for (const Real50& mass : narrow.masses) error.masses.push_back(Real100(factor * Real100(mass)));
    return error;
}

// What a frequency ratio a few units off in its last place changes.
MeasuredError<Real100> sensitivity(Scene<Real100> scene, const Response<Real100>& response, int units, std::optional<Mass> only) {
    *scene.r *= 1 + units * std::numeric_limits<Real100>::epsilon();
    return measured_error(response, response_at(scene, response, only), only);
}

void take_larger(MeasuredError<Real100>& error, const MeasuredError<Real100>& other) {
    error.comparable = error.comparable && other.comparable;
    error.relative = std::max(error.relative, other.relative);
    error.boundary = {std::max(error.boundary.exact, other.boundary.exact),
                      std::max(error.boundary.sticking, other.boundary.sticking)};
    error.masses.resize(std::max(error.masses.size(), other.masses.size()), Real100(0));
    for (std::size_t k = 0; k < other.masses.size(); ++k) error.masses[k] = std::max(error.masses[k], other.masses[k]);
}

Measured<Real100> in_100_digits(const SceneSource& source, std::optional<Mass> only) {
    const Scene<Real100> scene = source.in_100_digits();
    Measured<Real100> m{response(scene, only), scaled(in_50_digits(source, only).error)};
    for (const int units : {-8, 8}) take_larger(m.error, sensitivity(scene, m.response, units, only));
    set_error(m.response, m.error);
    return m;
}

template <class T>
bool reached(const Measured<T>& m, int digits) {
    using std::pow;
    return m.error.relative <= pow(T(10), -digits);
}

template <class T>
bool decided(const Measured<T>& m) {
    return !m.response.regime || !m.response.regime->on_boundary;
}

template <class T>
bool settled(const Measured<T>& m, int digits) {
    return reached(m, digits) && decided(m);
}

template <class T>
std::string verdict(const Measured<T>& m, int digits, const std::string& aim) {
    return (reached(m, digits) ? "it has the " : "it has not the ") + aim + (decided(m) ? "" : ", but beta lies on a boundary");
}

std::string in_words(int digits) { return std::to_string(digits) + (digits == 1 ? " digit" : " digits"); }

std::string checked_in(bool large, bool in_double_only) {
    return std::string("checked in ") + (large ? "long double" : "50 digits") +
           (in_double_only
                ? " with the damping ratios that the damping matrix has in double, because it decouples the modes to no "
                  "more digits"
                : "") +
           ": ";
}

template <class T>
Answer answered(const Measured<T>& m, const std::string& precision, const std::string& why, bool digits_reached) {
    const bool slides = m.response.steady_state.has_value();
    return {m.response,
            {slides ? "closed form" : "boundary of the sliding regime", precision, why},
            digits_reached,
            static_cast<double>(m.error.relative)};
}

} // namespace

Answer answer(const SceneSource& source, std::optional<int> digits, std::optional<Mass> only) {
    if (digits && (*digits < 1 || *digits > most_digits))
        throw InputError("digits", "must be from 1 to " + std::to_string(most_digits), std::to_string(*digits));
    const int wanted = digits.value_or(digits_by_default);
    const std::string aim = in_words(wanted) + (digits ? " asked for" : " aimed at");
    const bool large = number_of_masses(source.in_double().system) > most_masses_to_step_up;
    const bool stays = large && !digits;
    std::string before; // what the narrower precisions left open
    if (wanted <= most_digits_in_double) {
        try {
            const Measured<double> m = in_double(source, only);
            if (settled(m, wanted) || stays || (m.in_this_type_only && !digits))
                return answered(m, "double", checked_in(large, m.in_this_type_only) + verdict(m, wanted, aim),
                                reached(m, wanted));
            before = "in double: " + verdict(m, wanted, aim) + "; ";
        } catch (const DomainError& e) {
            if (stays) throw;
            before = std::string("in double: ") + e.what() + "; ";
        } catch (const PrecisionError& e) {
            if (stays) throw;
            before = std::string("in double: ") + e.what() + "; ";
        }
        count_precision_step();
    }
    if (wanted <= most_digits_in_50) {
        try {
            const Measured<Real50> m = in_50_digits(source, only);
            if (settled(m, wanted))
                return answered(m, "50 digits", before + "checked in 100 digits: " + verdict(m, wanted, aim), true);
            before += "in 50 digits: " + verdict(m, wanted, aim) + "; ";
        } catch (const DomainError& e) {
            before += std::string("in 50 digits: ") + e.what() + "; ";
        } catch (const PrecisionError& e) {
            before += std::string("in 50 digits: ") + e.what() + "; ";
        }
        count_precision_step();
    }
    const Measured<Real100> m = in_100_digits(source, only);
    return answered(m, "100 digits", before + "measured in 50 digits and scaled: " + verdict(m, wanted, aim), reached(m, wanted));
}

long precision_steps() { return steps; }

void count_precision_step() { ++steps; }

} // namespace denhartog
