/// @file
/// @brief The command-line program. A new commit compiles this source alone.
#include "denhartog/program/program.hpp"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

int main(int argc, char** argv) {
#if defined(__GLIBC__)
    // Balls come and go by the million: what they free is kept, and not handed back to the system each time.
    mallopt(M_TRIM_THRESHOLD, 1 << 28);
    mallopt(M_TOP_PAD, 1 << 20);
    mallopt(M_MMAP_THRESHOLD, 1 << 25);
#endif
    return denhartog::program::run_program(argc, argv, {DENHARTOG_COMMIT, DENHARTOG_COMPILER});
}
