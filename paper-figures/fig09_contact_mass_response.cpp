// Fig. 9: amplitude and phase of the mass in contact of two masses over the frequency ratio at three damping ratios.
#include "two_masses_response.hpp"

namespace denhartog::figures::fig09_contact_mass_response {

const Mass mass{1};

double least_phase(double r) { return r < 1.2 ? -pi<double>() / 2 : pi<double>() / 2; }

// Statement of the text on Fig. 10: with j not l stick-slip is expected at high frequency ratios.
Statement high_frequency_regime(const std::vector<Damped>& all) {
    const double r = 10;
    std::size_t stick_slip = 0, rest = 0, points = 0;
    for (const Damped& d : all)
        for (const Sweep& s : sweeps(d.modes.system, mass, {r}, two_masses_betas())) {
            ++points;
            if (s.points[0].regime == Regime::stick_slip) ++stick_slip;
            if (s.points[0].regime == Regime::permanent_sticking) ++rest;
        }
    const Boundary<double> limits = boundary(all[0].modes.at(r), 1.0);
    return {"With load and contact on different masses stick-slip is always expected at high frequency ratios",
            "r = 10: " + std::to_string(stick_slip) + " of " + std::to_string(points) + " motions stick and slip, " +
                std::to_string(rest) + " rest; zeta = 0.001: stick-slip from beta = " + text(limits.exact, "%.2g") +
                ", rest from beta = " + text(*limits.sticking, "%.2g") + " on",
            stick_slip == points};
}

// The invariant points of the mass in contact: the curves touch there without damping, and do not cross.
void touching(Figure& figure, Record& record, const std::vector<Damped>& all) {
    const std::vector<InvariantPoint<double>> points = sliding_invariant_points(all[0].modes, mass, two_masses_betas()[0], 2.5);
    Table table{"invariant points", {"r", "X"}, {}};
    for (const auto& p : points) table.rows.push_back({p.r, p.amplitude});
    figure.add(table);
    const InvariantPoint<double>& last = points.back();
    const auto drop = [&](const WithModes& s) {
        return 1 - s.sliding_amplitude(mass, last.r, 0.8) / s.sliding_amplitude(mass, last.r, 0);
    };
    std::vector<double> betas = two_masses_betas();
    betas.insert(betas.begin(), 0);
    int crossed = 0, pairs = 0;
    std::string drops;
    const double undamped = std::abs(drop(WithModes(two_masses(0.0))));
    drops = (undamped < 1e-9 ? "below 1e-9" : text(undamped, "%.2g")) + std::string(" at zeta = 0");
    for (const Damped& d : all) {
        drops = joined(drops, text(100 * drop(d.modes), "%.2g") + " % at zeta = " + plain(d.zeta), ", ");
        for (const auto& p : points) {
            const Crossings c = crossings(d.modes, mass, betas, p.r, 0.1);
            crossed += c.found;
            pairs += c.pairs;
        }
    }
    record.remarks.push_back("(87) has no solution for the mass in contact. It is invariant where U_j = 0, without damping: "
                             "there the curves touch and do "
                             "not cross, " +
                             std::to_string(crossed) + " of " + std::to_string(pairs) + " pairs cross with damping. At r = " +
                             text(last.r) + " beta = 0.8 lowers the amplitude by " + drops);
}

Record make(Figure& figure) {
    const std::vector<Damped> all = two_damped_masses(figure, mass, least_phase);
    Record record = two_masses_record("Amplitude and phase of mass 2, the mass in contact, over the frequency ratio");
    record.equations = {"38", "39", "69"};
    record.chosen.push_back("no markers where the contact rests for good: m_2 then stays where it came to rest");
    two_masses_statements(record, all, mass);
    record.statements.push_back(high_frequency_regime(all));
    touching(figure, record, all);
    return record;
}

const Listed listed("fig09_contact_mass_response", make);

} // namespace denhartog::figures::fig09_contact_mass_response
