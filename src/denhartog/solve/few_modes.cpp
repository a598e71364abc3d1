#include "denhartog/solve/few_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/mode.hpp"

namespace denhartog {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double largest_harmonic = 2000;

// What a mode contributes: evaluated, or static with bounds.
struct ModeAtR {
    Bounded R, zeta;
    Complex<Bounded> v;
    Bounded u, g;
    double harmonics = 0;          // sum over odd n >= 3 of 4 / (n pi) / |1 - n^2 R^2 + 2 i zeta n R|
    double velocity_harmonics = 0; // the same with n times each term
};

// With zeta >= 1: 0 < u < 2 S / R and 0 < 1 - g < 2 (d + exp(-2 delta)), where d = exp(-a pi / R) + a S, a the slow rate.
void bound_overdamped(double R, double zeta, double& du, double& dg) {
    const double x = std::numbers::pi / R, a = evaluation::slow_rate(zeta), w = evaluation::overdamped_w(zeta);
    const double slow = std::exp(-a * x), S = slow * (2 * w * x > 1 ? 1 / (2 * w) : x);
    du = 2 * S / R * (1 + 1e-9);
    dg = 2 * (slow + a * S + std::exp(-2 * zeta * x)) * (1 + 1e-9);
}

ModeAtR static_mode(const Bounded& R, const Bounded& zeta) {
    const double delta = std::numbers::pi * zeta.x / R.x, half = std::sinh(std::min(300.0, delta / 2));
    const double cosh_minus_one = 2 * half * half * (1 - 1e-9);
    const double a = (1 - R.x) * (1 + R.x), b = 2 * zeta.x * R.x;
    const double dv = (1 + 1e-9) * R.x * std::hypot(R.x, 2 * zeta.x) / std::hypot(a, b);
    double du, dg;
    if (zeta.x >= 1) {
        bound_overdamped(R.x, zeta.x, du, dg);
    } else {
        const double w = std::sqrt((1 - zeta.x) * (1 + zeta.x));
        du = 1 / (R.x * w * cosh_minus_one);
        dg = (std::exp(-delta) + 1 + zeta.x / w) / cosh_minus_one;
    }
    return {R, zeta, {{1, dv}, {0, dv}}, {0, du}, {1, dg}};
}

// Harmonics up to n R = 2 one by one, beyond by the integral: there |1 - n^2 R^2| is at least 3/4 n^2 R^2.
void add_harmonics(ModeAtR& mode) {
    const double R = mode.R.x, last = std::max(3.0, 2 / R + 2);
    if (!(last < largest_harmonic)) {
        mode.harmonics = mode.velocity_harmonics = infinite;
        return;
    }
    double n = 3;
    for (; n <= last; n += 2) {
        const double nR = n * R, uncertain = 2 * n * n * R * mode.R.e;
        const double size = std::hypot((1 - nR) * (1 + nR), 2 * mode.zeta.x * nR) * (1 - 1e-9) - uncertain;
        const double each = size > 0 ? 4 / std::numbers::pi / size : infinite;
        mode.harmonics += each / n;
        mode.velocity_harmonics += each;
    }
    const double beyond = 16 / (3 * std::numbers::pi * R * R) * (1 + 1e-9);
    mode.harmonics += beyond / (4 * (n - 2) * (n - 2));
    mode.velocity_harmonics += beyond / (2 * (n - 2));
}

double above(const Bounded& a) { return std::abs(a.x) + a.e; }

// R^2 times the largest second derivative of the braces of (40): of two amplitudes where the mode oscillates; where it does not,
// the root of y'^2 R^2 + y''^2 R^4 at tau = 0, which never grows.
double largest_acceleration(const ModeAtR& m) {
    const Bounded cosine = 1 + m.g;
    if (m.zeta.x >= 1) return std::hypot(above(m.u * m.R), above(cosine + 2 * m.zeta * m.R * m.u));
    return std::hypot(above(cosine), above((cosine * m.zeta + m.u * m.R) / sqrt(Bounded((1 - m.zeta) * (1 + m.zeta)))));
}

class FewModes {
public:
    FewModes(const Scene<double>& scene, BoundedModes& evaluated_, int digits, bool phases_, std::optional<Mass> only_)
        : j(scene.system.contact.index), l(scene.system.load.index), beta(as_input(*scene.beta)), evaluated(evaluated_),
          basis(evaluated.basis()), tolerance(std::pow(10.0, -digits)), phases(phases_), only(only_) {
        for (std::size_t i = 0; i < N(); ++i) modes.push_back(static_mode(Bounded(evaluated.r() / basis.r_n[i]), basis.zeta[i]));
        if (N() > 1 && !(only && only->index == j))
            for (ModeAtR& mode : modes) add_harmonics(mode);
    }

    std::optional<FewModesSolution> answer() {
        const std::vector<std::size_t> order = by_importance();
        std::size_t done = 0;
        for (std::size_t next = 1; done < N(); next *= 2) {
            for (; done < std::min(next, N()); ++done) evaluate(order[done]);
            std::optional<FewModesSolution> found = attempt(done);
            if (out_of_reach) return std::nullopt;
            if (found) return found;
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] std::size_t N() const { return basis.r_n.size(); }

    void evaluate(std::size_t i) {
        const evaluation::ModeFunctions<Bounded>& f = evaluated.at(i);
        modes[i].v = f.v;
        modes[i].u = f.u;
        modes[i].g = f.g;
    }

    // psi_k psi_m R^2 of a mode.
    [[nodiscard]] Bounded weight(std::size_t k, std::size_t m, std::size_t i) const {
        const auto column = static_cast<Eigen::Index>(i);
        const Bounded& r_n = basis.r_n[i];
        return basis.phi(static_cast<Eigen::Index>(k), column) * basis.phi(static_cast<Eigen::Index>(m), column) / (r_n * r_n);
    }

    // The modes by what leaving each out would cost the contact, largest first.
    [[nodiscard]] std::vector<std::size_t> by_importance() const {
        std::vector<double> cost;
        for (std::size_t i = 0; i < N(); ++i)
            cost.push_back(std::abs(weight(j, l, i).x) * modes[i].v.re.e +
                           beta.x * std::abs(weight(j, j, i).x) * (modes[i].u.e + modes[i].g.e));
        std::vector<std::size_t> order(N());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return cost[a] > cost[b]; });
        return order;
    }

    [[nodiscard]] Complex<Bounded> response_to(std::size_t k, std::size_t m) const {
        Complex<Bounded> V{Bounded(0), Bounded(0)};
        for (std::size_t i = 0; i < N(); ++i) V = V + weight(k, m, i) * modes[i].v;
        return V;
    }

    // A lower bound of the boundary (69).
    [[nodiscard]] double slides_below(const Complex<Bounded>& V_j, const Bounded& U_j) const {
        double S = 0;
        for (std::size_t i = 0; i < N(); ++i) {
            const ModeAtR& m = modes[i];
            const Bounded R_2 = m.R * m.R;
            S += above(weight(j, j, i) / R_2) * std::numbers::pi / 2 * (largest_acceleration(m) + above(R_2 * m.u));
        }
        const Bounded size = modulus(V_j);
        return (size.x - size.e) / std::hypot(S, above(U_j)) * (1 - 1e-12);
    }

    std::optional<FewModesSolution> attempt(std::size_t modes_evaluated) {
        Bounded U_j(0), G_j(0);
        for (std::size_t i = 0; i < N(); ++i) {
            U_j += weight(j, j, i) * modes[i].u;
            G_j += weight(j, j, i) * modes[i].g;
        }
        const Complex<Bounded> V_j = response_to(j, l);
        FewModesSolution all{{}, slides_below(V_j, U_j), modes_evaluated, 0};
        if (!(beta.x + beta.e < all.slides_below)) return std::nullopt;
        const Bounded X_j = evaluation::displacement_transmissibility_of_contact(V_j, U_j, G_j, beta);
        const Bounded phi_j = evaluation::phase_of_contact(V_j, U_j, beta);
        for (std::size_t k = 0; k < N(); ++k) {
            if (only && k != only->index) {
                all.masses.push_back({0, std::nullopt, 0, 0, std::nullopt});
                continue;
            }
            if (k == j) {
                if (!add(all, X_j, phi_j, 0, 0)) return std::nullopt;
                continue;
            }
            // Friction is beta on the half-period from the maximum of x_j on: its first harmonic is 4 beta / pi sin(tau - phi_j).
            const Bounded friction = 4 * beta / pi<Bounded>();
            const Complex<Bounded> Y = response_to(k, j), V = response_to(k, l);
            const Bounded C = friction * cos(phi_j), S = friction * sin(phi_j);
            const Complex<Bounded> H{V.re - S * Y.re + C * Y.im, V.im - C * Y.re - S * Y.im};
            double left_out = 0, velocity_left_out = 0;
            for (std::size_t i = 0; i < N(); ++i) {
                const double size = above(beta * weight(k, j, i));
                left_out += size * modes[i].harmonics;
                velocity_left_out += size * modes[i].velocity_harmonics;
            }
            if (!add(all, modulus(H), -argument(H), left_out, velocity_left_out)) return std::nullopt;
        }
        return all;
    }

    // Notes a mass; false where it has not the digits.
    bool add(FewModesSolution& all, const Bounded& amplitude, const Bounded& phase, double left_out, double velocity_left_out) {
        const double error = amplitude.e + left_out;
        if (!(error <= tolerance * amplitude.x)) {
            // More modes will not make the harmonics smaller, nor the amplitude much larger.
            out_of_reach = out_of_reach || !(left_out <= tolerance * 16 * (amplitude.x + amplitude.e));
            return false;
        }
        const double turn = velocity_left_out / (amplitude.x - amplitude.e);
        const double phase_error = turn < 1 ? phase.e + std::asin(turn) : std::numbers::pi;
        if (phases && !(phase_error <= tolerance)) return false;
        all.masses.push_back({amplitude.x, wrapped(phase.x), error, phase_error, std::nullopt});
        all.relative = std::max({all.relative, error / amplitude.x, phases ? phase_error : 0});
        return true;
    }

    std::size_t j, l;
    Bounded beta;
    BoundedModes& evaluated;
    const ModalBasis<Bounded>& basis;
    double tolerance;
    bool phases;
    std::optional<Mass> only;
    std::vector<ModeAtR> modes;
    bool out_of_reach = false;
};

} // namespace

std::optional<FewModesSolution> few_modes_solution(const Scene<double>& scene, BoundedModes& modes, int digits, bool phases,
                                                   std::optional<Mass> only) {
    if (scene.mu != 1) return std::nullopt;
    return FewModes(scene, modes, digits, phases, only).answer();
}

} // namespace denhartog
