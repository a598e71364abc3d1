#include "denhartog/stick_slip/lasting_rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/steady_state.hpp"

namespace denhartog {

using std::abs;

template <class T>
LastingRest<T>::LastingRest(const ContactSystem<T>& system, const Excitation<T>& excitation)
    : system_(&system), e_(excitation), weight_(0), terms_(abs(direct_load(system.stuck, system.contact, system.load))) {
    const StuckConfiguration<T>& s = system.stuck;
    try {
        response_ = stuck_response(s, system.contact, system.load, e_.r);
    } catch (const DomainError&) {
        response_.reset();
    }
    const std::size_t n = s.masses.size();
    for (std::size_t a = 0; a < n && response_; ++a)
        terms_ +=
            (abs(s.k_j[a]) + e_.r * abs(s.c_j[a]) + e_.r * e_.r * abs(s.m_j[a])) * response_->masses[s.masses[a].index].amplitude;
    follows_.assign(n, T(0));
    T stiffness(0), damping(0), inertia(0), fastest(0);
    for (std::size_t i = 0; i < n; ++i) {
        T k(0), c(0), m(0), rate(0);
        for (std::size_t a = 0; a < n; ++a) {
            k += s.phi(a, i) * s.k_j[a];
            c += s.phi(a, i) * s.c_j[a];
            m += s.phi(a, i) * s.m_j[a];
            rate += abs(s.damping(i, a));
        }
        for (std::size_t a = 0; a < n; ++a) follows_[a] -= s.phi(a, i) * k / (s.r_n[i] * s.r_n[i]);
        stiffness += k * k / (s.r_n[i] * s.r_n[i]);
        damping += c * c;
        inertia += m * m;
        fastest = std::max(fastest, T(s.r_n[i] + rate));
    }
    // In units of r times the energy norm, that is, of displacements times natural frequency ratios.
    weight_ = sqrt(stiffness) + sqrt(damping) + fastest * sqrt(inertia);
}

template <class T>
State<T> LastingRest<T>::steady_state(const T& x_j) const {
    State<T> z = at_rest<T>(follows_.size() + 1);
    z.x[system_->contact.index] = x_j;
    for (std::size_t n = 0; n < follows_.size(); ++n) {
        const std::size_t k = system_->stuck.masses[n].index;
        z.x[k] = follows_[n] * x_j + response_->masses[k].X.re;
        z.x_prime[k] = -response_->masses[k].X.im;
    }
    return z;
}

template <class T>
T LastingRest<T>::reach() const {
    if (!response_) return T(-1);
    const StuckConfiguration<T>& s = system_->stuck;
    const T holds = e_.mu * e_.beta, amplitude = modulus(response_->contact_load);
    const T rounding = 64 * static_cast<int>(s.masses.size() + 1) * std::numeric_limits<T>::epsilon() * (holds + terms_) *
                       std::max(T(1), T(s.k_jj / s.k_contact));
    return (holds - amplitude - rounding) / s.k_contact;
}

template <class T>
MassMotion<T> LastingRest<T>::motion(std::size_t k, const T& x_j) const {
    if (k == system_->contact.index) return {abs(x_j), x_j < 0 ? pi<T>() : T(0)};
    T offset(0);
    for (std::size_t n = 0; n < follows_.size(); ++n)
        if (system_->stuck.masses[n].index == k) offset = follows_[n] * x_j;
    const StuckMass<T>& mass = response_->masses[k];
    // Below zero the extremum comes half a period later, and half a period more is what a negative one adds to its phase.
    return {abs(offset) + mass.amplitude, mass.phase.value_or(offset < 0 ? pi<T>() : T(0))};
}

template <class T>
typename LastingRest<T>::Verdict LastingRest<T>::verdict(const State<T>& z) const {
    if (!response_) return Verdict::open;
    const StuckConfiguration<T>& s = system_->stuck;
    const T& x_j = z.x[system_->contact.index];
    const T holds = e_.mu * e_.beta;
    const T amplitude = modulus(response_->contact_load), constant = abs(s.k_contact * x_j);
    const T margin = holds - amplitude - constant;
    const T rounding = 16 * static_cast<int>(s.masses.size() + 1) * std::numeric_limits<T>::epsilon() *
                       (holds + terms_ + constant + abs(s.k_jj * x_j));
    if (margin < -rounding) return Verdict::open;
    const State<T> steady = steady_state(x_j);
    T energy(0);
    for (std::size_t i = 0; i < s.masses.size(); ++i) {
        T q(0), p(0);
        for (std::size_t a = 0; a < s.masses.size(); ++a) {
            T momentum(0);
            for (std::size_t b = 0; b < s.masses.size(); ++b) momentum += s.phi(b, i) * s.M(b, a);
            const std::size_t k = s.masses[a].index;
            q += momentum * (z.x[k] - steady.x[k]);
            p += momentum * (z.x_prime[k] - steady.x_prime[k]);
        }
        energy += s.r_n[i] * s.r_n[i] * q * q + e_.r * e_.r * p * p;
    }
    const T free = weight_ * sqrt(energy);
    if (free < margin) return Verdict::lasts;
    return margin <= rounding && free <= rounding ? Verdict::on_boundary : Verdict::open;
}

template class LastingRest<double>;

} // namespace denhartog
