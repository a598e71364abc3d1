// The motion of the masses while the contact is held, and where it may rest: `set_stuck_response`, by `held_response` of
// `stick_slip/bounds_of_equations.cpp`. Before it comes (88) as printed. Declared in `models_in_double.hpp`.
#include "denhartog/answer/models_in_double.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/answer/certify.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

using std::abs;

// A number that is written as a double has to be one.
void require_in_range(double number, int what) {
    if (!std::isfinite(number)) throw PrecisionError({Why::out_of_double, what}, Outcome::out_of_range);
}

// (88) as printed: modes of the masses on the load's side of the contact, damping read from the diagonal.
std::optional<Certified> limit_by_88(const Scene<double>& scene, const StuckConfiguration& stuck,
                                     const Matrix<double>& error_of_C) {
    const System<double>& s = scene.system;
    const Bounded<double> mu = as_input(scene.mu), r = as_input(*scene.r);
    const std::optional<StuckChain> chain = stuck_chain(s, stuck);
    if (!chain) return std::nullopt;
    if (!chain->kappa) return certified(paper::sticking_limit_under_load(mu));
    const auto n = static_cast<Eigen::Index>(chain->masses.size()),
               first = static_cast<Eigen::Index>(chain->masses.front().index);
    const Mass loaded = load_row(s);
    const bool before = loaded.index < s.contact.index;
    const Eigen::Index first_held = before ? first : first - 1, load = static_cast<Eigen::Index>(loaded.index) - first;
    System<double> moving; // as much of it as the bounds need
    moving.mass_ratios.assign(s.mass_ratios.begin() + first, s.mass_ratios.begin() + first + n);
    moving.stiffness_ratios.assign(s.stiffness_ratios.begin() + first, s.stiffness_ratios.begin() + first + n);
    moving.damping_matrix = stuck.C.block(first_held, first_held, n, n);
    const Matrix<double> left_out = error_of_C.block(first, first, n, n);
    const ModalBasis<Bounded<double>> modes =
        with_errors(moving, ModalBasis<double>{chain->r_n, chain->phi, chain->zeta, {}, 0.0});
    Complex<Bounded<double>> X{Bounded<double>(0), Bounded<double>(0)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const Bounded<double>& r_n = modes.r_n[static_cast<std::size_t>(i)];
        const Column size = chain->phi.col(i).cwiseAbs();
        Bounded<double> D = Bounded<double>(2) * modes.zeta[static_cast<std::size_t>(i)] * r_n;
        D.e += 2.0 * size.dot(product(left_out, size));
        const Bounded<double> a((r_n - r) * (r_n + r)), b(r * D);
        if (abs(a.x) <= a.e && abs(b.x) <= b.e) return std::nullopt; // a resonance
        X = X + modes.phi(before ? n - 1 : 0, i) * amplitude_of_mode(modes.phi(load, i), a, b);
    }
    const Bounded<double> limit = paper::sticking_limit_by_spring(as_input(*chain->kappa), modulus(X), mu);
    require_in_range(limit.x, 1);
    return certified(limit);
}

// A mass of a complex amplitude; `largest` is that of all masses.
SolvedMass mass_of(const Complex<Bounded<double>>& X, double largest) {
    SolvedMass mass{exactly(0), std::nullopt, std::nullopt};
    const double amplitude = elementary::hypot(X.re.x, X.im.x), error = X.re.e + X.im.e + 2 * unit_of<double>() * amplitude;
    if (does_not_move(amplitude, error, largest)) {
        mass.amplitude.error = amplitude + error;
        return mass;
    }
    const double error_of_phase = error < amplitude ? largest_turn(error, amplitude) + 4 * unit_of<double>() : pi<double>();
    mass.amplitude = certified({amplitude, error});
    mass.phase = certified({-elementary::atan2(X.im.x, X.re.x), error_of_phase});
    return mass;
}

} // namespace

void set_stuck_response(const Scene<double>& scene, const StuckConfiguration& stuck, const ModalBasis<Bounded<double>>& basis,
                        std::optional<Mass> only, Solution& s) {
    const System<double>& system = scene.system;
    const Matrix<double> error_of_C = errors_of_C(system, basis);
    const HeldResponse held = held_response(scene, stuck, error_of_C);
    const Bounded<double> compliance = compliance_of(stuck);
    const std::optional<Bounded<double>> frame = amplitude_of_frame(system.base_motion, as_input(*scene.r));
    double largest = held.load.x * compliance.x; // no mass moves where the load acts on the contact
    for (const Complex<Bounded<double>>& X : held.X) largest = std::max(largest, modulus(X).x);
    const SolvedMass at_rest{exactly(0), std::nullopt, std::nullopt};
    s.masses.clear();
    s.from_ground.clear();
    s.relative_error = 0;
    for (std::size_t k = 0; k < held.X.size(); ++k) {
        const Complex<Bounded<double>>& X = held.X[k];
        if (frame) s.from_ground.push_back(from_ground(mass_of({X.re + *frame, X.im}, std::max(largest, frame->x)), *frame));
        const SolvedMass& m = s.masses.emplace_back(k == contact_row(system).index ? at_rest : mass_of(X, largest));
        if (!m.phase || (only && k != only->index)) continue;
        s.relative_error =
            std::max({s.relative_error, m.amplitude.value > 0 ? m.amplitude.error / m.amplitude.value : 1.0, m.phase->error});
    }
    if (contact_moves_apart(system)) s.masses.push_back(at_rest);
    Bounded<double> to = (as_input(scene.mu) * as_input(*scene.beta) - held.load) * compliance;
    if (!std::isfinite(to.e)) {
        to.e = std::numeric_limits<double>::infinity();
        s.relative_error = std::max(s.relative_error, 1.0);
    }
    to.x = std::max(to.x, 0.0); // on the boundary rounding may leave less than nothing
    require_in_range(to.x, 2);
    s.rest_interval = {certified(-to), certified(to), std::nullopt};
    s.sticking_by_88 = limit_by_88(scene, stuck, error_of_C);
}

std::optional<Certified> sticking_by_88(const Scene<double>& scene) {
    const ModalBasis<Bounded<double>> basis = with_errors(scene.system, modal_basis(scene.system));
    return limit_by_88(scene, stuck_configuration(scene.system, values_of(basis)), errors_of_C(scene.system, basis));
}

} // namespace denhartog
