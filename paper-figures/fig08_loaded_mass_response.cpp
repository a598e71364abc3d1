// Fig. 8: amplitude and phase of the loaded mass of two masses over the frequency ratio at three damping ratios.
#include "two_masses_response.hpp"

namespace denhartog::figures::fig08_loaded_mass_response {

const Mass mass{0};
const double last_r = 2.5;

double least_phase(double) { return -pi<double>() / 2; }

// The stuck configuration of a system.
struct StuckCurve {
    const StuckConfiguration stuck; // the configuration
    const System<double>& system;   // the system

    double X(double r) const { return stuck_response(stuck, system.load, r).masses[mass.index].amplitude; }
};

StuckCurve stuck_curve(const Damped& d) { return {stuck_configuration(d.modes.system, d.modes.basis), d.modes.system}; }

// The stuck configuration over the frequency ratio.
void add_stuck(Figure& figure, const Damped& d) {
    const StuckCurve curve = stuck_curve(d);
    const double r_n = curve.stuck.r_n[0];
    Table table{"stuck zeta=" + plain(d.zeta), {"r", "X", "phase"}, {}};
    for (const double r : frequencies(0.05, last_r, 0.01, {{r_n, d.zeta / r_n}})) {
        const StuckMass m = stuck_response(curve.stuck, d.modes.system.load, r).masses[mass.index];
        table.rows.push_back({r, m.amplitude, turned(*m.phase, least_phase(r))});
    }
    figure.add(table);
}

// Statements of the text on the stuck configuration: its peak, where friction leaves it, what damping changes.
void stuck_statements(Record& record, const std::vector<Damped>& all) {
    std::string peaks, onsets;
    double worst_spread = 0;
    bool stands_out = true;
    for (const Damped& d : all) {
        const StuckCurve curve = stuck_curve(d);
        const double r_n = curve.stuck.r_n[0];
        const auto [r, minus] =
            boost::math::tools::brent_find_minima([&](double at) { return -curve.X(at); }, 0.9 * r_n, 1.1 * r_n, 26);
        stands_out = stands_out && -minus > 2 * curve.X(0.05) && -minus > 2 * curve.X(last_r);
        peaks = joined(peaks, text(-minus) + " at r = " + text(r, "%.3f") + ", zeta = " + plain(d.zeta));
    }
    record.statements.push_back(
        {"m_1 responds while m_2 is stuck, with a resonant peak of its own", "peaks of " + peaks, stands_out});
    for (std::size_t b = 4; b < 6; ++b) {
        double least = last_r, most = 0;
        onsets = joined(onsets, "beta = " + plain(all[0].lines[b].beta) + " leaves it at r =");
        for (const Damped& d : all) {
            const std::vector<SweepPoint>& p = d.lines[b].points;
            const auto first =
                std::ranges::find_if(p, [](const SweepPoint& each) { return each.regime != Regime::permanent_sticking; });
            least = std::min(least, first->r);
            most = std::max(most, first->r);
            onsets += " " + text(first->r, "%.2f");
        }
        worst_spread = std::max(worst_spread, most - least);
    }
    record.statements.push_back({"The onset of the resonant peak of the stuck configuration is not heavily affected by damping",
                                 onsets + " for the three damping ratios", worst_spread <= 0.1, "by less than 0.1 in r"});
    const StuckCurve least = stuck_curve(all.front()), most = stuck_curve(all.back());
    const auto change = [&](double r) { return std::abs(most.X(r) / least.X(r) - 1); };
    const double r_n = least.stuck.r_n[0];
    record.statements.push_back({"Damping changes the stuck configuration at its resonance alone, neither its start nor its end",
                                 "from the least damping ratio to the largest X changes by " + text(100 * change(0.05), "%.1g") +
                                     " % at r = 0.05, " + text(100 * change(1), "%.2g") + " % at r = 1, " +
                                     text(100 * change(r_n), "%.3g") + " % at r = " + text(r_n, "%.3f") + ", " +
                                     text(100 * change(2), "%.2g") + " % at r = 2, " + text(100 * change(100), "%.1g") +
                                     " % at r = 100",
                                 change(0.05) < 0.01 && change(100) < 0.01 && change(1) < 0.05 && change(2) < 0.05,
                                 "by less than 1 percent at the ends and 5 percent between"});
}

// Largest difference from the stuck configuration where the algorithm starts on it.
double worst_at_rest(const std::vector<Damped>& all) {
    double worst = 0;
    for (const Damped& d : all)
        worst = std::max(worst, agreement("", amplitudes_off(d.on_the_line, Regime::permanent_sticking)).worst);
    return worst;
}

// Where the curves invert: the points of (87), and crossings of the curves near them at every damping ratio.
void inversions(Figure& figure, Record& record, const std::vector<Damped>& all) {
    std::vector<InvariantPoint<double>> points = sliding_invariant_points(all[0].modes, mass, two_masses_betas()[0], last_r);
    std::string others;
    for (const auto& p : points)
        if (p.kind == InvariantPointKind::friction_leaves_it_alone) others = joined(others, text(p.r), ", ");
    std::erase_if(points, [](const auto& p) { return p.kind != InvariantPointKind::two_effects_cancel; });
    if (!others.empty())
        record.remarks.push_back("Not marked: without damping m_1 is invariant at r = " + others +
                                 " too, with U_1 = 0, a factor that (87) divides out");
    Table table{"invariant points", {"r", "X"}, {}};
    for (const auto& p : points) table.rows.push_back({p.r, p.amplitude});
    figure.add(table);
    std::vector<double> betas = two_masses_betas();
    betas.insert(betas.begin(), 0);
    std::string spreads;
    bool only_without_damping = true;
    const auto look = [&](const WithModes& system, double zeta) {
        std::string found;
        int pairs = 0, crossed = 0;
        double farthest = 0;
        for (const auto& p : points) {
            const Crossings c = crossings(system, mass, betas, p.r, 0.1);
            pairs += c.pairs;
            crossed += c.found;
            farthest = std::max(farthest, c.farthest);
            if (c.pairs > 0)
                found = joined(found, "r = " + text(p.r) + ": " + std::to_string(c.found) + " of " + std::to_string(c.pairs) +
                                          (c.found > 0 ? ", at most " + text(c.farthest, "%.2g") + " off" : ""));
        }
        spreads = joined(spreads, (farthest < 1e-9 ? "below 1e-9" : text(farthest, "%.2g")) + " at zeta = " + plain(zeta));
        only_without_damping = only_without_damping && (zeta == 0) == (farthest < 1e-9);
        if (zeta > 0)
            record.statements.push_back(
                {"Curves of different friction ratios invert close to the invariant points of (87); here zeta = " + plain(zeta),
                 "pairs of neighbouring curves that cross, " + found, crossed == pairs, "within 0.1 of r"});
    };
    look(WithModes(two_masses(0.0)), 0);
    for (const Damped& d : all) look(d.modes, d.zeta);
    record.statements.push_back({"Here (52) has invariant points without damping alone (in general it has them with damping too: "
                                 "claim 87/only-without-damping)",
                                 "largest distance of a crossing from its point of (87): " + spreads, only_without_damping});
}

Record make(Figure& figure) {
    const std::vector<Damped> all = two_damped_masses(figure, mass, least_phase);
    for (const Damped& d : all) add_stuck(figure, d);
    Record record = two_masses_record("Amplitude and phase of mass 1, where the load acts, over the frequency ratio");
    record.equations = {"52", "53", "69", "87", "88"};
    record.given.push_back("the stuck configuration dotted");
    record.chosen.push_back(
        "lines while the contact slides are (52) and (53), the paper's closed form for a mass not in contact");
    record.chosen.push_back("invariant points where beta = 0.1 slides");
    two_masses_statements(record, all, mass);
    record.remarks.push_back(
        "While the contact rests, it rests where it came to rest, not at zero, and at zeta = 0.001 the free motion of m_1 "
        "has not died out after 200 periods: the markers lie off the stuck configuration by a median of " +
        text(100 * agreement("", amplitudes_off(all[0].markers, Regime::permanent_sticking)).median, "%.2g") +
        " % there, by at most " + text(worst_at_rest(all), "%.1g") + " when started on it");
    stuck_statements(record, all);
    inversions(figure, record, all);
    record.remarks.push_back(
        "The caption names m_2; by the text Fig. 8 shows m_1 and Fig. 9 m_2, and m_1 alone moves in the stuck configuration");
    return record;
}

const Listed listed("fig08_loaded_mass_response", make);

} // namespace denhartog::figures::fig08_loaded_mass_response
