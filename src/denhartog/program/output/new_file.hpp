/// @file
/// @brief A new file that takes its place when it is whole; `write_file` is made of it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace denhartog::program {

/// @brief A new file beside the one whose place it takes, under a name that nobody can guess; gone again unless it took that
/// place.
class NewFile {
public:
    /// @param name  the file whose place it will take @throws InputError where none can be made there
    explicit NewFile(const std::string& name);
    ~NewFile();
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    /// @brief Adds to it. @param text what to add @throws InputError where it cannot be written
    void write(std::string_view text) const;
    /// @brief Waits until its content is on the disk. @throws InputError where it does not get there
    void flush() const;
    /// @brief Takes the place, with the permissions of the file that was there. @throws InputError where it cannot
    void take_place();
    /// @brief Waits until the folder has its name on the disk, as far as the folder can be opened.
    void flush_folder() const;

private:
    std::string name;
    std::filesystem::path target;
    int folder = -1, file = -1;
    std::string own_name;
};

/// @brief How the name of such a file begins: what is left of them belonged to a program that was killed.
inline constexpr std::string_view new_file_begins = ".denhartog-";
/// @brief How it ends.
inline constexpr std::string_view new_file_ends = ".part";

/// @brief Writes a file as `write_file` does, and makes sure that it is on the disk before anything after it.
/// @param path  the file
/// @param text  its content
/// @throws      InputError where it cannot be written; an earlier file is then left as it was
void write_file_to_disk(const std::string& path, const std::string& text);

} // namespace denhartog::program
