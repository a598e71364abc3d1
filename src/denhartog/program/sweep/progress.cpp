#include "denhartog/program/sweep/progress.hpp"

#include <functional>
#include <queue>

#include "denhartog/number/number_text.hpp"

namespace denhartog::program {
namespace {

using nlohmann::ordered_json;

// Chunks that are not done yet are taken to last as long as the others in turn.
double seconds_with(std::size_t workers, const std::vector<double>& seconds, std::size_t chunks) {
    std::priority_queue<double, std::vector<double>, std::greater<>> free;
    for (std::size_t n = 0; n < workers; ++n) free.push(0);
    double last = 0;
    for (std::size_t K = 0; K < chunks && !seconds.empty(); ++K) {
        const double end = free.top() + seconds[K % seconds.size()];
        free.pop();
        free.push(end);
        last = std::max(last, end);
    }
    return last;
}

} // namespace

std::string bar_of(std::size_t done, std::size_t all) {
    constexpr std::size_t width = 40;
    const std::size_t full = all == 0 ? width : width * done / all;
    std::string percent = std::to_string(all == 0 ? 100 : 100 * done / all);
    percent.insert(0, 3 - percent.size(), ' ');
    return "[" + std::string(full, '#') + std::string(width - full, '.') + "] " + percent + " %";
}

ordered_json status_of(const StudyFolder& study, std::optional<std::size_t> workers) {
    std::vector<std::size_t> missing, other;
    std::vector<double> seconds;
    std::array<std::size_t, 6> points{};
    double all_seconds = 0;
    for (std::size_t K = 0; K < study.plan.chunks; ++K) {
        const std::optional<Record> record = record_of(study, K);
        if (!record) {
            missing.push_back(K);
        } else if (record->files.empty() || record->fingerprint != study.fingerprint) {
            other.push_back(K);
        } else {
            seconds.push_back(record->seconds);
            all_seconds += record->seconds;
            for (std::size_t n = 0; n < points.size(); ++n) points[n] += record->points[n];
        }
    }
    ordered_json status{{"chunks", study.plan.chunks}, {"done", seconds.size()}, {"points", study.plan.points}};
    std::size_t points_done = 0;
    for (std::size_t n = 0; n < points.size(); ++n) {
        points_done += points[n];
        status["points_by_status"][sweep::statuses[n]] = points[n];
    }
    status["points_done"] = points_done;
    status["seconds"] = all_seconds;
    status["missing"] = ranges_of(missing);
    status["of_another_program_or_study"] = ranges_of(other);
    status["fingerprint"] = study.fingerprint;
    if (workers) {
        status["workers"] = *workers;
        status["seconds_with_workers"] = seconds_with(*workers, seconds, study.plan.chunks);
    }
    return status;
}

std::string status_text(const ordered_json& s) {
    const std::size_t done = s.at("done"), chunks = s.at("chunks");
    std::string text = bar_of(done, chunks) + "  " + std::to_string(done) + " of " + std::to_string(chunks) + " chunks\n";
    for (const auto& [name, count] : s.at("points_by_status").items())
        if (count != 0) text += name + ": " + std::to_string(count.get<std::size_t>()) + " points\n";
    const double seconds = s.at("seconds");
    if (done > 0) {
        text += "processor seconds so far: " + number_in_digits(seconds, 3);
        const double left = seconds / static_cast<double>(done) * static_cast<double>(chunks - done);
        text += done < chunks ? "; left at this pace: " + number_in_digits(left, 3) + "\n" : "\n";
    }
    if (s.at("missing") != "") text += "chunks to be run: " + s.at("missing").get<std::string>() + "\n";
    if (s.at("of_another_program_or_study") != "")
        text += "chunks of another program or study, to be run again: " + s.at("of_another_program_or_study").get<std::string>() +
                "\n";
    if (s.contains("workers"))
        text += "simulated with " + std::to_string(s.at("workers").get<std::size_t>()) +
                " workers, each given the next chunk when it is free: " + number_in_digits(s.at("seconds_with_workers"), 3) +
                " seconds\n";
    return text;
}

} // namespace denhartog::program
