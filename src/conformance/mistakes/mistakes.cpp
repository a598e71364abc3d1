#include <algorithm>

#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog::conformance {

bool asks_for(const ProtocolQuestion& q, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, q.quantity) != names.end();
}

Answering by_formulas(Names touched, std::function<void(Choices&)> choose) {
    return [touched = std::move(touched), choose = std::move(choose)](const ProtocolQuestion& q) {
        if (!touched.empty() && std::ranges::find(touched, q.quantity) == touched.end()) return std::optional<Value>();
        Choices c;
        choose(c);
        return plain_answer(q, c);
    };
}

Answering reading(std::function<void(ProtocolQuestion&)> change) {
    return [change = std::move(change)](const ProtocolQuestion& q) {
        ProtocolQuestion other = q;
        change(other);
        return other == q ? std::nullopt : plain_answer(other);
    };
}

std::span<const Mistake> mistakes() {
    static const std::vector<Mistake> all = [] {
        std::vector<Mistake> list;
        for (auto part : {mistakes_of_input(), mistakes_of_print(), mistakes_of_form(), mistakes_of_output(),
                          mistakes_of_integrators(), mistakes_of_systems()})
            for (Mistake& mistake : part) {
                // none for a place beyond the chain, or a motion that is none
                mistake.answer = [answer = std::move(mistake.answer)](const ProtocolQuestion& q) {
                    return where_finite([&] { return answer(q); });
                };
                list.push_back(std::move(mistake));
            }
        std::ranges::sort(list, {}, &Mistake::name);
        return list;
    }();
    return all;
}

std::optional<Value> answer_with_mistake(std::string_view name, const ProtocolQuestion& q) {
    const auto found = std::ranges::find(mistakes(), name, &Mistake::name);
    if (found == mistakes().end()) throw InputError("mistake", "must be one of the known ones", std::string(name));
    return found->answer(q);
}

} // namespace denhartog::conformance
