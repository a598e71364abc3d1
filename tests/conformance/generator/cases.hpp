/// @file
/// @brief What the vectors ask about: scenes with the questions about each, in a fixed order.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "conformance/question.hpp"
#include "denhartog/sliding/boundary.hpp"

namespace denhartog::conformance::generator {

/// @brief How the friction ratio of a scene is found.
enum class Friction : std::uint8_t {
    given,      ///< it stands in the scene
    of_limit,   ///< a part of beta_lim, Eq. (69)
    between,    ///< a part of the way from beta_lim to the boundary of permanent sticking
    of_sticking ///< so many times the boundary of permanent sticking
};

/// @brief A scene and what is asked about it.
struct Case {
    std::string group = {};                   ///< the group: name of the file
    std::string tier = "must";                ///< the easiest tier that its vectors may have
    ProtocolQuestion scene = {};              ///< the scene; the rest of the question is overwritten
    Friction friction = Friction::given;      ///< how beta is found
    double part = 0;                          ///< of what `friction` says
    int bits = 10;                            ///< binary digits that beta is rounded to
    std::vector<ProtocolQuestion> asked = {}; ///< what is asked: quantity, mass, tau, samples
    std::vector<std::string> flags = {};      ///< what the scene has besides what can be seen from its numbers
    std::string reject = {};                  ///< the rule it breaks; empty where it breaks none
    int first_number = 0;                     ///< number of its first question within the group
    bool withdrawn = false;                   ///< whether it is no longer asked; its ids are not used again
};

/// @brief Numbers that are the same everywhere: SplitMix64.
class Draw {
public:
    /// @param seed any number
    explicit Draw(std::uint64_t seed) : state_(seed) {}
    /// @brief An integer. @param from the smallest @param to the largest @return one of them
    int integer(int from, int to);
    /// @brief A binary fraction. @param from the smallest @param to the largest @param parts parts of a unit
    /// @return a multiple of 1 / parts
    double fraction(double from, double to, int parts);

private:
    std::uint64_t state_;
};

/// @brief A chain with unequal masses, springs and damping ratios, contact and load anywhere.
/// @param draw  where its numbers come from
/// @param N     number of masses
/// @param place 0: contact before load, 1: both on one mass, 2: contact after load; one mass has but one place
/// @return      the scene, with r in [1/4, 3] and mu 1 in two of three
[[nodiscard]] ProtocolQuestion drawn_scene(Draw& draw, int N, int place);

/// @brief What is asked about a mass. @param quantity its name @param mass k, from 1; 0 for none @param tau an instant
/// @param samples number of instants @return the question without a scene
[[nodiscard]] ProtocolQuestion ask(const std::string& quantity, int mass = 0, double tau = 0, int samples = 0);

/// @brief Cases of the groups `modes` and `functions`. @return the cases
[[nodiscard]] std::vector<Case> cases_of_modes();
/// @brief Cases of the groups `contact`, `motion` and `masses`. @return the cases
[[nodiscard]] std::vector<Case> cases_of_sliding();
/// @brief Cases of the groups `boundary` and `limits`. @return the cases
[[nodiscard]] std::vector<Case> cases_of_limits();
/// @brief Cases of the groups `stick-slip`, `stuck` and `solver`. @return the cases
[[nodiscard]] std::vector<Case> cases_of_sticking();
/// @brief Cases of the group `stress`. @return the cases
[[nodiscard]] std::vector<Case> cases_of_stress();
/// @brief Cases of the group `reject`. @return the cases
[[nodiscard]] std::vector<Case> cases_of_rejection();
/// @brief Cases of the groups that start with `systems-`: beyond the paper. @return the cases
[[nodiscard]] std::vector<Case> cases_of_systems();
/// @brief All cases, numbered. @return the cases
[[nodiscard]] std::vector<Case> all_cases();

} // namespace denhartog::conformance::generator
