#include "conformance/plain/closed_form.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/number/errors.hpp"
#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

struct PlainExtremum {
    double tau;   ///< instant in [0, pi]
    double size;  ///< largest size of the displacement
    bool minimum; ///< whether the displacement is negative there
};

// Largest displacement of a mass over the half-period: of the contact where it turns, of the others where they do.
PlainExtremum largest_displacement(const PlainModes& m, const Choices& c, std::size_t k) {
    if (k == m.j) return {0, paper::displacement_transmissibility_of_contact(m.V[k], m.U[k], m.G[k], m.beta), false};
    const int steps = plain_steps(m);
    PlainExtremum best{0, 0, false};
    const auto take = [&](double tau) {
        const double x = plain_motion(m, c, k, tau).x;
        if (std::isnan(x) || std::abs(x) > best.size) best = {tau, std::abs(x), x < 0};
    };
    const auto velocity = [&](double tau) { return plain_motion(m, c, k, tau).v; };
    take(0);
    double before = velocity(0);
    for (int n = 1; n <= steps; ++n) {
        const double from = (n - 1) * pi<double>() / steps,
                     to = n == steps ? pi<double>() * (1 - 1e-15) : n * pi<double>() / steps;
        const double after = velocity(to);
        if (before * after < 0) {
            std::uintmax_t most = 200;
            const boost::math::tools::eps_tolerance<double> all_digits(52);
            const auto [a, b] = boost::math::tools::toms748_solve(velocity, from, to, before, after, all_digits, most);
            take((a + b) / 2);
        }
        before = after;
    }
    take(pi<double>() * (1 - 1e-15));
    return best;
}

double phase_of_mass(const PlainModes& m, const Choices& c, std::size_t k) {
    if (k == m.j) return plain_phase(m, c);
    const PlainExtremum e = largest_displacement(m, c, k);
    return paper::phase_of_mass(plain_phase(m, c), e.tau, e.minimum && !c.no_half_period_for_minima ? 1 : 0);
}

double monoharmonic_cosine(const PlainModes& m, const Choices& c, std::size_t k) {
    if (c.cosine_as_printed) return as_printed::monoharmonic_cosine(m.V[k], m.V[m.j], m.U[m.j], m.G[k], m.beta);
    return c.motion_from_start ? plain_start(m, c, k).x // (49)
                               : paper::monoharmonic_cosine(m.V[k], m.V[m.j], m.U[m.j], m.G[k], m.beta);
}

double monoharmonic_sine(const PlainModes& m, const Choices& c, std::size_t k) {
    if (c.motion_from_start) return plain_start(m, c, k).v; // (49)
    return paper::monoharmonic_sine(m.V[k], m.V[m.j], m.U[m.j], m.U[k], m.beta);
}

double monoharmonic_amplitude(const PlainModes& m, const Choices& c, std::size_t k) {
    if (c.monoharmonic_as_printed)
        return as_printed::displacement_transmissibility(m.V[k], m.V[m.j], m.U[m.j], m.U[k], m.G[k], m.beta);
    if (c.amplitude_from_parts || c.motion_from_start)
        return elementary::hypot(monoharmonic_cosine(m, c, k), monoharmonic_sine(m, c, k));
    return paper::displacement_transmissibility(m.V[k], m.V[m.j], m.U[m.j], m.U[k], m.G[k], m.beta);
}

bool is_of_motion(const std::string& quantity) {
    return quantity == "amplitude" || quantity == "phase" || quantity == "motion_under_force" || quantity == "stops_per_period" ||
           quantity == "stop_durations" || quantity == "rest_interval";
}

bool slides(const PlainModes& m, const Choices& c) {
    if (c.beyond_the_boundary || c.harmonics > 0) return true;
    const double V = modulus(m.V[m.j]), root = std::sqrt(V * V - m.beta * m.U[m.j] * (m.beta * m.U[m.j]));
    if (!(root > m.beta * (m.H_j + m.mu * m.sum_of_squares))) return false; // (67), which costs no search
    return m.beta < plain_limit(m, {}, plain_demand(m, {}, false));
}

Value regime(const ProtocolQuestion& q, const PlainModes& m, const Choices& c) {
    if (c.beyond_the_boundary) return {{}, "continuous"};
    if (m.beta < plain_limit(m, c, plain_demand(m, c, false))) return {{}, "continuous"};
    return {{}, m.beta >= plain_sticking_limit(q, m, c) ? "permanent_sticking" : "stick_slip"};
}

// Quantities of the modes and of the boundaries, which do not depend on the motion; none for another quantity.
std::optional<std::vector<double>> without_motion(const ProtocolQuestion& q, const PlainModes& m, const Choices& c,
                                                  std::size_t k) {
    const std::string& name = q.quantity;
    if (name == "natural_frequency_ratios") return m.r_n;
    if (name == "modal_frequency_ratios") return m.R;
    if (name == "mode_shape_products") {
        std::vector<double> products;
        for (std::size_t i = 0; i < m.R.size(); ++i) products.push_back(m.psi[k][i] * m.psi[m.j][i]);
        return products;
    }
    if (name == "complex_response") return std::vector{m.V[k].re, m.V[k].im};
    if (name == "first_damping_function") return std::vector{m.U[k]};
    if (name == "second_damping_function") return std::vector{m.G[k]};
    if (name == "H_j") return std::vector{m.H_j};
    if (name == "S_j") return std::vector{plain_demand(m, c, false)};
    if (name == "beta_lim_exact" || name == "beta_lim_paper")
        return std::vector{plain_limit(m, c, plain_demand(m, c, name == "beta_lim_paper"))};
    if (name == "beta_lim_approximate") return std::vector{plain_approximate_limit(m, c)};
    if (name == "beta_lim_sticking") return std::vector{plain_sticking_limit(q, m, c)};
    if (name == "beta_lim_high_frequency") return std::vector{paper::friction_ratio_limit_at_high_frequency(m.mu)};
    return std::nullopt;
}

// Quantities of the motion while the contact slides.
std::vector<double> of_motion(const ProtocolQuestion& q, const PlainModes& m, const Choices& c, std::size_t k) {
    const std::string& name = q.quantity;
    if (name == "amplitude") return {largest_displacement(m, c, k).size};
    if (name == "phase") return {wrapped_angle(phase_of_mass(m, c, k))};
    if (name == "amplitude_monoharmonic") return {monoharmonic_amplitude(m, c, k)};
    if (name == "phase_monoharmonic")
        return {wrapped_angle(plain_phase(m, c) +
                              paper::phase_behind_contact(monoharmonic_cosine(m, c, k), monoharmonic_sine(m, c, k)))};
    if (name == "initial_displacement") return {plain_start(m, c, k).x};
    if (name == "initial_velocity") return {plain_start(m, c, k).v};
    if (name == "displacement") return {plain_motion(m, c, k, q.tau).x};
    if (name == "motion_under_force")
        return sampled(q, [&](double tau) { return plain_motion(m, c, k, tau - plain_phase(m, c)).x; }).numbers;
    if (name == "stops_per_period") return {0};
    return {};
}

std::optional<Value> computed(const ProtocolQuestion& q, const Choices& c) {
    const PlainModes m = plain_modes(q, c);
    const bool of_mass = quantity(q.quantity).of_mass;
    if (of_mass && (q.mass < 1 || static_cast<std::size_t>(q.mass) > m.R.size())) return std::nullopt;
    const std::size_t k = of_mass ? static_cast<std::size_t>(q.mass - 1) : 0;
    if (q.quantity == "regime") return regime(q, m, c);
    if (const std::optional<std::vector<double>> numbers = without_motion(q, m, c, k)) return Value{*numbers, ""};
    if (is_of_motion(q.quantity) && !slides(m, c)) return c.closed_form_alone ? std::nullopt : answer_of_steady_motion(q);
    if (q.quantity == "rest_interval") return std::nullopt;
    return Value{of_motion(q, m, c, k), ""};
}

} // namespace

std::optional<Value> where_finite(const std::function<std::optional<Value>()>& answer) {
    try {
        std::optional<Value> value = answer();
        if (value && !std::all_of(value->numbers.begin(), value->numbers.end(), [](double x) { return std::isfinite(x); }))
            return std::nullopt;
        return value;
    } catch (const InputError&) {
    } catch (const DomainError&) {
    } catch (const PrecisionError&) {
    }
    return std::nullopt;
}

Value sampled(const ProtocolQuestion& q, const std::function<double(double tau)>& f) {
    Value value;
    for (int n = 0; n < q.samples; ++n) value.numbers.push_back(f(2 * pi<double>() * n / q.samples));
    return value;
}

double wrapped_angle(double angle) {
    const double reduced = std::remainder(angle, 2 * pi<double>());
    return reduced <= -pi<double>() ? reduced + 2 * pi<double>() : reduced;
}

std::optional<Value> plain_answer(const ProtocolQuestion& q, const Choices& c) {
    return where_finite([&] { return computed(q, c); });
}

std::optional<Value> plain_answer(const ProtocolQuestion& q) {
    return where_finite([&] { return is_of_the_paper(q) ? computed(q, {}) : answer_of_system(q); });
}

} // namespace denhartog::conformance
