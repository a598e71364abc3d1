#include "conformance/plain/closed_form.hpp"

#include <algorithm>

#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/solve/sampled_solution.hpp"
#include "denhartog/solve/solve.hpp"
#include "denhartog/sums/bounded_modes.hpp"
#include "denhartog/sums/coupled_sums.hpp"

namespace denhartog::conformance {
namespace {

constexpr int digits_asked = 11;

// What friction does not change, and the motion while the contact slides.
class Sliding {
public:
    explicit Sliding(const ProtocolQuestion& q)
        : scene_(scene_of(q)), row_(row_of(q)), sums_(sums_of(scene_)), limits_(boundary(sums_, scene_.mu)) {}

    std::vector<double> numbers(const ProtocolQuestion& q) const {
        const std::string& name = q.quantity;
        if (name == "complex_response") return {sums_.V[row_].re, sums_.V[row_].im};
        if (name == "first_damping_function") return {sums_.U[row_]};
        if (name == "second_damping_function") return {sums_.G[row_]};
        if (name == "H_j") return {sums_.H_j};
        if (name == "S_j") return {limits_.S_exact};
        if (name == "beta_lim_exact") return {limits_.exact};
        if (name == "beta_lim_sticking") return limits_.sticking ? std::vector{*limits_.sticking} : std::vector<double>();
        const SteadyState<double> state = steady_state(sums_, limits_, *scene_.beta);
        const MassResponse<double>& m = state.masses[row_];
        if (name == "amplitude_monoharmonic") return {m.amplitude_monoharmonic};
        if (name == "phase_monoharmonic") return {m.phase_monoharmonic};
        if (name == "initial_displacement") return {m.x0};
        if (name == "initial_velocity") return {m.v0};
        return {motion(sums_, state, q.tau).x[row_]};
    }

private:
    Scene<double> scene_;
    std::size_t row_;
    ModeSums<double> sums_;
    Boundary<double> limits_;

    std::size_t row_of(const ProtocolQuestion& q) const {
        return q.mass == 0 ? contact_row(scene_.system).index : static_cast<std::size_t>(q.mass - 1);
    }

    static ModeSums<double> sums_of(const Scene<double>& scene) {
        const System<double>& s = scene.system;
        const ModalBasis<double> basis = modal_basis(s);
        if (basis.coupled()) return values_of(coupled_sums(s, as_input(*scene.r)));
        return mode_sums(basis, contact_row(s), load_row(s), *scene.r);
    }
};

// Displacements of the mass asked about, or of the contact, at the instants of the question.
std::vector<double> samples_of(const ProtocolQuestion& q, const Scene<double>& scene, const Solution& solution) {
    std::vector<double> x;
    for (const State& state : sampled_solution(scene_source(scene), solution, static_cast<std::size_t>(q.samples)).states) {
        const auto of = [&](int mass) { return state.x[static_cast<std::size_t>(mass - 1)]; };
        x.push_back(q.mass == 0 ? of(q.contact) - of(q.contact_with) : of(q.mass));
    }
    return x;
}

// The motion of a question's system. Questions about one system come one after the other: the motion of the last one is kept.
const Solution& motion_of(const ProtocolQuestion& q, const Scene<double>& scene) {
    thread_local std::string kept_for;
    thread_local std::optional<Solution> kept;
    ProtocolQuestion of_system = q;
    of_system.id = of_system.quantity = "any";
    of_system.mass = of_system.samples = 0;
    of_system.tau = 0;
    const std::string system = question_plain(of_system);
    if (!kept || system != kept_for) {
        kept = solve(scene_source(scene), {Asked::motion, digits_asked, false});
        kept_for = system;
    }
    return *kept;
}

// The steady motion in any regime.
std::optional<Value> of_motion(const ProtocolQuestion& q) {
    const Scene<double> scene = scene_of(q);
    const std::string& name = q.quantity;
    if (name == "regime") {
        const Regime regime = solve(scene_source(scene), {Asked::regime, digits_asked, false}).regime.regime;
        return Value{{}, std::string(denhartog::name(regime))};
    }
    const Solution& solution = motion_of(q, scene);
    if (solution.periods != 1) return std::nullopt;
    if (name == "rest_interval")
        return solution.rest_interval ? std::optional(Value{{solution.rest_interval->to.value}, ""}) : std::nullopt;
    if (name == "motion_under_force") return Value{samples_of(q, scene, solution), ""};
    if (name == "stops_per_period") return Value{{static_cast<double>(solution.stops.size())}, ""};
    if (name == "stop_durations") {
        Value lengths;
        for (const SolvedStop& stop : solution.stops) lengths.numbers.push_back(stop.end.value - stop.start.value);
        std::sort(lengths.numbers.begin(), lengths.numbers.end());
        return lengths;
    }
    const SolvedMass& m = q.mass == 0 ? solution.between.value() : mass_of(solution, Mass{static_cast<std::size_t>(q.mass - 1)});
    if (name == "amplitude") return Value{{m.amplitude.value}, ""};
    return m.phase ? std::optional(Value{{m.phase->value}, ""}) : std::nullopt;
}

} // namespace

std::optional<Value> answer_of_system(const ProtocolQuestion& q) {
    if (q.quantity == "natural_frequency_ratios") return Value{modal_basis(scene_of(q).system).r_n, ""};
    if (asks_for(q,
                 {"amplitude", "phase", "regime", "rest_interval", "stops_per_period", "stop_durations", "motion_under_force"}))
        return of_motion(q);
    const bool of_sums = asks_for(q, {"complex_response", "first_damping_function", "second_damping_function", "H_j", "S_j",
                                      "beta_lim_exact", "beta_lim_sticking", "amplitude_monoharmonic", "phase_monoharmonic",
                                      "initial_displacement", "initial_velocity", "displacement"});
    return of_sums ? std::optional(Value{Sliding(q).numbers(q), ""}) : std::nullopt;
}

} // namespace denhartog::conformance
