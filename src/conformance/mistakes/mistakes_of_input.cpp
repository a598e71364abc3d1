#include <algorithm>
#include <cmath>

#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number.hpp"

namespace denhartog::conformance {
namespace {

using Change = std::function<void(ProtocolQuestion&)>;

MistakeDefinition reading(std::string name, std::string equation, std::string told, std::string look_at, Change change) {
    return {{std::move(name), std::move(equation), false, std::move(told), std::move(look_at)},
            [change = std::move(change)](const ProtocolQuestion& q) {
                ProtocolQuestion other = q;
                change(other);
                return plain_answer(other);
            }};
}

void invert(std::vector<double>& ratios) {
    for (double& x : ratios) x = 1 / x;
}

double lowest_natural_frequency_ratio(const ProtocolQuestion& q) { return plain_modes(q, {}).r_n.front(); }

std::vector<MistakeDefinition> of_the_system() {
    return {
        reading("mass-ratios-ignored", "9", "The mass ratios of (9) are taken as 1: all masses are the first one.",
                "where mass_ratios enter the mass matrix; test with masses that differ",
                [](ProtocolQuestion& q) { std::fill(q.mass_ratios.begin(), q.mass_ratios.end(), 1); }),
        reading("mass-ratios-inverted", "9", "The mass ratios are taken as m_1 / m_i; (9) has m_i / m_1.",
                "where mass_ratios enter the mass matrix: a ratio above 1 is a heavier mass",
                [](ProtocolQuestion& q) { invert(q.mass_ratios); }),
        reading("stiffness-ratios-ignored", "73", "The stiffness ratios of (73) are taken as 1: all springs are the first one.",
                "where stiffness_ratios enter the stiffness matrix; test with springs that differ",
                [](ProtocolQuestion& q) { std::fill(q.stiffness_ratios.begin(), q.stiffness_ratios.end(), 1); }),
        reading("stiffness-ratios-inverted", "73", "The stiffness ratios are taken as k_1 / k_i; (73) has k_i / k_1.",
                "where stiffness_ratios enter the stiffness matrix: a ratio above 1 is a stiffer spring",
                [](ProtocolQuestion& q) { invert(q.stiffness_ratios); }),
        reading("damping-of-first-mode", "18", "The damping ratio of the first mode is used for every mode; (18) has one a mode.",
                "the index of the damping ratio in the loops over modes",
                [](ProtocolQuestion& q) {
                    if (!q.damping_ratios.empty())
                        std::fill(q.damping_ratios.begin(), q.damping_ratios.end(), q.damping_ratios.front());
                }),
        reading("damping-ignored", "18", "Viscous damping is left out: every zeta_i of (18) is taken as 0.",
                "whether the damping ratios reach (23), (28) and (29)",
                [](ProtocolQuestion& q) {
                    for (auto* list : {&q.damping_ratios, &q.damping_matrix}) std::fill(list->begin(), list->end(), 0);
                }),
        reading("damping-halved", "19",
                "Viscous damping is half of what it should be: the 2 of 2 zeta_i Omega_i in (19) is missing.",
                "the factor 2 where modal damping is made from damping ratios; a loss factor is twice a damping ratio",
                [](ProtocolQuestion& q) {
                    for (auto* list : {&q.damping_ratios, &q.damping_matrix})
                        for (double& x : *list) x /= 2;
                }),
        reading("damping-as-logarithmic-decrement", "18",
                "The damping ratios are taken for logarithmic decrements: zeta_i of (18) is divided by 2 pi.",
                "what is made of damping_ratios: they are zeta_i, not delta_i = 2 pi zeta_i / sqrt(1 - zeta_i^2)",
                [](ProtocolQuestion& q) {
                    for (double& x : q.damping_ratios) x /= 2 * pi<double>();
                }),
        reading("damping-ratios-reversed", "18",
                "The damping ratios are given to the modes by descending natural frequency; the list goes by ascending.",
                "the order in which the eigenvalue routine returns the modes; sort them before damping ratios are attached",
                [](ProtocolQuestion& q) { std::reverse(q.damping_ratios.begin(), q.damping_ratios.end()); }),
    };
}

std::vector<MistakeDefinition> of_places() {
    return {
        reading("contact-and-load-swapped", "4", "The mass in contact j and the loaded mass l are exchanged.",
                "which row of the modal matrix multiplies the friction force and which one the load",
                [](ProtocolQuestion& q) { std::swap(q.contact, q.load); }),
        reading("4-as-printed", "4",
                "Load and friction act on one mass, as (4) and (16) print it: the load stands on the mass in contact.",
                "the unit vectors of (4) or the rows of the modal matrix in (16): friction has e_j, the load e_l",
                [](ProtocolQuestion& q) { q.load = q.contact; }),
        reading("friction-on-loaded-mass", "4", "Friction acts on the loaded mass l in place of the mass in contact j.",
                "the row of the modal matrix that multiplies the friction force",
                [](ProtocolQuestion& q) { q.contact = q.load; }),
        reading("contact-counted-from-0", "4", "The mass in contact is counted from 0: contact is taken as one mass further.",
                "the index made from contact: the protocol counts masses from 1",
                [](ProtocolQuestion& q) {
                    ++q.contact;
                    if (q.contact_with != 0) ++q.contact_with;
                }),
        reading("load-counted-from-0", "4", "The loaded mass is counted from 0: load is taken as one mass further.",
                "the index made from load: the protocol counts masses from 1", [](ProtocolQuestion& q) { ++q.load; }),
        reading("mass-counted-from-0", "", "The mass asked about is counted from 0: mass is taken as one mass further.",
                "the index made from mass: the protocol counts masses from 1", [](ProtocolQuestion& q) { ++q.mass; }),
    };
}

std::vector<MistakeDefinition> of_the_point() {
    return {
        reading("mu-ignored", "3", "Static friction is taken equal to kinetic friction: mu of (3) is taken as 1.",
                "the conditions (54)b, (67) and (74), which have mu beta where the sliding motion has beta",
                [](ProtocolQuestion& q) { q.mu = 1; }),
        reading("mu-squared", "3", "mu is squared where (3), (67) and (74) have mu.",
                "every place where mu is multiplied by beta", [](ProtocolQuestion& q) { q.mu *= q.mu; }),
        reading("static-friction-while-sliding", "3",
                "The contact slides under static friction mu beta; it slides under kinetic friction beta.",
                "the friction force while the contact moves: beta without mu", [](ProtocolQuestion& q) { q.beta *= q.mu; }),
        reading("beta-as-static-friction", "11",
                "beta is taken as static friction over the load, so that kinetic friction is beta / mu.",
                "the meaning of beta: (11) has kinetic friction F; static friction is mu times that",
                [](ProtocolQuestion& q) { q.beta /= q.mu; }),
        reading("friction-by-effective-value", "11", "beta is taken for an effective value: friction is sqrt(2) times as large.",
                "the meaning of beta: (11) has the friction force itself over the amplitude of the load",
                [](ProtocolQuestion& q) { q.beta *= std::sqrt(2.0); }),
        reading("friction-by-first-harmonic", "11",
                "Friction is 4 / pi times as large: the first harmonic of a square wave is taken for its height.",
                "the meaning of beta: (11) has the friction force itself over the amplitude of the load",
                [](ProtocolQuestion& q) { q.beta *= 4 / pi<double>(); }),
        reading("r-over-first-natural-frequency", "10",
                "r is taken as omega over the first natural frequency; (10) has omega sqrt(m_1 / k_1).",
                "the definition of r: no eigenvalue is in it",
                [](ProtocolQuestion& q) { q.r *= lowest_natural_frequency_ratio(q); }),
        reading("r-not-squared", "8", "The mass matrix has gamma_i r where (8) has gamma_i r^2.",
                "the power of r in the non-dimensional mass matrix", [](ProtocolQuestion& q) { q.r = std::sqrt(q.r); }),
        reading("r-inverted", "10", "r is taken as the natural frequency over that of the load; (10) has it the other way.",
                "the definition of r, and of R_i in (22)", [](ProtocolQuestion& q) { q.r = 1 / q.r; }),
        reading("friction-sign", "2", "Friction drives the contact: the sign of (2) is the other one.",
                "the sign of the friction force: against the velocity", [](ProtocolQuestion& q) { q.beta = -q.beta; }),
    };
}

} // namespace

std::vector<MistakeDefinition> mistakes_of_input() {
    std::vector<MistakeDefinition> all = of_the_system();
    for (const auto& part : {of_places(), of_the_point()}) all.insert(all.end(), part.begin(), part.end());
    return all;
}

} // namespace denhartog::conformance
