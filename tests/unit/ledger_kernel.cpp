#include "derivation/ledger/ledger_kernel.hpp"

#include "denhartog/ledger/ledger_entry.hpp"
#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog;
using nlohmann::json;

namespace {

/// Two equations: two claims on the first, one of them refuted and with the equation at its end; none on the second.
json two_entries() {
    return json::parse(R"([
        {"equation": "28", "kind": "result", "claims": [{"id": "28/formula"}, {"id": "28/printed/28"}], "no_function": ""},
        {"equation": "6", "kind": "definition", "claims": [], "no_function": ""}])");
}

const char* const exported = R"({"certificates": [
    {"claim": "28/formula", "status": "exported", "reason": "", "lemmas": [{}, {}], "file": "certificates/equation_28.v"},
    {"claim": "28/printed", "status": "not_exported", "reason": "refuted: the two sides are not equal", "lemmas": []}]})";

json joined(const tests::Folder& folder, const std::string& statements = "") {
    json entries = two_entries();
    (void)derivation::add_kernel(entries, derivation::read_kernel_record(folder.path(), statements));
    return entries;
}

} // namespace

TEST_CASE("where the kernel was not run the ledger says so, and nothing else", "[ledger][kernel]") {
    const tests::Folder folder;
    for (const bool with_certificates : {false, true}) {
        if (with_certificates) folder.write("certificates.json", exported);
        const json entries = joined(folder);
        CHECK(entries[0].at("kernel").at("status") == "not_run");
        CHECK(entries[0].at("claims")[0].at("kernel") == json{{"status", "not_run"}});
        CHECK(entries[1].at("kernel").at("status") == "not_run");
        CHECK(derivation::kernel_sentence(entries) == "The kernel was not run.");
    }
}

TEST_CASE("a claim is checked where the kernel accepted its lemmas, and not exported with the reason", "[ledger][kernel]") {
    const tests::Folder folder;
    folder.write("certificates.json", exported);
    folder.write("kernel.json", R"({"claims": {"28/formula": {"status": "checked", "message": "",
                                    "why_not_in_functions": "1 of 2: the angle of a point"}}})");
    const json entries = joined(folder);
    const json& claims = entries[0].at("claims");
    CHECK(claims[0].at("kernel").at("why_not_in_functions") == "1 of 2: the angle of a point");
    CHECK(claims[0].at("kernel").at("status") == "checked");
    CHECK(claims[0].at("kernel").at("lemmas") == 2);
    CHECK(claims[1].at("kernel").at("status") == "not_exported");
    CHECK(claims[1].at("kernel").at("reason") == "refuted: the two sides are not equal");
    CHECK(entries[0].at("kernel").at("status") == "checked");
    CHECK(entries[0].at("kernel").at("certificates") == 1);
    CHECK(entries[1].at("kernel").at("status") == "not_exported");
    CHECK(entries[1].at("kernel").at("reason") == "definition: there is nothing to prove");
    CHECK(derivation::kernel_sentence(entries) ==
          "The kernel has checked the certificates of 1 of 2 claims; 1 are not exported. Of "
          "2 equations 1 have a certificate or a theorem that it has checked.");
}

TEST_CASE("a lemma that the kernel refuses makes its claim and its equation red", "[ledger][kernel]") {
    const tests::Folder folder;
    folder.write("certificates.json", exported);
    folder.write("kernel.json", R"({"claims": {"28/formula": {"status": "failed", "message": "not a valid ring equation"}}})");
    json entries = two_entries();
    const auto faults = derivation::add_kernel(entries, derivation::read_kernel_record(folder.path(), ""));
    CHECK(tests::tells(faults, "the kernel refuses the certificate of claim 28/formula"));
    CHECK(entries[0].at("kernel").at("status") == "failed");
    CHECK(ledger::kernel_words(entries[0].at("claims")[0].at("kernel")) == "failed: not a valid ring equation");
}

TEST_CASE("a claim that was exported and that the kernel has not seen is not checked", "[ledger][kernel]") {
    const tests::Folder folder;
    folder.write("certificates.json", exported);
    folder.write("kernel.json", R"({"claims": {}})");
    CHECK(joined(folder)[0].at("claims")[0].at("kernel").at("status") == "not_run");
}
