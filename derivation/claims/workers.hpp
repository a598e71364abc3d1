/// @file
/// @brief Tasks in processes of their own: GiNaC must not be used by two threads at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace denhartog::derivation {

/// @brief The result of a task.
struct Delivery {
    std::string text;  ///< what it returned
    std::string fault; ///< why it returned nothing: what it threw, or how its process ended; empty where it did return
};

/// @brief Runs tasks, each in a process forked from this one.
///
/// Every task starts from the state that this process has now. What it returns therefore does not depend on the number of
/// workers, nor on the tasks that ran before it.
/// @param count      how many tasks there are; they start in the order of their numbers
/// @param workers    how many processes run at a time, at least 1
/// @param task       a task by its number from 0; runs in the process of its own
/// @param delivered  called in this process as each task ends, once a task
/// @throws           std::system_error where no process can be started
void in_processes(std::size_t count, std::size_t workers, const std::function<std::string(std::size_t)>& task,
                  const std::function<void(std::size_t, const Delivery&)>& delivered);

} // namespace denhartog::derivation
