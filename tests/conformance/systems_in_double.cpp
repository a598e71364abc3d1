#include "tests/conformance/systems_in_double.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "conformance/question.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/solve/sampled_solution.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/conformance/c_fixtures.hpp"
#include "tests/conformance/generator/route.hpp"

namespace denhartog::tests {
namespace {

using conformance::asks_for;
using conformance::ProtocolQuestion;
using conformance::Value;

constexpr int digits_asked = 11;

std::vector<double> of_sums(const ProtocolQuestion& q) {
    const Scene<double> scene = conformance::scene_of(q);
    const System<double> s = with_load_at(scene.system, *scene.r);
    const ModalBasis<double> basis = modal_basis(s);
    const ModeSums<double> sums = basis.coupled() ? values_of(coupled_sums(s, as_input(*scene.r)))
                                                  : mode_sums(basis, contact_row(s), load_rows(s), *scene.r);
    return numbers_of_sums(q, sums, q.mass == 0 ? contact_row(s).index : static_cast<std::size_t>(q.mass - 1));
}

// Displacements of the mass asked about, or of the contact, at the instants of the question.
std::vector<double> samples_of(const ProtocolQuestion& q, const Scene<double>& scene, const Solution& solution) {
    std::vector<double> x;
    for (const State& state : sampled_solution(scene_source(scene), solution, static_cast<std::size_t>(q.samples)).states()) {
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
    const std::string system = conformance::question_plain(of_system);
    if (!kept || system != kept_for) {
        kept = solve(scene_source(scene), {Asked::motion, digits_asked, false});
        kept_for = system;
    }
    return *kept;
}

// (86) as the C interface gives it.
std::optional<Value> of_high_frequency(const ProtocolQuestion& q) {
    const Handle system = handle_of(conformance::question_json(q)["scene"].dump());
    double limit = 0;
    if (dh_high_frequency_limit(system.get(), q.mu, &limit) != DH_OK) return std::nullopt;
    return Value{{limit}, ""};
}

// The steady motion in any regime.
std::optional<Value> of_motion(const ProtocolQuestion& q) {
    const Scene<double> scene = conformance::scene_of(q);
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
    if (conformance::quantity(name).absolute) {
        const MassFromGround& seen = solution.from_ground.at(static_cast<std::size_t>(q.mass - 1));
        if (name == "absolute_phase") return seen.phase ? std::optional(Value{{seen.phase->value}, ""}) : std::nullopt;
        return Value{{(name == "transmissibility" ? seen.transmissibility : seen.amplitude).value}, ""};
    }
    const SolvedMass& m = q.mass == 0 ? solution.between.value() : mass_of(solution, Mass{static_cast<std::size_t>(q.mass - 1)});
    if (name == "amplitude") return Value{{m.amplitude.value}, ""};
    return m.phase ? std::optional(Value{{m.phase->value}, ""}) : std::nullopt;
}

} // namespace

std::vector<double> numbers_of_sums(const ProtocolQuestion& q, const ModeSums<double>& s, std::size_t k) {
    if (q.quantity == "complex_response") return {s.V[k].re, s.V[k].im};
    if (q.quantity == "first_damping_function") return {s.U[k]};
    if (q.quantity == "second_damping_function") return {s.G[k]};
    if (q.quantity == "H_j") return {s.H_j};
    const Boundary<double> b = boundary(s, q.mu);
    if (q.quantity == "S_j") return {b.S_exact};
    if (q.quantity == "beta_lim_exact") return {b.exact};
    if (q.quantity == "beta_lim_paper") return {b.paper};
    if (q.quantity == "beta_lim_approximate") return {b.approximate};
    if (q.quantity == "beta_lim_sticking") return b.sticking ? std::vector{*b.sticking} : std::vector<double>();
    const SteadyState<double> state = steady_state(s, b, q.beta);
    if (std::vector<double> numbers = conformance::generator::numbers_of_sliding(state.masses[k], q.quantity); !numbers.empty())
        return numbers;
    if (q.quantity == "displacement") return {motion(s, state, q.tau).x[k]};
    std::vector<double> x;
    for (int n = 0; n < q.samples; ++n) x.push_back(motion(s, state, 2 * n * pi<double>() / q.samples - state.phi_j).x[k]);
    return x;
}

std::optional<Value> answer_of_system(const ProtocolQuestion& q) {
    if (q.quantity == "natural_frequency_ratios") return Value{modal_basis(conformance::scene_of(q).system).r_n, ""};
    if (asks_for(q, {"amplitude", "phase", "regime", "rest_interval", "stops_per_period", "stop_durations", "motion_under_force",
                     "absolute_amplitude", "absolute_phase", "transmissibility"}))
        return of_motion(q);
    if (q.quantity == "beta_lim_high_frequency") return of_high_frequency(q);
    if (asks_for(q, {"complex_response", "first_damping_function", "second_damping_function", "H_j", "S_j", "beta_lim_exact",
                     "beta_lim_sticking", "amplitude_monoharmonic", "phase_monoharmonic", "initial_displacement",
                     "initial_velocity", "displacement"}))
        return Value{of_sums(q), ""};
    return std::nullopt;
}

} // namespace denhartog::tests
