#include "derivation/ledger/ledger_scenes.hpp"

#include "denhartog/ledger/ledger_entry.hpp"

namespace denhartog::derivation {

using nlohmann::json;

std::vector<std::string> add_scenes(json& entries, const json& scenes) {
    std::vector<std::string> faults;
    for (json& entry : entries) {
        const std::string equation = entry.at("equation"), printed = entry.at("printed");
        const bool fails = printed == "refuted" || printed == "illegible";
        const auto found = scenes.find(equation);
        entry["scene"] = found == scenes.end() ? json::object() : *found;
        if (fails && found == scenes.end())
            faults.push_back("(" + equation + ") is " + printed +
                             ", with neither a scene that shows it nor a reason why none can");
        if (!fails && found != scenes.end()) faults.push_back("(" + equation + ") has a scene that refutes it and is " + printed);
        if (found != scenes.end() && found->contains("loss") && !(found->at("loss") >= visible_loss))
            faults.push_back("the scene for (" + equation + ") shows a loss of " + found->at("loss").dump() +
                             ", which nobody sees");
    }
    return faults;
}

std::string scene_markdown(const json& scene) {
    if (scene.contains("none")) return "No scene shows it: " + scene.at("none").get<std::string>();
    return "To be seen on " + ledger::scene_sentence(scene) + ". Scene: `" + scene.at("scene").get<std::string>() + "`";
}

} // namespace denhartog::derivation
