#include "conformance/session/process_time.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace denhartog::conformance {
namespace {

// Of /proc/N/stat what follows the name, which may hold anything.
struct Status {
    char state = '?';
    pid_t group = 0;
    double ticks = 0;
};

std::optional<Status> status_in(const std::filesystem::path& process) {
    std::ifstream file(process / "stat");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const std::size_t name_end = text.rfind(')');
    if (name_end == std::string::npos) return std::nullopt;
    std::istringstream fields(text.substr(name_end + 1));
    Status status;
    long skipped = 0, user = 0, system = 0, user_of_children = 0, system_of_children = 0;
    fields >> status.state >> skipped >> status.group;
    for (int n = 0; n < 8; ++n) fields >> skipped;
    fields >> user >> system >> user_of_children >> system_of_children;
    if (!fields) return std::nullopt;
    status.ticks = static_cast<double>(user + system + user_of_children + system_of_children);
    return status;
}

} // namespace

std::optional<GroupActivity> group_activity(pid_t group) {
    std::error_code fault;
    GroupActivity activity;
    bool any = false;
    const double ticks_a_second = static_cast<double>(::sysconf(_SC_CLK_TCK));
    for (std::filesystem::directory_iterator at("/proc", fault), end; !fault && at != end; at.increment(fault)) {
        const std::string name = at->path().filename();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        const std::optional<Status> status = status_in(at->path());
        if (!status || status->group != group) continue;
        any = true;
        activity.processor_seconds += status->ticks / ticks_a_second;
        activity.stopped = activity.stopped || status->state == 'T';
    }
    if (!any) return std::nullopt;
    return activity;
}

} // namespace denhartog::conformance
