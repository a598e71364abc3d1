#include "conformance/session/process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <csignal>
#include <mutex>
#include <system_error>

namespace denhartog::conformance {
namespace {

[[noreturn]] void fail(int fault, const std::string& what) { throw std::system_error(fault, std::generic_category(), what); }

// A pipe that no other program inherits.
struct Pipe {
    std::array<int, 2> ends{-1, -1};

    Pipe() {
        if (::pipe(ends.data()) != 0) fail(errno, "pipe");
        for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
    }
    ~Pipe() {
        for (std::size_t end = 0; end < ends.size(); ++end) close(end);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    void close(std::size_t end) {
        if (ends.at(end) >= 0) ::close(ends[end]);
        ends[end] = -1;
    }
    int keep(std::size_t end) {
        const int kept = ends.at(end);
        ends[end] = -1;
        ::fcntl(kept, F_SETFL, ::fcntl(kept, F_GETFL) | O_NONBLOCK);
        return kept;
    }
};

// The signal comes when the runner dies; a runner that died before it was asked for shows by another parent.
void die_with(pid_t runner) {
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
#endif
    if (::getppid() != runner) ::_exit(127);
}

// The pipe's end as standard input or output, which the program inherits also where the pipe got that number by chance.
bool becomes(int end, int standard) {
    return end == standard ? ::fcntl(end, F_SETFD, 0) == 0 : ::dup2(end, standard) == standard;
}

// Work of the child: only calls that are allowed after a fork among threads. A group of its own, no signal blocked, none
// ignored that a program expects to end it. The number of the fault goes to the runner if it does not become the program.
[[noreturn]] void become(char* const* arguments, pid_t runner, int input, int output, int faults) {
    die_with(runner);
    ::setpgid(0, 0);
    for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::signal(signal, SIG_DFL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    if (becomes(input, STDIN_FILENO) && becomes(output, STDOUT_FILENO)) ::execvp(arguments[0], arguments);
    const int fault = errno;
    static_cast<void>(!::write(faults, &fault, sizeof fault));
    ::_exit(127);
}

} // namespace

Process::Process(const std::vector<std::string>& command) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
#ifdef __linux__ // children that a program leaves behind come to this process to be waited for; else to the first one
    ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
#endif
    // One at a time, or a program could inherit the other's pipe before it is closed to it.
    static std::mutex starting;
    const std::lock_guard<std::mutex> lock(starting);
    Pipe in, out, faults;
    const pid_t runner = ::getpid();
    sigset_t all, before; // no signal reaches the child before it is the program: a handler of the runner's would run there
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);
    const pid_t child = ::fork();
    if (child == 0) become(arguments.data(), runner, in.ends[0], out.ends[1], faults.ends[1]);
    const int not_forked = errno;
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    if (child < 0) fail(not_forked, "fork");
    faults.close(1);
    int fault = 0; // that kept the child from becoming the program; its becoming it closes the pipe
    ssize_t size = 0;
    while ((size = ::read(faults.ends[0], &fault, sizeof fault)) < 0 && errno == EINTR) continue;
    if (size == sizeof fault) {
        while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
        fail(fault, words.front());
    }
    group = child;
    to = in.keep(1);
    from = out.keep(0);
}

} // namespace denhartog::conformance
