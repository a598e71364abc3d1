// One quantity by its name in C, `dh_quantity`, with the names of the conformance protocol. Read the table `named` first: each
// name has the function that computes its numbers, and `named_quantity` checks the call and hands them out.
#include <algorithm>
#include <string_view>

#include "denhartog/c/handles.hpp"
#include "denhartog/solve/sampled_solution.hpp"

using namespace denhartog;
using namespace denhartog::c_interface;

namespace {

// Place at which a quantity is asked for.
struct AtPoint {
    const dh_system* system;
    double r, beta, mu;
    Mass k;
    double tau;
    size_t samples, N;
    ValueOrError part; // that is wanted
};

// A number where it exists.
template <class Number>
Numbers existing(const std::optional<Number>& x, const char* why) {
    if (!x) throw DomainError(why);
    return {bounded(*x)};
}

// psi_ki psi_ji of every mode; psi_ji is w^T psi_i where the contact does not move as one mass.
Numbers shape_products(const AtPoint& a) {
    const Numbers psi = shapes_at(a.system, a.r);
    const System<double>& s = a.system->prepared.scene().system;
    Numbers products;
    for (size_t i = 0; i < a.N; ++i) {
        const auto of = [&](Mass k) { return psi[k.index * a.N + i]; };
        products.push_back(of(a.k) * along_contact<Bounded<double>>(s, [&](size_t k) { return of(Mass{k}); }));
    }
    return products;
}

// The steady motion in any regime.
dh_solution steady(const AtPoint& a) {
    constexpr int digits = 12;
    return solution_at(a.system, a.r, a.beta, a.mu, digits, false);
}

SolvedMass sliding(const AtPoint& a) { return sliding_at(a.system, a.r, a.beta, a.mu, a.k); }

Limits limits(const AtPoint& a) { return limits_at(a.system, a.r, a.mu); }

Numbers amplitude(const AtPoint& a) {
    const Solution s = steady(a).solution;
    const SolvedMass& m = mass_of(s, a.k);
    return {bounded(m.amplitude.value, error_of_displacements(m))};
}

Numbers phase(const AtPoint& a) {
    return existing(mass_of(steady(a).solution, a.k).phase, "a mass that does not move has no phase");
}

// A number of the motion seen from the ground.
Numbers from_ground(const AtPoint& a, std::optional<Certified> (*number)(const MassFromGround&)) {
    const Solution s = steady(a).solution;
    if (s.from_ground.empty()) throw DomainError("neither base nor wall moves");
    return existing(number(s.from_ground[a.k.index]), "a mass that does not move has no phase");
}

Numbers regime(const AtPoint& a) {
    const RegimeAtPoint found = steady(a).solution.regime;
    return {{static_cast<double>(found.regime), found.on_boundary ? 1.0 : 0.0}};
}

Numbers stops_per_period(const AtPoint& a) {
    const Solution s = steady(a).solution;
    return {{static_cast<double>(s.stops.size()) / s.periods, 0.0}};
}

Numbers stop_durations(const AtPoint& a) {
    Numbers durations;
    for (const SolvedStop& stop : steady(a).solution.stops) durations.push_back(bounded(stop.end) - bounded(stop.start));
    std::sort(durations.begin(), durations.end());
    return durations;
}

Numbers rest_interval(const AtPoint& a) {
    std::optional<RestInterval> found = steady(a).solution.rest_interval;
    if (found) found->to.error = std::max(found->from.error, found->to.error);
    return existing(found ? std::optional(found->to) : std::nullopt, "the contact does not rest for ever");
}

Numbers motion_under_force(const AtPoint& a) {
    need_length(a.samples, most_samples_of(a.N), "size, the number of samples,");
    const auto [source, solution] = steady(a);
    if (solution.periods != 1) throw DomainError("the motion has not the period of the force");
    const SolvedMass& m = mass_of(solution, a.k);
    const double error = error_of_samples * m.amplitude.value + error_of_displacements(m);
    if (a.part == ValueOrError::error) return Numbers(a.samples, bounded(0, error));
    Numbers x;
    const SampledSolution motion = sampled_solution(source, solution, a.samples);
    for (size_t n = a.k.index; n < motion.x.size(); n += a.N) x.push_back(bounded(motion.x[n], error));
    return x;
}

struct Named {
    std::string_view name;
    bool has_mass;
    Numbers (*numbers)(const AtPoint&);
};

constexpr Named named[] = {
    {"natural_frequency_ratios", false, [](const AtPoint& a) { return a.system->modes->r_n; }},
    {"modal_frequency_ratios", false, [](const AtPoint& a) { return frequency_ratios_at(a.system, a.r); }},
    {"mode_shape_products", true, shape_products},
    {"complex_response", true,
     [](const AtPoint& a) {
         const auto [re, im] = sums_at(a.system, a.r).V[a.k.index];
         return Numbers{re, im};
     }},
    {"first_damping_function", true, [](const AtPoint& a) { return Numbers{sums_at(a.system, a.r).U[a.k.index]}; }},
    {"second_damping_function", true, [](const AtPoint& a) { return Numbers{sums_at(a.system, a.r).G[a.k.index]}; }},
    {"H_j", false, [](const AtPoint& a) { return Numbers{sums_at(a.system, a.r).H_j}; }},
    {"S_j", false, [](const AtPoint& a) { return Numbers{sums_at(a.system, a.r).S}; }},
    {"amplitude", true, amplitude},
    {"phase", true, phase},
    {"absolute_amplitude", true,
     [](const AtPoint& a) { return from_ground(a, [](const MassFromGround& m) { return std::optional(m.amplitude); }); }},
    {"absolute_phase", true, [](const AtPoint& a) { return from_ground(a, [](const MassFromGround& m) { return m.phase; }); }},
    {"transmissibility", true,
     [](const AtPoint& a) { return from_ground(a, [](const MassFromGround& m) { return std::optional(m.transmissibility); }); }},
    {"amplitude_monoharmonic", true,
     [](const AtPoint& a) { return Numbers{bounded(sliding(a).sliding->amplitude_monoharmonic)}; }},
    {"phase_monoharmonic", true, [](const AtPoint& a) { return Numbers{bounded(sliding(a).sliding->phase_monoharmonic)}; }},
    {"initial_displacement", true, [](const AtPoint& a) { return Numbers{bounded(sliding(a).sliding->x0)}; }},
    {"initial_velocity", true, [](const AtPoint& a) { return Numbers{bounded(sliding(a).sliding->v0)}; }},
    {"displacement", true,
     [](const AtPoint& a) { return displacements_at(a.system, a.r, a.beta, a.mu, a.k, std::span(&a.tau, 1)); }},
    {"beta_lim_exact", false, [](const AtPoint& a) { return Numbers{bounded(limits(a).exact)}; }},
    {"beta_lim_paper", false, [](const AtPoint& a) { return Numbers{bounded(limits(a).paper)}; }},
    {"beta_lim_approximate", false, [](const AtPoint& a) { return Numbers{bounded(limits(a).approximate)}; }},
    {"beta_lim_sticking", false,
     [](const AtPoint& a) {
         return existing(limits(a).sticking, "no friction holds the contact: the system resonates while it is held");
     }},
    {"beta_lim_high_frequency", false, [](const AtPoint& a) { return Numbers{limit_at_high_frequency(a.system, a.mu)}; }},
    {"regime", false, regime},
    {"stops_per_period", false, stops_per_period},
    {"stop_durations", false, stop_durations},
    {"rest_interval", false, rest_interval},
    {"motion_under_force", true, motion_under_force},
};

// The numbers of a quantity, or the bounds of their errors.
int named_quantity(const dh_system* system, const char* name, double r, double beta, double mu, size_t mass, double tau,
                   ValueOrError part, size_t size, double* result, const char* result_name, size_t* count) noexcept {
    return guarded([&] {
        need(name, "name");
        need(result, result_name);
        need(count, "count");
        const size_t N = masses_of(system);
        check_frequency_ratio(r);
        check_friction_ratio(beta);
        check_static_friction(mu);
        const auto* quantity = std::ranges::find(named, std::string_view(name), &Named::name);
        if (quantity == std::end(named)) throw DomainError("there is no quantity of this name");
        const Mass k = quantity->has_mass ? mass_from(mass, N, "mass") : Mass{};
        const Numbers numbers = quantity->numbers({system, r, beta, mu, k, tau, size, N, part});
        if (numbers.size() > size)
            throw CallError(DH_ERROR_SIZE,
                            "size must be at least " + std::to_string(numbers.size()) + ", but is " + std::to_string(size));
        hand_out(part, {{numbers, result}});
        *count = numbers.size();
    });
}

} // namespace

extern "C" {

int dh_quantity(const dh_system* system, const char* name, double r, double beta, double mu, size_t mass, double tau, size_t size,
                double* values, size_t* count) noexcept {
    return named_quantity(system, name, r, beta, mu, mass, tau, ValueOrError::value, size, values, "values", count);
}

int dh_quantity_errors(const dh_system* system, const char* name, double r, double beta, double mu, size_t mass, double tau,
                       size_t size, double* errors, size_t* count) noexcept {
    return named_quantity(system, name, r, beta, mu, mass, tau, ValueOrError::error, size, errors, "errors", count);
}

} // extern "C"
