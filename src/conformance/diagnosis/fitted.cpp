// Mistakes with a number of their own, found from the answers: the instants at which a program looks for the maximum of (57),
// printed or corrected, and the period from rest in which it reads off the motion. Read `fitted_instants` and `fitted_transient`,
// then `fitted_to`, which gives the known mistakes these numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "conformance/diagnosis/explanations.hpp"
#include "conformance/grade.hpp"
#include "conformance/mistakes/mistake_definition.hpp"
#include "conformance/plain/closed_form.hpp"
#include "denhartog/number/number_text.hpp"
#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

constexpr double of_instants = 1e-6; // agreement
constexpr std::size_t most_observed = 24;
constexpr double largest_step = 0.8; // of a grid that deserves the name

// A wrong answer that depends on a maximum over tau.
struct Observed {
    ProtocolQuestion question;
    double given;
    PlainModes modes;
    double S; // that the answer amounts to
};

double maximum_behind(const ProtocolQuestion& q, double given, const PlainModes& m) {
    if (q.quantity == "S_j") return given;
    const double V = modulus(m.V[m.j]) / given, U = m.U[m.j];
    return std::sqrt(V * V - U * U);
}

std::optional<Observed> observed(const Judged& one) {
    const ProtocolQuestion& q = one.vector->question;
    if (!is_wrong_value(one.verdict) || one.given.numbers.size() != 1 || is_overdamped(q) || !is_of_the_paper(q))
        return std::nullopt;
    if (!asks_for(q, {"S_j", "beta_lim_exact", "beta_lim_paper"})) return std::nullopt;
    Observed seen{q, one.given.numbers.front(), plain_modes(q, {}), 0};
    seen.S = maximum_behind(q, seen.given, seen.modes);
    return std::isfinite(seen.S) ? std::optional(seen) : std::nullopt;
}

// Some of them, from all over the list.
std::vector<Observed> all_observed(std::span<const Judged> judged) {
    std::vector<Observed> all;
    for (const Judged& one : judged)
        if (std::optional<Observed> seen = observed(one)) all.push_back(std::move(*seen));
    return spread(all, most_observed);
}

double printed_of_mode(const PlainModes& m, std::size_t i, double tau) {
    return m.psi[m.j][i] * m.psi[m.j][i] * printed_demand_of_mode(m, i, tau);
}

// Steps from an end of the half-period at which a function that is large there has a value.
std::vector<double> steps_at(const std::function<double(double)>& f, double value) {
    constexpr int pieces = 160;
    const double least = elementary::log(1e-9), most = elementary::log(largest_step);
    std::vector<double> grid;
    for (int n = 0; n <= pieces; ++n) grid.push_back(elementary::exp(least + (most - least) * n / pieces));
    return sign_changes([&](double h) { return f(h) - value; }, grid, 60);
}

// The number that most of some numbers share.
std::optional<double> most_common(std::vector<double> numbers) {
    std::sort(numbers.begin(), numbers.end());
    std::size_t best = 0, most = 1;
    for (std::size_t from = 0, to = 0; from < numbers.size(); ++from) {
        to = std::max(to, from);
        while (to < numbers.size() && numbers[to] <= numbers[from] * (1 + of_instants)) ++to;
        if (to - from > most) {
            most = to - from;
            best = from + most / 2;
        }
    }
    return most > 1 ? std::optional(numbers[best]) : std::nullopt;
}

// Quantity to which the steps of a grid are in proportion from scene to scene.
struct GridMeasure {
    const char* told;
    double (*of)(const PlainModes&);
};

constexpr GridMeasure measures[] = {{"", [](const PlainModes&) { return 1.0; }},
                                    {" times r", [](const PlainModes& m) { return m.r; }},
                                    {" times 1/r", [](const PlainModes& m) { return 1 / m.r; }},
                                    {" times R_1", [](const PlainModes& m) { return m.R.front(); }},
                                    {" times R_N", [](const PlainModes& m) { return m.R.back(); }}};

// Equally spaced instants, the numbers in units of the measure.
struct Grid {
    double first;
    std::optional<double> before_end; // none: whatever the steps leave
    double step;
    const GridMeasure* measure = measures;
};

Instants instants_of(const Grid& grid, const PlainModes& m) {
    const double unit = grid.measure->of(m), first = unit * grid.first, step = unit * grid.step;
    const double rest = std::numbers::pi - first - unit * grid.before_end.value_or(0);
    const double steps = std::max(1.0, grid.before_end ? std::round(rest / step) : std::floor(rest / step));
    const double before_end = std::numbers::pi - first - (grid.before_end ? rest : steps * step);
    return {first, before_end, static_cast<std::size_t>(std::min(steps, 4096.0)) + 1};
}

// Treatment of the load condition (67).
enum class LoadCondition : std::uint8_t { asked, beyond_68, left_out };

constexpr std::array load_conditions{LoadCondition::asked, LoadCondition::beyond_68, LoadCondition::left_out};

// Search for a maximum, by (57) as printed or as corrected.
struct WayOfSearch {
    Grid grid;
    bool as_printed = false, of_each_mode = false;
    LoadCondition load = LoadCondition::asked;
};

void choose(Choices& c, LoadCondition load) {
    c.without_load_condition = c.without_load_condition || load == LoadCondition::left_out;
    c.sliding_beyond_68 = c.sliding_beyond_68 || load == LoadCondition::beyond_68;
}

Choices choices_of(const WayOfSearch& search, const PlainModes& m) {
    Choices c;
    c.demand_as_printed = search.as_printed;
    c.instants = instants_of(search.grid, m);
    c.maximum_of_each_mode = search.of_each_mode;
    choose(c, search.load);
    return c;
}

using ByLoadCondition = std::array<std::size_t, load_conditions.size()>;

// Number of answers that a search explains, for each treatment of the load condition (67), which leaves the maxima alone.
ByLoadCondition agreeing(std::span<const Observed> all, const WayOfSearch& search) {
    ByLoadCondition count{};
    for (const Observed& one : all) {
        const std::string& asked = one.question.quantity;
        const PlainModes& m = one.modes;
        const Choices c = choices_of(search, m);
        const double S = plain_demand(m, c, asked == "beta_lim_paper");
        const auto agrees = [&](double x) { return std::abs(x - one.given) <= of_instants * std::abs(x); };
        for (std::size_t n = 0; n < count.size(); ++n) {
            Choices with = c;
            choose(with, load_conditions[n]);
            count[n] += agrees(asked == "S_j" ? S : plain_limit(m, with, S));
        }
    }
    return count;
}

// The best of some grids, each with the sum before the maximum or after it, with the load condition or without.
std::optional<WayOfSearch> best_of(const std::vector<Observed>& all, bool as_printed, const std::vector<Grid>& grids) {
    constexpr std::size_t first_look = 6;
    const auto first = std::span(all).first(std::min(first_look, all.size()));
    std::optional<WayOfSearch> best;
    std::size_t most = least_agreeing - 1;
    for (const Grid& grid : grids) {
        std::array<ByLoadCondition, 2> counts{};
        for (const bool of_each_mode : {false, true}) {
            const WayOfSearch search{grid, as_printed, of_each_mode};
            const ByLoadCondition seen = agreeing(first, search);
            if (seen == ByLoadCondition{}) continue;
            counts[of_each_mode] = agreeing(all, search);
            for (std::size_t n = 0; n < seen.size(); ++n)
                if (seen[n] == 0) counts[of_each_mode][n] = 0;
        }
        for (std::size_t n = 0; n < load_conditions.size(); ++n)
            for (const bool of_each_mode : {false, true}) {
                if (counts[of_each_mode][n] <= most) continue;
                most = counts[of_each_mode][n];
                best = WayOfSearch{grid, as_printed, of_each_mode, load_conditions[n]};
            }
    }
    return best;
}

// Steps from the ends of the half-period at which (57) as printed has the values that are observed.
struct EndSteps {
    std::vector<double> at_start, at_end, at_both;
};

EndSteps end_steps(const Observed& one) {
    const PlainModes& m = one.modes;
    const auto sum = [&](const std::function<double(std::size_t)>& of_mode) {
        double S = 0;
        for (std::size_t i = 0; i < m.R.size(); ++i) S += of_mode(i);
        return S;
    };
    const auto late = [](double step) { return std::numbers::pi - step; };
    const auto larger = [&](std::size_t i, double h) {
        return std::max(printed_of_mode(m, i, h), printed_of_mode(m, i, late(h)));
    };
    return {steps_at([&](double h) { return sum([&](std::size_t i) { return printed_of_mode(m, i, h); }); }, one.S),
            steps_at([&](double h) { return sum([&](std::size_t i) { return printed_of_mode(m, i, late(h)); }); }, one.S),
            steps_at([&](double h) { return sum([&](std::size_t i) { return larger(i, h); }); }, one.S)};
}

void add_grids(std::vector<Grid>& shown, const std::vector<Observed>& all, const std::vector<EndSteps>& steps,
               const GridMeasure& measure) {
    const auto common = [&](std::vector<double> EndSteps::*end) {
        std::vector<double> numbers;
        for (std::size_t n = 0; n < all.size(); ++n)
            for (const double h : steps[n].*end) numbers.push_back(h / measure.of(all[n].modes));
        return most_common(std::move(numbers));
    };
    const std::optional<double> start = common(&EndSteps::at_start), end = common(&EndSteps::at_end),
                                both = common(&EndSteps::at_both);
    const double fine = std::numbers::pi / 1000;
    const auto add = [&](double first, std::optional<double> before_end, double step) {
        shown.push_back({first, before_end, step, &measure});
    };
    for (const std::optional<double>& h : {both, start, end}) {
        if (!h) continue;
        add(*h, *h, *h);
        add(*h, *h, fine);
    }
    if (start && end) {
        add(*start, *end, *start);
        add(*start, *end, *end);
        add(*start, *end, fine);
    }
    if (start) {
        add(*start, std::nullopt, *start);
        add(*start, 0, *start);
        add(*start, 0, fine);
    }
    if (end) {
        add(*end, *end, *end);
        add(fine, *end, fine);
    }
}

std::vector<Grid> grids_shown(const std::vector<Observed>& all) {
    std::vector<EndSteps> steps;
    for (const Observed& one : all) steps.push_back(end_steps(one));
    std::vector<Grid> shown;
    for (const GridMeasure& measure : measures) add_grids(shown, all, steps, measure);
    return shown;
}

std::vector<Grid> coarse_grids() {
    std::vector<Grid> grids;
    for (int steps = 4; steps <= 64; ++steps) {
        const double h = std::numbers::pi / steps;
        grids.insert(grids.end(), {{0, 0.0, h}, {0, h, h}, {h, h, h}, {h / 2, h / 2, h}});
    }
    return grids;
}

Answering answer_of(const WayOfSearch& search) {
    return where_modes_vibrate(
        by_formulas_of({"S_j", "beta_lim_exact", "beta_lim_paper", "regime"}, [search](Choices& c, const ProtocolQuestion& q) {
            const Choices of_search = choices_of(search, plain_modes(q, {}));
            c.demand_as_printed = of_search.demand_as_printed;
            c.instants = of_search.instants;
            c.maximum_of_each_mode = c.maximum_of_each_mode || of_search.maximum_of_each_mode;
            choose(c, search.load);
        }));
}

std::vector<std::string> named_besides(const WayOfSearch& search) {
    std::vector<std::string> names;
    if (search.of_each_mode) names.emplace_back("56-as-printed");
    if (search.load == LoadCondition::beyond_68) names.emplace_back("68-as-printed");
    return names;
}

std::string told(const WayOfSearch& search) {
    const Grid& grid = search.grid;
    const auto number = [&](double x) { return number_in_digits(x, 4) + (x == 0 ? "" : grid.measure->told); };
    return "instants from " + number(grid.first) +
           (grid.before_end ? " to pi - " + number(*grid.before_end) : " on, " + number(grid.step) + " apart") +
           (search.as_printed ? "" : ", " + std::to_string(instants_of(grid, {}).count) + " of them") +
           (search.of_each_mode ? "; the maximum of each mode, (56)" : "; the maximum of the sum over the modes") +
           (search.load == LoadCondition::left_out ? "; without the load condition (67)" : "");
}

constexpr int most_periods = 200;
constexpr std::size_t most_probed = 9, first_probed = 3;

// Distance of a wrong answer from the motion from rest, for each of its periods; infinite for an answer that is not of a period.
std::vector<double> distances(const Judged& one) {
    const Quantity& asked = quantity(one.vector->question.quantity);
    const double from_truth = difference(asked, one.given.numbers, one.vector->nearest).size;
    std::vector<double> all;
    for (const std::optional<Value>& shown : answers_of_transient(one.vector->question, 1, most_periods)) {
        const double apart = shown ? difference(asked, one.given.numbers, shown->numbers).size : INFINITY;
        const bool agrees =
            shown && apart <= of_steps_in_time * size_of(shown->numbers) && apart <= nearer_than_truth * from_truth;
        all.push_back(agrees ? apart / size_of(shown->numbers) : INFINITY);
    }
    return all;
}

std::vector<const Judged*> probes(std::span<const Judged> judged) {
    std::vector<const Judged*> all;
    for (const Judged& one : judged) {
        const Vector& v = *one.vector;
        if (is_wrong_value(one.verdict) && asks_for(v.question, {"amplitude", "motion_under_force"}) &&
            one.given.numbers.size() == v.nearest.size() && is_of_the_paper(v.question))
            all.push_back(&one);
    }
    return spread(all, most_probed);
}

struct Shown {
    int period = 0;
    std::size_t agreeing = 0;
    double distance = 0; // the sum of the digits that are missing, negative
};

// The period that most answers show; of two the one to which they are nearer.
Shown shown_by(const std::vector<std::vector<double>>& all) {
    Shown best;
    for (int n = 1; n <= most_periods; ++n) {
        Shown of_n{n, 0, 0};
        for (const std::vector<double>& of_one : all) {
            const double apart = of_one[static_cast<std::size_t>(n - 1)];
            if (!std::isfinite(apart)) continue;
            ++of_n.agreeing;
            of_n.distance += elementary::log10(std::max(apart, 1e-16));
        }
        if (of_n.agreeing > best.agreeing || (of_n.agreeing == best.agreeing && of_n.distance < best.distance)) best = of_n;
    }
    return best;
}

// Finds the instants at which a program looks for the maximum of (57), from wrong answers for S_j and the boundaries: of
// `57-as-printed` or `coarse-grid-of-tau`. The instants may be the same in every scene, or proportional to r, 1 / r, R_1 or R_N.
std::optional<Fitted> fitted_instants(std::span<const Judged> judged) {
    const std::vector<Observed> all = all_observed(judged);
    if (all.size() < least_agreeing) return std::nullopt;
    std::optional<WayOfSearch> search = best_of(all, true, grids_shown(all));
    if (!search) search = best_of(all, false, coarse_grids());
    if (!search) return std::nullopt;
    return Fitted{search->as_printed ? "57-as-printed" : "coarse-grid-of-tau", told(*search), answer_of(*search),
                  named_besides(*search)};
}

} // namespace

std::optional<Fitted> fitted_transient(std::span<const Judged> judged) {
    const std::vector<const Judged*> some = probes(judged);
    if (some.size() < least_agreeing) return std::nullopt;
    std::vector<std::vector<double>> all;
    for (const Judged* one : some) {
        if (all.size() == first_probed && shown_by(all).agreeing == 0) return std::nullopt;
        try {
            all.push_back(distances(*one));
        } catch (const NoPlainAnswer&) { // a motion that is none shows nothing
        }
    }
    const Shown shown = shown_by(all);
    if (shown.agreeing < least_agreeing || 2 * shown.agreeing < all.size()) return std::nullopt; // of 200 some agree by chance
    return Fitted{"transient", "read off in period " + std::to_string(shown.period) + " from rest",
                  [period = shown.period](const ProtocolQuestion& q) {
                      if (!asks_for(q, {"amplitude", "phase", "motion_under_force"})) return std::optional<Value>();
                      return where_finite([&] { return answers_of_transient(q, period, period).front(); });
                  }};
}

std::vector<Mistake> fitted_to(std::span<const Judged> judged, std::vector<Mistake> known) {
    for (const std::optional<Fitted>& fitted : {fitted_instants(judged), fitted_transient(judged)})
        for (Mistake& mistake : known) {
            if (!fitted || mistake.name != fitted->name) continue;
            mistake.number = fitted->number;
            mistake.answer = fitted->answer;
            mistake.besides = fitted->besides;
        }
    return known;
}

} // namespace denhartog::conformance
