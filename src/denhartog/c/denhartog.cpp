#include "denhartog/c/denhartog.h"

#include <algorithm>
#include <array>
#include <memory>

#include "denhartog/answer/sliding_solution.hpp"
#include "denhartog/c/handles.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/solve/certain_modes.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/version.hpp"

using namespace denhartog;
using namespace denhartog::c_interface;

namespace {

std::size_t masses_of(const dh_system* system) {
    need(system, "system");
    return number_of_masses(system->prepared.scene().system);
}

void make_system(const SceneSource& source, dh_system** system) {
    auto made = std::make_unique<dh_system>(dh_system{prepare(source, Question{}, Prepared::every_regime)});
    made->modes = certain_modes(source, made->prepared.bounded);
    made->basis = values_of(*made->modes);
    Matrix<double>& phi = made->basis.phi;
    const std::vector<Mass>& replaced = made->prepared.scene().system.coordinates.replaced;
    for (std::size_t n = 0; n < replaced.size(); ++n)
        phi.row(static_cast<Eigen::Index>(replaced[n].index)) = phi.row(phi.cols() + static_cast<Eigen::Index>(n));
    phi.conservativeResize(phi.cols(), Eigen::NoChange);
    need_finite(made->basis.r_n);
    *system = made.release();
}

// Significant digits of the numbers that come without a bound of their error.
constexpr int digits_without_bound = 10;

// A boundary below it is zero: at an antiresonance of the contact.
constexpr double boundary_of_antiresonance = 1e-25;

// The system at a point, in every number type.
SceneSource point_of(const dh_system* system, double r, double beta, double mu) {
    check_frequency_ratio(r);
    check_friction_ratio(beta);
    check_static_friction(mu);
    return at_point(with_static_friction(system->prepared.source, mu), r, beta);
}

// Boundary and closed form at a point, in the first precision that has the digits.
Solution closed_form_at(const dh_system* system, double r, double beta, double mu, Asked asked, std::optional<Mass> mass) {
    const SceneSource source = point_of(system, r, beta, mu);
    BoundedModes<double> modes(system->prepared.bounded, as_input(r));
    return sliding_solution(source, {asked, digits_without_bound, mass, &modes});
}

void need_digits(const Solution& found) {
    if (!found.digits_reached)
        throw PrecisionError("the result does not have the " + std::to_string(digits_without_bound) +
                             " digits aimed at: " + found.method.why);
}

[[noreturn]] void throw_not_sliding(double beta, double beta_lim) {
    throw DomainError("beta = " + number_to_text(beta) + " is not below beta_lim = " + number_to_text(beta_lim) +
                      ", Eq. (69): the contact does not slide throughout");
}

std::vector<double> values_of(const std::vector<Bounded<double>>& numbers) {
    std::vector<double> values;
    for (const Bounded<double>& each : numbers) values.push_back(each.x);
    return values;
}

void need_all_finite(std::initializer_list<std::span<const double>> arrays) {
    for (const std::span<const double> array : arrays) need_finite(array);
}

} // namespace

extern "C" {

const char* dh_version(void) noexcept { return DENHARTOG_VERSION; }

int dh_abi_version(void) noexcept { return DH_ABI_VERSION; }

const char* dh_last_message(void) noexcept { return message(); }

const char* dh_status_text(int status) noexcept {
    switch (status) {
    case DH_OK: return "done";
    case DH_ERROR_NULL: return "a pointer that is needed is null";
    case DH_ERROR_SIZE: return "an array or a struct has the wrong size, or a size beyond a limit";
    case DH_ERROR_INPUT: return "a number or a text breaks a rule";
    case DH_ERROR_DOMAIN: return "a formula was asked for where it does not hold";
    case DH_ERROR_PRECISION: return "the digits asked for were not reached, or a result is no finite double";
    case DH_ERROR_MEMORY: return "memory is short";
    case DH_ERROR_INTERNAL: return "a defect of the library";
    default: return "no status of this library";
    }
}

int dh_system_from_ratios(size_t N, const double* mass_ratios, const double* stiffness_ratios, const double* damping_ratios,
                          size_t contact, size_t load, dh_system** system) noexcept {
    return guarded([&] {
        need(mass_ratios, "mass_ratios");
        need(stiffness_ratios, "stiffness_ratios");
        need(damping_ratios, "damping_ratios");
        need(system, "system");
        need_length(N, most_masses, "N");
        Scene<double> scene;
        scene.system.contact = mass_from(contact, N, "contact");
        scene.system.load = mass_from(load, N, "load");
        scene.system.mass_ratios.assign(mass_ratios, mass_ratios + N);
        scene.system.stiffness_ratios.assign(stiffness_ratios, stiffness_ratios + N);
        scene.system.damping_ratios.assign(damping_ratios, damping_ratios + N);
        make_system(scene_source(scene), system);
    });
}

int dh_system_from_json(const char* text, size_t length, dh_system** system) noexcept {
    return guarded([&] {
        need(text, "text");
        need(system, "system");
        make_system(without_point(scene_source(SceneText{std::string_view(text, length)})), system);
    });
}

void dh_system_destroy(dh_system* system) noexcept { delete system; }

int dh_system_masses(const dh_system* system, size_t* N, size_t* contact, size_t* load) noexcept {
    return guarded([&] {
        const std::size_t count = masses_of(system);
        need(N, "N");
        *N = count;
        const System<double>& s = system->prepared.scene().system;
        if (contact != nullptr) *contact = (s.coordinates.between.empty() ? s.contact : s.coordinates.between[0]).index + 1;
        const std::vector<double> p = load_on_coordinates(s);
        const std::vector<Mass>& replaced = s.coordinates.replaced; // its force counts for the other mass of the contact as well
        const auto is_loaded = [](double force) { return force != 0; };
        if (load != nullptr)
            *load = !replaced.empty() && is_loaded(p[replaced.front().index])
                        ? replaced.front().index + 1
                        : static_cast<std::size_t>(std::ranges::find_if(p, is_loaded) - p.begin()) + 1;
    });
}

int dh_natural_frequency_ratios(const dh_system* system, size_t count, double* r_n, double* zeta) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(r_n, "r_n");
        need_count(count, N);
        hand_out(system->basis.r_n, r_n);
        hand_out(system->basis.zeta, zeta);
    });
}

int dh_mode_shapes(const dh_system* system, double r, size_t count, double* psi) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(psi, "psi");
        need_count(count, N * N);
        check_frequency_ratio(r);
        std::vector<double> at_r;
        for (std::size_t k = 0; k < N; ++k)
            for (std::size_t i = 0; i < N; ++i)
                at_r.push_back(system->basis.phi(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) / r);
        need_finite(at_r);
        hand_out(at_r, psi);
    });
}

int dh_modal_functions(const dh_system* system, double r, size_t count, double* R, double* v, double* u, double* g) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(R, "R");
        need_count(count, N);
        check_frequency_ratio(r);
        std::vector<double> ratios;
        for (const double r_n : system->basis.r_n) ratios.push_back(r / r_n);
        need_finite(ratios);
        if (v == nullptr && u == nullptr && g == nullptr) return hand_out(ratios, R); // there is no pole
        check_uncoupled(*system->modes);
        std::vector<double> parts, of_u, of_g;
        for (const auto& f : certain_mode_functions(at_frequency(system->prepared.source, r), system->modes)) {
            parts.insert(parts.end(), {f.v.re.x, f.v.im.x});
            of_u.push_back(f.u.x);
            of_g.push_back(f.g.x);
        }
        need_all_finite({parts, of_u, of_g});
        hand_out(ratios, R);
        hand_out(parts, v);
        hand_out(of_u, u);
        hand_out(of_g, g);
    });
}

int dh_sums(const dh_system* system, double r, size_t count, double* V, double* U, double* G, double* H_j, double* S_j) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(V, "V");
        need_count(count, N);
        const Quantities<Bounded<double>> q =
            quantities(system->prepared, point_of(system, r, 0, 1), {}, digits_without_bound, PointNumbers::sums).numbers;
        std::vector<double> parts;
        for (const Complex<Bounded<double>>& each : q.V) parts.insert(parts.end(), {each.re.x, each.im.x});
        const std::vector<double> of_U = values_of(q.U), of_G = values_of(q.G);
        need_all_finite({parts, of_U, of_G, std::array{q.H_j.x, q.S.x}});
        hand_out(parts, V);
        hand_out(of_U, U);
        hand_out(of_G, G);
        if (H_j != nullptr) *H_j = q.H_j.x;
        if (S_j != nullptr) *S_j = q.S.x;
    });
}

int dh_boundaries(const dh_system* system, double r, double mu, dh_boundary* result) noexcept {
    return guarded([&] {
        need(system, "system");
        need_struct(result, "boundary");
        const Solution found = closed_form_at(system, r, 0, mu, Asked::regime, std::nullopt);
        const Limits& b = *found.limits;
        const dh_boundary all{
            0, b.exact.value, b.paper.value, b.approximate.value, b.sticking ? b.sticking->value : 0, b.sticking.has_value()};
        if (!(all.exact < boundary_of_antiresonance)) need_digits(found);
        need_finite(std::array{all.exact, all.paper, all.approximate, all.sticking});
        hand_out(all, result);
    });
}

int dh_high_frequency_limit(const dh_system* system, double mu, double* beta_lim) noexcept {
    return guarded([&] {
        need(system, "system");
        need(beta_lim, "beta_lim");
        check_static_friction(mu);
        const System<double>& s = system->prepared.scene().system;
        if (s.contact != s.load) throw DomainError("(86) is for a contact that bears the load, j = l");
        *beta_lim = paper::friction_ratio_limit_at_high_frequency(mu);
    });
}

int dh_sliding_motion(const dh_system* system, double r, double beta, double mu, size_t mass, dh_sliding_mass* result) noexcept {
    return guarded([&] {
        const Mass k = mass_from(mass, masses_of(system), "mass");
        need_struct(result, "result");
        const Mass row = displacement_of(system->prepared.scene().system, k);
        const Solution found = closed_form_at(system, r, beta, mu, Asked::motion, row);
        if (found.masses.empty()) throw_not_sliding(beta, found.limits->exact.value);
        const SolvedMass& m = found.masses[row.index];
        const SlidingOfMass& of = *m.sliding;
        const dh_sliding_mass all{0,
                                  of.x0.value,
                                  of.v0.value,
                                  m.amplitude.value,
                                  m.phase ? m.phase->value : 0,
                                  of.instant.value,
                                  of.amplitude_monoharmonic.value,
                                  of.phase_monoharmonic.value};
        need_digits(found);
        need_finite(std::array{all.initial_displacement, all.initial_velocity, all.amplitude, all.phase, all.instant,
                               all.amplitude_monoharmonic, all.phase_monoharmonic});
        hand_out(all, result);
    });
}

int dh_displacement(const dh_system* system, double r, double beta, double mu, size_t mass, size_t count, const double* tau,
                    double* x) noexcept {
    return guarded([&] {
        const Mass k = mass_from(mass, masses_of(system), "mass");
        need(tau, "tau");
        need(x, "x");
        if (count > 0) need_length(count, most_samples_of(masses_of(system)), "count");
        const Quantities<Bounded<double>> q = quantities(system->prepared, point_of(system, r, beta, mu), std::span(tau, count),
                                                         digits_without_bound, PointNumbers::motion)
                                                  .numbers;
        if (!q.X_j) throw_not_sliding(beta, q.beta_lim.x);
        std::vector<double> all;
        for (std::size_t n = k.index; n < q.x.size(); n += q.x_size.size()) all.push_back(q.x[n].x);
        need_finite(all);
        hand_out(all, x);
    });
}

} // extern "C"
