/// @file
/// @brief An expression in the form that a reader wants: the paper's groups recognised, common factors collected.
///
/// GiNaC's expressions come out of linear systems, expanded and over one denominator. Here functions and roots become symbols,
/// the paper's groups \f$ d_i, q_i, w_i, [v_{di}\cos\phi_j] \f$ are put in by exact substitution, and the result is factored as a
/// whole or term by term. Of several such forms the one that is narrowest on the page is taken. None is trusted: the zero test
/// has to prove that the form, with the groups' meanings put back, equals the expression; what it does not prove is shown as
/// GiNaC made it.
#pragma once

#include <ginac/ginac.h>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief A group of the paper: a symbol that stands for an expression.
struct Group {
    GiNaC::ex symbol;       ///< printed in its place
    GiNaC::ex meaning;      ///< what it stands for
    std::string latex;      ///< LaTeX of the symbol
    std::string definition; ///< LaTeX of `symbol = meaning`
};

/// @brief The groups of one mode.
struct ModeGroups {
    GiNaC::ex R;                ///< frequency ratio of the mode
    GiNaC::ex zeta;             ///< its damping ratio
    Group w;                    ///< \f$ \sqrt{1-\zeta_i^2} \f$
    std::vector<Group> d;       ///< the free motion from displacement, (A.8), at tau and at pi
    std::vector<Group> q;       ///< the free motion from velocity, (A.8), at tau and at pi
    std::vector<Group> q_prime; ///< the rate of q, (A.9), at tau and at pi
    std::vector<GiNaC::ex> tau; ///< tau and pi
};

/// @brief The groups of the mode i and of the modes 1, 2, 3. @return one a mode
[[nodiscard]] const std::vector<ModeGroups>& groups_of_modes();

/// @brief The groups of all modes, and v cos(phi_j) and v sin(phi_j): the last two pairs, for symbols and for functions.
/// @return  all of them; each uses only groups before it
[[nodiscard]] const std::vector<Group>& groups();

/// @brief Sums in the shape that the paper gives them: of each mode the denominator of (23), and the square of w.
/// @return  the expanded sum and its shape
[[nodiscard]] const std::vector<std::pair<GiNaC::ex, GiNaC::ex>>& paper_shapes();

/// @brief An expression with the groups' meanings put back. @param form an expression in groups @return the same without
[[nodiscard]] GiNaC::ex without_groups(const GiNaC::ex& form);

/// @brief The roots of the groups by their names, sums in the paper's shapes; nothing else is touched.
/// @param e  an expression
/// @return   the same in groups
[[nodiscard]] GiNaC::ex with_names(const GiNaC::ex& e);

/// @brief Whether a form in groups equals an expression, by the zero test. @param form the form @param e the expression
/// @return  true where it is proved
[[nodiscard]] bool stands_for(const GiNaC::ex& form, const GiNaC::ex& e);

/// @brief The narrowest proved form of an expression.
/// @param e  the expression
/// @return   a form in groups that `stands_for` it; the expression itself where no other is proved
[[nodiscard]] GiNaC::ex readable(const GiNaC::ex& e);

/// @brief Definitions of the groups that occur in LaTeX. @param latex LaTeX of some steps
/// @return  the definitions; empty without groups
[[nodiscard]] std::string legend_of(const std::string& latex);

} // namespace denhartog::derivation
