// Errors of (48)-(53), (67), (71), (72), (88) over frequency, friction and damping.
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "error_curves.hpp"
#include "peak.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::error_of_approximations {

/// Modes and boundary at a point, with the steady state.
struct Sliding {
    ModeSums<double> sums;
    SteadyState<double> state;
};

/// The steady state at a fraction of the boundary (69).
Sliding sliding(const WithModes& s, double r, double fraction) {
    const ModeSums<double> sums = s.at(r);
    const Boundary<double> limits = boundary(sums, 1.0);
    return {sums, steady_state(sums, limits, fraction * limits.exact)};
}

double error_of_52(const Sliding& s, Mass k) {
    const MassResponse<double>& mass = s.state.masses[k.index];
    return std::abs(mass.amplitude_monoharmonic / mass.amplitude - 1);
}

/// Radians. Compared is the phase from the instant of the largest displacement, (47).
double error_of_53(const Sliding& s, Mass k) {
    const MassResponse<double>& mass = s.state.masses[k.index];
    return std::abs(wrapped(mass.phase_monoharmonic - mass.phase));
}

/// Largest difference over the half-period of (48), which is (49) with (50) and (51), from (46), over the amplitude.
double error_of_48(const Sliding& s, Mass k) {
    const MassResponse<double>& mass = s.state.masses[k.index];
    double worst = 0;
    for (int n = 0; n <= 64; ++n) {
        const double tau = pi<double>() * n / 64;
        const double x = paper::monoharmonic_displacement(tau, mass.x0, mass.v0);
        worst = std::max(worst, std::abs(x - motion(s.sums, s.state, tau).x[k.index]));
    }
    return worst / mass.amplitude;
}

double error_of_67(const WithModes& s, double r) {
    const Boundary<double> b = boundary(s.at(r), 1.0);
    return std::abs(b.approximate / b.exact - 1);
}

/// (71) against the maximum (57) of the mode of a single mass.
double error_of_71(const WithModes& s, double R) {
    const ModeSums<double> m = s.at(R);
    return std::abs(paper::s_d_at_zero(m.R[0], m.zeta[0], m.u[0], m.g[0]) * m.sum_of_squares / boundary(m, 1.0).S_exact - 1);
}

double error_of_72(const WithModes& s, double r) {
    const ModeSums<double> m = s.at(r);
    return std::abs(paper::static_friction_demand(m.H_j, 1.0, m.sum_of_squares) / boundary(m, 1.0).S_exact - 1);
}

/// (88) as printed against the boundary of permanent sticking.
std::function<double(double)> error_of_88(const WithModes& s) {
    const StuckConfiguration stuck = stuck_configuration(s.system, s.basis);
    return [stuck, chain = stuck_chain(s.system, stuck), j = s.system.contact, l = s.system.load](double r) {
        const StickingBoundary b = sticking_boundary(stuck_response(stuck, l, r), chain, 1.0);
        return std::abs(b.paper.value() / b.exact - 1);
    };
}

Record make(Figure& figure) {
    const std::vector<double> r = spaced(0.1, 2.5, 961), fractions = spaced_in_octaves(1e-3, 0.999, 61);
    const Mass first{0};
    Record record;
    record.title = "Errors of (48)-(53), (67), (71), (72), (88) over frequency, friction and damping";
    record.equations = {"48", "49", "50", "51", "52", "53", "67", "71", "72", "88"};
    record.given = {"2DOF of Figs. 8 to 10: j = 2, l = 1, zeta_i = zeta / r_n,i; 5DOF of Fig. 5: j = 3, l = 1; SDOF; mu = 1"};
    record.chosen = {
        "zeta = 0.001, 0.01, 0.1; r = 0.1 to 2.5, of which (e) to (h) show the part with errors",
        "(a), (b), (c) mass 1 of 2DOF, beta half of the boundary (69)",
        "(d) mass 1 of 2DOF, zeta = 0.01, r = 0.9, beta from a thousandth of the boundary to all of it",
        "exact is the closed form (46): its largest displacement, its instant, its values; (48) is over the amplitude, (53) in "
        "radians, so that 1 percent is 0.01",
        "(e), (f), (h) against (69) with the maximum of the sum, (g) against (57); (i) (88) as printed"};
    std::vector<ErrorCurve> curves;
    std::size_t done = 0;
    const auto add_now = [&](const ErrorCurve& c) {
        add(figure, record, c);
        figure.progress(++done, 28);
    };
    for (const double zeta : {0.001, 0.01, 0.1}) {
        const WithModes two(two_masses(zeta)), one(single_mass(zeta)), five(five_masses(3, zeta)),
            first_of_five(five_masses(1, zeta));
        const std::string name = "zeta=" + text(zeta), of = ", zeta = " + text(zeta);
        add_now(
            {"a", name, "(52), 2DOF mass 1" + of, "r", r, [&](double x) { return error_of_52(sliding(two, x, 0.5), first); }});
        add_now({"b", name, "(48), (49), 2DOF mass 1" + of, "r", r,
                 [&](double x) { return error_of_48(sliding(two, x, 0.5), first); }});
        add_now(
            {"c", name, "(53), 2DOF mass 1" + of, "r", r, [&](double x) { return error_of_53(sliding(two, x, 0.5), first); }});
        add_now({"e", name, "(67), SDOF" + of, "r", r, [&](double x) { return error_of_67(one, x); }});
        add_now({"f", name, "(67), 2DOF" + of, "r", r, [&](double x) { return error_of_67(two, x); }});
        add_now({"g", name, "(71)" + of, "R", r, [&](double x) { return error_of_71(one, x); }});
        add_now({"h", name, "(72), 2DOF" + of, "r", r, [&](double x) { return error_of_72(two, x); }});
        add_now({"i", name, "(88), 5DOF j = 3" + of, "r", r, error_of_88(five)});
    }
    const WithModes two(two_masses(0.01));
    const std::string at = ", 2DOF mass 1, zeta = 0.01, r = 0.9";
    const double r_d = 0.9;
    add_now({"d", "(48)", "(48)" + at, "beta / beta_lim", fractions,
             [&](double f) { return error_of_48(sliding(two, r_d, f), first); }});
    add_now({"d", "(52)", "(52)" + at, "beta / beta_lim", fractions,
             [&](double f) { return error_of_52(sliding(two, r_d, f), first); }});
    add_now({"d", "(53)", "(53)" + at, "beta / beta_lim", fractions,
             [&](double f) { return error_of_53(sliding(two, r_d, f), first); }});
    const WithModes last(equal_chain<double>(5, 5, 1, std::vector<double>(5, 0.1)));
    add_now({"i", "j=5", "(88), 5DOF j = 5, zeta = 0.1", "r", r, error_of_88(last)});
    record.remarks = {
        "The largest displacement has its instant in common with (48) only where the motion is harmonic; (52) and (53) are exact "
        "for the mass in contact, whose amplitude and phase are (38) and (39).",
        "(67) and (72) are exact where the sum over the modes is largest for tau -> 0."};
    return record;
}

const Listed listed("error_of_approximations", make);

} // namespace denhartog::figures::error_of_approximations
