#include "tests/support/second_witness.hpp"

#include <algorithm>
#include <array>

#include "tests/support/rotations.hpp"

namespace denhartog {
namespace {

using Index = Eigen::Index;

/// |a - b|; a number that is not finite is no small difference.
template <class W>
W distance(const W& a, const W& b) {
    const W difference = a < b ? W(b - a) : W(a - b);
    if (!(difference - difference == W(0)))
        throw DomainError("the motion that is compared with the second witness is not finite");
    return difference;
}

template <class W>
W angle_between(const W& a, const W& b) {
    return distance(W(atan2(sin(W(a - b)), cos(W(a - b)))), W(0));
}

// The errors of an agreement; the first five are those of the motion.
template <class T>
constexpr std::array figures{&Agreement<T>::displacement, &Agreement<T>::x_0,   &Agreement<T>::x_prime_0,
                             &Agreement<T>::amplitude,    &Agreement<T>::phi_j, &Agreement<T>::phase};

} // namespace

template <class T>
HalfPeriodProblem<WitnessOf<T>> half_period_problem(const Scene<T>& scene) {
    using W = WitnessOf<T>;
    check(scene);
    if (!scene.r) throw InputError("r", "must be given", "");
    if (!scene.beta) throw InputError("beta", "must be given", "");
    const W r = static_cast<W>(*scene.r);
    const Matrix<W> M = mass_of<W>(scene.system);
    const Matrix<W> K = stiffness_of<W>(scene.system);
    const Matrix<W> C = damping_of<W>(scene.system, M, K);
    HalfPeriodProblem<W> p{M * W(r * r), C * r, K, scene.system.contact, scene.system.load, static_cast<W>(*scene.beta)};
    if (scene.system.contact_with) {
        p.w = Vector<W>::Zero(M.rows());
        p.w(static_cast<Index>(scene.system.contact.index)) = W(1);
        p.w(static_cast<Index>(scene.system.contact_with->index)) = W(-1);
    }
    if (const std::vector<T>& w = scene.system.contact_direction; !w.empty()) {
        p.w.resize(M.rows());
        for (Index k = 0; k < M.rows(); ++k) p.w(k) = static_cast<W>(w[static_cast<std::size_t>(k)]);
    }
    p.p.resize(static_cast<Index>(scene.system.load_vector.size()));
    for (Index k = 0; k < p.p.size(); ++k) p.p(k) = static_cast<W>(scene.system.load_vector[static_cast<std::size_t>(k)]);
    if (load_depends_on_frequency(scene.system)) { // springs and dampers of what moves, and inertia in the frame of a wall
        const Vector<W> ones = Vector<W>::Ones(M.rows());
        const bool wall = scene.system.base_motion == BaseMotion::wall;
        p.p = wall ? Vector<W>(p.M * ones - p.K * ones) : Vector<W>(p.K * ones);
        p.p_i = wall ? Vector<W>(-(p.C * ones)) : Vector<W>(p.C * ones);
        return p;
    }
    if (scene.system.load_phases.empty()) return p;
    p.p_i.resize(p.p.size());
    for (Index k = 0; k < p.p.size(); ++k) {
        const W theta = static_cast<W>(scene.system.load_phases[static_cast<std::size_t>(k)]), force = p.p(k);
        p.p(k) = force * cos(theta);
        p.p_i(k) = force * sin(theta);
    }
    return p;
}

template <class T>
SampledMotion<T> sampled_motion(const ModeSums<T>& sums, const SteadyState<T>& state, int steps) {
    const Index N = static_cast<Index>(state.masses.size());
    SampledMotion<T> sampled{Vector<T>(N), Vector<T>(N), Vector<T>(N), Vector<T>(N), sums.contact, Matrix<T>(N, steps + 1)};
    for (Index k = 0; k < N; ++k) {
        const MassResponse<T>& m = state.masses[static_cast<std::size_t>(k)];
        sampled.x_0(k) = m.x0;
        sampled.x_prime_0(k) = m.v0;
        sampled.amplitude(k) = m.amplitude;
        sampled.phase(k) = m.phase;
    }
    for (int n = 0; n <= steps; ++n) {
        const Motion<T> at = motion(sums, state, T(n * pi<T>() / steps));
        for (Index k = 0; k < N; ++k) sampled.x(k, n) = at.x[static_cast<std::size_t>(k)];
    }
    return sampled;
}

template <class T>
T worst(const Agreement<T>& a) {
    return std::max({a.displacement, a.x_0, a.x_prime_0, a.amplitude, a.phi_j});
}

template <class T>
Agreement<T> compare(const SampledMotion<T>& motion, const HalfPeriodMotion<WitnessOf<T>>& witness) {
    using W = WitnessOf<T>;
    const Index N = witness.x.rows(), j = static_cast<Index>(motion.contact.index);
    if (motion.x.rows() != N || motion.x.cols() != witness.x.cols() || motion.x_0.size() != N || motion.x_prime_0.size() != N ||
        motion.amplitude.size() != N || motion.phase.size() != N || j >= N)
        throw InputError("motion", "must be sampled as the witness's is", "");
    Agreement<W> all{};
    W largest(-1);
    for (Index k = 0; k < N; ++k) {
        const W X_k = witness.amplitude(k);
        W x_prime_scale(0), displacement(0);
        for (Index n = 0; n < witness.x.cols(); ++n) {
            x_prime_scale = std::max(x_prime_scale, distance(witness.x_prime(k, n), W(0)));
            displacement = std::max(displacement, distance(static_cast<W>(motion.x(k, n)), witness.x(k, n)));
        }
        const Agreement<W> of_mass{W(displacement / X_k),
                                   W(distance(static_cast<W>(motion.x_0(k)), witness.x_0(k)) / X_k),
                                   W(distance(static_cast<W>(motion.x_prime_0(k)), witness.x_prime_0(k)) / x_prime_scale),
                                   W(distance(static_cast<W>(motion.amplitude(k)), X_k) / X_k),
                                   k == j ? angle_between(static_cast<W>(motion.phase(k)), witness.phi_j) : W(0),
                                   angle_between(static_cast<W>(motion.phase(k)), witness.phase(k)),
                                   Mass{static_cast<std::size_t>(k)}};
        const W error = std::max({of_mass.displacement, of_mass.x_0, of_mass.x_prime_0, of_mass.amplitude});
        if (error > largest) all.worst_mass = of_mass.worst_mass;
        largest = std::max(largest, error);
        for (const auto figure : figures<W>) all.*figure = std::max(all.*figure, of_mass.*figure);
    }
    Agreement<T> rounded{};
    rounded.worst_mass = all.worst_mass;
    for (std::size_t n = 0; n < figures<T>.size(); ++n) rounded.*figures<T>[n] = static_cast<T>(all.*figures<W>[n]);
    return rounded;
}

template <class T>
Agreement<T> compare_with_second_witness(const Scene<T>& scene, int steps) {
    if (!scene.beta) throw InputError("beta", "must be given", "");
    const Response<T> answered = response(scene);
    if (!answered.steady_state)
        throw DomainError("no motion to compare with the second witness: " + in_words(answered.regime.value().reason));
    const ModeSums<T> sums = mode_sums(modal_basis(scene.system), contact_row(scene.system), load_rows(scene.system), *scene.r);
    return compare(sampled_motion(sums, *answered.steady_state, steps), half_period_motion(half_period_problem(scene), steps));
}

template HalfPeriodProblem<Real50> half_period_problem(const Scene<double>&);
template HalfPeriodProblem<Real100> half_period_problem(const Scene<Real50>&);
template HalfPeriodProblem<Real100> half_period_problem(const Scene<Real100>&);
template SampledMotion<double> sampled_motion(const ModeSums<double>&, const SteadyState<double>&, int);
template double worst(const Agreement<double>&);
template Agreement<double> compare(const SampledMotion<double>&, const HalfPeriodMotion<Real50>&);
template Agreement<double> compare_with_second_witness(const Scene<double>&, int);
template SampledMotion<Real50> sampled_motion(const ModeSums<Real50>&, const SteadyState<Real50>&, int);
template Real50 worst(const Agreement<Real50>&);
template Agreement<Real50> compare(const SampledMotion<Real50>&, const HalfPeriodMotion<Real100>&);
template Agreement<Real50> compare_with_second_witness(const Scene<Real50>&, int);

} // namespace denhartog
