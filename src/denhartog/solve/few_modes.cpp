#include "denhartog/solve/few_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/overdamped.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/contact_modes.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/solve/solve_task.hpp"

namespace denhartog {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double largest_harmonic = 2000;

// What a mode contributes: evaluated, or static with bounds.
struct ModeAtR {
    Bounded<double> R, zeta;
    Complex<Bounded<double>> v;
    Bounded<double> u, g;
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

ModeAtR static_mode(const Bounded<double>& R, const Bounded<double>& zeta) {
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

class FewModes {
public:
    FewModes(const Scene<double>& scene, BoundedModes<double>& evaluated_, int digits, bool phases_, std::optional<Mass> only_)
        : j(scene.system.contact.index), l(scene.system.load.index), beta(as_input(*scene.beta)), evaluated(evaluated_),
          basis(evaluated.basis()), tolerance(std::pow(10.0, -digits)), phases(phases_), only(only_) {
        for (std::size_t i = 0; i < N(); ++i)
            modes.push_back(static_mode(Bounded<double>(evaluated.r() / basis.r_n[i]), basis.zeta[i]));
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
        const evaluation::ModeFunctions<Bounded<double>>& f = evaluated.at(i);
        modes[i].v = f.v;
        modes[i].u = f.u;
        modes[i].g = f.g;
    }

    // psi_k psi_m R^2 of a mode.
    [[nodiscard]] Bounded<double> weight(std::size_t k, std::size_t m, std::size_t i) const {
        const auto column = static_cast<Eigen::Index>(i);
        const Bounded<double>& r_n = basis.r_n[i];
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

    [[nodiscard]] Complex<Bounded<double>> response_to(std::size_t k, std::size_t m) const {
        Complex<Bounded<double>> V{Bounded<double>(0), Bounded<double>(0)};
        for (std::size_t i = 0; i < N(); ++i) V = V + weight(k, m, i) * modes[i].v;
        return V;
    }

    // A lower bound of the boundary (69).
    [[nodiscard]] double slides_below(const Complex<Bounded<double>>& V_j, const Bounded<double>& U_j) const {
        double S = 0;
        for (std::size_t i = 0; i < N(); ++i) {
            const ModeAtR& m = modes[i];
            S += Bounded<double>(weight(j, j, i) / (m.R * m.R)).most() * largest_demand(m.R, m.zeta, {m.u, m.g});
        }
        return least_boundary(V_j, U_j, S * (1 + 1e-12));
    }

    std::optional<FewModesSolution> attempt(std::size_t modes_evaluated) {
        Bounded<double> U_j(0), G_j(0);
        for (std::size_t i = 0; i < N(); ++i) {
            U_j += weight(j, j, i) * modes[i].u;
            G_j += weight(j, j, i) * modes[i].g;
        }
        const Complex<Bounded<double>> V_j = response_to(j, l);
        FewModesSolution all{{}, slides_below(V_j, U_j), modes_evaluated, 0};
        if (!(beta.x + beta.e < all.slides_below)) return std::nullopt;
        const Bounded<double> X_j = evaluation::displacement_transmissibility_of_contact(V_j, U_j, G_j, beta);
        const Bounded<double> phi_j = evaluation::phase_of_contact(V_j, U_j, beta);
        for (std::size_t k = 0; k < N(); ++k) {
            if (only && k != only->index) {
                all.masses.push_back({});
                continue;
            }
            if (k == j) {
                if (!add(all, X_j, phi_j, 0, 0)) return std::nullopt;
                continue;
            }
            // Friction is beta on the half-period from the maximum of x_j on: its first harmonic is 4 beta / pi sin(tau - phi_j).
            const Bounded<double> friction = 4 * beta / pi<Bounded<double>>();
            const Complex<Bounded<double>> Y = response_to(k, j), V = response_to(k, l);
            const Bounded<double> C = friction * cos(phi_j), S = friction * sin(phi_j);
            const Complex<Bounded<double>> H{V.re - S * Y.re + C * Y.im, V.im - C * Y.re - S * Y.im};
            double left_out = 0, velocity_left_out = 0;
            for (std::size_t i = 0; i < N(); ++i) {
                const double size = Bounded<double>(beta * weight(k, j, i)).most();
                left_out += size * modes[i].harmonics;
                velocity_left_out += size * modes[i].velocity_harmonics;
            }
            if (!add(all, modulus(H), -argument(H), left_out, velocity_left_out)) return std::nullopt;
        }
        return all;
    }

    // Notes a mass; false where it has not the digits.
    bool add(FewModesSolution& all, const Bounded<double>& amplitude, const Bounded<double>& phase, double left_out,
             double velocity_left_out) {
        const double error = amplitude.e + left_out;
        if (!(error <= tolerance * amplitude.x)) {
            // More modes will not make the harmonics smaller, nor the amplitude much larger.
            out_of_reach = out_of_reach || !(left_out <= tolerance * 16 * (amplitude.x + amplitude.e));
            return false;
        }
        const double turn = velocity_left_out / (amplitude.x - amplitude.e);
        const double phase_error = turn < 1 ? phase.e + std::asin(turn) : std::numbers::pi;
        if (phases && !(phase_error <= tolerance)) return false;
        all.masses.push_back({{amplitude.x, error, {}}, Certified{wrapped(phase.x), phase_error, {}}, std::nullopt});
        all.relative = std::max({all.relative, error / amplitude.x, phases ? phase_error : 0});
        return true;
    }

    std::size_t j, l;
    Bounded<double> beta;
    BoundedModes<double>& evaluated;
    const ModalBasis<Bounded<double>>& basis;
    double tolerance;
    bool phases;
    std::optional<Mass> only;
    std::vector<ModeAtR> modes;
    bool out_of_reach = false;
};

} // namespace

std::optional<FewModesSolution> few_modes_solution(const Scene<double>& scene, BoundedModes<double>& modes, int digits,
                                                   bool phases, std::optional<Mass> only) {
    if (scene.mu != 1) return std::nullopt;
    return FewModes(scene, modes, digits, phases, only).answer();
}

bool answer_by_few_modes(SolveTask& task, Solution& s) {
    constexpr int most_digits_few_modes = 8; // beyond, harmonics and static modes are too coarse
    if (task.aim.digits > most_digits_few_modes) return false;
    std::optional<FewModesSolution> few;
    try {
        few =
            few_modes_solution(task.scene, *task.modes, task.aim.digits, task.question.asked == Asked::phase, task.question.mass);
    } catch (const DomainError&) {
        return false; // the next model says where the pole is
    }
    if (!few) return false;
    const std::size_t N = task.basis->r_n.size();
    s.slides_below = Certified{few->slides_below, 0, {}};
    s.masses = std::move(few->masses);
    s.regime = {Regime::continuous, {}, false, certainly_slides};
    std::string why = "the bound of rounding and of what is left out leaves the " + in_words(task.aim);
    if (few->modes < N)
        why = std::to_string(few->modes) + " of " + std::to_string(N) + " modes, the others by their static displacement; " + why;
    s.method = {N == 1 ? "closed form" : "closed form, first harmonic of the masses not in contact", "double", why};
    s.relative_error = few->relative;
    return true;
}

} // namespace denhartog