#include "denhartog/c/denhartog.h"

#include <array>
#include <memory>

#include "denhartog/c/handles.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/model/point_rules.hpp"
#include "denhartog/response/steady_state.hpp"

using namespace denhartog;
using namespace denhartog::c_interface;

namespace {

std::size_t masses_of(const dh_system* system) {
    need(system, "system");
    return number_of_masses(system->prepared.scene.system);
}

// The scene of any text at mu = 1 and without a point.
SceneSource without_point(const SceneSource& source) {
    const auto plain = [](const auto& read) {
        return [read] {
            auto scene = read();
            scene.mu = 1;
            scene.r.reset();
            scene.beta.reset();
            return scene;
        };
    };
    return {plain(source.in_double), plain(source.in_long_double), plain(source.in_50_digits), plain(source.in_100_digits)};
}

void make_system(const SceneSource& source, dh_system** system) {
    auto made = std::make_unique<dh_system>(dh_system{prepare(source, Question{}, Prepared::every_regime)});
    made->basis = made->prepared.basis.value();
    need_finite(made->basis.r_n);
    *system = made.release();
}

ModeSums<double> sums_at(const dh_system* system, double r) {
    const System<double>& s = system->prepared.scene.system;
    return mode_sums(system->basis, s.contact, s.load, r);
}

// A point where the contact slides throughout.
struct Sliding {
    ModeSums<double> sums;
    RegimeBoundary<double> boundary;
};

Sliding sliding_at(const dh_system* system, double r, double beta, double mu) {
    Sliding at{sums_at(system, r), {}};
    at.boundary = regime_boundary(at.sums, mu);
    check_friction_ratio(beta);
    if (!(beta < at.boundary.exact))
        throw DomainError("beta = " + number_to_text(beta) + " is not below beta_lim = " + number_to_text(at.boundary.exact) +
                          ", Eq. (69): the contact does not slide throughout");
    return at;
}

std::vector<double> interleaved(const std::vector<Complex<double>>& z) {
    std::vector<double> parts;
    for (const Complex<double>& each : z) parts.insert(parts.end(), {each.re, each.im});
    return parts;
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
    case DH_ERROR_SIZE: return "an array or a struct has not the size that it must have";
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
        if (N == 0) throw CallError(DH_ERROR_SIZE, "N must be at least 1, but is 0");
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
        if (contact != nullptr) *contact = system->prepared.scene.system.contact.index + 1;
        if (load != nullptr) *load = system->prepared.scene.system.load.index + 1;
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
        if (v == nullptr && u == nullptr && g == nullptr) { // there is no pole
            check_frequency_ratio(r);
            std::vector<double> ratios;
            for (const double r_n : system->basis.r_n) ratios.push_back(r / r_n);
            need_finite(ratios);
            return hand_out(ratios, R);
        }
        const ModeSums<double> s = sums_at(system, r);
        const std::vector<double> parts = interleaved(s.v);
        need_all_finite({s.R, parts, s.u, s.g});
        hand_out(s.R, R);
        hand_out(parts, v);
        hand_out(s.u, u);
        hand_out(s.g, g);
    });
}

int dh_sums(const dh_system* system, double r, size_t count, double* V, double* U, double* G, double* H_j, double* S_j) noexcept {
    return guarded([&] {
        const std::size_t N = masses_of(system);
        need(V, "V");
        need_count(count, N);
        const ModeSums<double> s = sums_at(system, r);
        const std::vector<double> parts = interleaved(s.V);
        const double S = S_j == nullptr ? 0 : sliding_demand(s, instant_of_largest_demand(s));
        need_all_finite({parts, s.U, s.G, std::array{s.H_j, S}});
        hand_out(parts, V);
        hand_out(s.U, U);
        hand_out(s.G, G);
        if (H_j != nullptr) *H_j = s.H_j;
        if (S_j != nullptr) *S_j = S;
    });
}

int dh_boundaries(const dh_system* system, double r, double mu, dh_boundary* result) noexcept {
    return guarded([&] {
        need(system, "system");
        need_struct(result, "boundary");
        const Boundary<double> b = boundary(sums_at(system, r), mu);
        const dh_boundary all{0, b.exact, b.paper, b.approximate, b.sticking.value_or(0), b.sticking.has_value()};
        need_finite(std::array{all.exact, all.paper, all.approximate, all.sticking});
        hand_out(all, result);
    });
}

int dh_high_frequency_limit(const dh_system* system, double mu, double* beta_lim) noexcept {
    return guarded([&] {
        need(system, "system");
        need(beta_lim, "beta_lim");
        check_static_friction(mu);
        const System<double>& s = system->prepared.scene.system;
        if (s.contact != s.load) throw DomainError("(86) is for a contact that bears the load, j = l");
        *beta_lim = paper::friction_ratio_limit_at_high_frequency(mu);
    });
}

int dh_sliding_motion(const dh_system* system, double r, double beta, double mu, size_t mass, dh_sliding_mass* result) noexcept {
    return guarded([&] {
        const Mass k = mass_from(mass, masses_of(system), "mass");
        need_struct(result, "result");
        const Sliding at = sliding_at(system, r, beta, mu);
        const MassResponse<double> m = steady_state(at.sums, at.boundary, beta, k).masses[k.index];
        const dh_sliding_mass all{0, m.x0, m.v0, m.amplitude, m.phase, m.instant, m.amplitude_monoharmonic, m.phase_monoharmonic};
        need_finite(std::array{m.x0, m.v0, m.amplitude, m.phase, m.instant, m.amplitude_monoharmonic, m.phase_monoharmonic});
        hand_out(all, result);
    });
}

int dh_displacement(const dh_system* system, double r, double beta, double mu, size_t mass, size_t count, const double* tau,
                    double* x) noexcept {
    return guarded([&] {
        const Mass k = mass_from(mass, masses_of(system), "mass");
        need(tau, "tau");
        need(x, "x");
        const Sliding at = sliding_at(system, r, beta, mu);
        const SteadyState<double> state = steady_state_without_maxima(at.sums, beta);
        std::vector<double> all;
        for (std::size_t n = 0; n < count; ++n) {
            if (!std::isfinite(tau[n])) throw InputError("tau", "must be finite", number_to_text(tau[n]));
            all.push_back(motion(at.sums, state, tau[n]).x[k.index]);
        }
        need_finite(all);
        hand_out(all, x);
    });
}

} // extern "C"
