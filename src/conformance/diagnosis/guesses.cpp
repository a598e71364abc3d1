// Simple explanations of answers that no known mistake explains: a factor, an offset or a power of r, mu or gamma_j in the
// answers, another value of one input, a chain read from its other end. Read `guesses_at`; the diagnosis weighs its guesses as it
// weighs known mistakes.
#include "conformance/diagnosis/explanations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "conformance/mistakes/mistake_definition.hpp"
#include "conformance/plain/closed_form.hpp"
#include "denhartog/number/number_text.hpp"
#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

constexpr double fits = 1e-6;

std::string short_text(double x) { return number_in_digits(x, 4); }

bool is_in_numbers(const Judged& one) {
    return one.answered && one.given.word.empty() && !one.given.numbers.empty() &&
           one.given.numbers.size() == one.vector->nearest.size();
}

// The answers in numbers to each quantity.
std::map<std::string, std::vector<const Judged*>> numbers_by_quantity(std::span<const Judged* const> wrong) {
    std::map<std::string, std::vector<const Judged*>> all;
    for (const Judged* one : wrong)
        if (is_in_numbers(*one)) all[one->vector->question.quantity].push_back(one);
    return all;
}

Mistake changed_numbers(std::string told, const std::string& asked,
                        std::function<double(double x, const ProtocolQuestion& q)> change) {
    return {"", "", std::move(told), "", each_changed({quantity(asked).name}, std::move(change))};
}

// The middle one of some numbers, or the half of a whole number next to it, if every second number is that.
std::optional<double> shared(std::vector<double> numbers, bool in_halves = false) {
    if (numbers.empty()) return std::nullopt;
    std::nth_element(numbers.begin(), numbers.begin() + static_cast<long>(numbers.size() / 2), numbers.end());
    const double middle = numbers[numbers.size() / 2], x = in_halves ? std::round(2 * middle) / 2 : middle;
    const auto equal = [&](double y) { return std::abs(y - x) <= fits * std::abs(x); };
    const bool is_shared = 2 * std::ranges::count_if(numbers, equal) >= static_cast<long>(numbers.size());
    return is_shared && std::abs(middle - x) <= fits ? std::optional(x) : std::nullopt;
}

// A factor, or an offset, in the answers to a quantity.
void add_changes(std::vector<Mistake>& all, const std::string& asked, const std::vector<const Judged*>& answers) {
    std::vector<double> factors, offsets;
    const bool angle = quantity(asked).angle;
    for (const Judged* one : answers) {
        const double given = one->given.numbers.front(), truth = one->vector->nearest.front();
        if (truth != 0) factors.push_back(given / truth);
        offsets.push_back(angle ? wrapped_angle(given - truth) : given - truth);
    }
    if (const std::optional<double> offset = shared(offsets))
        all.push_back(
            changed_numbers(asked + " plus " + short_text(*offset), asked, [=, by = *offset](double x, const ProtocolQuestion&) {
                return angle ? wrapped_angle(x + by) : x + by;
            }));
    if (const std::optional<double> factor = shared(factors))
        all.push_back(changed_numbers(asked + " times " + short_text(*factor), asked,
                                      [by = *factor](double x, const ProtocolQuestion&) { return by * x; }));
}

// A number of the scene, to some power of which answers may have a wrong factor.
struct Base {
    const char* name;
    double (*of)(const ProtocolQuestion&);
};

constexpr Base bases[] = {{"r", [](const ProtocolQuestion& q) { return q.r; }},
                          {"mu", [](const ProtocolQuestion& q) { return q.mu; }},
                          {"gamma_j", [](const ProtocolQuestion& q) {
                               return q.mass_ratios.empty() ? 1 : q.mass_ratios[static_cast<std::size_t>(q.contact - 1)];
                           }}};

// A power of a number of the scene in the answers to a quantity.
void add_powers(std::vector<Mistake>& all, const std::string& asked, const std::vector<const Judged*>& answers) {
    for (const Base& base : bases) {
        std::vector<double> exponents;
        for (const Judged* one : answers) {
            const double factor = one->given.numbers.front() / one->vector->nearest.front();
            const double size = base.of(one->vector->question);
            if (factor > 0 && std::isfinite(factor) && size > 0 && size != 1)
                exponents.push_back(elementary::log(factor) / elementary::log(size));
        }
        if (2 * exponents.size() < answers.size()) continue;
        const double exponent = shared(exponents, true).value_or(0);
        if (exponent == 0) continue;
        all.push_back(changed_numbers(asked + " times " + base.name + "^" + short_text(exponent), asked,
                                      [&base, exponent](double x, const ProtocolQuestion& q) {
                                          return x * elementary::exp(exponent * elementary::log(base.of(q)));
                                      }));
    }
}

struct Input {
    const char* name;
    void (*scale)(ProtocolQuestion&, double);
};

void scale_all(std::vector<double>& list, double by, std::size_t from = 0) {
    for (std::size_t n = from; n < list.size(); ++n) list[n] *= by;
}

constexpr Input inputs[] = {
    {"beta", [](ProtocolQuestion& q, double f) { q.beta *= f; }},
    {"mu", [](ProtocolQuestion& q, double f) { q.mu *= f; }},
    {"r", [](ProtocolQuestion& q, double f) { q.r *= f; }},
    {"every damping ratio", [](ProtocolQuestion& q, double f) { scale_all(q.damping_ratios, f); }},
    {"every mass ratio but the first", [](ProtocolQuestion& q, double f) { scale_all(q.mass_ratios, f, 1); }},
    {"every stiffness ratio but the first", [](ProtocolQuestion& q, double f) { scale_all(q.stiffness_ratios, f, 1); }}};

const Choices closed_form_alone{.closed_form_alone = true};

Mistake read_as(std::string told, std::function<void(ProtocolQuestion&)> change) {
    return {"", "", std::move(told), "", [change = std::move(change)](const ProtocolQuestion& q) {
                if (!is_of_the_paper(q)) return std::optional<Value>();
                ProtocolQuestion other = q;
                change(other);
                return plain_answer(other, closed_form_alone);
            }};
}

// Whether a guess gives half of some answers. Most guesses do not, and need no further look.
bool fits_some(const Mistake& guess, std::span<const Judged* const> answers) {
    std::size_t fitting = 0;
    for (const Judged* one : answers) {
        const std::optional<Value> value = guess.answer(one->vector->question);
        if (!value || value->numbers.size() != one->given.numbers.size()) continue;
        const double size = std::max(std::abs(one->given.numbers.front()), one->vector->scale * fits);
        fitting += std::abs(value->numbers.front() - one->given.numbers.front()) <= fits * size;
    }
    return 2 * fitting >= answers.size();
}

// Factors of an input by which the closed form answers as was answered.
void add_factors(std::vector<Mistake>& all, const Input& input, std::span<const Judged* const> answers, const Judged& one) {
    constexpr int pieces = 48;
    const double reach = elementary::log(12.0);
    const auto apart = [&](double factor) {
        ProtocolQuestion q = one.vector->question;
        input.scale(q, factor);
        const std::optional<Value> value = plain_answer(q, closed_form_alone);
        return value && !value->numbers.empty() ? value->numbers.front() - one.given.numbers.front() : std::nan("");
    };
    std::vector<double> grid;
    for (int n = 0; n <= pieces; ++n) grid.push_back(elementary::exp(reach * (2.0 * n / pieces - 1)));
    std::vector<double> factors = sign_changes(apart, grid, 48);
    for (const double unit : {100.0, 1000.0, 180 / std::numbers::pi}) factors.insert(factors.end(), {unit, 1 / unit});
    for (const double factor : factors) {
        Mistake guess = read_as(std::string(input.name) + " times " + short_text(factor),
                                [&input, factor](ProtocolQuestion& q) { input.scale(q, factor); });
        if (std::abs(factor - 1) > fits && fits_some(guess, answers)) all.push_back(std::move(guess));
    }
}

Mistake with(std::string told, std::function<void(Choices&)> choose) {
    return {"", "", std::move(told), "", [choose = std::move(choose)](const ProtocolQuestion& q) {
                Choices c = closed_form_alone;
                choose(c);
                return plain_answer(q, c);
            }};
}

void add_others(std::vector<Mistake>& all) {
    const auto reversed = [](std::vector<double>& list, std::size_t from) {
        std::reverse(list.begin() + static_cast<long>(from), list.end());
        const double unit = list.front();
        for (double& x : list) x /= unit;
    };
    for (const std::size_t from : {0, 1}) {
        const std::string which = from == 0 ? "" : " behind the first";
        all.push_back(
            read_as("the masses" + which + " in the other order", [=](ProtocolQuestion& q) { reversed(q.mass_ratios, from); }));
        all.push_back(read_as("the springs" + which + " in the other order",
                              [=](ProtocolQuestion& q) { reversed(q.stiffness_ratios, from); }));
    }
    all.push_back(read_as("mass ratios and stiffness ratios exchanged",
                          [](ProtocolQuestion& q) { std::swap(q.mass_ratios, q.stiffness_ratios); }));
    all.push_back(read_as("masses counted from the other end of the chain", [](ProtocolQuestion& q) {
        const int N = static_cast<int>(q.mass_ratios.size());
        q.contact = N + 1 - q.contact;
        q.load = N + 1 - q.load;
        if (q.mass > 0) q.mass = N + 1 - q.mass;
    }));
    all.push_back(with("the last mode is missing", [](Choices& c) {
        c.change_modes = [](PlainModes& m) {
            if (m.psi.size() > 1)
                for (auto& row : m.psi) row.back() = 0;
        };
    }));
    all.push_back(with("damped natural frequencies in R_i of the response", [](Choices& c) {
        c.change_modes = [](PlainModes& m) {
            for (std::size_t i = 0; i < m.R.size(); ++i)
                if (m.zeta[i] < 1) m.R[i] /= std::sqrt(1 - m.zeta[i] * m.zeta[i]);
        };
    }));
}

} // namespace

std::vector<double> sign_changes(const std::function<double(double)>& f, const std::vector<double>& grid, int halvings) {
    std::vector<double> places;
    double f_before = f(grid.front());
    for (std::size_t n = 1; n < grid.size(); ++n) {
        const double f_at = f(grid[n]);
        if (f_before * f_at < 0) {
            double a = grid[n - 1], b = grid[n];
            for (int halving = 0; halving < halvings; ++halving) {
                const double middle = (a + b) / 2;
                (f_before * f(middle) < 0 ? b : a) = middle;
            }
            places.push_back((a + b) / 2);
        }
        f_before = f_at;
    }
    return places;
}

std::vector<Mistake> guesses_at(std::span<const Judged* const> wrong) {
    constexpr std::size_t least = 3, most_probed = 6, probes = 2;
    std::vector<Mistake> all;
    std::map<std::string, std::vector<const Judged*>> of = numbers_by_quantity(wrong);
    for (const auto& [asked, answers] : of)
        if (answers.size() >= least) {
            add_changes(all, asked, answers);
            add_powers(all, asked, answers);
        }
    // The first quantity in the protocol's order, which needs the fewest others, tells most of an input.
    for (const Quantity& each : quantities()) {
        const auto found = of.find(std::string(each.name));
        if (found == of.end() || found->second.size() < least || each.shape == Shape::samples) continue;
        const std::vector<const Judged*> probed = spread(found->second, most_probed);
        for (const Input& input : inputs)
            for (const Judged* probe : spread(probed, probes)) add_factors(all, input, probed, *probe);
        std::vector<Mistake> others;
        add_others(others);
        for (Mistake& guess : others)
            if (fits_some(guess, probed)) all.push_back(std::move(guess));
        break;
    }
    return all;
}

} // namespace denhartog::conformance
