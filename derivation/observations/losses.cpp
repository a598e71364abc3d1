#include "derivation/observations/losses.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>

#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "derivation/observations/boundary_maxima.hpp"
#include "derivation/observations/resonance_losses.hpp"
#include "derivation/observations/sliding_scenes.hpp"

namespace denhartog::derivation {

namespace {

constexpr int instants = 64;

double instant(int n) { return pi<double>() * n / instants; }

/// The largest amplitude of any mass: what errors of displacements are measured by, so that a mass at rest does not count.
double largest_amplitude(const SlidingScene& s) {
    double largest = 0;
    for (const MassResponse<double>& mass : s.state.masses) largest = std::max(largest, mass.amplitude);
    return largest;
}

/// Largest error of the displacement of any mass with (46)'s sum as printed, over the largest amplitude.
double displacement_error(const SlidingScene& s) {
    const ModeSums<double>& m = s.sums;
    const std::span<const double> psi_j = mode_shapes_at(m, m.contact);
    double worst = 0;
    for (std::size_t k = 0; k < m.V.size(); ++k) {
        const std::span<const double> psi_k = mode_shapes_at(m, Mass{k});
        for (int n = 0; n <= instants; ++n) {
            const double printed = as_printed::friction_motion_of_mass<double>(instant(n), psi_k, psi_j, m.R, m.zeta, m.u, m.g);
            const double correct = paper::friction_motion_of_mass<double>(instant(n), psi_k, psi_j, m.R, m.zeta, m.u, m.g);
            worst = std::max(worst, s.state.beta * std::abs(printed - correct));
        }
    }
    return worst / largest_amplitude(s);
}

/// Largest error of a quantity of a mode over the half-period, over its largest value.
double modal_error(const SlidingScene& s,
                   const std::function<std::pair<double, double>(const ModeInScene<double>&, const InitialValues<double>&,
                                                                 std::size_t, double)>& printed_and_correct) {
    double worst = 0;
    for (std::size_t i = 0; i < s.sums.R.size(); ++i) {
        double error = 0, size = 0;
        for (int n = 0; n <= instants; ++n) {
            const auto [printed, correct] = printed_and_correct(mode_of(s, i), start_of_mode(s, i), i, instant(n));
            error = std::max(error, std::abs(printed - correct));
            size = std::max(size, std::abs(correct));
        }
        if (size > 0) worst = std::max(worst, error / size);
    }
    return worst;
}

/// Largest value over the masses of a relative error.
double over_masses(const SlidingScene& s, const std::function<double(std::size_t k)>& error) {
    double worst = 0;
    for (std::size_t k = 0; k < s.sums.V.size(); ++k) {
        const double e = error(k);
        if (std::isnan(e)) return e;
        worst = std::max(worst, e);
    }
    return worst;
}

double monoharmonic_error(const SlidingScene& s, const std::function<double(std::size_t k)>& printed) {
    return over_masses(
        s, [&](std::size_t k) { return std::abs(printed(k) - s.state.masses[k].amplitude_monoharmonic) / largest_amplitude(s); });
}

/// Relative error of a boundary, with a sum S of one's own in (69).
double boundary_error(const SlidingScene& s, double S, double correct) {
    return std::abs(limit_with_sum(s, S) - correct) / correct;
}

/// Relative error of the boundary (67) where (63) is asked of every mode: the first friction ratio, in steps of 1/256 of (67), at
/// which a mode fails.
double mode_by_mode_error(const SlidingScene& s) {
    const std::size_t j = s.sums.contact.index;
    const double limit = paper::friction_ratio_limit(s.sums.V[j], s.sums.U[j],
                                                     paper::static_friction_demand(s.sums.H_j, s.mu, s.sums.sum_of_squares));
    for (int n = 1; n < 256; ++n)
        if (!every_mode_meets_63(s, limit * n / 256)) return 1 - n / 256.0;
    return 0;
}

/// Relative error of the boundary by (58) and "(67) or (68)" with (68) as printed: if (68) begins below (58), (58) alone is left.
double error_with_68(const SlidingScene& s) {
    const ModeSums<double>& m = s.sums;
    const std::size_t j = m.contact.index;
    const double by_58 = paper::friction_ratio_limit(m.V[j], m.U[j], s.boundary.S_exact);
    const double by_68 = paper::friction_ratio_limit(m.V[j], m.U[j], m.H_j - s.mu * m.sum_of_squares);
    return by_68 < by_58 ? by_58 / s.boundary.exact - 1 : 0;
}

/// Relative error of the boundary of permanent sticking by (88); none where the system is no chain.
std::optional<double> error_with_88(const SlidingScene& s) {
    const StuckConfiguration stuck = stuck_configuration(s.system, s.basis);
    const StuckResponse response = stuck_response(stuck, s.system.load, s.sums.r);
    const StickingBoundary b = sticking_boundary(response, stuck_chain(s.system, stuck), s.mu);
    if (!b.paper) return std::nullopt;
    return std::abs(*b.paper / b.exact - 1);
}

struct Measure {
    std::string quantity;
    std::function<std::optional<double>(const SlidingScene&)> error; ///< none where the equation does not speak of the scene
};

const std::map<std::string, Measure>& measures() {
    static const Measure displacement{"displacement of a mass, relative to the largest amplitude", displacement_error};
    static const Measure modal_displacement{
        "modal displacement, relative to its largest value", [](const SlidingScene& s) {
            return modal_error(
                s, [&s](const ModeInScene<double>& m, const InitialValues<double>& start, std::size_t i, double tau) {
                    return std::pair(as_printed::modal_displacement(tau, m, start, s.sums.u[i], s.sums.g[i], s.state.beta),
                                     paper::modal_displacement(tau, m, start, s.sums.u[i], s.sums.g[i], s.state.beta));
                });
        }};
    static const Measure sum_of_maxima{"friction ratio at the boundary (69) with (56), relative", [](const SlidingScene& s) {
                                           return (s.boundary.exact - s.boundary.paper) / s.boundary.exact;
                                       }};
    static const Measure mode_by_mode{"friction ratio at the boundary (67) where the condition is asked of every mode, relative",
                                      mode_by_mode_error};
    static const std::map<std::string, Measure> all{
        {"40", modal_displacement},
        {"A.15", modal_displacement},
        {"41", displacement},
        {"46", displacement},
        {"A.7",
         {"modal velocity, relative to its largest value",
          [](const SlidingScene& s) {
              return modal_error(
                  s, [&s](const ModeInScene<double>& m, const InitialValues<double>& start, std::size_t, double tau) {
                      return std::pair(as_printed::modal_velocity_from_start(tau, m, start, s.state.beta, s.state.phi_j),
                                       paper::modal_velocity_from_start(tau, m, start, s.state.beta, s.state.phi_j));
                  });
          }}},
        {"44",
         {"initial displacement of a mass, relative to the largest amplitude",
          [](const SlidingScene& s) {
              return over_masses(s, [&s](std::size_t k) {
                  const std::size_t j = s.sums.contact.index;
                  const double printed =
                      as_printed::initial_displacement(s.sums.V[k], s.sums.V[j], s.sums.U[j], s.sums.G[k], s.state.beta);
                  return std::abs(printed - s.state.masses[k].x0) / largest_amplitude(s);
              });
          }}},
        {"45",
         {"initial velocity of a mass, relative to the largest amplitude",
          [](const SlidingScene& s) {
              return over_masses(s, [&s](std::size_t k) {
                  const std::size_t j = s.sums.contact.index;
                  const double printed =
                      as_printed::initial_velocity(s.sums.V[k], s.sums.V[j], s.sums.U[j], s.sums.U[k], s.state.beta);
                  return std::abs(printed - s.state.masses[k].v0) / largest_amplitude(s);
              });
          }}},
        {"50",
         {"monoharmonic amplitude of a mass from (50) and (51), relative to the largest amplitude",
          [](const SlidingScene& s) {
              return monoharmonic_error(s, [&s](std::size_t k) {
                  const std::size_t j = s.sums.contact.index;
                  return std::hypot(
                      as_printed::monoharmonic_cosine(s.sums.V[k], s.sums.V[j], s.sums.U[j], s.sums.G[k], s.state.beta),
                      s.state.masses[k].v0);
              });
          }}},
        {"52",
         {"monoharmonic amplitude of a mass, relative to the largest amplitude",
          [](const SlidingScene& s) {
              return monoharmonic_error(s, [&s](std::size_t k) {
                  const std::size_t j = s.sums.contact.index;
                  return as_printed::displacement_transmissibility(s.sums.V[k], s.sums.V[j], s.sums.U[j], s.sums.U[k],
                                                                   s.sums.G[k], s.state.beta);
              });
          }}},
        {"81", {"amplitude of a mass at a resonance, relative to the largest", error_with_81}},
        {"82", {"amplitude of a mass at a resonance, relative to the largest", error_with_82}},
        {"86", {"friction ratio at the boundary for r -> infinity, relative", error_with_86}},
        {"56", sum_of_maxima},
        {"69", sum_of_maxima},
        {"59", mode_by_mode},
        {"63", mode_by_mode},
        {"88",
         {"friction ratio from which the contact rests for ever, chains at their frequency ratio, relative", error_with_88}},
        {"68", {"friction ratio at the end of the sliding regime by (58) and \"(67) or (68)\", relative", error_with_68}},
        {"57",
         {"friction ratio at the boundary (69), relative; it is zero where the printed expression grows beyond bounds",
          [](const SlidingScene& s) { return boundary_error(s, printed_sum_of_maxima(s), s.boundary.exact); }}},
        {"70",
         {"friction ratio at the boundary (67), mu = 1, with S_dj from (70) at tau = 1e-6 in place of (72), relative",
          [](const SlidingScene& s) {
              double S = 0;
              for (std::size_t i = 0; i < s.sums.R.size(); ++i)
                  S += std::pow(mode_of(s, i).psi_ji, 2) *
                       as_printed::s_d_expansion(1e-6, s.sums.R[i], s.sums.zeta[i], s.sums.u[i], s.sums.g[i]);
              const std::size_t j = s.sums.contact.index;
              const double correct = paper::friction_ratio_limit(
                  s.sums.V[j], s.sums.U[j], paper::static_friction_demand(s.sums.H_j, 1.0, s.sums.sum_of_squares));
              return std::abs(paper::friction_ratio_limit(s.sums.V[j], s.sums.U[j], S) - correct) / correct;
          }}},
    };
    return all;
}

/// The worst loss by (56) over the frequency ratio, in the paper's systems.
void search_over_frequency(Loss& loss) {
    static const std::pair<LargestOverRange, std::string> worst = [] {
        std::pair<LargestOverRange, std::string> found{{0, 0}, ""};
        for (const ObservedSystem& s : systems_of_the_paper()) {
            const LargestOverRange most = largest_over_frequency(s, 0.1, 3, loss_by_56);
            if (most.value > found.first.value) found = {most, s.name + ", r = " + std::to_string(most.x)};
        }
        return found;
    }();
    loss.searched = worst.first.value;
    loss.place = worst.second;
}

} // namespace

std::optional<Loss> loss_of(const std::string& equation) {
    const auto found = measures().find(equation);
    if (found == measures().end()) return std::nullopt;
    Loss loss;
    loss.quantity = found->second.quantity;
    for (const SlidingScene& scene : sliding_scenes()) {
        const std::optional<double> error = found->second.error(scene);
        if (!error) continue;
        ++loss.scenes;
        if (!std::isfinite(*error)) {
            ++loss.without_value;
            continue;
        }
        double& worst = scene.of_the_paper ? loss.on_paper : loss.on_others;
        if (*error > worst) {
            worst = *error;
            (scene.of_the_paper ? loss.paper_scene : loss.other_scene) = scene.name;
        }
    }
    if (equation == "56" || equation == "69") search_over_frequency(loss);
    return loss;
}

std::string sentence(const Loss& loss) {
    std::ostringstream text;
    text.precision(3);
    const auto off = [&text](double error, const char* where, const std::string& scene) {
        text << (error < 10 ? 100 * error : error) << (error < 10 ? " %" : " times") << where;
        if (!scene.empty()) text << " (" << scene << ")";
    };
    text << loss.quantity << ": off by up to ";
    if (loss.searched > 0) {
        off(loss.searched, " in the paper's systems over all r from 0.1 to 3", loss.place);
        text << ", ";
    }
    off(loss.on_paper, " on the grid of the paper's scenes", loss.paper_scene);
    text << ", ";
    off(loss.on_others, " in asymmetric scenes drawn at random", loss.other_scene);
    text << "; " << loss.scenes << " scenes";
    if (loss.without_value > 0) text << ", " << loss.without_value << " of them without a real value";
    return text.str();
}

} // namespace denhartog::derivation
