// The benchmark's pack: its files agree with the manifest, with what is computed anew, and with an integration from rest.
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "tests/benchmark/generator/pack.hpp"
#include "tests/conformance/shell.hpp"
#include "tests/support/sha256.hpp"

namespace denhartog::tests {
namespace {

using Json = nlohmann::json;

std::string pack_file(const std::string& name) { return content_of(source_file("tests/benchmark/pack/" + name)); }

const Json& scenes() {
    static const Json all = Json::parse(pack_file("scenes.json"));
    return all;
}

} // namespace

TEST_CASE("scenes of the benchmark's pack come out the same to the last byte when both routes compute them anew",
          "[eq:6][eq:69]") {
    std::vector<benchmark::CertifiedScene> some; // one in six; the case below computes all
    for (std::size_t n = 3; n < scenes().size(); n += 6) some.push_back(benchmark::certified(benchmark::pack_scene(scenes()[n])));
    const std::string objects = pack_file("scenes.json");
    for (const benchmark::CertifiedScene& s : some) {
        INFO(s.scene.id);
        CHECK(objects.find(json_of(s)) != std::string::npos);
    }
    const auto files = benchmark::files_of(some);
    for (const std::string name : {"scenes.csv", "events.csv", "samples.csv"}) {
        const std::string rows = "\n" + pack_file(name);
        std::istringstream lines(files.at(name));
        for (std::string line; std::getline(lines, line);) {
            INFO(name << ": " << line);
            CHECK(rows.find("\n" + line + "\n") != std::string::npos);
        }
    }
    CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"); // as the standard has it
    const Json manifest = Json::parse(pack_file("manifest.json"));
    CHECK(manifest.at("files").size() == 4);
    for (const Json& file : manifest.at("files")) CHECK(sha256(pack_file(file.at("name"))) == file.at("sha256"));
}

TEST_CASE("the benchmark's pack comes out the same to the last byte when both routes compute it anew", "[.][sweep]") {
    const auto files = benchmark::files_of(benchmark::certify_all(source_file("tests/benchmark/pack"), false));
    for (const auto& [name, bytes] : files) {
        INFO(name);
        CHECK(bytes == pack_file(name));
    }
    std::size_t there = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_file("tests/benchmark/pack")))
        there += files.count(entry.path().filename().string()) > 0 ? 1 : 100;
    CHECK(there == files.size());
}

TEST_CASE("the two routes to a motion of the benchmark tell a friction from one that is 1e-12 larger", "[eq:6]") {
    for (const std::size_t n : {0, 5, 17, 30, 43}) {
        Scene<double> scene = benchmark::scene_of(benchmark::pack_scene(scenes()[n]));
        INFO(scenes()[n].at("scene"));
        const benchmark::Motion motion = benchmark::library_motion(scene);
        CHECK(benchmark::agreement(motion, benchmark::physical_motion(scene, motion)) > 30);
        *scene.beta *= 1 + 1e-12;
        const int digits = benchmark::agreement(motion, benchmark::physical_motion(scene, motion));
        CHECK(digits >= 6); // next to the onset of stops their instants go with the root of the distance
        CHECK(digits <= 13);
    }
}

TEST_CASE("the paper's Runge-Kutta from rest comes to the motions of the benchmark", "[eq:6][eq:74][eq:75]") {
    int compared = 0;
    for (std::size_t n = 0; n < scenes().size(); n += 2) {
        const Json& s = scenes()[n];
        const benchmark::PackScene scene = benchmark::pack_scene(s);
        INFO(s.at("scene"));
        if (s.at("periods_to_settle").at("1e-06") > 400) continue;
        PaperSettings settings;
        settings.absolute_tolerance = 1e-9;
        settings.cycles = s.at("periods_to_settle").at("1e-06").get<int>() + 1;
        settings.samples = benchmark::instants;
        const PaperMotion motion = paper_algorithm(benchmark::scene_of(scene), settings);
        REQUIRE(motion.status == IntegrationStatus::complete);
        double largest = 0, apart = 0;
        for (std::size_t k = 0; k < scene.m.size(); ++k)
            for (std::size_t i = 0; i < motion.samples.size(); ++i) {
                const double x = s.at("x")[k][i], v = s.at("v")[k][i].get<double>() / scene.omega;
                largest = std::max({largest, std::abs(x), std::abs(v)});
                apart = std::max({apart, std::abs(motion.samples[i].x[k] - x), std::abs(motion.samples[i].x_prime[k] - v)});
            }
        CHECK(apart <=
              4e-6 * largest); // 1e-6 is left of transients in the state at the maximum of the force; others may have more
        ++compared;
    }
    CHECK(compared > 20);
}

TEST_CASE("a scene of the benchmark next to a boundary has the regime of its side") {
    const auto find = [](const std::string& id) {
        return *std::ranges::find_if(scenes(), [&](const Json& s) { return s.at("scene") == id; });
    };
    for (const auto& [below, above] :
         {std::pair{"one-15", "one-16"}, {"one-17", "one-18"}, {"one-19", "one-20"}, {"two-08", "two-07"}}) {
        CHECK(find(below).at("regime") == "continuous");
        CHECK(find(above).at("regime") == "stick_slip");
        CHECK(find(below).at("F") < find(below).at("F_slides_below"));
        CHECK(find(above).at("F") > find(above).at("F_slides_below"));
    }
    CHECK(find("one-14").at("regime") == "stick_slip");
    CHECK(find("one-12").at("regime") == "permanent_sticking");
}

TEST_CASE("readers of the benchmark in Python, Octave and C++ read the same numbers") {
    const std::string readers = source_file("tests/benchmark/readers/"), pack = " '" + source_file("tests/benchmark/pack") + "'";
    const auto program = (scratch() / "read").string();
    REQUIRE(run_shell("c++ -std=c++17 -O1 '" + readers + "read.cpp' -o '" + program + "'").status == 0);
    const std::string read = run_shell("'" + program + "'" + pack).output;
    std::string expected;
    for (const Json& s : scenes()) {
        const auto j = s.at("contact").get<std::size_t>() - 1;
        std::array<double, 2> largest{};
        for (std::size_t n = 0; n < benchmark::instants; ++n)
            for (const int what : {0, 1})
                largest[what] = std::max(largest[what], std::abs(s.at(what == 0 ? "x" : "v")[j][n].get<double>()));
        const auto stops = std::ranges::count_if(s.at("events"), [](const Json& e) { return e.at("what") == "stops"; });
        std::array<char, 200> line{};
        std::snprintf(line.data(), line.size(), "%s %zu %s %d %.17g %.17g\n", s.at("scene").get<std::string>().c_str(),
                      s.at("m").size(), s.at("regime").get<std::string>().c_str(), static_cast<int>(stops), largest[0],
                      largest[1]);
        expected += line.data();
    }
    CHECK(read == expected);
    for (const auto& [command, name] : {std::pair{"python3", "read.py"}, {"octave-cli", "read.m"}}) {
        if (is_there_or_skipped(command))
            CHECK(run_shell(std::string(command) + " '" + readers + name + "'" + pack).output == expected);
    }
}

} // namespace denhartog::tests
