/// @file
/// @brief What a survey found, written down for the pages of the site: the worst error of each function in each zone.
#pragma once

#include <string>
#include <vector>

#include "tests/speed_accuracy/functions_survey.hpp"

namespace denhartog::tests {

/// @brief The worst errors of a survey as JSON. It is an object with `type`, e.g. `double`, and `functions`: function, equations,
/// zone, points, printed, shipped, shipped_at; an error that is no number is null.
[[nodiscard]] std::string accuracy_record(const std::string& type, const std::vector<FunctionInZone>& all);

/// @brief Writes a record into the folder that the environment names in DENHARTOG_RECORDS; does nothing where it names none. The
/// name is without `.json`. False where it cannot be written.
[[nodiscard]] bool keep_record(const std::string& name, const std::string& text);

} // namespace denhartog::tests
