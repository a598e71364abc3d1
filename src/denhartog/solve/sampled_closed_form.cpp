#include "denhartog/solve/sampled_closed_form.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "denhartog/answer/certify.hpp"
#include "denhartog/evaluation/even_samples.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/friction_motion.hpp"
#include "denhartog/solve/quantities_of_sums.hpp"

namespace denhartog {
namespace {

using evaluation::ErrorOfSamples;
using Number = Bounded<double>;

// What errors of a mode make of its brace in (40): errors of R and zeta are forces on it, by the energy that the free motion has.
ErrorOfSamples error_of_brace(const ModeSums<Number>& s, std::size_t i) {
    const double R = s.R[i].least(), of_R = s.R[i].e / R, half_period = pi<double>();
    const double energy = 1 + s.g[i].most() + s.R[i].most() * s.u[i].most();
    const double force = 2 * half_period / (R * R) * energy * (s.zeta[i].e + s.zeta[i].most() * of_R + of_R);
    return {s.g[i].e + half_period * s.u[i].e + std::min(half_period, s.R[i].most()) * force, s.g[i].e / R + s.u[i].e + force};
}

// The motion of the masses over the half-period, and what the errors of its numbers make of it.
evaluation::LinearSum motion_of_masses(const ModeSums<Number>& s, std::size_t N, const Number& beta,
                                       std::vector<ErrorOfSamples>& errors) {
    const std::size_t n = s.R.size();
    evaluation::LinearSum motion{0, {}, {}, std::vector<double>(N), {}, {}, {}};
    std::vector<ErrorOfSamples> of_braces;
    for (std::size_t i = 0; i < n; ++i) {
        motion.coordinates.push_back({s.R[i].x, s.zeta[i].x, s.w[i].x, 1, -s.g[i].x, -s.u[i].x});
        of_braces.push_back(error_of_brace(s, i));
    }
    for (std::size_t k = 0; k < N; ++k) {
        const MassInMotion<Number> mass(s, k, beta);
        motion.A.push_back(mass.h.A.x);
        motion.B.push_back(mass.h.B.x);
        motion.harmonic.push_back(std::abs(mass.h.A.x) + std::abs(mass.h.B.x));
        ErrorOfSamples error{mass.h.A.e + mass.h.B.e, mass.h.A.e + mass.h.B.e};
        for (std::size_t i = 0; i < n; ++i) {
            const Number weight = beta * mass.weights[i];
            const double size = evaluation::largest_size(motion.coordinates[i], pi<double>());
            error.x += weight.e * size + weight.most() * of_braces[i].x;
            error.x_prime += weight.e * size / s.R[i].least() + weight.most() * of_braces[i].x_prime;
            motion.shapes.push_back(weight.x);
        }
        errors.push_back(error);
    }
    return motion;
}

// The period from half-period to half-period of x_j, each of which mirrors that before; so does half of the instants the other.
SampledSolution over_period(evaluation::LinearSum motion, double phi_j, std::size_t samples) {
    const std::size_t N = motion.A.size(), all = samples % 2 == 0 ? samples / 2 : samples;
    const double step = 2 * pi<double>() / static_cast<double>(samples);
    SampledSolution s(samples, 1, N);
    const auto mirror = [&] {
        for (std::vector<double>* numbers : {&motion.A, &motion.B, &motion.shapes})
            for (double& each : *numbers) each = -each;
    };
    if (phi_j > 0) mirror();
    double turn = phi_j > 0 ? phi_j - pi<double>() : phi_j; // the last of x_j until tau = 0
    for (std::size_t from = 0; from < all; turn += pi<double>(), mirror()) {
        const double first = step * static_cast<double>(from) - turn, left = std::ceil((pi<double>() - first) / step);
        const std::size_t count = std::min(all - from, static_cast<std::size_t>(std::max(0.0, left)));
        if (count > 0) evaluation::even_samples(motion, {first, step, count}, &s.x[from * N], &s.x_prime[from * N]);
        from += count;
    }
    for (std::vector<double>* numbers : {&s.x, &s.x_prime})
        for (std::size_t n = all * N; n < numbers->size(); ++n) (*numbers)[n] = -(*numbers)[n - all * N];
    return s;
}

// None where double does not tell.
std::optional<SampledClosedForm> in_double(const Scene<double>& scene, double phi_j, std::size_t samples, double tolerance,
                                           bool known_to_slide) {
    const auto basis = modes_with_errors(scene.system);
    if (basis->coupled()) return std::nullopt;
    const Number beta = as_input(*scene.beta);
    const ModeSums<Number> sums = bounded_sums(scene.system, *basis, as_input(*scene.r));
    SampledClosedForm all{{}, {{}, {"closed form", "double", {}}}};
    Quantities<Number>& q = all.found.numbers;
    if (!known_to_slide) {
        q = quantities_in_double(scene, sums, {});
        if (!(std::abs(q.beta_lim.x - beta.x) > q.beta_lim.e)) return std::nullopt;
        if (!q.X_j) return all;
    }
    const SteadyState<Number> state = steady_state_without_maxima(sums, beta);
    q.X_j = state.X_j;
    std::vector<ErrorOfSamples> errors;
    evaluation::LinearSum motion = motion_of_masses(sums, number_of_masses(scene.system), beta, errors);
    const std::vector<ErrorOfSamples> lost =
        evaluation::loss_of_samples(motion, {0, 2 * pi<double>() / static_cast<double>(samples), samples / 2 + 1});
    for (std::size_t k = 0; k < errors.size(); ++k) {
        const double most = tolerance * state.masses[k].amplitude_monoharmonic.x;
        if (!(errors[k].x + lost[k].x <= most && errors[k].x_prime + lost[k].x_prime <= most)) return std::nullopt;
    }
    all.motion = over_period(std::move(motion), phi_j, samples);
    return all;
}

} // namespace

SampledClosedForm sampled_closed_form(const SceneSource& source, double phi_j, std::size_t samples, int digits,
                                      bool known_to_slide) {
    const Scene<double>& scene = source->in_double();
    if (digits >= 1 && digits <= most_digits_in_double) { // else, and where it is refused, `quantities` asks the reference
        auto seen = tried([&] { return in_double(scene, phi_j, samples, aim_of(digits).tolerance, known_to_slide); });
        if (seen.value && *seen.value) return **std::move(seen.value);
    }
    std::vector<double> tau = SampledSolution(samples, 1, 0).tau;
    for (double& instant : tau) instant -= phi_j;
    SampledClosedForm all{{}, quantities(source, tau, digits, PointNumbers::motion)};
    const Quantities<Number>& q = all.found.numbers;
    if (!q.X_j) return all;
    all.motion = SampledSolution(samples, 1, q.x_size.size());
    const auto value = [](const Number& x) { return x.x; };
    std::ranges::transform(q.x, all.motion.x.begin(), value);
    std::ranges::transform(q.x_prime, all.motion.x_prime.begin(), value);
    return all;
}

} // namespace denhartog
