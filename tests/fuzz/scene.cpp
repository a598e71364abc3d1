// Scene JSON: what is read, written and read again is the same scene.
#include <nlohmann/json.hpp>

#include "denhartog/scene/scene_json.hpp"
#include "tests/fuzz/claims.hpp"
#include "tests/fuzz/same_scene.hpp"

using namespace denhartog;

namespace {

void read_and_written(std::string_view text) {
    Scene<double> scene;
    if (!fuzz::answers([&] { scene = read_scene<double>(text); })) return;
    const std::string written = write_scene(scene).dump();
    Scene<double> again;
    fuzz::claim(fuzz::answers([&] { again = read_scene<double>(written); }), "a scene that is written is read", written);
    fuzz::claim(fuzz::same(scene, again), "a scene that is written and read is the same", written);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    read_and_written(fuzz::text_of(data, size));
    return 0;
}
