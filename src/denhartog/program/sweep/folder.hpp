/// @file
/// @brief The folder of a study: what `sweep plan` writes, and the other subcommands read.
///
/// study.json, plan.json, result.zarr (metadata and axes), parts/ (of reductions that several chunks have a part in), done/ (a
/// record a chunk), log/, and a script an engine. A chunk is done when its record is there: it is written last, and names the
/// files with their checksums. Every file appears under its name when it is whole and on the disk.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "denhartog/sweep/pieces.hpp"
#include "denhartog/sweep/plan.hpp"

namespace denhartog::program {

/// @brief A study with its folder.
struct StudyFolder {
    std::string path;        ///< the folder
    sweep::Plan plan;        ///< the plan
    std::string fingerprint; ///< of program and study: results of two of them are never put together
    /// @brief A file in it. @param name its name from the folder @return its path
    [[nodiscard]] std::string file(const std::string& name) const { return path + "/" + name; }
};

/// @brief The checksum of what results depend on. @param study the JSON text of a study @param commit of the program
/// @return SHA-256 of the program's version and commit and of the study
[[nodiscard]] std::string fingerprint_of(const std::string& study, const std::string& commit);

/// @brief Opens the folder of a study.
/// @param path    the folder
/// @param commit  the commit of the program
/// @return        the study
/// @throws        InputError where it is no such folder, or was planned by another program
[[nodiscard]] StudyFolder open_study(const std::string& path, const std::string& commit);

/// @brief What a chunk left behind.
struct Record {
    std::size_t chunk = 0;               ///< its number
    std::string fingerprint;             ///< of the program and the study
    std::array<std::size_t, 6> points{}; ///< points by their status
    double seconds = 0;                  ///< processor seconds that it took
    /// @brief A file that it wrote.
    struct File {
        std::string path;   ///< from the folder
        std::size_t bytes;  ///< its size
        std::string sha256; ///< its checksum
    };
    std::vector<File> files; ///< what it wrote
};

/// @brief Where the record of a chunk stands. @param study the study @param K the chunk @return the path
[[nodiscard]] std::string path_of_record(const StudyFolder& study, std::size_t K);

/// @brief A record as JSON. @param record the record @return its text
[[nodiscard]] std::string text_of(const Record& record);

/// @brief The record of a chunk. @param study the study @param K the chunk
/// @return the record; none where there is none, and one without files where it cannot be read
[[nodiscard]] std::optional<Record> record_of(const StudyFolder& study, std::size_t K);

/// @brief What is wrong with a chunk that has a record. @param study the study @param K the chunk @param record its record
/// @return in words; empty where its files are there as they were written, by this program for this study
[[nodiscard]] std::string fault_of(const StudyFolder& study, std::size_t K, const Record& record);

/// @brief Numbers in words. @param numbers ascending @return e.g. `0-3, 7`, at most a hundred characters
[[nodiscard]] std::string ranges_of(const std::vector<std::size_t>& numbers);

} // namespace denhartog::program
