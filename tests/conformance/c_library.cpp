// The C interface from outside: what the library exports, the header in C, the example of the page, and other languages.
#include <algorithm>
#include <iterator>
#include <regex>
#include <sstream>

#include "tests/conformance/shell.hpp"

using namespace denhartog::tests;

namespace {

const std::string library = DENHARTOG_C_LIBRARY;
std::string strict_c() { return "cc -std=c99 -pedantic -Wall -Wextra -Werror -I '" + source_file("src/denhartog/c") + "' "; }

std::vector<std::string> sorted(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    return names;
}

// The text of the first fence of a language on the page.
std::string fence_of(const std::string& language) {
    const std::string page = content_of(source_file("docs/c-interface.md")), open = "```" + language + "\n";
    const std::size_t from = page.find(open);
    REQUIRE(from != std::string::npos);
    return page.substr(from + open.size(), page.find("\n```", from + 3) + 1 - from - open.size());
}

void check_done(const Run& run) {
    INFO(run.error);
    REQUIRE(run.status == 0);
}

// The lines that the examples in other languages have in common with that of the page.
std::vector<std::string> motion_of_page() {
    std::vector<std::string> lines = lines_of(fence_of("text"));
    REQUIRE(lines.size() == 4);
    lines.erase(lines.begin());
    return lines;
}

} // namespace

TEST_CASE("the shared library exports the names of its list and no other", "[c_interface][symbols]") {
    std::istringstream names(
        "dh_abi_version dh_boundaries dh_boundaries_proved dh_boundary_errors dh_displacement dh_displacement_errors "
        "dh_find dh_follow dh_free_decay dh_high_frequency_limit dh_high_frequency_limit_error dh_last_message dh_map "
        "dh_modal_function_errors "
        "dh_modal_functions dh_mode_shape_errors dh_mode_shapes dh_natural_frequency_ratio_errors "
        "dh_natural_frequency_ratios dh_place_of_rest dh_quantity dh_quantity_errors dh_set_effort dh_sliding_motion "
        "dh_sliding_motion_errors dh_solution_contact dh_solution_destroy dh_solution_energies dh_solution_from_ground "
        "dh_solution_is_from_rest "
        "dh_solution_is_proved "
        "dh_solution_mass dh_solution_motion dh_solution_stop_errors dh_solution_stops dh_solution_summary "
        "dh_solution_warning dh_solve "
        "dh_solve_points "
        "dh_solve_proved dh_solve_systems dh_status_text dh_sum_errors dh_sums dh_system_destroy dh_system_from_json "
        "dh_system_from_ratios dh_system_masses dh_version");
    const std::vector<std::string> list{std::istream_iterator<std::string>(names), {}};
    const Run run = run_shell("nm -D --defined-only '" + library + "'");
    check_done(run);
    std::vector<std::string> exported, versions;
    for (const std::string& line : lines_of(run.output)) {
        std::smatch name;
        REQUIRE(std::regex_match(line, name, std::regex("[0-9a-f]+ ([A-Za-z]) (\\S+?)(@@DENHARTOG_0)?")));
        (name[1] == "A" ? versions : exported).push_back(name[2]);
    }
    CHECK(sorted(exported) == list);
    CHECK(versions == std::vector<std::string>{"DENHARTOG_0"});

    std::vector<std::string> declared;
    const std::string header = content_of(source_file("src/denhartog/c/denhartog.h"));
    const std::regex declaration("\nDH_EXPORT [a-z_ *]*?(dh_[a-z_]+)\\(");
    for (std::sregex_iterator it(header.begin(), header.end(), declaration), end; it != end; ++it) declared.push_back((*it)[1]);
    CHECK(sorted(declared) == list);
    CHECK(run_shell("objdump -p '" + library + "' | grep -q 'SONAME *libdenhartog.so.0$'").status == 0);
}

TEST_CASE("the header is C99 and C++11 without a warning", "[c_interface][header]") {
    const auto unit = file_with("header.c", "#include <denhartog.h>\n#include <denhartog.h>\nint main(void) { return DH_OK; }\n");
    check_done(run_shell(strict_c() + "-fsyntax-only '" + unit.string() + "'"));
    for (const std::string standard : {"c++11", "c++20"})
        check_done(run_shell("c++ -x c++ -std=" + standard + " -pedantic -Wall -Wextra -Werror -I '" +
                             source_file("src/denhartog/c") + "' -fsyntax-only '" + unit.string() + "'"));
}

TEST_CASE("the example of the page on the C interface compiles and prints what the page says", "[c_interface][documentation]") {
    const auto source = file_with("example.c", fence_of("c")), program = scratch() / "example";
    check_done(run_shell(strict_c() + "'" + source.string() + "' '" + library + "' -o '" + program.string() + "'"));
    const Run run = run_shell("LD_LIBRARY_PATH=$(dirname '" + library + "') '" + program.string() + "'");
    check_done(run);
    CHECK(run.output == fence_of("text"));
}

TEST_CASE("the page's table has every function of the header", "[c_interface][documentation]") {
    const std::string header = content_of(source_file("src/denhartog/c/denhartog.h"));
    const std::string page = content_of(source_file("docs/c-interface.md"));
    const std::regex declaration("\nDH_EXPORT [a-z_ *]*?(dh_[a-z_]+)\\(");
    for (std::sregex_iterator it(header.begin(), header.end(), declaration), end; it != end; ++it) {
        INFO((*it)[1]);
        CHECK(page.find("`" + std::string((*it)[1]) + "`") != std::string::npos);
    }
}

TEST_CASE("the example in Python finds what the example in C finds", "[c_interface][python]") {
    if (!is_there_or_skipped("python3")) return;
    const Run run =
        run_shell("python3 '" + source_file("tests/conformance/adapters/python/library_example.py") + "' '" + library + "'");
    check_done(run);
    CHECK(lines_of(run.output) == motion_of_page());
}

TEST_CASE("the example in Fortran finds what the example in C finds", "[c_interface][fortran]") {
    if (!is_there_or_skipped("gfortran")) return;
    const auto program = scratch() / "library_example";
    check_done(run_shell("gfortran -std=f2008 -Wall -Wextra -Werror '" +
                         source_file("tests/conformance/adapters/fortran/library_example.f90") + "' '" + library + "' -J '" +
                         scratch().string() + "' -o '" + program.string() + "'"));
    const Run run = run_shell("LD_LIBRARY_PATH=$(dirname '" + library + "') '" + program.string() + "'");
    check_done(run);
    CHECK(lines_of(run.output) == motion_of_page());
}
