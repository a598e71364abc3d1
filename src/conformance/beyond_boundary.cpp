#include "conformance/beyond_boundary.hpp"

#include <limits>
#include <string_view>

#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/steady_state.hpp"

namespace denhartog::conformance {
namespace {

double displacement_at(const ModeSums<double>& sums, const SteadyState<double>& state, std::size_t k, double tau) {
    return motion(sums, state, tau).x[k];
}

std::optional<Value> value_of(const Question& q, const ModeSums<double>& sums, const SteadyState<double>& state) {
    const auto k = static_cast<std::size_t>(q.mass - 1);
    const MassResponse<double>& mass = state.masses.at(k);
    const std::string_view asked = q.quantity;
    if (asked == "amplitude") return Value{{mass.amplitude}, ""};
    if (asked == "phase") return Value{{mass.phase}, ""};
    if (asked == "amplitude_monoharmonic") return Value{{mass.amplitude_monoharmonic}, ""};
    if (asked == "phase_monoharmonic") return Value{{mass.phase_monoharmonic}, ""};
    if (asked == "initial_displacement") return Value{{mass.x0}, ""};
    if (asked == "initial_velocity") return Value{{mass.v0}, ""};
    if (asked == "displacement") return Value{{displacement_at(sums, state, k, q.tau)}, ""};
    if (quantity(asked).shape != Shape::samples) return std::nullopt;
    Value curve;
    for (int n = 0; n < q.samples; ++n) {
        const double from_force = 2 * pi<double>() * n / q.samples;
        curve.numbers.push_back(displacement_at(sums, state, k, from_force - state.phi_j));
    }
    return curve;
}

} // namespace

std::optional<Value> closed_form_beyond_boundary(const Question& q) {
    const Quantity& asked = quantity(q.quantity);
    if (!asked.of_mass || asked.shape == Shape::complex || asked.shape == Shape::modes) return std::nullopt;
    try {
        const Scene<double> scene = scene_of<double>(q);
        const System<double>& system = scene.system;
        const ModeSums<double> sums = mode_sums(modal_basis(system), system.contact, system.load, q.r);
        const RegimeBoundary<double> none{std::numeric_limits<double>::infinity(), std::nullopt};
        const Mass mass{static_cast<std::size_t>(q.mass - 1)};
        return value_of(q, sums, steady_state(sums, none, q.beta, mass));
    } catch (const DomainError&) {
        return std::nullopt;
    } catch (const PrecisionError&) {
        return std::nullopt;
    }
}

} // namespace denhartog::conformance
