#include "denhartog/response/bounded_response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace denhartog {
namespace {

std::vector<double> values_of(const std::vector<Bounded>& numbers) {
    std::vector<double> values;
    values.reserve(numbers.size());
    for (const Bounded& number : numbers) values.push_back(number.x);
    return values;
}

std::vector<Complex<double>> values_of(const std::vector<Complex<Bounded>>& numbers) {
    std::vector<Complex<double>> values;
    values.reserve(numbers.size());
    for (const Complex<Bounded>& number : numbers) values.push_back({number.re.x, number.im.x});
    return values;
}

ModeSums<double> values_of(const ModeSums<Bounded>& s) {
    return {s.r.x,
            s.contact,
            s.load,
            values_of(s.R),
            values_of(s.zeta),
            values_of(s.psi),
            values_of(s.v),
            values_of(s.u),
            values_of(s.g),
            values_of(s.V),
            values_of(s.U),
            values_of(s.G),
            {s.Y_jj.re.x, s.Y_jj.im.x},
            s.H_j.x,
            s.sum_of_squares.x};
}

// Twice what separates a number from the bounded one and that one from the truth: the instants of maxima are not followed.
double error_of(double x, const Bounded& bounded) { return 2 * (std::abs(x - bounded.x) + bounded.e); }

double error_of_phase(double phase, const Bounded& bounded) { return 2 * (std::abs(wrapped(phase - bounded.x)) + bounded.e); }

double relative(double error, double size) { return error == 0 ? 0 : size > 0 ? error / size : 1; }

void bound_boundary(BoundedResponse& all, const Boundary<Bounded>& bounded, BoundaryError<double>& error) {
    const Boundary<double>& b = all.response.boundary;
    error = {error_of(b.exact, bounded.exact), 0};
    all.relative = std::max({relative(error.exact, b.exact), relative(error_of(b.paper, bounded.paper), b.paper),
                             relative(error_of(b.approximate, bounded.approximate), b.approximate)});
    if (b.sticking.has_value() != bounded.sticking.has_value()) all.relative = 1;
    if (!b.sticking || !bounded.sticking) return;
    error.sticking = error_of(*b.sticking, *bounded.sticking);
    all.relative = std::max(all.relative, relative(error.sticking, *b.sticking));
}

void bound_masses(BoundedResponse& all, const SteadyState<Bounded>& bounded) {
    std::vector<MassResponse<double>>& masses = all.response.steady_state->masses;
    double largest = 0;
    for (const MassResponse<double>& m : masses) largest = std::max(largest, m.amplitude);
    for (std::size_t k = 0; k < masses.size(); ++k) {
        MassResponse<double>& m = masses[k];
        const MassResponse<Bounded>& b = bounded.masses[k];
        m.error_bound = std::max({error_of(m.x0, b.x0), error_of(m.v0, b.v0), error_of(m.amplitude, b.amplitude),
                                  error_of(m.amplitude_monoharmonic, b.amplitude_monoharmonic)});
        all.phase_error.push_back(
            std::max(error_of_phase(m.phase, b.phase), error_of_phase(m.phase_monoharmonic, b.phase_monoharmonic)));
        if (m.amplitude <= m.error_bound && m.error_bound <= largest * std::numeric_limits<double>::epsilon() * 1024)
            continue; // a mass that does not move
        all.relative = std::max({all.relative, relative(m.error_bound, m.amplitude), all.phase_error.back()});
    }
}

} // namespace

Bounded as_input(double x) { return {x, std::numeric_limits<double>::epsilon() * std::abs(x)}; }

ModalBasis<Bounded> with_errors(const System<double>& system, const ModalBasis<double>& basis) {
    const std::size_t N = basis.r_n.size();
    const double unit = 8 * static_cast<double>(N) * std::numeric_limits<double>::epsilon();
    const bool chain = !system.stiffness_ratios.empty() && !system.mass_ratios.empty();
    const double highest = basis.r_n.back();
    ModalBasis<Bounded> bounded;
    bounded.phi.resize(static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(N));
    for (std::size_t i = 0; i < N; ++i) {
        const double& r_n = basis.r_n[i];
        const double of_square = chain ? 2 * unit * r_n * r_n : unit * highest * highest; // error of the squared frequency
        bounded.r_n.emplace_back(r_n, of_square / (2 * r_n));
        bounded.zeta.push_back(as_input(basis.zeta[i]));
        double nearest = std::numeric_limits<double>::infinity(); // difference of the squares, of the chain's relative to both
        for (const std::size_t n : {i - 1, i + 1}) {
            if (n >= N) continue;
            const double apart = std::abs(basis.r_n[n] - r_n) * (basis.r_n[n] + r_n);
            nearest = std::min(nearest, chain ? apart * r_n / std::max(basis.r_n[n], r_n) : apart);
        }
        const double turn = std::min(1.0, N == 1 ? unit : of_square / nearest + unit);
        const auto column = static_cast<Eigen::Index>(i);
        const double size = basis.phi.col(column).norm();
        for (std::size_t k = 0; k < N; ++k) {
            const auto row = static_cast<Eigen::Index>(k);
            bounded.phi(row, column) = Bounded(basis.phi(row, column), turn * size);
        }
    }
    return bounded;
}

BoundedModes::BoundedModes(const Scene<double>& scene, const ModalBasis<double>& basis)
    : basis_(with_errors(scene.system, basis)), r_(as_input(*scene.r)), known_(basis.r_n.size()) {}

const evaluation::ModeFunctions<Bounded>& BoundedModes::at(std::size_t i) {
    if (!known_[i]) known_[i] = mode_functions_at(basis_, i, r_);
    return *known_[i];
}

std::vector<evaluation::ModeFunctions<Bounded>> BoundedModes::all() {
    std::vector<evaluation::ModeFunctions<Bounded>> functions;
    for (std::size_t i = 0; i < known_.size(); ++i) functions.push_back(at(i));
    return functions;
}

BoundedResponse bounded_response(const Scene<double>& scene, BoundedModes& modes, bool with_motion) {
    const Mass contact = scene.system.contact;
    const Bounded beta = as_input(*scene.beta), mu = as_input(scene.mu);
    const ModeSums<Bounded> bounded = mode_sums(modes.basis(), contact, scene.system.load, modes.r(), modes.all());
    const ModeSums<double> sums = values_of(bounded);
    BoundedResponse all{{*scene.r, scene.mu, scene.beta, contact, boundary(sums, scene.mu), std::nullopt, std::nullopt}, 0, {}};
    Response<double>& response = all.response;
    std::vector<Bounded> instants(response.boundary.instants.begin(), response.boundary.instants.end());
    BoundaryError<double> error{};
    bound_boundary(all, boundary_at(bounded, mu, Bounded(response.boundary.instant), instants), error);
    response.regime = regime_at(response.boundary, *scene.beta, error);
    if (response.regime->regime != Regime::continuous || !with_motion) return all;
    response.steady_state = steady_state(sums, response.boundary, *scene.beta);
    instants.clear();
    for (const MassResponse<double>& m : response.steady_state->masses) instants.emplace_back(m.instant);
    bound_masses(all, steady_state_at(bounded, beta, instants));
    return all;
}

} // namespace denhartog
