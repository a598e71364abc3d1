#include "denhartog/program/sweep/merge.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "denhartog/number/errors.hpp"
#include "denhartog/program/output/files.hpp"
#include "denhartog/program/output/new_file.hpp"
#include "denhartog/program/sweep/store.hpp"

namespace denhartog::program {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using sweep::Array;
using sweep::Box;
using sweep::Partial;
using sweep::Reduction;

bool is_left_over(const std::string& name) { return name.starts_with(new_file_begins) && name.ends_with(new_file_ends); }

// The folders in which chunks leave files.
std::vector<std::string> folders_of_chunks(const StudyFolder& study) {
    std::vector<std::string> all{"done"};
    for (const Array& array : arrays_of_points(study.plan)) all.push_back(std::string(sweep::result_folder) + "/" + array.name);
    for (const Reduction& r : study.plan.study.reductions) {
        if (study.plan.splits(r)) all.push_back("parts/" + r.name);
        for (const Array& array : arrays_of(study.plan, r)) all.push_back(std::string(sweep::result_folder) + "/" + array.name);
    }
    return all;
}

// The chunks of an array that is put together; `merge` writes them.
std::vector<std::string> paths_of_merge(const StudyFolder& study) {
    std::vector<std::string> paths;
    for (const Reduction& r : study.plan.study.reductions) {
        if (!study.plan.splits(r)) continue;
        for (const Array& array : arrays_of(study.plan, r)) {
            const std::vector<std::size_t> boxes = array.boxes();
            std::vector<std::size_t> place(boxes.size(), 0);
            for (bool more = true; more;) {
                paths.push_back(std::string(sweep::result_folder) + "/" + array.name + "/" + sweep::chunk_name(place));
                more = false;
                for (std::size_t d = place.size(); d-- > 0 && !more;) {
                    more = ++place[d] < boxes[d];
                    if (!more) place[d] = 0;
                }
            }
        }
    }
    return paths;
}

void add_strangers(const StudyFolder& study, const std::set<std::string>& known, MergeFaults& found) {
    for (const std::string& folder : folders_of_chunks(study)) {
        std::error_code fault;
        for (const auto& entry : fs::directory_iterator(study.file(folder), fault)) {
            const std::string name = entry.path().filename().string(), path = folder + "/" + name;
            if (name.starts_with(".z") || is_left_over(name) || known.contains(path)) continue;
            found.faults.push_back(path + " is a file that no chunk of this plan wrote");
        }
    }
}

std::vector<std::size_t> left_place(const Box& box, const std::vector<std::size_t>& left) {
    std::vector<std::size_t> place;
    for (const std::size_t d : left) place.push_back(box.place[d]);
    return place;
}

void put_together(const StudyFolder& study, const Reduction& r) {
    const std::vector<std::size_t> left = study.plan.dimensions_of(r.name);
    std::map<std::vector<std::size_t>, std::vector<std::size_t>> chunks_of;
    for (std::size_t K = 0; K < study.plan.chunks; ++K) chunks_of[left_place(study.plan.box(K), left)].push_back(K);
    for (const auto& [place, chunks] : chunks_of) {
        std::optional<Partial> all;
        for (const std::size_t K : chunks) {
            const Partial part = from_bytes(study.plan, r, study.plan.box(K), read_input(study.file(path_of_part(r, K))));
            if (all)
                put_together(r, *all, part);
            else
                all = part;
        }
        for (const sweep::Piece& piece : pieces_of(study.plan, r, study.plan.box(chunks.front()), *all))
            write_file_to_disk(study.file(piece.path), piece.bytes);
    }
}

} // namespace

std::vector<Array> all_arrays(const sweep::Plan& plan) {
    std::vector<Array> all;
    for (const sweep::Coordinate& each : coordinates_of(plan)) all.push_back(each.array);
    for (const Array& each : arrays_of_points(plan)) all.push_back(each);
    for (const Reduction& r : plan.study.reductions)
        for (const Array& each : arrays_of(plan, r)) all.push_back(each);
    return all;
}

MergeFaults faults_of(const StudyFolder& study) {
    MergeFaults found;
    std::set<std::string> known;
    for (std::size_t K = 0; K < study.plan.chunks; ++K) {
        const std::optional<Record> record = record_of(study, K);
        if (!record) {
            found.missing.push_back(K);
            continue;
        }
        known.insert("done/" + std::to_string(K) + ".json");
        const std::string fault = fault_of(study, K, *record);
        if (!fault.empty()) found.faults.push_back("chunk " + std::to_string(K) + ": " + fault);
        for (const std::string& path : paths_of(study.plan, K)) known.insert(path);
    }
    for (const std::string& path : paths_of_merge(study)) known.insert(path);
    // A chunk that is missing may have left files without its record.
    for (const std::size_t K : found.missing)
        for (const std::string& path : paths_of(study.plan, K)) known.insert(path);
    add_strangers(study, known, found);
    return found;
}

void merge(const StudyFolder& study) {
    for (const Reduction& r : study.plan.study.reductions)
        if (study.plan.splits(r)) put_together(study, r);
    for (const std::string& folder : folders_of_chunks(study)) {
        std::vector<fs::path> left_over;
        for (const auto& entry : fs::directory_iterator(study.file(folder)))
            if (is_left_over(entry.path().filename().string())) left_over.push_back(entry.path());
        for (const fs::path& each : left_over) fs::remove(each);
    }
    const std::string store = study.file(sweep::result_folder) + "/";
    ordered_json metadata{{".zgroup", {{"zarr_format", 2}}}};
    metadata[".zattrs"] = json_of_store(study);
    for (const Array& each : all_arrays(study.plan)) {
        metadata[each.name + "/.zarray"] = each.metadata();
        metadata[each.name + "/.zattrs"] = each.all_attributes();
    }
    const ordered_json consolidated{{"zarr_consolidated_format", 1}, {"metadata", metadata}};
    write_file_to_disk(store + ".zmetadata", consolidated.dump(1) + "\n");
}

} // namespace denhartog::program
