#include "tests/speed_accuracy/surveys.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "tests/support/plain_response.hpp"
#include "tests/support/sample_scenes.hpp"

namespace denhartog::tests {
namespace {

/// A point with all that its comparison needs.
class Point {
public:
    Point(const Scene<double>& scene, double beta, int most_periods)
        : scene_(scene), beta_(beta), most_periods_(most_periods), system_(contact_system(scene.system)),
          sums_(mode_sums(system_.basis, system_.contact, system_.load, *scene.r)), limits_(boundary(sums_, scene.mu)),
          solver_(system_, {*scene.r, beta, scene.mu}) {}

    [[nodiscard]] Regime by_formula() const { return regime_of(limits_, beta_); }

    [[nodiscard]] bool unique() const {
        return scene_.mu == 1 && std::ranges::all_of(system_.basis.zeta, [](double zeta) { return zeta > 0; });
    }

    Comparison compare() {
        const Regime formula = by_formula();
        OrbitSearch search;
        search.most_periods = unique() ? 10 * most_periods_ : most_periods_;
        search.contact_only = true;
        const PeriodicOrbit orbit = periodic_orbit(solver_, at_rest(sums_.R.size()), search);
        if (orbit.status == OrbitStatus::permanently_stuck && formula == Regime::permanent_sticking) return Comparison::agree;
        if (orbit.status == OrbitStatus::periodic) {
            const bool twice = turns_and_way(orbit.start, 0, orbit.periods).turns <= 2 * orbit.periods;
            if (formula == Regime::continuous && orbit.stops.empty() && orbit.symmetric && twice) return Comparison::agree;
            if (formula == Regime::stick_slip && !orbit.stops.empty()) return Comparison::agree;
            if (formula == Regime::stick_slip && !twice) return Comparison::turns;
            if (formula == Regime::stick_slip && !orbit.symmetric) return Comparison::asymmetric;
        }
        if (near(limits_.exact) || (limits_.sticking && near(*limits_.sticking))) return Comparison::on_boundary;
        if (!is_from_start(orbit)) return not_converged(formula);
        return !unique() && formula_motion_exists(formula) ? Comparison::several_motions : Comparison::unexplained;
    }

private:
    struct Counts {
        int turns = 0;
        double slipped = 0; // way of the contact in a period, at most
    };

    [[nodiscard]] bool near(double limit) const { return std::abs(beta_ - limit) <= 1e-9 * limit; }

    Counts turns_and_way(const State& start, int from, int periods) {
        State z = start;
        const double period = 2 * pi<double>();
        for (int n = 0; n < from; ++n) z = solver_.run(z, 0, period).end;
        Counts counts;
        int before = 0;
        const std::size_t N = z.x.size(), j = system_.contact.index;
        for (int n = 0; n < periods; ++n) {
            const ExactMotion& motion = solver_.run(z, 0, period);
            double way = 0;
            for (std::size_t i = 0; i < motion.phases.size(); ++i) {
                const Phase& p = motion.phases[i];
                const double x_j = i + 1 < motion.phases.size() ? motion.states[2 * N * (i + 1) + j] : motion.end.x[j];
                way += std::abs(x_j - motion.states[2 * N * i + j]);
                if (p.direction == 0 || !(p.end > p.start)) continue;
                counts.turns += before == -p.direction;
                before = p.direction;
            }
            counts.slipped = std::max(way, counts.slipped);
            z = motion.end;
        }
        return counts;
    }

    // The motion that the formula stands for, started in it: it must go on. Of stick-slip the formula says what it is not.
    bool formula_motion_exists(Regime formula) {
        OrbitSearch search;
        search.most_periods = 10;
        search.contact_only = true;
        search.follow_start = false;
        if (formula == Regime::continuous) {
            const SteadyState<double> closed = steady_state(sums_, limits_, beta_);
            const PeriodicOrbit orbit = periodic_orbit(solver_, at_maximum_of_force(sums_, closed), search);
            return orbit.status == OrbitStatus::periodic && orbit.symmetric && orbit.stops.empty() &&
                   std::abs(orbit.contact.amplitude - closed.X_j) <= 1e-9 * closed.X_j;
        }
        if (formula == Regime::permanent_sticking) {
            const LastingRest rest(system_, solver_.excitation());
            const PeriodicOrbit orbit = periodic_orbit(solver_, rest.steady_state(0), search);
            return orbit.status == OrbitStatus::permanently_stuck;
        }
        return false;
    }

    Comparison not_converged(Regime formula) {
        if (unique()) return Comparison::unexplained;
        if (formula != Regime::stick_slip)
            return formula_motion_exists(formula) ? Comparison::never_settles : Comparison::unexplained;
        // Stick-slip by formula means neither sliding steadily nor resting for ever: the contact has to be moving still.
        return turns_and_way(at_rest(sums_.R.size()), most_periods_, 20).slipped > 0 ? Comparison::never_settles
                                                                                     : Comparison::unexplained;
    }

    Scene<double> scene_;
    double beta_;
    int most_periods_;
    ContactSystem system_;
    ModeSums<double> sums_;
    Boundary<double> limits_;
    ExactSolver solver_;
};

} // namespace

std::string name(Comparison c) {
    switch (c) {
    case Comparison::agree: return "agree";
    case Comparison::on_boundary: return "beta within 1e-9 of a boundary";
    case Comparison::several_motions: return "the formula's motion is there; rest leads to another";
    case Comparison::never_settles: return "rest leads to no periodic motion in the time allowed";
    case Comparison::turns: return "no stop, but more than two turns a period";
    case Comparison::asymmetric: return "no stop, but no half-period symmetry";
    case Comparison::pole: return "resonance of a mode without damping";
    case Comparison::unexplained: return "unexplained";
    }
    return {};
}

RegimeSurvey survey_regimes(int points, std::size_t most_masses, int most_periods, std::uint64_t seed) {
    RegimeSurvey survey;
    std::mt19937_64 random(seed);
    while (survey.points < points) {
        for (const RandomScene<double>& named : random_scenes<double>(random())) {
            Scene<double> scene = named.scene;
            if (number_of_masses(scene.system) > most_masses || survey.points == points) break;
            if (random() >> 63) scene.mu = 1;
            const double part = static_cast<double>(1 + (random() >> 56)) / 256 * 1.25;
            ++survey.points;
            Comparison comparison = Comparison::pole;
            bool unique = false;
            std::string at = named.name + " mu=" + digits(scene.mu, "%.17g") + " r=" + digits(*scene.r, "%.17g");
            try {
                const Boundary<double> limits = response(scene).boundary;
                const double upper = std::max(limits.exact, limits.sticking.value_or(2 * limits.exact));
                const double beta = upper > 0 ? friction_ratio_at(part, upper) : 0.25;
                at += " beta=" + digits(beta, "%a");
                Point point(scene, beta, most_periods);
                comparison = point.compare();
                unique = point.unique();
                if (comparison == Comparison::agree) ++survey.regimes[denhartog::name(point.by_formula())];
            } catch (const DomainError&) {
            }
            ++survey.count[{unique, comparison}];
            survey.example.try_emplace(comparison, at);
            if (comparison == Comparison::unexplained) survey.unexplained.push_back(at);
        }
    }
    return survey;
}

Table table_of(const RegimeSurvey& s) {
    Table table{"Regime by boundary formulas and by the exact solver, " + std::to_string(s.points) + " points",
                {"what", "mu = 1, all modes damped", "else", "example"},
                {},
                "Agreements:"};
    for (const auto& [regime, n] : s.regimes) table.note += " " + regime + " " + std::to_string(n) + ";";
    for (const auto& each : s.example) {
        const Comparison c = each.first;
        const auto of = [&](bool unique) {
            const auto found = s.count.find({unique, c});
            return std::to_string(found == s.count.end() ? 0 : found->second);
        };
        table.rows.push_back({name(c), of(true), of(false), c == Comparison::agree ? "" : each.second});
    }
    for (const std::string& at : s.unexplained) table.note += "\nUnexplained: " + at;
    return table;
}

} // namespace denhartog::tests
