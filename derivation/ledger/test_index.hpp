/// @file
/// @brief Which test speaks of which equation: read from the tags `[eq:46]` in the sources of the tests and in their results.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief A test with tags of equations, as its source declares it.
struct DeclaredTest {
    std::string name;                   ///< what it says
    std::vector<std::string> equations; ///< as the ledger writes them, or as they stand where the paper has no such equation
    std::string file;                   ///< its file
    int line = 0;                       ///< line of its name, from 1
};

/// @brief A test with tags of equations that ran.
struct TestRun {
    std::string name;                   ///< what it says
    std::vector<std::string> equations; ///< as the ledger writes them, or as they stand where the paper has no such equation
    bool passed = false;                ///< whether it came to its end and every assertion held
};

/// @brief Results of the last run of the tests.
struct TestResults {
    bool found = false;        ///< whether there is any
    std::vector<TestRun> runs; ///< tests that are tagged with equations
};

/// @brief Tests that one file declares. @param source its text @param file its name @return those tagged with equations
[[nodiscard]] std::vector<DeclaredTest> tests_of_source(const std::string& source, const std::string& file);

/// @brief Tests that the sources in a folder declare.
/// @param tests_root  the folder `tests`
/// @return            those tagged with equations
[[nodiscard]] std::vector<DeclaredTest> tests_of_sources(const std::filesystem::path& tests_root);

/// @brief Tests that ran, from the XML that Catch2 (version 2 or 3) writes.
/// @param xml  its text; what is no test case is passed over, and a case without an overall result did not pass
/// @return     those tagged with equations
[[nodiscard]] std::vector<TestRun> runs_of_xml(const std::string& xml);

/// @brief Tests that ran, from every `*.xml` in a folder; a folder that is not there has no results.
/// @param results  the folder
/// @return         the results
[[nodiscard]] TestResults read_test_results(const std::filesystem::path& results);

} // namespace denhartog::derivation
