// (44), (45), (46), (A.7) as printed and as corrected over a period, with the paper's algorithm as the witness.
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "markers.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::printed_against_corrected_motion {

const double r = 0.9, beta = 0.2;

/// The scene with what the modes are there.
struct Moving {
    System<double> system = five_masses(1, 0.1);
    ModeSums<double> sums = mode_sums(modal_basis(system), system.contact, system.load, r);
    SteadyState<double> state = steady_state(sums, boundary(sums, 1.0), beta);
};

/// A function over the half-period from a maximum of the contact, with the sign changed in the other half.
double antisymmetric(double tau, const std::function<double(double tau)>& f) {
    const double half = std::floor(tau / pi<double>()), sign = std::fmod(std::abs(half), 2) == 0 ? 1 : -1;
    return sign * f(tau - half * pi<double>());
}

double displacement_46_as_printed(const Moving& s, Mass k, double tau) {
    const std::span<const double> psi_k = mode_shapes_at(s.sums, k), psi_j = mode_shapes_at(s.sums, s.sums.contact);
    const std::span<const double> R(s.sums.R), zeta(s.sums.zeta), u(s.sums.u), g(s.sums.g);
    const double F_k = as_printed::friction_motion_of_mass(tau, psi_k, psi_j, R, zeta, u, g);
    const std::size_t j = s.sums.contact.index;
    return paper::steady_displacement(tau, s.sums.V[k.index], s.sums.V[j], s.sums.U[j], beta, F_k);
}

/// (41) as corrected from the initial values (44) and (45) as printed.
double displacement_from_44_45_as_printed(const Moving& s, Mass k, double tau) {
    const std::span<const double> psi_k = mode_shapes_at(s.sums, k), psi_j = mode_shapes_at(s.sums, s.sums.contact);
    const std::span<const double> R(s.sums.R), zeta(s.sums.zeta), u(s.sums.u), g(s.sums.g);
    const double F_k = paper::friction_motion_of_mass(tau, psi_k, psi_j, R, zeta, u, g);
    const std::size_t n = k.index, j = s.sums.contact.index;
    const double x_0 = as_printed::initial_displacement(s.sums.V[n], s.sums.V[j], s.sums.U[j], s.sums.G[n], beta);
    const double v_0 = as_printed::initial_velocity(s.sums.V[n], s.sums.V[j], s.sums.U[j], s.sums.U[n], beta);
    return paper::displacement(tau, x_0, v_0, s.sums.G[n], s.sums.U[n], beta, F_k);
}

/// A modal coordinate, by (17): psi^T M, all masses being equal. @param of_masses displacements or velocities
double of_mode(const Moving& s, std::size_t i, const std::vector<double>& of_masses) {
    double sum = 0;
    for (std::size_t k = 0; k < of_masses.size(); ++k) sum += mode_shapes_at(s.sums, Mass{k})[i] * r * r * of_masses[k];
    return sum;
}

double modal_velocity_as_printed(const Moving& s, std::size_t i, double tau) {
    const ModeInScene<double> mode{s.sums.R[i], s.sums.zeta[i], mode_shapes_at(s.sums, s.sums.contact)[i],
                                   mode_shapes_at(s.sums, s.sums.load)[i]};
    const Motion<double> start = motion(s.sums, s.state, 0.0);
    return as_printed::modal_velocity_from_start(tau, mode, {of_mode(s, i, start.x), of_mode(s, i, start.x_prime)}, beta,
                                                 s.state.phi_j);
}

/// A quantity over time: as corrected, as printed in one or two ways, and by the paper's algorithm.
struct Panel {
    std::string name;                                       ///< of its tables
    std::string what;                                       ///< which quantity
    std::function<double(const Motion<double>&)> of_motion; ///< as corrected
    std::function<double(const State&)> of_state;           ///< by the algorithm
    std::vector<std::string> equations;                     ///< printed, in the order of `printed`
    std::vector<std::function<double(double tau)>> printed; ///< over the half-period
};

/// Tables `NAME` (tau / pi from the maximum of the contact) and `markers NAME`; differences over the largest value.
void add(Figure& figure, Record& record, const Moving& s, const PaperMotion& numerical, const Panel& p) {
    Table lines{p.name, {"tau over pi", "corrected"}, {}}, dots{"markers " + p.name, {"tau over pi", "numerical"}, {}};
    for (const std::string& each : p.equations) lines.columns.push_back(each + " as printed");
    double largest = 0;
    for (const double part : spaced(0, 2, 401)) {
        const double tau = part * pi<double>();
        lines.rows.push_back({part, p.of_motion(motion(s.sums, s.state, tau))});
        largest = std::max(largest, std::abs(lines.rows.back()[1]));
        for (const auto& f : p.printed) lines.rows.back().push_back(antisymmetric(part < 2 ? tau : 0, f));
    }
    std::vector<std::vector<std::pair<double, std::string>>> off(1 + p.printed.size());
    for (std::size_t n = 0; n < numerical.samples.size(); ++n) {
        const double turn = 2 * pi<double>(), from_force = numerical.sample_times[n] - s.state.phi_j;
        const double tau = from_force - turn * std::floor(from_force / turn), x = p.of_state(numerical.samples[n]);
        const std::string where = "tau = " + text(tau / pi<double>(), "%.3f") + " pi";
        dots.rows.push_back({tau / pi<double>(), x});
        off[0].emplace_back((p.of_motion(motion(s.sums, s.state, tau)) - x) / largest, where);
        for (std::size_t m = 0; m < p.printed.size(); ++m)
            off[m + 1].emplace_back((antisymmetric(tau, p.printed[m]) - x) / largest, where);
    }
    figure.add(lines);
    figure.add(dots);
    const std::string panel = "(" + p.name + ") " + p.what;
    record.agreements.push_back(agreement(panel + " as corrected against the markers, over its largest value", off[0]));
    const double corrected = record.agreements.back().worst;
    for (std::size_t m = 0; m < p.printed.size(); ++m) {
        record.agreements.push_back(agreement(panel + ", " + p.equations[m] + " as printed, the same", off[m + 1]));
        const Agreement& printed = record.agreements.back();
        record.statements.push_back({"(" + p.name + ") " + p.equations[m] + " as printed gives the motion as well as corrected",
                                     "off by up to " + text(100 * printed.worst, "%.3g") + " percent of the largest value (" +
                                         printed.where + "), as corrected by " +
                                         (corrected < 1e-4 ? "less than 0.01" : text(100 * corrected, "%.2g")),
                                     printed.worst <= 2 * corrected});
    }
}

/// Jump of a printed form where one half-period meets the next, over the largest value.
double jump(const std::function<double(double tau)>& f, double largest) { return std::abs(f(0) + f(pi<double>())) / largest; }

Record make(Figure& figure) {
    const Moving s;
    PaperSettings settings;
    settings.samples = 40;
    const PaperMotion numerical = markers(figure, s.system, 1, {{r, beta}}, settings).front().motion;
    const Mass contact = s.sums.contact, other{2};
    const std::size_t mode = 1;
    Record record;
    record.title = "Time responses as printed and as corrected: (44), (45), (46), (A.7)";
    record.equations = {"44", "45", "46", "41", "A.7"};
    record.given = {"Scene of Fig. 4b: 5DOF, equal masses and springs, j = 1, l = 1, mu = 1, beta = 0.2, r = 0.9, zeta_i = 0.1",
                    "200 periods from rest, absolute tolerance 1e-6"};
    record.chosen = {"(a) mass 1, the contact", "(b) mass 3; there (41) as corrected is started with (44) and (45) as printed",
                     "(c) velocity of mode 2", "a period from the maximum of the contact; 40 markers"};
    const auto of_mass = [&](Mass k) { return [k](const auto& at) { return at.x[k.index]; }; };
    const auto velocity = [&](const auto& at) { return of_mode(s, mode, at.x_prime); };
    const std::vector<Panel> panels{
        {"a", "displacement of mass 1", of_mass(contact), of_mass(contact), {"(46)"}, {[&](double tau) {
             return displacement_46_as_printed(s, contact, tau);
         }}},
        {"b",
         "displacement of mass 3",
         of_mass(other),
         of_mass(other),
         {"(46)", "(44), (45)"},
         {[&](double tau) { return displacement_46_as_printed(s, other, tau); },
          [&](double tau) { return displacement_from_44_45_as_printed(s, other, tau); }}},
        {"c", "velocity of mode 2", velocity, velocity, {"(A.7)"}, {[&](double tau) {
             return modal_velocity_as_printed(s, mode, tau);
         }}}};
    for (const Panel& p : panels) add(figure, record, s, numerical, p);
    const double jump_46 = jump(panels[0].printed[0], s.state.X_j);
    record.statements.push_back({"(a) The half-period of (46) as printed ends where its mirror image begins",
                                 "it misses it by " + text(100 * jump_46, "%.3g") + " percent of the amplitude", jump_46 < 1e-9});
    const double at_start = displacement_46_as_printed(s, contact, 0);
    record.statements.push_back({"(a) At tau = 0 the contact is at its maximum, (38)",
                                 "(46) as printed has " + text(at_start) + " there, (38) " + text(s.state.X_j),
                                 std::abs(at_start / s.state.X_j - 1) < 1e-9});
    record.remarks = {
        "The bracket that (46) prints with sine and cosine exchanged is that of (40), (41) and (A.15) too.",
        "(44) and (45) are drawn by their real parts; for the contact, whose angle with itself is zero, they are right."};
    return record;
}

const Listed listed("printed_against_corrected_motion", make);

} // namespace denhartog::figures::printed_against_corrected_motion
