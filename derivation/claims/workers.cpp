#include "derivation/claims/workers.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <poll.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace denhartog::derivation {

namespace {

/// Exit status of a process whose task threw; its text is then what was thrown.
constexpr int threw = 1;

struct Worker {
    std::size_t task;
    pid_t process;
    int pipe;
    std::string text;
};

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// The work of a child process, which leaves without the parent's destructors and buffers.
[[noreturn]] void work(std::size_t number, int pipe, const std::function<std::string(std::size_t)>& task) {
    int status = 0;
    std::string text;
    try {
        text = task(number);
    } catch (const std::exception& e) {
        text = e.what();
        status = threw;
    }
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t written = ::write(pipe, text.data() + at, text.size() - at);
        if (written > 0)
            at += static_cast<std::size_t>(written);
        else if (errno != EINTR)
            ::_exit(threw + 1);
    }
    ::_exit(status);
}

Worker start(std::size_t number, const std::function<std::string(std::size_t)>& task) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) fail("no pipe for a worker");
    std::fflush(nullptr);
    const pid_t process = ::fork();
    if (process < 0) fail("no process for a worker");
    if (process == 0) work(number, ends[1], task);
    ::close(ends[1]);
    return {number, process, ends[0], {}};
}

/// Reads what there is. Whether there may be more.
bool read_some(Worker& worker) {
    std::array<char, 65536> buffer;
    const ssize_t got = ::read(worker.pipe, buffer.data(), buffer.size());
    if (got > 0) worker.text.append(buffer.data(), static_cast<std::size_t>(got));
    return got > 0 || (got < 0 && errno == EINTR);
}

/// Takes leave of a worker that has nothing more to say.
Delivery finish(Worker& worker) {
    ::close(worker.pipe);
    int status = 0;
    while (::waitpid(worker.process, &status, 0) < 0)
        if (errno != EINTR) fail("a worker is lost");
    if (WIFSIGNALED(status)) return {{}, std::string("its process was ended by a signal: ") + ::strsignal(WTERMSIG(status))};
    if (WEXITSTATUS(status) == threw) return {{}, worker.text};
    if (WEXITSTATUS(status) != 0) return {{}, "its process ended with status " + std::to_string(WEXITSTATUS(status))};
    return {std::move(worker.text), {}};
}

} // namespace

void in_processes(std::size_t count, std::size_t workers, const std::function<std::string(std::size_t)>& task,
                  const std::function<void(std::size_t, const Delivery&)>& delivered) {
    std::vector<Worker> running;
    for (std::size_t next = 0; next < count || !running.empty();) {
        while (next < count && running.size() < std::max<std::size_t>(workers, 1)) running.push_back(start(next++, task));
        std::vector<pollfd> pipes;
        for (const Worker& worker : running) pipes.push_back({worker.pipe, POLLIN, 0});
        if (::poll(pipes.data(), pipes.size(), -1) < 0 && errno != EINTR) fail("the workers cannot be heard");
        for (std::size_t i = running.size(); i-- > 0;) {
            if (pipes[i].revents == 0 || read_some(running[i])) continue;
            const Delivery delivery = finish(running[i]);
            const std::size_t number = running[i].task;
            running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
            delivered(number, delivery);
        }
    }
}

} // namespace denhartog::derivation
