/// @file
/// @brief The identities that the derivation proves, as lemmas that the kernel of a proof assistant checks.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <vector>

#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

/// @brief The certificates of a claim: a lemma for every identity that its proof rests on.
/// @param claim  the claim
/// @return       `claim`, `equation`, `equations`, `title`, `assumptions`; `status`, which is `exported` or `not_exported`;
///               `reason`, why not, empty where it is; `lemmas`, each with `name`, `statement`, `proof`, `generators` and
///               `terms`. A claim that rests on more than identities is not exported, but the identities are there
[[nodiscard]] nlohmann::json certificates_of(const Claim& claim);

/// @brief Lemmas that the kernel must reject: one operation of a formula replaced, or a hypothesis left out.
/// @return  objects with `claim`, `what`, `name`, `statement` and `proof`
[[nodiscard]] nlohmann::json rejected_twins();

/// @brief Writes the certificates of all claims, and the twins.
///
/// `certificates/*.v` holds the lemmas, by equation; `twins/*.v` one twin each; `certificates.json` says of every claim which
/// lemmas it has, in which file, or why it has none. Files of an earlier run that are none now are removed; a file that is
/// unchanged is left alone.
/// @param all      the claims
/// @param folder   where to
/// @param workers  how many processes work at a time
/// @param out      gets the counts
/// @return         what `certificates.json` holds
nlohmann::json export_certificates(const std::vector<Claim>& all, const std::filesystem::path& folder, std::size_t workers,
                                   std::ostream& out);

} // namespace denhartog::derivation
