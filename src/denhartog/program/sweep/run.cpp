#include "denhartog/program/sweep/run.hpp"

#include <atomic>
#include <mutex>

#include "denhartog/number/parallel.hpp"
#include "denhartog/program/exit_status.hpp"
#include "denhartog/program/interruptible.hpp"
#include "denhartog/program/output/new_file.hpp"
#include "denhartog/program/sweep/processor_time.hpp"
#include "denhartog/sweep/sha256.hpp"

namespace denhartog::program {
namespace {

std::atomic<bool> stop{false};

// The record last: until it is there the chunk is not done, whatever else was written.
void write_chunk(const StudyFolder& study, std::size_t K, const sweep::Points& points, double seconds) {
    Record record;
    record.chunk = K;
    record.fingerprint = study.fingerprint;
    record.seconds = seconds;
    for (const std::int8_t each : points.status) ++record.points[static_cast<std::size_t>(each)];
    for (const sweep::Piece& piece : pieces_of(study.plan, K, points)) {
        write_file_to_disk(study.file(piece.path), piece.bytes);
        record.files.push_back({piece.path, piece.bytes.size(), sweep::sha256(piece.bytes)});
    }
    write_file_to_disk(path_of_record(study, K), text_of(record));
}

bool is_done(const StudyFolder& study, std::size_t K) {
    const std::optional<Record> record = record_of(study, K);
    if (!record) return false;
    const std::string fault = fault_of(study, K, *record);
    if (!fault.empty()) report("chunk " + std::to_string(K) + " is computed again: " + fault);
    return fault.empty();
}

} // namespace

ChunksRun run_chunks(const StudyFolder& study, const std::vector<std::size_t>& chunks, unsigned jobs,
                     const std::function<void(std::size_t)>& told) {
    const Interruptible interruptible(stop);
    const sweep::SceneAt scenes(study.plan);
    ChunksRun run;
    std::mutex mutex;
    parallel_for(chunks.size(), jobs, [&](std::size_t n) {
        const bool done_before = is_done(study, chunks[n]);
        if (!done_before) {
            const double start = processor_seconds();
            const sweep::Points points = points_of(study.plan, scenes, study.plan.box(chunks[n]), stop);
            if (!points.complete) return false;
            write_chunk(study, chunks[n], points, processor_seconds() - start);
        }
        const std::lock_guard<std::mutex> lock(mutex);
        ++(done_before ? run.found_done : run.computed);
        told(run.found_done + run.computed);
        return !stop;
    });
    if (stop) run.signal = interruptible.caught();
    return run;
}

} // namespace denhartog::program
