#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "denhartog/c/denhartog.h"
#include "denhartog/c/handles.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/solve/sampled_solution.hpp"

using namespace denhartog;
using namespace denhartog::c_interface;

namespace {

using Numbers = std::vector<double>;

// What a quantity is asked of, and whether its numbers are wanted or the bounds of their errors.
struct AtPoint {
    const dh_system* system;
    double r, beta, mu;
    size_t mass;
    double tau;
    size_t samples;
    ValueOrError part;
    size_t N, contact;
};

// A call of another function of the interface; what failed there fails here with its text.
void done(int status) {
    if (status != DH_OK) throw CallError(static_cast<dh_status>(status), message());
}

// A number where it exists.
Numbers existing(bool exists, double x, const char* why) {
    if (!exists) throw DomainError(why);
    return {x};
}

// The one of two functions, or of two numbers, that belongs to the part that is wanted.
template <class Of>
Of wanted(const AtPoint& a, Of of_value, Of of_error) {
    return a.part == ValueOrError::value ? of_value : of_error;
}

Numbers shape_products(const AtPoint& a) {
    Numbers psi(a.N * a.N), errors(a.N * a.N), products;
    done(dh_mode_shapes(a.system, a.r, psi.size(), psi.data()));
    done(dh_mode_shape_errors(a.system, a.r, errors.size(), errors.data()));
    const auto shape = [&](size_t k, size_t i) { return Bounded<double>(psi[k * a.N + i], errors[k * a.N + i]); };
    const std::optional<Mass>& with = a.system->prepared.scene().system.contact_with;
    for (size_t i = 0; i < a.N; ++i) {
        const Bounded<double> of_contact = shape(a.contact - 1, i);
        const Bounded<double> psi_ji = with ? of_contact - shape(with->index, i) : of_contact;
        products.push_back(part_of(shape(a.mass - 1, i) * psi_ji, a.part));
    }
    return products;
}

struct Sums {
    Numbers V, U, G;
    double H_j, S_j;
};

Sums sums(const AtPoint& a, bool largest = false) {
    Sums s{Numbers(2 * a.N), Numbers(a.N), Numbers(a.N), 0, 0};
    done(wanted(a, dh_sums, dh_sum_errors)(a.system, a.r, a.N, s.V.data(), s.U.data(), s.G.data(), &s.H_j,
                                           largest ? &s.S_j : nullptr));
    return s;
}

dh_boundary boundaries(const AtPoint& a) {
    dh_boundary b{};
    b.size = sizeof b;
    done(wanted(a, dh_boundaries, dh_boundary_errors)(a.system, a.r, a.mu, &b));
    return b;
}

dh_sliding_mass sliding(const AtPoint& a) {
    dh_sliding_mass m{};
    m.size = sizeof m;
    done(wanted(a, dh_sliding_motion, dh_sliding_motion_errors)(a.system, a.r, a.beta, a.mu, a.mass, &m));
    return m;
}

// The steady motion in any regime.
struct Steady {
    struct Destroy {
        void operator()(dh_solution* solution) const { dh_solution_destroy(solution); }
    };
    std::unique_ptr<dh_solution, Destroy> solution;
    dh_summary all{};
    explicit Steady(const AtPoint& a) {
        constexpr int digits = 12;
        dh_solution* found = nullptr;
        done(dh_solve(a.system, a.r, a.beta, a.mu, digits, &found));
        solution.reset(found);
        all.size = sizeof all;
        done(dh_solution_summary(found, &all));
    }
    [[nodiscard]] dh_mass mass(size_t k) const {
        dh_mass m{};
        m.size = sizeof m;
        done(dh_solution_mass(solution.get(), k, &m));
        return m;
    }
};

Numbers amplitude(const AtPoint& a) {
    const dh_mass m = Steady(a).mass(a.mass);
    return {wanted(a, m.amplitude, m.error)};
}

Numbers phase(const AtPoint& a) {
    const dh_mass m = Steady(a).mass(a.mass);
    return existing(m.moves != 0, wanted(a, m.phase, m.phase_error), "a mass that does not move has no phase");
}

Numbers regime(const AtPoint& a) {
    const dh_summary all = Steady(a).all;
    return {static_cast<double>(wanted(a, all.regime, all.on_boundary))};
}

Numbers stops_per_period(const AtPoint& a) {
    const dh_summary all = Steady(a).all;
    return {wanted(a, static_cast<double>(all.stops) / all.periods, 0.0)};
}

Numbers stop_durations(const AtPoint& a) {
    const Steady steady(a);
    const size_t count = steady.all.stops;
    Numbers start(count), end(count), start_error(count), end_error(count), parts;
    done(dh_solution_stops(steady.solution.get(), count, start.data(), end.data()));
    done(dh_solution_stop_errors(steady.solution.get(), count, start_error.data(), end_error.data()));
    std::vector<Bounded<double>> durations;
    for (size_t i = 0; i < count; ++i)
        durations.push_back(Bounded<double>(end[i], end_error[i]) - Bounded<double>(start[i], start_error[i]));
    std::sort(durations.begin(), durations.end());
    return parts_of(durations, a.part);
}

Numbers motion_under_force(const AtPoint& a) {
    need_length(a.samples, most_samples_of(a.N), "size, the number of samples,");
    const Steady steady(a);
    if (steady.all.periods != 1) throw DomainError("the motion has not the period of the force");
    const dh_mass m = steady.mass(a.mass);
    if (a.part == ValueOrError::error) return Numbers(a.samples, error_of_samples * m.amplitude + m.error);
    Numbers x(a.samples * a.N), of_mass;
    done(dh_solution_motion(steady.solution.get(), a.samples, x.size(), x.data(), nullptr));
    for (size_t n = 0; n < a.samples; ++n) of_mass.push_back(x[n * a.N + a.mass - 1]);
    return of_mass;
}

Numbers natural_frequency_ratios(const AtPoint& a) {
    Numbers r_n(a.N);
    done(wanted(a, dh_natural_frequency_ratios, dh_natural_frequency_ratio_errors)(a.system, a.N, r_n.data(), nullptr));
    return r_n;
}

Numbers modal_frequency_ratios(const AtPoint& a) {
    Numbers R(a.N);
    done(wanted(a, dh_modal_functions, dh_modal_function_errors)(a.system, a.r, a.N, R.data(), nullptr, nullptr, nullptr));
    return R;
}

Numbers displacement(const AtPoint& a) {
    double x = 0;
    done(wanted(a, dh_displacement, dh_displacement_errors)(a.system, a.r, a.beta, a.mu, a.mass, 1, &a.tau, &x));
    return {x};
}

Numbers high_frequency_limit(const AtPoint& a) {
    double limit = 0;
    done(wanted(a, dh_high_frequency_limit, dh_high_frequency_limit_error)(a.system, a.mu, &limit));
    return {limit};
}

Numbers sticking_limit(const AtPoint& a) {
    const dh_boundary b = boundaries(a);
    return existing(b.sticking_exists != 0, b.sticking, "no friction holds the contact: the system resonates while it is held");
}

Numbers rest_interval(const AtPoint& a) {
    const dh_summary all = Steady(a).all;
    return existing(all.rest_interval_exists != 0, wanted(a, all.rest_to, all.rest_error), "the contact does not rest for ever");
}

struct Named {
    std::string_view name;
    bool of_mass;
    Numbers (*value)(const AtPoint&);
};

constexpr Named named[] = {
    {"natural_frequency_ratios", false, natural_frequency_ratios},
    {"modal_frequency_ratios", false, modal_frequency_ratios},
    {"mode_shape_products", true, shape_products},
    {"complex_response", true,
     [](const AtPoint& a) {
         return Numbers{sums(a).V[2 * a.mass - 2], sums(a).V[2 * a.mass - 1]};
     }},
    {"first_damping_function", true, [](const AtPoint& a) { return Numbers{sums(a).U[a.mass - 1]}; }},
    {"second_damping_function", true, [](const AtPoint& a) { return Numbers{sums(a).G[a.mass - 1]}; }},
    {"H_j", false, [](const AtPoint& a) { return Numbers{sums(a).H_j}; }},
    {"S_j", false, [](const AtPoint& a) { return Numbers{sums(a, true).S_j}; }},
    {"amplitude", true, amplitude},
    {"phase", true, phase},
    {"amplitude_monoharmonic", true, [](const AtPoint& a) { return Numbers{sliding(a).amplitude_monoharmonic}; }},
    {"phase_monoharmonic", true, [](const AtPoint& a) { return Numbers{sliding(a).phase_monoharmonic}; }},
    {"initial_displacement", true, [](const AtPoint& a) { return Numbers{sliding(a).initial_displacement}; }},
    {"initial_velocity", true, [](const AtPoint& a) { return Numbers{sliding(a).initial_velocity}; }},
    {"displacement", true, displacement},
    {"beta_lim_exact", false, [](const AtPoint& a) { return Numbers{boundaries(a).exact}; }},
    {"beta_lim_paper", false, [](const AtPoint& a) { return Numbers{boundaries(a).paper}; }},
    {"beta_lim_approximate", false, [](const AtPoint& a) { return Numbers{boundaries(a).approximate}; }},
    {"beta_lim_sticking", false, sticking_limit},
    {"beta_lim_high_frequency", false, high_frequency_limit},
    {"regime", false, regime},
    {"stops_per_period", false, stops_per_period},
    {"stop_durations", false, stop_durations},
    {"rest_interval", false, rest_interval},
    {"motion_under_force", true, motion_under_force},
};

// The numbers of a quantity, or the bounds of their errors.
int named_quantity(const dh_system* system, const char* name, double r, double beta, double mu, size_t mass, double tau,
                   ValueOrError part, size_t size, Output result, size_t* count) noexcept {
    return guarded([&] {
        need(name, "name");
        need(result.numbers, result.name);
        need(count, "count");
        AtPoint asked{system, r, beta, mu, mass, tau, size, part, 0, 0};
        done(dh_system_masses(system, &asked.N, &asked.contact, nullptr));
        check_frequency_ratio(r);
        check_friction_ratio(beta);
        check_static_friction(mu);
        const auto* quantity = std::find_if(std::begin(named), std::end(named), [&](const Named& q) { return q.name == name; });
        if (quantity == std::end(named)) throw DomainError("there is no quantity of this name");
        if (quantity->of_mass) (void)mass_from(mass, asked.N, "mass");
        const Numbers numbers = quantity->value(asked);
        if (numbers.size() > size)
            throw CallError(DH_ERROR_SIZE,
                            "size must be at least " + std::to_string(numbers.size()) + ", but is " + std::to_string(size));
        need_finite(numbers);
        hand_out(numbers, result.numbers);
        *count = numbers.size();
    });
}

} // namespace

extern "C" {

int dh_quantity(const dh_system* system, const char* name, double r, double beta, double mu, size_t mass, double tau, size_t size,
                double* values, size_t* count) noexcept {
    return named_quantity(system, name, r, beta, mu, mass, tau, ValueOrError::value, size, {values, "values"}, count);
}

int dh_quantity_errors(const dh_system* system, const char* name, double r, double beta, double mu, size_t mass, double tau,
                       size_t size, double* errors, size_t* count) noexcept {
    return named_quantity(system, name, r, beta, mu, mass, tau, ValueOrError::error, size, {errors, "errors"}, count);
}

} // extern "C"
