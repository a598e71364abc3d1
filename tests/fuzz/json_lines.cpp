// JSON Lines: every part of a text is a scene or an error in its place, and scenes written one a line are read again as they are.
#include <nlohmann/json.hpp>

#include "denhartog/scene/scene_json.hpp"
#include "tests/fuzz/claims.hpp"
#include "tests/fuzz/same_scene.hpp"

using namespace denhartog;

namespace {

void check_parts(std::string_view text, const std::vector<SceneText>& parts) {
    fuzz::claim(!parts.empty(), "a text has at least one part", text);
    const char* end = text.data();
    std::size_t line = 0;
    for (const SceneText& part : parts) {
        fuzz::claim(part.text.empty() ||
                        (part.text.data() >= end && part.text.data() + part.text.size() <= text.data() + text.size()),
                    "parts are in the text, in its order", text);
        fuzz::claim(part.line > line, "every part starts on a line of its own", text);
        fuzz::claim(part.alone == (parts.size() == 1) || !part.alone, "only one part is alone", text);
        end = part.text.data() + part.text.size();
        line = part.line;
    }
}

void check_error(const SceneOrError<double>& one, const SceneText& part) {
    fuzz::claim(one.scene.has_value() != one.error.has_value(), "a part is a scene or an error", part.text);
    if (!one.error) return;
    fuzz::claim_message(one.error->what());
    const bool in_line = one.error->place.starts_with("line " + std::to_string(part.line));
    fuzz::claim(part.alone || in_line, "an error among many scenes has its line", one.error->what());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    const std::vector<SceneText> parts = split_scenes(text);
    check_parts(text, parts);
    const std::vector<SceneOrError<double>> read = read_scenes<double>(text);
    fuzz::claim(read.size() == parts.size(), "every part is read", text);
    std::vector<Scene<double>> scenes;
    std::string lines;
    for (std::size_t n = 0; n < parts.size(); ++n) {
        check_error(read[n], parts[n]);
        if (!read[n].scene) continue;
        scenes.push_back(*read[n].scene);
        lines += write_scene(*read[n].scene).dump() + "\n";
    }
    if (scenes.empty()) return 0;
    const std::vector<SceneOrError<double>> again = read_scenes<double>(lines);
    fuzz::claim(again.size() == scenes.size(), "every line that is written is read", lines);
    for (std::size_t n = 0; n < scenes.size(); ++n)
        fuzz::claim(again[n].scene && fuzz::same(*again[n].scene, scenes[n]), "a scene of many is the same again", lines);
    return 0;
}
