#include "conformance/fitted.hpp"

#include <algorithm>
#include <cmath>

#include "conformance/mistakes/mistake_definition.hpp"
#include "conformance/plain/closed_form.hpp"
#include "conformance/spread.hpp"
#include "denhartog/formulas/as_printed.hpp"

namespace denhartog::conformance {
namespace {

constexpr double of_instants = 1e-6; // agreement
constexpr std::size_t most_observed = 24, least_agreeing = 3;
constexpr double largest_step = 0.8; // of a grid that deserves the name

// A wrong answer that depends on a maximum over tau.
struct Observed {
    Question question;
    double given;
    PlainModes modes;
    double S; // that the answer amounts to
};

double maximum_behind(const Question& q, double given, const PlainModes& m) {
    if (q.quantity == "S_j") return given;
    const double V = modulus(m.V[m.j]) / given, U = m.U[m.j];
    return std::sqrt(V * V - U * U);
}

std::optional<Observed> observed(const Judged& one) {
    const Question& q = one.vector->question;
    if (!is_wrong_value(one.verdict) || one.given.numbers.size() != 1 || is_overdamped(q)) return std::nullopt;
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
    return m.psi[m.j][i] * m.psi[m.j][i] * as_printed::s_d_integrand(tau, m.R[i], m.zeta[i], m.u[i], m.g[i]);
}

// Steps from an end of the half-period at which a function that is large there has a value.
void add_steps(std::vector<double>& steps, const std::function<double(double)>& f, double value) {
    constexpr int pieces = 160;
    const double least = std::log(1e-9), most = std::log(largest_step);
    double before = std::exp(least), f_before = f(before);
    for (int n = 1; n <= pieces; ++n) {
        const double at = std::exp(least + (most - least) * n / pieces), f_at = f(at);
        if ((f_before - value) * (f_at - value) < 0) {
            double a = before, b = at;
            for (int halvings = 0; halvings < 60; ++halvings) {
                const double middle = (a + b) / 2;
                ((f_before - value) * (f(middle) - value) < 0 ? b : a) = middle;
            }
            steps.push_back((a + b) / 2);
        }
        before = at;
        f_before = f_at;
    }
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

std::size_t agreeing(std::span<const Observed> all, const Choices& c) {
    std::size_t count = 0;
    for (const Observed& one : all) {
        const std::string& asked = one.question.quantity;
        const PlainLimits limits = plain_limits(one.question, one.modes, c, needed_for(asked));
        const double x = asked == "S_j" ? limits.S : asked == "beta_lim_exact" ? limits.exact : limits.paper;
        if (std::abs(x - one.given) <= of_instants * std::abs(x)) ++count;
    }
    return count;
}

// The best of some choices of instants, each with the sum before the maximum or after it, with the load condition or without.
std::optional<Choices> best_of(const std::vector<Observed>& all, bool as_printed, const std::vector<Instants>& instants) {
    std::optional<Choices> best;
    std::size_t most = least_agreeing - 1;
    for (const Instants& each : instants)
        for (const int variant : {0, 1, 2, 3}) {
            Choices c;
            c.demand_as_printed = as_printed;
            c.instants = each;
            c.maximum_of_each_mode = variant % 2 == 1;
            c.without_load_condition = variant / 2 == 1;
            constexpr std::size_t first_look = 6;
            if (agreeing(std::span(all).first(std::min(first_look, all.size())), c) == 0) continue;
            const std::size_t count = agreeing(all, c);
            if (count <= most) continue;
            most = count;
            best = c;
        }
    return best;
}

Instants between(double first, double before_end, double step) {
    const double steps = std::round((pi<double>() - first - before_end) / step);
    return {first, before_end, static_cast<std::size_t>(std::clamp(steps, 1.0, 4096.0)) + 1};
}

std::vector<Instants> instants_shown(const std::vector<Observed>& all) {
    std::vector<double> at_start, at_end, at_both;
    for (const Observed& one : all) {
        const PlainModes& m = one.modes;
        const auto sum = [&](const std::function<double(std::size_t)>& of_mode) {
            double S = 0;
            for (std::size_t i = 0; i < m.R.size(); ++i) S += of_mode(i);
            return S;
        };
        const auto late = [](double step) { return pi<double>() - step; };
        add_steps(
            at_start, [&](double h) { return sum([&](std::size_t i) { return printed_of_mode(m, i, h); }); }, one.S);
        add_steps(
            at_end, [&](double h) { return sum([&](std::size_t i) { return printed_of_mode(m, i, late(h)); }); }, one.S);
        const auto larger = [&](std::size_t i, double h) {
            return std::max(printed_of_mode(m, i, h), printed_of_mode(m, i, late(h)));
        };
        add_steps(
            at_both, [&](double h) { return sum([&](std::size_t i) { return larger(i, h); }); }, one.S);
    }
    const std::optional<double> start = most_common(at_start), end = most_common(at_end), both = most_common(at_both);
    const double fine = pi<double>() / 1000;
    std::vector<Instants> shown;
    for (const std::optional<double>& h : {both, start, end})
        if (h) shown.insert(shown.end(), {between(*h, *h, *h), between(*h, *h, fine)});
    if (start && end)
        shown.insert(shown.end(), {between(*start, *end, *start), between(*start, *end, *end), between(*start, *end, fine)});
    if (start) shown.insert(shown.end(), {between(*start, 0, *start), between(*start, 0, fine)});
    if (end) shown.insert(shown.end(), {between(*end, *end, *end), between(fine, *end, fine)});
    return shown;
}

std::vector<Instants> coarse_grids() {
    std::vector<Instants> grids;
    for (std::size_t steps = 4; steps <= 64; ++steps) {
        const double h = pi<double>() / static_cast<double>(steps);
        grids.push_back({0, 0, steps + 1});
        grids.push_back({0, h, steps});
        grids.push_back({h, h, steps - 1});
        grids.push_back({h / 2, h / 2, steps});
    }
    return grids;
}

std::function<std::optional<Value>(const Question&)> answers_with(const Choices& c) {
    return [c](const Question& q) {
        if (is_overdamped(q) || !asks_for(q, {"S_j", "beta_lim_exact", "beta_lim_paper", "regime"}))
            return std::optional<Value>();
        return plain_answer(q, c);
    };
}

} // namespace

FittedAnswers fitted_answers(std::span<const Judged> judged) {
    FittedAnswers fitted;
    const std::vector<Observed> all = all_observed(judged);
    if (all.size() < least_agreeing) return fitted;
    if (const std::optional<Choices> printed = best_of(all, true, instants_shown(all)))
        fitted.emplace("57-as-printed", answers_with(*printed));
    else if (const std::optional<Choices> coarse = best_of(all, false, coarse_grids()))
        fitted.emplace("coarse-grid-of-tau", answers_with(*coarse));
    return fitted;
}

} // namespace denhartog::conformance
