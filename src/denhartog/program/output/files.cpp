// Files read and written whole or not at all: a result is written beside the file that it replaces and takes its name at the end,
// and no signal interrupts that. Read `read_input` and `write_file`.
#include "denhartog/program/output/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <random>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/program/exit_status.hpp"

namespace denhartog::program {
namespace {

namespace fs = std::filesystem;

// The longest line on standard error.
constexpr std::size_t longest_report = 1500;

// The longest input: it is held in memory as a whole.
constexpr std::size_t most_bytes = std::size_t(1) << 30;

std::string last_fault() { return errno != 0 ? std::strerror(errno) : "an input or output error"; }

[[noreturn]] void cannot_be_read(const std::string& name, const std::string& why) {
    throw InputError(name, "cannot be read (" + why + ")", "");
}

[[noreturn]] void cannot_be_written(const std::string& name, const std::string& why) {
    throw InputError(name, "cannot be written (" + why + ")", "");
}

std::string all_of(std::FILE* in, const std::string& name) {
    std::string text;
    std::array<char, 65536> piece;
    errno = 0;
    while (const std::size_t size = std::fread(piece.data(), 1, piece.size(), in)) {
        text.append(piece.data(), size);
        if (text.size() > most_bytes)
            throw InputError(name, "must have at most " + std::to_string(most_bytes) + " bytes", "more");
    }
    if (std::ferror(in) != 0) cannot_be_read(name, last_fault());
    return text;
}

void write(std::ostream& out, const std::string& text, const std::string& name) {
    errno = 0;
    out << text;
    out.flush();
    if (!out) cannot_be_written(name, last_fault());
}

// The file that a path leads to through all symbolic links, whether it is there or not.
fs::path followed(const std::string& name) {
    constexpr int most_links = 40;
    fs::path path = name;
    std::error_code fault;
    for (int n = 0; fs::is_symlink(fs::symlink_status(path, fault)); ++n) {
        if (n == most_links) cannot_be_written(name, std::strerror(ELOOP));
        const fs::path to = fs::read_symlink(path, fault);
        if (fault) cannot_be_written(name, fault.message());
        path = to.is_absolute() ? to : path.parent_path() / to;
    }
    return path;
}

// No interruption between the first byte and the last: it comes when the file is whole, or gone.
class InterruptionsHeld {
public:
    InterruptionsHeld() {
        sigset_t held;
        ::sigemptyset(&held);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::sigaddset(&held, signal);
        ::pthread_sigmask(SIG_BLOCK, &held, &before);
    }
    ~InterruptionsHeld() { ::pthread_sigmask(SIG_SETMASK, &before, nullptr); }
    InterruptionsHeld(const InterruptionsHeld&) = delete;
    InterruptionsHeld& operator=(const InterruptionsHeld&) = delete;

private:
    sigset_t before{};
};

// A pipe, a terminal and the like: no file can take its place.
bool is_no_file(const std::string& path) {
    std::error_code fault;
    const fs::file_status status = fs::status(path, fault);
    if (fs::is_directory(status)) cannot_be_written(path, std::strerror(EISDIR));
    return fs::exists(status) && !fs::is_regular_file(status);
}

// A new file beside the one whose place it takes when it is whole, under a name that nobody can guess; gone again unless it took
// that place.
class NewFile {
public:
    explicit NewFile(const std::string& name_) : name(name_), target(followed(name_)) {
        std::random_device random;
        do {
            char text[40];
            std::snprintf(text, sizeof text, ".denhartog-%08x%08x.part", random(), random());
            own_path = target.parent_path() / text;
            file = ::open(own_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        } while (file < 0 && errno == EEXIST);
        if (file < 0) cannot_be_written(name, last_fault());
    }
    ~NewFile() {
        if (file >= 0) ::close(file);
        if (!own_path.empty()) ::unlink(own_path.c_str());
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    void write(std::string_view text) const {
        while (!text.empty()) {
            const ssize_t size = ::write(file, text.data(), text.size());
            if (size < 0 && errno != EINTR) cannot_be_written(name, last_fault());
            text.remove_prefix(size < 0 ? 0 : static_cast<std::size_t>(size));
        }
    }
    // With the permissions of the file that was there.
    void take_place() {
        struct stat earlier {};
        const bool there = ::lstat(target.c_str(), &earlier) == 0;
        if (there && ::fchmod(file, earlier.st_mode & 0777U) != 0) cannot_be_written(name, last_fault());
        const int closed = ::close(file);
        file = -1;
        if (closed != 0 || ::rename(own_path.c_str(), target.c_str()) != 0) cannot_be_written(name, last_fault());
        own_path.clear();
    }

private:
    std::string name;
    fs::path target, own_path;
    int file = -1;
};

// A path of the build or, where there is none of that name, what was installed with the program.
std::string found(const std::string& built, const std::string& installed) {
    std::error_code fault;
    if (fs::exists(built, fault)) return built;
    const fs::path beside = fs::path(this_program()).parent_path() / "../share/denhartog" / installed;
    return fs::exists(beside, fault) ? beside.lexically_normal().string() : built;
}

} // namespace

void report(const std::string& fault) {
    std::string line = fault;
    for (char& c : line)
        if (c == '\n' || c == '\r') c = ' ';
    std::cerr << "denhartog: " << legible(line, longest_report) << '\n';
}

std::string read_input(const std::string& path) {
    if (path.empty() || path == "-") return all_of(stdin, "standard input");
    errno = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(path.c_str(), "rbe"), std::fclose);
    if (!in) cannot_be_read(path, last_fault());
    return all_of(in.get(), path);
}

void write_standard_output(const std::string& text) { write(std::cout, text, "standard output"); }

void check_writable(const std::string& path) {
    errno = 0;
    if (!is_no_file(path)) {
        const InterruptionsHeld held;
        const NewFile file(path);
    } else if (::access(path.c_str(), W_OK) != 0) {
        cannot_be_written(path, last_fault());
    }
}

void write_file(const std::string& path, const std::string& text) {
    errno = 0;
    if (is_no_file(path)) {
        std::ofstream out(path, std::ios::binary);
        if (!out) cannot_be_written(path, last_fault());
        return write(out, text, path);
    }
    const InterruptionsHeld held;
    NewFile file(path);
    file.write(text);
    file.take_place();
}

void write_output(const std::string& path, const std::string& text) {
    path.empty() ? write_standard_output(text) : write_file(path, text);
}

std::string this_program() {
    std::error_code fault;
    const fs::path path = fs::read_symlink("/proc/self/exe", fault);
    return fault ? "denhartog" : path.string();
}

std::string vectors_folder() { return found(DENHARTOG_VECTORS, "vectors"); }

std::string equations_file() { return found(DENHARTOG_EQUATIONS_FILE, "equations.json"); }

std::string derivation_file(const std::string& name) { return found(DENHARTOG_DERIVATION_FOLDER "/" + name, name); }

} // namespace denhartog::program
