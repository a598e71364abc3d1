/// @file
/// @brief The audit as a table: for each equation how it was decided, the verdict, and what remains assumed.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief A row of the audit.
struct AuditRow {
    std::string equation;              ///< the number of the equation
    std::string kinds;                 ///< how many claims of which kind decide it; what it is where none does
    std::string printed;               ///< verdict as printed
    std::string shipped;               ///< verdict as shipped
    std::vector<std::string> premises; ///< the paper's assumptions that it rests on, by number, however far
    std::vector<std::string> domains;  ///< where the claims that prove it are made, each domain once
    std::string masses;                ///< for how many masses; empty where the number does not matter
    std::vector<std::string> argued;   ///< steps beside it that a person argued; they decide nothing
    bool typed = false;                ///< whether a person typed the formula that is shown as what holds
};

/// @brief The audit of a ledger.
///
/// Steps and observations decide no equation and are not counted; nor is a claim that says what another one has said. The
/// premises are the equations of the kind `assumption` that are reached by `rests_on`. The domain has the assumptions of the
/// claims, `derived` or `refinement`, on the form that is shipped, or on the printed form where none is.
/// @param entries  the ledger
/// @return         a row an equation, in the paper's order
[[nodiscard]] std::vector<AuditRow> audit_of(const nlohmann::json& entries);

/// @brief A sentence: what an equation still assumes. @param row its row @return text; `nothing` where nothing does
[[nodiscard]] std::string remaining(const AuditRow& row);

/// @brief The audit in a sentence of counts. @param rows the audit @return Markdown
[[nodiscard]] std::string audit_summary(const std::vector<AuditRow>& rows);

/// @brief The audit as a table. @param rows the audit @return Markdown
[[nodiscard]] std::string audit_markdown(const std::vector<AuditRow>& rows);

} // namespace denhartog::derivation
