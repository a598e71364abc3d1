/// @file
/// @brief The folder of the vectors: its files and its manifest.
#pragma once

#include <filesystem>
#include <map>
#include <set>

#include "tests/conformance/generator/certify.hpp"

namespace denhartog::conformance::generator {

/// @brief Version of the vectors' content: one higher whenever a vector is added, taken out or changed.
inline constexpr int content_version = 9;

/// @brief The files of a set of vectors, by name. `schema` is the text of schema.json, which is written by hand: the JSON schema
/// (draft 2020-12) of a line of a vector file.
[[nodiscard]] std::map<std::string, std::string> files_of(const std::vector<Vector>& vectors, const std::string& schema);

/// @brief What is wrong with the files of a folder: sizes and checksums that its manifest does not have, files that are missing.
/// A sentence a fault.
[[nodiscard]] std::vector<std::string> manifest_faults(const std::filesystem::path& folder);

/// @brief What the files of a folder ask, scene by scene. A line needs nothing but a question, as the protocol has it; its group
/// is the name of its file. They come file by file.
[[nodiscard]] std::vector<Case> cases_of(const std::filesystem::path& folder);

/// @brief The vectors of all groups of a folder but some, as they stand in their lines. The lines of the groups left out need
/// nothing but a question.
[[nodiscard]] std::vector<Vector> stored_but(const std::filesystem::path& folder, const std::set<std::string>& groups);

/// @brief All vectors of a folder's questions, on as many threads as there are. Says on standard error how far it is. No groups
/// stand for all. Has what was refused, too.
[[nodiscard]] Certified certify_all(const std::filesystem::path& folder, const std::set<std::string>& groups);

/// @brief Computes some of a folder's vectors anew and compares them byte for byte. It is every so manieth from one on, counted
/// from 0. A sentence a difference.
[[nodiscard]] std::vector<std::string> differences(const std::filesystem::path& folder, int every, int from);

/// @brief Contents of a file. @param file its path @return its bytes @throws InputError where it cannot be read
[[nodiscard]] std::string bytes_of(const std::filesystem::path& file);

} // namespace denhartog::conformance::generator
