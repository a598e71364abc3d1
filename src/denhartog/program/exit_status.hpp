// The exit status of the program, and how faults and interruptions get there.
#pragma once

#include <array>
#include <atomic>
#include <csignal>
#include <string>

namespace denhartog::program {

// Faults so far.
struct ExitStatus {
    bool bad_input = false;      // a scene, an option or a file: status 2
    bool digits_missing = false; // an answer not to the digits asked for: status 3
    bool failed = false;         // an implementation under test does not conform: status 1
    bool broken = false;         // an implementation under test broke: status 3
    bool beyond_must = false;    // an implementation under test conforms, but not as --strict asks: status 4
    int signal = 0;              // the signal that interrupted the program: status 128 plus its number

    [[nodiscard]] int value() const {
        return signal != 0 ? 128 + signal : bad_input ? 2 : digits_missing || broken ? 3 : failed ? 1 : beyond_must ? 4 : 0;
    }
};

// Prints a fault as one line on standard error.
void report(const std::string& fault);

// While it lives SIGINT, SIGTERM and SIGHUP set a flag, which must outlive it, so that a long computation ends in good order. One
// at a time. A SIGHUP that the caller ignores, as `nohup` does, stays ignored.
class Interruptible {
public:
    explicit Interruptible(std::atomic<bool>& stop);
    ~Interruptible() { end(); }
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;

    // The signal that came so far; 0 where none did.
    [[nodiscard]] int caught() const;

    // From now on a signal does what it did before, so that it ends a program that waits for somebody to read what it writes. The
    // signal that came until then; 0 where none did.
    int end();

private:
    static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
    std::array<void (*)(int), signals.size()> before{};
};

} // namespace denhartog::program
