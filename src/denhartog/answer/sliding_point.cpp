// Boundary, regime and steady state where the contact slides throughout, (38) to (53) and (69), in double. Read
// `sliding_solution`.
#include "denhartog/answer/models_in_double.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "denhartog/answer/certify.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"

namespace denhartog {
namespace {

using Number = Bounded<double>;

Boundary<Number> boundary_with(const ModeSums<Number>& sums, const Number& mu, const std::vector<double>& demands) {
    return boundary_at(sums, mu, Number(demands.front()), std::vector<Number>(demands.begin() + 1, demands.end()));
}

Attempted errors_of_boundary(const Boundary<Number>& b) {
    Attempted all{std::max({relative_error(b.exact), relative_error(b.paper), relative_error(b.approximate)})};
    if (b.sticking) all.relative = std::max(all.relative, relative_error(*b.sticking));
    return all;
}

// Far off in frequency a boundary leaves the range of a double; where modes are not told apart it has no bound.
void require_finite(const Boundary<Number>& b) {
    const bool in_range = std::isfinite(b.exact.x + b.paper.x + b.approximate.x);
    if (!in_range || !std::isfinite(b.exact.e))
        throw PrecisionError(Why::boundary_out_of_range, in_range ? Outcome::digits_missing : Outcome::out_of_range);
}

double error_of_masses(const SteadyState<Number>& state, std::optional<Mass> only) {
    double largest = 0;
    for (const auto& m : state.masses) largest = std::max(largest, m.amplitude.x);
    double error = 0;
    for (std::size_t k = 0; k < state.masses.size(); ++k) {
        if (only && k != only->index) continue;
        const MassResponse<Number>& m = state.masses[k];
        const double error_of_mass = std::max({m.x0.e, m.v0.e, m.amplitude.e, m.amplitude_monoharmonic.e});
        // If one mass alone is asked about, double cannot tell whether it moves.
        if (!only && does_not_move(m.amplitude.x, error_of_mass, largest)) continue;
        error = std::max(
            {error, relative_error(Number{m.amplitude.x, error_of_mass}), as_error(m.phase.e), as_error(m.phase_monoharmonic.e)});
    }
    return error;
}

// Errors of displacements over the half-period by those of the sums: a multiple of the errors at its start.
std::vector<double> errors_of_displacements(const SteadyState<Number>& state) {
    std::vector<double> errors;
    errors.reserve(state.masses.size());
    for (const MassResponse<Number>& m : state.masses) errors.push_back(4 * std::max(m.x0.e, m.v0.e));
    return errors;
}

// (56) of the modes by themselves, where the coupling by a damping matrix makes no difference to (69) that anybody could measure.
// Where double leaves that open the bound takes in both.
Number paper_limit(const Scene<double>& scene, ModalBasis<Number> basis, const Boundary<Number>& coupled, Effort* effort) {
    const Matrix<double> D = basis.D.unaryExpr([](const Number& entry) { return entry.x; });
    if (largest_coupling(D) > hardly_coupled) return coupled.paper;
    const bool couples = basis.couples;
    basis.D.resize(0, 0);
    basis.couples = false;
    const ModeSums<Number> sums = mode_sums(basis, contact_row(scene.system), load_rows(scene.system), as_input(*scene.r));
    const Boundary<Number> b = boundary_with(sums, as_input(scene.mu), SearchedSums(sums, effort).demands());
    const double change = std::abs(b.exact.x - coupled.exact.x), most = hardly_changed * coupled.exact.x;
    Number paper = change <= most ? b.paper : coupled.paper;
    if (couples ? std::abs(change - most) <= b.exact.e + coupled.exact.e : change > most)
        paper.e = std::abs(b.paper.x - coupled.paper.x) + std::max(b.paper.e, coupled.paper.e);
    return paper;
}

// Next to a pole the numbers are those of rounding: one unit in the last place of r changes them by a tenth and more.
void check_poles(const ModalBasis<Number>& basis, const System<double>& system, double r) {
    constexpr double units = 8;
    for (std::size_t i = 0; i < basis.r_n.size() && !basis.coupled(); ++i) {
        const double R = r / basis.r_n[i].x;
        if (basis.zeta[i].x == 0 && std::abs(R - 1) <= units * unit_of<double>() && is_excited(basis, system, i))
            throw DomainError({Why::pole_by_rounding, i + 1, R, R == 1});
    }
}

SolvedMass solved_mass(const MassResponse<Number>& m, bool with_motion) {
    SolvedMass mass{certified(m.amplitude), std::nullopt, std::nullopt};
    if (m.amplitude.x > m.amplitude.e) mass.phase = certified(m.phase);
    const Number instant(m.instant.x, mass.phase ? m.instant.e : pi<double>()); // a mass that does not move has none
    if (with_motion)
        mass.sliding = SlidingOfMass{certified(m.x0), certified(m.v0), certified(instant), certified(m.amplitude_monoharmonic),
                                     certified(m.phase_monoharmonic)};
    return mass;
}

// Sums whose displacements are absolute; friction knows the relative one of the contact alone, the row behind those of the
// masses.
ModeSums<Number> sums_from_ground(const ModeSums<Number>& s, std::size_t N, BaseMotion motion, const Number& b) {
    ModeSums<Number> seen = s;
    const std::size_t j = s.contact.index;
    seen.V.assign(s.V.begin(), s.V.begin() + static_cast<std::ptrdiff_t>(N));
    for (Complex<Number>& V_k : seen.V) V_k = response_from_ground(V_k, motion, b);
    seen.U.resize(N);
    seen.G.resize(N);
    seen.V.push_back(s.V[j]);
    seen.U.push_back(s.U[j]);
    seen.G.push_back(s.G[j]);
    const auto psi_j = mode_shapes_at(s, s.contact);
    seen.psi.resize(N * s.R.size());
    seen.psi.insert(seen.psi.end(), psi_j.begin(), psi_j.end());
    seen.contact = seen.load = Mass{N};
    seen.load_im.reset();
    return seen;
}

// From a frame that moves by b; none where displacements are absolute.
std::vector<MassFromGround> masses_from_ground(const System<double>& system, const std::optional<Number>& b,
                                               const ModeSums<Number>& sums, const Number& beta, Effort* effort) {
    std::vector<MassFromGround> seen;
    if (!b) return seen;
    const std::size_t N = number_of_masses(system);
    SearchedSums from_there(sums_from_ground(sums, N, system.base_motion, *b), effort);
    const SteadyState<Number> state = from_there.steady_state(beta, std::nullopt, true);
    for (std::size_t k = 0; k < N; ++k) seen.push_back(from_ground(solved_mass(state.masses[k], false), *b));
    return seen;
}

// The regime by the boundary, and that by (56), if it differs.
void set_regime(const Boundary<Number>& b, double beta, Solution& s) {
    s.regime = regime_at(b, beta);
    RegimeBoundary<Number> by_56 = b;
    by_56.exact = b.paper;
    const Regime other = regime_of(by_56, Number(beta));
    if (other != regime_of<Number>(b, Number(beta))) s.regime_by_56 = other;
}

} // namespace

bool is_excited(const ModalBasis<Number>& basis, const System<double>& system, std::size_t mode) {
    const auto reaches = [&](Mass row) {
        const Number& p = basis.phi(static_cast<Eigen::Index>(row.index), static_cast<Eigen::Index>(mode));
        return std::abs(p.x) > p.e;
    };
    const LoadRows load = load_rows(system);
    return reaches(load.re) || (load.im && reaches(*load.im));
}

FrictionMotions& SearchedSums::motions() {
    constexpr std::size_t most_remembered = std::size_t(1) << 16;
    if (!motions_ || motions_->remembered() > most_remembered) motions_.emplace(values(), effort_);
    return *motions_;
}

std::vector<double> SearchedSums::demands() {
    if (largest_at_start(sums_)) return std::vector<double>(sums_.R.size() + 1, 0.0);
    return instants_of_demands(motions());
}

SteadyState<Number> SearchedSums::steady_state(const Number& beta, std::optional<Mass> only, bool with_rivals) {
    SteadyState<Number> state = steady_state_without_maxima(sums_, beta);
    if (only ? *only == sums_.contact : state.masses.size() == 1) return state; // the contact has a closed form
    const InstantsOfMaxima maxima =
        instants_of_maxima(motions(), beta.x, only, with_rivals ? errors_of_displacements(state) : std::vector<double>());
    state = with_maxima(sums_, std::move(state), {maxima.instants.begin(), maxima.instants.end()}, only);
    for (std::size_t k = 0; k < maxima.spreads.size(); ++k) {
        MassResponse<Number>& m = state.masses[k];
        if (!(maxima.spreads[k] > 0)) continue;
        m.phase.e += maxima.spreads[k];
        m.instant.e = pi<double>();
    }
    return state;
}

void set_point(const System<double>& system, double r, std::optional<double> beta, double mu, Asked asked, Solution& s) {
    s.asked = asked;
    s.contact = system.contact;
    s.r = exactly(r);
    s.mu = exactly(mu);
    if (beta) s.beta = exactly(*beta);
    if (const auto base = amplitude_of_base(system.base_motion, as_input(r))) s.base_amplitude = certified(*base);
}

Solution sliding_solution(const SceneSource& source, const Question& question, std::shared_ptr<const ModalBasis<Number>> modes) {
    const Aim aim = aim_of(question.digits);
    const Scene<double>& scene = source->in_double();
    const Asked asked = question.asked;
    Effort* effort = source->effort;
    if (!modes) check(scene);
    (void)frequency_ratio_of(scene);
    if (!modes) modes = modes_with_errors(scene.system, effort);
    check_poles(*modes, scene.system, *scene.r);
    SearchedSums at(bounded_sums(scene.system, *modes, as_input(*scene.r), effort), effort);
    Boundary<Number> b = boundary_with(at.sums(), as_input(scene.mu), at.demands());
    if (at.sums().coupled) b.paper = paper_limit(scene, *modes, b, effort);
    require_finite(b);
    Solution s{};
    set_point(scene.system, *scene.r, scene.beta, scene.mu, asked, s);
    s.limits = Limits{certified(b.exact), certified(b.paper), certified(b.approximate), std::nullopt, b.binding};
    if (b.sticking) s.limits->sticking = certified(*b.sticking);
    Attempted attempted{0};
    if (asked == Asked::motion || asked == Asked::regime || !scene.beta) attempted = errors_of_boundary(b);
    if (scene.beta) set_regime(b, *scene.beta, s);
    attempted.decided = !s.regime.on_boundary;
    const char* model = "boundary of the sliding regime";
    // Where mu > 1 the motion from rest may be the sliding one, whatever is asked.
    if (scene.beta && s.regime.regime == Regime::continuous && (asked != Asked::regime || scene.mu > 1)) {
        const SteadyState<Number> state = at.steady_state(as_input(*scene.beta), question.mass, true);
        attempted.relative = std::max(attempted.relative, error_of_masses(state, question.mass));
        for (const MassResponse<Number>& m : state.masses) s.masses.push_back(solved_mass(m, asked == Asked::motion));
        if (asked == Asked::motion && !question.mass)
            s.from_ground = masses_from_ground(scene.system, amplitude_of_frame(scene.system.base_motion, as_input(*scene.r)),
                                               at.sums(), state.beta, effort);
        model = "closed form";
    }
    s.method = {model, "double", verdict(attempted, aim)};
    s.relative_error = attempted.relative;
    s.digits_reached = s.relative_error <= aim.tolerance;
    return s;
}

} // namespace denhartog
