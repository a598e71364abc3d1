// Three chains of three unequal masses: the load before the contact, after it and on it.
#include "peak.hpp"
#include "plane_at_mu.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::unequal_systems {

const double zeta = 0.05;
const std::vector<double> betas{0.1, 0.3, 0.6};

/// A chain of three masses.
System<double> chain_of(const std::vector<double>& masses, const std::vector<double>& springs, std::size_t j, std::size_t l,
                        double damping) {
    System<double> s = equal_chain<double>(3, j, l, {damping, damping, damping});
    s.mass_ratios = masses;
    s.stiffness_ratios = springs;
    return s;
}

/// A chain with its responses.
struct Chain {
    /// Where the load is, as seen from the wall; masses, springs, contact, load, the mass shown besides the contact.
    Chain(const std::string& load, const std::vector<double>& masses, const std::vector<double>& springs, std::size_t j,
          std::size_t l, std::size_t k)
        : name(load), modes(chain_of(masses, springs, j, l, zeta)), light(chain_of(masses, springs, j, l, 0.001)),
          other(Mass{k - 1}) {}

    std::string name;                ///< as tables and record have it
    WithModes modes;                 ///< the system
    WithModes light;                 ///< the same with next to no damping
    Mass other;                      ///< the mass shown besides the one in contact
    std::vector<Comparison> contact; ///< markers of the contact against its lines
    std::vector<Comparison> beside;  ///< markers of the other mass
    std::vector<Comparison> steady;  ///< the same where the contact slides or rests, started on the steady motion
    std::optional<PlaneAtMu> plane;  ///< boundaries at mu = 1
};

/// Lines and markers of a mass.
std::vector<Sweep> add_mass(Figure& figure, const Chain& c, Mass k, const std::string& of, std::vector<Comparison>& markers) {
    const LeastPhase no_phase = [](double) { return 0.0; };
    std::vector<std::pair<double, double>> resonances;
    for (const double r_n : c.modes.basis.r_n) resonances.emplace_back(r_n, zeta);
    std::vector<double> with_none{0};
    with_none.insert(with_none.end(), betas.begin(), betas.end());
    for (const Sweep& line : sweeps(c.modes.system, k, frequencies(0.02, 3, 0.015, resonances), with_none))
        add(figure, c.name + " " + of + " beta=" + plain(line.beta), line, no_phase);
    const std::vector<Sweep> points = sweeps(c.modes.system, k, spaced(0.2, 2.8, 14), betas);
    markers = compared(figure, c.modes.system, k, points);
    add(figure, "markers " + c.name + " " + of, markers, betas, no_phase);
    return points;
}

void compute(Figure& figure, Chain& c) {
    add_mass(figure, c, c.modes.system.contact, "contact", c.contact);
    const std::vector<Sweep> points = add_mass(figure, c, c.other, "other", c.beside);
    c.steady = compared(figure, c.modes.system, c.other, points, true);
    c.plane = plane_at_mu(figure, {c.name, c.modes.system}, 1);
}

void add_agreements(Record& record, const Chain& c) {
    const auto compare = [&](const std::string& what, const std::vector<std::pair<double, std::string>>& off) {
        if (!off.empty()) record.agreements.push_back(agreement("load " + c.name + " the contact: " + what, off));
    };
    const std::string k = std::to_string(c.other.index + 1);
    compare("amplitude of the contact while it slides, relative", amplitudes_off(c.contact, Regime::continuous));
    compare("amplitude of the contact in stick-slip, relative to the exact solver",
            amplitudes_off(c.contact, Regime::stick_slip));
    compare("displacement of the contact at rest, units of P / k_1", amplitudes_off(c.contact, Regime::permanent_sticking));
    compare("amplitude of mass " + k + " while the contact slides, relative", amplitudes_off(c.beside, Regime::continuous));
    compare("amplitude of mass " + k + " while the contact slides, started on the steady motion, relative",
            amplitudes_off(c.steady, Regime::continuous));
    compare("amplitude of mass " + k + " in stick-slip, relative to the exact solver",
            amplitudes_off(c.beside, Regime::stick_slip));
    if (c.name != "on")
        compare("amplitude of mass " + k + " while the contact rests, started on the stuck motion, relative",
                amplitudes_off(c.steady, Regime::permanent_sticking));
    for (Agreement a : agreements({*c.plane})) {
        a.what.replace(0, c.name.size(), "load " + c.name + " the contact");
        record.agreements.push_back(a);
    }
}

/// A function for each chain as text.
std::string for_each(const std::vector<Chain>& chains, const std::function<std::string(const Chain&)>& f) {
    std::string line;
    for (const Chain& c : chains) line += (line.empty() ? "" : "; ") + ("load " + c.name + " the contact ") + f(c);
    return line;
}

std::string list(const std::vector<double>& numbers) {
    std::string line;
    for (const double x : numbers) line += (line.empty() ? "" : ", ") + text(x, "%.3g");
    return line;
}

Statement regimes_as_predicted(const std::vector<Chain>& chains) {
    std::size_t points = 0, same = 0, creep = 0, settled = 0;
    for (const Chain& c : chains)
        for (const RegimeCheck& check : c.plane->checks) {
            ++points;
            same += check.seen == check.predicted;
            creep += check.seen != check.predicted && check.creeps;
            settled += check.seen != check.predicted && check.exact == check.predicted;
        }
    return {"Continuous, stick-slip and permanent sticking responses occur as the boundaries predict",
            "the last of 200 periods has the predicted regime at " + std::to_string(same) + " of " + std::to_string(points) +
                " points; of the others " + std::to_string(creep) + " still creep to their rest, and at " +
                std::to_string(settled) + " the exact solver finds the predicted regime",
            same == points};
}

Statement amplitudes_agree(const std::vector<Chain>& chains) {
    std::size_t points = 0, close = 0;
    std::string others;
    for (const Chain& c : chains)
        for (const auto* markers : {&c.contact, &c.beside})
            for (const Comparison& m : *markers) {
                if (m.regime != Regime::continuous) continue;
                ++points;
                const bool within = std::abs(m.amplitude_off) < 0.01;
                close += within;
                if (!within)
                    others += std::string(others.empty() ? "; farther off: " : "; ") + "load " + c.name + " the contact, mass " +
                              std::to_string((markers == &c.contact ? c.modes.system.contact : c.other).index + 1) + ", " +
                              where(m) + ", " + text(100 * m.amplitude_off, "%.2g") + " percent";
            }
    return {"Closed-form and numerical amplitudes agree very well while the contact slides; here: to 1 percent after 200 periods",
            std::to_string(close) + " of " + std::to_string(points) + " points" + others, close == points};
}

Statement high_frequency(const std::vector<Chain>& chains) {
    double worst = 0;
    for (const Chain& c : chains) {
        const double limit = c.plane->loaded_contact() ? paper::friction_ratio_limit_at_high_frequency(1.0) : 0.0;
        worst = std::max(worst, std::abs(c.plane->at(100).paper - limit));
    }
    return {
        "For high frequencies (69) tends to (86) with the load on the contact, else to zero, whatever masses and springs; here: "
        "to 0.001 at r = 100",
        "(86) is " + text(paper::friction_ratio_limit_at_high_frequency(1.0)) + "; (69) at r = 3 and 100: " +
            for_each(chains,
                     [](const Chain& c) {
                         return list({c.plane->at(3).paper, c.plane->at(100).paper});
                     }),
        worst < 1e-3};
}

Statement low_frequency(const std::vector<Chain>& chains) {
    double worst = 0;
    const auto quotient = [](const Chain& c, double r) { return c.plane->at(r).paper / at_low_frequency(*c.plane, r); };
    for (const Chain& c : chains) worst = std::max(worst, std::abs(quotient(c, 0.005) - 1));
    return {
        "For r -> 0 (69) falls to zero; here: as its law with mass ratio and static displacement of the contact, to a hundredth "
        "at r = 0.005",
        "(69) over that law at r = 0.05 and 0.005: " + for_each(chains,
                                                                [&](const Chain& c) {
                                                                    return list({quotient(c, 0.05), quotient(c, 0.005)});
                                                                }),
        worst < 0.01};
}

/// (88) as printed against all forces on the contact.
Statement sticking_as_printed(Figure& figure, const std::vector<Chain>& chains) {
    double worst = 0;
    std::string found;
    for (const Chain& c : chains) {
        const System<double>& s = c.modes.system;
        const StuckConfiguration stuck = stuck_configuration(s, c.modes.basis);
        const std::optional<StuckChain> moving = stuck_chain(s, stuck);
        Table table{"printed " + c.name, {"r", "(88)"}, {}};
        double most = 0, at = 0;
        for (const double r : spaced(0.02, 3, 299)) {
            const StickingBoundary limits = sticking_boundary(stuck_response(stuck, s.load, r), moving, 1.0);
            table.rows.push_back({r, limits.paper.value()});
            const double difference = std::abs(limits.paper.value() / limits.exact - 1);
            if (difference <= most) continue;
            most = difference;
            at = r;
        }
        figure.add(table);
        worst = std::max(worst, most);
        found += (found.empty() ? "load " : "; load ") + c.name + " the contact " +
                 (most < 1e-9 ? std::string("less than 1e-9") : text(100 * most, "%.2g") + " percent at r = " + text(at, "%.3g"));
    }
    return {"(88) gives the friction ratio from which the contact rests for ever; here: to 1 percent, zeta = 0.05, r = 0.02 to 3",
            "off by at the most: " + found + "; it leaves out the damping forces of the moving masses on the contact",
            worst < 0.01};
}

Statement limit_at_resonances(const std::vector<Chain>& chains) {
    double worst = 0;
    const auto quotients = [](const WithModes& s) {
        std::vector<double> all;
        for (std::size_t i = 0; i < 3; ++i) all.push_back(s.estimated_limit(i) / boundary(s.at(s.basis.r_n[i]), 1.0).paper);
        return all;
    };
    for (const Chain& c : chains)
        for (const double q : quotients(c.light)) worst = std::max(worst, std::abs(q - 1));
    return {"At resonances (85) approximates (69); here: to a tenth at every resonance at zeta = 0.001",
            "(85) over (69) at zeta = 0.001: " + for_each(chains, [&](const Chain& c) { return list(quotients(c.light)); }) +
                "; at zeta = 0.05: " + for_each(chains, [&](const Chain& c) { return list(quotients(c.modes)); }),
            worst < 0.1};
}

/// (83) for the contact, where there is a peak in the sliding regime.
Statement peaks(const std::vector<Chain>& chains, double beta) {
    double worst = 0;
    const auto quotients = [&](const Chain& c) {
        std::string line;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::optional<Peak> peak = sliding_peak(c.light, c.modes.system.contact, i, beta);
            const double q = peak ? c.light.estimated_peak(c.modes.system.contact, i, beta) / peak->X : 1;
            worst = std::max(worst, std::abs(q - 1));
            line += (i == 0 ? "" : ", ") + (peak ? text(q, "%.3g") : std::string("no such peak"));
        }
        return line;
    };
    const std::string found = for_each(chains, quotients);
    return {"(83) estimates the peaks in the sliding regime very well; here: contact, zeta = 0.001, beta = " + plain(beta) +
                ", to a hundredth",
            "(83) over the peak of (52): " + found, worst < 0.01};
}

/// Frequencies, and where little friction ends the sliding motion between them.
std::string frequencies_and_gaps(const std::vector<Chain>& chains) {
    const auto gaps = [](const Chain& c) {
        const std::vector<double> r = spaced(c.modes.basis.r_n.front(), 3, 500);
        std::string line;
        for (std::size_t n = 1; n + 1 < r.size(); ++n) {
            const double limit = c.plane->at(r[n]).paper;
            if (limit < c.plane->at(r[n - 1]).paper && limit < c.plane->at(r[n + 1]).paper)
                line += (line.empty() ? "" : ", ") + text(limit, "%.2g") + " at r = " + text(r[n], "%.2g");
        }
        return line.empty() ? std::string("none") : line;
    };
    return "Natural frequency ratios: " + for_each(chains, [](const Chain& c) { return list(c.modes.basis.r_n); }) +
           "; with the contact held: " + for_each(chains, [](const Chain& c) { return list(c.plane->stuck.r_n); }) +
           ". Minima of (69) beyond the first: " + for_each(chains, gaps) + ".";
}

/// The contact comes to rest off zero from rest at the start, and takes the other masses along.
std::string rest_off_zero(const std::vector<Chain>& chains) {
    const auto farthest = [](const Chain& c) {
        double most = 0;
        for (const Comparison& m : c.contact)
            if (m.regime == Regime::permanent_sticking) most = std::max(most, m.X);
        return text(most, "%.2g");
    };
    return "From rest the contact can come to its rest off zero, at the markers by at the most: " + for_each(chains, farthest) +
           ". The other masses then swing about another place, and their markers are off the lines by as much as that moves "
           "them.";
}

Record make(Figure& figure) {
    std::vector<Chain> chains{Chain("before", {1, 0.4, 1}, {1, 1, 1}, 2, 1, 1), Chain("after", {1, 4, 1}, {1, 2, 2}, 2, 3, 3),
                              Chain("on", {1, 1, 1}, {1, 0.25, 0.25}, 1, 1, 3)};
    Record record;
    record.title = "Responses and regimes of chains with unequal masses and springs";
    record.equations = {"52", "69", "83", "85", "86", "88"};
    record.chosen = {
        "3DOF, mu = 1, zeta = 0.05 in every mode",
        "(a) light contact mass, load before it: gamma = 1, 0.4, 1; kappa = 1, 1, 1; j = 2, l = 1",
        "(b) heavy contact mass, soft first spring, load after it: gamma = 1, 4, 1; kappa = 1, 2, 2; j = 2, l = 3",
        "(c) stiff first spring, load on the contact: gamma = 1, 1, 1; kappa = 1, 0.25, 0.25; j = l = 1",
        "r = 0.02 to 3, beta = 0, 0.1, 0.3, 0.6; markers at r = 0.2 to 2.8 in steps of 0.2, 200 periods from rest",
        "panels (g), (h), (i): end of sliding from rest, end of slipping within a period started on the stuck motion",
        "amplitudes in stick-slip by the exact solver"};
    for (Chain& c : chains) {
        compute(figure, c);
        add_agreements(record, c);
    }
    record.statements = {
        regimes_as_predicted(chains),        amplitudes_agree(chains),    high_frequency(chains), low_frequency(chains),
        sticking_as_printed(figure, chains), limit_at_resonances(chains), peaks(chains, 0.1)};
    record.remarks = {frequencies_and_gaps(chains), rest_off_zero(chains)};
    return record;
}

const Listed listed("unequal_systems", make);

} // namespace denhartog::figures::unequal_systems
