// Regimes of motion where static friction exceeds kinetic friction: (69), (86) and (88) for several mu.
#include "plane_at_mu.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::figures::regimes_with_mu {

const std::vector<double> mus{1, 1.5, 2, 3};

/// Larger static friction leaves less room to the sliding motion.
Statement less_room(const std::vector<PlaneAtMu>& planes) {
    const std::vector<double> all = spaced(0.02, 3, 300);
    std::vector<double> before(all.size(), 1e300);
    bool falls = true;
    const auto area = [&](const PlaneAtMu& p) {
        double sum = 0;
        for (std::size_t n = 0; n < all.size(); ++n) {
            const double limit = p.at(all[n]).paper;
            falls = falls && limit < before[n];
            before[n] = limit;
            sum += limit;
        }
        return sum / static_cast<double>(all.size());
    };
    return {planes.front().of +
                ": larger static friction reduces the region of continuous motion; here: at every r from 0.02 to 3",
            "mean of (69) over r " + for_each_mu(planes, area) + " for mu = 1, 1.5, 2, 3", falls};
}

/// The paper's algorithm at one point of the sliding regime of all mu.
Statement no_effect_while_sliding(const std::vector<PlaneAtMu>& planes, double r, double beta) {
    double least = 1e300, largest = 0;
    std::string amplitudes;
    for (const PlaneAtMu& p : planes) {
        PaperSettings settings;
        settings.start = on_closed_form(p.sums(r), p.mu, beta);
        const PaperMotion motion = motion_at(p, r, beta, settings);
        if (!motion.slides) throw std::runtime_error(where(p, r) + ": no sliding motion");
        const double X = motion.masses[p.system.contact.index].amplitude;
        least = std::min(least, X);
        largest = std::max(largest, X);
        amplitudes += (amplitudes.empty() ? "" : ", ") + text(X);
    }
    return {planes.front().of +
                ": static friction has no effect on the response while the contact slides; here: amplitude of the "
                "contact by the paper's algorithm to 1e-5, r = " +
                text(r) + ", beta = " + text(beta),
            amplitudes + " for mu = 1, 1.5, 2, 3", largest - least < 1e-5 * largest};
}

/// The text on (67), for each damping ratio and mu.
Statement approximation(const std::string& of, const std::function<System<double>(double zeta)>& family) {
    bool as_said = true;
    std::string found;
    for (const double zeta : {0.001, 0.01, 0.1}) {
        const System<double> system = family(zeta);
        const ModalBasis<double> basis = modal_basis(system);
        std::string each;
        double last = 0;
        for (const double mu : mus) {
            double most = 0;
            for (const double r : spaced(0.02, 3, 299)) {
                const Boundary<double> b = boundary(mode_sums(basis, system.contact, system.load, r), mu);
                const double excess = b.approximate / b.paper - 1;
                most = std::max(most, excess);
                if (excess > 0.01) last = std::max(last, r);
            }
            each += (each.empty() ? "" : ", ") + (most < 1e-9 ? std::string("below 1e-9") : text(100 * most, "%.2g"));
        }
        as_said = as_said && (zeta > 0.01 ? last == 0 : last < 0.5);
        found += (found.empty() ? "zeta = " : "; zeta = ") + text(zeta) + ": " + each + " percent, " +
                 (last == 0 ? "nowhere above 1 percent" : "above 1 percent up to r = " + text(last, "%.3g"));
    }
    return {of + ": (67) differs from (69) at low frequencies and next to no damping only; here: by more than 1 percent only for "
                 "r < 0.5 and zeta up to 0.01",
            "largest difference at mu = 1, 1.5, 2, 3 for " + found, as_said};
}

Statement high_frequency(const std::vector<PlaneAtMu>& planes) {
    double worst = 0;
    for (const PlaneAtMu& p : planes) {
        const double limit = p.loaded_contact() ? paper::friction_ratio_limit_at_high_frequency(p.mu) : 0.0;
        worst = std::max(worst, std::abs(p.at(100).paper - limit));
    }
    const auto at = [&](double r) { return for_each_mu(planes, [&](const PlaneAtMu& p) { return p.at(r).paper; }); };
    const std::string here = "(69) at r = 3 " + at(3) + ", at r = 100 " + at(100);
    if (!planes.front().loaded_contact())
        return {planes.front().of + ": (69) tends to zero for high frequencies; here: below 1e-3 at r = 100", here, worst < 1e-3};
    return {planes.front().of + ": (69) tends to (86) for high frequencies; here: to 0.001 at r = 100",
            "(86) is " +
                for_each_mu(planes, [](const PlaneAtMu& p) { return paper::friction_ratio_limit_at_high_frequency(p.mu); }) +
                " for mu = 1, 1.5, 2, 3; " + here,
            worst < 1e-3};
}

Statement low_frequency(const std::vector<PlaneAtMu>& planes) {
    double largest = 0;
    for (const PlaneAtMu& p : planes) largest = std::max(largest, p.at(0.01).paper);
    return {planes.front().of + ": (69) tends to zero for r -> 0; here: below 1e-4 at r = 0.01",
            "at r = 0.01 " + for_each_mu(planes, [](const PlaneAtMu& p) { return p.at(0.01).paper; }) +
                ", which is its law for r -> 0 times " +
                for_each_mu(planes, [](const PlaneAtMu& p) { return p.at(0.01).paper / at_low_frequency(p, 0.01); }),
            largest < 1e-4};
}

/// Where (69) is above (88): the contact can slide and can rest.
Statement apart(const std::vector<PlaneAtMu>& planes) {
    bool none = true;
    std::string found;
    for (const PlaneAtMu& p : planes) {
        double first = 0, last = 0;
        for (const double r : spaced(0.02, 3, 299))
            if (p.at(r).exact > p.sticking(r)) {
                if (first == 0) first = r;
                last = r;
            }
        none = none && first == 0;
        found += std::string(found.empty() ? "" : "; ") + "mu = " + text(p.mu) + " " +
                 (first == 0 ? "nowhere" : "between r = " + text(first, "%.3g") + " and " + text(last, "%.3g"));
    }
    return {planes.front().of + ": as in Figs. 7 and 10 permanent sticking begins above the end of continuous motion",
            "below it: " + found, none};
}

/// The grid of regimes, from rest: what happens depends on the start where mu > 1.
Statement regimes_as_predicted(const std::vector<PlaneAtMu>& planes) {
    std::size_t points = 0, same = 0;
    std::string found;
    for (const PlaneAtMu& p : planes) {
        std::size_t rests = 0, moves = 0, long_stops = 0, other = 0;
        for (const RegimeCheck& c : p.checks) {
            ++points;
            if (c.seen == c.predicted)
                ++same;
            else if (c.predicted == Regime::continuous && c.seen == Regime::permanent_sticking)
                ++rests;
            else if (c.predicted == Regime::permanent_sticking && c.exact == Regime::stick_slip)
                ++moves;
            else if (c.seen == Regime::permanent_sticking && c.exact == c.predicted)
                ++long_stops;
            else
                ++other;
        }
        const std::pair<std::size_t, std::string> differences[] = {{rests, " rest below (69)"},
                                                                   {moves, " stick and slip above (88)"},
                                                                   {long_stops, " rest for the last period, not for ever"},
                                                                   {other, " differ otherwise"}};
        for (const auto& [number, what] : differences)
            if (number > 0) found += "; mu = " + text(p.mu) + ": " + std::to_string(number) + what;
    }
    return {planes.front().of +
                ": continuous, stick-slip and permanent sticking responses occur as the boundaries predict, from rest",
            std::to_string(same) + " of " + std::to_string(points) + " points" + found, same == points};
}

/// Range in which the motion that begins as stick-slip lasts although sliding is possible.
std::string early_end_of_sliding(const std::vector<PlaneAtMu>& planes) {
    std::string line;
    for (const PlaneAtMu& p : planes)
        for (const SeenFromStarts& s : p.seen) {
            const Boundary<double> limits = p.at(s.r);
            const double lower = p.loaded_contact() ? std::min(limits.exact, *limits.sticking) : limits.exact;
            if (s.from_rest < 0.999 * lower)
                line += (line.empty() ? "" : "; ") + where(p, s.r) + ": " + text(s.from_rest, "%.3g") + ", (69) " +
                        text(limits.exact, "%.3g");
        }
    return planes.front().of + ": friction ratios below (69) from which the start from rest leads to stick-slip: " +
           (line.empty() ? "none." : line + ".");
}

Record make(Figure& figure) {
    const std::function<System<double>(double)> families[] = {[](double zeta) { return single_mass(zeta); },
                                                              [](double zeta) { return two_masses(zeta); }};
    const std::string names[] = {"SDOF", "2DOF"};
    Record record;
    record.title = "Regimes of motion for several ratios of static to kinetic friction";
    record.equations = {"69", "86", "88", "67"};
    record.given = {"SDOF; 2DOF of Fig. 10: equal masses and springs, j = 2, l = 1, zeta_i = zeta / r_n,i"};
    record.chosen = {
        "zeta = 0.1; mu = 1, 1.5, 2, 3", "panels (a), (b): r = 0.01 to 3; (c), (d): r = 0.02 to 30, both axes logarithmic",
        "markers: r = 0.2 to 2.8 in steps of 0.2, friction ratios found by halving: end of sliding in the last of 200 "
        "periods, started on the closed form and from rest; end of slipping within a period, started on the stuck motion",
        "regimes: the same r, beta = 0.07 to 1.27 in steps of 0.1, from rest"};
    for (std::size_t n = 0; n < 2; ++n) {
        std::vector<PlaneAtMu> planes;
        for (const double mu : mus) planes.push_back(plane_at_mu(figure, {names[n], families[n](0.1)}, mu));
        for (const PlaneAtMu& p : planes) add_limits(figure, p);
        for (const Agreement& a : agreements(planes)) record.agreements.push_back(a);
        for (const Statement& s :
             {less_room(planes), no_effect_while_sliding(planes, 1, 0.2), approximation(names[n], families[n]),
              high_frequency(planes), low_frequency(planes), apart(planes), regimes_as_predicted(planes)})
            record.statements.push_back(s);
        record.remarks.push_back(early_end_of_sliding(planes));
    }
    return record;
}

const Listed listed("regimes_with_mu", make);

} // namespace denhartog::figures::regimes_with_mu
