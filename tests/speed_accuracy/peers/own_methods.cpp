#include "tests/speed_accuracy/peers/peers.hpp"

#include <algorithm>
#include <numbers>
#include <variant>

#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/speed_accuracy/peers/closed_form_peers.hpp"
#include "tests/speed_accuracy/table.hpp"
#include "tests/support/closed_form.hpp"

namespace denhartog::tests {
namespace {

Scene<double> scene_of(const System<double>& system, const ChartPoint& point) {
    Scene<double> scene;
    scene.system = system;
    scene.r = point.r;
    scene.beta = point.beta;
    return scene;
}

ModalBasis<double> basis_in_double(const System<double>& system) { return modal_basis(system); }
ModalBasis<float> basis_in_float(const System<double>& system) { return rounded<float>(modal_basis(system)); }
ModalBasis<long double> basis_in_long_double(const System<double>& system) {
    return rounded<long double>(modal_basis(converted<Real50>(scene_of(system, {1, 0})).system));
}

// In float and long double the boundaries are not built; the forms of the modes are.
template <class T, class Basis>
Peer shipped_forms_of_modes(const std::string& setting, const Basis& basis) {
    return {"closed form as shipped", setting, 0, [basis](const System<double>& system) {
                const auto modes = std::make_shared<const ModalBasis<T>>(basis(system));
                return [modes, j = system.contact, l = system.load](const ChartPoint& point) {
                    return closed_form_at(*modes, j, l, point, evaluation::mode_functions<T>);
                };
            }};
}

Peer paper_algorithm_peer(double tolerance, bool as_needed) {
    const std::string cycles = as_needed ? "cycles as damping needs" : "200 cycles";
    return {"paper's Runge-Kutta, " + cycles, tolerance_text(tolerance), tolerance, [=](const System<double>& system) {
                return [=, decay = slowest_decay(system)](const ChartPoint& point) {
                    PaperSettings settings;
                    settings.absolute_tolerance = tolerance;
                    settings.most_steps = 300'000;
                    if (as_needed) settings.cycles = cycles_needed(decay, point.r, tolerance);
                    const PaperMotion motion = paper_algorithm(scene_of(system, point), settings);
                    PeerAnswer answer;
                    answer.evaluations = motion.right_hand_sides;
                    switch (motion.status) {
                    case IntegrationStatus::complete: break;
                    case IntegrationStatus::chattering: answer.ending = Ending::stalled; return answer;
                    case IntegrationStatus::step_limit: answer.ending = Ending::did_not_finish; return answer;
                    case IntegrationStatus::overflow: answer.ending = Ending::not_a_number; return answer;
                    }
                    answer.sticks = regime_seen(motion) != Regime::continuous;
                    set_amplitude(answer, motion.masses[system.contact.index].amplitude);
                    return answer;
                };
            }};
}

Peer solve_peer(int digits) {
    return {"solve", std::to_string(digits) + " digits", std::pow(10.0, -digits), [=](const System<double>& system) {
                const Question question = question_of_chart(system, digits);
                const auto prepared = std::make_shared<const PreparedSystem>(
                    prepare(scene_source(Scene<double>{system, 1, {}, {}, {}, {}}), question));
                return [=](const ChartPoint& point) {
                    PeerAnswer answer;
                    try {
                        const Solution s = solve(*prepared, point.r, point.beta, question);
                        answer.evaluations = s.work.mode_evaluations + s.work.phases_propagated;
                        answer.sticks = s.regime.regime != Regime::continuous;
                        const Certified& X_j = s.masses.front().amplitude;
                        if (X_j.decimal.empty())
                            set_amplitude(answer, X_j.value);
                        else
                            set_amplitude(answer, Real50(X_j.decimal));
                    } catch (const PrecisionError&) {
                        answer.ending = Ending::did_not_finish;
                    }
                    return answer;
                };
            }};
}

} // namespace

Question question_of_chart(const System<double>& system, int digits) { return {Asked::amplitude, digits, false, system.contact}; }

std::string tolerance_text(double tolerance) { return digits(tolerance, "%.0e"); }

std::vector<double> chart_tolerances() { return {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}; }

double slowest_decay(const System<double>& system) {
    const ModalBasis<double> basis = modal_basis(system);
    double slowest = basis.zeta[0] * basis.r_n[0];
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) slowest = std::min(slowest, basis.zeta[i] * basis.r_n[i]);
    return slowest;
}

int cycles_needed(double decay, double r, double tolerance) {
    return static_cast<int>(std::clamp(std::ceil(-std::log(tolerance) * r / (2 * std::numbers::pi * decay)), 20.0, 20000.0));
}

std::vector<Peer> printed_form_peers() {
    return {printed_form_peer<float>("float", basis_in_float), printed_form_peer<double>("double", basis_in_double),
            printed_form_peer<long double>("long double", basis_in_long_double), closed_form_peers_in_50_digits()[0]};
}

std::vector<Peer> shipped_form_peers() {
    return {shipped_forms_of_modes<float>("float", basis_in_float), shipped_form_peer<double>("double", basis_in_double),
            shipped_forms_of_modes<long double>("long double", basis_in_long_double), closed_form_peers_in_50_digits()[1]};
}

Peer exact_solver_peer() {
    return {"exact solver", "double", 0, [](const System<double>& system) {
                const auto prepared = std::make_shared<const ContactSystem>(contact_system(system));
                const auto solver = std::make_shared<ExactSolver>(*prepared, Excitation{1, 0, 1});
                return [prepared, solver](const ChartPoint& point) {
                    solver->set({point.r, point.beta, 1});
                    OrbitSearch search;
                    search.contact_only = true;
                    search.with_stability = false;
                    const long before = phases_propagated();
                    const PeriodicOrbit orbit = periodic_orbit(*solver, at_rest(prepared->basis.r_n.size()), search);
                    PeerAnswer answer;
                    answer.evaluations = phases_propagated() - before;
                    answer.sticks = orbit.status == OrbitStatus::permanently_stuck || !orbit.stops.empty();
                    if (!is_from_start(orbit))
                        answer.ending = Ending::did_not_finish;
                    else if (orbit.status == OrbitStatus::periodic)
                        set_amplitude(answer, orbit.contact.amplitude);
                    else
                        set_amplitude(answer, std::abs(orbit.start.x[prepared->contact.index]));
                    return answer;
                };
            }};
}

std::vector<Peer> paper_algorithm_peers() {
    std::vector<Peer> peers;
    for (const bool as_needed : {false, true})
        for (const double tolerance : chart_tolerances()) peers.push_back(paper_algorithm_peer(tolerance, as_needed));
    return peers;
}

std::vector<Peer> solve_peers() {
    std::vector<Peer> peers;
    for (const int digits : {2, 4, 8, 12, 15, 30}) peers.push_back(solve_peer(digits));
    return peers;
}

std::vector<Peer> own_peers() {
    std::vector<Peer> peers;
    for (const auto& some :
         {printed_form_peers(), shipped_form_peers(), std::vector{exact_solver_peer()}, paper_algorithm_peers(), solve_peers()})
        peers.insert(peers.end(), some.begin(), some.end());
    return peers;
}

} // namespace denhartog::tests
