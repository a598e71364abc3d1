// Independent pieces of work shared among threads.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>

namespace denhartog {

// Does pieces of work that know nothing of each other, each once, on as many threads as asked for. A piece that throws ends the
// work; the first exception thrown comes out of here once all threads are done. A piece says whether to go on. Not
// more threads are started than there are pieces.
void parallel_for(std::size_t count, unsigned threads, const std::function<bool(std::size_t n)>& piece);

// Counts the items that threads have finished, and reports the count: one thread at a time.
class Progress {
public:
    // `told` gets the number of finished items; it may be empty.
    explicit Progress(std::function<void(std::size_t done)> told) : told_(std::move(told)) {}

    void add(std::size_t more) {
        const std::lock_guard<std::mutex> lock(mutex_);
        done_ += more;
        if (told_) told_(done_);
    }
    // Number of finished items, once no thread works any more.
    [[nodiscard]] std::size_t done() const { return done_; }

private:
    std::function<void(std::size_t done)> told_;
    std::size_t done_ = 0;
    std::mutex mutex_;
};

} // namespace denhartog
