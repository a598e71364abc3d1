#include "denhartog/solve/truncated_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "denhartog/answer/certify.hpp"
#include "denhartog/elementary/elementary.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/sliding/contact_modes.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/solve/solve_task.hpp"
#include "denhartog/sums/static_mode.hpp"

namespace denhartog {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double largest_harmonic = 2000;
constexpr double much_larger = 16; // what more modes will not make of an amplitude

// What the first harmonic of a force does to a mode at most, and the higher ones of friction, 4 beta / (n pi) for odd n from 3 on.
struct Harmonics {
    double response = infinite; // 1 / |1 - R^2 + 2 i zeta R|
    double displacement = 0;    // sum of 4 / (n pi) / |1 - n^2 R^2 + 2 i zeta n R|
    double velocity = 0;        // the same with n times each term
};

// Harmonics up to n R = 2 one by one, beyond by the integral: there |1 - n^2 R^2| is at least 3/4 n^2 R^2.
Harmonics harmonics_of(const Bounded<double>& R_i, double zeta) {
    const double R = R_i.x, last = std::max(3.0, 2 / R + 2);
    if (!(last < largest_harmonic)) return {infinite, infinite, infinite};
    const auto over_stiffness = [&](double force, double n) {
        const double nR = n * R, uncertain = 2 * n * n * R * R_i.e;
        const double size = elementary::hypot((1 - nR) * (1 + nR), 2 * zeta * nR) * (1 - 1e-9) - uncertain;
        return size > 0 ? force / size : infinite;
    };
    Harmonics all{over_stiffness(1, 1)};
    const long one_by_one = static_cast<long>((last - 1) / 2);
    for (long harmonic = 0; harmonic < one_by_one; ++harmonic) {
        const double n = static_cast<double>(2 * harmonic + 3);
        const double each = over_stiffness(4 / std::numbers::pi, n);
        all.displacement += each / n;
        all.velocity += each;
    }
    const double beyond = 16 / (3 * std::numbers::pi * R * R) * (1 + 1e-9), n = static_cast<double>(2 * one_by_one + 1);
    all.displacement += beyond / (4 * n * n);
    all.velocity += beyond / (2 * n);
    return all;
}

class TruncatedModes {
public:
    TruncatedModes(const Scene<double>& scene, BoundedModes<double>& evaluated_, int digits, bool phases_,
                   std::optional<Mass> only_)
        : j(scene.system.contact.index), l(scene.system.load.index), beta(as_input(*scene.beta)), evaluated(evaluated_),
          basis(evaluated.basis()), tolerance(tolerance_of(digits)), phases(phases_), only(only_) {}

    std::optional<TruncatedModesSolution> answer() {
        if (N() > 1 && !(only && only->index == j)) {
            harmonics.reserve(N());
            for (std::size_t i = 0; i < N(); ++i) harmonics.push_back(harmonics_of(ratio(i), basis.zeta[i].x));
            if (leaves_out_too_much(only ? only->index : j == 0 ? 1 : 0)) return std::nullopt;
        }
        contact = contact_modes(evaluated.shared_basis(), Mass{j}, Mass{l});
        functions.reserve(N());
        for (std::size_t i = 0; i < N(); ++i) functions.push_back(static_mode_functions(ratio(i).x, basis.zeta[i].x));
        const std::vector<std::size_t> order = by_importance();
        std::size_t done = 0;
        for (std::size_t next = 1; done < N(); next *= 2) {
            for (; done < std::min(next, N()); ++done) functions[order[done]] = evaluated.at(order[done]);
            std::optional<TruncatedModesSolution> found = attempt(done);
            if (out_of_reach) return std::nullopt;
            if (found) return found;
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] std::size_t N() const { return basis.r_n.size(); }

    [[nodiscard]] Bounded<double> ratio(std::size_t i) const { return evaluated.r() / basis.r_n[i]; }

    // psi_k psi_m R^2 of a mode.
    [[nodiscard]] Bounded<double> weight(std::size_t i, std::size_t k, std::size_t m) const {
        const auto column = static_cast<Eigen::Index>(i);
        return evaluation::array_weights(basis.phi(static_cast<Eigen::Index>(k), column),
                                         basis.phi(static_cast<Eigen::Index>(m), column), basis.r_n[i], basis.zeta[i])
            .load;
    }
    [[nodiscard]] std::vector<Bounded<double>> weights(std::size_t k, std::size_t m) const {
        std::vector<Bounded<double>> all;
        all.reserve(N());
        for (std::size_t i = 0; i < N(); ++i) all.push_back(weight(i, k, m));
        return all;
    }

    // Whether the higher harmonics of a mass not in contact are too large beside all that its amplitude can be. More modes will not
    // make them smaller.
    [[nodiscard]] bool leaves_out_too_much(std::size_t k) const {
        double left_out = 0, most = 0;
        for (std::size_t i = 0; i < N(); ++i) {
            const Bounded<double> of_friction = weight(i, k, j);
            left_out += of_friction.least() * harmonics[i].displacement;
            most += (weight(i, k, l).most() + 4 / std::numbers::pi * beta.most() * of_friction.most()) * harmonics[i].response;
        }
        return beta.least() * left_out > tolerance * much_larger * most;
    }

    // The modes by what leaving each out would cost the contact, largest first.
    [[nodiscard]] std::vector<std::size_t> by_importance() const {
        std::vector<double> cost;
        for (std::size_t i = 0; i < N(); ++i)
            cost.push_back(std::abs(contact.modes[i].weights.load.x) * functions[i].v.re.e +
                           beta.x * std::abs(contact.modes[i].weights.contact.x) * (functions[i].u.e + functions[i].g.e));
        std::vector<std::size_t> order(N());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return cost[a] > cost[b]; });
        return order;
    }

    [[nodiscard]] Complex<Bounded<double>> response_by(const std::vector<Bounded<double>>& weights) const {
        Complex<Bounded<double>> V{Bounded<double>(0), Bounded<double>(0)};
        for (std::size_t i = 0; i < N(); ++i) V = V + weights[i] * functions[i].v;
        return V;
    }

    std::optional<TruncatedModesSolution> attempt(std::size_t modes_evaluated) {
        const std::optional<ContactSolution<double>> of_contact =
            contact_solution(sums_at_contact(contact, evaluated.r(), functions), beta);
        if (!of_contact) return std::nullopt;
        const Bounded<double>& phi_j = of_contact->phase;
        TruncatedModesSolution all{{}, of_contact->slides_below.x, modes_evaluated, 0};
        for (std::size_t k = 0; k < N(); ++k) {
            if (only && k != only->index) {
                all.masses.push_back({});
                continue;
            }
            if (k == j) {
                if (!add(all, of_contact->amplitude, phi_j, 0, 0)) return std::nullopt;
                continue;
            }
            // Friction is beta on the half-period from the maximum of x_j on: its first harmonic is 4 beta / pi sin(tau - phi_j).
            const std::vector<Bounded<double>> of_friction = weights(k, j);
            const Bounded<double> friction = 4 * beta / pi<Bounded<double>>();
            const Complex<Bounded<double>> Y = response_by(of_friction), V = response_by(weights(k, l));
            const Bounded<double> C = friction * cos(phi_j), S = friction * sin(phi_j);
            const Complex<Bounded<double>> H{V.re - S * Y.re + C * Y.im, V.im - C * Y.re - S * Y.im};
            double left_out = 0, velocity_left_out = 0;
            for (std::size_t i = 0; i < N(); ++i) {
                const double size = Bounded<double>(beta * of_friction[i]).most();
                left_out += size * harmonics[i].displacement;
                velocity_left_out += size * harmonics[i].velocity;
            }
            if (!add(all, modulus(H), -argument(H), left_out, velocity_left_out)) return std::nullopt;
        }
        return all;
    }

    // Notes a mass; false where it has not the digits.
    bool add(TruncatedModesSolution& all, const Bounded<double>& amplitude, const Bounded<double>& phase, double left_out,
             double velocity_left_out) {
        const double error = amplitude.e + left_out;
        if (!(error <= tolerance * amplitude.x)) {
            // More modes will not make the harmonics smaller, nor the amplitude much larger.
            out_of_reach = out_of_reach || !(left_out <= tolerance * much_larger * (amplitude.x + amplitude.e));
            return false;
        }
        const double turn = velocity_left_out / (amplitude.x - amplitude.e);
        const double phase_error = turn < 1 ? phase.e + largest_turn(turn, 1.0) : std::numbers::pi;
        if (phases && !(phase_error <= tolerance)) return false;
        SolvedMass& mass = all.masses.emplace_back();
        mass.amplitude = {amplitude.x, error};
        mass.phase = Certified{wrapped(phase.x), phase_error};
        all.relative = std::max({all.relative, error / amplitude.x, phases ? phase_error : 0});
        return true;
    }

    std::size_t j, l;
    Bounded<double> beta;
    BoundedModes<double>& evaluated;
    const ModalBasis<Bounded<double>>& basis;
    ContactModes<double> contact;
    double tolerance;
    bool phases;
    std::optional<Mass> only;
    std::vector<evaluation::ModeFunctions<Bounded<double>>> functions; // evaluated, or static with bounds
    std::vector<Harmonics> harmonics;
    bool out_of_reach = false;
};

} // namespace

std::optional<TruncatedModesSolution> truncated_modes_solution(const Scene<double>& scene, BoundedModes<double>& modes,
                                                               int digits, bool phases, std::optional<Mass> only) {
    if (scene.mu != 1) return std::nullopt;
    return TruncatedModes(scene, modes, digits, phases, only).answer();
}

bool answer_by_truncated_modes(SolveTask& task, Solution& s) {
    constexpr int most_digits = 8; // beyond, harmonics and static modes are too coarse
    if (task.aim.digits > most_digits || !task.scene.system.coordinates.replaced.empty()) return false;
    std::optional<TruncatedModesSolution> few;
    try {
        few = truncated_modes_solution(task.scene, *task.modes, task.aim.digits, task.question.asked == Asked::phase,
                                       task.question.mass);
    } catch (const DomainError&) {
        return false; // the next model says where the pole is
    }
    if (!few) return false;
    const std::size_t N = task.known.basis->r_n.size();
    s.slides_below = Certified{few->slides_below, 0, {}};
    s.masses = std::move(few->masses);
    s.regime = {Regime::continuous, {}, false, certainly_slides};
    std::string why = "the error bound, which includes the modes left out, guarantees the " + in_words(task.aim);
    if (few->modes < N)
        why = std::to_string(few->modes) + " of " + std::to_string(N) +
              " modes are summed, the others give their static displacement; " + why;
    s.method = {N == 1 ? "closed form" : "closed form, first harmonic of the masses not in contact", "double", why};
    s.relative_error = few->relative;
    return true;
}

} // namespace denhartog