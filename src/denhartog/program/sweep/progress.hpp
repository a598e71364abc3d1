/// @file
/// @brief How far a study has come.
#pragma once

#include <optional>
#include <string>

#include "denhartog/program/sweep/folder.hpp"

namespace denhartog::program {

/// @brief A bar. @param done parts that are done @param all all parts @return e.g. `[#####.....]  50 %`
[[nodiscard]] std::string bar_of(std::size_t done, std::size_t all);

/// @brief What `sweep status` says, from the records alone: files are checked by `merge`.
/// @param study    the study
/// @param workers  where given, also how long so many workers would take, each given the next chunk when it is free
/// @return         chunks and points done, seconds, missing chunks, chunks of another program or study
[[nodiscard]] nlohmann::ordered_json status_of(const StudyFolder& study, std::optional<std::size_t> workers);

/// @brief The same for people. @param status from `status_of` @return lines
[[nodiscard]] std::string status_text(const nlohmann::ordered_json& status);

} // namespace denhartog::program
