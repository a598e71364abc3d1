#include "conformance/chain.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace denhartog::conformance {
namespace {

constexpr std::array<std::string_view, 14> links{"frequencies",
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
                                                 "amplitude",
                                                 "phase",
                                                 "motion"};

} // namespace

std::size_t place_in_chain(const Question& q) {
    static const std::map<std::string_view, std::size_t> places{{"natural_frequency_ratios", 0},
                                                                {"modal_frequency_ratios", 0},
                                                                {"mode_shape_products", 1},
                                                                {"complex_response", 5},
                                                                {"first_damping_function", 6},
                                                                {"second_damping_function", 7},
                                                                {"H_j", 8},
                                                                {"S_j", 9},
                                                                {"beta_lim_exact", 10},
                                                                {"beta_lim_paper", 10},
                                                                {"beta_lim_approximate", 10},
                                                                {"beta_lim_sticking", 10},
                                                                {"beta_lim_high_frequency", 10},
                                                                {"regime", 10},
                                                                {"amplitude", 11},
                                                                {"amplitude_monoharmonic", 11},
                                                                {"phase", 12},
                                                                {"phase_monoharmonic", 12}};
    const auto found = places.find(q.quantity);
    const std::size_t place = found == places.end() ? 13 : found->second;
    const bool of_one_mass = q.mass_ratios.size() == 1 && place >= 5 && place <= 7;
    return of_one_mass ? place - 3 : place;
}

std::vector<Link> chain_of(std::span<const Judged* const> wrong, std::span<const Judged> judged) {
    std::array<Link, links.size()> all;
    for (std::size_t n = 0; n < links.size(); ++n) all[n].name = links[n];
    for (const Judged& one : judged)
        if (one.vector->reject.empty() && (is_right(one.verdict) || is_wrong_value(one.verdict)))
            ++all[place_in_chain(one.vector->question)].answered;
    for (const Judged* one : wrong) ++all[place_in_chain(one->vector->question)].wrong;
    std::vector<Link> answered;
    std::copy_if(all.begin(), all.end(), std::back_inserter(answered), [](const Link& link) { return link.answered > 0; });
    return answered;
}

} // namespace denhartog::conformance
