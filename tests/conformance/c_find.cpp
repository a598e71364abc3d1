// The inverse question from C: the numbers of the library, wherever the caller wants them.
#include <array>

#include "denhartog/solve/find.hpp"
#include "tests/conformance/c_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

const std::string scene = R"({"mass_ratios": [1, 2], "stiffness_ratios": [1, 1], "damping_ratios": 0.1, "contact": 1,
    "load": 1, "r": 0.4, "beta": 0.1})";

dh_find_request request_for(const char* so_that) {
    auto request = sized<dh_find_request>();
    request.scene = scene.data();
    request.scene_length = scene.size();
    request.vary = "r";
    request.from = 0.2;
    request.to = 2;
    request.so_that = so_that;
    request.samples = 64;
    return request;
}

} // namespace

TEST_CASE("dh_find has the places of the library", "[c_interface]") {
    const char* const wanted = "amplitude of mass 2 = 1.5";
    const dh_find_request request = request_for(wanted);
    std::array<double, 8> at{}, from{}, to{}, amplitude{}, error{};
    std::array<int, 8> is{};
    auto places = sized<dh_places>();
    places.room = at.size();
    places.at = at.data();
    places.from = from.data();
    places.to = to.data();
    places.amplitude = amplitude.data();
    places.error = error.data();
    places.is = is.data();
    REQUIRE(dh_find(&request, &places) == DH_OK);
    const FoundPlaces found = find_places(scene, {"r", 0.2, 2}, wanted_from(wanted), 64);
    REQUIRE(found.places.size() >= 2);
    REQUIRE(places.count == found.places.size());
    CHECK(places.unanswered == found.unanswered.size());
    for (std::size_t n = 0; n < places.count; ++n) {
        const FoundPlace& p = found.places[n];
        CHECK((at[n] == p.at && from[n] == p.from && to[n] == p.to));
        CHECK((amplitude[n] == p.amplitude.value && error[n] == p.amplitude.error));
        CHECK(is[n] == static_cast<int>(p.is));
    }
    auto few = sized<dh_places>();
    few.room = places.count - 1;
    CHECK(dh_find(&request, &few) == DH_ERROR_SIZE);
    CHECK(std::string(dh_last_message()).find("room must be") == 0);
    few.room = places.count; // arrays may be null
    CHECK(dh_find(&request, &few) == DH_OK);
    CHECK(few.count == places.count);
}

TEST_CASE("dh_find refuses what is missing or breaks a rule", "[c_interface][faults]") {
    auto places = sized<dh_places>();
    const dh_find_request good = request_for("amplitude of mass 2 is largest");
    CHECK(dh_find(nullptr, &places) == DH_ERROR_NULL);
    CHECK(dh_find(&good, nullptr) == DH_ERROR_NULL);
    const auto fails = [&](int status, const std::string& part, const auto& change) {
        dh_find_request bad = good;
        change(bad);
        CHECK(dh_find(&bad, &places) == status);
        INFO(dh_last_message());
        CHECK(std::string(dh_last_message()).find(part) != std::string::npos);
        CHECK(places.count == 0);
    };
    fails(DH_ERROR_SIZE, "size must be at least", [](dh_find_request& r) { --r.size; });
    fails(DH_ERROR_NULL, "scene", [](dh_find_request& r) { r.scene = nullptr; });
    fails(DH_ERROR_NULL, "vary", [](dh_find_request& r) { r.vary = nullptr; });
    fails(DH_ERROR_NULL, "so_that", [](dh_find_request& r) { r.so_that = nullptr; });
    fails(DH_ERROR_INPUT, "so-that", [](dh_find_request& r) { r.so_that = "phase"; });
    fails(DH_ERROR_INPUT, "vary", [](dh_find_request& r) { r.vary = "omega"; });
    fails(DH_ERROR_INPUT, "samples", [](dh_find_request& r) { r.samples = 1; });
    fails(DH_ERROR_INPUT, "between", [](dh_find_request& r) { r.to = r.from; });
    fails(DH_ERROR_INPUT, "line 1", [](dh_find_request& r) { r.scene_length = 3; });
}
