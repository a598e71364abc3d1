#include "denhartog/stick_slip/lasting_rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/steady_state.hpp"

namespace denhartog {

LastingRest::LastingRest(const ContactSystem& system, const Excitation& excitation)
    : system_(&system), e_(excitation), weight_(0), terms_(std::abs(direct_load(system.stuck, system.load))) {
    const StuckConfiguration<double>& s = system.stuck;
    try {
        response_ = stuck_response(s, system.load, e_.r);
    } catch (const DomainError&) {
        response_.reset();
    }
    const std::size_t n = s.masses.size();
    for (std::size_t a = 0; a < n && response_; ++a)
        terms_ += (std::abs(s.k_j[a]) + e_.r * std::abs(s.c_j[a]) + e_.r * e_.r * std::abs(s.m_j[a])) *
                  response_->masses[s.masses[a].index].amplitude;
    follows_ = s.carried;
    double stiffness = 0, damping = 0, inertia = 0, fastest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        double k = 0, c = 0, m = 0, rate = 0;
        for (std::size_t a = 0; a < n; ++a) {
            k += s.phi(a, i) * s.k_j[a];
            c += s.phi(a, i) * s.c_j[a];
            m += s.phi(a, i) * s.m_j[a];
            rate += std::abs(s.damping(i, a));
        }
        for (std::size_t a = 0; a <= n; ++a) follows_[a] -= s.shapes(a, i) * k / (s.r_n[i] * s.r_n[i]);
        stiffness += k * k / (s.r_n[i] * s.r_n[i]);
        damping += c * c;
        inertia += m * m;
        fastest = std::max(fastest, s.r_n[i] + rate);
    }
    // In units of r times the energy norm, that is, of displacements times natural frequency ratios.
    weight_ = sqrt(stiffness) + sqrt(damping) + fastest * sqrt(inertia);
}

State LastingRest::steady_state(double x_j) const {
    State z = at_rest(follows_.size());
    for (std::size_t k = 0; k < follows_.size(); ++k) {
        z.x[k] = follows_[k] * x_j + response_->masses[k].X.re;
        z.x_prime[k] = -response_->masses[k].X.im;
    }
    return z;
}

double LastingRest::reach() const {
    if (!response_) return -1;
    const StuckConfiguration<double>& s = system_->stuck;
    const double holds = e_.mu * e_.beta, amplitude = modulus(response_->contact_load);
    const double rounding = 64 * static_cast<int>(s.masses.size() + 1) * std::numeric_limits<double>::epsilon() *
                            (holds + terms_) * std::max(1.0, s.k_jj / s.k_contact);
    return (holds - amplitude - rounding) / s.k_contact;
}

MassMotion LastingRest::motion(std::size_t k, double x_j) const {
    if (k == system_->contact.index) return {std::abs(x_j), x_j < 0 ? pi<double>() : 0.0};
    const double offset = follows_[k] * x_j;
    const StuckMass& mass = response_->masses[k];
    // Below zero the extremum comes half a period later, and half a period more is what a negative one adds to its phase.
    return {std::abs(offset) + mass.amplitude, mass.phase.value_or(offset < 0 ? pi<double>() : 0.0)};
}

LastingRest::Verdict LastingRest::verdict(const State& z) const {
    if (!response_) return Verdict::open;
    const StuckConfiguration<double>& s = system_->stuck;
    const double x_j = s.contact.of(z.x);
    const double holds = e_.mu * e_.beta;
    const double amplitude = modulus(response_->contact_load), constant = std::abs(s.k_contact * x_j);
    const double margin = holds - amplitude - constant;
    const double rounding = 16 * static_cast<int>(s.masses.size() + 1) * std::numeric_limits<double>::epsilon() *
                            (holds + terms_ + constant + std::abs(s.k_jj * x_j));
    if (margin < -rounding) return Verdict::open;
    const State steady = steady_state(x_j);
    double energy = 0;
    for (std::size_t i = 0; i < s.masses.size(); ++i) {
        double q = 0, p = 0;
        for (std::size_t k = 0; k < z.x.size(); ++k) {
            q += s.momentum(i, k) * (z.x[k] - steady.x[k]);
            p += s.momentum(i, k) * (z.x_prime[k] - steady.x_prime[k]);
        }
        energy += s.r_n[i] * s.r_n[i] * q * q + e_.r * e_.r * p * p;
    }
    const double free = weight_ * sqrt(energy);
    if (free < margin) return Verdict::lasts;
    return margin <= rounding && free <= rounding ? Verdict::on_boundary : Verdict::open;
}

} // namespace denhartog
