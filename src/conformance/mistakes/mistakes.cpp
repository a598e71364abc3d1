#include <algorithm>
#include <iterator>

#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog::conformance {
namespace {

std::vector<MistakeDefinition> all_definitions() {
    std::vector<MistakeDefinition> all;
    for (auto part : {mistakes_of_input(), mistakes_of_print(), mistakes_of_form(), mistakes_of_output(),
                      mistakes_of_integrators(), mistakes_of_systems()})
        std::move(part.begin(), part.end(), std::back_inserter(all));
    std::sort(all.begin(), all.end(),
              [](const MistakeDefinition& a, const MistakeDefinition& b) { return a.mistake.name < b.mistake.name; });
    return all;
}

const std::vector<MistakeDefinition>& definitions() {
    static const std::vector<MistakeDefinition> all = all_definitions();
    return all;
}

} // namespace

bool asks_for(const ProtocolQuestion& q, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), q.quantity) != names.end();
}

MistakeDefinition by_formulas(Mistake mistake, std::vector<std::string_view> touched, std::function<void(Choices&)> choose) {
    return {std::move(mistake), [touched = std::move(touched), choose = std::move(choose)](const ProtocolQuestion& q) {
                if (!touched.empty() && std::find(touched.begin(), touched.end(), q.quantity) == touched.end())
                    return std::optional<Value>();
                Choices c;
                choose(c);
                return plain_answer(q, c);
            }};
}

std::span<const Mistake> mistakes() {
    static const std::vector<Mistake> told = [] {
        std::vector<Mistake> list;
        for (const MistakeDefinition& each : definitions()) list.push_back(each.mistake);
        return list;
    }();
    return told;
}

std::optional<Value> answer_with_mistake(std::string_view name, const ProtocolQuestion& q) {
    const auto found = std::find_if(definitions().begin(), definitions().end(),
                                    [&](const MistakeDefinition& each) { return each.mistake.name == name; });
    if (found == definitions().end()) throw InputError("mistake", "must be one of the known ones", std::string(name));
    return where_finite([&] { return found->answer(q); }); // not for a place beyond the chain, or a motion that is none
}

} // namespace denhartog::conformance
