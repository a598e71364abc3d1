// Files that the program writes: whole, in their own place, and through nobody else's links.
#include <sys/stat.h>

#include "tests/catch.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog::tests;
namespace fs = std::filesystem;

namespace {

/// An empty folder with nothing in it but what a test puts there.
fs::path empty_folder(const std::string& name) {
    const fs::path folder = scratch() / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

int motion_to(const fs::path& file, const std::string& before = "") {
    const char* program = std::getenv("DENHARTOG_PROGRAM");
    const std::string command = before + " '" + std::string(program) + "' motion --samples 8 --output '" + file.string() + "' '" +
                                file_with("scene-of-files", scene_text("unequal")).string() + "' 2>/dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::size_t count_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

unsigned permissions_of(const fs::path& file) {
    struct stat found {};
    return ::stat(file.c_str(), &found) == 0 ? found.st_mode & 07777U : 0;
}

} // namespace

TEST_CASE("a symbolic link stays and the file that it leads to is replaced", "[program][output]") {
    const fs::path folder = empty_folder("links"), other = empty_folder("other");
    std::ofstream(other / "motion.csv") << "old";
    fs::create_symlink(other / "motion.csv", other / "absolute");
    fs::create_symlink("../other/absolute", folder / "relative.csv");
    CHECK(motion_to(folder / "relative.csv") == 0);
    CHECK(fs::is_symlink(folder / "relative.csv"));
    CHECK(fs::is_symlink(other / "absolute"));
    CHECK(fs::is_regular_file(fs::symlink_status(other / "motion.csv")));
    CHECK(lines_of(content_of(other / "motion.csv")).size() == 9);
    CHECK(count_in(folder) == 1);
    CHECK(count_in(other) == 2);
    fs::create_symlink("not-yet.csv", folder / "dangling.csv");
    CHECK(motion_to(folder / "dangling.csv") == 0);
    CHECK(fs::is_symlink(folder / "dangling.csv"));
    CHECK(lines_of(content_of(folder / "not-yet.csv")).size() == 9);
    fs::create_symlink("round.csv", folder / "round.csv");
    CHECK(motion_to(folder / "round.csv") == 2);
    CHECK(fs::is_symlink(folder / "round.csv"));
    CHECK(motion_to(folder) == 2);
}

TEST_CASE("nothing is written through a link that somebody has laid for the temporary file", "[program][output]") {
    const fs::path folder = empty_folder("trap");
    std::ofstream(folder / "victim") << "untouched";
    // The names that the shell's process and its next ones would have given.
    const std::string trap =
        "cd '" + folder.string() + "' && for n in $(seq $$ $(($$ + 200))); do ln -s victim out.csv.part$n; done;";
    CHECK(motion_to(folder / "out.csv", trap + " exec") == 0);
    CHECK(content_of(folder / "victim") == "untouched");
    CHECK(fs::is_regular_file(fs::symlink_status(folder / "out.csv")));
}

TEST_CASE("permissions are those of the file that was there, else those of a new file", "[program][output]") {
    const fs::path folder = empty_folder("permissions");
    CHECK(motion_to(folder / "new.csv", "umask 027;") == 0);
    CHECK(permissions_of(folder / "new.csv") == 0640);
    std::ofstream(folder / "old.csv") << "old";
    fs::permissions(folder / "old.csv", fs::perms(0604));
    CHECK(motion_to(folder / "old.csv", "umask 077;") == 0);
    CHECK(permissions_of(folder / "old.csv") == 0604);
    CHECK(lines_of(content_of(folder / "old.csv")).size() == 9);
    CHECK(count_in(folder) == 2);
}

TEST_CASE("a pipe is written directly, and a file beside which nothing can be made is refused", "[program][output]") {
    const fs::path folder = empty_folder("pipes");
    const fs::path pipe = folder / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    CHECK(motion_to(pipe, "cat '" + pipe.string() + "' > '" + (folder / "read").string() + "' &") == 0);
    CHECK(fs::is_fifo(pipe));
    for (int n = 0; n < 100 && lines_of(content_of(folder / "read")).size() < 9; ++n) ::usleep(20'000);
    CHECK(lines_of(content_of(folder / "read")).size() == 9);
    CHECK(motion_to("/dev/null") == 0);
    CHECK(motion_to("/proc/motion.csv") == 2);
    CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a hang-up of a map leaves no file and is the status", "[program][map][output]") {
    const fs::path folder = empty_folder("hang-up");
    const std::string command = "'" + std::string(std::getenv("DENHARTOG_PROGRAM")) + "' map '" +
                                file_with("map-scene-of-files", scene_text("unequal")).string() +
                                "' --r 0.01:0.02:2000 --beta 0.1:1:2000 --output '" + (folder / "map.csv").string() +
                                "' 2>/dev/null & sleep 0.5; kill -HUP $!; wait $!";
    const int status = std::system(command.c_str());
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 129);
    CHECK(count_in(folder) == 0);
}
