// How a program under test is started, asked a line and ended, so that it can neither block the runner nor outlive it. Read
// `Process::ask`: it ends with a line, or with a crash, a stall or a timeout. The child's side is the functions before `Process`.
#include "conformance/session/session.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <sstream>
#include <system_error>
#include <utility>

namespace denhartog::conformance {
namespace {

using Clock = std::chrono::steady_clock;

// Longest wait in the system: interruptions and the program's end are looked for in between.
constexpr int slice_milliseconds = 20;

// Below this share of the processor a program counts as waiting.
constexpr double share_of_a_waiting_program = 0.02;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Whether the program has ended; it stays there to be waited for, so that the number of its group is nobody else's.
bool has_ended(pid_t program) {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(program), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == program;
}

// Waits for the processes of a group that has been killed, as far as they are children of this process by then.
void wait_for_all_of(pid_t group) {
    while (::waitpid(-group, nullptr, 0) > 0 || errno == EINTR) continue;
}

std::string end_of(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        const char* name = ::strsignal(signal);
        return "it was ended by signal " + std::to_string(signal) + (name != nullptr ? " (" + std::string(name) + ")" : "");
    }
    return "it ended with status " + std::to_string(WEXITSTATUS(status));
}

[[noreturn]] void fail(int fault, const std::string& what) { throw std::system_error(fault, std::generic_category(), what); }

// A pipe that no other program inherits, if no thread starts one meanwhile.
struct Pipe {
    std::array<int, 2> ends{};

    Pipe() {
        if (::pipe(ends.data()) != 0) fail(errno, "pipe");
        for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
    }
    ~Pipe() {
        for (const int end : ends)
            if (end >= 0) ::close(end);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    // An end for the runner, which does not wait there.
    int keep(std::size_t end) {
        ::fcntl(ends.at(end), F_SETFL, O_NONBLOCK);
        return std::exchange(ends.at(end), -1);
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

// Processor time of a process group, and whether it can run.
struct GroupActivity {
    double processor_seconds = 0; // user and system time of its processes, and of their children that have ended
    bool stopped = false;         // one of them is stopped by a signal
};

// State of a process group, from /proc; none if there is no such group.
std::optional<GroupActivity> group_activity(pid_t group) {
    std::error_code fault;
    std::optional<GroupActivity> activity;
    const double ticks_a_second = static_cast<double>(::sysconf(_SC_CLK_TCK));
    for (std::filesystem::directory_iterator at("/proc", fault), end; !fault && at != end; at.increment(fault)) {
        if (at->path().filename().string().find_first_not_of("0123456789") != std::string::npos) continue;
        std::ifstream file(at->path() / "stat");
        const std::string text(std::istreambuf_iterator<char>(file), {});
        std::istringstream behind_name(text.substr(text.rfind(')') + 1)); // the name may hold anything
        const std::vector<std::string> fields{std::istream_iterator<std::string>(behind_name), {}};
        constexpr std::size_t state = 0, its_group = 2, times = 11, end_of_times = 15;
        if (fields.size() < end_of_times || fields[its_group] != std::to_string(group)) continue;
        if (!activity) activity.emplace();
        for (std::size_t n = times; n < end_of_times; ++n) activity->processor_seconds += std::stod(fields[n]) / ticks_a_second;
        activity->stopped = activity->stopped || fields[state] == "T";
    }
    return activity;
}

} // namespace

std::atomic<bool>& interruption() {
    static std::atomic<bool> set{false};
    return set;
}

WithoutBrokenPipeSignal::WithoutBrokenPipeSignal() : earlier(std::signal(SIGPIPE, SIG_IGN)) {}
WithoutBrokenPipeSignal::~WithoutBrokenPipeSignal() { std::signal(SIGPIPE, earlier); }

Process::Process(const std::vector<std::string>& command) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
#ifdef __linux__ // children that a program leaves behind come to this process to be waited for; else to the first one
    ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
#endif
    static std::mutex of_starts;
    const std::lock_guard<std::mutex> hold(of_starts);
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
    ::close(std::exchange(faults.ends[1], -1));
    int fault = 0; // that kept the child from becoming the program; its becoming it closes the pipe
    ssize_t size = 0;
    while ((size = ::read(faults.ends[0], &fault, sizeof fault)) < 0 && errno == EINTR) continue;
    if (size == sizeof fault) {
        wait_for_all_of(child);
        fail(fault, words.front());
    }
    group = child;
    to = in.keep(1);
    from = out.keep(0);
}

Process::~Process() {
    kill_group();
    if (to >= 0) ::close(to);
    if (from >= 0) ::close(from);
}

void Process::kill_group() {
    if (group < 0) return;
    ::kill(-group, SIGKILL);
    wait_for_all_of(group);
    group = -1;
}

// Reads what is there; whether anything was.
bool Process::receive(bool& at_end) {
    std::array<char, 65536> piece;
    const ssize_t size = ::read(from, piece.data(), piece.size());
    at_end = size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR);
    if (size <= 0) return false;
    received.append(piece.data(), static_cast<std::size_t>(size));
    return true;
}

// Writes what fits; a program that does not read any more is left to answer all the same.
void Process::send(std::string_view& rest) {
    const ssize_t size = ::write(to, rest.data(), rest.size());
    if (size >= 0)
        rest.remove_prefix(static_cast<std::size_t>(size));
    else if (errno != EAGAIN && errno != EINTR)
        rest = {};
}

// Puts what was not asked for on its own account; false where there is no end of it.
bool Process::set_aside() {
    bool at_end = false;
    std::size_t size = received.size();
    while (size <= longest_line && receive(at_end)) size = received.size();
    for (std::size_t start = 0; start < received.size();) {
        const std::size_t end = std::min(received.find('\n', start), received.size());
        if (extra.lines++ == 0) extra.first = received.substr(start, std::min<std::size_t>(end - start, 200));
        start = end + 1;
    }
    received.clear();
    return size <= longest_line;
}

Reply Process::ask(std::string_view line, double seconds) {
    // Output before the first line is sent is read as the reply to it: whether it comes before or after is chance.
    if (asked && !set_aside()) return {"", Verdict::crash, "it wrote more than a megabyte without being asked"};
    asked = true;
    const std::string text = std::string(line) + '\n';
    std::string_view rest = text;
    const Clock::time_point start = Clock::now();
    double at_half = -1;
    std::size_t searched = 0;
    bool ended = false;
    while (true) {
        const std::size_t end = received.find('\n', searched);
        if (end != std::string::npos && end <= longest_line) {
            Reply reply{received.substr(0, end), std::nullopt, ""};
            received.erase(0, end + 1);
            return reply;
        }
        if (received.size() > longest_line) return {"", Verdict::crash, "it wrote a line of more than a megabyte"};
        searched = received.size();
        if (ended) return broken_off();
        if (interruption()) return {"", Verdict::skipped, "the runner was interrupted"};
        const double waited = seconds_since(start);
        if (waited >= seconds) return no_line(waited - seconds / 2, at_half);
        if (at_half < 0 && waited >= seconds / 2) {
            const auto activity = group_activity(group);
            if (activity) at_half = activity->processor_seconds;
        }
        std::array<pollfd, 2> ends{{{from, POLLIN, 0}, {rest.empty() ? -1 : to, POLLOUT, 0}}};
        ::poll(ends.data(), ends.size(), slice_milliseconds);
        if (ends[1].revents != 0) send(rest);
        bool at_end = false;
        const bool leader_gone = has_ended(group);
        // After the program's end one more reading: another process may hold the pipe open.
        while (receive(at_end) && received.size() <= longest_line && received.find('\n', searched) == std::string::npos) continue;
        ended = at_end || leader_gone;
    }
}

Reply Process::no_line(double second_half, double processor_time_at_half) {
    const auto activity = group_activity(group);
    const std::string part = received.empty() ? "" : "; it has written half a line";
    if (!activity || processor_time_at_half < 0) return {"", Verdict::timeout, "it did not answer in time" + part};
    if (activity->stopped) return {"", Verdict::stall, "it is stopped by a signal" + part};
    const double used = activity->processor_seconds - processor_time_at_half;
    if (used > share_of_a_waiting_program * second_half) return {"", Verdict::timeout, "it was still computing" + part};
    return {"", Verdict::stall,
            "it waits and computes nothing: does it flush its output after each line, and does it read a line at "
            "a time, without waiting for more input?" +
                part};
}

Reply Process::broken_off() {
    constexpr double patience = 0.2;
    const std::string half = received.empty() ? "" : ", in the middle of a line";
    const Clock::time_point start = Clock::now();
    while (!has_ended(group) && seconds_since(start) < patience) ::poll(nullptr, 0, 1);
    if (!has_ended(group)) return {"", Verdict::crash, "it closed its standard output" + half};
    return {"", Verdict::crash, how_it_ended(0) + half};
}

// Waits for the end of the program and kills what is left of its group.
std::string Process::how_it_ended(double seconds) {
    const Clock::time_point start = Clock::now();
    while (!has_ended(group)) {
        if (seconds_since(start) >= seconds || interruption()) {
            kill_group();
            return "it did not end when its standard input was closed";
        }
        bool at_end = false;
        receive(at_end);
        if (received.size() > longest_line) received.resize(1);
        ::poll(nullptr, 0, 2);
    }
    ::kill(-group, SIGKILL);
    int status = 0;
    while (::waitpid(group, &status, 0) < 0 && errno == EINTR) continue;
    wait_for_all_of(group);
    group = -1;
    return end_of(status);
}

std::string Process::finish(double seconds) {
    ::close(to);
    to = -1;
    const std::string end = how_it_ended(seconds);
    set_aside();
    return end == "it ended with status 0" ? "" : end;
}

} // namespace denhartog::conformance
