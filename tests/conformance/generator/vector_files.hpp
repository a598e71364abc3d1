/// @file
/// @brief Certified vectors: what a case gives by two routes, and the files of a folder.
#pragma once

#include <filesystem>
#include <map>
#include <set>

#include "conformance/vector.hpp"

namespace denhartog::conformance::generator {

/// @brief Questions about one scene, on lines one after the other. Of each vector the question, group, tier, flags and the rule that
/// is broken are read. The first tells whether the scene breaks a rule.
using Case = std::vector<Vector>;

/// @brief A question that no vector came of.
struct Refusal {
    std::string id;  ///< its id
    std::string why; ///< a sentence
};

/// @brief What came of a case.
struct Certified {
    std::vector<Vector> vectors;          ///< in the order of the questions
    std::vector<Refusal> refusals;        ///< the others
    std::array<int, 2> least{1000, 1000}; ///< least digits on which the routes agree, not cut off at what vectors state
};

/// @brief Least digits that a vector has in the computation in 100 digits.
inline constexpr int least_digits = 40;

/// @brief Computes the vectors of a case. The tier that a question has is the easiest that its vector may have. `only` has the
/// ids that are wanted; none stands for all.
[[nodiscard]] Certified certify(const Case& c, const std::set<std::string>& only = {});

/// @brief Names of the mistakes that a vector catches: their answers are wrong by more than four times what is inaccurate. Names
/// ascend.
[[nodiscard]] std::vector<std::string> catches_of(const Vector& v);

/// @brief Version of the vectors' content: one higher whenever a vector is added, taken out or changed.
inline constexpr int content_version = 10;

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
