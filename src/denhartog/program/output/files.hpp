// Files that are read and written whole, or not at all, and where those are that the program reads by default.
// Each function throws InputError where its file cannot be read or written.
#pragma once

#include <string>

namespace denhartog::program {

// The text of a file; of standard input where the path is empty or `-`.
[[nodiscard]] std::string read_input(const std::string& path);

// Writes to standard output and makes sure that it arrived.
void write_standard_output(const std::string& text);

// Writes a file: into a new file beside it, which takes its place when it is complete; an earlier file is left as it was where
// that fails. The new file has a name that cannot be guessed and is opened by nobody else. A symbolic link stays, and the file
// that it leads to is replaced. The permissions are those of the file that was there, else those of any new file. Interruptions
// wait until the file is whole. What is no regular file, such as a pipe, is written directly.
void write_file(const std::string& path, const std::string& text);

// Writes a file or, where the path is empty, to standard output.
void write_output(const std::string& path, const std::string& text);

// Makes sure that a file can be written, before a long computation; an earlier file is left as it is.
void check_writable(const std::string& path);

// The program that runs; `denhartog` where the system does not tell its path.
[[nodiscard]] std::string this_program();

// The certified vectors, the hand-written half of the ledger, and what the last derivation left (`ledger.json`, `derivation.json`):
// in the tree that the program was built from or, once installed, beside the program.
[[nodiscard]] std::string vectors_folder();
[[nodiscard]] std::string equations_file();
[[nodiscard]] std::string derivation_file(const std::string& name);

} // namespace denhartog::program
