// Fig. 11: resonant peak of a single mass over friction and damping ratio, (84) up to (85), and the actual peak of (52).
#include "denhartog/number/parallel.hpp"
#include "markers.hpp"
#include "peak.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::fig11_resonant_peak {

/// Friction ratio at which (84) has a height: it falls linearly from its value without friction to zero at (85).
double estimated_friction(double zeta, double height) {
    const double limit = evaluation::friction_ratio_limit_at_resonance(1.0, 1.0, zeta);
    return limit * (1 - height / evaluation::resonant_peak_of_single_mass(zeta, 0.0));
}

/// Friction ratio at which the actual peak of (52) has a height; not a number where it has left the sliding regime by then.
double actual_friction(const WithModes& s, double height) {
    const auto too_high = [&](double beta) {
        const std::optional<Peak> peak = sliding_peak(s, Mass{0}, 0, beta);
        return peak && peak->X > height;
    };
    if (!too_high(0)) return std::nan("");
    double low = 0, high = 1;
    for (int n = 0; n < 12; ++n) (too_high((low + high) / 2) ? low : high) = (low + high) / 2;
    const std::optional<Peak> peak = sliding_peak(s, Mass{0}, 0, low);
    return peak->X < 1.05 * height ? (low + high) / 2 : std::nan("");
}

/// (69) at r = 1.
double limit_at_resonance(double zeta) { return boundary(WithModes(single_mass(zeta)).at(1), 1.0).exact; }

Record make(Figure& figure) {
    const double pi_4 = pi<double>() / 4;
    const auto estimated_limit = [](double zeta) { return evaluation::friction_ratio_limit_at_resonance(1.0, 1.0, zeta); };
    const std::vector<double> zetas = spaced_in_octaves(0.001, 0.5, 109);
    const std::vector<double> levels{1, 2, 5, 10, 20, 50, 100, 200};

    Table limits{"boundaries", {"zeta", "(85)", "(69) at r = 1"}, {}};
    for (const double zeta : zetas) limits.rows.push_back({zeta, estimated_limit(zeta), limit_at_resonance(zeta)});
    figure.add(limits);
    for (const double X : levels) {
        // the line begins on the axis, where 1 / (2 zeta) is the height without friction
        Table line{"estimated X=" + text(X), {"zeta", "beta by (84)"}, {}};
        for (const double zeta : spaced_in_octaves(0.001, std::min(0.5, 1 / (2 * X)), 80))
            line.rows.push_back({zeta, estimated_friction(zeta, X)});
        figure.add(line);
    }
    std::vector<Table> actual;
    for (const double X : levels) {
        Table line{"actual X=" + text(X), {"zeta", "beta by (52)"}, {}};
        for (const double zeta : spaced_in_octaves(0.001, std::min(0.5, 1 / (2 * X)), 16)) line.rows.push_back({zeta, 0});
        actual.push_back(line);
    }
    std::atomic<std::size_t> done{0};
    parallel_for(16 * levels.size(), threads(), [&](std::size_t n) {
        std::vector<double>& row = actual[n / 16].rows[n % 16];
        row[1] = actual_friction(WithModes(single_mass(row[0])), levels[n / 16]);
        figure.progress(++done, 16 * levels.size());
        return true;
    });
    for (const Table& line : actual) figure.add(line);

    std::string printed, bounds, apart, at_half;
    double fall_light = 0, fall_heavy = 0, light_apart = 0, half_worst = 0;
    for (const double zeta : {0.001, 0.01, 0.1}) {
        const std::string comma = printed.empty() ? "" : ", ";
        const double limit = limit_at_resonance(zeta);
        printed += comma + text(estimated_limit(zeta));
        bounds += comma + text(limit);
        apart += comma + text(100 * (pi_4 / limit - 1), "%.3g");
        if (zeta <= 0.01) {
            fall_light = std::max(fall_light, 1 - estimated_limit(zeta) / pi_4);
            light_apart = std::max(light_apart, std::abs(pi_4 / limit - 1));
        } else {
            fall_heavy = 1 - estimated_limit(zeta) / pi_4;
        }
        const WithModes s(single_mass(zeta));
        const double beta = limit / 2, off = s.estimated_peak(Mass{0}, 0, beta) / sliding_peak(s, Mass{0}, 0, beta)->X - 1;
        at_half += comma + text(100 * off, "%.3g");
        half_worst = std::max(half_worst, std::abs(off));
    }
    Record record;
    record.title = "Resonant peak of a single mass over friction and damping ratio";
    record.equations = {"84", "85", "52", "69"};
    record.given = {"SDOF in the sliding regime, boundary of the domain of (84) drawn"};
    record.chosen = {"zeta = 0.001 to 0.5: the text has 0 to 0.1 as usual, beyond it (85) is seen to fall", "mu = 1",
                     "lines of equal height, X = 1 to 200, zeta on a logarithmic axis",
                     "actual peak: the largest amplitude (52) over r next to 1 with the contact sliding, drawn where it exists",
                     "boundary (69) at r = 1 besides (85)"};
    record.statements = {
        {"The peak depends on zeta and beta as (84) has it; here: to 1 percent at half the boundary (69)",
         "at zeta = 0.001, 0.01, 0.1 (84) is off by " + at_half + " percent", half_worst < 0.01, "to 1 percent"},
        {"(85) stays about constant for zeta up to 0.01; here: within 0.1 percent of pi / 4",
         "at zeta = 0.001, 0.01, 0.1 it is " + printed + "; at 0.01 it is " + text(100 * fall_light, "%.2g") +
             " percent below pi / 4",
         fall_light < 0.001, "to 0.1 percent"},
        {"(85) decreases significantly for larger zeta; here: by 1 percent at least up to 0.1, the end of the usual range",
         "by " + text(100 * fall_heavy, "%.2g") + " percent at zeta = 0.1, by " +
             text(100 * (1 - estimated_limit(0.5) / pi_4), "%.3g") + " percent at 0.5",
         fall_heavy >= 0.01, "by 1 percent up to zeta = 0.1"},
        {"In lightly damped systems pi / 4 estimates well the least friction ratio with stick-slip at resonance; here: within 5 "
         "percent of (69) at r = 1 for zeta up to 0.01",
         "(69) at r = 1 is " + bounds + " at zeta = 0.001, 0.01, 0.1; pi / 4 is off by " + apart + " percent", light_apart < 0.05,
         "to 5 percent"}};
    const double edge = (estimated_limit(0.1) + limit_at_resonance(0.1)) / 2;
    record.remarks = {
        "Between (69) at r = 1 and (85) the contact sticks, though (84) still gives a height: at zeta = 0.1 it is " +
        text(evaluation::resonant_peak_of_single_mass(0.1, edge)) + " at beta = " + text(edge) +
        ". The boundary falls with damping much faster than (85)."};
    return record;
}

const Listed listed("fig11_resonant_peak", make);

} // namespace denhartog::figures::fig11_resonant_peak
