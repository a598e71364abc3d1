#include "conformance/diagnosis/explanations.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace denhartog::conformance {
namespace {

constexpr std::array<std::string_view, 15> links{"natural frequencies",
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
                                                 "amplitude",
                                                 "phase",
                                                 "motion"};

} // namespace

std::size_t place_in_chain(const ProtocolQuestion& q) {
    static const std::map<std::string_view, std::size_t> places{{"natural_frequency_ratios", 0},
                                                                {"modal_frequency_ratios", 1},
                                                                {"mode_shape_products", 2},
                                                                {"complex_response", 6},
                                                                {"first_damping_function", 7},
                                                                {"second_damping_function", 8},
                                                                {"H_j", 9},
                                                                {"S_j", 10},
                                                                {"beta_lim_exact", 11},
                                                                {"beta_lim_paper", 11},
                                                                {"beta_lim_approximate", 11},
                                                                {"beta_lim_sticking", 11},
                                                                {"beta_lim_high_frequency", 11},
                                                                {"regime", 11},
                                                                {"amplitude", 12},
                                                                {"amplitude_monoharmonic", 12},
                                                                {"phase", 13},
                                                                {"phase_monoharmonic", 13}};
    const auto found = places.find(q.quantity);
    const std::size_t place = found == places.end() ? 14 : found->second;
    const bool of_one_mass = q.mass_ratios.size() == 1 && place >= 6 && place <= 8;
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
