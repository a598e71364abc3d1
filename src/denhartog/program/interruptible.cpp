#include "denhartog/program/exit_status.hpp"

#include <csignal>

namespace denhartog::program {
namespace {

std::atomic<std::atomic<bool>*> flag{nullptr};
std::atomic<int> signal_caught{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free &&
              std::atomic<std::atomic<bool>*>::is_always_lock_free);

void catch_signal(int signal) {
    signal_caught = signal;
    *flag.load() = true;
}

} // namespace

Interruptible::Interruptible(std::atomic<bool>& stop) {
    flag = &stop;
    interrupt = std::signal(SIGINT, catch_signal);
    terminate = std::signal(SIGTERM, catch_signal);
    hang_up = std::signal(SIGHUP, catch_signal);
    if (hang_up == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

Interruptible::~Interruptible() {
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, terminate);
    std::signal(SIGHUP, hang_up);
}

int Interruptible::caught() const { return signal_caught; }

} // namespace denhartog::program
