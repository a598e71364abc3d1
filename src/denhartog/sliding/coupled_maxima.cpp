#include "denhartog/sliding/coupled_maxima.hpp"

#include "denhartog/sliding/demand_curve.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/sliding/mass_in_motion.hpp"

namespace denhartog {

template <class T>
T instant_of_largest_demand_where_coupled(const ModeSums<T>& s) {
    const CoupledFriction<T>& friction = *s.coupled;
    const std::size_t j = s.contact.index;
    const T start = friction.derivative(j, 1, friction.at(T(0)));
    Curve<T> curve;
    curve.sample = [&](const T& tau) {
        const CoupledState<T>& now = friction.at(tau);
        const auto [S, C] = sine_cosine(tau);
        const T first = friction.derivative(j, 1, now), second = friction.derivative(j, 2, now);
        const T N = first - start * C, N_prime = second + start * S, Z = friction.derivative(j, 3, now) + first;
        if (tau > 0 && tau < pi<T>()) return Sample<T>{N / S, N_prime * S - N * C, Z, Z * S};
        return Sample<T>{coupled_demand(friction, s.contact, tau), T(0), Z};
    };
    curve.rate = [&](const T& a, const T&) { return friction.rate_of_demand(j, friction.at(a)); };
    curve.rise = [](const T& a, const T& b, const T& z_bound) { return rise_of_demand(a, b, z_bound); };
    curve.cost = friction.cost();
    curve.share = default_effort(friction.size()) / 4;
    const T found = global_maximum(curve, T(0), pi<T>()).instant;
    return coupled_demand(friction, s.contact, T(0)) >= coupled_demand(friction, s.contact, found) ? T(0) : found;
}

template <class T>
std::pair<T, T> instant_and_spread_where_coupled(const ModeSums<T>& s, const T& beta, std::size_t k, const T& error) {
    const MassInMotion<T> mass(s, k, beta);
    const CoupledFriction<T>& friction = *s.coupled;
    const T harmonic_size = modulus(Complex<T>{mass.h.A, mass.h.B});
    Curve<T> curve;
    curve.rate = [&](const T& a, const T&) {
        return T(harmonic_size + beta * friction.largest_derivative(k, 3, friction.at(a)));
    };
    curve.cost = friction.cost();
    curve.share = default_effort(friction.size()) / 4;
    const T noise = 2 * unit_of<T>() * (harmonic_size + beta * friction.compliance(k).most());
    return instant_and_spread(
        curve, [&](const T& tau) { return motion_at(s, mass, k, tau); }, noise, error);
}

template double instant_of_largest_demand_where_coupled(const ModeSums<double>&);
template std::pair<double, double> instant_and_spread_where_coupled(const ModeSums<double>&, const double&, std::size_t,
                                                                    const double&);

} // namespace denhartog
