#include "denhartog/program/files.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "denhartog/number/errors.hpp"
#include "denhartog/program/exit_status.hpp"

namespace denhartog::program {
namespace {

namespace fs = std::filesystem;

std::string last_fault() { return errno != 0 ? std::strerror(errno) : "an input or output error"; }

std::string all_of(std::istream& in, const std::string& name) {
    errno = 0;
    std::string text(std::istreambuf_iterator<char>(in), {});
    if (in.bad() || errno != 0) throw InputError(name, "cannot be read (" + last_fault() + ")", "");
    return text;
}

void write(std::ostream& out, const std::string& text, const std::string& name) {
    errno = 0;
    out << text;
    out.flush();
    if (!out) throw InputError(name, "cannot be written (" + last_fault() + ")", "");
}

// Where a file is written before it takes its place; what is no regular file is written directly.
struct Target {
    std::string path;
    bool direct;
};

Target target_of(const std::string& path) {
    std::error_code fault;
    const fs::file_status status = fs::status(path, fault);
    const bool direct = fs::exists(status) && !fs::is_regular_file(status);
    return {direct ? path : path + ".part" + std::to_string(::getpid()), direct};
}

} // namespace

void report(const std::string& fault) {
    std::string line = fault;
    for (char& c : line)
        if (c == '\n' || c == '\r') c = ' ';
    std::cerr << "denhartog: " << line << '\n';
}

std::string read_input(const std::string& path) {
    if (path.empty() || path == "-") return all_of(std::cin, "standard input");
    std::error_code none;
    if (fs::is_directory(path, none)) throw InputError(path, "cannot be read (Is a directory)", "");
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError(path, "cannot be read (" + last_fault() + ")", "");
    return all_of(in, path);
}

void write_standard_output(const std::string& text) { write(std::cout, text, "standard output"); }

void check_writable(const std::string& path) {
    const Target target = target_of(path);
    std::error_code fault;
    errno = 0;
    const bool opened = std::ofstream(target.path, std::ios::binary | std::ios::app).is_open();
    if (!opened) throw InputError(path, "cannot be written (" + last_fault() + ")", "");
    if (!target.direct) fs::remove(target.path, fault);
}

void write_file(const std::string& path, const std::string& text) {
    std::error_code fault;
    const auto [target, direct] = target_of(path);
    errno = 0;
    std::ofstream out(target, std::ios::binary | std::ios::trunc);
    if (!out) throw InputError(path, "cannot be written (" + last_fault() + ")", "");
    try {
        write(out, text, path);
        out.close();
        if (!out) throw InputError(path, "cannot be written (" + last_fault() + ")", "");
        if (!direct) fs::rename(target, path);
    } catch (const fs::filesystem_error& e) {
        fs::remove(target, fault);
        throw InputError(path, "cannot be written (" + e.code().message() + ")", "");
    } catch (...) {
        if (!direct) fs::remove(target, fault);
        throw;
    }
}

} // namespace denhartog::program
