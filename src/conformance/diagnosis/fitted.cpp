// Mistakes with a number of their own, found from the answers: the instants at which a program looks for the maximum of (57),
// printed or corrected, and the period from rest in which it reads off the motion. Read `fitted_instants` and `fitted_transient`,
// then `fitted_to`, which gives the known mistakes these numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "conformance/diagnosis/explanations.hpp"
#include "conformance/mistakes/mistake_definition.hpp"
#include "conformance/verdict.hpp"
#include "denhartog/number/number_text.hpp"
#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

using std::numbers::pi;

constexpr double of_instants = 1e-6; // agreement
constexpr double largest_step = 0.8; // of a grid that deserves the name

// A wrong answer that depends on a maximum over tau.
struct Observed {
    ProtocolQuestion question;
    double given;
    PlainModes modes;
    double S; // that the answer amounts to
};

// Some of them, from all over the list.
std::vector<Observed> all_observed(std::span<const Judged> judged) {
    constexpr std::size_t most_observed = 24;
    std::vector<Observed> all;
    for (const Judged& one : judged) {
        const ProtocolQuestion& q = one.vector->question;
        if (!is_wrong_value(one.verdict) || one.given.numbers.size() != 1 || is_overdamped(q) || !is_of_the_paper(q) ||
            !asks_for(q, {"S_j", "beta_lim_exact", "beta_lim_paper"}))
            continue;
        Observed seen{q, one.given.numbers.front(), plain_modes(q, {}), one.given.numbers.front()};
        const double V = modulus(seen.modes.V[seen.modes.j]) / seen.given, U = seen.modes.U[seen.modes.j];
        if (q.quantity != "S_j") seen.S = std::sqrt(V * V - U * U);
        if (std::isfinite(seen.S)) all.push_back(std::move(seen));
    }
    return spread(all, most_observed);
}

// Steps from an end of the half-period at which a function that is large there has a value.
std::vector<double> steps_at(const std::function<double(double)>& f, double value) {
    constexpr int pieces = 160;
    const double least = elementary::log(1e-9), most = elementary::log(largest_step);
    std::vector<double> grid;
    for (int n = 0; n <= pieces; ++n) grid.push_back(elementary::exp(least + (most - least) * n / pieces));
    return sign_changes([&](double h) { return f(h) - value; }, grid);
}

// The number that most of some numbers share.
std::optional<double> most_common(std::vector<double> numbers) {
    std::ranges::sort(numbers);
    std::span<const double> best;
    for (auto from = numbers.begin(); from != numbers.end(); ++from) {
        const std::span<const double> equal(from, std::ranges::upper_bound(numbers, *from * (1 + of_instants)));
        if (equal.size() > best.size()) best = equal;
    }
    return best.size() > 1 ? std::optional(best[best.size() / 2]) : std::nullopt;
}

// Quantity to which the steps of a grid are in proportion from scene to scene.
struct GridMeasure {
    const char* told;
    double (*of)(const PlainModes&);
};

constexpr GridMeasure measures[] = {{"", [](const PlainModes&) { return 1.0; }},
                                    {" times r", [](const PlainModes& m) { return m.r; }},
                                    {" times 1/r", [](const PlainModes& m) { return 1 / m.r; }},
                                    {" times R_1", [](const PlainModes& m) { return m.R[0]; }},
                                    {" times R_N", [](const PlainModes& m) { return m.R.tail(1)[0]; }}};

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

// Search for a maximum, by (57) as printed or as corrected, of each mode or of the sum, and what becomes of the load condition
// (67).
struct WayOfSearch {
    Grid grid;
    bool as_printed = false, of_each_mode = false;
    bool Choices::*load = nullptr; // none: it is asked
};

constexpr std::array<bool Choices::*, 3> load_conditions{nullptr, &Choices::sliding_beyond_68, &Choices::without_load_condition};

// Changes the choices that a search makes, and no other.
void choose(Choices& c, const WayOfSearch& search, const PlainModes& m) {
    c.demand_as_printed = search.as_printed;
    c.instants = instants_of(search.grid, m);
    c.maximum_of_each_mode = c.maximum_of_each_mode || search.of_each_mode;
    if (search.load != nullptr) c.*search.load = true;
}

using ByWay = std::array<std::size_t, 2 * load_conditions.size()>; // of the sum and of each mode, for each load condition

WayOfSearch way_of_search(const Grid& grid, bool as_printed, std::size_t way) {
    return {grid, as_printed, way % 2 == 1, load_conditions[way / 2]};
}

// Number of answers that a grid explains in each way.
ByWay agreeing(std::span<const Observed> all, const Grid& grid, bool as_printed) {
    ByWay count{};
    for (const Observed& one : all) {
        const std::string& asked = one.question.quantity;
        std::array<double, 2> S{}; // the load condition leaves the maxima alone
        for (std::size_t way = 0; way < count.size(); ++way) {
            Choices c;
            choose(c, way_of_search(grid, as_printed, way), one.modes);
            if (way < 2) S[way] = plain_demand(one.modes, c, asked == "beta_lim_paper");
            const double x = asked == "S_j" ? S[way % 2] : plain_limit(one.modes, c, S[way % 2]);
            count[way] += std::abs(x - one.given) <= of_instants * std::abs(x);
        }
    }
    return count;
}

// The best way of some grids; of equal ones the first.
std::optional<WayOfSearch> best_of(const std::vector<Observed>& all, bool as_printed, const std::vector<Grid>& grids) {
    constexpr std::size_t first_look = 6;
    const auto first = std::span(all).first(std::min(first_look, all.size()));
    std::optional<WayOfSearch> best;
    std::size_t most = least_agreeing - 1;
    for (const Grid& grid : grids) {
        const ByWay seen = agreeing(first, grid, as_printed);
        if (seen == ByWay{}) continue;
        const ByWay counts = agreeing(all, grid, as_printed);
        for (std::size_t way = 0; way < counts.size(); ++way) {
            if (seen[way] == 0 || counts[way] <= most) continue;
            most = counts[way];
            best = way_of_search(grid, as_printed, way);
        }
    }
    return best;
}

// Steps from the start of the half-period, from its end, and from both, at which (57) as printed has a value that is observed.
using EndSteps = std::array<std::vector<double>, 3>;

EndSteps end_steps(const Observed& one) {
    const PlainModes& m = one.modes;
    const auto larger = [&](double h) {
        double S = 0;
        for (Index i = 0; i < m.R.size(); ++i)
            S += m.psi(m.j, i) * m.psi(m.j, i) * std::max(demand_of_mode(m, i, h, true), demand_of_mode(m, i, pi - h, true));
        return S;
    };
    return {steps_at([&](double h) { return plain_demand_at(m, h, true); }, one.S),
            steps_at([&](double h) { return plain_demand_at(m, pi - h, true); }, one.S), steps_at(larger, one.S)};
}

void add_grids(std::vector<Grid>& shown, const std::vector<Observed>& all, const std::vector<EndSteps>& steps,
               const GridMeasure& measure) {
    std::array<std::optional<double>, 3> common;
    for (std::size_t end = 0; end < common.size(); ++end) {
        std::vector<double> numbers;
        for (std::size_t n = 0; n < all.size(); ++n)
            for (const double h : steps[n][end]) numbers.push_back(h / measure.of(all[n].modes));
        common[end] = most_common(std::move(numbers));
    }
    const auto& [start, end, both] = common;
    const double fine = pi / 1000;
    const auto add = [&](double first, std::optional<double> before_end, std::initializer_list<double> each_step) {
        for (const double step : each_step) shown.push_back({first, before_end, step, &measure});
    };
    for (const std::optional<double>& h : {both, start, end})
        if (h) add(*h, *h, {*h, fine});
    if (start && end) add(*start, *end, {*start, *end, fine});
    if (start) add(*start, std::nullopt, {*start});
    if (start) add(*start, 0, {*start, fine});
    if (end) add(fine, *end, {fine});
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
        by_formulas(of_maximum, [search](Choices& c, const ProtocolQuestion& q) { choose(c, search, plain_modes(q, {})); }));
}

std::string told(const WayOfSearch& search) {
    const Grid& grid = search.grid;
    const auto number = [&](double x) { return number_in_digits(x, 4) + (x == 0 ? "" : grid.measure->told); };
    return "instants from " + number(grid.first) +
           (grid.before_end ? " to pi - " + number(*grid.before_end) : " on, " + number(grid.step) + " apart") +
           (search.as_printed ? "" : ", " + std::to_string(instants_of(grid, {}).count) + " of them") +
           (search.of_each_mode ? "; the maximum of each mode, (56)" : "; the maximum of the sum over the modes") +
           (search.load == &Choices::without_load_condition ? "; without the load condition (67)" : "");
}

// Finds the instants at which a program looks for the maximum of (57), from wrong answers for S_j and the boundaries: of
// `57-as-printed` or `coarse-grid-of-tau`. The instants may be the same in every scene, or proportional to r, 1 / r, R_1 or R_N.
std::optional<Mistake> fitted_instants(std::span<const Judged> judged) {
    const std::vector<Observed> all = all_observed(judged);
    if (all.size() < least_agreeing) return std::nullopt;
    std::optional<WayOfSearch> search = best_of(all, true, grids_shown(all));
    if (!search) search = best_of(all, false, coarse_grids());
    if (!search) return std::nullopt;
    Mistake fitted{search->as_printed ? "57-as-printed" : "coarse-grid-of-tau", "", "", "", answer_of(*search)};
    fitted.number = told(*search);
    if (search->of_each_mode) fitted.besides.emplace_back("56-as-printed");
    if (search->load == &Choices::sliding_beyond_68) fitted.besides.emplace_back("68-as-printed");
    return fitted;
}

std::vector<const Judged*> probes(std::span<const Judged> judged) {
    constexpr std::size_t most_probed = 9;
    std::vector<const Judged*> all;
    for (const Judged& one : judged) {
        const Vector& v = *one.vector;
        if (is_wrong_value(one.verdict) && asks_for(v.question, {"amplitude", "motion_under_force"}) &&
            one.given.numbers.size() == v.nearest.size() && is_of_the_paper(v.question))
            all.push_back(&one);
    }
    return spread(all, most_probed);
}

} // namespace

std::optional<Mistake> fitted_transient(std::span<const Judged> judged) {
    constexpr std::size_t most_periods = 200, first_probed = 3;
    const std::vector<const Judged*> some = probes(judged);
    if (some.size() < least_agreeing) return std::nullopt;
    // How many answers agree with each period, and to how many digits together.
    std::vector<std::pair<std::size_t, double>> periods(most_periods);
    std::size_t probed = 0;
    for (const Judged* one : some) {
        if (probed == first_probed && std::ranges::max(periods).first == 0) return std::nullopt;
        std::vector<std::optional<Value>> all;
        try {
            all = answers_of_transient(one->vector->question, 1, most_periods);
        } catch (const NoPlainAnswer&) { // a motion that is none shows nothing
            continue;
        }
        ++probed;
        for (std::size_t n = 0; n < most_periods; ++n) {
            if (!all[n] || !agrees(*one->vector, one->given, *all[n], of_steps_in_time)) continue;
            const double apart = difference(quantity(one->vector->question.quantity), one->given.numbers, all[n]->numbers).size;
            const double size = size_of(all[n]->numbers);
            ++periods[n].first;
            periods[n].second -= elementary::log10(std::max(apart / (size > 0 ? size : one->vector->scale), 1e-16));
        }
    }
    const auto best = std::ranges::max_element(periods);
    if (best->first < least_agreeing || 2 * best->first < probed) return std::nullopt; // of 200 some agree by chance
    const int period = static_cast<int>(best - periods.begin()) + 1;
    Mistake fitted{"transient", "", "", "", read_off_in(period)};
    fitted.number = "read off in period " + std::to_string(period) + " from rest";
    return fitted;
}

std::vector<Mistake> fitted_to(std::span<const Judged> judged, std::vector<Mistake> known) {
    for (const std::optional<Mistake>& fitted : {fitted_instants(judged), fitted_transient(judged)})
        for (Mistake& mistake : known) {
            if (!fitted || mistake.name != fitted->name) continue;
            mistake.number = fitted->number;
            mistake.answer = fitted->answer;
            mistake.besides = fitted->besides;
        }
    return known;
}

} // namespace denhartog::conformance
