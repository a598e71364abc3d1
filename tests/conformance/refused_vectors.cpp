// Lines of vector files that are no vectors: each is refused with the quantity at fault, before anybody is asked or judged by it.
#include <nlohmann/json.hpp>

#include "denhartog/scene/json_document.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/runner_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;

namespace {

// The quantity that a vector is refused for, once a member is replaced.
std::string refused_for(const Vector& good, const char* pointer, const nlohmann::json& member) {
    nlohmann::json object = vector_json(good);
    REQUIRE_NOTHROW(vector_from_json(object));
    object[nlohmann::json::json_pointer(pointer)] = member;
    try {
        static_cast<void>(vector_from_json(object));
        return "nothing";
    } catch (const InputError& fault) {
        return fault.quantity;
    }
}

} // namespace

TEST_CASE("a vector is refused that cannot be asked in both dialects, or judged", "[conformance][vectors]") {
    Vector good = vector_of("a-1", "amplitude", {0.25});
    CHECK(refused_for(good, "/id", "a 1") == "id");
    CHECK(refused_for(good, "/id", "") == "id");
    CHECK(refused_for(good, "/hex", {"0x1p-2", "0x1p-2"}) == "hex");
    CHECK(refused_for(good, "/hex", {"inf"}) == "hex");
    CHECK(refused_for(good, "/scale", "0x0p0") == "scale");
    CHECK(refused_for(good, "/regime", "gliding") == "regime");
    CHECK(refused_for(good, "/scene/r", -1) == "r");
    CHECK(refused_for(reject_vector("a-1"), "/reject", "") == "reject");
    CHECK(refused_for(word_vector("a-1", "stick_slip"), "/value", "gliding") == "value");
    good = vector_of("a-1", "motion_under_force", {0.25, -0.25});
    good.question.samples = 2;
    CHECK(refused_for(good, "/samples", 3) == "samples");
}

TEST_CASE("whole numbers of a vector are not cut to size", "[conformance][vectors]") {
    const Vector good = vector_of("a-1", "amplitude", {0.25});
    for (const nlohmann::json& number :
         {nlohmann::json(1e300), nlohmann::json(1.5), nlohmann::json(4294967297), nlohmann::json(true)}) {
        CHECK(refused_for(good, "/scene/contact", number) == "contact");
        CHECK(refused_for(good, "/mass", number) == "mass");
    }
    CHECK(refused_for(good, "/digits", {40, 1e300}) == "digits");
}

TEST_CASE("neither vectors nor verdicts of earlier runs that are nested without an end do harm", "[conformance][program]") {
    const std::string deep = std::string(300000, '[') + std::string(300000, ']');
    CHECK_FALSE(json_or_nothing(deep).is_array());
    const std::string folder = folder_of("deep", {vector_of("a-1", "amplitude", {0.25})});
    std::ofstream(folder + "/a.jsonl", std::ios::app) << "{\"scene\":{},\"id\":" << deep << "}\n";
    const Run listed = conform("list " + with_vectors(folder, ""));
    CHECK(listed.status == 2);
    CHECK(contains(listed.error, "vector must be a JSON object"));
    const std::string answers = file_with("deep.csv", "id,value\namplitude-1,0.25\n").string();
    const std::string track = file_with("deep.track", "{\"format\":" + deep + "}").string();
    const Run graded = conform("grade " + with_vectors(six(), "") + "--track '" + track + "' '" + answers + "'");
    CHECK(graded.status == 2);
    CHECK(contains(graded.error, "track must be a file that --track has written"));
}
