#include <algorithm>
#include <map>

#include "denhartog/conformance/mistake_definition.hpp"
#include "denhartog/errors.hpp"

namespace denhartog::conformance {
namespace {

std::vector<MistakeDefinition> all_definitions() {
    std::vector<MistakeDefinition> all;
    for (auto part :
         {mistakes_of_input(), mistakes_of_print(), mistakes_of_form(), mistakes_of_output(), mistakes_of_integrators()})
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

bool asks_for(const Question& q, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), q.quantity) != names.end();
}

std::vector<Value> listed(const std::optional<Value>& value) { return value ? std::vector{*value} : std::vector<Value>{}; }

std::span<const Mistake> mistakes() {
    static const std::vector<Mistake> told = [] {
        std::vector<Mistake> list;
        for (const MistakeDefinition& each : definitions()) list.push_back(each.mistake);
        return list;
    }();
    return told;
}

std::vector<Value> answers_with_mistake(std::string_view name, const Question& q) {
    const auto found = std::find_if(definitions().begin(), definitions().end(),
                                    [&](const MistakeDefinition& each) { return each.mistake.name == name; });
    if (found == definitions().end()) throw InputError("mistake", "must be one of the known ones", std::string(name));
    try {
        return found->answers(q);
    } catch (const InputError&) {
    } catch (const DomainError&) {
    } catch (const PrecisionError&) {
    }
    return {};
}

std::optional<Value> answer_with_mistake(std::string_view name, const Question& q) {
    const std::vector<Value> all = answers_with_mistake(name, q);
    return all.empty() ? std::nullopt : std::optional(all.front());
}

} // namespace denhartog::conformance
