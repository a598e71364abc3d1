// Motions and initial values as printed, on the paper's own scenes: a single mass of Fig. 6 and the five masses of Fig. 5.
#include <algorithm>
#include <cmath>

#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "derivation/observations/refutation_scene.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

namespace {

constexpr const char* in_units_of_load = ", in units of P / k_1";

/// The sum in (41) and (46) for a mass, as printed and as it holds.
std::pair<double, double> friction_motions_of(const SlidingScene& s, std::size_t k, double tau) {
    const ModeSums<double>& m = s.sums;
    const std::span<const double> psi_k = mode_shapes_at(m, Mass{k}), psi_j = mode_shapes_at(m, m.contact);
    return {as_printed::friction_motion_of_mass<double>(tau, psi_k, psi_j, m.R, m.zeta, m.u, m.g),
            paper::friction_motion_of_mass<double>(tau, psi_k, psi_j, m.R, m.zeta, m.u, m.g)};
}

/// (46) at the maximum of the displacement of the contact.
Compared amplitude_of_contact(const SlidingScene& s) {
    const std::size_t j = s.sums.contact.index;
    const auto [printed, holds] = friction_motions_of(s, j, 0);
    const auto displacement = [&](double F_j) {
        return paper::steady_displacement(0.0, s.sums.V[j], s.sums.V[j], s.sums.U[j], s.state.beta, F_j);
    };
    return {std::string("displacement of the mass in contact at tau = 0, which is its amplitude") + in_units_of_load,
            displacement(printed), displacement(holds), s.state.X_j};
}

/// (41) at the same instant, from initial values that are right: it does not give them back.
Compared start_of_contact(const SlidingScene& s) {
    const std::size_t j = s.sums.contact.index;
    const auto [printed, holds] = friction_motions_of(s, j, 0);
    const auto displacement = [&](double F_j) {
        return paper::displacement(0.0, s.state.X_j, 0.0, s.sums.G[j], s.sums.U[j], s.state.beta, F_j);
    };
    return {std::string("displacement of the mass in contact at tau = 0, started from its amplitude") + in_units_of_load,
            displacement(printed), displacement(holds), s.state.X_j};
}

/// (40) and (A.15) at tau = 0, where the modal displacement is its own initial value.
Compared start_of_first_mode(const SlidingScene& s) {
    const InitialValues<double> start = start_of_mode(s, 0);
    const auto displacement = [&](const auto& formula) {
        return formula(0.0, mode_of(s, 0), start, s.sums.u[0], s.sums.g[0], s.state.beta);
    };
    const double printed = displacement([](auto&&... a) { return as_printed::modal_displacement(a...); });
    const double holds = displacement([](auto&&... a) { return paper::modal_displacement(a...); });
    return {"displacement of the first mode at tau = 0, started from eta_10", printed, holds, std::abs(holds)};
}

/// (A.7) at tau = pi/2.
Compared velocity_of_first_mode(const SlidingScene& s) {
    const InitialValues<double> start = start_of_mode(s, 0);
    const double tau = pi<double>() / 2;
    const double printed = as_printed::modal_velocity_from_start(tau, mode_of(s, 0), start, s.state.beta, s.state.phi_j);
    const double holds = paper::modal_velocity_from_start(tau, mode_of(s, 0), start, s.state.beta, s.state.phi_j);
    return {"velocity of the first mode at tau = pi/2", printed, holds, std::abs(holds)};
}

/// A comparison for the first mass, which is not in contact.
std::function<Compared(const SlidingScene&)>
first_mass(const std::string& quantity, const std::function<std::pair<double, double>(const SlidingScene&)>& printed_and_holds) {
    return [=](const SlidingScene& s) {
        const auto [printed, holds] = printed_and_holds(s);
        return Compared{quantity, printed, holds, s.state.masses[0].amplitude};
    };
}

double printed_x_0(const SlidingScene& s) {
    const std::size_t j = s.sums.contact.index;
    return as_printed::initial_displacement(s.sums.V[0], s.sums.V[j], s.sums.U[j], s.sums.G[0], s.state.beta);
}

double printed_v_0(const SlidingScene& s) {
    const std::size_t j = s.sums.contact.index;
    return as_printed::initial_velocity(s.sums.V[0], s.sums.V[j], s.sums.U[j], s.sums.U[0], s.state.beta);
}

/// The motion (49) at tau = pi/4: its first equality with real parts of what is printed, and its last.
std::pair<double, double> monoharmonic_motions(const SlidingScene& s) {
    const std::size_t j = s.sums.contact.index;
    const ModeSums<double>& m = s.sums;
    const double tau = pi<double>() / 4, beta = s.state.beta;
    const double cosine = paper::monoharmonic_cosine(m.V[0], m.V[j], m.U[j], m.G[0], beta);
    const double sine = paper::monoharmonic_sine(m.V[0], m.V[j], m.U[j], m.U[0], beta);
    return {paper::monoharmonic_displacement(tau, printed_x_0(s), printed_v_0(s)),
            paper::monoharmonic_displacement(tau, cosine, sine)};
}

std::pair<double, double> monoharmonic_cosines(const SlidingScene& s) {
    const std::size_t j = s.sums.contact.index;
    const ModeSums<double>& m = s.sums;
    return {as_printed::monoharmonic_cosine(m.V[0], m.V[j], m.U[j], m.G[0], s.state.beta),
            paper::monoharmonic_cosine(m.V[0], m.V[j], m.U[j], m.G[0], s.state.beta)};
}

std::pair<double, double> monoharmonic_amplitudes(const SlidingScene& s) {
    const std::size_t j = s.sums.contact.index;
    const ModeSums<double>& m = s.sums;
    return {as_printed::displacement_transmissibility(m.V[0], m.V[j], m.U[j], m.U[0], m.G[0], s.state.beta),
            paper::displacement_transmissibility(m.V[0], m.V[j], m.U[j], m.U[0], m.G[0], s.state.beta)};
}

} // namespace

std::vector<RefutationScene> scenes_of_motions() {
    const double zeta = 0.1;
    const System<double> five = five_masses<double>(3, zeta), single = single_mass<double>(zeta);
    const auto of_five = [&](const std::string& equation, const std::function<Compared(const SlidingScene&)>& compared) {
        return RefutationScene{equation, "the five masses of Fig. 5, damping ratios 0.1", five, 1, 0.9, 0.2, true, compared};
    };
    const auto of_one = [&](const std::string& equation, const std::function<Compared(const SlidingScene&)>& compared) {
        return RefutationScene{equation, "the single mass of Fig. 6, damping ratio 0.1", single, 1, 0.9, 0.2, true, compared};
    };
    const auto of_two = [&](const std::string& equation, const std::function<Compared(const SlidingScene&)>& compared) {
        const System<double> two = denhartog::equal_chain<double>(2, 2, 1, {0.016, 0.006}); // Figs. 8 to 10, rounded
        return RefutationScene{equation, "the two masses of Figs. 8 to 10", two, 1, 1, 0.2, true, compared};
    };
    const std::string of_first = " of mass 1", units = in_units_of_load;
    return {of_one("40", start_of_first_mode),
            of_one("A.15", start_of_first_mode),
            of_one("41", start_of_contact),
            of_one("46", amplitude_of_contact),
            of_one("A.7", velocity_of_first_mode),
            of_five("44", first_mass("displacement" + of_first + " at tau = 0" + units,
                                     [](const SlidingScene& s) { return std::pair(printed_x_0(s), s.state.masses[0].x0); })),
            of_five("45", first_mass("velocity" + of_first + " at tau = 0" + units,
                                     [](const SlidingScene& s) { return std::pair(printed_v_0(s), s.state.masses[0].v0); })),
            of_five("49", first_mass("monoharmonic displacement" + of_first + " at tau = pi/4" + units, monoharmonic_motions)),
            of_two("50", first_mass("factor of the cosine in the motion" + of_first + units, monoharmonic_cosines)),
            of_five("52", first_mass("monoharmonic amplitude" + of_first + units, monoharmonic_amplitudes))};
}

} // namespace denhartog::derivation
