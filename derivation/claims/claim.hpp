/// @file
/// @brief A claim: what an equation says, what the derivation makes of it, and the grounds for a verdict.
///
/// The kernel of a claim is a formula template instantiated with symbols, or an equation as printed. The derived side never
/// contains the kernel that it checks. Claims register themselves.
#pragma once

#include <functional>
#include <map>
#include <source_location>
#include <string>
#include <vector>

#include "derivation/algebra/symbolic.hpp"
#include "derivation/algebra/zero_test.hpp"
#include "derivation/claims/threshold.hpp"
#include "derivation/selections/stand_ins.hpp"

namespace denhartog::derivation {

/// @brief One line of a derivation, as text and as LaTeX.
struct Step {
    std::string text;  ///< what is done; formulas in it stand between dollar signs
    std::string latex; ///< what comes out; may be empty
};

/// @brief The subject of a claim.
enum class Role {
    both,       ///< the equation as printed, which is also what is shipped
    printed,    ///< the equation as printed, where something else is shipped
    shipped,    ///< what is shipped, where it is not the equation as printed
    step,       ///< a statement that the derivation needs
    observation ///< what the paper's text says it has observed; may turn out either way
};

/// @brief The kind of departure of a printed equation from the one that holds.
enum class Departure {
    none,      ///< it does not
    scan,      ///< a slip of the text at hand
    misprint,  ///< the paper's own other equations contradict it
    substance, ///< a claim or a bound that does not hold
    convention ///< holds with a reading that the paper leaves unsaid
};

/// @brief The outcome of a claim that is decided by other means than the zero test alone.
struct Outcome {
    Verdict verdict = Verdict::unknown;                       ///< the verdict
    std::vector<std::pair<std::string, std::string>> witness; ///< names and values
    std::vector<Step> steps;                                  ///< the argument, or what was searched
    bool argued = false;                                      ///< a step of it is an argument that a person gave
    std::string why_no_twin = {};                             ///< of a check that refutes no altered statement
    std::vector<Threshold> thresholds = {};                   ///< numbers that vague words were taken to be
};

/// @brief Values of a kernel, component by component.
using Values = std::vector<Symbolic>;

/// @brief A claim.
struct Claim {
    std::string id = {};                        ///< unique name, e.g. `A.7/velocity`
    std::vector<std::string> equations = {};    ///< equations it decides, e.g. `A.7`
    std::vector<std::string> by_component = {}; ///< the equation that each component decides; empty: all of them decide each
    Role role = Role::both;                     ///< what it speaks of
    std::string title = {};                     ///< one sentence
    std::vector<std::string> assumptions = {};  ///< under which it holds
    std::function<Values()> kernel = {};        ///< the formula under test
    std::function<std::vector<GiNaC::ex>()> derived = {}; ///< what the derivation made, component by component
    std::function<Outcome()> check = {};                  ///< in place of kernel and derived
    Departure departure = Departure::none;                ///< for Role::printed and Role::both
    std::string correction = {};                          ///< LaTeX of what holds instead, written by a person
    std::vector<std::string> correction_left = {};        ///< instead: left sides; the run prints the derived side next to them
    std::vector<std::string> refines = {};                ///< equations whose formulas the derived side calls, other than its own
    bool approximation = false;                           ///< proved means: the order of the error is proved
    bool special_case = false;    ///< the kernel at special values, where some of its operations do not matter
    bool slow = false;            ///< a reduction takes seconds: values come first for the twins of operations
    std::vector<Step> steps = {}; ///< how the derived side was made
};

/// @brief All claims, in the order of their equations.
/// @return the registered claims, in the order of their first equations: those named after it before others
[[nodiscard]] const std::vector<Claim>& claims();

/// @brief Registers claims when constructed at namespace scope.
struct Register {
    /// @param made   makes the claims; called once, before the first use of `claims`
    /// @param where  the file that makes them
    explicit Register(std::function<std::vector<Claim>()> made, std::source_location where = std::source_location::current());
};

/// @brief The verdict on a claim.
struct Result {
    Verdict verdict = Verdict::unknown;                       ///< the worst over its components
    std::string kind;                                         ///< how it bears on its equations, by `kind_of`
    std::map<std::string, Verdict> by_equation;               ///< of each equation, where the components are told apart
    std::string correction;                                   ///< printed by the run from the derived side; empty where it is not
    std::string fingerprint;                                  ///< both sides' values, and the kernel's operations
    Decision decision;                                        ///< of the component that decided
    std::vector<std::pair<std::string, std::string>> witness; ///< names and values of the refuting point
    std::vector<Step> steps;                                  ///< derivation, kernel and outcome
    double milliseconds = 0;                                  ///< time taken
    std::string why_no_twin;                                  ///< the reason that the check gives
    long altered = 0;                                         ///< altered statements that a check of its own has refuted
    std::vector<Threshold> thresholds;                        ///< numbers that vague words of an observation were taken to be
};

/// @brief Counts the altered statements that the check of a claim has refuted so far: twins of what it proves. @return the count
[[nodiscard]] long& altered_statements_refuted();

/// @brief Decides one component of a claim. @param kernel the formula under test @param derived what it has to be
/// @param real  roots in the derived side, real wherever the claim is made @return the decision
[[nodiscard]] Decision decide_component(const Symbolic& kernel, const GiNaC::ex& derived, const std::vector<GiNaC::ex>& real);

/// @brief Whether values at sample points refute a component, without the reduction.
/// @param kernel   what the kernel gives @param derived what it ought to equal
/// @param real     roots that are real wherever the statement is made
/// @return         true where they differ
[[nodiscard]] bool component_differs(const Symbolic& kernel, const GiNaC::ex& derived, const std::vector<GiNaC::ex>& real = {});

/// @brief Decides a claim.
/// @param claim  the claim
/// @return       the result
[[nodiscard]] Result decide(const Claim& claim);

/// @brief The verdicts on the mutated twins of a claim, counted.
struct MutantCount {
    long refuted = 0;               ///< not equal, with a witness
    long without_value = 0;         ///< the mutant is not an expression at all (division by zero)
    long idle = 0;                  ///< equal in a special case, where the operation meets a zero
    long unknown = 0;               ///< neither proved nor refuted
    long proved = 0;                ///< wrongly proved: must be 0
    std::vector<std::string> holes; ///< which were proved or unknown
};

/// @brief Refutes each mutated twin of a claim.
///
/// A twin has one operation of the kernel replaced or a term dropped, two of its symbols exchanged (the contact's mode shapes for
/// those of the load, u for g, the mass k for j), or a mode left out: the difference of each is reduced, and must not come to zero.
/// Further twins have the derived side altered, one added, the sign changed, doubled, a term dropped: where values refute these,
/// nothing is reduced. In a slow claim and in a special case, often a whole system, values come first for operations as well; in a
/// special case an operation may meet a zero, and a twin that is proved is counted as idle.
/// @param claim  a claim whose kernel is proved
/// @return       the counts
[[nodiscard]] MutantCount mutate(const Claim& claim);

} // namespace denhartog::derivation
