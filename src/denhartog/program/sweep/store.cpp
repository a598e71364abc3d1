#include "denhartog/program/sweep/store.hpp"

#include <filesystem>

#include "denhartog/number/errors.hpp"
#include "denhartog/program/installed.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/program/output/new_file.hpp"
#include "denhartog/program/sweep/merge.hpp"
#include "denhartog/program/sweep/scripts.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/version.hpp"

namespace denhartog::program {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

void make_folder(const std::string& path) {
    std::error_code fault;
    fs::create_directories(path, fault);
    if (fault) throw InputError(path, "cannot be written (" + fault.message() + ")", "");
}

// A folder that is there may hold the same study alone.
void check_place(const std::string& path, const std::string& fingerprint) {
    std::error_code fault;
    if (!fs::exists(path, fault)) return;
    if (!fs::is_directory(path, fault)) throw InputError("DIR", "must be a folder", path);
    if (fs::is_empty(path, fault)) return;
    const bool planned = fs::is_regular_file(path + "/plan.json", fault);
    const nlohmann::json plan = planned ? json_or_nothing(read_input(path + "/plan.json")) : nlohmann::json();
    if (!plan.is_object() || plan.value("fingerprint", "") != fingerprint)
        throw InputError("DIR", "must be a new folder, or that of the same study planned by the same program", path);
}

void write_arrays(const StudyFolder& study) {
    const std::string store = study.file(sweep::result_folder) + "/";
    for (const sweep::Array& each : all_arrays(study.plan)) {
        make_folder(store + each.name);
        write_file_to_disk(store + each.name + "/.zarray", each.metadata().dump(1) + "\n");
        write_file_to_disk(store + each.name + "/.zattrs", each.all_attributes().dump(1) + "\n");
    }
    for (const sweep::Coordinate& each : coordinates_of(study.plan))
        write_file_to_disk(store + each.array.name + "/0", each.bytes);
    write_file_to_disk(store + ".zgroup", ordered_json{{"zarr_format", 2}}.dump(1) + "\n");
    write_file_to_disk(store + ".zattrs", json_of_store(study).dump(1) + "\n");
    for (const sweep::Reduction& r : study.plan.study.reductions)
        if (study.plan.splits(r)) make_folder(study.file("parts/" + r.name));
}

} // namespace

ordered_json json_of_store(const StudyFolder& study) {
    return {{"program", "denhartog " DENHARTOG_VERSION},
            {"fingerprint", study.fingerprint},
            {"chunks", study.plan.chunks},
            {"points", study.plan.points}};
}

StudyFolder write_folder(const std::string& text, const std::string& path, const std::string& commit,
                         const ordered_json& estimate) {
    const StudyFolder study{path, sweep::plan_of(sweep::read_study(text)), fingerprint_of(text, commit)};
    check_place(path, study.fingerprint);
    for (const char* each : {"done", "log", sweep::result_folder}) make_folder(study.file(each));
    write_arrays(study);
    const fs::path absolute = fs::canonical(path);
    for (const Script& each : scripts_of(absolute.string(), this_program(), study.plan.chunks)) {
        write_file_to_disk(study.file(each.name), each.text);
        fs::permissions(study.file(each.name), fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                        fs::perm_options::add);
    }
    ordered_json axes = ordered_json::array();
    for (std::size_t d = 0; d < study.plan.dimensions.size(); ++d)
        axes.push_back({{"name", study.plan.dimensions[d].name},
                        {"size", study.plan.dimensions[d].size},
                        {"of_a_chunk", study.plan.chunk[d]}});
    const ordered_json plan{{"program", "denhartog " DENHARTOG_VERSION},
                            {"commit", commit},
                            {"fingerprint", study.fingerprint},
                            {"points", study.plan.points},
                            {"chunks", study.plan.chunks},
                            {"axes", axes},
                            {"estimate", estimate}};
    write_file_to_disk(study.file("study.json"), text);
    write_file_to_disk(study.file("plan.json"), plan.dump(1) + "\n"); // last: with it the folder is one of a study
    return study;
}

} // namespace denhartog::program
