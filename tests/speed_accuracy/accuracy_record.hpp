/// @file
/// @brief What a survey found, written down for the pages of the site: the worst error of each function in each zone.
#pragma once

#include <string>
#include <vector>

#include "tests/speed_accuracy/functions_survey.hpp"

namespace denhartog::tests {

/// @brief The worst errors of a survey as JSON.
/// @param type  the number type, e.g. `double`
/// @param all   what the survey found
/// @return      an object with `type` and `functions`: function, equations, zone, points, printed, shipped, shipped_at; an error
///              that is no number is null
[[nodiscard]] std::string accuracy_record(const std::string& type, const std::vector<FunctionInZone>& all);

/// @brief Writes a record into the folder that the environment names in DENHARTOG_RECORDS; does nothing where it names none.
/// @param name  of the file, without `.json`
/// @param text  the record
/// @return      false where it cannot be written
[[nodiscard]] bool keep_record(const std::string& name, const std::string& text);

} // namespace denhartog::tests
