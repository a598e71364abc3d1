/// @file
/// @brief The verdict of Coq's kernel on the exported lemmas: each file compiled, each twin refused.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>

namespace denhartog::derivation {

/// @brief Compiles the certificates in a folder with Coq, and the twins, which must not compile; writes `kernel.json`.
///
/// A file that was accepted before and has not changed since is not compiled again, also where that run was broken off. Where
/// a file is refused, each of its claims is compiled by itself, so that one lemma costs no other the compiler's word; coqchk
/// does not read such a file. A twin counts as rejected only where a tactic finds that its identity does not hold or that a
/// condition is missing; any other message is a fault of the file.
///
/// `kernel.json` holds `coq`, the version; `claims`, for each claim with lemmas `status`, which is `checked` or `failed`,
/// `message`, and `in_functions`, which is `checked`, or `not_proved` where Coq does not get through a lemma on the functions
/// themselves: the certificate stands without it; `why_not_in_functions`, where a lemma of the claim is not stated of the
/// functions or Coq does not prove it: how many lemmas, and the reason; `twins`, each with `file`, `claim`, `what`, `rejected`
/// and `message`;
/// `files`, each with `file`, `status`, `seconds`, `checksum`, and `seconds_again`, `gigabytes_again` of the second check;
/// `checked_again`, the word of coqchk; `axioms`, what the files rest on; `lemmas`, `lines`, `seconds`.
/// @param folder   with `certificates.json`, as `export_certificates` leaves it
/// @param workers  how many processes work at a time
/// @param coqc     the compiler
/// @param coqchk   the checker that reads compiled files again, without the compiler's tactics
/// @param out      gets a line on every file that is not as it should be, and the counts
/// @return         whether all certificates were accepted and all twins rejected, and Coq could read every lemma on the functions
/// @throws         std::runtime_error where the compiler cannot be run or the record cannot be read or written
bool check_certificates(const std::filesystem::path& folder, std::size_t workers, const std::string& coqc,
                        const std::string& coqchk, std::ostream& out);

/// @brief The verdict of a compiler on a source, and the time that it takes.
struct Compiled {
    bool accepted = false; ///< whether it compiles
    std::string message;   ///< the error; empty where there is none
    double seconds = 0;    ///< time taken
};

/// @brief Compiles a source of Coq, in two minutes of the processor at most. @param file the source @param coqc the compiler
/// @return what it says
[[nodiscard]] Compiled compile_with_coq(const std::filesystem::path& file, const std::string& coqc);

/// @brief Why lemmas of a claim are not stated of the functions themselves. @param claim its entry in `certificates.json`
/// @return for each reason how many lemmas have it; empty where all are stated so
[[nodiscard]] std::string why_not_in_functions(const nlohmann::json& claim);

/// @brief Whether a message says that a tactic has found no proof, and not that the file is at fault. @param message the message
/// @return true where it does
[[nodiscard]] bool finds_no_proof(const std::string& message);

/// @brief Whether Coq could read a source that it refused: a fault of the text is no missing proof. @param message what it said
/// @return false where it says that the text is at fault
[[nodiscard]] bool can_be_read(const std::string& message);

} // namespace denhartog::derivation
