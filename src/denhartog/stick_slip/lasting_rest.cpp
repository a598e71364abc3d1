// Does a contact at rest stay for ever? The load on it is that of the steady motion of the other masses, (88), a constant, and
// what is left of the start, which loses energy. `verdict` compares their sum with mu beta.
#include "denhartog/stick_slip/lasting_rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/number/errors.hpp"
#include "denhartog/stick_slip/linear_motion.hpp"

namespace denhartog {

LastingRest::LastingRest(const ContactSystem& system, const Excitation& excitation)
    : system_(&system), e_(excitation), weight_(0), terms_(modulus(direct_load(system.stuck, system.load))) {
    const StuckConfiguration& s = system.stuck;
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
    double stiffness = 0, fastest = 0;
    const Column k = s.phi.transpose() * column(s.k_j), c = s.phi.transpose() * column(s.c_j),
                 m = s.phi.transpose() * column(s.m_j);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t a = 0; a <= n; ++a) follows_[a] -= s.shapes(a, i) * k(i) / (s.r_n[i] * s.r_n[i]);
        stiffness += k(i) * k(i) / (s.r_n[i] * s.r_n[i]);
        fastest = std::max(fastest, s.r_n[i] + s.damping.row(i).cwiseAbs().sum());
    }
    // In units of r times the energy norm, that is, of displacements times natural frequency ratios.
    weight_ = sqrt(stiffness) + c.norm() + fastest * m.norm();
}

State LastingRest::steady_state(double x_j) const {
    State z = at_rest(follows_.size());
    for (std::size_t k = 0; k < follows_.size(); ++k) {
        z.x[k] = follows_[k] * x_j + response_->masses[k].X.re;
        z.x_prime[k] = -response_->masses[k].X.im;
    }
    if (const Contact& contact = system_->stuck.contact; !contact.others.empty())
        contact.hold(z.x_prime.data()); // to the last bit: it rests
    return z;
}

double LastingRest::reach() const {
    if (!response_) return -1;
    const StuckConfiguration& s = system_->stuck;
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
    const StuckConfiguration& s = system_->stuck;
    const double x_j = s.contact.of(z.x);
    const double holds = e_.mu * e_.beta;
    const double amplitude = modulus(response_->contact_load), constant = std::abs(s.k_contact * x_j);
    const double margin = holds - amplitude - constant;
    const double rounding = 16 * static_cast<int>(s.masses.size() + 1) * std::numeric_limits<double>::epsilon() *
                            (holds + terms_ + constant + std::abs(s.k_jj * x_j));
    if (margin < -rounding) return Verdict::open;
    const State steady = steady_state(x_j);
    const Column q = s.momentum * (column(z.x) - column(steady.x)), p = s.momentum * (column(z.x_prime) - column(steady.x_prime));
    double energy = 0;
    for (std::size_t i = 0; i < s.masses.size(); ++i) energy += s.r_n[i] * s.r_n[i] * q(i) * q(i) + e_.r * e_.r * p(i) * p(i);
    const double free = weight_ * sqrt(energy);
    if (free < margin) return Verdict::lasts;
    return margin <= rounding && free <= rounding ? Verdict::on_boundary : Verdict::open;
}

} // namespace denhartog
