/// @file
/// @brief Reading input and writing output whole, or not at all.
#pragma once

#include <string>

namespace denhartog::program {

/// @brief The text of a file or of standard input.
/// @param path  a path; empty or `-` for standard input
/// @return      the whole text
/// @throws      InputError where it cannot be read
[[nodiscard]] std::string read_input(const std::string& path);

/// @brief Writes to standard output and makes sure that it arrived.
/// @param text  what to write
/// @throws      InputError where it cannot be written
void write_standard_output(const std::string& text);

/// @brief Writes a file: into a new file beside it, which takes its place when it is complete.
///
/// The new file has a name that cannot be guessed and is opened by nobody else. A symbolic link stays, and the file that it leads
/// to is replaced. The permissions are those of the file that was there, else those of any new file. Interruptions wait until the
/// file is whole. What is no regular file, such as a pipe, is written directly.
/// @param path  the file
/// @param text  its content
/// @throws      InputError where it cannot be written; an earlier file is then left as it was
void write_file(const std::string& path, const std::string& text);

/// @brief Makes sure that a file can be written, before a long computation; an earlier file is left as it is.
/// @param path  the file
/// @throws      InputError where it cannot be written
void check_writable(const std::string& path);

} // namespace denhartog::program
