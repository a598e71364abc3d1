#include <algorithm>

#include "denhartog/number/errors.hpp"
#include "denhartog/solve/few_modes.hpp"
#include "denhartog/solve/solve_task.hpp"

namespace denhartog {
namespace {

constexpr int most_digits_bounded = 13;         // beyond, bounds known beforehand are too wide
constexpr int most_digits_bounded_sharply = 14; // the same with the modes of long double
constexpr int most_digits_few_modes = 8;        // beyond, harmonics and static modes are too coarse
constexpr std::size_t most_masses_sharp = 40;   // beyond, the eigen-solve in long double costs more than it may save

template <class T>
void write_closed_form(const SolveTask& task, const Response<T>& response, Solution& s) {
    Solved<T> numbers = numbers_with_boundary<T>(task, s);
    const std::vector<MassResponse<T>>& masses = response.steady_state->masses;
    for (std::size_t k = 0; k < masses.size(); ++k) {
        const MassResponse<T>& m = masses[k];
        const bool moves = m.amplitude > m.error_bound;
        const T of_phase = k < task.phase_error.size() ? T(task.phase_error[k]) : T(task.found.relative_error);
        numbers.masses.push_back({m.amplitude, moves ? std::optional<T>(m.phase) : std::nullopt, m.error_bound, of_phase,
                                  task.question.asked == Asked::motion ? std::optional(m) : std::nullopt});
    }
    s.numbers = std::move(numbers);
    s.method = task.found.method;
    s.relative_error = task.found.relative_error;
}

bool take_bounded(SolveTask& task, BoundedModes& modes, const std::string& before) {
    try {
        const bool with_motion = task.question.asked != Asked::regime || task.scene.mu > 1;
        const BoundedResponse bounded = bounded_response(task.scene, modes, with_motion, task.question.mass);
        if (!(bounded.relative <= task.tolerance) || bounded.response.regime->on_boundary) return false;
        task.phase_error = bounded.phase_error;
        const bool slides = bounded.response.steady_state.has_value();
        task.found = {bounded.response,
                      {slides ? "closed form" : "boundary of the sliding regime", "double",
                       before + "the error bound known beforehand leaves the " + task.aim},
                      true,
                      bounded.relative};
        return true;
    } catch (const DomainError&) {
        return false;
    } catch (const PrecisionError&) {
        return false;
    }
}

} // namespace

bool answer_by_few_modes(SolveTask& task, Solution& s) {
    if (task.wanted > most_digits_few_modes || !task.modes) return false;
    std::optional<FewModesSolution> few;
    try {
        few = few_modes_solution(task.scene, *task.modes, task.wanted, task.question.asked == Asked::phase, task.question.mass);
    } catch (const DomainError&) {
        return false; // the next rung says where the pole is
    }
    if (!few) return false;
    const std::size_t N = task.basis.r_n.size();
    Solved<double> numbers{*task.scene.r, *task.scene.beta, task.scene.system.contact};
    numbers.slides_below = few->slides_below;
    numbers.masses = std::move(few->masses);
    s.numbers = std::move(numbers);
    s.regime = {Regime::continuous, {}, false, certainly_slides};
    std::string why = "the bound of rounding and of what is left out, known beforehand, leaves the " + task.aim;
    if (few->modes < N)
        why = std::to_string(few->modes) + " of " + std::to_string(N) + " modes, the others by their static displacement; " + why;
    s.method = {N == 1 ? "closed form" : "closed form, first harmonic of the masses not in contact", "double", why};
    s.relative_error = few->relative;
    return true;
}

void find_boundary(SolveTask& task) {
    if (task.modes && task.wanted <= most_digits_bounded) {
        if (take_bounded(task, *task.modes, "")) return;
        count_precision_step();
    }
    if (task.modes && task.wanted <= most_digits_bounded_sharply && task.basis.r_n.size() <= most_masses_sharp) {
        BoundedModes sharp(sharp_basis(task.scene.system, Inputs::rounded), as_input(*task.scene.r));
        if (take_bounded(task, sharp, "with the modes of long double; ")) return;
        count_precision_step();
    }
    try {
        task.found = answer(task.source, task.question.digits, task.question.mass);
    } catch (const DomainError& e) {
        task.pole = e.what();
    }
}

void answer_by_closed_form(const SolveTask& task, Solution& s) {
    std::visit([&](const auto& response) { write_closed_form(task, response, s); }, task.found.response);
}

void answer_by_boundaries(const SolveTask& task, const std::string& model, const std::string& why, Solution& s) {
    std::visit([&]<class T>(const Response<T>&) { s.numbers = numbers_with_boundary<T>(task, s); }, task.found.response);
    s.method = {model, task.found.method.precision, why + task.found.method.why};
    s.relative_error = task.found.relative_error;
}

} // namespace denhartog
