#include "derivation/observations/observed_systems.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

namespace {

/// (52) where the contact slides by (67); not a number elsewhere.
double sliding_amplitude(const ModeSums<double>& m, std::size_t k, double beta) {
    const std::size_t j = m.contact.index;
    const double demand = paper::static_friction_demand(m.H_j, 1.0, m.sum_of_squares);
    if (!(beta < paper::friction_ratio_limit(m.V[j], m.U[j], demand))) return std::nan("");
    return monoharmonic_amplitude(m, k, beta);
}

} // namespace

ObservedSystem observed_system(const std::string& name, double zeta, const System<double>& system) {
    return {name + " zeta=" + rounded(zeta), zeta, system, modal_basis(system)};
}

const std::vector<double>& damping_ratios_of_figures() {
    static const std::vector<double> list{1.0 / 1000, 1.0 / 100, 1.0 / 10};
    return list;
}

std::vector<ObservedSystem> systems_of_the_paper(double zeta) {
    std::vector<ObservedSystem> list;
    for (const NamedSystem<double>& named : paper_systems(zeta)) list.push_back(observed_system(named.name, zeta, named.system));
    return list;
}

const std::vector<ObservedSystem>& systems_of_the_paper() {
    static const std::vector<ObservedSystem> all = [] {
        std::vector<ObservedSystem> list;
        for (const double zeta : damping_ratios_of_figures())
            for (ObservedSystem& s : systems_of_the_paper(zeta)) list.push_back(std::move(s));
        return list;
    }();
    return all;
}

double damping_ratio_up_to(const std::function<double(double zeta)>& largest, double bound) {
    double low = 1e-6, high = 0.1;
    if (largest(low) > bound) return 0;
    if (largest(high) <= bound) return high;
    for (int n = 0; n < 30; ++n) {
        const double middle = std::sqrt(low * high);
        (largest(middle) > bound ? high : low) = middle;
    }
    return low;
}

ModeSums<double> sums_at(const ObservedSystem& s, double r) { return mode_sums(s.basis, s.system.contact, s.system.load, r); }

double monoharmonic_amplitude(const ModeSums<double>& m, std::size_t k, double beta) {
    const std::size_t j = m.contact.index;
    if (k == j) return paper::displacement_transmissibility_of_contact(m.V[j], m.U[j], m.G[j], beta);
    return paper::displacement_transmissibility(m.V[k], m.V[j], m.U[j], m.U[k], m.G[k], beta);
}

Witness place(const ObservedSystem& s, std::size_t k, std::size_t i) {
    return {{"system", s.name}, {"mass", std::to_string(k + 1)}, {"mode", std::to_string(i + 1)}, {"r", text(s.basis.r_n[i])}};
}

std::optional<Peak> peak_near(const ObservedSystem& s, std::size_t k, std::size_t i, double beta) {
    const std::vector<double>& r_n = s.basis.r_n;
    double width = 0.3 * r_n[i];
    if (i > 0) width = std::min(width, 0.45 * (r_n[i] - r_n[i - 1]));
    if (i + 1 < r_n.size()) width = std::min(width, 0.45 * (r_n[i + 1] - r_n[i]));
    const double least = std::min(s.basis.zeta[i] / 64 * r_n[i], width / 2);
    const int parts = 80; // on each side, distances from the resonance in geometric progression
    const auto X = [&](double r) { return sliding_amplitude(sums_at(s, r), k, beta); };
    std::vector<double> r, x;
    for (int n = -parts; n <= parts; ++n) {
        const double distance = n == 0 ? 0 : least * std::pow(width / least, (std::abs(n) - 1.0) / (parts - 1));
        r.push_back(r_n[i] + (n < 0 ? -distance : distance));
        x.push_back(X(r.back()));
    }
    std::optional<std::size_t> best;
    for (std::size_t n = 1; n + 1 < r.size(); ++n)
        if (x[n] >= x[n - 1] && x[n] >= x[n + 1] && (!best || x[n] > x[*best])) best = n;
    if (!best) return std::nullopt;
    const int bits = 30; // near a maximum no more of its place is to be had: half the digits of a double, and a few
    const auto minus_X = [&](double r_at) { return -X(r_at); };
    const double at = boost::math::tools::brent_find_minima(minus_X, r[*best - 1], r[*best + 1], bits).first;
    const ModeSums<double> m = sums_at(s, at);
    if (!(beta < boundary(m, 1.0).exact)) return std::nullopt;
    return Peak{at, monoharmonic_amplitude(m, k, beta)};
}

double ratio_of_shapes(const ObservedSystem& s, std::size_t i) {
    const auto phi = [&](Mass m) { return s.basis.phi(static_cast<Eigen::Index>(m.index), static_cast<Eigen::Index>(i)); };
    return std::abs(phi(s.system.load) / phi(s.system.contact));
}

double limit_at(const ObservedSystem& s, std::size_t i) { return boundary(sums_at(s, s.basis.r_n[i]), 1.0).exact; }

} // namespace denhartog::derivation
