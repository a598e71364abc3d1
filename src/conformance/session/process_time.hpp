/// @file
/// @brief What the processes of a group are doing, from /proc.
#pragma once

#include <sys/types.h>

#include <optional>

namespace denhartog::conformance {

/// @brief What a process group has used and whether it can run.
struct GroupActivity {
    double processor_seconds = 0; ///< user and system time of its processes, and of their children that have ended
    bool stopped = false;         ///< one of them is stopped by a signal
};

/// @brief Looks at a process group.
/// @param group  its number
/// @return       what it does; none where there is no /proc
[[nodiscard]] std::optional<GroupActivity> group_activity(pid_t group);

} // namespace denhartog::conformance
