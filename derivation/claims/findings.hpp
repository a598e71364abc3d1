/// @file
/// @brief The findings on every claim: its verdict with the steps that led there, and the verdicts on its mutated twins.
#pragma once

#include <iosfwd>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

/// @brief Findings by the names of the claims: `record`, what `denhartog derive` shows; `fingerprint`, by which claims that say
///        the same are found; `twins`, counts, or null where none were tried;
///        `fault`, why there is no verdict, empty where there is one.
using Findings = std::map<std::string, nlohmann::json>;

/// @brief Decides claims and tries their mutated twins, each claim in a process of its own.
///
/// A claim whose process throws or dies is unknown, and says why.
/// @param claims   the claims
/// @param known    what was found before; claims in it are not decided again
/// @param workers  how many processes run at a time
/// @param out      gets a line as each claim is decided
/// @return         what was known and what was found; the same whatever the number of workers, but for the time taken
[[nodiscard]] Findings findings_of(const std::vector<Claim>& claims, Findings known, std::size_t workers, std::ostream& out);

} // namespace denhartog::derivation
