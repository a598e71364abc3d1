/// @file
/// @brief What `sweep plan` writes, but for the numbers.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "denhartog/program/sweep/folder.hpp"

namespace denhartog::program {

/// @brief What the store says of itself. @param study the study @return its `.zattrs`
[[nodiscard]] nlohmann::ordered_json json_of_store(const StudyFolder& study);

/// @brief Writes the folder of a study.
/// @param text      the study's JSON text
/// @param path      the folder
/// @param commit    the commit of the program
/// @param estimate  what it will cost
/// @return          the study
/// @throws          InputError where the study breaks a rule, a file cannot be written, or another study stands there
StudyFolder write_folder(const std::string& text, const std::string& path, const std::string& commit,
                         const nlohmann::ordered_json& estimate);

} // namespace denhartog::program
