/// @file
/// @brief The ledger's column "kernel": what a proof assistant has checked of each claim and each equation.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief The records of a check by the kernel, as far as they are there.
struct KernelRecord {
    nlohmann::json certificates = nlohmann::json::object(); ///< by claim: what was exported, or why nothing was
    nlohmann::json claims = nlohmann::json::object();       ///< by claim: what the kernel said of it
    nlohmann::json theorems = nlohmann::json::array();      ///< statements with proofs by hand: theorems, negations, definitions
    nlohmann::json by_equation = nlohmann::json::array(); ///< by equation: names of theorems and negations, and why there is none
    nlohmann::json theorems_checked = nlohmann::json::object(); ///< by name: what the kernel said of them
    bool ran = false;                                           ///< whether there is a record at all
};

/// @brief Reads the record of a check.
/// @param folder      with `certificates.json` and `kernel.json`, and `theorems.json` if theorems were checked; empty: not run
/// @param statements  the list of theorems by hand, `derivation/kernel/statements.json`, beside `equations.json`, which says of
///                    every equation which of them speak of it, or why none; need not be there
/// @return            the record
[[nodiscard]] KernelRecord read_kernel_record(const std::filesystem::path& folder, const std::filesystem::path& statements);

/// @brief Writes into each claim of the ledger, and into each equation, the key `kernel`.
///
/// Its `status` is `checked`; `not_exported`, with `reason`; `failed`, with `message`; or `not_run`. An equation is `failed` if
/// one of its claims or theorems is, `checked` if at least one claim or theorem on it is, and it has `theorems` and `negations`.
/// @param entries  the ledger
/// @param record   what the check left
/// @return         a sentence for each claim or theorem that failed
[[nodiscard]] std::vector<std::string> add_kernel(nlohmann::json& entries, const KernelRecord& record);

/// @brief The counts in a sentence, for the terminal and the report. @param entries the ledger with its keys @return the sentence
[[nodiscard]] std::string kernel_sentence(const nlohmann::json& entries);

} // namespace denhartog::derivation
