/// @file
/// @brief The results as one file of NetCDF's classic format with 64-bit data (CDF-5).
#pragma once

#include <string>

#include "denhartog/program/sweep/folder.hpp"

namespace denhartog::program {

/// @brief Writes all arrays of a study that `merge` has completed, row of chunks by row of chunks.
/// @param study  the study
/// @param path   the file; it appears when it is complete
/// @throws       InputError where it cannot be written
void write_netcdf(const StudyFolder& study, const std::string& path);

} // namespace denhartog::program
