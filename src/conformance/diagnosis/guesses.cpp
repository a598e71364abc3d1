// Simple explanations of answers that no known mistake explains: a factor, an offset or a power of r, mu or gamma_j in the
// answers, another value of one input, a chain read from its other end. Read `guesses_at`; the diagnosis weighs its guesses as it
// weighs known mistakes.
#include "conformance/diagnosis/explanations.hpp"

#include <algorithm>
#include <cmath>
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

// The answers in numbers to each quantity.
std::map<std::string, std::vector<const Judged*>> numbers_by_quantity(std::span<const Judged* const> wrong) {
    std::map<std::string, std::vector<const Judged*>> all;
    for (const Judged* one : wrong)
        if (one->answered && !one->given.numbers.empty() && one->given.numbers.size() == one->vector->nearest.size())
            all[one->vector->question.quantity].push_back(one);
    return all;
}

// A change of the answers to a quantity by a number: a summand, a factor, or the power of a number of the scene that a factor is.
struct ChangeByNumber {
    const char* told;
    bool adds = false;
    double (*base)(const ProtocolQuestion&) = nullptr; // the exponent is half of a whole number; one in two answers may show none
};

constexpr ChangeByNumber changes[] = {{" plus ", true},
                                      {" times "},
                                      {" times r^", false, [](const ProtocolQuestion& q) { return q.r; }},
                                      {" times mu^", false, [](const ProtocolQuestion& q) { return q.mu; }},
                                      {" times gamma_j^", false, [](const ProtocolQuestion& q) {
                                           return q.mass_ratios.empty() ? 1
                                                                        : q.mass_ratios[static_cast<std::size_t>(q.contact - 1)];
                                       }}};

// The number that an answer shows; not a number where it shows none.
double number_shown(const ChangeByNumber& change, const Judged& one, bool angle) {
    const double given = one.given.numbers.front(), truth = one.vector->nearest.front(), factor = given / truth;
    if (change.adds) return angle ? wrapped_angle(given - truth) : given - truth;
    if (truth == 0 || change.base == nullptr) return truth == 0 ? std::nan("") : factor;
    const double base = change.base(one.vector->question);
    const bool is_power = factor > 0 && std::isfinite(factor) && base > 0 && base != 1;
    return is_power ? elementary::log(factor) / elementary::log(base) : std::nan("");
}

double changed_by(const ChangeByNumber& change, double x, double by, const ProtocolQuestion& q, bool angle) {
    if (change.adds) return angle ? wrapped_angle(x + by) : x + by;
    return x * (change.base == nullptr ? by : elementary::exp(by * elementary::log(change.base(q))));
}

// The middle one of some numbers, or the half of a whole number next to it, if every second number is that.
std::optional<double> shared(std::vector<double> numbers, bool in_halves) {
    if (numbers.empty()) return std::nullopt;
    std::ranges::nth_element(numbers, numbers.begin() + static_cast<long>(numbers.size() / 2));
    const double middle = numbers[numbers.size() / 2], x = in_halves ? std::round(2 * middle) / 2 : middle;
    const auto equal = [&](double y) { return std::abs(y - x) <= fits * std::abs(x); };
    const bool is_shared = 2 * std::ranges::count_if(numbers, equal) >= static_cast<long>(numbers.size());
    return is_shared && std::abs(middle - x) <= fits ? std::optional(x) : std::nullopt;
}

// Changes by one number of all answers to a quantity.
void add_changes(std::vector<Mistake>& all, const Quantity& asked, const std::vector<const Judged*>& answers) {
    for (const ChangeByNumber& change : changes) {
        std::vector<double> numbers;
        for (const Judged* one : answers) numbers.push_back(number_shown(change, *one, asked.angle));
        std::erase_if(numbers, [](double x) { return std::isnan(x); });
        const bool in_halves = change.base != nullptr;
        const std::optional<double> number = shared(numbers, in_halves);
        if (!number || (in_halves && (*number == 0 || 2 * numbers.size() < answers.size()))) continue;
        const auto made = [&change, by = *number, angle = asked.angle](double x, const ProtocolQuestion& q) {
            return changed_by(change, x, by, q, angle);
        };
        all.push_back(
            {"", "", std::string(asked.name) + change.told + short_text(*number), "", each_changed({asked.name}, made)});
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
    return {"", "", std::move(told), "", by_itself([change = std::move(change)](ProtocolQuestion q) {
                if (!is_of_the_paper(q)) return std::optional<Value>();
                change(q);
                return plain_answer(q, closed_form_alone);
            })};
}

// Whether a guess gives at least half of some answers. Most guesses do not, and need no further look.
bool fits_some(const Mistake& guess, std::span<const Judged* const> answers) {
    const auto fitting = std::ranges::count_if(answers, [&](const Judged* one) {
        const std::optional<Value> value = guess.answer(one->vector->question);
        return value && agrees(*one->vector, one->given, *value, fits);
    });
    return 2 * fitting >= std::ssize(answers);
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
    std::vector<double> factors = sign_changes(apart, grid);
    for (const double unit : {100.0, 1000.0, 180 / std::numbers::pi}) factors.insert(factors.end(), {unit, 1 / unit});
    for (const double factor : factors) {
        Mistake guess = read_as(std::string(input.name) + " times " + short_text(factor),
                                [&input, factor](ProtocolQuestion& q) { input.scale(q, factor); });
        if (std::abs(factor - 1) > fits && fits_some(guess, answers)) all.push_back(std::move(guess));
    }
}

// Masses or springs, from one of them on, in the other order.
Mistake in_other_order(const std::string& which, std::vector<double> ProtocolQuestion::*ratios, long from) {
    return read_as("the " + which + " in the other order", [ratios, from](ProtocolQuestion& q) {
        std::vector<double>& list = q.*ratios;
        std::reverse(list.begin() + from, list.end());
        const double unit = list.front();
        for (double& x : list) x /= unit;
    });
}

Mistake with_modes(std::string told, void (*change)(PlainModes&)) {
    return {"", "", std::move(told), "", by_itself([change](const ProtocolQuestion& q) {
                Choices c = closed_form_alone;
                c.change_modes = change;
                return plain_answer(q, c);
            })};
}

std::vector<Mistake> others() {
    return {in_other_order("masses", &ProtocolQuestion::mass_ratios, 0),
            in_other_order("springs", &ProtocolQuestion::stiffness_ratios, 0),
            in_other_order("masses behind the first", &ProtocolQuestion::mass_ratios, 1),
            in_other_order("springs behind the first", &ProtocolQuestion::stiffness_ratios, 1),
            read_as("mass ratios and stiffness ratios exchanged",
                    [](ProtocolQuestion& q) { std::swap(q.mass_ratios, q.stiffness_ratios); }),
            read_as("masses counted from the other end of the chain",
                    [](ProtocolQuestion& q) {
                        const int N = static_cast<int>(q.mass_ratios.size());
                        q.contact = N + 1 - q.contact;
                        q.load = N + 1 - q.load;
                        if (q.mass > 0) q.mass = N + 1 - q.mass;
                    }),
            with_modes("the last mode is missing",
                       [](PlainModes& m) {
                           if (m.psi.rows() > 1) m.psi.rightCols(1).setZero();
                       }),
            with_modes("damped natural frequencies in R_i of the response", [](PlainModes& m) {
                for (Index i = 0; i < m.R.size(); ++i)
                    if (m.zeta[i] < 1) m.R[i] /= std::sqrt(1 - m.zeta[i] * m.zeta[i]);
            })};
}

} // namespace

std::vector<double> sign_changes(const std::function<double(double)>& f, const std::vector<double>& grid) {
    std::vector<double> places;
    double before = f(grid.front());
    for (std::size_t n = 1; n < grid.size(); ++n) {
        const double at = f(grid[n]);
        if (before * at < 0) places.push_back(zero_between(f, grid[n - 1], grid[n]));
        before = at;
    }
    return places;
}

std::vector<Mistake> guesses_at(std::span<const Judged* const> wrong) {
    constexpr std::size_t least = 3, most_probed = 6, probes = 2;
    std::vector<Mistake> all;
    const std::map<std::string, std::vector<const Judged*>> of = numbers_by_quantity(wrong);
    for (const auto& [asked, answers] : of)
        if (answers.size() >= least) add_changes(all, quantity(asked), answers);
    // The first quantity in the protocol's order, which needs the fewest others, tells most of an input.
    for (const Quantity& each : quantities()) {
        const auto found = of.find(std::string(each.name));
        if (found == of.end() || found->second.size() < least || each.shape == Shape::samples) continue;
        const std::vector<const Judged*> probed = spread(found->second, most_probed);
        for (const Input& input : inputs)
            for (const Judged* probe : spread(probed, probes)) add_factors(all, input, probed, *probe);
        for (const Mistake& guess : others())
            if (fits_some(guess, probed)) all.push_back(guess);
        break;
    }
    return all;
}

} // namespace denhartog::conformance
