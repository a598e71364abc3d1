#include "denhartog/program/installed.hpp"

#include <filesystem>

namespace denhartog::program {
namespace {

// A path of the build or, where there is none of that name, what was installed with the program.
std::string found(const std::string& built, const std::string& installed) {
    std::error_code fault;
    if (std::filesystem::exists(built, fault)) return built;
    const std::filesystem::path beside = std::filesystem::path(this_program()).parent_path() / "../share/denhartog" / installed;
    return std::filesystem::exists(beside, fault) ? beside.lexically_normal().string() : built;
}

} // namespace

std::string this_program() {
    std::error_code fault;
    const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", fault);
    return fault ? "denhartog" : path.string();
}

std::string vectors_folder() { return found(DENHARTOG_VECTORS, "vectors"); }

std::string equations_file() { return found(DENHARTOG_EQUATIONS_FILE, "equations.json"); }

std::string derivation_file(const std::string& name) { return found(DENHARTOG_DERIVATION_FOLDER "/" + name, name); }

} // namespace denhartog::program
