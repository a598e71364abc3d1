/// @file
/// @brief A long computation that SIGINT, SIGTERM and SIGHUP end in good order.
#pragma once

#include <atomic>

namespace denhartog::program {

/// @brief While it lives an interruption sets a flag. One at a time. A SIGHUP that the caller ignores, as `nohup` does, stays
/// ignored.
class Interruptible {
public:
    /// @param stop  the flag; must outlive the object
    explicit Interruptible(std::atomic<bool>& stop);
    ~Interruptible();
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;

    /// @brief The signal that came. @return its number; 0 where none did
    [[nodiscard]] int caught() const;

private:
    void (*interrupt)(int);
    void (*terminate)(int);
    void (*hang_up)(int);
};

} // namespace denhartog::program
