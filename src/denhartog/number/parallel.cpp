// Independent pieces of work, shared among threads. Each thread takes the next piece from a counter, until none is left,
// a piece returns false, or one has thrown.
#include "denhartog/number/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace denhartog {

void parallel_for(std::size_t count, unsigned threads, const std::function<bool(std::size_t)>& piece) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> ended{false};
    std::mutex mutex;
    std::exception_ptr fault;
    const auto work = [&] {
        try {
            for (std::size_t n = next++; n < count && !ended; n = next++)
                if (!piece(n)) ended = true;
        } catch (...) {
            const std::lock_guard<std::mutex> lock(mutex);
            if (!fault) fault = std::current_exception();
            ended = true;
        }
    };
    std::vector<std::thread> others;
    try {
        others.reserve(std::min<std::size_t>(threads, count));
        for (unsigned n = 1; n < std::min<std::size_t>(threads, count); ++n) others.emplace_back(work);
    } catch (const std::system_error&) {
        // The system grants no more threads: those that there are do all the pieces.
    }
    work();
    for (std::thread& other : others) other.join();
    if (fault) std::rethrow_exception(fault);
}

} // namespace denhartog
