/// @file
/// @brief Independent pieces of work shared among threads.
#pragma once

#include <cstddef>
#include <functional>

namespace denhartog {

/// @brief Does pieces of work that know nothing of each other, each once, on as many threads as asked for.
///
/// A piece that throws ends the work; the first exception thrown comes out of here once all threads are done.
/// @param count    number of pieces
/// @param threads  threads, at least 1; not more are started than there are pieces
/// @param piece    does piece n, and says whether to go on
void parallel_for(std::size_t count, unsigned threads, const std::function<bool(std::size_t n)>& piece);

} // namespace denhartog
