/// @file
/// @brief The findings of the figures, read from the records that their programs write, for the ledger and for the READMEs.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief The records of the figures in a folder, those of the paper's figures first, each as its program wrote it.
/// @param folder  where the figures were drawn
/// @return        the records by name; empty where there are none
/// @throws        std::runtime_error where a record cannot be read
[[nodiscard]] std::vector<nlohmann::json> figure_records(const std::filesystem::path& folder);

/// @brief Writes into each entry of the ledger the names of the figures that show its equation.
/// @param entries  the ledger
/// @param records  records of the figures
/// @return         a sentence for each figure that names an equation the ledger does not have
[[nodiscard]] std::vector<std::string> add_figures(nlohmann::json& entries, const std::vector<nlohmann::json>& records);

/// @brief The figures in a table: name, markers against lines, statements borne out. @param records the records @return Markdown
[[nodiscard]] std::string figures_table(const std::vector<nlohmann::json>& records);

/// @brief All that the records say, a section a figure. @param records the records @return Markdown
[[nodiscard]] std::string figures_markdown(const std::vector<nlohmann::json>& records);

} // namespace denhartog::derivation
