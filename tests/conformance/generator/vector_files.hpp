/// @file
/// @brief The folder of the vectors: its files and its manifest.
#pragma once

#include <filesystem>
#include <map>
#include <set>

#include "tests/conformance/generator/certify.hpp"

namespace denhartog::conformance::generator {

/// @brief Version of the vectors' content: one higher whenever a vector is added, taken out or changed.
inline constexpr int content_version = 10;

/// @brief The files of a set of vectors, by name.
/// @param vectors  the vectors, in their order
/// @param schema   the text of schema.json, which is written by hand: the JSON schema (draft 2020-12) of a line of a vector file
/// @return         contents
[[nodiscard]] std::map<std::string, std::string> files_of(const std::vector<Vector>& vectors, const std::string& schema);

/// @brief What is wrong with the files of a folder: sizes and checksums that its manifest does not have, files that are missing.
/// @param folder  the folder
/// @return        a sentence a fault
[[nodiscard]] std::vector<std::string> manifest_faults(const std::filesystem::path& folder);

/// @brief What the files of a folder ask, scene by scene. A line needs nothing but a question, as the protocol has it; its group
/// is the name of its file.
/// @param folder  the folder
/// @return        the cases, file by file
[[nodiscard]] std::vector<Case> cases_of(const std::filesystem::path& folder);

/// @brief The vectors of all groups of a folder but some, as they stand in their lines.
/// @param folder  the folder
/// @param groups  the groups left out, whose lines need nothing but a question
/// @return        the vectors, file by file
[[nodiscard]] std::vector<Vector> stored_but(const std::filesystem::path& folder, const std::set<std::string>& groups);

/// @brief All vectors of a folder's questions, on as many threads as there are. Says on standard error how far it is.
/// @param folder  the folder
/// @param groups  the groups wanted; none for all
/// @return        the vectors with what was refused
[[nodiscard]] Certified certify_all(const std::filesystem::path& folder, const std::set<std::string>& groups);

/// @brief Computes some of a folder's vectors anew and compares them byte for byte.
/// @param folder  the folder
/// @param every   every how many
/// @param from    the first, from 0
/// @return        a sentence a difference
[[nodiscard]] std::vector<std::string> differences(const std::filesystem::path& folder, int every, int from);

/// @brief Contents of a file. @param file its path @return its bytes @throws InputError where it cannot be read
[[nodiscard]] std::string bytes_of(const std::filesystem::path& file);

} // namespace denhartog::conformance::generator
