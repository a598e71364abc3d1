// Questions about systems beyond the paper: how they are written and read, who is asked them, and what the kit itself answers.
#include <cmath>
#include <nlohmann/json.hpp>

#include "conformance/mistakes/mistake.hpp"
#include "conformance/plain/closed_form.hpp"
#include "tests/conformance/runner_fixtures.hpp"
#include "tests/conformance/seeded_questions.hpp"
#include "tests/conformance/shell.hpp"
#include "tests/conformance/vector_folder.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;

namespace {

// The first example of docs/protocol.md.
ProtocolQuestion two_masses() {
    ProtocolQuestion q;
    q.id = "example-1";
    q.quantity = "amplitude";
    q.mass_ratios = {1, 2.5};
    q.stiffness_ratios = {1, 0.625};
    q.damping_matrix = {0.375, -0.25, -0.25, 0.25};
    q.contact = 2;
    q.contact_with = 1;
    q.load = 0;
    q.loads = {0.5, -1};
    q.r = 1.125;
    q.beta = 0.125;
    return q;
}

// All examples of that page beyond the paper.
std::vector<ProtocolQuestion> examples() {
    ProtocolQuestion phased = two_masses();
    phased.id = "example-2";
    phased.quantity = "phase";
    phased.damping_matrix.clear();
    phased.damping_ratios = {0.0625, 0.125};
    phased.contact_with = 0;
    phased.mass = 1;
    phased.load_phases = {0.75, 0};
    ProtocolQuestion wall = phased;
    wall.id = "example-3";
    wall.quantity = "transmissibility";
    wall.loads.clear();
    wall.load_phases.clear();
    wall.base_motion = "wall";
    return {two_masses(), phased, wall};
}

std::string sentence(const std::function<void(ProtocolQuestion&)>& breaks) {
    ProtocolQuestion q = two_masses();
    breaks(q);
    try {
        static_cast<void>(scene_of(q));
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}

} // namespace

TEST_CASE("a question beyond the paper is the same after either dialect has it, and reads as the protocol's page shows",
          "[conformance][systems]") {
    const std::string page = content_of(source_file("docs/protocol.md"));
    for (const ProtocolQuestion& q : examples()) {
        INFO(q.id);
        CHECK(contains(page, question_plain(q) + "\n"));
        const std::size_t from = page.find("{\"id\":\"" + q.id + "\"");
        REQUIRE(from != std::string::npos);
        const nlohmann::json shown = nlohmann::json::parse(page.substr(from, page.find('\n', from) - from));
        CHECK(shown == nlohmann::json(question_json(q)));
        CHECK(plain_answer(q));
    }
    for (const Vector& v : vectors()) {
        if (!is_of_systems(v)) continue;
        INFO(v.question.id);
        REQUIRE_FALSE(is_of_the_paper(v.question));
        const ProtocolQuestion again = question_from_json(nlohmann::json(question_json(v.question)));
        REQUIRE(question_plain(again) == question_plain(v.question));
        REQUIRE(question_json(again) == question_json(v.question));
    }
}

TEST_CASE("a scene beyond the paper breaks a rule in the words of the scene", "[conformance][systems]") {
    CHECK(sentence([](ProtocolQuestion&) {}).empty());
    CHECK(contains(sentence([](ProtocolQuestion& q) { q.contact_with = 2; }), "contact must be between two masses"));
    CHECK(contains(sentence([](ProtocolQuestion& q) { q.loads = {1}; }), "load must be one mass, or have as many values"));
    CHECK(contains(sentence([](ProtocolQuestion& q) { q.mass = 3; }), "mass must be a mass from 1 to 2"));
    CHECK(contains(sentence([](ProtocolQuestion& q) { q.mass = -1; }), "mass must be a mass from 1 to 2"));
    CHECK(contains(sentence([](ProtocolQuestion& q) {
                       q.contact_with = 0;
                       q.mass = 0;
                   }),
                   "mass must be a mass from 1 to 2"));
    CHECK(contains(sentence([](ProtocolQuestion& q) { q.base_motion = "up"; }), "base_motion must be"));
    CHECK(contains(sentence([](ProtocolQuestion& q) { q.load_phases = {0.5}; }), "load_phases must have as many values"));
    CHECK(contains(sentence([](ProtocolQuestion& q) { q.quantity = "transmissibility"; }), "base_motion must be given"));
    CHECK(contains(sentence([](ProtocolQuestion& q) {
                       q.base_motion = "wall";
                       q.loads.clear();
                   }),
                   "base_motion must be"));
}

TEST_CASE("an implementation of the paper is asked about the paper, and about other systems where it says so",
          "[conformance][systems][program]") {
    const auto groups = [](const std::string& options) {
        std::map<std::string, std::size_t> count;
        const Run r = conform("list --vectors '" + vector_folder().string() + "' " + options);
        CHECK(r.status == 0);
        const std::vector<std::string> lines = lines_of(r.output);
        for (std::size_t n = 1; n < lines.size(); ++n) ++count[contains(lines[n], "  systems-") ? "systems" : "paper"];
        return count;
    };
    std::size_t systems = 0;
    for (const Vector& v : vectors()) systems += is_of_systems(v);
    const std::size_t paper = vectors().size() - systems;
    using Counts = std::map<std::string, std::size_t>;
    CHECK(groups("") == Counts{{"paper", paper}});
    CHECK(groups("--systems") == Counts{{"paper", paper}, {"systems", systems}});
    CHECK(groups("--group systems") == Counts{{"systems", systems}});
    CHECK(groups("--group systems-reject") == Counts{{"systems", 17}});
    CHECK(groups("--group reject --systems") == Counts{{"paper", 37}, {"systems", systems}});
    const Run none = conform("list --vectors '" + vector_folder().string() + "' --filter '^systems-'");
    CHECK(none.status == 2);
    CHECK(contains(none.error, "--systems"));
    const std::string summary = "list --summary --vectors '" + vector_folder().string() + "'";
    CHECK(contains(conform(summary + " --systems").output, "systems-damping"));
    CHECK_FALSE(contains(conform(summary).output, "systems-")); // a summary is of what would be asked
}

TEST_CASE("an answers file is judged about the systems that it answers", "[conformance][systems][program]") {
    const auto first = [](bool of_systems) {
        return *std::find_if(vectors().begin(), vectors().end(), [&](const Vector& v) {
            return is_of_systems(v) == of_systems && v.value.size() == 1 && v.tier == "must";
        });
    };
    const auto graded = [&](const Vector& v) {
        const auto file = file_with("answers", "id,value\n" + v.question.id + "," + v.value.front() + "\n");
        return conform("grade --format json --vectors '" + vector_folder().string() + "' '" + file.string() + "'").output;
    };
    const Vector of_paper = first(false), of_system = first(true);
    CHECK_FALSE(contains(graded(of_paper), "systems-"));
    const nlohmann::json report = nlohmann::json::parse(graded(of_system));
    CHECK(report.at("counts").at("pass") == 1);
    CHECK(report.at("results").size() == vectors().size());
}

TEST_CASE("a mistake in what only systems beyond the paper have says nothing of the paper", "[conformance][systems][mistake]") {
    for (const ProtocolQuestion& q : seeded_questions(7, 10))
        for (const char* name : {"coupling-neglected", "dashpots-between-masses-ignored", "second-contact-mass-ignored",
                                 "relative-displacement-reversed", "loads-normalised", "largest-load-only",
                                 "base-taken-with-wall", "base-taken-alone", "base-load-without-masses", "load-phases-reversed",
                                 "load-phases-ignored", "load-phases-in-degrees", "base-damper-ignored", "base-load-taken-real",
                                 "wall-taken-with-base", "relative-for-absolute", "frame-subtracted", "base-amplitude-of-one"}) {
            INFO(name);
            CHECK_FALSE(answer_with_mistake(name, q));
        }
    // x_a - x_b and x_b - x_a are half a period apart.
    ProtocolQuestion q = two_masses();
    q.quantity = "phase";
    const double right = plain_answer(q).value().numbers.front();
    const double reversed = answer_with_mistake("relative-displacement-reversed", q).value().numbers.front();
    CHECK(std::abs(std::remainder(reversed - right, 2 * std::acos(-1.0))) == Approx(std::acos(-1.0)));
}
