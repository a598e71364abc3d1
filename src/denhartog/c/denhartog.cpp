// The C interface to a system: status texts, making and destroying it, the boundaries (67), (69), (86) and (88), and the motion
// while the contact slides, (46). Each value has a twin that gives its bound. Read `dh_boundaries` for the pattern of all.
#include <algorithm>
#include <array>
#include <memory>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/c/handles.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/solve/solve.hpp"
#include "denhartog/version.hpp"

using namespace denhartog;
using namespace denhartog::c_interface;

namespace {

void make_system(const SceneSource& source, dh_system** system) {
    auto made = std::make_unique<dh_system>(dh_system{prepare(paid(source), Question{}, Prepared::every_regime)});
    made->prepared.source = source; // which outlives this call
    made->modes = certain_modes(paid(source), made->prepared.bounded);
    for (const Bounded<double>& r_n : made->modes->r_n) need_finite(std::array{r_n.x});
    *system = made.release();
}

// A boundary below it is zero: at an antiresonance of the contact.
constexpr double boundary_of_antiresonance = 1e-25;

// Boundary and closed form at a point.
Solution closed_form_at(const dh_system* system, double r, double beta, double mu, Asked asked, std::optional<Mass> mass) {
    const SceneSource source = paid(point_of(system, r, beta, mu));
    const bool own_load = load_depends_on_frequency(source->in_double().system); // that of what is prepared is another
    return sliding_answer(source, Question{asked, digits_of_formulas, false, mass},
                          own_load ? nullptr : system->prepared.bounded);
}

void need_digits(const Solution& found) {
    if (!found.digits_reached)
        throw PrecisionError("the result does not have the " + std::to_string(digits_of_formulas) +
                             " digits aimed at: " + in_words(found.method.why));
}

[[noreturn]] void throw_not_sliding(double beta, double beta_lim) {
    throw DomainError("beta = " + number_to_text(beta) + " is not below beta_lim = " + number_to_text(beta_lim) +
                      ", Eq. (69): the contact does not slide throughout");
}

// The friction ratios between the regimes, or the bounds of their errors.
dh_boundary struct_of(const Limits& b, ValueOrError part) {
    const dh_boundary all{0,
                          part_of(b.exact, part),
                          part_of(b.paper, part),
                          part_of(b.approximate, part),
                          b.sticking ? part_of(*b.sticking, part) : 0,
                          b.sticking.has_value()};
    need_finite(std::array{all.exact, all.paper, all.approximate, all.sticking});
    return all;
}

int boundaries(const dh_system* system, double r, double mu, ValueOrError part, dh_boundary* result, const char* name) noexcept {
    return guarded([&] {
        need(system, "system");
        need_struct(result, name);
        hand_out(struct_of(limits_at(system, r, mu), part), result);
    });
}

// Motion of a mass while the contact slides throughout, or the bounds of its errors.
int sliding_motion(const dh_system* system, double r, double beta, double mu, size_t mass, ValueOrError part,
                   dh_sliding_mass* result, const char* name) noexcept {
    return guarded([&] {
        const Mass k = mass_from(mass, masses_of(system), "mass");
        need_struct(result, name);
        const SolvedMass m = sliding_at(system, r, beta, mu, k);
        const SlidingOfMass& of = *m.sliding;
        const dh_sliding_mass all{0,
                                  part_of(of.x0, part),
                                  part_of(of.v0, part),
                                  part_of(m.amplitude, part),
                                  m.phase ? part_of(*m.phase, part) : 0,
                                  part_of(of.instant, part),
                                  part_of(of.amplitude_monoharmonic, part),
                                  part_of(of.phase_monoharmonic, part)};
        need_finite(std::array{all.initial_displacement, all.initial_velocity, all.amplitude, all.phase, all.instant,
                               all.amplitude_monoharmonic, all.phase_monoharmonic});
        hand_out(all, result);
    });
}

// (86), or the bound of its error.
int high_frequency_limit(const dh_system* system, double mu, ValueOrError part, double* result, const char* name) noexcept {
    return guarded([&] {
        need(system, "system");
        need(result, name);
        hand_out(part, {{{c_interface::limit_at_high_frequency(system, mu)}, result}});
    });
}

// Displacements, or the bounds of their errors.
int displacements(const dh_system* system, double r, double beta, double mu, size_t mass, size_t count, const double* tau,
                  ValueOrError part, double* result) noexcept {
    return guarded([&] {
        const Mass k = mass_from(mass, masses_of(system), "mass");
        need(tau, "tau");
        need(result, part, "x");
        if (count > 0) need_length(count, most_samples_of(masses_of(system)), "count");
        hand_out(part, {{displacements_at(system, r, beta, mu, k, std::span(tau, count)), result}});
    });
}

} // namespace

Limits c_interface::limits_at(const dh_system* system, double r, double mu) {
    const Solution found = closed_form_at(system, r, 0, mu, Asked::regime, std::nullopt);
    if (!(found.limits->exact.value < boundary_of_antiresonance)) need_digits(found);
    return *found.limits;
}

SolvedMass c_interface::sliding_at(const dh_system* system, double r, double beta, double mu, Mass k) {
    const Solution found = closed_form_at(system, r, beta, mu, Asked::motion, k);
    if (found.masses.empty()) throw_not_sliding(beta, found.limits->exact.value);
    need_digits(found);
    return found.masses.front();
}

Bounded<double> c_interface::limit_at_high_frequency(const dh_system* system, double mu) {
    check_static_friction(mu);
    const System<double>& s = system->prepared.scene().system;
    const bool changes = load_depends_on_frequency(s);
    const System<double> at = changes && s.base_motion == BaseMotion::alone ? with_load_at(s, 1) : s; // dampers that load nothing
    if (changes && (at.base_motion == BaseMotion::wall || !at.load_phases.empty()))
        throw DomainError(
            "(86) is for one load at all frequencies, not for that of a wall alone, or of a base alone with dampers "
            "to the base");
    const Bounded<double> limit = paper::friction_ratio_limit_at_high_frequency(Bounded<double>(mu));
    if (!changes && contact_row(s) == load_row(s)) return limit;
    // V_dj and U_dj fall with w^T M^-1 p and w^T M^-1 w, the sums over the modes.
    const Matrix<Bounded<double>>& phi = system->modes->phi;
    const auto with_contact = [&](Mass row) {
        Bounded<double> sum(0);
        for (Eigen::Index i = 0; i < phi.cols(); ++i)
            sum += phi(static_cast<Eigen::Index>(contact_row(s).index), i) * phi(static_cast<Eigen::Index>(row.index), i);
        return sum;
    };
    Complex<Bounded<double>> load{Bounded<double>(0), Bounded<double>(0)};
    if (changes) {
        for (std::size_t k = 0; k < at.load_vector.size(); ++k)
            load.re += Bounded<double>(at.load_vector[k], at.load_error[k]) * with_contact(Mass{k});
    } else {
        const LoadRows rows = load_rows(s);
        load = {with_contact(rows.re), rows.im ? with_contact(*rows.im) : Bounded<double>(0)};
    }
    if (std::abs(load.re.x) <= load.re.e && std::abs(load.im.x) <= load.im.e)
        throw DomainError("(86) is for a contact that bears the load, j = l: here inertia keeps the load away from the contact");
    return limit * modulus(load) / with_contact(contact_row(s));
}

Numbers c_interface::displacements_at(const dh_system* system, double r, double beta, double mu, Mass k,
                                      std::span<const double> tau) {
    const Quantities<Bounded<double>> q =
        quantities(paid(point_of(system, r, beta, mu)), tau, digits_of_formulas, PointNumbers::motion, system->prepared.bounded)
            .numbers;
    if (!q.X_j) throw_not_sliding(beta, q.beta_lim.x);
    Numbers x;
    for (std::size_t n = k.index; n < q.x.size(); n += q.x_size.size()) x.push_back(q.x[n]);
    return x;
}

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
        if (contact != nullptr) *contact = s.contact.index + 1;
        const auto first = std::ranges::find_if(s.load_vector, [](double force) { return force != 0; });
        if (load != nullptr)
            *load = s.load_vector.empty() ? s.load.index + 1 : static_cast<std::size_t>(first - s.load_vector.begin()) + 1;
    });
}

int dh_boundaries(const dh_system* system, double r, double mu, dh_boundary* boundary) noexcept {
    return boundaries(system, r, mu, ValueOrError::value, boundary, "boundary");
}

int dh_boundary_errors(const dh_system* system, double r, double mu, dh_boundary* errors) noexcept {
    return boundaries(system, r, mu, ValueOrError::error, errors, "errors");
}

int dh_boundaries_proved(const dh_system* system, double r, double mu, dh_boundary* boundary, dh_boundary* errors) noexcept {
    return guarded([&] {
        need(system, "system");
        need_struct(boundary, "boundary");
        if (errors != nullptr) need_struct(errors, "errors");
        check_frequency_ratio(r);
        check_static_friction(mu);
        const SceneSource source = paid(at_frequency(with_static_friction(system->prepared.source, mu), r));
        const Limits found = *sliding_answer(source, digits_of_formulas, true).limits;
        const dh_boundary values = struct_of(found, ValueOrError::value), bounds = struct_of(found, ValueOrError::error);
        hand_out(values, boundary);
        if (errors != nullptr) hand_out(bounds, errors);
    });
}

int dh_high_frequency_limit(const dh_system* system, double mu, double* beta_lim) noexcept {
    return high_frequency_limit(system, mu, ValueOrError::value, beta_lim, "beta_lim");
}

int dh_high_frequency_limit_error(const dh_system* system, double mu, double* error) noexcept {
    return high_frequency_limit(system, mu, ValueOrError::error, error, "error");
}

int dh_sliding_motion(const dh_system* system, double r, double beta, double mu, size_t mass, dh_sliding_mass* result) noexcept {
    return sliding_motion(system, r, beta, mu, mass, ValueOrError::value, result, "result");
}

int dh_sliding_motion_errors(const dh_system* system, double r, double beta, double mu, size_t mass,
                             dh_sliding_mass* errors) noexcept {
    return sliding_motion(system, r, beta, mu, mass, ValueOrError::error, errors, "errors");
}

int dh_displacement(const dh_system* system, double r, double beta, double mu, size_t mass, size_t count, const double* tau,
                    double* x) noexcept {
    return displacements(system, r, beta, mu, mass, count, tau, ValueOrError::value, x);
}

int dh_displacement_errors(const dh_system* system, double r, double beta, double mu, size_t mass, size_t count,
                           const double* tau, double* x_error) noexcept {
    return displacements(system, r, beta, mu, mass, count, tau, ValueOrError::error, x_error);
}

} // extern "C"
