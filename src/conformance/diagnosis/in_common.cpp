// The wrong answers that no known mistake explains: their links in the chain of quantities, properties that they share, and their
// counts by quantity. Read `properties_in_common` first.
#include "conformance/diagnosis/explanations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <string_view>

#include "denhartog/number/number_text.hpp"

namespace denhartog::conformance {
namespace {

constexpr double share_in_common = 0.9;
constexpr double least_lift = 1.25;
constexpr std::size_t most_told = 3;
constexpr std::size_t least_wrong = 3;

// Properties of a question in words, each with its opposite.
std::set<std::string> properties(const Vector& v) {
    const ProtocolQuestion& q = v.question;
    std::set<std::string> all;
    for (const std::string& flag : v.flags) all.insert("flag " + flag);
    all.insert(masses_of(q) > 1 ? "N > 1" : "N = 1");
    all.insert(masses_of(q) > 2 ? "N > 2" : "N <= 2");
    if (q.quantity == "displacement") all.insert(q.tau > std::numbers::pi ? "tau > pi" : "tau <= pi");
    all.insert(q.mu > 1 ? "mu > 1" : "mu = 1");
    all.insert(is_of_the_paper(q) ? "a scene of the paper" : "a system beyond the paper");
    if (q.contact_with == 0 && q.load != 0) {
        all.insert(q.contact == q.load ? "j = l" : "j != l");
        if (q.contact != q.load) all.insert(q.contact < q.load ? "j < l" : "j > l");
    }
    if (q.mass != 0 && q.contact_with == 0) all.insert(q.mass == q.contact ? "k = j" : "k != j");
    all.insert(q.beta == 0 ? "beta = 0" : "beta > 0");
    all.insert(q.r > 1 ? "r > 1" : "r <= 1");
    if (!v.regime.empty()) all.insert("regime " + v.regime);
    const auto undamped = [](double zeta) { return zeta == 0; };
    if (std::any_of(q.damping_ratios.begin(), q.damping_ratios.end(), undamped)) all.insert("a zeta of 0");
    if (is_overdamped(q)) all.insert("a zeta of 1 or more");
    return all;
}

using Answers = std::vector<const Judged*>;

// The answers that were judged right or wrong: to every quantity, or to some.
Answers answered(std::span<const Judged> judged, const std::set<std::string>& quantities = {}) {
    Answers all;
    for (const Judged& one : judged)
        if (one.vector->reject.empty() && (is_right(one.verdict) || is_wrong_value(one.verdict)) &&
            (quantities.empty() || quantities.contains(one.vector->question.quantity)))
            all.push_back(&one);
    return all;
}

// Wrong answers, and all that were asked for, by what they share; by name.
template <class Of>
std::vector<InCommon> counted(std::span<const Judged* const> wrong, const Answers& asked, const Of& properties_of) {
    std::map<std::string, InCommon> all;
    const auto count = [&](const auto& answers, std::size_t InCommon::*number) {
        for (const Judged* one : answers)
            for (const std::string& property : properties_of(*one->vector))
                ++(all.try_emplace(property, InCommon{property, 0, wrong.size(), 0, asked.size()}).first->second.*number);
    };
    count(asked, &InCommon::asked);
    count(wrong, &InCommon::wrong);
    std::vector<InCommon> list;
    for (const auto& [property, one] : all) list.push_back(one);
    return list;
}

std::size_t count_of(const auto& list, const auto& condition) {
    return static_cast<std::size_t>(std::ranges::count_if(list, condition));
}

bool larger_share_of_wrong(const InCommon& a, const InCommon& b) {
    return a.wrong * b.asked != b.wrong * a.asked ? a.wrong * b.asked > b.wrong * a.asked : a.wrong > b.wrong;
}

// Whether each number of an answer has so few decimal digits.
bool has_digits(const Judged& one, int digits) {
    return !one.given.numbers.empty() &&
           std::ranges::all_of(one.given.numbers, [&](double x) { return finite_number(number_in_digits(x, digits)) == x; });
}

bool is_too_small(const Judged& one) {
    return one.error && std::abs(one.given.numbers[one.worst]) < std::abs(one.vector->nearest[one.worst]);
}

// Properties of the answers: that they are all too small or too large, or have few digits, as all answers have then.
void add_of_answers(std::vector<InCommon>& found, std::span<const Judged* const> wrong, const Answers& asked) {
    const std::size_t numbers = count_of(wrong, [](const Judged* one) { return one->error.has_value(); });
    const std::size_t small = count_of(wrong, [](const Judged* one) { return is_too_small(*one); });
    if (numbers < wrong.size()) return;
    for (const auto& [told, count] : {std::pair("the answer is too small", small), {"the answer is too large", numbers - small}})
        if (count == numbers) found.push_back({told, count, count, count, count});
    constexpr int fewest = 3, most = 8;
    for (int digits = fewest; digits <= most; ++digits) {
        const std::size_t with = count_of(asked, [&](const Judged* one) { return has_digits(*one, digits); });
        if (share(with, asked.size()) < share_in_common) continue;
        found.push_back(
            {"the answer has no more than " + std::to_string(digits) + " digits", numbers, numbers, with, asked.size()});
        return;
    }
}

constexpr std::array<std::string_view, 19> links{"natural frequencies",
                                                 "R = r / r_n, (22)",
                                                 "shapes",
                                                 "v of one mass, (23)",
                                                 "u of one mass, (28)",
                                                 "g of one mass, (29)",
                                                 "V, (33)",
                                                 "U, (34)",
                                                 "G, (35)",
                                                 "H, (64)",
                                                 "S, (56), (57)",
                                                 "boundary",
                                                 "rest interval",
                                                 "initial values, (44), (45)",
                                                 "displacement, (46)",
                                                 "monoharmonic response, (52), (53)",
                                                 "amplitude",
                                                 "phase",
                                                 "motion and stops"};

} // namespace

std::vector<InCommon> chain_of(std::span<const Judged* const> wrong, std::span<const Judged> judged) {
    std::vector<InCommon> chain = counted(
        wrong, answered(judged), [](const Vector& v) { return std::array{std::string(links[place_in_chain(v.question)])}; });
    std::ranges::sort(chain, {}, [](const InCommon& link) { return std::ranges::find(links, link.property); });
    return chain;
}

std::vector<InCommon> properties_in_common(std::span<const Judged* const> wrong, std::span<const Judged> judged) {
    if (wrong.size() < least_wrong) return {};
    std::set<std::string> quantities;
    for (const Judged* one : wrong) quantities.insert(one->vector->question.quantity);
    const Answers asked = answered(judged, quantities);
    std::vector<InCommon> found = counted(wrong, asked, properties);
    std::erase_if(found, [](const InCommon& one) {
        return share(one.wrong, one.all_wrong) < share_in_common ||
               share(one.wrong, one.asked) < least_lift * share(one.all_wrong, one.all_asked);
    });
    std::stable_sort(found.begin(), found.end(), larger_share_of_wrong);
    if (found.size() > most_told) found.resize(most_told);
    std::erase_if(found, [&](const InCommon& one) { // what separates much worse than the first says nothing new
        return share(one.wrong, one.asked) < share_in_common * share(found.front().wrong, found.front().asked);
    });
    add_of_answers(found, wrong, asked);
    return found;
}

std::vector<InCommon> by_quantity(std::span<const Judged* const> wrong, std::span<const Judged> judged) {
    std::vector<InCommon> found =
        counted(wrong, answered(judged), [](const Vector& v) { return std::array{v.question.quantity}; });
    std::erase_if(found, [](const InCommon& one) { return one.wrong == 0; });
    std::ranges::stable_sort(found, std::greater(), &InCommon::wrong);
    return found;
}

} // namespace denhartog::conformance
